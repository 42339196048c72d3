#include <boost/test/unit_test.hpp>

#include "estimator_checks.h"
#include "raise_to.h"
#include "says.h"

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/height_field_curvatures.h>
#include <Shape_characteristics/curvature/height_grid_curvatures.h>

#include <CGAL/property_map.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(height_grid)

namespace {

namespace SC = Shape_characteristics;
using estimator_checks::Curvatures;
using estimator_checks::Kernel;
using estimator_checks::Result;
using estimator_checks::same_bits;
using SC::Estimation_status;

const double nan_value = std::numeric_limits<double>::quiet_NaN();

struct Grid
{
  std::vector<double> heights;
  std::size_t columns = 0;
  double su = 1., sv = 1.;

  std::size_t rows() const { return columns == 0 ? 0 : heights.size() / columns; }
  double& at(std::size_t i, std::size_t j) { return heights[j * columns + i]; }
};

template <typename Tag = CGAL::Sequential_tag>
Result run(const Grid& g, SC::Height_field_normal normal = SC::Height_field_normal::UPWARD)
{
  const std::size_t n = g.heights.size();
  Result r;
  r.curvatures.resize(n);
  r.mean.resize(n);
  r.Gaussian.resize(n);
  r.status.resize(n, Estimation_status::CANCELLED);
  r.failures = SC::height_grid_curvatures<Tag>(
      g.heights, g.columns, g.su, g.sv,
      SC::parameters::principal_curvatures_and_directions_map(CGAL::make_property_map(r.curvatures))
          .mean_curvature_map(CGAL::make_property_map(r.mean))
          .Gaussian_curvature_map(CGAL::make_property_map(r.Gaussian))
          .status_map(CGAL::make_property_map(r.status))
          .height_field_normal(normal));
  return r;
}

// h and its derivatives: value, u, v, uu, uv, vv
using Function = std::function<std::array<double, 6>(double, double)>;

std::array<double, 6> waves(double x, double y)
{
  const double s = std::sin(2. * x + .3), c = std::cos(2. * x + .3), e = std::exp(-y);
  return {.3 * s * e, .6 * c * e, -.3 * s * e, -1.2 * s * e, -.6 * c * e, .3 * s * e};
}
std::array<double, 6> sphere(double x, double y)
{
  const double x_0 = x - .5, y_0 = y - .5, z = std::sqrt(4. - x_0 * x_0 - y_0 * y_0), z3 = z * z * z;
  return {z, -x_0 / z, -y_0 / z, -1. / z - x_0 * x_0 / z3, -x_0 * y_0 / z3, -1. / z - y_0 * y_0 / z3};
}

// over the unit square
Grid sampled(const Function& f, std::size_t columns, std::size_t rows)
{
  Grid g;
  g.columns = columns;
  g.su = 1. / double(columns - 1);
  g.sv = 1. / double(rows - 1);
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
      g.heights.push_back(f(double(i) * g.su, double(j) * g.sv)[0]);
  return g;
}

Curvatures exact(const Function& f, const Grid& g, std::size_t k)
{
  const auto d = f(double(k % g.columns) * g.su, double(k / g.columns) * g.sv);
  return SC::height_field_curvatures<Kernel>(d[1], d[2], d[3], d[4], d[5], SC::Height_field_normal::UPWARD);
}

double error(const Curvatures& a, const Curvatures& b)
{
  double largest = 0.;
  test_support::raise_to(largest, std::abs(a.min_curvature - b.min_curvature),
                         std::abs(a.max_curvature - b.max_curvature));
  return largest;
}

void check_consistency(const Grid& g, const Result& r)
{
  std::size_t failures = 0;
  for(std::size_t k = 0; k < g.heights.size(); ++k)
  {
    const Curvatures& c = r.curvatures[k];
    BOOST_TEST((r.status[k] != Estimation_status::CANCELLED));
    BOOST_TEST(std::isfinite(g.heights[k]) == (r.status[k] != Estimation_status::NON_FINITE_INPUT));
    if(!SC::is_estimated(r.status[k]))
    {
      ++failures;
      BOOST_TEST((std::isnan(c.min_curvature) && std::isnan(c.max_curvature) && std::isnan(r.mean[k]) &&
                  std::isnan(r.Gaussian[k]) && std::isnan(c.min_direction.x()) &&
                  std::isnan(c.max_direction.z())));
      continue;
    }
    BOOST_TEST((std::isfinite(c.min_curvature) && std::isfinite(c.max_curvature)));
    BOOST_TEST(c.min_curvature <= c.max_curvature);
    BOOST_TEST(std::abs(c.min_direction.squared_length() - 1.) < 1e-12);
    BOOST_TEST(std::abs(c.max_direction.squared_length() - 1.) < 1e-12);
    BOOST_TEST(std::abs(c.min_direction * c.max_direction) < 1e-12);
    BOOST_TEST(r.mean[k] == c.min_curvature / 2. + c.max_curvature / 2.);
  }
  BOOST_TEST(failures == r.failures);
}

bool is_inner(const Grid& g, std::size_t k)
{
  const std::size_t i = k % g.columns, j = k / g.columns;
  return i > 0 && j > 0 && i + 1 < g.columns && j + 1 < g.rows();
}

} // namespace

