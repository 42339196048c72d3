#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/registration/fast_global_registration.h>
#include <Shape_characteristics/registration/tuple_test.h>

#include "bumpy_ball.h"
#include "raise_to.h"

#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(fast_global_registration)

namespace SC = Shape_characteristics;
using SC::Correspondence;
using SC::Oriented_points;
using SC::Rigid_alignment;
using test_support::bumpy_ball;
using test_support::moved;
using test_support::Random;
using test_support::random_motion;
using Correspondences = std::vector<Correspondence>;
using Status = SC::Estimation_status;

namespace {

struct Scene
{
  Oriented_points source, target;
  Correspondences correspondences;
  Eigen::Isometry3d truth;
};

// of a share of the correspondences, the target is drawn at random
Scene make_scene(std::size_t n, double wrong, std::uint64_t seed, double distance = 5.)
{
  Random random(seed);
  Scene scene;
  scene.source = bumpy_ball(n);
  scene.truth = random_motion(random, distance);
  scene.target = moved(scene.source, scene.truth);
  for(std::uint32_t i = 0; i < n; ++i)
    scene.correspondences.push_back(
        {i, random.uniform() < wrong ? std::uint32_t(random.uniform() * double(n)) : i});
  return scene;
}

template <typename... NamedParameters>
Rigid_alignment align(const Scene& s, const NamedParameters&... np)
{
  return SC::fast_global_registration(s.source, s.target, s.correspondences, np...);
}

// the largest distance between where two motions bring a point
double difference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const Oriented_points& points)
{
  double result = 0.;
  for(const auto& p : points.points)
    test_support::raise_to(result, (a * p - b * p).norm());
  return result;
}

void check_failure(const Rigid_alignment& result, Status status)
{
  BOOST_TEST(int(result.status) == int(status));
  BOOST_TEST(result.transformation.matrix().array().isNaN().all());
  BOOST_TEST(result.inliers.empty());
  BOOST_TEST(std::isnan(result.residual));
  BOOST_TEST(std::isnan(result.conditioning));
}

} // namespace

BOOST_AUTO_TEST_CASE(exact_correspondences_give_the_exact_motion)
{
  for(std::uint64_t seed = 0; seed < 30; ++seed)
  {
    const Scene scene = make_scene(seed % 3 == 0 ? 3 : 200, 0., seed);
    const Rigid_alignment result = align(scene);
    BOOST_TEST(int(result.status) == int(Status::ESTIMATED));
    BOOST_TEST(difference(result, scene.truth, scene.source) < 1e-13);
    BOOST_TEST((result.inliers == scene.correspondences));
    BOOST_TEST(result.residual < 1e-14);
    BOOST_TEST(result.has_converged);
    BOOST_TEST(result.transformation.linear().determinant() > 0.);
  }
  // half turns, on which steps of Gauss and Newton stand still
  for(const Eigen::Vector3d& axis : {Eigen::Vector3d(1., 0., 0.), Eigen::Vector3d(0., .6, -.8)})
  {
    Scene scene = make_scene(100, 0., 1);
    scene.truth = Eigen::AngleAxisd(CGAL_PI, axis);
    scene.target = moved(scene.source, scene.truth);
    BOOST_TEST(difference(align(scene), scene.truth, scene.source) < 1e-13);
  }
  // far from the origin, as far as coordinates are exact there
  const Scene far = make_scene(200, 0., 2, 1e7);
  BOOST_TEST(difference(align(far), far.truth, far.source) < 1e-8);
}

BOOST_AUTO_TEST_CASE(equal_surfaces_give_the_identity)
{
  Scene scene = make_scene(500, 0., 3);
  scene.target = scene.source;
  BOOST_TEST((align(scene).transformation.matrix() - Eigen::Matrix4d::Identity()).norm() < 1e-12);
}

