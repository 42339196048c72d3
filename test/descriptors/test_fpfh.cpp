#include <boost/test/unit_test.hpp>

#include "oriented_cloud.h"
#include "plain_pair_features.h"
#include "raise_to.h"

#include <Shape_characteristics/descriptors/Fpfh_descriptor.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/descriptors/fpfh_descriptors.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(fpfh)

using namespace oriented_cloud;
namespace plain = plain_pair_features;
using plain::Real;
using SC::Fpfh_variant;
using S = SC::Estimation_status;

namespace {

constexpr double radius = .25;

SC::Descriptor_matrix
fpfh(const Cloud& cloud, const SC::Neighborhood& neighborhood, Fpfh_variant variant = Fpfh_variant::PCL)
{
  const SC::Point_set_samples samples = samples_of(cloud, neighborhood);
  const SC::Fpfh_descriptor<SC::Point_set_samples> descriptor(samples, variant);
  return SC::compute_descriptors(descriptor, samples.size());
}

SC::Descriptor_matrix fpfh(const Cloud& cloud)
{
  return fpfh(cloud, SC::Neighborhood::ball(radius));
}

plain::Histogram simple_histograms(const Cloud& cloud,
                                   std::size_t i,
                                   const std::vector<std::size_t>& neighbors,
                                   Fpfh_variant variant)
{
  plain::Histogram h;
  h.values.assign(33, 0);
  Real pairs = 0, in_doubt = 0;
  for(const std::size_t j : neighbors)
  {
    plain::Pair pair = plain::features(plain::point(cloud, i), plain::normal(cloud, i),
                                       plain::point(cloud, j), plain::normal(cloud, j), 11);
    in_doubt += !pair.is_certain;
    if(!pair.is_defined)
    {
      if(variant != Fpfh_variant::OPEN3D)
        continue;
      pair.bin = {5, 5, 5};
    }
    pairs += 1;
    for(std::size_t k = 0; k < 3; ++k)
      h.values[11 * k + std::size_t(pair.bin[k])] += 1;
  }
  for(Real& value : h.values)
    value *= pairs > 0 ? 100 / pairs : 0;
  h.uncertainty = pairs > 0 ? 100 * in_doubt / pairs : 0;
  return h;
}

// row by row, in the form of the paper, of PCL, or of Open3D
std::vector<plain::Histogram> plain_fpfh(const Cloud& cloud, double r, Fpfh_variant variant)
{
  const std::size_t n = cloud.points.size();
  std::vector<std::vector<std::size_t> > neighbors;
  std::vector<plain::Histogram> simple, result(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    neighbors.push_back(plain::ball(cloud, i, r));
    simple.push_back(simple_histograms(cloud, i, neighbors[i], variant));
  }
  for(std::size_t i = 0; i < n; ++i)
  {
    plain::Histogram& h = result[i];
    h.values.assign(33, 0);
    Real weights = 0;
    for(const std::size_t j : neighbors[i])
    {
      const Real d = (plain::point(cloud, j) - plain::point(cloud, i)).norm();
      const Real weight = variant == Fpfh_variant::PAPER ? 1 / d : 1 / (d * d);
      weights += weight;
      for(std::size_t k = 0; k < 33; ++k)
        h.values[k] += weight * simple[j].values[k];
      h.uncertainty += weight * simple[j].uncertainty;
    }
    const Real share = variant == Fpfh_variant::PAPER ? Real(.5) : 1;
    const Real own = variant == Fpfh_variant::PCL ? 0 : share;
    for(std::size_t k = 0; k < 33; ++k)
      h.values[k] = share * h.values[k] / weights + own * simple[i].values[k];
    h.uncertainty = share * h.uncertainty / weights + own * simple[i].uncertainty;
  }
  return result;
}

// how far a row is from the reference beyond what pairs in doubt explain
double error(const SC::Descriptor_matrix& m, std::size_t i, const plain::Histogram& expected)
{
  Real largest = expected.uncertainty;
  for(std::size_t k = 0; k < expected.values.size(); ++k)
    test_support::raise_to(largest,
                           std::abs(Real(m.values(Eigen::Index(i), Eigen::Index(k))) - expected.values[k]));
  return double(largest - expected.uncertainty);
}

void check_against_reference(const Cloud& cloud, Fpfh_variant variant)
{
  const SC::Descriptor_matrix m = fpfh(cloud, SC::Neighborhood::ball(radius), variant);
  BOOST_TEST(is_consistent(m));
  const std::vector<plain::Histogram> expected = plain_fpfh(cloud, radius, variant);
  double worst = 0.;
  std::size_t estimated = 0, certain = 0;
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
    if(SC::is_estimated(m.status[i]))
    {
      ++estimated;
      certain += expected[i].uncertainty == 0;
      test_support::raise_to(worst, error(m, i, expected[i]));
    }
  BOOST_TEST(worst < 1e-4);
  BOOST_TEST(estimated > cloud.points.size() * 9 / 10);
  BOOST_TEST(certain > estimated / 2); // or nothing would be compared
}

// `tilt`: by how much normals differ
Cloud line_cloud(std::size_t count, const Vector3d& direction, double tilt = 0.)
{
  Cloud cloud;
  for(std::size_t i = 0; i < count; ++i)
  {
    cloud.points.push_back(double(i * i + 1) * direction);
    cloud.normals.push_back(Vector3d(tilt * double(i), tilt * double(i * i), 1.).normalized());
  }
  return cloud;
}

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_plain_loops)
{
  for(const double roughness : {0., .3, 3.})
  {
    const Cloud cloud = rough_cloud(300, 5, roughness);
    for(const Fpfh_variant variant : {Fpfh_variant::PAPER, Fpfh_variant::PCL, Fpfh_variant::OPEN3D})
      check_against_reference(cloud, variant);
  }
}

