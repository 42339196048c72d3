#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/screen_space/Camera.h>
#include <Shape_characteristics/screen_space/G_buffer.h>
#include <Shape_characteristics/screen_space/Griffin_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/Hattori_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/Two_part_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/ambient_occlusion.h>
#include <Shape_characteristics/screen_space/mean_curvature_extreme.h>
#include <Shape_characteristics/screen_space/ray_cast_ambient_occlusion.h>
#include <Shape_characteristics/screen_space/screen_space_curvatures.h>

#include "build_face_graph.h"
#include "raise_to.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/number_type_config.h>
#include <CGAL/property_map.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(ambient_occlusion)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

const double quiet_nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

Curvatures curvatures(double k_min, double k_max)
{
  Curvatures result;
  result.min_curvature = k_min;
  result.max_curvature = k_max;
  return result;
}

// another library's type with the same members
struct Foreign
{
  float min_curvature, max_curvature;
};

} // namespace

BOOST_AUTO_TEST_CASE(two_parts_by_the_formula_of_the_thesis)
{
  const SC::Two_part_ambient_occlusion light(2.);
  BOOST_TEST(light(curvatures(0, 0)) == 0.9);
  BOOST_TEST(light(curvatures(-1, 1)) == 0.9);                                          // a saddle
  BOOST_TEST(std::abs(light(curvatures(2, 2)) - 1) < 1e-15);                            // the brightest bump
  BOOST_TEST(std::abs(light(curvatures(0, 2)) - 0.95) < 1e-15);                         // half of it
  BOOST_TEST(std::abs(light(curvatures(-2, -2)) - 0.9 * std::exp(-2.5)) < 1e-15);       // the darkest hollow
  BOOST_TEST(std::abs(light(curvatures(-2, 0)) - 0.9 * std::exp(-0.25 / 0.4)) < 1e-15); // half of it
  BOOST_TEST(light(curvatures(5, 7)) == light(curvatures(2, 2)));                       // beyond the extreme
  BOOST_TEST(light(curvatures(-infinity, -3)) == light(curvatures(-2, -2)));
  BOOST_TEST(light(Foreign{0.f, 2.f}) == light(curvatures(0, 2)));
}

BOOST_AUTO_TEST_CASE(two_parts_grow_and_join)
{
  const SC::Two_part_ambient_occlusion light(1., 0.7, 0.1);
  double before = -1;
  for(int i = -1000; i <= 1000; ++i)
  {
    const double value = light(curvatures(i / 1000., i / 1000.));
    BOOST_TEST(value > before);
    BOOST_TEST((i == -1000 || value - before < 0.007)); // no step
    before = value;
  }
  BOOST_TEST(before == 1);
}

// the mean over all directions of the squared sine under which the quadric leaves the sphere, by quadrature
BOOST_AUTO_TEST_CASE(Hattori_is_the_quadric_in_a_sphere)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> curvature(-2, 2), size(0.1, 0.6);
  for(int trial = 0; trial < 100; ++trial)
  {
    const double k1 = curvature(random), k2 = curvature(random), r = size(random);
    double hidden = 0;
    const int steps = 64; // exact for a trigonometric polynomial of degree 4
    for(int i = 0; i < steps; ++i)
    {
      const double angle = 2 * CGAL_PI * i / steps, c = std::cos(angle), s = std::sin(angle);
      const double sine = r * (k1 * c * c + k2 * s * s) / 2;
      hidden += sine * sine / steps;
    }
    const SC::Hattori_ambient_occlusion light(r);
    BOOST_TEST(std::abs(light(curvatures(k1, k2)) - (1 - hidden)) < 1e-14);
    BOOST_TEST(light(curvatures(-k1, -k2)) == light(curvatures(k1, k2))); // no sign
  }
  BOOST_TEST(SC::Hattori_ambient_occlusion(1.)(curvatures(0, 0)) == 1);
  BOOST_TEST(SC::Hattori_ambient_occlusion(1.)(curvatures(-100, 100)) == 0);
}

BOOST_AUTO_TEST_CASE(Griffin_is_a_polynomial)
{
  const SC::Griffin_ambient_occlusion light(5.);
  BOOST_TEST(light(curvatures(0, 0)) == 0.7369);
  BOOST_TEST(std::abs(light(curvatures(0.1, 0.2)) - (0.7369 + 0.0776 * 1.5 - 0.0022 * 1.25)) < 1e-15);
  BOOST_TEST(std::abs(light(curvatures(-0.3, 0.1)) - (0.7369 - 0.0776 - 0.0022 * 2.5)) < 1e-15);
  BOOST_TEST(light(curvatures(2, 2)) == 1);
  BOOST_TEST(light(curvatures(-9, -9)) == 0);
}

