#include <boost/test/unit_test.hpp>

#include "oriented_cloud.h"
#include "plain_pair_features.h"
#include "raise_to.h"

#include <Shape_characteristics/descriptors/Pfh_descriptor.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/descriptors/pfh_descriptors.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(pfh)

using namespace oriented_cloud;
namespace plain = plain_pair_features;
using plain::Real;
using S = SC::Estimation_status;

namespace {

constexpr double radius = .25;

SC::Descriptor_matrix pfh(const Cloud& cloud, const SC::Neighborhood& neighborhood)
{
  const SC::Point_set_samples samples = samples_of(cloud, neighborhood);
  return SC::compute_descriptors(SC::Pfh_descriptor<SC::Point_set_samples>(samples), samples.size());
}

SC::Descriptor_matrix pfh(const Cloud& cloud)
{
  return pfh(cloud, SC::Neighborhood::ball(radius));
}

plain::Histogram plain_pfh(const Cloud& cloud, std::size_t i, double r)
{
  std::vector<std::size_t> all = plain::ball(cloud, i, r);
  all.push_back(i);
  plain::Histogram h;
  h.values.assign(125, 0);
  Real pairs = 0, in_doubt = 0;
  for(std::size_t a = 0; a < all.size(); ++a)
    for(std::size_t b = 0; b < a; ++b)
    {
      const plain::Pair pair = plain::features(plain::point(cloud, all[a]), plain::normal(cloud, all[a]),
                                               plain::point(cloud, all[b]), plain::normal(cloud, all[b]), 5);
      in_doubt += !pair.is_certain;
      if(!pair.is_defined)
        continue;
      pairs += 1;
      h.values[std::size_t(pair.bin[0] + 5 * pair.bin[1] + 25 * pair.bin[2])] += 1;
    }
  for(Real& value : h.values)
    value *= pairs > 0 ? 100 / pairs : 0;
  h.uncertainty = pairs > 0 ? 100 * in_doubt / pairs : 0;
  return h;
}

// how far the rows are from the reference, at most, beyond what pairs in doubt explain
double error(const SC::Descriptor_matrix& m, const std::vector<plain::Histogram>& expected)
{
  Real worst = 0;
  for(std::size_t i = 0; i < expected.size(); ++i)
    if(SC::is_estimated(m.status[i]))
      for(std::size_t k = 0; k < 125; ++k)
        test_support::raise_to(
            worst, std::abs(Real(m.values(Eigen::Index(i), Eigen::Index(k))) - expected[i].values[k]) -
                       expected[i].uncertainty);
  return double(worst);
}

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_plain_loops)
{
  for(const double roughness : {0., .3, 3.})
  {
    const Cloud cloud = rough_cloud(250, 5, roughness);
    const SC::Descriptor_matrix m = pfh(cloud);
    BOOST_TEST(is_consistent(m));
    BOOST_TEST(m.values.cols() == 125);
    BOOST_TEST(number_of(S::ESTIMATED, m) > 240u);
    std::vector<plain::Histogram> expected;
    std::size_t certain = 0;
    for(std::size_t i = 0; i < cloud.points.size(); ++i)
    {
      expected.push_back(plain_pfh(cloud, i, radius));
      certain += expected.back().uncertainty == 0;
    }
    BOOST_TEST(error(m, expected) < 1e-5);
    BOOST_TEST(certain > 125u); // or nothing would be compared
    for(std::size_t i = 0; i < cloud.points.size(); ++i)
      if(SC::is_estimated(m.status[i]))
        BOOST_TEST(std::abs(m.values.row(Eigen::Index(i)).sum() - 100.f) < 1e-3f);

    // moved, and in another unit
    for(const double scale : {1e-6, 1e6})
    {
      const SC::Descriptor_matrix of_moved =
          pfh(moved(cloud, scale, some_rotation(), scale * Vector3d(30., -10., 20.)),
              SC::Neighborhood::ball(radius * scale));
      BOOST_TEST((of_moved.status == m.status));
      BOOST_TEST(error(of_moved, expected) < 1e-5);
    }
    BOOST_TEST(same_bits(pfh(moved(cloud, std::ldexp(1., 40), Eigen::Matrix3d::Identity(), Vector3d::Zero()),
                             SC::Neighborhood::ball(std::ldexp(radius, 40))),
                         m));
  }
}