// points above others, along their normals
BOOST_AUTO_TEST_CASE(pairs_without_features)
{
  Cloud cloud = rough_cloud(300, 5, .3);
  for(std::size_t i = 0; i < 300; i += 50)
  {
    cloud.normals[i] = Vector3d(0., 0., 1.);
    cloud.points.push_back(cloud.points[i] + Vector3d(0., 0., .125));
    cloud.normals.push_back(cloud.normals[i + 1]);
  }
  for(const Fpfh_variant variant : {Fpfh_variant::PAPER, Fpfh_variant::PCL, Fpfh_variant::OPEN3D})
    check_against_reference(cloud, variant);
}

// The nearest neighbor, by orders of magnitude, has no histograms: it sees all the others along its normal. Those of the others count
// as if it weren't there.
BOOST_AUTO_TEST_CASE(neighbor_without_histograms)
{
  Cloud cloud;
  for(int k = 0; k < 8; ++k)
  {
    cloud.points.emplace_back(1e-7 * std::cos(.7 * k), 1e-7 * std::sin(.7 * k), 1. + 1e-7 * k);
    cloud.normals.push_back(Vector3d(std::cos(.7 * k), std::sin(.4 * k), 1.).normalized());
  }
  cloud.points.emplace_back(0., 0., 0.);
  cloud.normals.push_back(Vector3d(0., 0., 1.));
  cloud.points.emplace_back(1e-20, 0., 0.);
  cloud.normals.push_back(Vector3d(1., 0., 1.).normalized());
  const Eigen::Index last = 9;
  for(const Fpfh_variant variant : {Fpfh_variant::PAPER, Fpfh_variant::PCL, Fpfh_variant::OPEN3D})
  {
    const SC::Descriptor_matrix m = fpfh(cloud, SC::Neighborhood::nearest(20), variant);
    BOOST_TEST(int(m.status[8]) == int(variant == Fpfh_variant::OPEN3D ? S::ESTIMATED : S::DEGENERATE));
    BOOST_TEST(int(m.status[std::size_t(last)]) == int(S::ESTIMATED));
    BOOST_TEST(is_consistent(m));
    for(Eigen::Index k = 0; k < 33; k += 11)
      BOOST_TEST(std::abs(m.values.row(last).segment(k, 11).sum() -
                          (variant == Fpfh_variant::OPEN3D ? 200.f : 100.f)) < 1e-3f);
  }
}