BOOST_AUTO_TEST_CASE(every_mapping_stays_within_bounds_and_passes_nan_on)
{
  const auto check = [](const auto& light)
  {
    for(const double a : {-infinity, -1e300, -3., -0., 1e-300, 4., 1e300, infinity})
      for(const double b : {-infinity, -1e300, -3., -0., 1e-300, 4., 1e300, infinity})
        if(!(std::isinf(a) && a == -b)) // their mean is not defined
        {
          const double value = light(curvatures(a, b));
          BOOST_TEST(value >= 0);
          BOOST_TEST(value <= 1);
        }
    for(const double other : {0., infinity, quiet_nan})
    {
      BOOST_TEST(std::isnan(light(curvatures(quiet_nan, other))));
      BOOST_TEST(std::isnan(light(curvatures(other, quiet_nan))));
    }
  };
  check(SC::Two_part_ambient_occlusion(1.));
  check(SC::Hattori_ambient_occlusion(1.));
  check(SC::Griffin_ambient_occlusion(1.));
}

// a surface of another size with parameters in its unit looks the same
BOOST_AUTO_TEST_CASE(mappings_do_not_depend_on_the_unit)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> curvature(-2, 2);
  for(const double unit : {0x1p-20, 0x1p20})
    for(int trial = 0; trial < 50; ++trial)
    {
      const double a = curvature(random), b = curvature(random);
      const Curvatures c = curvatures(a, b), scaled = curvatures(a / unit, b / unit);
      BOOST_TEST(SC::Two_part_ambient_occlusion(3. / unit)(scaled) == SC::Two_part_ambient_occlusion(3.)(c));
      BOOST_TEST(SC::Hattori_ambient_occlusion(.25 * unit)(scaled) == SC::Hattori_ambient_occlusion(.25)(c));
      BOOST_TEST(SC::Griffin_ambient_occlusion(5. * unit)(scaled) == SC::Griffin_ambient_occlusion(5.)(c));
    }
}

BOOST_AUTO_TEST_CASE(wrong_arguments)
{
  for(const double wrong : {0., -1., infinity, quiet_nan})
  {
    BOOST_CHECK_THROW(SC::Two_part_ambient_occlusion{wrong}, std::invalid_argument);
    BOOST_CHECK_THROW(SC::Two_part_ambient_occlusion(1., 0.9, wrong), std::invalid_argument);
    BOOST_CHECK_THROW(SC::Hattori_ambient_occlusion{wrong}, std::invalid_argument);
    BOOST_CHECK_THROW(SC::Griffin_ambient_occlusion{wrong}, std::invalid_argument);
  }
  for(const double wrong : {-0.1, 1.1, quiet_nan})
    BOOST_CHECK_THROW(SC::Two_part_ambient_occlusion(1., wrong), std::invalid_argument);
  BOOST_CHECK_THROW(SC::Two_part_ambient_occlusion(1., .9, .2, infinity), std::invalid_argument);
  BOOST_CHECK_THROW(SC::Griffin_ambient_occlusion(1., quiet_nan), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(extreme_of_a_picture)
{
  std::vector<float> picture(1010, std::numeric_limits<float>::quiet_NaN()); // nine without an estimate
  for(int i = 0; i <= 1000; ++i)
    picture[std::size_t(i)] = i % 2 ? float(i) : -float(i);
  picture[1005] = std::numeric_limits<float>::infinity();
  BOOST_TEST(SC::mean_curvature_extreme(picture) == 999);
  BOOST_TEST(SC::mean_curvature_extreme(picture, 1.) == 1000);
  BOOST_TEST(SC::mean_curvature_extreme(picture, 0.) == 0);
  BOOST_TEST(SC::mean_curvature_extreme(std::vector<double>(3, quiet_nan)) == 0);
  BOOST_TEST(SC::mean_curvature_extreme(std::vector<double>()) == 0);
  for(const double wrong : {-0.1, 1.1, quiet_nan})
    BOOST_CHECK_THROW(SC::mean_curvature_extreme(picture, wrong), std::invalid_argument);
}

namespace {

auto into(std::vector<float>& light)
{
  return SC::parameters::ambient_occlusion_map(CGAL::make_property_map(light));
}

// what a camera sees: arrays and the G-buffer that wraps them
struct Picture
{
  int width, height;
  SC::Camera camera;
  std::vector<float> depths, normals;

  Picture(int w, int h, const SC::Camera& c)
    : width(w),
      height(h),
      camera(c),
      depths(std::size_t(w * h), 0.f),
      normals(std::size_t(3 * w * h), 0.f)
  {}

  void set(int x, int y, double depth, const Eigen::Vector3d& normal)
  {
    const std::size_t i = std::size_t(y * width + x);
    depths[i] = float(depth);
    for(int k = 0; k < 3; ++k)
      normals[3 * i + std::size_t(k)] = float(normal[k]);
  }

  SC::G_buffer g_buffer() const { return {width, height, depths.data(), normals.data(), camera}; }
};

// from above, parallel: the square [-1, 1]^2 on the plane z = 0, whose points have all the depth 10
Picture plane_from_above(double unit = 1)
{
  const SC::Camera camera(SC::Camera::look_at({0, 0, 10 * unit}, {0, 0, 0}, {0, 1, 0}),
                          SC::Camera::orthographic(2 * unit, 1, unit, 20 * unit),
                          SC::Depth_convention::EYE_DISTANCE);
  Picture picture(16, 16, camera);
  for(int y = 0; y < 16; ++y)
    for(int x = 0; x < 16; ++x)
      picture.set(x, y, 10 * unit, {0, 0, 1});
  return picture;
}

// a floor, and a wall that stands on it along x = 1
Mesh floor_and_wall(double height, double unit = 1)
{
  const double far = 1e4;
  std::vector<std::array<double, 3>> points = {{-far, -far, 0}, {1, -far, 0},      {1, far, 0},
                                               {-far, far, 0},  {1, -far, height}, {1, far, height}};
  for(auto& p : points)
    for(double& x : p)
      x *= unit;
  // the wall doesn't share the floor's vertices
  points.push_back(points[1]);
  points.push_back(points[2]);
  const std::vector<std::vector<std::size_t>> faces = {{0, 1, 2, 3}, {6, 4, 5, 7}};
  return benchmark_support::build_face_graph<Mesh>(points, faces);
}

Mesh ball(double radius, int subdivisions)
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Kernel::Point_3>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(subdivisions));
  for(const auto v : mesh.vertices())
  {
    const auto p = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + radius / std::sqrt(p.squared_length()) * p;
  }
  return mesh;
}

} // namespace

