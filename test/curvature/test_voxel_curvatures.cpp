#include <boost/test/unit_test.hpp>

#include "estimator_checks.h"
#include "raise_to.h"

#include <Shape_characteristics/curvature/Voxel_octree.h>
#include <Shape_characteristics/curvature/voxel_curvatures.h>
#include <Shape_characteristics/curvature/voxelize.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/number_type_config.h>
#include <CGAL/property_map.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(voxel_curvatures)

using namespace estimator_checks;

namespace {

using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Item = std::tuple<Point_3, Vector_3, Curvatures, double, double, SC::Estimation_status>;
using Items = std::vector<Item>;

template <int I>
using Nth = CGAL::Nth_of_tuple_property_map<I, Item>;

enum class Normals_of_items
{
  GIVEN,
  OF_THE_VOXELS
};

template <typename Tag = CGAL::Sequential_tag>
std::size_t estimate(const SC::Voxel_octree& octree, Items& items, double radius, Normals_of_items normals)
{
  const auto np = SC::parameters::point_map(Nth<0>())
                      .principal_curvatures_and_directions_map(Nth<2>())
                      .mean_curvature_map(Nth<3>())
                      .Gaussian_curvature_map(Nth<4>())
                      .status_map(Nth<5>())
                      .neighbor_radius(radius);
  return normals == Normals_of_items::GIVEN
             ? SC::voxel_curvatures<Tag>(octree, items, np.normal_map(Nth<1>()))
             : SC::voxel_curvatures<Tag>(octree, items, np);
}

Items items_of(const Analytic_surface& s)
{
  Items items(s.points.size());
  for(std::size_t i = 0; i < items.size(); ++i)
  {
    const auto &p = s.points[i], &n = s.exact[i].normal;
    std::get<0>(items[i]) = Point_3(p[0], p[1], p[2]);
    std::get<1>(items[i]) = Vector_3(n[0], n[1], n[2]);
  }
  return items;
}

Items items_at(const std::vector<Point_3>& points)
{
  Items items(points.size());
  for(std::size_t i = 0; i < items.size(); ++i)
    std::get<0>(items[i]) = points[i];
  return items;
}

SC::Voxel_octree voxels(const Analytic_surface& s, double size, SC::Voxel_values values)
{
  return SC::voxelize(surface_mesh_of(s), size, values);
}

double mean_error(const Analytic_surface& s, const Items& items)
{
  double sum = 0.;
  for(std::size_t i = 0; i < items.size(); ++i)
  {
    const Curvatures& c = std::get<2>(items[i]);
    BOOST_TEST_REQUIRE((std::get<5>(items[i]) == SC::Estimation_status::ESTIMATED));
    sum += std::abs(c.min_curvature - s.exact[i].k_min) + std::abs(c.max_curvature - s.exact[i].k_max);
  }
  return sum / (2. * double(items.size()) * largest_curvature(s));
}

bool same_bits(const Items& a, const Items& b)
{
  bool same = a.size() == b.size();
  for(std::size_t i = 0; same && i < a.size(); ++i)
    same = estimator_checks::same_bits(std::get<2>(a[i]), std::get<2>(b[i])) &&
           std::get<5>(a[i]) == std::get<5>(b[i]);
  return same;
}

} // namespace