BOOST_AUTO_TEST_CASE(three_histograms_of_a_hundred)
{
  const Cloud cloud = rough_cloud(400, 6, 1.);
  for(const Fpfh_variant variant : {Fpfh_variant::PAPER, Fpfh_variant::PCL, Fpfh_variant::OPEN3D})
  {
    const SC::Descriptor_matrix m = fpfh(cloud, SC::Neighborhood::nearest(20), variant);
    BOOST_TEST(m.values.cols() == 33);
    BOOST_TEST(number_of(S::ESTIMATED, m) == 400u);
    BOOST_TEST(m.values.minCoeff() >= 0.f);
    for(Eigen::Index i = 0; i < m.values.rows(); ++i)
      for(Eigen::Index k = 0; k < 33; k += 11)
        BOOST_TEST(std::abs(m.values.row(i).segment(k, 11).sum() -
                            (variant == Fpfh_variant::OPEN3D ? 200.f : 100.f)) < 1e-3f);
  }
}

// the second of the three histograms tells left from right, and nothing else does
BOOST_AUTO_TEST_CASE(mirrored_surface)
{
  const Cloud cloud = rough_cloud(300, 7, 3.);
  const SC::Descriptor_matrix m = fpfh(cloud), of_mirrored = fpfh(mirrored(cloud));
  SC::Descriptor_matrix expected = m;
  double odd = 0.;
  for(Eigen::Index i = 0; i < m.values.rows(); ++i)
  {
    if(SC::is_estimated(m.status[std::size_t(i)]))
      SC::Fpfh_descriptor<SC::Point_set_samples>::mirrored(m.values.row(i).data(),
                                                           expected.values.row(i).data());
    if(SC::is_estimated(m.status[std::size_t(i)]))
      test_support::raise_to(
          odd, double((m.values.row(i) - expected.values.row(i)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>()));
  }
  BOOST_TEST(same_bits(of_mirrored, expected));
  BOOST_TEST(odd > 10.);
  for(Eigen::Index k = 0; k < 33; ++k)
  {
    double change = 0.;
    for(Eigen::Index i = 0; i < m.values.rows(); ++i)
      if(SC::is_estimated(m.status[std::size_t(i)]))
        test_support::raise_to(change, std::abs(double(of_mirrored.values(i, k)) - double(m.values(i, k))));
    BOOST_TEST((change > 0.) == (k >= 11 && k < 22 && k != 16)); // 16 is the middle
  }
}

BOOST_AUTO_TEST_CASE(flipped_normals)
{
  const Cloud cloud = rough_cloud(300, 8, .3);
  SC::Descriptor_matrix m = fpfh(cloud);
  const SC::Descriptor_matrix of_flipped = fpfh(flipped(cloud));
  for(Eigen::Index i = 0; i < m.values.rows(); ++i)
    for(const Eigen::Index k : {0, 22})
      std::reverse(m.values.row(i).data() + k, m.values.row(i).data() + k + 11);
  BOOST_TEST(same_bits(of_flipped, m));
}

BOOST_AUTO_TEST_CASE(motion_and_unit)
{
  const Cloud cloud = rough_cloud(300, 9, .3);
  const SC::Descriptor_matrix m = fpfh(cloud);
  for(const double power_of_two : {std::ldexp(1., -40), std::ldexp(1., 40)})
    BOOST_TEST(same_bits(fpfh(moved(cloud, power_of_two, Eigen::Matrix3d::Identity(), Vector3d::Zero()),
                              SC::Neighborhood::ball(radius * power_of_two)),
                         m));
  // what rounding changes is no more than what the reference has doubts about
  const std::vector<plain::Histogram> expected = plain_fpfh(cloud, radius, Fpfh_variant::PCL);
  for(const double scale : {1e-6, 1., 1e6})
    for(const Vector3d& shift : {Vector3d(0., 0., 0.), Vector3d(3e3, -1e3, 2e3)})
    {
      const SC::Descriptor_matrix of_moved =
          fpfh(moved(cloud, scale, some_rotation(), scale * shift), SC::Neighborhood::ball(radius * scale));
      BOOST_TEST((of_moved.status == m.status));
      double worst = 0.;
      for(std::size_t i = 0; i < expected.size(); ++i)
        if(SC::is_estimated(m.status[i]))
          test_support::raise_to(worst, error(of_moved, i, expected[i]));
      BOOST_TEST(worst < 1e-4);
    }
}

BOOST_AUTO_TEST_CASE(regular_points_of_other_sizes)
{
  for(const Cloud& cloud : {torus_cloud(24, 12), torus_cloud(48, 24)})
    for(const double r : {.3, .4})
    {
      const SC::Descriptor_matrix m = fpfh(cloud, SC::Neighborhood::ball(r));
      for(const double scale : {1e6, 3e5, 1e3, 1e-6})
      {
        const Cloud other = moved(cloud, scale, Eigen::Matrix3d::Identity(), Vector3d::Zero());
        BOOST_TEST(difference(m, fpfh(other, SC::Neighborhood::ball(r * scale))) < 1e-4);
      }
    }
}

BOOST_AUTO_TEST_CASE(order_of_the_points)
{
  const Cloud cloud = rough_cloud(300, 10, .3);
  std::vector<std::size_t> order(300);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::mt19937 generator(3);
  for(std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[generator() % i]);
  for(const SC::Neighborhood& neighborhood : {SC::Neighborhood::ball(radius), SC::Neighborhood::nearest(12)})
  {
    const SC::Descriptor_matrix m = fpfh(cloud, neighborhood);
    BOOST_TEST(same_bits(fpfh(permuted(cloud, order), neighborhood), permuted(m, order)));
  }
}

BOOST_AUTO_TEST_CASE(threads_and_subsets)
{
  const Cloud cloud = rough_cloud(1000, 11, .3);
  const SC::Point_set_samples samples = samples_of(cloud, SC::Neighborhood::ball(.15));
  using Descriptor = SC::Fpfh_descriptor<SC::Point_set_samples>;
  const Descriptor descriptor(samples, Fpfh_variant::PCL, CGAL::Sequential_tag());
  const SC::Descriptor_matrix m = SC::compute_descriptors<CGAL::Sequential_tag>(descriptor, samples.size());
  const Descriptor in_parallel(samples, Fpfh_variant::PCL, CGAL::Parallel_if_available_tag());
  BOOST_TEST(
      same_bits(SC::compute_descriptors<CGAL::Parallel_if_available_tag>(in_parallel, samples.size()), m));

  const std::vector<std::size_t> some = {999, 0, 17, 500, 17};
  for(const Fpfh_variant variant : {Fpfh_variant::PCL, Fpfh_variant::PAPER})
  {
    const SC::Descriptor_matrix all = fpfh(cloud, SC::Neighborhood::ball(.15), variant);
    const Descriptor of_some(samples, some, variant);
    const SC::Descriptor_matrix rows = SC::compute_descriptors(of_some, some);
    BOOST_TEST(rows.values.rows() == 5);
    for(std::size_t k = 0; k < some.size(); ++k)
    {
      BOOST_TEST((rows.status[k] == all.status[some[k]]));
      BOOST_TEST((rows.values.row(Eigen::Index(k)) == all.values.row(Eigen::Index(some[k]))));
    }
  }
}

BOOST_AUTO_TEST_CASE(bad_point_sets)
{
  for(const SC::Neighborhood& neighborhood : {SC::Neighborhood::ball(1e3), SC::Neighborhood::nearest(10)})
  {
    BOOST_TEST(fpfh(Cloud(), neighborhood).values.rows() == 0);
    BOOST_TEST(fpfh(Cloud(), neighborhood).values.cols() == 33);
    for(const std::size_t count : {1, 2})
    {
      const SC::Descriptor_matrix m = fpfh(line_cloud(count, {1., 2., 3.}), neighborhood);
      BOOST_TEST(is_consistent(m));
      BOOST_TEST(number_of(S::FEW_NEIGHBOURS, m) == count);
    }
    for(const double scale : {1e-6, 1., 1e6})
    {
      const SC::Descriptor_matrix m =
          fpfh(line_cloud(8, scale * Vector3d(.1, .2, .3), .1),
               neighborhood.kind() == SC::Neighborhood::Kind::BALL ? SC::Neighborhood::ball(1e3 * scale)
                                                                   : neighborhood);
      BOOST_TEST(is_consistent(m));
      BOOST_TEST(number_of(S::DEGENERATE, m) == 8u);
    }
    // all at the same place: nobody has a neighbor
    const SC::Descriptor_matrix identical = fpfh(line_cloud(8, {0., 0., 0.}), neighborhood);
    BOOST_TEST(is_consistent(identical));
    BOOST_TEST(number_of(S::FEW_NEIGHBOURS, identical) == 8u);
  }

  // in a plane, all three are 0
  Cloud plane;
  for(int i = 0; i < 5; ++i)
    for(int j = 0; j < 5; ++j)
    {
      plane.points.emplace_back(.1 * i, .1 * j, 0.);
      plane.normals.emplace_back(0., 0., 2.);
    }
  const SC::Descriptor_matrix flat = fpfh(plane);
  for(Eigen::Index i = 0; i < 25; ++i)
    for(Eigen::Index k = 0; k < 33; ++k)
      BOOST_TEST(std::abs(flat.values(i, k) - (k % 11 == 5 ? 100.f : 0.f)) < 1e-4f);

  // points above each other along their normals have no features
  Cloud stack = line_cloud(6, {0., 0., 1.});
  stack.points.emplace_back(.1, 0., 1.);
  stack.normals.emplace_back(0., 0., 1.);
  BOOST_TEST(is_consistent(fpfh(stack, SC::Neighborhood::ball(100.))));
}

BOOST_AUTO_TEST_CASE(bad_points_among_good_ones)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const Cloud good = rough_cloud(300, 12, .3);
  const SC::Descriptor_matrix m = fpfh(good);
  Cloud cloud = good;
  for(const Vector3d& p : {Vector3d(nan, 0., 0.), Vector3d(0., infinity, 0.)})
  {
    cloud.points.push_back(p);
    cloud.normals.emplace_back(0., 0., 1.);
  }
  for(const Vector3d& n : {Vector3d(0., 0., 0.), Vector3d(0., nan, 1.), Vector3d(infinity, 0., 0.)})
  {
    cloud.points.emplace_back(.1, .1, .2);
    cloud.normals.push_back(n);
  }
  const SC::Descriptor_matrix with_bad = fpfh(cloud);
  BOOST_TEST(is_consistent(with_bad));
  BOOST_TEST(number_of(S::NON_FINITE_INPUT, with_bad) == 5u);
  for(std::size_t i = 0; i < 300; ++i)
  {
    BOOST_TEST((with_bad.status[i] == m.status[i]));
    if(SC::is_estimated(m.status[i]))
      BOOST_TEST((with_bad.values.row(Eigen::Index(i)) == m.values.row(Eigen::Index(i))));
  }

  // each point three times: the same shares of the same histograms
  Cloud thrice;
  for(int copy = 0; copy < 3; ++copy)
  {
    thrice.points.insert(thrice.points.end(), good.points.begin(), good.points.end());
    thrice.normals.insert(thrice.normals.end(), good.normals.begin(), good.normals.end());
  }
  const SC::Descriptor_matrix of_thrice = fpfh(thrice);
  for(std::size_t i = 0; i < 900; ++i)
    if(SC::is_estimated(m.status[i % 300]))
      BOOST_TEST((of_thrice.values.row(Eigen::Index(i)) - m.values.row(Eigen::Index(i % 300)))
                     .cwiseAbs()
                     .maxCoeff<Eigen::PropagateNaN>() < 1e-3f);
}