// an endless wall of height h at the distance d hides the share (1 - d / sqrt(d^2 + h^2)) / 2
BOOST_AUTO_TEST_CASE(rays_beside_a_wall)
{
  const Picture picture = plane_from_above();
  const SC::G_buffer g_buffer = picture.g_buffer();
  for(const double height : {0.5, 2.})
  {
    const Mesh mesh = floor_and_wall(height);
    std::vector<float> light(g_buffer.size());
    BOOST_TEST(SC::ray_cast_ambient_occlusion(mesh, g_buffer, into(light).number_of_rays(1000)) == 0u);
    double largest = 0;
    for(std::size_t i = 0; i < light.size(); ++i)
    {
      const double d = 1 - (-1 + (double(i % 16) + .5) / 8);
      const double expected = 1 - (1 - d / std::hypot(d, height)) / 2;
      test_support::raise_to(largest, std::abs(light[i] - expected));
    }
    BOOST_TEST_MESSAGE("largest error beside a wall: " << largest);
    BOOST_TEST(largest < 0.01);
  }
}

// within a ball of radius R, rays of the length l at the most leave unhindered where 2 R cos(angle) > l: the share 1 - (l / 2R)^2
BOOST_AUTO_TEST_CASE(rays_within_a_ball)
{
  const double radius = 2;
  const Mesh mesh = ball(radius, 5);
  const SC::Camera camera(Eigen::Matrix4d::Identity(), SC::Camera::perspective(1., 1., .1, 10.),
                          SC::Depth_convention::EYE_DISTANCE);
  Picture picture(8, 8, camera);
  for(int y = 0; y < 8; ++y)
    for(int x = 0; x < 8; ++x)
    {
      const Eigen::Vector3d direction = camera.view_point(x + .5, y + .5, 1., 8, 8).normalized();
      picture.set(x, y, -radius * direction.z(), -direction);
    }
  const SC::G_buffer g_buffer = picture.g_buffer();
  std::vector<float> light(g_buffer.size());
  for(const double length : {0.5, 2., 3.5})
  {
    BOOST_TEST(SC::ray_cast_ambient_occlusion(
                   mesh, g_buffer, into(light).number_of_rays(1000).maximum_ray_length(length)) == 0u);
    const double expected = 1 - length * length / (4 * radius * radius);
    for(const float value : light)
      BOOST_TEST(std::abs(double(value) - expected) < 0.01);
  }
  SC::ray_cast_ambient_occlusion(mesh, g_buffer, into(light));
  for(const float value : light)
    BOOST_TEST(value == 0);
}