BOOST_AUTO_TEST_CASE(mirrored_and_permuted)
{
  const Cloud cloud = rough_cloud(250, 7, 1.);
  const SC::Descriptor_matrix m = pfh(cloud);
  SC::Descriptor_matrix expected = m;
  for(std::size_t i = 0; i < 250; ++i)
    if(SC::is_estimated(m.status[i]))
      SC::Pfh_descriptor<SC::Point_set_samples>::mirrored(m.values.row(Eigen::Index(i)).data(),
                                                          expected.values.row(Eigen::Index(i)).data());
  BOOST_TEST(same_bits(pfh(mirrored(cloud)), expected));
  BOOST_TEST(!same_bits(m, expected));

  std::vector<std::size_t> order;
  for(std::size_t i = 250; i-- > 0;)
    order.push_back(i);
  BOOST_TEST(same_bits(pfh(permuted(cloud, order)), permuted(m, order)));
}

BOOST_AUTO_TEST_CASE(bad_point_sets)
{
  for(const SC::Neighborhood& neighborhood : {SC::Neighborhood::ball(1e3), SC::Neighborhood::nearest(10)})
  {
    BOOST_TEST(pfh(Cloud(), neighborhood).values.cols() == 125);
    check_points_on_a_line([&](const Cloud& line) { return pfh(line, neighborhood); });
  }

  const Cloud good = rough_cloud(250, 12, .3);
  check_samples_that_are_not_finite(good, [](const Cloud& cloud) { return pfh(cloud); });

  // pairs of points at the same place have no features, and nothing is divided by their distance
  Cloud twice = good;
  twice.points.insert(twice.points.end(), good.points.begin(), good.points.end());
  twice.normals.insert(twice.normals.end(), good.normals.rbegin(), good.normals.rend());
  BOOST_TEST(is_consistent(pfh(twice)));
}

BOOST_AUTO_TEST_CASE(functions_for_meshes_and_point_sets)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  namespace np = SC::parameters;

  const Cloud cloud = rough_cloud(500, 3, .3);
  const std::vector<test_support::Oriented_point> points = pairs_of(cloud);
  const auto maps = test_support::oriented_point_maps();
  const SC::Descriptor_matrix m =
      SC::pfh_descriptors<CGAL::Sequential_tag>(points, maps.neighbor_radius(radius));
  BOOST_TEST(same_bits(m, pfh(cloud))); // which runs in parallel
  const SC::Descriptor_matrix row = SC::pfh_descriptors(
      points, maps.neighbor_radius(radius).descriptor_samples(std::vector<unsigned int>{42u}));
  BOOST_TEST(row.values.rows() == 1);
  BOOST_TEST((row.values.row(0) == m.values.row(42)));
  BOOST_CHECK_THROW(SC::pfh_descriptors(points, maps.descriptor_samples(std::vector<unsigned int>{500u})),
                    std::invalid_argument);
  const SC::Descriptor_matrix cancelled =
      SC::pfh_descriptors<CGAL::Sequential_tag>(points, maps.callback([](double) { return false; }));
  BOOST_TEST(is_consistent(cancelled));
  BOOST_TEST(number_of(S::ESTIMATED, cancelled) == 128u);
  BOOST_TEST(number_of(S::CANCELLED, cancelled) == 372u);

  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0., 0., 0.), Kernel::Point_3(1., 0., 0.),
                         Kernel::Point_3(0., 1., 0.), Kernel::Point_3(0., 0., 1.), mesh);
  mesh.add_vertex(Kernel::Point_3(5., 5., 5.));
  const SC::Descriptor_matrix of_mesh = SC::pfh_descriptors(mesh);
  BOOST_TEST(is_consistent(of_mesh));
  BOOST_TEST(number_of(S::ESTIMATED, of_mesh) == 4u);
  BOOST_TEST((of_mesh.status[4] == S::UNREFERENCED));
}

BOOST_AUTO_TEST_SUITE_END()