// the octree against all voxels, divided into small ones
BOOST_AUTO_TEST_CASE(moments_by_counting)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0., 1.);
  const SC::Voxel_octree::Voxel size = {7, 9, 5};
  const std::array<double, 3> spacing = {1., .8, 1.3};
  std::vector<double> values(7 * 9 * 5);
  for(std::size_t v = 0; v < values.size(); ++v) // a solid block, and some of all values
    values[v] = v < 160 ? 1. : v % 3 == 0 ? 0. : number(random);
  const Point_3 origin(.5, -2., 1.);
  const SC::Voxel_octree octree(size, origin, spacing,
                                [&](std::size_t i, std::size_t j, std::size_t k)
                                { return values[i + 7 * (j + 9 * k)]; });
  for(std::size_t v = 0; v < values.size(); ++v)
    BOOST_TEST(octree.value(v % 7, v / 7 % 9, v / 63) == values[v]);
  BOOST_TEST(octree.value(7, 0, 0) == 0.);

  for(const double radius : {1.7, 3.1, 20.})
  {
    const Eigen::Vector3d center(3.2, 1.1, 3.9);
    const auto m = octree.moments_in_ball(center, radius);
    const int n = 24;
    double volume = 0.;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for(std::size_t v = 0; v < values.size(); ++v)
      for(int a = 0; a < n * n * n && values[v] > 0.; ++a)
      {
        const Eigen::Vector3d corner(double(v % 7), double(v / 7 % 9), double(v / 63));
        const Eigen::Vector3d in((a % n + .5) / n, (a / n % n + .5) / n, (a / n / n + .5) / n);
        const Eigen::Vector3d p =
            (Eigen::Vector3d(.5, -2., 1.) +
             (corner + in).cwiseProduct(Eigen::Vector3d(spacing[0], spacing[1], spacing[2])) - center) /
            radius;
        if(p.squaredNorm() > 1.)
          continue;
        const double weight = values[v] * 1.04 / std::pow(n * radius, 3);
        volume += weight;
        first += weight * p;
        second += weight * p * p.transpose();
      }
    BOOST_TEST_MESSAGE("  radius " << radius << ": " << m.volume - volume << ", " << (m.first - first).norm()
                                   << ", " << (m.second - second).norm());
    BOOST_TEST(std::abs(m.volume - volume) < 1e-3);
    BOOST_TEST((m.first - first).norm() < 1e-3);
    BOOST_TEST((m.second - second).norm() < 1e-3);
    BOOST_TEST(std::abs(octree.volume_in_ball(Point_3(3.2, 1.1, 3.9), radius) -
                        m.volume * std::pow(radius, 3)) < 1e-12 * std::pow(radius, 3));
  }
}