// the faces of a coarse ball aren't in each other's way, and interpolated normals don't put them there
BOOST_AUTO_TEST_CASE(rays_from_a_coarse_ball_meet_nothing)
{
  const Mesh mesh = ball(1, 1);
  const SC::Camera camera(SC::Camera::look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}),
                          SC::Camera::orthographic(1.2, 1, 1, 20), SC::Depth_convention::EYE_DISTANCE);
  Picture picture(16, 16, camera);
  for(int y = 0; y < 16; ++y)
    for(int x = 0; x < 16; ++x)
    {
      const Eigen::Vector3d p = camera.world_point(camera.view_point(x + .5, y + .5, 5., 16, 16));
      const double z = std::sqrt(std::max(0., 1 - p.x() * p.x() - p.y() * p.y()));
      picture.set(x, y, 5 - z * .98, {p.x(), p.y(), z});
    }
  const SC::G_buffer g_buffer = picture.g_buffer();
  std::vector<float> light(g_buffer.size());
  SC::ray_cast_ambient_occlusion(mesh, g_buffer, into(light));
  std::size_t found = 0;
  for(const double value : light)
    if(!std::isnan(value))
    {
      BOOST_TEST(value == 1);
      ++found;
    }
  BOOST_TEST(found > light.size() / 4);
}