// The differences of a quadratic polynomial are its derivatives, central or one-sided, beside holes too.
BOOST_AUTO_TEST_CASE(exact_for_quadratic_polynomials)
{
  const Function quadratic = [](double x, double y) -> std::array<double, 6>
  {
    return {.7 * x * x - 1.1 * x * y + .4 * y * y + x - 2. * y + 5.,
            1.4 * x - 1.1 * y + 1.,
            -1.1 * x + .8 * y - 2.,
            1.4,
            -1.1,
            .8};
  };
  Grid g = sampled(quadratic, 14, 9);
  g.at(5, 4) = g.at(6, 4) = g.at(10, 3) = nan_value;
  g.at(0, 0) = std::numeric_limits<double>::infinity();
  const Result r = run(g);
  check_consistency(g, r);
  BOOST_TEST(r.failures == 4u);
  for(std::size_t k = 0; k < g.heights.size(); ++k)
    if(SC::is_estimated(r.status[k]))
      BOOST_TEST(error(r.curvatures[k], exact(quadratic, g, k)) < 1e-11);

  // by hand, at one inner sample
  const std::size_t k = 3 * 14 + 2;
  const auto h = [&](int i, int j) { return g.heights[std::size_t(int(k) + 14 * j + i)]; };
  const auto c = SC::height_field_curvatures<Kernel>(
      (h(1, 0) - h(-1, 0)) / (2. * g.su), (h(0, 1) - h(0, -1)) / (2. * g.sv),
      (h(1, 0) - 2. * h(0, 0) + h(-1, 0)) / (g.su * g.su),
      (h(1, 1) - h(-1, 1) - h(1, -1) + h(-1, -1)) / (4. * g.su * g.sv),
      (h(0, 1) - 2. * h(0, 0) + h(0, -1)) / (g.sv * g.sv), SC::Height_field_normal::UPWARD);
  BOOST_TEST(error(c, r.curvatures[k]) < 1e-11);
  BOOST_TEST(std::abs(c.max_direction * r.curvatures[k].max_direction) > 1. - 1e-11);
}

// The error falls with the square of the spacing, on the border as well.
BOOST_AUTO_TEST_CASE(convergence)
{
  for(const Function& f : {Function(waves), Function(sphere)})
  {
    const auto errors = [&](std::size_t n)
    {
      const Grid g = sampled(f, 3 * n + 1, 2 * n + 1); // spacings that differ
      const Result r = run(g);
      check_consistency(g, r);
      BOOST_TEST(r.failures == 0u);
      std::array<double, 2> largest = {0., 0.};
      for(std::size_t k = 0; k < g.heights.size(); ++k)
      {
        BOOST_TEST(
            (r.status[k] == (is_inner(g, k) ? Estimation_status::ESTIMATED : Estimation_status::BORDER)));
        double& e = largest[is_inner(g, k) ? 0 : 1];
        test_support::raise_to(e, error(r.curvatures[k], exact(f, g, k)));
      }
      return largest;
    };
    const auto coarse = errors(12), fine = errors(48);
    for(const std::size_t border : {0u, 1u})
    {
      const double order = std::log2(coarse[border] / fine[border]) / 2.;
      BOOST_TEST_MESSAGE((border ? "  border: " : "  inside: ")
                         << coarse[border] << " -> " << fine[border] << ", order " << order);
      BOOST_TEST(order > 1.8);
    }
    BOOST_TEST(fine[0] < 2e-3);
    BOOST_TEST(fine[1] < 2e-2);
  }
}

// A hole changes the samples of which a difference reaches it, to what one-sided differences say, and no others.
BOOST_AUTO_TEST_CASE(holes)
{
  const Grid whole = sampled(waves, 40, 30);
  const Result expected = run(whole);
  Grid g = whole;
  g.at(20, 15) = nan_value;
  const Result r = run(g);
  check_consistency(g, r);
  BOOST_TEST(r.failures == 1u);
  for(std::size_t k = 0; k < g.heights.size(); ++k)
  {
    const int di = std::abs(int(k % 40) - 20), dj = std::abs(int(k / 40) - 15);
    if(di == 0 && dj == 0)
      continue;
    if(di > 1 || dj > 1)
      BOOST_TEST((r.status[k] == expected.status[k] && same_bits(r.curvatures[k], expected.curvatures[k])));
    else
    {
      BOOST_TEST((r.status[k] == Estimation_status::BORDER));
      BOOST_TEST(error(r.curvatures[k], exact(waves, g, k)) < .05);
    }
  }

  // a crack: every second row is missing
  for(std::size_t j = 1; j < 30; j += 2)
    for(std::size_t i = 0; i < 40; ++i)
      g.at(i, j) = nan_value;
  const Result cracked = run(g);
  check_consistency(g, cracked);
  BOOST_TEST(cracked.failures == g.heights.size());
  BOOST_TEST((cracked.status[80] == Estimation_status::FEW_NEIGHBOURS));
}

