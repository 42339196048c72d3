#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/screen_space/internal/Screen_frame.h>
#include <Shape_characteristics/screen_space/screen_space_curvatures.h>
#include <Shape_characteristics/screen_space/sphere_fit_mean_curvatures.h>

#include "analytic_scenes.h"
#include "plain_algebra.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(screen_space_curvatures)

namespace SC = Shape_characteristics;
namespace sp = SC::parameters;
using SC::Camera;
using SC::G_buffer;
using SC::Level_of_detail;
using test_support::camera_at;
using test_support::Cylinder;
using test_support::map_of;
using test_support::Picture;
using test_support::Plane;
using test_support::quantile;
using test_support::Sphere;
using test_support::Torus;
using Convention = SC::Depth_convention;
using Rule = SC::Depth_discontinuity_rule;
using Status = SC::Estimation_status;

namespace {

const float no_number = std::numeric_limits<float>::quiet_NaN();
const float unlimited = std::numeric_limits<float>::infinity();

struct Result
{
  std::vector<float> low, high, mean, Gaussian, shape_index;
  std::vector<Status> statuses;
  std::size_t failures = 0;
};

template <typename Tag = CGAL::Parallel_if_available_tag,
          typename GBuffer,
          typename NamedParameters = sp::Default_named_parameters>
Result curvatures_of(const GBuffer& g, const NamedParameters& np)
{
  const std::size_t n = std::size_t(g.width()) * std::size_t(g.height());
  Result r;
  for(auto* v : {&r.low, &r.high, &r.mean, &r.Gaussian, &r.shape_index})
    v->assign(n, 7.f);
  r.statuses.assign(n, Status::CANCELLED);
  r.failures = SC::screen_space_curvatures<Tag>(g, np.min_curvature_map(map_of(r.low))
                                                       .max_curvature_map(map_of(r.high))
                                                       .mean_curvature_map(map_of(r.mean))
                                                       .Gaussian_curvature_map(map_of(r.Gaussian))
                                                       .shape_index_map(map_of(r.shape_index))
                                                       .status_map(map_of(r.statuses)));
  return r;
}

Result curvatures_of(const G_buffer& g)
{
  return curvatures_of(g, sp::number_of_triangles(4));
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

// errors of H and K relative to the truth; those of the cylinder's K relative to the square of its curvature
struct Errors
{
  double mean, Gaussian;
  std::size_t pixels;
};

Errors median_errors(const Picture& picture, const Result& r, double size_of_K, double least_facing = .3)
{
  std::vector<double> mean, Gaussian;
  for(std::size_t i = 0; i < picture.size(); ++i)
    if(picture.facing[i] > least_facing)
    {
      const double h = picture.mean_curvatures[i], k = picture.Gaussian_curvatures[i];
      mean.push_back(std::abs(r.mean[i] - h) / std::abs(h));
      Gaussian.push_back(std::abs(r.Gaussian[i] - k) / (size_of_K > 0. ? size_of_K : std::abs(k)));
    }
  return {quantile(mean, .5), quantile(Gaussian, .5), mean.size()};
}

// The shape operator of one triangle by least squares of all its equations (7.5), in double precision, by QR.
std::array<double, 2>
plain_triangle(const std::array<Eigen::Vector3d, 3>& p, const std::array<Eigen::Vector3d, 3>& n, int edges)
{
  const Eigen::Vector3d u = (p[1] - p[0]).normalized();
  const Eigen::Vector3d v = (p[1] - p[0]).cross(p[2] - p[0]).cross(u).normalized();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 * edges, 3);
  Eigen::VectorXd b(2 * edges);
  const int ends[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for(int i = 0; i < edges; ++i)
  {
    const Eigen::Vector3d e = p[std::size_t(ends[i][1])] - p[std::size_t(ends[i][0])];
    const Eigen::Vector3d d = n[std::size_t(ends[i][1])] - n[std::size_t(ends[i][0])];
    a(2 * i, 0) = a(2 * i + 1, 1) = e.dot(u);
    a(2 * i, 1) = a(2 * i + 1, 2) = e.dot(v);
    b[2 * i] = d.dot(u);
    b[2 * i + 1] = d.dot(v);
  }
  const Eigen::VectorXd x = test_support::least_squares(a, b);
  Eigen::Matrix2d w;
  w << x[0], x[1], x[1], x[2];
  const Eigen::Vector2d k = test_support::symmetric_eigenvalues(w);
  return {k[0], k[1]};
}

// smooth but otherwise arbitrary depths and normals
Picture arbitrary_picture(int width, int height, const Camera& camera)
{
  Picture picture(width, height, camera);
  for(int y = 0; y < height; ++y)
    for(int x = 0; x < width; ++x)
    {
      const std::size_t i = std::size_t(y * width + x);
      picture.depths[i] = float(camera.depth(4. + .05 * std::sin(.9 * x) + .04 * std::cos(1.3 * y + .2 * x)));
      const Eigen::Vector3d n =
          Eigen::Vector3d(.3 * std::sin(.4 * x), .2 * std::cos(.3 * y + .1 * x), 1.).normalized();
      for(std::size_t k = 0; k < 3; ++k)
        picture.normals[3 * i + k] = float(n[Eigen::Index(k)]);
      picture.facing[i] = 1.;
    }
  return picture;
}

} // namespace

BOOST_AUTO_TEST_CASE(accuracy_on_analytic_surfaces)
{
  for(const double distance : {2.5, 10., 200.})
    for(const int width : {150, 300}) // the object is two thirds as wide: 100 pixels and more
    {
      const Camera camera = camera_at(distance, 1.5);
      const auto check = [&](const Picture& picture, double size_of_K, const std::string& what)
      {
        for(const int triangles : {1, 2, 4})
          for(const int edges : {2, 3})
          {
            const Result r =
                curvatures_of(picture.g_buffer(), sp::number_of_triangles(triangles).number_of_edges(edges));
            const Errors e = median_errors(picture, r, size_of_K);
            BOOST_TEST_MESSAGE(what << " at " << distance << ", " << width << " pixels, " << triangles
                                    << " triangles, " << edges << " edges: median relative error of H "
                                    << e.mean << ", of K " << e.Gaussian);
            BOOST_TEST(e.pixels > 1000u);
            BOOST_TEST(e.mean < .02);
            BOOST_TEST(e.Gaussian < .04);
            if(triangles > 1)
            {
              BOOST_TEST(e.mean < .002);
              BOOST_TEST(e.Gaussian < .01);
            }
          }
      };
      check(Picture(width, width, camera).add(Sphere()), 0., "sphere");
      check(Picture(width, width, camera).add(Cylinder()), 4., "cylinder");
      check(Picture(width, width, camera).add(Torus()), 0., "torus");
    }
}

BOOST_AUTO_TEST_CASE(second_order)
{
  // halving the pixels' size quarters the error
  std::vector<double> errors;
  for(const int width : {60, 120, 240})
  {
    const Picture picture = Picture(width, width, camera_at(4., 1.5)).add(Torus());
    errors.push_back(median_errors(picture, curvatures_of(picture.g_buffer()), 0.).mean);
  }
  BOOST_TEST_MESSAGE("torus, errors at 60, 120, 240 pixels: " << errors[0] << ' ' << errors[1] << ' '
                                                              << errors[2]);
  BOOST_TEST(errors[1] < errors[0] / 3.);
  BOOST_TEST(errors[2] < errors[1] / 3.);
}

BOOST_AUTO_TEST_CASE(triangles_against_plain_least_squares)
{
  const Camera camera(Eigen::Matrix4d::Identity(), Camera::perspective(.5, 20. / 15., 2., 8.));
  const Picture picture = arbitrary_picture(20, 15, camera);
  const G_buffer g = picture.g_buffer();
  for(const int edges : {2, 3})
  {
    const Result r = curvatures_of(
        g, sp::number_of_triangles(1).number_of_edges(edges).depth_discontinuity_rule(Rule::NONE));
    for(int y = 0; y + 1 < 15; ++y)
      for(int x = 0; x + 1 < 20; ++x)
      {
        const std::size_t i = g.index(x, y), right = g.index(x + 1, y), up = g.index(x, y + 1);
        const auto k = plain_triangle({g.view_point(i), g.view_point(right), g.view_point(up)},
                                      {g.view_normal(i), g.view_normal(right), g.view_normal(up)}, edges);
        const double size = (std::max)(std::abs(k[0]), std::abs(k[1]));
        BOOST_TEST(std::abs(r.low[i] - k[0]) < 1e-4 * size);
        BOOST_TEST(std::abs(r.high[i] - k[1]) < 1e-4 * size);
        BOOST_TEST((r.statuses[i] == Status::ESTIMATED));
      }
  }
}

BOOST_AUTO_TEST_CASE(kinds_of_depth_and_projection)
{
  const Camera usual = camera_at(4., 1.5);
  Eigen::Matrix4d zero_to_one = usual.projection(), reversed, infinite, oblique = usual.projection();
  zero_to_one.row(2) = .5 * (usual.projection().row(2) + usual.projection().row(3));
  reversed = zero_to_one;
  reversed.row(2) = usual.projection().row(3) - zero_to_one.row(2);
  infinite = reversed; // reversed with the far plane at unlimited: the best there is
  infinite(2, 2) = 0.;
  infinite(2, 3) = usual.near_plane();
  oblique(0, 2) = .3; // off center
  oblique(1, 2) = -.2;
  const Eigen::Matrix4d parallel = Camera::orthographic(3.2, 1., 1., 7.);
  struct Case
  {
    const char* name;
    Camera camera;
  };
  // the planes are those of the projection, whatever depths are
  const double near = usual.near_plane(), far = usual.far_plane();
  BOOST_TEST(far > near);
  for(const auto& [matrix, convention, expected_far] :
      {std::make_tuple(zero_to_one, Convention::WINDOW_DEPTH_ZERO_TO_ONE, far),
       std::make_tuple(reversed, Convention::WINDOW_DEPTH_ZERO_TO_ONE, far),
       std::make_tuple(reversed, Convention::EYE_DISTANCE, far),
       std::make_tuple(infinite, Convention::WINDOW_DEPTH_ZERO_TO_ONE,
                       std::numeric_limits<double>::infinity()),
       std::make_tuple(infinite, Convention::EYE_DISTANCE, std::numeric_limits<double>::infinity()),
       std::make_tuple(usual.projection(), Convention::EYE_DISTANCE, far)})
  {
    const Camera camera(usual.view(), matrix, convention);
    BOOST_TEST(std::abs(camera.near_plane() - near) < 1e-12 * near);
    BOOST_TEST((camera.far_plane() == expected_far ||
                std::abs(camera.far_plane() - expected_far) < 1e-12 * expected_far));
  }
  const std::vector<Case> cases = {
      {"usual", usual},
      {"scaled matrix", Camera(usual.view(), 3. * usual.projection())},
      {"zero to one", Camera(usual.view(), zero_to_one, Convention::WINDOW_DEPTH_ZERO_TO_ONE)},
      {"reversed", Camera(usual.view(), reversed, Convention::WINDOW_DEPTH_ZERO_TO_ONE)},
      {"infinite", Camera(usual.view(), infinite, Convention::WINDOW_DEPTH_ZERO_TO_ONE)},
      {"distance", Camera(usual.view(), usual.projection(), Convention::EYE_DISTANCE)},
      {"off center", Camera(usual.view(), oblique)},
      {"parallel", Camera(usual.view(), parallel)},
      {"parallel, distance", Camera(usual.view(), parallel, Convention::EYE_DISTANCE)}};
  for(const Case& c : cases)
    BOOST_TEST_CONTEXT(c.name)
    {
      BOOST_TEST(c.camera.depth(c.camera.distance(.7)) == .7, boost::test_tools::tolerance(1e-12));
      const Picture picture = Picture(150, 150, c.camera).add(Sphere()).add(Sphere{{.8, .5, .4}, .3});
      const G_buffer g = picture.g_buffer();
      const Result r = curvatures_of(g);
      std::vector<double> errors;
      std::size_t background = 0, right_background = 0;
      for(std::size_t i = 0; i < picture.size(); ++i)
      {
        if(picture.facing[i] > .3 && r.statuses[i] == Status::ESTIMATED)
        {
          errors.push_back(std::abs(r.mean[i] / picture.mean_curvatures[i] - 1.));
          errors.push_back(std::abs(r.Gaussian[i] / picture.Gaussian_curvatures[i] - 1.));
        }
        background += picture.facing[i] == 0.;
        right_background +=
            picture.facing[i] == 0. && r.statuses[i] == Status::UNREFERENCED && std::isnan(r.mean[i]);
        if(picture.facing[i] > 0.)
        {
          BOOST_TEST_REQUIRE(g.is_valid(i));
          const Eigen::Vector3d p = c.camera.world_point(g.view_point(i));
          BOOST_TEST_REQUIRE((std::abs(p.norm() - 1.) < 1e-4 ||
                              std::abs((p - Eigen::Vector3d(.8, .5, .4)).norm() - .3) < 1e-4));
        }
        else
          BOOST_TEST_REQUIRE(!g.is_valid(i));
      }
      BOOST_TEST(r.failures == 0u);
      BOOST_TEST(background > 1000u);
      BOOST_TEST(background == right_background);
      BOOST_TEST_MESSAGE(c.name << ": median error " << quantile(errors, .5) << ", 99 of 100 below "
                                << quantile(errors, .99));
      BOOST_TEST(quantile(errors, .5) < 1e-4);
      BOOST_TEST(quantile(errors, .99) < 2e-3); // but next to creases
    }
}

BOOST_AUTO_TEST_CASE(normals_of_any_space_length_and_sign)
{
  const Picture picture = Picture(120, 100, camera_at(5., 1.5, 1.2)).add(Torus());
  const Result r = curvatures_of(picture.g_buffer());

  // world space, four channels, another length
  std::vector<float> world(4 * picture.size(), no_number);
  const Eigen::Matrix3d to_world = picture.camera.view().topLeftCorner<3, 3>().transpose();
  for(std::size_t i = 0; i < picture.size(); ++i)
  {
    const Eigen::Vector3d n = to_world * picture.g_buffer().normal(i).cast<double>();
    for(std::size_t k = 0; k < 3; ++k)
      world[4 * i + k] = float(n[Eigen::Index(k)] * (i % 2 ? 1e30 : 1e-30));
  }
  const G_buffer g(120, 100, picture.depths.data(), world.data(), picture.camera, SC::Normal_space::WORLD, 4);
  const Result w = curvatures_of(g);
  for(std::size_t i = 0; i < picture.size(); ++i)
  {
    BOOST_TEST_REQUIRE((w.statuses[i] == r.statuses[i]));
    if(picture.facing[i] > .3)
      BOOST_TEST_REQUIRE(std::abs(w.mean[i] - r.mean[i]) < 1e-4);
  }

  // the other side of the surface
  std::vector<float> flipped = picture.normals;
  for(float& n : flipped)
    n = -n;
  const Result f = curvatures_of(G_buffer(120, 100, picture.depths.data(), flipped.data(), picture.camera),
                                 sp::number_of_edges(2));
  for(std::size_t i = 0; i < picture.size(); ++i)
    if(SC::is_estimated(r.statuses[i]))
    {
      BOOST_TEST_REQUIRE(f.low[i] == -r.high[i]);
      BOOST_TEST_REQUIRE(f.high[i] == -r.low[i]);
      BOOST_TEST_REQUIRE(f.Gaussian[i] == r.Gaussian[i]);
    }
}

BOOST_AUTO_TEST_CASE(values_belong_together)
{
  const Picture picture = Picture(120, 120, camera_at(5., 1.5)).add(Torus()).add(Plane{{0., 0., 1.}, -1.});
  const Result r = curvatures_of(picture.g_buffer());
  for(std::size_t i = 0; i < picture.size(); ++i)
    if(SC::is_estimated(r.statuses[i]))
    {
      const SC::Screen_space_curvature c = {r.low[i], r.high[i], r.statuses[i]};
      BOOST_TEST_REQUIRE(r.low[i] <= r.high[i]);
      BOOST_TEST_REQUIRE(r.mean[i] == SC::mean_curvature(c));
      BOOST_TEST_REQUIRE(r.Gaussian[i] == SC::Gaussian_curvature(c));
      const float s = SC::shape_index(c);
      BOOST_TEST_REQUIRE((r.shape_index[i] == s || (std::isnan(s) && std::isnan(r.shape_index[i]))));
    }
  // nothing is asked for: the failures are counted all the same
  BOOST_TEST(SC::screen_space_curvatures(picture.g_buffer()) == 0u);
}

BOOST_AUTO_TEST_CASE(units)
{
  const auto picture = [](double unit)
  {
    const Camera c = camera_at(5., 1.5);
    Eigen::Matrix4d view = c.view();
    view.block<3, 1>(0, 3) *= unit;
    Torus torus;
    torus.major *= unit;
    torus.minor *= unit;
    return Picture(100, 100, Camera(view, Camera::perspective(2. * std::atan(.31), 1., 3. * unit, 7. * unit)))
        .add(torus);
  };
  const Picture one = picture(1.);
  const Result r = curvatures_of(one.g_buffer());
  for(const double unit : {1e-6, 1e-3, 1e3, 1e6, 1e12})
  {
    const Picture other = picture(unit);
    const Result o = curvatures_of(other.g_buffer());
    std::size_t differences = 0;
    std::vector<double> errors;
    for(std::size_t i = 0; i < one.size(); ++i)
    {
      differences += o.statuses[i] != r.statuses[i];
      if(one.facing[i] > .3)
        errors.push_back(std::abs(o.mean[i] * unit - r.mean[i]) / std::abs(r.mean[i]));
    }
    BOOST_TEST(differences <= 4u);           // pixels at the silhouette
    BOOST_TEST(quantile(errors, .5) < 1e-5); // the depths are rounded to single precision
    BOOST_TEST(quantile(errors, .999) < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(threads)
{
  const Picture picture = Picture(333, 555, camera_at(5., 1.5)).add(Torus()).add(Sphere{{.5, .5, .5}, .4});
  const auto np = sp::level_of_detail(Level_of_detail::by_length(.05));
  const Result a = curvatures_of<CGAL::Sequential_tag>(picture.g_buffer(), np);
  const Result b = curvatures_of<CGAL::Parallel_if_available_tag>(picture.g_buffer(), np);
  BOOST_TEST(same_bits(a.low, b.low));
  BOOST_TEST(same_bits(a.high, b.high));
  BOOST_TEST((a.statuses == b.statuses));
  BOOST_TEST(a.failures == b.failures);
}

BOOST_AUTO_TEST_CASE(normal_mapped_plane)
{
  // The points are those of a plane, the normals those of a ball: so are the curvatures, exactly so at right angles.
  const double radius = 1.3;
  const Camera camera(Camera::look_at({0., 0., 3.}, {0., 0., 0.}, {0., 1., 0.}),
                      Camera::orthographic(2., 1., 1., 5.));
  Picture picture = Picture(200, 200, camera).add(Plane());
  for(std::size_t i = 0; i < picture.size(); ++i)
  {
    const Eigen::Vector3d p = camera.world_point(picture.g_buffer().view_point(i));
    const double x = p.x() / radius, y = p.y() / radius, z = std::sqrt((std::max)(0., 1. - x * x - y * y));
    picture.normals[3 * i] = float(x);
    picture.normals[3 * i + 1] = float(y);
    picture.normals[3 * i + 2] = float(z);
  }
  const Result r = curvatures_of(picture.g_buffer());
  BOOST_TEST(r.failures == 0u);
  std::vector<double> errors;
  for(int y = 40; y < 160; ++y)
    for(int x = 40; x < 160; ++x)
    {
      const std::size_t i = std::size_t(200 * y + x);
      errors.push_back(std::abs(r.mean[i] * radius - 1.));
      errors.push_back(std::abs(r.Gaussian[i] * radius * radius - 1.));
    }
  BOOST_TEST(quantile(errors, 1.) < 1e-3);
}

// Where the normals of a normal map, or of a coarse mesh, lean away from points that are seen from the side, the points tell what
// belongs together.
BOOST_AUTO_TEST_CASE(leaning_normals_seen_from_the_side)
{
  for(const double elevation : {15., 20., 40.})
  {
    const double angle = elevation * CGAL_PI / 180.;
    const Camera camera(
        Camera::look_at({0., -3. * std::cos(angle), 3. * std::sin(angle)}, {0., 0., 0.}, {0., 0., 1.}),
        Camera::perspective(.3, 1., .5, 20.));
    Picture picture = Picture(200, 200, camera).add(Plane());
    for(const double tilt : {.3, .6})
      for(const double towards : {1., -1.})
      {
        for(std::size_t i = 0; i < picture.size(); ++i)
        {
          picture.normals[3 * i] = float(std::sin(tilt) / 2.);
          picture.normals[3 * i + 1] = float(towards * std::sin(tilt));
          picture.normals[3 * i + 2] = float(std::cos(tilt));
        }
        const Result r = curvatures_of(picture.g_buffer());
        BOOST_TEST(r.failures == 0u);
        for(std::size_t i = 0; i < picture.size(); ++i)
          if(SC::is_estimated(r.statuses[i]))
            BOOST_REQUIRE_SMALL(double(r.mean[i]), 1e-4);
      }
  }
}

BOOST_AUTO_TEST_CASE(levels_of_detail)
{
  const auto steps = [](const Level_of_detail& level, const Camera& camera, double distance)
  {
    std::array<float, Level_of_detail::maximum_step> table;
    const int largest = level.fill_table(camera, .001, table);
    const float depth = float(camera.depth(distance)), sign = camera.depth_grows() ? 1.f : -1.f;
    int step = 1;
    while(step < largest && sign * depth <= sign * table[std::size_t(step)])
      ++step;
    return step;
  };
  const Camera window(Eigen::Matrix4d::Identity(), Camera::perspective(.5, 1., .5, 200.));
  const Camera distances(Eigen::Matrix4d::Identity(), window.projection(), Convention::EYE_DISTANCE);
  Eigen::Matrix4d reversed = window.projection();
  reversed.row(2) *= -1.;
  const Camera falling(Eigen::Matrix4d::Identity(), reversed);
  const Camera parallel(Eigen::Matrix4d::Identity(), Camera::orthographic(1., 1., 0., 50.));
  BOOST_TEST(!falling.depth_grows());
  for(const double d : {.501, .52, .6, 1., 2., 7., 60., 199.})
  {
    BOOST_TEST(steps(Level_of_detail::none(), window, d) == 1);
    BOOST_TEST(steps(Level_of_detail::by_pixels(5), window, d) == 5);
    for(const Camera& camera : {window, distances, falling})
    {
      // (7.12) as it is printed
      BOOST_TEST(steps(Level_of_detail::by_depth(9.), camera, d) ==
                 int(std::floor(9. * std::pow(1. / (200. * 200.), d / 200.) + 1.)));
      BOOST_TEST(steps(Level_of_detail::by_length(.0205), camera, d) ==
                 (std::max)(1, (std::min)(32, int(.0205 / (.001 * d)))));
    }
    BOOST_TEST(steps(Level_of_detail::by_length(.0205), parallel, d) == 20);
  }
  // the far plane is at least 100 away
  const Camera near(Eigen::Matrix4d::Identity(), Camera::perspective(.5, 1., .5, 3.));
  BOOST_TEST(steps(Level_of_detail::by_depth(9.), near, .55) == int(9. * std::pow(1e-4, .55 / 3.) + 1.));

  for(const double size : {0., -1., 32., double(no_number), double(unlimited)})
    BOOST_CHECK_THROW(Level_of_detail::by_depth(size), std::invalid_argument);
  for(const double length : {0., -1., double(no_number), double(unlimited)})
    BOOST_CHECK_THROW(Level_of_detail::by_length(length), std::invalid_argument);
  for(const int step : {0, -1, 33})
    BOOST_CHECK_THROW(Level_of_detail::by_pixels(step), std::invalid_argument);

  // wide steps on smooth surfaces: still right
  const Picture picture = Picture(300, 300, camera_at(4., 1.5)).add(Sphere());
  for(const Level_of_detail& level :
      {Level_of_detail::by_depth(30.), Level_of_detail::by_length(.08), Level_of_detail::by_pixels(8)})
  {
    const Result r = curvatures_of(picture.g_buffer(), sp::level_of_detail(level));
    const Errors e = median_errors(picture, r, 0.);
    BOOST_TEST(e.mean < 1e-3);
    BOOST_TEST(e.Gaussian < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(depth_discontinuities)
{
  // A torus and a ball in front of a plane. Gross errors, larger than the reciprocal of the torus's radius, at pixels whose neighbors are
  // on other surfaces.
  const int width = 400;
  const Picture picture = Picture(width, width, camera_at(4., 1.5))
                              .add(Plane{Eigen::Vector3d(.3, .2, 1.).normalized(), -.8}, 1)
                              .add(Torus(), 2)
                              .add(Sphere{{.6, .6, .6}, .3}, 3);
  for(const int step : {1, 4, 8})
  {
    double gross[3] = {}, flagged_inside = 0.;
    for(const Rule rule : {Rule::NONE, Rule::FAR_PLANE, Rule::TANGENT_PLANES})
    {
      const Result r =
          curvatures_of(picture.g_buffer(),
                        sp::level_of_detail(Level_of_detail::by_pixels(step)).depth_discontinuity_rule(rule));
      std::size_t at_silhouettes = 0, wrong = 0, inside = 0, flagged = 0;
      for(int y = step; y < width - step; ++y)
        for(int x = step; x < width - step; ++x)
        {
          const int i = y * width + x;
          if(picture.objects[std::size_t(i)] < 0)
            continue;
          bool is_near = false;
          for(int k = 1; k <= step; ++k)
            for(const int d : {k, -k, k * width, -k * width})
              is_near = is_near || picture.objects[std::size_t(i + d)] != picture.objects[std::size_t(i)];
          const std::size_t p = std::size_t(i);
          if(is_near)
          {
            ++at_silhouettes;
            wrong += !(std::abs(r.mean[p] - picture.mean_curvatures[p]) < 1.);
          }
          else
          {
            ++inside;
            flagged += r.statuses[p] != Status::ESTIMATED;
          }
        }
      gross[int(rule)] = double(wrong) / double(at_silhouettes);
      if(rule == Rule::TANGENT_PLANES)
        flagged_inside = double(flagged) / double(inside);
    }
    BOOST_TEST_MESSAGE("step " << step << ": gross errors at silhouettes without a rule " << gross[0]
                               << ", with the far plane " << gross[1] << ", with tangent planes "
                               << gross[2]);
    BOOST_TEST(gross[2] < .005);
    BOOST_TEST(gross[2] < .1 * gross[1]);
    BOOST_TEST(gross[1] <= gross[0]);
    BOOST_TEST(flagged_inside < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(creases_are_kept)
{
  // Where two faces of a roof meet, both seen at less than 60 degrees, pixels bend: none is told apart.
  const Camera camera = camera_at(4., 1.5);
  Picture picture(200, 200, camera);
  picture.add(Plane{Eigen::Vector3d(1., 0., 1.2).normalized(), .2}, 1);
  Picture other = Picture(200, 200, camera).add(Plane{Eigen::Vector3d(-1., .2, 1.2).normalized(), .2}, 2);
  for(std::size_t i = 0; i < picture.size(); ++i) // what is farther away: the ridge points at the eye
    if(other.facing[i] > 0. && (picture.facing[i] == 0. || other.depths[i] > picture.depths[i]))
    {
      picture.depths[i] = other.depths[i];
      std::copy_n(other.normals.begin() + std::ptrdiff_t(3 * i), 3,
                  picture.normals.begin() + std::ptrdiff_t(3 * i));
      picture.facing[i] = other.facing[i];
      picture.objects[i] = 2;
    }
  const Result r = curvatures_of(picture.g_buffer());
  std::size_t convex = 0, at_ridge = 0;
  for(int y = 1; y < 199; ++y)
    for(int x = 1; x < 199; ++x)
    {
      const std::size_t i = std::size_t(200 * y + x);
      if(picture.objects[i] == 2 && picture.objects[i + 1] == 1)
      {
        ++at_ridge;
        convex += r.statuses[i] == Status::ESTIMATED && r.high[i] > 5.f;
      }
    }
  BOOST_TEST(at_ridge > 100u);
  BOOST_TEST(convex == at_ridge);
}

BOOST_AUTO_TEST_CASE(bad_pixels)
{
  Picture picture = Picture(60, 50, camera_at(5., 1.5, 1.2)).add(Sphere());
  const Result before = curvatures_of(picture.g_buffer());
  const std::size_t center = 25 * 60 + 30;
  struct Case
  {
    std::size_t pixel;
    Status status;
  };
  const std::vector<Case> cases = {
      {center, Status::NON_FINITE_INPUT},         {center - 10, Status::NON_FINITE_INPUT},
      {center + 10, Status::NON_FINITE_INPUT},    {center + 5 * 60, Status::NON_FINITE_INPUT},
      {center - 5 * 60, Status::UNREFERENCED},    {center + 5 + 5 * 60, Status::UNREFERENCED},
      {center - 5 - 5 * 60, Status::UNREFERENCED}};
  picture.normals[3 * cases[0].pixel] = no_number;
  picture.normals[3 * cases[1].pixel + 2] = unlimited;
  for(std::size_t k = 0; k < 3; ++k)
    picture.normals[3 * cases[2].pixel + k] = 0.f;
  picture.depths[cases[3].pixel] = no_number;
  picture.depths[cases[4].pixel] = 1.f;
  picture.depths[cases[5].pixel] = unlimited;
  picture.depths[cases[6].pixel] = -1.f;
  const G_buffer g = picture.g_buffer();
  const Result r = curvatures_of(g);
  BOOST_TEST(r.failures == 4u);
  std::vector<bool> is_near(picture.size(), false), is_bad(picture.size(), false);
  for(const Case& c : cases)
  {
    BOOST_TEST((r.statuses[c.pixel] == c.status), SC::to_string(r.statuses[c.pixel]));
    for(const auto* v : {&r.low, &r.high, &r.mean, &r.Gaussian, &r.shape_index})
      BOOST_TEST(std::isnan((*v)[c.pixel]));
    BOOST_TEST(!g.is_valid(c.pixel));
    is_bad[c.pixel] = true;
    for(const std::size_t i : {c.pixel - 1, c.pixel + 1, c.pixel - 60, c.pixel + 60})
      is_near[i] = true;
  }
  for(std::size_t i = 0; i < picture.size(); ++i)
    if(is_bad[i])
      continue;
    else if(is_near[i])
    {
      BOOST_TEST((r.statuses[i] == Status::BORDER));
      BOOST_TEST(std::abs(r.mean[i] - 1.) < 1e-3);
    }
    else
    {
      BOOST_TEST_REQUIRE((r.statuses[i] == before.statuses[i]));
      if(SC::is_estimated(r.statuses[i]))
        BOOST_TEST_REQUIRE(r.low[i] == before.low[i]);
    }

  // the sphere fit: the same, in the radius
  std::vector<float> mean(picture.size(), 7.f);
  std::vector<Status> statuses(picture.size());
  BOOST_TEST(SC::sphere_fit_mean_curvatures(
                 g, sp::mean_curvature_map(map_of(mean)).status_map(map_of(statuses))) == 4u);
  for(const Case& c : cases)
  {
    BOOST_TEST((statuses[c.pixel] == c.status));
    BOOST_TEST(std::isnan(mean[c.pixel]));
  }
  BOOST_TEST((statuses[center + 1] == Status::BORDER));
  BOOST_TEST(std::abs(mean[center + 1] - 1.) < 1e-3);
}

BOOST_AUTO_TEST_CASE(uniforms_of_the_shader)
{
  // the formulas in the first lines of the shader are those of the passes
  Eigen::Matrix4d projection = Camera::perspective(.7, 1.5, .5, 30.);
  projection(0, 2) = .1;
  projection(1, 2) = -.2;
  const int w = 300, h = 170;
  const SC::internal::Screen_frame frame(Camera(Eigen::Matrix4d::Identity(), projection),
                                         SC::Normal_space::VIEW, w, h);
  const auto p = [&](int column, int row) { return projection(row, column); }; // as in GLSL
  const auto check = [](double a, double b) { BOOST_TEST(std::abs(a - b) <= 1e-6 * std::abs(b)); };
  const double scale = frame.denominator[1] / -2.;
  check(frame.numerator[0], scale * -p(3, 2));
  check(frame.numerator[1], 0.);
  check(frame.denominator[0], scale * (-1. - p(2, 2)));
  check(frame.determinant, scale * scale * -2. * p(3, 2));
  check(frame.depth_reference, 1.);
  check(frame.lowest_depth, 0.);
  check(frame.highest_depth, .99999994);
  check(frame.depth_sign, 1.);
  check(frame.ray_origin[0], (1. / w - 1. + p(2, 0)) / p(0, 0));
  check(frame.ray_origin[1], (1. / h - 1. + p(2, 1)) / p(1, 1));
  check(frame.ray_step[0], 2. / (w * p(0, 0)));
  check(frame.ray_step[1], 2. / (h * p(1, 1)));
  const double m = std::sqrt(frame.ray_step[0] * frame.ray_step[1]);
  check(frame.pixel_edge[0], frame.ray_step[0] / m);
  check(frame.pixel_edge[1], frame.ray_step[1] / m);
  check(frame.pixel_size, m);
  check(frame.perspective, 1.);
}

BOOST_AUTO_TEST_CASE(small_pictures)
{
  const Camera camera = camera_at(5., 1.5);
  // without pixels
  for(const auto& size : {std::array<int, 2>{0, 0}, {0, 5}, {5, 0}})
  {
    const G_buffer g(size[0], size[1], nullptr, nullptr, camera);
    BOOST_TEST(SC::screen_space_curvatures(g) == 0u);
    BOOST_TEST(SC::sphere_fit_mean_curvatures(g) == 0u);
  }
  BOOST_TEST(SC::screen_space_curvatures(G_buffer()) == 0u);
  // one pixel, a row, a column: too few neighbors
  for(const auto& size : {std::array<int, 2>{1, 1}, {5, 1}, {1, 5}})
  {
    const Picture picture = Picture(size[0], size[1], camera).add(Sphere{{0., 0., 0.}, 1.4});
    const Result r = curvatures_of(picture.g_buffer());
    BOOST_TEST(r.failures == picture.size());
    for(std::size_t i = 0; i < picture.size(); ++i)
    {
      BOOST_TEST((r.statuses[i] == Status::FEW_NEIGHBOURS));
      BOOST_TEST(std::isnan(r.low[i]));
    }
  }
  // two by two: one triangle each
  const Picture picture = Picture(2, 2, camera_at(50., 1.)).add(Sphere{{0., 0., 0.}, 3.});
  const Result r = curvatures_of(picture.g_buffer());
  for(std::size_t i = 0; i < 4; ++i)
  {
    BOOST_TEST((r.statuses[i] == Status::BORDER));
    BOOST_TEST(std::abs(r.mean[i] - 1. / 3.) < 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(sphere_fits)
{
  for(const int radius : {2, 8, 16})
  {
    const Picture picture = Picture(200, 200, camera_at(5., 1.5)).add(Sphere());
    std::vector<float> mean(picture.size());
    std::vector<Status> statuses(picture.size());
    SC::sphere_fit_mean_curvatures(
        picture.g_buffer(),
        sp::mean_curvature_map(map_of(mean)).status_map(map_of(statuses)).pixel_radius(radius));
    std::vector<double> errors;
    for(std::size_t i = 0; i < picture.size(); ++i)
      if(statuses[i] == Status::ESTIMATED)
        errors.push_back(std::abs(mean[i] - 1.));
    BOOST_TEST(errors.size() > 3000u);
    BOOST_TEST(quantile(errors, 1.) < 1e-3); // a sphere is what is fitted
  }
  const Picture torus = Picture(200, 200, camera_at(5., 1.5)).add(Torus());
  std::vector<float> mean(torus.size());
  SC::sphere_fit_mean_curvatures(torus.g_buffer(), sp::mean_curvature_map(map_of(mean)).pixel_radius(4));
  std::vector<double> errors;
  for(std::size_t i = 0; i < torus.size(); ++i)
    if(torus.facing[i] > .5)
      errors.push_back(std::abs(mean[i] - torus.mean_curvatures[i]));
  BOOST_TEST_MESSAGE("torus, sphere fit of 4 pixels: median error " << quantile(errors, .5));
  BOOST_TEST(quantile(errors, .5) < .05);
}

BOOST_AUTO_TEST_CASE(better_than_sphere_fits)
{
  // the mean curvature is at least as good as that of spheres fitted to 8 pixels around; silhouettes included
  for(const double distance : {3., 6.})
  {
    const Picture picture = Picture(200, 200, camera_at(distance, 1.5))
                                .add(Torus())
                                .add(Cylinder{Eigen::Vector3d(0., 1., .1).normalized(), .2});
    const G_buffer g = picture.g_buffer();
    const auto error = [&](const std::vector<float>& mean, double q)
    {
      std::vector<double> errors;
      for(std::size_t i = 0; i < picture.size(); ++i)
        if(picture.facing[i] > 0. && !std::isnan(mean[i]))
          errors.push_back(std::abs(mean[i] - picture.mean_curvatures[i]) /
                           std::abs(picture.mean_curvatures[i]));
      return quantile(errors, q);
    };
    std::vector<float> fitted(picture.size());
    SC::sphere_fit_mean_curvatures(g, sp::mean_curvature_map(map_of(fitted)));
    const Result r = curvatures_of(g);
    for(const double q : {.5, .9})
    {
      BOOST_TEST_MESSAGE("torus and cylinder at " << distance << ", relative error of H, quantile " << q
                                                  << ": " << error(r.mean, q) << ", of spheres "
                                                  << error(fitted, q));
      BOOST_TEST(error(r.mean, q) < .5 * error(fitted, q));
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_parameters)
{
  const Picture picture = Picture(10, 10, camera_at(5., 1.5)).add(Sphere());
  const G_buffer g = picture.g_buffer();
  const float* d = picture.depths.data();
  const float* n = picture.normals.data();
  for(const double k : {0., 5., -1., 1.5})
    BOOST_CHECK_THROW(SC::screen_space_curvatures(g, sp::number_of_triangles(k)), std::invalid_argument);
  for(const double k : {0., 1., 4., 2.5})
    BOOST_CHECK_THROW(SC::screen_space_curvatures(g, sp::number_of_edges(k)), std::invalid_argument);
  for(const double k : {-1., 0., 1., 65., 2.5})
    BOOST_CHECK_THROW(SC::sphere_fit_mean_curvatures(g, sp::pixel_radius(k)), std::invalid_argument);
  BOOST_CHECK_THROW(G_buffer(-1, 10, d, n, picture.camera), std::invalid_argument);
  BOOST_CHECK_THROW(G_buffer(10, 10, nullptr, n, picture.camera), std::invalid_argument);
  BOOST_CHECK_THROW(G_buffer(10, 10, d, nullptr, picture.camera), std::invalid_argument);
  BOOST_CHECK_THROW(G_buffer(10, 10, d, n, picture.camera, SC::Normal_space::VIEW, 2), std::invalid_argument);

  const Eigen::Matrix4d view = Eigen::Matrix4d::Identity(), projection = Camera::perspective(1., 1., 1., 2.);
  BOOST_CHECK_THROW(Camera(2. * view, projection), std::invalid_argument);
  BOOST_CHECK_THROW(Camera(double(no_number) * view, projection), std::invalid_argument);
  BOOST_CHECK_THROW(Camera(view, Eigen::Matrix4d::Zero()), std::invalid_argument);
  BOOST_CHECK_THROW(Camera(view, Eigen::Matrix4d::Ones()), std::invalid_argument);
  Eigen::Matrix4d mirrored = view;
  mirrored(0, 0) = -1.;
  BOOST_CHECK_THROW(Camera(mirrored, projection), std::invalid_argument);
  BOOST_CHECK_THROW(Camera::perspective(0., 1., 1., 2.), std::invalid_argument);
  BOOST_CHECK_THROW(Camera::perspective(4., 1., 1., 2.), std::invalid_argument);
  BOOST_CHECK_THROW(Camera::perspective(1., 0., 1., 2.), std::invalid_argument);
  BOOST_CHECK_THROW(Camera::perspective(1., 1., 0., 2.), std::invalid_argument);
  BOOST_CHECK_THROW(Camera::perspective(1., 1., 2., 1.), std::invalid_argument);
  BOOST_CHECK_THROW(Camera::orthographic(0., 1., 1., 2.), std::invalid_argument);
  BOOST_CHECK_THROW(Camera::orthographic(1., 1., 2., 2.), std::invalid_argument);
  BOOST_CHECK_THROW(Camera::look_at({0., 0., 0.}, {0., 0., 0.}, {0., 1., 0.}), std::invalid_argument);
  BOOST_CHECK_THROW(Camera::look_at({0., 0., 1.}, {0., 0., 0.}, {0., 0., 1.}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