BOOST_AUTO_TEST_CASE(rays_do_not_depend_on_threads_or_unit)
{
  std::vector<float> in_turn(256), parallel(256), scaled(256);
  const SC::G_buffer none;
  const Picture picture = plane_from_above();
  SC::ray_cast_ambient_occlusion<CGAL::Sequential_tag>(floor_and_wall(1), picture.g_buffer(), into(in_turn));
  SC::ray_cast_ambient_occlusion(floor_and_wall(1), picture.g_buffer(), into(parallel));
  BOOST_TEST(in_turn == parallel, boost::test_tools::per_element());
  for(const double unit : {0x1p-20, 0x1p20})
  {
    const Picture of_unit = plane_from_above(unit);
    SC::ray_cast_ambient_occlusion(floor_and_wall(1, unit), of_unit.g_buffer(), into(scaled));
    BOOST_TEST(in_turn == scaled, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(rays_and_bad_inputs)
{
  const Mesh mesh = floor_and_wall(1);
  Picture picture = plane_from_above();
  picture.set(0, 0, infinity, {0, 0, 1});   // the background
  picture.set(1, 0, quiet_nan, {0, 0, 1});  // no depth
  picture.set(2, 0, 10, {quiet_nan, 0, 1}); // no normal
  picture.set(3, 0, 10, {0, 0, 0});         // the same
  picture.set(4, 0, 10 + 5e3, {0, 0, 1});   // not of this mesh
  const SC::G_buffer g_buffer = picture.g_buffer();
  std::vector<float> light(g_buffer.size());
  BOOST_TEST(SC::ray_cast_ambient_occlusion(mesh, g_buffer, into(light)) == 1u);
  for(std::size_t i = 0; i < light.size(); ++i)
    BOOST_TEST(std::isnan(light[i]) == (i < 5));

  // rays of any length end somewhere
  std::vector<float> far(light.size());
  SC::ray_cast_ambient_occlusion(mesh, g_buffer, into(far).maximum_ray_length(infinity));
  for(const double length : {1e10, 1e200, std::numeric_limits<double>::max()})
  {
    SC::ray_cast_ambient_occlusion(mesh, g_buffer, into(light).maximum_ray_length(length));
    for(std::size_t i = 5; i < light.size(); ++i)
      BOOST_TEST(light[i] == far[i]);
  }

  // no pixels, no mesh, one without an area
  std::vector<float> no_light;
  BOOST_TEST(SC::ray_cast_ambient_occlusion(mesh, SC::G_buffer(), into(no_light)) == 0u);
  BOOST_TEST(SC::ray_cast_ambient_occlusion(Mesh(), g_buffer, into(light)) == 252u);
  Mesh needle;
  needle.add_face(needle.add_vertex({0, 0, 0}), needle.add_vertex({1, 0, 0}), needle.add_vertex({2, 0, 0}));
  BOOST_TEST(SC::ray_cast_ambient_occlusion(needle, g_buffer, into(light)) == 252u);
  // what isn't finite is left out
  Mesh broken = mesh;
  broken.add_face(broken.add_vertex({0, 0, quiet_nan}), broken.add_vertex({1, 0, 0}),
                  broken.add_vertex({0, 1, infinity}));
  std::vector<float> same(light.size());
  BOOST_TEST(SC::ray_cast_ambient_occlusion(broken, g_buffer, into(same)) == 1u);
  SC::ray_cast_ambient_occlusion(mesh, g_buffer, into(light));
  for(std::size_t i = 5; i < light.size(); ++i)
    BOOST_TEST(same[i] == light[i]);

  BOOST_CHECK_THROW(SC::ray_cast_ambient_occlusion(mesh, g_buffer, into(light).number_of_rays(0)),
                    std::invalid_argument);
  for(const double wrong : {0., -1., quiet_nan})
    BOOST_CHECK_THROW(SC::ray_cast_ambient_occlusion(mesh, g_buffer, into(light).maximum_ray_length(wrong)),
                      std::invalid_argument);

  // a callback that stops
  BOOST_TEST(SC::ray_cast_ambient_occlusion<CGAL::Sequential_tag>(
                 mesh, g_buffer, into(light).callback([](double) { return false; })) > 100u);
}

// the function is what its parts are, one after the other
BOOST_AUTO_TEST_CASE(light_from_curvature_of_a_picture)
{
  const SC::Camera camera(SC::Camera::look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}),
                          SC::Camera::perspective(.5, 1, 1, 20), SC::Depth_convention::EYE_DISTANCE);
  Picture picture(48, 40, camera); // a wavy surface
  for(int y = 0; y < 40; ++y)
    for(int x = 0; x < 44; ++x)
      picture.set(x, y, 5 + .1 * std::sin(.3 * x) * std::cos(.2 * y),
                  {.6 * std::cos(.3 * x), .4 * std::sin(.2 * y), 1.});
  const SC::G_buffer g_buffer = picture.g_buffer();
  std::vector<float> k_min(g_buffer.size()), k_max(k_min), light(k_min), in_turn(k_min), mean(k_min);
  SC::screen_space_curvatures(g_buffer, SC::parameters::min_curvature_map(CGAL::make_property_map(k_min))
                                            .max_curvature_map(CGAL::make_property_map(k_max))
                                            .mean_curvature_map(CGAL::make_property_map(mean))
                                            .number_of_triangles(2));
  const auto check = [&](const auto& mapping)
  {
    for(std::size_t i = 0; i < light.size(); ++i)
      if(i % 48 >= 44)
        BOOST_TEST(std::isnan(light[i]));
      else
        BOOST_TEST(light[i] == float(mapping(Foreign{k_min[i], k_max[i]})));
    BOOST_TEST(std::equal(light.begin(), light.end(), in_turn.begin(),
                          [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
  };
  const SC::Hattori_ambient_occlusion Hattori(.4);
  BOOST_TEST(SC::ambient_occlusion(
                 g_buffer, into(light).number_of_triangles(2).ambient_occlusion_mapping(Hattori)) == 0u);
  std::vector<SC::Estimation_status> statuses(light.size(), SC::Estimation_status::CANCELLED);
  SC::ambient_occlusion<CGAL::Sequential_tag>(
      g_buffer, into(in_turn).number_of_triangles(2).ambient_occlusion_mapping(Hattori).status_map(
                    CGAL::make_property_map(statuses)));
  for(std::size_t i = 0; i < light.size(); ++i)
    BOOST_TEST(
        (i % 48 >= 44 ? statuses[i] == SC::Estimation_status::UNREFERENCED : SC::is_estimated(statuses[i])));
  check(Hattori);
  SC::ambient_occlusion(g_buffer, into(light).number_of_triangles(2));
  SC::ambient_occlusion<CGAL::Sequential_tag>(g_buffer, into(in_turn).number_of_triangles(2));
  check(SC::Two_part_ambient_occlusion(SC::mean_curvature_extreme(mean)));

  // a plane is flat, and nothing has no light
  const Picture plane = plane_from_above();
  std::vector<float> flat(256), nothing;
  SC::ambient_occlusion(plane.g_buffer(), into(flat));
  for(const float value : flat)
    BOOST_TEST(value == 0.9f);
  BOOST_TEST(SC::ambient_occlusion(SC::G_buffer(), into(nothing)) == 0u);
  BOOST_TEST(SC::ambient_occlusion(plane.g_buffer()) == 0u);
  BOOST_CHECK_THROW(SC::ambient_occlusion(plane.g_buffer(), into(flat).number_of_triangles(5)),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