BOOST_AUTO_TEST_CASE(wrong_correspondences)
{
  for(const double wrong : {.3, .5, .6, .7})
    for(std::uint64_t seed = 0; seed < 10; ++seed)
    {
      const Scene scene = make_scene(500, wrong, 10 + seed);
      const Rigid_alignment result = align(scene);
      BOOST_TEST(difference(result, scene.truth, scene.source) < 1e-3);
      // of the inliers nearly all are right, and no right one is missing
      std::size_t right = 0, right_inliers = 0;
      for(const auto& c : scene.correspondences)
        right += c.source == c.target;
      for(const auto& c : result.inliers)
        right_inliers += c.source == c.target;
      BOOST_TEST(right_inliers == right);
      BOOST_TEST(result.inliers.size() - right_inliers < 10u);
    }
}

// The motion is a minimum of what the documentation says is minimized: every motion nearby is worse.
BOOST_AUTO_TEST_CASE(the_robust_sum_is_minimal)
{
  Scene scene = make_scene(400, .4, 30);
  Random random(31);
  for(auto& p : scene.target.points)
    for(int k = 0; k < 3; ++k)
      p[k] += .01 * random.gaussian();
  const Rigid_alignment result = align(scene);
  double size = 0.;
  for(const auto* points : {&scene.source.points, &scene.target.points})
  {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for(const auto& p : *points)
      mean += p / double(points->size());
    for(const auto& p : *points)
      size = std::max(size, (p - mean).norm());
  }
  const long double mu = std::pow(.025L * size, 2);
  const auto sum = [&](const Eigen::Isometry3d& motion)
  {
    long double s = 0;
    for(const auto& c : scene.correspondences)
    {
      const long double r2 =
          (motion * scene.source.points[c.source] - scene.target.points[c.target]).squaredNorm();
      s += mu * r2 / (mu + r2);
    }
    return s;
  };
  const long double least = sum(result);
  for(const double step : {1e-5, 1e-3})
    for(int i = 0; i < 200; ++i)
    {
      const auto gaussian = [&]
      {
        const double x = random.gaussian(), y = random.gaussian();
        return Eigen::Vector3d(x, y, random.gaussian());
      };
      const Eigen::Vector3d rotation = step * gaussian(), center = result.transformation.translation();
      Eigen::Isometry3d other = Eigen::Isometry3d::Identity();
      other.linear() = Eigen::AngleAxisd(rotation.norm(), rotation.normalized()).toRotationMatrix();
      other.translation() = center - other.linear() * center + step * gaussian();
      BOOST_TEST(sum(other * result.transformation) > least);
    }
  BOOST_TEST(result.residual < 2. * .01 * std::sqrt(3.));
}

BOOST_AUTO_TEST_CASE(start_unit_order_and_direction_do_not_count)
{
  Scene scene = make_scene(300, .5, 40);
  Random random(41);
  for(auto& p : scene.target.points)
    for(int k = 0; k < 3; ++k)
      p[k] += .02 * random.gaussian();
  const Rigid_alignment expected = align(scene);
  const auto check = [&](const Eigen::Isometry3d& motion, const Rigid_alignment& result)
  {
    BOOST_TEST(difference(motion, expected, scene.source) < 1e-9);
    BOOST_TEST(result.inliers.size() == expected.inliers.size());
    BOOST_TEST(std::abs(result.conditioning / expected.conditioning - 1.) < 1e-9);
    BOOST_TEST(result.has_converged);
  };

  for(int i = 0; i < 10; ++i)
  {
    const Eigen::Isometry3d start = random_motion(random, 20.);
    Scene other = scene;
    other.source = moved(scene.source, start);
    const Rigid_alignment result = align(other);
    check(result.transformation * start, result);
  }
  for(const double scale : {1e-6, 1e6, 1e-100, 1e100})
  {
    Scene other = scene;
    for(auto* points : {&other.source.points, &other.target.points})
      for(auto& p : *points)
        p *= scale;
    const Rigid_alignment result = align(other);
    Eigen::Isometry3d motion = result;
    motion.translation() /= scale;
    check(motion, result);
    BOOST_TEST(std::abs(result.residual / (scale * expected.residual) - 1.) < 1e-9);
  }
  Scene other = scene;
  for(std::size_t i = other.correspondences.size(); i > 1; --i)
    std::swap(other.correspondences[i - 1], other.correspondences[std::size_t(random.uniform() * double(i))]);
  check(align(other), align(other));

  other = scene;
  std::swap(other.source, other.target);
  for(auto& c : other.correspondences)
    std::swap(c.source, c.target);
  const Rigid_alignment back = align(other);
  BOOST_TEST(difference(back.transformation.inverse(), expected, scene.source) < 1e-9);
}