// What little there is: second derivatives need three in a row, mixed ones a neighbor on a diagonal
BOOST_AUTO_TEST_CASE(small_grids)
{
  const auto grid = [](std::size_t columns, std::size_t rows)
  {
    return columns > 1 && rows > 1 ? sampled(waves, columns, rows)
                                   : Grid{std::vector<double>(columns * rows, 1.), columns};
  };
  BOOST_TEST(run(Grid()).failures == 0u);
  for(const auto& [columns, rows] :
      {std::pair(1, 1), std::pair(1, 9), std::pair(9, 1), std::pair(2, 9), std::pair(9, 2)})
  {
    const Result r = run(grid(std::size_t(columns), std::size_t(rows)));
    BOOST_TEST(r.failures == std::size_t(columns * rows));
    for(const Estimation_status s : r.status)
      BOOST_TEST((s == Estimation_status::FEW_NEIGHBOURS));
  }
  Grid g = sampled(waves, 3, 3);
  const Result r = run(g);
  BOOST_TEST(r.failures == 0u);
  BOOST_TEST((r.status[4] == Estimation_status::ESTIMATED));
  g.at(0, 0) = g.at(0, 2) = g.at(2, 0) = nan_value; // one diagonal is left
  BOOST_TEST((run(g).status[4] == Estimation_status::BORDER));
  g.at(2, 2) = nan_value;
  BOOST_TEST((run(g).status[4] == Estimation_status::FEW_NEIGHBOURS));
}

BOOST_AUTO_TEST_CASE(flip_unit_and_position)
{
  const Grid g = sampled(waves, 25, 31);
  const Result r = run(g), down = run(g, SC::Height_field_normal::DOWNWARD);
  for(std::size_t k = 0; k < g.heights.size(); ++k)
  {
    BOOST_TEST(down.curvatures[k].min_curvature == -r.curvatures[k].max_curvature);
    BOOST_TEST(down.curvatures[k].max_curvature == -r.curvatures[k].min_curvature);
  }
  for(const double s : {1e-100, 1e-6, 1e6, 1e100})
  {
    Grid scaled = g;
    scaled.su *= s;
    scaled.sv *= s;
    for(double& h : scaled.heights)
      h *= s;
    const Result t = run(scaled);
    for(std::size_t k = 0; k < g.heights.size(); ++k)
    {
      BOOST_TEST(std::abs(t.curvatures[k].min_curvature * s - r.curvatures[k].min_curvature) < 1e-10);
      BOOST_TEST(std::abs(t.curvatures[k].max_curvature * s - r.curvatures[k].max_curvature) < 1e-10);
    }
  }
  Grid moved = g;
  for(double& h : moved.heights)
    h += 1e7;
  const Result t = run(moved);
  for(std::size_t k = 0; k < g.heights.size(); ++k)
    BOOST_TEST(error(t.curvatures[k], r.curvatures[k]) <
               1e-4); // the last bits of the heights, over the squared spacing
}

BOOST_AUTO_TEST_CASE(one_sample_threads_and_types)
{
  Grid g = sampled(waves, 61, 57);
  std::mt19937 random(3);
  for(int k = 0; k < 300; ++k)
    g.heights[random() % g.heights.size()] = nan_value;
  const Result r = run(g);
  check_consistency(g, r);
  bool same = true;
  for(std::size_t k = 0; k < g.heights.size(); ++k)
  {
    Curvatures c;
    double mean, Gaussian;
    const Estimation_status s =
        SC::height_grid_curvatures(k % 61, k / 61, g.heights, g.columns, g.su, g.sv,
                                   SC::parameters::vertex_principal_curvatures_and_directions(std::ref(c))
                                       .vertex_mean_curvature(std::ref(mean))
                                       .vertex_Gaussian_curvature(std::ref(Gaussian)));
    same = same && s == r.status[k] && same_bits(c, r.curvatures[k]) && same_bits(mean, r.mean[k]) &&
           same_bits(Gaussian, r.Gaussian[k]);
  }
  BOOST_TEST(same);
#ifdef CGAL_LINKED_WITH_TBB
  for(const std::size_t threads : {1, 2, 4})
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Result p = run<CGAL::Parallel_tag>(g);
    bool equal = p.status == r.status && p.failures == r.failures;
    for(std::size_t k = 0; k < g.heights.size(); ++k)
      equal = equal && same_bits(p.curvatures[k], r.curvatures[k]);
    BOOST_TEST(equal);
  }
