#include <boost/test/unit_test.hpp>

#include "analytic_surfaces.h"
#include "build_mesh.h"
#include "raise_to.h"

#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/internal/Shape_operator_eigen.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/interpolation/Gaussian.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Local_hermite_rbf.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/internal/Batched_hermite_rbf.h>
#include <Shape_characteristics/interpolation/internal/Hermite_fit_output.h>
#include <Shape_characteristics/interpolation/internal/Hermite_fit_rules.h>
#include <Shape_characteristics/interpolation/internal/Hermite_jet.h>
#include <Shape_characteristics/interpolation/internal/Hermite_trend.h>
#include <Shape_characteristics/interpolation/internal/Lanes.h>
#include <Shape_characteristics/interpolation/internal/basis_function_on_lanes.h>
#include <Shape_characteristics/interpolation/internal/for_each_patch.h>
#include <Shape_characteristics/interpolation/internal/trend_of_exact_fit.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(batched_hermite_rbf)

namespace SC = Shape_characteristics;
namespace internal = SC::internal;
using test_support::Analytic_surface;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using SC::Face_graph_samples;

namespace {

Face_graph_samples samples_of(const Analytic_surface& s, unsigned int rings, double turned = 0.)
{
  const Mesh mesh = test_support::build_mesh<Mesh>(s);
  Face_graph_samples samples(mesh, mesh.points(), SC::Neighborhood::rings(rings));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-turned, turned);
  std::vector<Eigen::Vector3d> normals;
  for(const auto& e : s.exact)
    normals.emplace_back(e.normal[0] + uniform(random), e.normal[1] + uniform(random),
                         e.normal[2] + uniform(random));
  samples.set_normals(std::move(normals));
  return samples;
}

template <typename RadialBasisFunction>
std::vector<SC::Local_implicit_surface>
one_by_one(const Face_graph_samples& samples, const RadialBasisFunction& phi, bool exact, double noise)
{
  using Fit = SC::Local_hermite_rbf<Face_graph_samples, RadialBasisFunction>;
  typename Fit::Options options;
  options.normals_are_exact = exact;
  options.noise_level = noise;
  const Fit fit(samples, phi, options);
  typename Fit::Workspace workspace;
  std::vector<SC::Local_implicit_surface> result;
  for(std::size_t i = 0; i < samples.size(); ++i)
    result.push_back(fit(i, workspace));
  return result;
}

template <typename RadialBasisFunction>
void fit_batched(const Face_graph_samples& samples,
                 const RadialBasisFunction& phi,
                 bool exact,
                 double noise,
                 bool shared,
                 std::size_t lanes,
                 std::size_t patch_size,
                 const internal::Hermite_fit_output& output)
{
  using Fit = internal::Batched_hermite_rbf<Face_graph_samples, RadialBasisFunction>;
  typename Fit::Options options;
  options.normals_are_exact = exact;
  options.noise_level = noise;
  options.fits_are_shared = shared;
  const Fit fit(samples, phi, options, lanes);
  auto patches = internal::Sample_patches::compact(samples, patch_size);
  internal::for_each_patch<CGAL::Sequential_tag>(fit, samples.size(), patches, output);
}

template <typename RadialBasisFunction>
std::vector<SC::Local_implicit_surface> batched(const Face_graph_samples& samples,
                                                const RadialBasisFunction& phi,
                                                bool exact,
                                                double noise,
                                                bool shared,
                                                std::size_t lanes,
                                                std::size_t patch_size)
{
  std::vector<SC::Local_implicit_surface> result(samples.size());
  std::vector<int> answers(samples.size(), 0);
  fit_batched(samples, phi, exact, noise, shared, lanes, patch_size,
              {[&](const std::size_t i, const SC::Local_implicit_surface& local)
               {
                 result[i] = local;
                 ++answers[i];
               }});
  BOOST_TEST(std::all_of(answers.begin(), answers.end(), [](const int n) { return n == 1; }));
  return result;
}

// the shape operator of the fitted surface, as a matrix that maps the normal to zero
Eigen::Matrix3d shape_operator(const SC::Local_implicit_surface& local)
{
  const double length = local.gradient.norm();
  const Eigen::Vector3d n = local.gradient / length;
  const Eigen::Matrix3d projection = Eigen::Matrix3d::Identity() - n * n.transpose();
  return projection * local.hessian * projection / length;
}