// Both sides of a symmetric surface: more correspondences lead to the mirrored partner than to the right one.
BOOST_AUTO_TEST_CASE(mirrored_correspondences)
{
  int with = 0, without = 0;
  for(std::uint64_t seed = 0; seed < 10; ++seed)
  {
    Random random(50 + seed);
    Scene scene;
    scene.source = bumpy_ball(400, true);
    // point i + n is the mirror image of point i, and on the surface as well
    const std::uint32_t n = std::uint32_t(scene.source.size());
    for(std::uint32_t i = 0; i < n; ++i)
    {
      const Eigen::Vector3d mirror(-1., 1., 1.);
      scene.source.points.push_back(scene.source.points[i].cwiseProduct(mirror));
      scene.source.normals.push_back(scene.source.normals[i].cwiseProduct(mirror));
    }
    scene.truth = random_motion(random, 3.);
    scene.target = moved(scene.source, scene.truth);
    for(std::uint32_t i = 0; i < n; ++i)
    {
      // near the plane of symmetry, a point and its mirror image are the same, for all that distances tell
      const double x = random.uniform(), mirrored = std::abs(scene.source.points[i].x()) > .1 ? .8 : .15;
      scene.correspondences.push_back(
          {i, x < .15 ? i : (x < mirrored ? i + n : std::uint32_t(random.uniform() * 2. * n))});
    }
    const auto is_right = [&](const Correspondences& triples)
    {
      return difference(SC::fast_global_registration(scene.source, scene.target, triples), scene.truth,
                        scene.source) < 1e-3;
    };
    with += is_right(SC::tuple_test(scene.source, scene.target, scene.correspondences));
    without +=
        is_right(SC::tuple_test(scene.source, scene.target, scene.correspondences,
                                SC::parameters::orientation_is_tested(false).normals_are_tested(false)));
  }
  BOOST_TEST(with == 10);
  BOOST_TEST(without < 5);
}

BOOST_AUTO_TEST_CASE(repeated_correspondences_weigh_more)
{
  // two points that disagree, between two that hold the motion: the mean of their distances, weighted, is the translation
  Scene scene;
  scene.source.points = {{0., 0., 0.}, {0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}};
  scene.target = scene.source;
  scene.target.points[0].z() = 1e-6;
  scene.target.points[1].z() = -1e-6;
  scene.correspondences = {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}};
  const double once = align(scene).transformation.translation().z();
  BOOST_TEST(std::abs(once) < 1e-12);
  scene.correspondences.insert(scene.correspondences.end(), 50, {0, 0});
  BOOST_TEST(align(scene).transformation.translation().z() > 1e-7);
}