#endif

  // whole numbers of any kind, in another container
  const auto of_type = [](auto zero)
  {
    std::vector<decltype(zero)> depths;
    for(int k = 0; k < 12; ++k)
      depths.push_back(decltype(zero)((k % 4) * (k % 4)));
    std::vector<double> mean(12);
    SC::height_grid_curvatures(depths, 4, 1., 1.,
                               SC::parameters::mean_curvature_map(CGAL::make_property_map(mean)));
    return mean[5];
  };
  for(const double m : {of_type(std::uint8_t()), of_type(std::uint16_t()), of_type(std::int64_t())})
    BOOST_TEST(std::abs(m + 1. / std::pow(1. + 4., 1.5)) < 1e-15);
  const std::deque<int> heights = {0, 1, 4, 9, 0, 1, 4, 9, 0, 1, 4, 9};
  std::vector<double> mean(12);
  BOOST_TEST(SC::height_grid_curvatures(heights, 4, 1., 1.,
                                        SC::parameters::mean_curvature_map(CGAL::make_property_map(mean))) ==
             0u);
  BOOST_TEST(std::abs(mean[5] + 1. / std::pow(1. + 4., 1.5)) < 1e-15); // h = u^2 at u = 1: a valley
}

BOOST_AUTO_TEST_CASE(callback)
{
  const Grid g = sampled(waves, 80, 80);
  std::vector<double> advancements;
  std::vector<Estimation_status> status(g.heights.size());
  const auto np = SC::parameters::status_map(CGAL::make_property_map(status));
  BOOST_TEST(SC::height_grid_curvatures<CGAL::Sequential_tag>(g.heights, g.columns, g.su, g.sv,
                                                              np.callback(
                                                                  [&](double t)
                                                                  {
                                                                    advancements.push_back(t);
                                                                    return true;
                                                                  })) == 0u);
  BOOST_TEST(std::is_sorted(advancements.begin(), advancements.end()));
  BOOST_TEST(advancements.back() == 1.);
  const std::size_t failures = SC::height_grid_curvatures<CGAL::Sequential_tag>(
      g.heights, g.columns, g.su, g.sv, np.callback([](double) { return false; }));
  const auto cancelled = std::count(status.begin(), status.end(), Estimation_status::CANCELLED);
  BOOST_TEST(cancelled > 0);
  BOOST_TEST(std::size_t(cancelled) == failures);
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  using test_support::says;
  const std::vector<double> heights(12, 0.);
  BOOST_CHECK_EXCEPTION(SC::height_grid_curvatures(heights, 5, 1., 1.), std::invalid_argument,
                        says("5 columns"));
  BOOST_CHECK_EXCEPTION(SC::height_grid_curvatures(heights, 0, 1., 1.), std::invalid_argument,
                        says("0 columns"));
  for(const double s : {0., -1., nan_value, std::numeric_limits<double>::infinity()})
  {
    BOOST_CHECK_EXCEPTION(SC::height_grid_curvatures(heights, 4, s, 1.), std::invalid_argument,
                          says("spacing"));
    BOOST_CHECK_EXCEPTION(SC::height_grid_curvatures(heights, 4, 1., s), std::invalid_argument,
                          says("spacing"));
  }
  BOOST_CHECK_EXCEPTION(SC::height_grid_curvatures(4, 0, heights, 4, 1., 1.), std::invalid_argument,
                        says("column 4"));
  BOOST_CHECK_EXCEPTION(SC::height_grid_curvatures(0, 3, heights, 4, 1., 1.), std::invalid_argument,
                        says("row 3"));

  for(const Curvatures& c : run(Grid{heights, 4}).curvatures)
    BOOST_TEST((c.min_curvature == 0. && c.max_curvature == 0.));

  // any bits at all: an answer, or a status
  std::mt19937_64 random(5);
  for(int k = 0; k < 400; ++k)
  {
    Grid g;
    g.columns = 1 + random() % 8;
    g.heights.resize(g.columns * (random() % 8));
    g.su = std::ldexp(1., int(random() % 600) - 300);
    g.sv = std::ldexp(1., int(random() % 600) - 300);
    for(double& h : g.heights)
    {
      const std::uint64_t bits = random();
      if(random() % 3 == 0)
        std::memcpy(&h, &bits, sizeof(double));
      else
        h = double(bits % 1000) / 100.;
    }
    check_consistency(g, run(g));
  }
}

BOOST_AUTO_TEST_SUITE_END()