// largest difference of the shape operators, in units of the largest of them, or of the normals
double difference(const std::vector<SC::Local_implicit_surface>& a,
                  const std::vector<SC::Local_implicit_surface>& b)
{
  double unit = 1e-6, largest = 0.;
  for(const SC::Local_implicit_surface& local : a)
    if(SC::is_estimated(local.status))
      test_support::raise_to(unit, shape_operator(local).norm());
  for(std::size_t i = 0; i < a.size(); ++i)
  {
    BOOST_TEST((a[i].status == b[i].status), "status of sample " << i);
    if(SC::is_estimated(a[i].status) && SC::is_estimated(b[i].status))
      test_support::raise_to(largest, (shape_operator(a[i]) - shape_operator(b[i])).norm() / unit,
                             (a[i].gradient.normalized() - b[i].gradient.normalized()).norm(),
                             unit * (a[i].displacement - b[i].displacement).norm());
  }
  return largest;
}

bool same_bits(const std::vector<SC::Local_implicit_surface>& a,
               const std::vector<SC::Local_implicit_surface>& b)
{
  const auto same = [](const auto& x, const auto& y)
  { return std::memcmp(x.data(), y.data(), sizeof(double) * std::size_t(x.size())) == 0; };
  for(std::size_t i = 0; i < a.size(); ++i)
    if(a[i].status != b[i].status || !same(a[i].gradient, b[i].gradient) ||
       !same(a[i].hessian, b[i].hessian) || !same(a[i].displacement, b[i].displacement))
      return false;
  return true;
}

const auto surfaces = [] { return test_support::all_analytic_surfaces(.2, 3); };

template <int n>
void check_lanes()
{
  using V = internal::Lanes<n>;
  std::mt19937 random(3);
  double of_root = 0., of_exponential = 0.;
  for(int k = 0; k < 20000; ++k)
  {
    alignas(64) double x[n], y[n];
    V v, result;
    for(double& number : x)
      number = std::ldexp(std::uniform_real_distribution<double>(1., 2.)(random), int(random() % 1800) - 900);
    std::memcpy(&v, x, sizeof(V));
    internal::inverse_sqrt(v, result);
    std::memcpy(y, &result, sizeof(V));
    for(int lane = 0; lane < n; ++lane)
      test_support::raise_to(of_root, std::abs(y[lane] * std::sqrt(x[lane]) - 1.));
    for(double& number : x)
      number = -std::ldexp(std::uniform_real_distribution<double>(1., 2.)(random), int(random() % 60) - 50);
    std::memcpy(&v, x, sizeof(V));
    internal::exp_of_negative(v, result);
    std::memcpy(y, &result, sizeof(V));
    for(int lane = 0; lane < n; ++lane)
      test_support::raise_to(of_exponential,
                             x[lane] < -700. ? y[lane] : std::abs(y[lane] / std::exp(x[lane]) - 1.));
  }
  const double epsilon = std::numeric_limits<double>::epsilon();
  BOOST_TEST_MESSAGE(n << " lanes: relative error of 1 / sqrt(x) " << of_root / epsilon << ", of exp(x) "
                       << of_exponential / epsilon << " units in the last place");
  BOOST_TEST(of_root < 3. * epsilon);
  BOOST_TEST(of_exponential < 4. * epsilon);
}

// largest relative error of psi, P and B, where long double can tell; `exact` gives phi, A and B
template <typename RadialBasisFunction, typename Exact>
double error_of_remainders(const RadialBasisFunction& phi, const Exact& exact)
{
  const internal::Basis_function_on_lanes<RadialBasisFunction> on_lanes(phi);
  double largest = 0.;
  for(double q = .01; q < 1000.; q *= 1.01)
  {
    double psi, P, B, C;
    on_lanes.template operator()<false>(q, false, psi, P, B, C);
    const std::array<long double, 3> e = exact((long double)(q));
    const long double origin = on_lanes.at_origin();
    for(const double error :
        {double(psi / (e[0] - origin + q / 2) - 1), double(P / (e[1] + 1) - 1), double(B / e[2] - 1)})
      test_support::raise_to(largest, std::abs(error));
    if(q <= on_lanes.near)
    {
      double near_psi, near_P, near_B;
      on_lanes.template operator()<false>(q, true, near_psi, near_P, near_B, C);
      BOOST_TEST((near_psi == psi && near_P == P && near_B == B));
    }
  }
  return largest;
}