BOOST_AUTO_TEST_CASE(functions_for_meshes_and_point_sets)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using test_support::Oriented_point;
  namespace np = SC::parameters;

  // a height field over a grid, its normals given
  Mesh mesh;
  std::vector<Oriented_point> points;
  const int n = 12;
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      const double x = .1 * i + .013 * (i * j % 3), y = .1 * j + .017 * (i % 4),
                   z = .05 * std::sin(4. * x + y);
      const auto v = mesh.add_vertex(Kernel::Point_3(x, y, z));
      const double slope = .05 * std::cos(4. * x + y);
      normals[v] = Kernel::Vector_3(-4. * slope, -slope, 1.);
      points.emplace_back(mesh.point(v), normals[v]);
    }
  for(int i = 0; i + 1 < n; ++i)
    for(int j = 0; j + 1 < n; ++j)
    {
      const auto v = [&](int k, int l) { return Mesh::Vertex_index(Mesh::size_type(k * n + l)); };
      mesh.add_face(v(i, j), v(i + 1, j), v(i + 1, j + 1));
      mesh.add_face(v(i, j), v(i + 1, j + 1), v(i, j + 1));
    }
  const auto maps = test_support::oriented_point_maps();
  const SC::Descriptor_matrix of_mesh =
      SC::fpfh_descriptors(mesh, np::vertex_normal_map(normals).neighbor_radius(.3));
  const SC::Descriptor_matrix of_points = SC::fpfh_descriptors(points, maps.neighbor_radius(.3));
  BOOST_TEST(of_mesh.status.size() == std::size_t(n * n));
  BOOST_TEST((of_mesh.values == of_points.values));
  BOOST_TEST(number_of(S::BORDER, of_mesh) == std::size_t(4 * (n - 1)));
  BOOST_TEST(number_of(S::ESTIMATED, of_points) == std::size_t(n * n));

  const SC::Descriptor_matrix of_rings = SC::fpfh_descriptors<CGAL::Sequential_tag>(mesh);
  BOOST_TEST(is_consistent(of_rings));
  BOOST_TEST(number_of(S::ESTIMATED, of_rings) == std::size_t((n - 2) * (n - 2)));

  const std::vector<int> some = {30, 7};
  const SC::Descriptor_matrix rows =
      SC::fpfh_descriptors(mesh, np::vertex_normal_map(normals).neighbor_radius(.3).descriptor_samples(some));
  BOOST_TEST((rows.values.row(0) == of_mesh.values.row(30)));
  BOOST_TEST((rows.values.row(1) == of_mesh.values.row(7)));
  BOOST_TEST((rows.status[1] == S::BORDER));
  const SC::Descriptor_matrix same = SC::fpfh_descriptors(
      mesh, np::vertex_normal_map(normals).neighbor_radius(.3).descriptor_samples(std::cref(some)));
  BOOST_TEST((same.values == rows.values));

  for(const int wrong : {-1, n * n})
    BOOST_CHECK_EXCEPTION(
        SC::fpfh_descriptors(mesh, np::descriptor_samples(std::vector<int>{0, wrong})), std::invalid_argument,
        [](const std::invalid_argument& e)
        { return std::string(e.what()).find("Shape_characteristics: descriptor_samples") == 0; });
  BOOST_CHECK_THROW(SC::fpfh_descriptors(mesh, np::neighbor_radius(-1.)), std::invalid_argument);
  BOOST_CHECK_THROW(
      SC::fpfh_descriptors(points, np::point_map(CGAL::First_of_pair_property_map<Oriented_point>())),
      std::invalid_argument);

  // progress, and an end before the end
  std::vector<double> advancements;
  const auto watch = [&](double advancement)
  {
    advancements.push_back(advancement);
    return true;
  };
  SC::fpfh_descriptors(mesh, np::callback(watch));
  BOOST_TEST(std::is_sorted(advancements.begin(), advancements.end()));
  BOOST_TEST(advancements.front() > 0.);
  BOOST_TEST(advancements.back() == 1.);
  const std::size_t calls = advancements.size();
  for(std::size_t last = 1; last < calls; ++last)
  {
    std::size_t call = 0;
    const SC::Descriptor_matrix incomplete =
        SC::fpfh_descriptors<CGAL::Sequential_tag>(mesh, np::callback([&](double) { return ++call < last; }));
    BOOST_TEST(call == last);
    BOOST_TEST(is_consistent(incomplete));
    BOOST_TEST(number_of(S::CANCELLED, incomplete) > 0u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
