// Planes of symmetry of shapes that have one, several or none by construction.
#include <Shape_characteristics/head_features/detect_symmetry_plane.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include "analytic_surfaces.h"
#include "build_mesh.h"
#include "check_names.h"
#include "oriented_point_maps.h"

#include "../../benchmark/support/Random.h"

#include <boost/test/unit_test.hpp>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(symmetry_plane)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Detection = SC::Symmetry_detection<Kernel>;
using benchmark_support::Random;
using SC::Symmetry_verdict;

namespace {

struct Shape
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::size_t, 3> > triangles;
};

// A ball with bumps and dents: four pairs of them, which x = 0 mirrors, and two on it; or ten anywhere.
Shape potato(const bool symmetric, const unsigned int subdivisions = 4)
{
  std::vector<std::pair<Eigen::Vector3d, double> > bumps;
  Random random(7);
  const auto direction = [&]
  {
    const double x = random.gaussian(), y = random.gaussian(), z = random.gaussian();
    return Eigen::Vector3d(x, y, z).normalized();
  };
  for(int k = 0; k < (symmetric ? 6 : 10); ++k)
  {
    Eigen::Vector3d d = direction();
    const double height = k % 3 == 2 ? -.3 : .6;
    if(symmetric && k > 3)
      d = Eigen::Vector3d(0., d.y(), d.z()).normalized();
    bumps.push_back({d, height});
    if(symmetric && k <= 3)
      bumps.push_back({Eigen::Vector3d(-d.x(), d.y(), d.z()), height});
  }
  Shape shape;
  const auto ball = test_support::sphere(1., subdivisions);
  for(const auto& p : ball.points)
  {
    const Eigen::Vector3d d = Eigen::Vector3d(p[0], p[1], p[2]).normalized();
    double r = 1.;
    for(const auto& [middle, height] : bumps)
      r += height * std::exp(-(d - middle).squaredNorm() / .16);
    shape.points.push_back(r * d);
  }
  for(const auto& t : ball.triangles)
    shape.triangles.push_back({std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])});
  return shape;
}

Mesh mesh_of(const Shape& shape)
{
  Mesh mesh;
  for(const auto& p : shape.points)
    mesh.add_vertex(Point(p[0], p[1], p[2]));
  for(const auto& t : shape.triangles)
    mesh.add_face(Mesh::Vertex_index(std::uint32_t(t[0])), Mesh::Vertex_index(std::uint32_t(t[1])),
                  Mesh::Vertex_index(std::uint32_t(t[2])));
  return mesh;
}

const Eigen::Affine3d motion =
    Eigen::Translation3d(3., -2., 5.) * Eigen::AngleAxisd(2.2, Eigen::Vector3d(1., 2., -2.).normalized());

Shape moved(Shape shape, const Eigen::Affine3d& by = motion)
{
  for(auto& p : shape.points)
    p = by * p;
  return shape;
}

// in degrees, between the plane's normal and the image of the x-axis
double angle(const Detection& found, const Eigen::Affine3d& by = motion)
{
  const auto n = found.best.plane.orthogonal_vector();
  const Eigen::Vector3d a = Eigen::Vector3d(n.x(), n.y(), n.z()).normalized(),
                        b = by.linear().col(0).normalized();
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * 180. / CGAL_PI;
}

// of the image of the origin from the plane
double distance(const Detection& found, const Eigen::Affine3d& by = motion)
{
  const Eigen::Vector3d o = by.translation();
  return std::sqrt(CGAL::squared_distance(found.best.plane, Point(o[0], o[1], o[2])));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_plane_of_a_symmetric_shape)
{
  const Detection found = SC::detect_symmetry_plane(mesh_of(moved(potato(true))));
  BOOST_TEST(int(found.verdict) == int(Symmetry_verdict::ONE));
  BOOST_TEST(found.confidence > .8);
  BOOST_TEST(found.best.support > .95);
  BOOST_TEST(found.best.deviation < .01);
  BOOST_TEST(angle(found) < .2);
  BOOST_TEST(distance(found) < .004);
}

BOOST_AUTO_TEST_CASE(no_plane_of_an_asymmetric_shape)
{
  const Detection found = SC::detect_symmetry_plane(mesh_of(moved(potato(false))));
  BOOST_TEST(int(found.verdict) == int(Symmetry_verdict::NONE));
  BOOST_TEST(found.confidence == 0.);
}

BOOST_AUTO_TEST_CASE(units_and_places_do_not_matter)
{
  for(const double scale : {1e-6, 1e6})
  {
    const Eigen::Affine3d by = Eigen::Translation3d(Eigen::Vector3d(1e4, -1e4, 1e4) * scale) *
                               motion.linear() * Eigen::Scaling(scale);
    const Detection found = SC::detect_symmetry_plane(mesh_of(moved(potato(true), by)));
    BOOST_TEST(int(found.verdict) == int(Symmetry_verdict::ONE));
    BOOST_TEST(angle(found, by) < .2);
    BOOST_TEST(distance(found, by) < .004 * scale);
    BOOST_TEST(found.best.deviation < .01 * scale);
  }
}