// phi and its radial derivatives A, B, C of the inverse multiquadric or Matern function of shape parameter 1, times what makes A -1 at
// the origin
template <bool is_multiquadric, typename Number>
std::array<Number, 4> radial(const Number& q)
{
  using std::exp;
  using std::sqrt;
  if constexpr(is_multiquadric)
  {
    const Number square = 1 / (1 + q), phi = sqrt(square), cube = phi * square;
    return {phi, -cube, 3 * cube * square, -15 * cube * square * square};
  }
  else
  {
    const Number a = sqrt(q), e = exp(-a);
    return {(7 + a * (7 + a * (3 + a * (Number(2) / 3 + a / 15)))) * e,
            -(1 + a * (1 + a * (Number(2) / 5 + a / 15))) * e, (1 + a * (1 + a / 3)) / 5 * e,
            -(1 + a) / 15 * e};
  }
}

// the fit at sample `i`, where `found` lies: exact or with noise level 1e-6, after so many attempts whose gradients were too small
template <bool exact>
SC::Local_implicit_surface with_more_digits(const Face_graph_samples& samples,
                                            std::size_t i,
                                            const SC::Local_implicit_surface& found,
                                            int failures)
{
  using Number = boost::multiprecision::cpp_bin_float_quad;
  using Vector = Eigen::Matrix<Number, 3, 1>;
  using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
  using Weights = Eigen::Matrix<Number, Eigen::Dynamic, 1>;
  internal::Scaled_neighborhood neighborhood;
  Face_graph_samples::Workspace workspace;
  neighborhood.collect_evenly(samples, i, workspace,
                              internal::largest_neighborhood(samples.neighborhood(), exact),
                              internal::desired_neighborhood(samples, i, exact), exact);
  const std::size_t m = neighborhood.points.size();
  const double unit =
      exact ? internal::shape_parameter_of_exact_fit(m) : internal::shape_parameter_of_noisy_fit;
  internal::Hermite_trend trend =
      exact ? internal::trend_of_exact_fit(neighborhood, unit)
            : internal::Hermite_trend(internal::trend_of_noisy_fit(neighborhood.normals));
  const internal::Exact_fit_attempts exact_noise(neighborhood);
  internal::Noisy_fit_attempts noise(neighborhood, 1e-6);
  for(int k = 0; k < failures; ++k)
    noise.next(false);
  if(!exact && noise.bends_trend())
    internal::bend_by_heights(trend, neighborhood.points);
  const Number value_noise = unit * unit * (exact ? exact_noise.value_variance() : noise.value_variance());
  const Number derivative_noise = exact ? exact_noise.derivative_variance() : noise.derivative_variance();

  struct Equation
  {
    std::size_t center;
    Vector direction; // zero: the value
  };
  std::vector<Vector> points;
  std::vector<Equation> equations;
  std::vector<Number> data;
  for(std::size_t k = 0; k < m; ++k)
  {
    const Eigen::Vector3d& normal = neighborhood.normals[k];
    const internal::Hermite_jet jet = trend(neighborhood.points[k]);
    points.push_back(Number(unit) * neighborhood.points[k].cast<Number>());
    const auto add = [&](const Eigen::Vector3d& direction, const double value)
    {
      equations.push_back({k, direction.cast<Number>()});
      data.push_back(value);
    };
    add(Eigen::Vector3d::Zero(), -unit * jet.value);
    if(exact)
    {
      Eigen::Vector3d u, v;
      internal::tangent_basis(normal, u, v);
      add(u, -jet.gradient.dot(u));
      add(v, -jet.gradient.dot(v));
      if(k == 0)
        add(normal, 1. - jet.gradient.dot(normal));
    }
    else
      for(const Eigen::Vector3d& axis :
          {Eigen::Vector3d(Eigen::Vector3d::UnitX()), Eigen::Vector3d(Eigen::Vector3d::UnitY()),
           Eigen::Vector3d(Eigen::Vector3d::UnitZ())})
        add(axis, (normal - jet.gradient).dot(axis));
  }
  const auto is_value = [](const Equation& e) { return e.direction.isZero(0); };
  const auto size = Eigen::Index(equations.size());
  std::vector<std::array<Number, 4> > functions; // from center to center
  for(const Vector& p : points)
    for(const Vector& q : points)
      functions.push_back(radial<exact>(Number((p - q).squaredNorm())));
  Matrix matrix(size, size);
  for(Eigen::Index r = 0; r < size; ++r)
    for(Eigen::Index c = 0; c < size; ++c)
    {
      const Equation &e = equations[std::size_t(r)], &f = equations[std::size_t(c)];
      const Vector d = points[e.center] - points[f.center];
      const auto& [phi, A, B, C] = functions[e.center * m + f.center];
      matrix(r, c) = is_value(e) ? (is_value(f) ? phi : -A * f.direction.dot(d))
                     : is_value(f)
                         ? A * e.direction.dot(d)
                         : -A * e.direction.dot(f.direction) - B * e.direction.dot(d) * f.direction.dot(d);
      if(r == c)
        matrix(r, c) += is_value(e) ? value_noise : derivative_noise;
    }
  // solved in long double, and corrected: each time, the error is some 1e-7 of what it was
  const auto factor = matrix.template cast<long double>().eval().ldlt();
  const Weights known = Eigen::Map<const Weights>(data.data(), size);
  Weights weights = Weights::Zero(size);
  for(int step = 0; step < 3; ++step)
  {
    const Weights remainder = known - matrix * weights;
    weights += factor.solve(remainder.template cast<long double>().eval()).template cast<Number>();
  }

  Eigen::Vector3d x = neighborhood.scaling(found.displacement) / neighborhood.scale;
  if(internal::is_negligible(x))
    x.setZero();
  Vector gradient = Vector::Zero();
  Eigen::Matrix<Number, 3, 3> hessian = Eigen::Matrix<Number, 3, 3>::Zero();
  for(Eigen::Index c = 0; c < size; ++c)
  {
    const Equation& f = equations[std::size_t(c)];
    const Vector d = Number(unit) * x.cast<Number>() - points[f.center], b = weights[c] * f.direction;
    const auto [phi, A, B, C] = radial<exact>(Number(d.squaredNorm()));
    const Number alpha = is_value(f) ? weights[c] : 0, s = b.dot(d);
    gradient += (alpha * A - B * s) * d - A * b;
    hessian += (alpha * B - C * s) * d * d.transpose() - B * (b * d.transpose() + d * b.transpose());
    hessian.diagonal().array() += alpha * A - B * s;
  }
  SC::Local_implicit_surface result;
  result.status = found.status;
  const internal::Hermite_jet jet = trend(x);
  result.gradient = neighborhood.scaling(Eigen::Vector3d(jet.gradient + gradient.cast<double>()));
  result.hessian = neighborhood.scaling(Eigen::Matrix3d(
      (jet.hessian + (Number(unit) * hessian).eval().template cast<double>()) / neighborhood.scale));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(remainders_of_basis_functions)
{
  using Number = long double;
  BOOST_TEST(error_of_remainders(
                 SC::Inverse_multiquadric(1.),
                 [](const Number q)
                 {
                   const Number phi = 1 / std::sqrt(1 + q);
                   return std::array<Number, 3>{phi, -phi * phi * phi, 3 * phi * phi * phi * phi * phi};
                 }) < 1e-12);
  BOOST_TEST(error_of_remainders(SC::Matern_9_2(1.),
                                 [](const Number q)
                                 {
                                   const Number a = std::sqrt(q), e = std::exp(-a);
                                   return std::array<Number, 3>{
                                       (7 + a * (7 + a * (3 + a * (Number(2) / 3 + a / 15)))) * e,
                                       -(1 + a * (1 + a * (Number(2) / 5 + a / 15))) * e,
                                       (1 + a * (1 + a / 3)) / 5 * e};
                                 }) < 1e-12);
}

BOOST_AUTO_TEST_CASE(functions_on_lanes)
{
  check_lanes<1>();
#if defined(__GNUC__)
  check_lanes<2>();
  check_lanes<4>();
  check_lanes<8>();
#endif
}

// The oracle is Local_hermite_rbf: plain Eigen, a fit at a time, points not scaled by the shape parameter. The exact systems
// are nearly singular, and magnify the rounding errors of both.
BOOST_AUTO_TEST_CASE(agrees_with_plain_fits)
{
  for(const unsigned int rings : {1u, 2u, 3u})
    for(const Analytic_surface& s : surfaces())
      BOOST_TEST_CONTEXT(s.name << ", " << rings << " rings")
      {
        const Face_graph_samples samples = samples_of(s, rings);
        const auto check =
            [&](const char* name, const auto& phi, const bool exact, const double noise, const double bound)
        {
          const auto expected = one_by_one(samples, phi, exact, noise);
          double largest = 0.;
          const std::vector<std::size_t> widths =
              rings == 2u ? std::vector<std::size_t>{1, 2, 4, 8} : std::vector<std::size_t>{8};
          for(const std::size_t lanes : widths)
            test_support::raise_to(
                largest, difference(expected, batched(samples, phi, exact, noise, false, lanes, 512)));
          BOOST_TEST_MESSAGE(s.name << ", " << rings << " rings, " << name << ": " << largest);
          BOOST_TEST(largest < bound, name);
        };
        check("exact", SC::Inverse_multiquadric(), true, 0., 5e-5);
        check("exact, its own shape", SC::Inverse_multiquadric(.5), true, 0., 5e-5);
        check("exact, by the scalar function", SC::Gaussian(.5), true, 0., 5e-5);
        check("noise 1e-6", SC::Matern_9_2(), false, 1e-6, 5e-5);
        check("noise 0.01", SC::Matern_9_2(), false, .01, 2e-9);
      }
}

// Where weights are large, plain fits in double precision tell less.
BOOST_AUTO_TEST_CASE(agrees_with_fits_of_more_digits)
{
  const auto check = [](const std::size_t n, const unsigned int rings, const bool exact)
  {
    const Face_graph_samples samples = samples_of(test_support::waves(.1, 4., 1., n, .2, 3), rings);
    const auto found = exact ? batched(samples, SC::Inverse_multiquadric(), true, 0., false, 8, 512)
                             : batched(samples, SC::Matern_9_2(), false, 1e-6, false, 8, 512);
    double unit = 0., largest = 0.;
    for(std::size_t i = 0; i < samples.size(); i += n / 4) // the corners, and others
      if(SC::is_estimated(found[i].status))
      {
        const auto fit = [&](const int failures)
        {
          return exact ? with_more_digits<true>(samples, i, found[i], failures)
                       : with_more_digits<false>(samples, i, found[i], failures);
        };
        SC::Local_implicit_surface expected_fit = fit(0);
        internal::Fit_quality quality;
        quality.gradient_length = expected_fit.gradient.norm();
        if(!exact && !internal::Noisy_fit_attempts::is_surface(quality, Eigen::Vector3d::Zero()))
          expected_fit = fit(1); // normals are trusted more then
        const Eigen::Matrix3d expected = shape_operator(expected_fit);
        test_support::raise_to(unit, expected.norm());
        test_support::raise_to(largest, (shape_operator(found[i]) - expected).norm());
      }
    BOOST_TEST_MESSAGE(n << " x " << n << ", " << rings << " rings" << (exact ? ", exact" : "") << ": "
                         << largest / unit);
    BOOST_TEST(unit > 1.);
    BOOST_TEST(largest < 1e-9 * unit);
  };
  for(const unsigned int rings : {2u, 3u})
  {
    check(6, rings, true);
    check(16, rings, true);
    check(16, rings, false);
  }
}

// noisy normals: some fits need more attempts than one
BOOST_AUTO_TEST_CASE(attempts_agree_with_plain_fits)
{
  for(const double turned : {.3, 1.})
    for(const Analytic_surface& s : surfaces())
      BOOST_TEST_CONTEXT(s.name << ", normals turned by " << turned)
      {
        const Face_graph_samples samples = samples_of(s, 2, turned);
        BOOST_TEST(difference(one_by_one(samples, SC::Matern_9_2(), false, 1e-4),
                              batched(samples, SC::Matern_9_2(), false, 1e-4, false, 8, 512)) < 1e-5);
      }
}

// Lanes don't see each other, nor do fits without sharing see the patches.
BOOST_AUTO_TEST_CASE(bits)
{
  for(const Analytic_surface& s : surfaces())
    for(const bool exact : {true, false})
      BOOST_TEST_CONTEXT(s.name << (exact ? ", exact" : ""))
      {
        const Face_graph_samples samples = samples_of(s, 2);
        const auto run = [&](const bool shared, const std::size_t lanes, const std::size_t patch_size)
        {
          return exact ? batched(samples, SC::Inverse_multiquadric(), true, 0., shared, lanes, patch_size)
                       : batched(samples, SC::Matern_9_2(), false, 1e-4, shared, lanes, patch_size);
        };
        BOOST_TEST(same_bits(run(false, 8, 512), run(false, 8, 100)));
        BOOST_TEST(same_bits(run(false, 8, 512), run(false, 8, 1)));
        BOOST_TEST(same_bits(run(true, 8, 512), run(true, 8, 512)));
        const auto lanes_of = [](const std::size_t most)
        { return internal::Hermite_batch_functions<SC::Matern_9_2>::best(most).lanes; };
        if(lanes_of(8) == 8 && lanes_of(4) == 4) // both with fused multiplication and addition
        {
          BOOST_TEST(same_bits(run(false, 8, 512), run(false, 4, 512)));
          BOOST_TEST(same_bits(run(true, 8, 512), run(true, 4, 512)));
        }
        if(lanes_of(2) == 2)
          BOOST_TEST(same_bits(run(true, 2, 512), run(true, 1, 512)));
      }
}

// The curvatures that are found side by side are those of the gradient and Hessian matrix.
BOOST_AUTO_TEST_CASE(curvatures_of_fits)
{
  for(const Analytic_surface& s : surfaces())
    for(const bool exact : {true, false})
      for(const std::size_t lanes : {1, 2, 4, 8})
        BOOST_TEST_CONTEXT(s.name << (exact ? ", exact, " : ", ") << lanes << " lanes")
        {
          const Face_graph_samples samples = samples_of(s, 2);
          std::vector<internal::Shape_operator_eigen> found(samples.size());
          std::vector<SC::Estimation_status> statuses(samples.size());
          std::vector<SC::Local_implicit_surface> surface;
          std::size_t of_uneven_rings = 0;
          const auto run = [&](const auto& phi)
          {
            surface = batched(samples, phi, exact, 1e-4, true, lanes, 512);
            fit_batched(samples, phi, exact, 1e-4, true, lanes, 512,
                        {[&](const std::size_t i, const SC::Local_implicit_surface& local)
                         {
                           statuses[i] = local.status;
                           if(!SC::is_estimated(local.status))
                             return;
                           ++of_uneven_rings;
                           BOOST_TEST((local.gradient == surface[i].gradient));
                           BOOST_TEST((local.hessian == surface[i].hessian));
                         },
                         [&](const std::size_t i, const SC::Estimation_status status,
                             const internal::Shape_operator_eigen& curvatures)
                         {
                           statuses[i] = status;
                           found[i] = curvatures;
                         }});
          };
          if(exact)
            run(SC::Inverse_multiquadric());
          else
            run(SC::Matern_9_2());
          double largest = 0.;
          std::size_t side_by_side = 0;
          for(std::size_t i = 0; i < samples.size(); ++i)
          {
            BOOST_TEST((statuses[i] == surface[i].status));
            const internal::Shape_operator_eigen& k = found[i];
            if(!SC::is_estimated(statuses[i]) || !k.is_finite())
              continue;
            ++side_by_side;
            const Eigen::Matrix3d expected = shape_operator(surface[i]);
            const double unit = std::max(expected.norm(), 1e-300);
            test_support::raise_to(
                largest,
                (k.min_curvature * (k.min_direction * k.min_direction.transpose()) +
                 k.max_curvature * (k.max_direction * k.max_direction.transpose()) - expected)
                        .norm() /
                    unit,
                std::abs(k.min_direction.norm() - 1.), std::abs(k.max_direction.norm() - 1.),
                std::abs(k.min_direction.dot(k.max_direction)),
                std::abs(k.min_direction.dot(surface[i].gradient.normalized())));
            BOOST_TEST(k.min_curvature <= k.max_curvature);
          }
          BOOST_TEST_MESSAGE(s.name << (exact ? ", exact, " : ", ") << lanes << " lanes: " << largest);
          BOOST_TEST(largest < 1e-13);
          const auto estimated =
              std::size_t(std::count_if(statuses.begin(), statuses.end(), SC::is_estimated));
          BOOST_TEST(side_by_side + of_uneven_rings == estimated);
          BOOST_TEST(2 * of_uneven_rings < estimated);
        }
}

BOOST_AUTO_TEST_CASE(likelihoods_agree_with_plain_ones)
{
  const Analytic_surface s = test_support::torus(1., .4, 24, 12, .2, 5);
  const Face_graph_samples samples = samples_of(s, 2, .1);
  const std::vector<double> levels = {1e-6, 1e-4, 1e-2, .1};
  const std::vector<std::uint32_t> probes = {0, 17, 100, 101, 250};
  using Plain = SC::Local_hermite_rbf<Face_graph_samples, SC::Matern_9_2>;
  using Batched = internal::Batched_hermite_rbf<Face_graph_samples, SC::Matern_9_2>;
  const std::vector<double> normal_levels = {1e-2, Plain::Options().normal_noise_level};
  Plain::Workspace workspace;
  for(const std::vector<double>& shape_factors : {std::vector<double>{1.}, std::vector<double>{1., 2., 4.}})
    for(const std::size_t neighbors : {9, 18, 36}) // of rings that grow
    {
      const auto expected_of = [&](const std::size_t probe, const double level, const double normal_level)
      {
        Plain::Options options;
        options.normal_noise_level = normal_level;
        std::vector<double> of_shape;
        for(const double factor : shape_factors)
        {
          const Plain plain(
              samples, SC::Matern_9_2().with_shape_parameter(factor * internal::shape_parameter_of_noisy_fit),
              options);
          of_shape.push_back(plain.log_likelihood(probe, level, neighbors, workspace));
        }
        const double largest = *std::max_element(of_shape.begin(), of_shape.end());
        double sum = 0.;
        for(const double l : of_shape)
          sum += std::exp(l - largest);
        return largest + std::log(sum);
      };
      std::vector<std::vector<double> > results; // of each level of the normals
      for(const double normal_level : normal_levels)
      {
        Batched::Options options;
        options.normal_noise_level = normal_level;
        const Batched batched(samples, SC::Matern_9_2(), options);
        results.push_back(batched.log_likelihoods(probes, levels, neighbors, shape_factors));
      }
      for(std::size_t k = 0; k < probes.size(); ++k)
        for(std::size_t n = 0; n < normal_levels.size(); ++n)
          for(std::size_t e = 0; e < levels.size(); ++e)
          {
            // in units of that with most noise
            const double expected = expected_of(probes[k], levels[e], normal_levels[n]) -
                                    expected_of(probes[k], levels.back(), normal_levels.back());
            const double found =
                results[n][k * levels.size() + e] - results.back()[(k + 1) * levels.size() - 1];
            // many neighbors and little noise magnify rounding: of the points, or less of them and of the normals
            const bool both_are_little = neighbors > 18 && levels[e] < 1e-3 && n == 0;
            const double tolerance = neighbors > 9 && levels[e] < 1e-5 ? 1e-4 : both_are_little ? 1e-5 : 1e-6;
            BOOST_TEST_CONTEXT(neighbors << " neighbors, " << levels[e] << ", of normals "
                                         << normal_levels[n])
            BOOST_TEST(std::abs(found - expected) < tolerance * (1. + std::abs(expected)));
          }
      BOOST_TEST(workspace.neighborhood.points.size() == neighbors + 1);
    }
}

BOOST_AUTO_TEST_SUITE_END()