BOOST_AUTO_TEST_CASE(voxels_of_meshes)
{
  // a box that is no multiple of voxels: exact shares along z, and along x and y as far as four lines see them
  Surface_mesh box;
  const std::array<double, 3> a = {.1, .2, .3}, b = {1.35, 2.2, 1.7};
  CGAL::make_hexahedron(Point_3(a[0], a[1], a[2]), Point_3(b[0], a[1], a[2]), Point_3(b[0], b[1], a[2]),
                        Point_3(a[0], b[1], a[2]), Point_3(a[0], b[1], b[2]), Point_3(a[0], a[1], b[2]),
                        Point_3(b[0], a[1], b[2]), Point_3(b[0], b[1], b[2]), box);
  CGAL::Polygon_mesh_processing::triangulate_faces(box);
  const double volume = 1.25 * 2. * 1.4;
  const auto total = [](const SC::Voxel_octree& o) { return o.volume_in_ball(Point_3(1., 1., 1.), 100.); };
  BOOST_TEST(std::abs(total(SC::voxelize(box, .25)) - volume) < 1e-5 * volume);
  BOOST_TEST(std::abs(total(SC::voxelize(box, .05, SC::Voxel_values::BINARY)) - volume) < 1e-2 * volume);

  // a grid's lines through vertices and along edges: a symmetric octahedron, and one inside out
  Surface_mesh octahedron;
  CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1), octahedron);
  for(int turn = 0; turn < 2; ++turn)
  {
    for(const double size : {.125, .1, .03})
      BOOST_TEST(std::abs(total(SC::voxelize(octahedron, size)) - 1. / 6.) < .1 * size);
    CGAL::Polygon_mesh_processing::reverse_face_orientations(octahedron);
  }

  // a plate whose walls are cut into slabs, and so large that its columns come in several parts
  double volume_of_slabs[2] = {};
  for(const int slabs : {1, 5})
  {
    Surface_mesh prism;
    std::vector<Surface_mesh::Vertex_index> ring[6];
    for(int k = 0; k <= slabs; ++k)
      for(const auto& [x, y] :
          {std::pair(150., 0.), std::pair(300., 150.), std::pair(150., 300.), std::pair(0., 150.)})
        ring[k].push_back(prism.add_vertex(Point_3(x, y, 1.3 * k / slabs)));
    for(int k = 0; k < slabs; ++k)
      for(int c = 0; c < 4; ++c)
      {
        prism.add_face(ring[k][c], ring[k][(c + 1) % 4], ring[k + 1][(c + 1) % 4]);
        prism.add_face(ring[k][c], ring[k + 1][(c + 1) % 4], ring[k + 1][c]);
      }
    prism.add_face(ring[0][0], ring[0][2], ring[0][1]);
    prism.add_face(ring[0][0], ring[0][3], ring[0][2]);
    prism.add_face(ring[slabs][0], ring[slabs][1], ring[slabs][2]);
    prism.add_face(ring[slabs][0], ring[slabs][2], ring[slabs][3]);
    volume_of_slabs[slabs > 1] = SC::voxelize(prism, .9).volume_in_ball(Point_3(150., 150., 0.), 1000.);
    BOOST_TEST(std::abs(volume_of_slabs[slabs > 1] / (45000. * 1.3) - 1.) < 1e-3);
  }
  BOOST_TEST(volume_of_slabs[0] == volume_of_slabs[1]);

  const Analytic_surface s = test_support::sphere(1., 5);
  const Surface_mesh sphere = surface_mesh_of(s);
  BOOST_TEST(std::abs(total(SC::voxelize(sphere, .05)) / (4. * CGAL_PI / 3.) - 1.) < 3e-3);

  for(const double size : {0., -1., std::nan(""), 1e-9, 1e308})
    BOOST_CHECK_THROW(SC::voxelize(sphere, size), std::invalid_argument);
  Surface_mesh open, empty;
  CGAL::make_triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), open);
  BOOST_CHECK_THROW(SC::voxelize(open, .1), std::invalid_argument);
  BOOST_TEST(SC::voxelize(empty, .1).surface_points().empty());
  Surface_mesh infinite = octahedron;
  infinite.point(*infinite.vertices().begin()) = Point_3(std::numeric_limits<double>::infinity(), 0., 0.);
  BOOST_CHECK_THROW(SC::voxelize(infinite, .1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(errors_at_points_of_the_surface)
{
  struct Case
  {
    Analytic_surface surface, mesh; // few points, fine mesh
    double radius, shares, binary;
  };
  for(const Case& c :
      {Case{test_support::torus(1., .4, 16, 8), test_support::torus(1., .4, 192, 96), .18, .03, .08},
       Case{test_support::sphere(1., 1), test_support::sphere(1., 5), .35, .04, .04},
       Case{test_support::ellipsoid(1., .8, .6, 1), test_support::ellipsoid(1., .8, .6, 5), .25, .03, .06}})
    for(const auto values : {SC::Voxel_values::SHARES, SC::Voxel_values::BINARY})
    {
      const SC::Voxel_octree octree = voxels(c.mesh, .02, values);
      for(const auto normals : {Normals_of_items::GIVEN, Normals_of_items::OF_THE_VOXELS})
      {
        Items items = items_of(c.surface);
        BOOST_TEST(estimate(octree, items, c.radius, normals) == 0u);
        const double error = mean_error(c.surface, items);
        BOOST_TEST_MESSAGE("  " << c.surface.name << ": " << error);
        BOOST_TEST(error < (values == SC::Voxel_values::SHARES ? c.shares : c.binary));
      }
    }
}

// finer voxels, and a ball that shrinks more slowly
BOOST_AUTO_TEST_CASE(convergence)
{
  const Analytic_surface points = test_support::torus(1., .4, 16, 8),
                         mesh = test_support::torus(1., .4, 256, 128);
  for(const auto values : {SC::Voxel_values::SHARES, SC::Voxel_values::BINARY})
  {
    const auto error = [&](double size)
    {
      const double radius =
          values == SC::Voxel_values::SHARES ? 1.2 * std::sqrt(size) : .75 * std::cbrt(size);
      Items items = items_of(points);
      estimate(voxels(mesh, size, values), items, radius, Normals_of_items::OF_THE_VOXELS);
      return mean_error(points, items);
    };
    const double coarse = error(.06), fine = error(.015), order = std::log2(coarse / fine) / 2.;
    BOOST_TEST_MESSAGE("  error " << coarse << " -> " << fine << ", order " << order);
    BOOST_TEST(order > (values == SC::Voxel_values::SHARES ? .9 : .5)); // 1 and 2/3 in theory
  }
}

BOOST_AUTO_TEST_CASE(points_of_voxels)
{
  const SC::Voxel_octree octree = voxels(test_support::sphere(1., 5), .04, SC::Voxel_values::SHARES);
  const std::vector<Point_3> points = octree.surface_points();
  BOOST_TEST_REQUIRE(points.size() > 1000u);
  for(const Point_3& p : points)
    BOOST_TEST(std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.) < .02);
  Items items = items_at(points);
  BOOST_TEST(estimate(octree, items, .3, Normals_of_items::OF_THE_VOXELS) == 0u);
  double largest = 0.;
  for(const Item& item : items)
    test_support::raise_to(largest, std::abs(std::get<3>(item) - 1.));
  BOOST_TEST_MESSAGE("  largest error " << largest);
  BOOST_TEST(largest < .1);
  // the default radius is 6 voxels
  Items again = items;
  BOOST_TEST(
      SC::voxel_curvatures(
          octree, again,
          SC::parameters::point_map(Nth<0>()).principal_curvatures_and_directions_map(Nth<2>()).status_map(
              Nth<5>())) == 0u);
  estimate(octree, items, .24, Normals_of_items::OF_THE_VOXELS);
  BOOST_TEST(same_bits(items, again));
}

// A plane is flat at any height over the points, and in any direction of the axes.
BOOST_AUTO_TEST_CASE(planes_are_flat)
{
  const SC::Voxel_octree octree({20, 20, 20}, Point_3(0., 0., 0.), {.1, .1, .1},
                                [](std::size_t, std::size_t j, std::size_t) { return j < 10; });
  for(const double height : {0., .03, -.07, .15, -.2, .3, -.34})
  {
    Items items(1);
    std::get<0>(items[0]) = Point_3(1.02, 1. + height, .97);
    BOOST_TEST(estimate(octree, items, .6, Normals_of_items::OF_THE_VOXELS) == 0u);
    BOOST_TEST(std::abs(std::get<2>(items[0]).max_curvature) < 2e-3);
    BOOST_TEST(std::abs(std::get<2>(items[0]).min_curvature) < 2e-3);
    BOOST_TEST((std::get<5>(items[0]) == SC::Estimation_status::ESTIMATED));
  }
  for(const double height : {.42, -.5, .58}) // of a surface that is too far away, in a ball of radius .6
  {
    Items items(1);
    std::get<0>(items[0]) = Point_3(1.02, 1. + height, .97);
    BOOST_TEST(estimate(octree, items, .6, Normals_of_items::OF_THE_VOXELS) == 1u);
    BOOST_TEST((std::get<5>(items[0]) == SC::Estimation_status::DEGENERATE));
  }
  // a plate: one side of it behind the other one
  const SC::Voxel_octree plate({20, 20, 20}, Point_3(0., 0., 0.), {.1, .1, .1},
                               [](std::size_t, std::size_t j, std::size_t) { return j == 9 || j == 10; });
  for(const double y : {.9, 1.1})
  {
    Items items(1);
    std::get<0>(items[0]) = Point_3(1.02, y, .97);
    BOOST_TEST(estimate(plate, items, .6, Normals_of_items::OF_THE_VOXELS) == 1u);
    BOOST_TEST(estimate(plate, items, .15, Normals_of_items::OF_THE_VOXELS) == 0u);
    BOOST_TEST(std::abs(std::get<3>(items[0])) < 2e-2);
  }
  Items items(1);
  std::get<0>(items[0]) = Point_3(.3, 1., 1.); // the solid reaches the end of the grid
  estimate(octree, items, .6, Normals_of_items::OF_THE_VOXELS);
  BOOST_TEST((std::get<5>(items[0]) == SC::Estimation_status::BORDER));
}

// Normals that a point set has of its own are taken, as those of `normal_map`.
BOOST_AUTO_TEST_CASE(point_set_with_normals)
{
  const Analytic_surface s = test_support::torus(1., .4, 16, 8);
  const SC::Voxel_octree octree = voxels(test_support::torus(1., .4, 96, 48), .05, SC::Voxel_values::SHARES);
  Items items = items_of(s);
  CGAL::Point_set_3<Point_3> points(true);
  for(Item& item : items)
  {
    std::get<1>(item) = -std::get<1>(item); // not those that the voxels say
    points.insert(std::get<0>(item), std::get<1>(item));
  }
  const auto curvature = points.add_property_map<double>("curvature", 0.).first;
  for(const Normals_of_items normals : {Normals_of_items::GIVEN, Normals_of_items::OF_THE_VOXELS})
  {
    if(normals == Normals_of_items::OF_THE_VOXELS)
      points.remove_normal_map();
    estimate(octree, items, .3, normals);
    SC::voxel_curvatures<CGAL::Sequential_tag>(
        octree, points, SC::parameters::neighbor_radius(.3).mean_curvature_map(curvature));
    for(std::size_t i = 0; i < items.size(); ++i)
      BOOST_TEST(curvature[i] == std::get<3>(items[i]));
  }
}

// the same voxels in other units
BOOST_AUTO_TEST_CASE(scale)
{
  const auto ball = [](const std::size_t i, const std::size_t j, const std::size_t k)
  {
    const double x = double(i) - 11.5, y = double(j) - 11.5, z = double(k) - 11.5;
    return x * x + y * y + z * z < 81.;
  };
  const auto curvatures = [&](const double unit)
  {
    const SC::Voxel_octree octree({24, 24, 24}, Point_3(3. * unit, 0., 0.), {.1 * unit, .1 * unit, .1 * unit},
                                  ball);
    Items items = items_at(octree.surface_points());
    BOOST_TEST(estimate(octree, items, .5 * unit, Normals_of_items::OF_THE_VOXELS) == 0u);
    return items;
  };
  const Items expected = curvatures(1.);
  BOOST_TEST(expected.size() > 100u);
  for(const double unit : {1e-6, 1e6})
  {
    const Items items = curvatures(unit);
    BOOST_TEST_REQUIRE(items.size() == expected.size());
    for(std::size_t i = 0; i < items.size(); ++i)
    {
      BOOST_TEST(std::abs(unit * std::get<3>(items[i]) - std::get<3>(expected[i])) < 1e-9);
      BOOST_TEST(std::abs(unit * unit * std::get<4>(items[i]) - std::get<4>(expected[i])) < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(invariances_and_threads)
{
  const Analytic_surface s = test_support::torus(1., .4, 32, 16), mesh = test_support::torus(1., .4, 96, 48);
  const SC::Voxel_octree octree = voxels(mesh, .05, SC::Voxel_values::SHARES);
  Items items = items_of(s);
  estimate(octree, items, .3, Normals_of_items::GIVEN);

  Items inward = items_of(s);
  for(Item& item : inward)
    std::get<1>(item) = -3. * std::get<1>(item);
  estimate(octree, inward, .3, Normals_of_items::GIVEN);
  for(std::size_t i = 0; i < items.size(); ++i)
    BOOST_TEST(std::abs(std::get<2>(items[i]).max_curvature + std::get<2>(inward[i]).min_curvature) < 1e-12);

  for(const double scale : {1e-6, 1e6})
  {
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    const Analytic_surface t = transformed(s, scale, identity, Eigen::Vector3d::Zero());
    Items scaled = items_of(t);
    const SC::Voxel_octree other = voxels(transformed(mesh, scale, identity, Eigen::Vector3d::Zero()),
                                          .05 * scale, SC::Voxel_values::SHARES);
    estimate(other, scaled, .3 * scale, Normals_of_items::GIVEN);
    for(std::size_t i = 0; i < items.size(); ++i)
      BOOST_TEST(std::abs(std::get<2>(items[i]).max_curvature -
                          scale * std::get<2>(scaled[i]).max_curvature) < 1e-4);
  }
#ifdef CGAL_LINKED_WITH_TBB
  for(const std::size_t threads : {1, 2, 4})
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Items parallel = items_of(s);
    estimate<CGAL::Parallel_tag>(octree, parallel, .3, Normals_of_items::GIVEN);
    BOOST_TEST(same_bits(items, parallel));
  }
#endif
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  const SC::Voxel_octree octree = voxels(test_support::sphere(1., 3), .1, SC::Voxel_values::SHARES);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Items items(5);
  for(Item& item : items)
    item = {
        Point_3(1., 0., 0.), Vector_3(1., 0., 0.), Curvatures(), 0., 0., SC::Estimation_status::CANCELLED};
  std::get<0>(items[1]) = Point_3(nan, 0., 0.);
  std::get<0>(items[2]) = Point_3(9., 0., 0.); // nothing there
  std::get<1>(items[3]) = Vector_3(0., 0., 0.);
  std::get<1>(items[4]) = Vector_3(0., 1., 0.); // tangential
  BOOST_TEST(estimate(octree, items, .4, Normals_of_items::GIVEN) == 4u);
  using S = SC::Estimation_status;
  const std::array<S, 5> expected = {S::ESTIMATED, S::NON_FINITE_INPUT, S::DEGENERATE, S::NON_FINITE_INPUT,
                                     S::DEGENERATE};
  for(std::size_t i = 0; i < 5; ++i)
  {
    BOOST_TEST((std::get<5>(items[i]) == expected[i]));
    BOOST_TEST(std::isnan(std::get<3>(items[i])) == (i > 0));
  }
  Items none;
  BOOST_TEST(estimate(octree, none, .4, Normals_of_items::GIVEN) == 0u);
  for(const double radius : {0., -1., nan})
    BOOST_CHECK_THROW(estimate(octree, items, radius, Normals_of_items::GIVEN), std::invalid_argument);

  const auto full = [](std::size_t, std::size_t, std::size_t) { return 1.; };
  using Octree = SC::Voxel_octree;
  const Point_3 o(0., 0., 0.);
  BOOST_CHECK_THROW(Octree({2, 2, 2}, o, {1., 0., 1.}, full), std::invalid_argument);
  BOOST_CHECK_THROW(Octree({2, 2, 2}, Point_3(nan, 0., 0.), {1., 1., 1.}, full), std::invalid_argument);
  BOOST_CHECK_THROW(Octree({2000000, 1, 1}, o, {1., 1., 1.}, full), std::invalid_argument);
  for(const double value : {-.1, 1.1, nan})
    BOOST_CHECK_THROW(Octree({2, 2, 2}, o, {1., 1., 1.},
                             [=](std::size_t i, std::size_t, std::size_t) { return i == 1 ? value : 0.; }),
                      std::invalid_argument);
  BOOST_CHECK_THROW(octree.volume_in_ball(o, 0.), std::invalid_argument);
  const Octree cube({3, 3, 3}, o, {1., 1., 1.}, full), nothing({0, 0, 0}, o, {1., 1., 1.}, full);
  BOOST_TEST(cube.surface_points().size() == 54u);
  BOOST_TEST(std::abs(cube.volume_in_ball(o, 10.) - 27.) < 1e-12);
  BOOST_TEST(std::abs(cube.volume_in_ball(o, 1e200) - 27.) < 1e-12);
  BOOST_TEST(cube.volume_in_ball(o, 1e-200) == 0.); // what is left of 1e-600
  BOOST_TEST(nothing.volume_in_ball(o, 10.) == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