BOOST_AUTO_TEST_CASE(noise_and_missing_parts)
{
  Shape shape = potato(true);
  Random random(3);
  for(auto& p : shape.points)
    for(int k = 0; k < 3; ++k)
      p[k] += .01 * random.gaussian();
  // a fifth of one side is missing
  std::vector<std::array<std::size_t, 3> > kept;
  for(const auto& t : shape.triangles)
    if(const Eigen::Vector3d& p = shape.points[t[0]]; !(p.x() > .3 && p.y() > .2))
      kept.push_back(t);
  BOOST_TEST(kept.size() < shape.triangles.size() * 9 / 10);
  shape.triangles = kept;
  const Detection found = SC::detect_symmetry_plane(mesh_of(moved(shape)));
  BOOST_TEST(int(found.verdict) == int(Symmetry_verdict::ONE));
  BOOST_TEST(angle(found) < 1.);
  BOOST_TEST(distance(found) < .02);
}

BOOST_AUTO_TEST_CASE(several_planes)
{
  const Detection of_sphere = SC::detect_symmetry_plane(mesh_of(
      []
      {
        Shape shape = potato(true);
        for(auto& p : shape.points)
          p.normalize();
        return moved(shape);
      }()));
  BOOST_TEST(int(of_sphere.verdict) == int(Symmetry_verdict::SEVERAL));
  BOOST_TEST(of_sphere.best.support > .95);
  BOOST_TEST(of_sphere.confidence < .4);

  Shape cube;
  for(int i = 0; i < 8; ++i)
    cube.points.push_back(Eigen::Vector3d(i & 1, (i >> 1) & 1, i >> 2) - Eigen::Vector3d::Constant(.5));
  cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const Detection of_cube = SC::detect_symmetry_plane(mesh_of(moved(cube)));
  BOOST_TEST(int(of_cube.verdict) == int(Symmetry_verdict::SEVERAL));
  BOOST_TEST(of_cube.best.support > .9);
  BOOST_TEST(of_cube.alternatives.size() >= 2u);
}

BOOST_AUTO_TEST_CASE(a_point_set)
{
  const Mesh mesh = mesh_of(moved(potato(true)));
  const SC::Face_graph_samples samples = SC::sampled_surface(mesh, SC::Neighborhood::rings(1));
  std::vector<test_support::Oriented_point> points;
  for(std::size_t i = 0; i < samples.size(); ++i)
  {
    const Eigen::Vector3d &p = samples.point(i), &n = samples.normal(i);
    points.emplace_back(Point(p[0], p[1], p[2]), Kernel::Vector_3(n[0], n[1], n[2]));
  }
  const auto np = test_support::oriented_point_maps();
  const Detection found = SC::detect_symmetry_plane(points, np);
  BOOST_TEST(int(found.verdict) == int(Symmetry_verdict::ONE));
  BOOST_TEST(angle(found) < .3);
  points.resize(20);
  BOOST_TEST(int(SC::detect_symmetry_plane(points, np).verdict) == int(Symmetry_verdict::NONE));
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  BOOST_TEST(int(SC::detect_symmetry_plane(Mesh()).verdict) == int(Symmetry_verdict::NONE));
  Shape triangle;
  triangle.points.assign(3, Eigen::Vector3d::Zero());
  triangle.triangles = {{0, 1, 2}};
  BOOST_TEST(int(SC::detect_symmetry_plane(mesh_of(triangle)).verdict) == int(Symmetry_verdict::NONE));

  Shape spoilt = potato(true);
  spoilt.points[5][1] = std::numeric_limits<double>::quiet_NaN();
  spoilt.points[50][2] = std::numeric_limits<double>::infinity();
  const Detection found = SC::detect_symmetry_plane(mesh_of(moved(spoilt)));
  BOOST_TEST(int(found.verdict) == int(Symmetry_verdict::ONE));
  BOOST_TEST(angle(found) < .3);

  Mesh quad;
  const auto a = quad.add_vertex(Point(0, 0, 0)), b = quad.add_vertex(Point(1, 0, 0)),
             c = quad.add_vertex(Point(1, 1, 0)), d = quad.add_vertex(Point(0, 1, 0));
  quad.add_face(a, b, c, d);
  BOOST_CHECK_THROW(SC::detect_symmetry_plane(quad), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(every_verdict_has_its_name)
{
  test_support::check_names<Symmetry_verdict>({"NONE", "ONE", "SEVERAL"});
}

BOOST_AUTO_TEST_SUITE_END()