BOOST_AUTO_TEST_CASE(conditioning_of_known_shapes)
{
  const auto conditioning = [](const std::vector<Eigen::Vector3d>& points)
  {
    Scene scene;
    scene.source.points = scene.target.points = points;
    for(std::uint32_t i = 0; i < points.size(); ++i)
      scene.correspondences.push_back({i, i});
    const Rigid_alignment result = align(scene);
    BOOST_TEST(int(result.status) == int(Status::ESTIMATED));
    return result.conditioning;
  };
  // eigenvalues of the scatter matrix, by its trace: 1/3, 1/3, 1/3; 1/2, 1/2, 0; a, 1 - a, 0
  const std::vector<Eigen::Vector3d> octahedron{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                                {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  BOOST_TEST(std::abs(conditioning(octahedron) - 2. / 3.) < 1e-12);
  BOOST_TEST(std::abs(conditioning({{1, 0, 5}, {-1, 0, 5}, {0, 1, 5}, {0, -1, 5}}) - .5) < 1e-12);
  for(const double width : {1e-1, 1e-3, 1e-5})
  {
    const double expected = width * width / (1. + width * width);
    BOOST_TEST(std::abs(conditioning({{1, 0, 0}, {-1, 0, 0}, {0, width, 0}, {0, -width, 0}}) / expected -
                        1.) < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check_failure(align(Scene()), Status::FEW_NEIGHBOURS);
  const Scene scene = make_scene(50, 0., 60);
  Scene bad = scene;
  bad.correspondences.clear();
  check_failure(align(bad), Status::FEW_NEIGHBOURS);
  bad.correspondences.assign(100, {1, 1});
  bad.correspondences.push_back({2, 2}); // two are not three
  check_failure(align(bad), Status::FEW_NEIGHBOURS);

  bad = scene; // infinite points are nobody's, the others stay exact
  bad.source.points[3].y() = nan;
  bad.target.points[4].z() = std::numeric_limits<double>::infinity();
  Rigid_alignment result = align(bad);
  BOOST_TEST(result.inliers.size() == 48u);
  BOOST_TEST((result.transformation.matrix() - scene.truth.matrix()).norm() < 1e-12);
  for(auto& p : bad.source.points)
    p.x() = nan;
  check_failure(align(bad), Status::FEW_NEIGHBOURS);

  bad = scene; // all in one point, in one or in both
  for(auto& p : bad.source.points)
    p = {1., 2., 3.};
  check_failure(align(bad), Status::FEW_NEIGHBOURS); // hardly a distance is right
  for(auto& p : bad.target.points)
    p = {3., 2., 1.};
  check_failure(align(bad), Status::DEGENERATE);

  bad = scene; // so far out that motions would leave the range of numbers
  for(auto* const points : {&bad.source.points, &bad.target.points})
    for(auto& p : *points)
      p *= 1e307;
  check_failure(align(bad), Status::DEGENERATE);

  bad = scene; // on a line
  for(std::size_t i = 0; i < bad.source.size(); ++i)
    bad.source.points[i] = Eigen::Vector3d(.1, 0., 3.) + double(i) * Eigen::Vector3d(1., 2., 3.) / 7.;
  bad.target = moved(bad.source, scene.truth);
  check_failure(align(bad), Status::DEGENERATE);

  bad = scene; // in a plane: enough
  for(auto& p : bad.source.points)
    p.z() = 0.;
  bad.target = moved(bad.source, scene.truth);
  BOOST_TEST(difference(align(bad), scene.truth, bad.source) < 1e-12);

  // one wrong unit: no motion brings the points together
  bad = scene;
  for(auto& p : bad.target.points)
    p *= 1000.;
  check_failure(align(bad), Status::FEW_NEIGHBOURS);

  bad = scene;
  bad.correspondences.push_back({0, 50});
  BOOST_CHECK_THROW(align(bad), std::invalid_argument);
  for(const double d : {0., -1., 2., nan})
    BOOST_CHECK_THROW(align(scene, SC::parameters::maximum_correspondence_distance(d)),
                      std::invalid_argument);
  BOOST_CHECK_THROW(align(scene, SC::parameters::number_of_iterations(0)), std::invalid_argument);
  BOOST_CHECK_THROW(align(scene, SC::parameters::number_of_iterations(1.5)), std::invalid_argument);

  BOOST_TEST(align(scene, SC::parameters::number_of_iterations(1)).number_of_iterations == 1u);
  result = align(scene, SC::parameters::number_of_iterations(7));
  BOOST_TEST(!result.has_converged);
  BOOST_TEST(result.number_of_iterations == 7u);
}

BOOST_AUTO_TEST_SUITE_END()
