#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/registration/iterative_closest_point.h>

#include "bumpy_ball.h"
#include "plain_algebra.h"
#include "raise_to.h"

#include <CGAL/number_type_config.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(iterative_closest_point)

namespace SC = Shape_characteristics;
using SC::Oriented_points;
using SC::Rigid_alignment;
using test_support::bumpy_ball;
using test_support::moved;
using test_support::Random;
using test_support::random_motion;
using Status = SC::Estimation_status;

namespace {

template <typename... NamedParameters>
Rigid_alignment align(const Oriented_points& source,
                      const Oriented_points& target,
                      const Eigen::Isometry3d& start,
                      const NamedParameters&... np)
{
  return SC::iterative_closest_point<CGAL::Sequential_tag>(source, target, start, np...);
}

// the largest distance between where two motions bring a point
double difference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const Oriented_points& points)
{
  double result = 0.;
  for(const auto& p : points.points)
    if(p.allFinite())
      test_support::raise_to(result, (a * p - b * p).norm());
  return result;
}

// a motion that displaces points of a surface of radius 1 by about `size`
Eigen::Isometry3d small_motion(Random& random, double size)
{
  const Eigen::Vector3d axis = random_motion(random, 1.).translation();
  Eigen::Isometry3d motion(Eigen::AngleAxisd(size, axis));
  motion.translation() = .5 * size * random_motion(random, 1.).translation();
  return motion;
}

// the points whose coordinate along x is at least (at most) a limit
Oriented_points part(const Oriented_points& points, double sign, double limit)
{
  Oriented_points result;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(sign * points.points[i].x() >= limit)
    {
      result.points.push_back(points.points[i]);
      result.normals.push_back(points.normals[i]);
    }
  return result;
}

void check_failure(const Rigid_alignment& result, Status status)
{
  BOOST_TEST(int(result.status) == int(status));
  BOOST_TEST(result.transformation.matrix().array().isNaN().all());
  BOOST_TEST(result.inliers.empty());
  BOOST_TEST(std::isnan(result.residual));
}

} // namespace

BOOST_AUTO_TEST_CASE(equal_surfaces_stay_where_they_are)
{
  for(const double scale : {1., 1e-6, 1e6})
  {
    Oriented_points points = bumpy_ball(1000);
    for(auto& p : points.points)
      p = scale * (p + Eigen::Vector3d(3., 4., 5.));
    const Rigid_alignment result = align(points, points, Eigen::Isometry3d::Identity());
    BOOST_TEST(int(result.status) == int(Status::ESTIMATED));
    BOOST_TEST(result.has_converged);
    BOOST_TEST((result.transformation.linear() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
    BOOST_TEST(result.transformation.translation().norm() < 1e-12 * scale);
    BOOST_TEST(result.inliers.size() == points.size());
    for(const auto& c : result.inliers)
      BOOST_TEST(c.source == c.target);
    BOOST_TEST(result.residual < 1e-12 * scale);
  }
}

BOOST_AUTO_TEST_CASE(known_motions_are_found_from_near)
{
  Random random(1);
  const Oriented_points source = bumpy_ball(2000);
  for(int i = 0; i < 10; ++i)
  {
    const Eigen::Isometry3d truth = random_motion(random, 4.);
    const Rigid_alignment result = align(source, moved(source, truth), truth * small_motion(random, .08));
    BOOST_TEST(result.has_converged);
    BOOST_TEST(difference(result, truth, source) < 1e-12);
    BOOST_TEST(result.residual < 1e-12);
  }
}

// Two samplings of one surface, of which each shows a part, with points that belong to neither.
BOOST_AUTO_TEST_CASE(parts_that_overlap)
{
  Random random(2);
  for(int i = 0; i < 5; ++i)
  {
    Oriented_points source = part(bumpy_ball(3000), 1., -.3);
    Oriented_points target = part(bumpy_ball(2500, false, 1.), -1., -.3);
    for(std::size_t k = 0; k < source.size(); k += 10) // spikes
      source.points[k] += random.uniform(.02, .3) * source.normals[k];
    const Eigen::Isometry3d truth = random_motion(random, 4.);
    target = moved(target, truth);
    const Rigid_alignment result = align(source, target, truth * small_motion(random, .05));
    BOOST_TEST(result.has_converged);
    BOOST_TEST(difference(result, truth, source) < 2e-3); // a spacing is 0.06
    BOOST_TEST(result.conditioning > 1e-3);
    // of the overlap without the spikes nearly all
    std::size_t in_overlap = 0, spikes = 0;
    for(std::size_t k = 0; k < source.size(); ++k)
      in_overlap += source.points[k].x() < .3;
    for(const auto& c : result.inliers)
      spikes += c.source % 10 == 0;
    BOOST_TEST(double(result.inliers.size()) > .8 * double(in_overlap));
    BOOST_TEST(double(result.inliers.size()) < 1.3 * double(in_overlap));
    BOOST_TEST(double(spikes) < .05 * double(result.inliers.size()));
  }
}

BOOST_AUTO_TEST_CASE(noise)
{
  Random random(3);
  Oriented_points source = bumpy_ball(4000), target = bumpy_ball(3500, false, 1.);
  for(auto* points : {&source.points, &target.points})
    for(auto& p : *points)
      for(int k = 0; k < 3; ++k)
        p[k] += .01 * random.gaussian(); // a fifth of the spacing
  const Rigid_alignment result = align(source, target, small_motion(random, .05));
  BOOST_TEST(result.has_converged);
  // The standard deviation of the motion in the direction that the planes hold least: that of a distance over the root of
  // the smallest eigenvalue. The largest one is at least a third of the number of points, the trace of their normals.
  const double deviation = std::sqrt(2.) * .01 / std::sqrt(result.conditioning * double(source.size()) / 3.);
  BOOST_TEST(deviation < 5e-3);
  BOOST_TEST(difference(result, Eigen::Isometry3d::Identity(), source) < 2. * deviation);
  BOOST_TEST(result.residual > .01);
  BOOST_TEST(result.residual < .02);
}

// One step is the least-squares solution of the linear equations that the documentation tells of.
BOOST_AUTO_TEST_CASE(a_step_solves_the_least_squares_problem)
{
  Random random(4);
  std::vector<SC::internal::Plane_distances::Term> terms(100);
  Eigen::MatrixXd matrix(100, 6);
  Eigen::VectorXd right(100);
  for(std::size_t i = 0; i < terms.size(); ++i)
  {
    auto& t = terms[i];
    t.point = random_motion(random, random.uniform(0., 3.)).translation() + Eigen::Vector3d(4., -2., 1.);
    t.normal = random_motion(random, 1.).translation();
    t.distance = 1e-7 * random.gaussian();
    t.weight = i % 7 == 0 ? 0. : random.uniform();
    // point + rotation x point + translation, about the origin
    matrix.row(Eigen::Index(i)) << t.point.cross(t.normal).transpose(), t.normal.transpose();
    matrix.row(Eigen::Index(i)) *= std::sqrt(t.weight);
    right[Eigen::Index(i)] = -std::sqrt(t.weight) * t.distance;
  }
  const Eigen::VectorXd x = test_support::least_squares(matrix, right);
  const SC::internal::Plane_distances planes(terms);
  const Eigen::Isometry3d motion = planes.solve();
  for(const auto& t : terms)
  {
    const Eigen::Vector3d expected =
        Eigen::Vector3d(x.head<3>()).cross(t.point) + Eigen::Vector3d(x.tail<3>());
    BOOST_TEST((motion * t.point - t.point - expected).norm() < 1e-12);
  }
  BOOST_TEST(planes.conditioning() > .01);
  BOOST_TEST(planes.conditioning() < 1.);
}

BOOST_AUTO_TEST_CASE(surfaces_that_slide_on_themselves)
{
  // plane, sphere, cylinder, as two samplings that are apart along the normals
  const auto surface = [](int kind, std::size_t n, double offset)
  {
    Random random(5 + n);
    Oriented_points points;
    for(std::size_t i = 0; i < n; ++i)
    {
      const double u = random.uniform(-1., 1.), v = random.uniform(-1., 1.), angle = CGAL_PI * v;
      const double r = std::sqrt(1. - u * u);
      const Eigen::Vector3d normal =
          kind == 0 ? Eigen::Vector3d(0., 0., 1.)
                    : (kind == 1 ? Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), u)
                                 : Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.));
      points.normals.push_back(normal);
      points.points.push_back(
          kind == 0 ? Eigen::Vector3d(u, v, offset)
                    : (kind == 1 ? normal : Eigen::Vector3d(normal + Eigen::Vector3d(0., 0., u))));
    }
    return points;
  };
  for(const int kind : {0, 1, 2})
  {
    const Oriented_points source = surface(kind, 2000, .02), target = surface(kind, 1900, 0.);
    const Rigid_alignment result = align(source, target, Eigen::Isometry3d::Identity());
    BOOST_TEST(int(result.status) == int(Status::ESTIMATED));
    BOOST_TEST(result.conditioning < 2e-3);
    BOOST_TEST(result.transformation.matrix().allFinite());
    // nothing moves within the surface for long ways
    BOOST_TEST(difference(result, Eigen::Isometry3d::Identity(), source) < .05);
    if(kind == 0)
    {
      BOOST_TEST(result.conditioning < 1e-15);
      Eigen::Isometry3d down = Eigen::Isometry3d::Identity();
      down.translation().z() = -.02;
      BOOST_TEST(difference(result, down, source) < 1e-12);
    }
  }
  // one that doesn't
  const Rigid_alignment firm = align(bumpy_ball(2000), bumpy_ball(1900), Eigen::Isometry3d::Identity());
  BOOST_TEST(firm.conditioning > 5e-3);
}

BOOST_AUTO_TEST_CASE(start_unit_and_side_do_not_count)
{
  Random random(6);
  const Oriented_points source = part(bumpy_ball(2000), 1., -.4),
                        target = part(bumpy_ball(1800, false, 1.), -1., -.4);
  const Eigen::Isometry3d start = small_motion(random, .05);
  const Rigid_alignment expected = align(source, target, start);
  BOOST_TEST(difference(expected, Eigen::Isometry3d::Identity(), source) < 3e-3);

  for(int i = 0; i < 5; ++i)
  {
    const Eigen::Isometry3d before = random_motion(random, 20.), after = random_motion(random, 20.);
    const Rigid_alignment result =
        align(moved(source, before), moved(target, after), after * start * before.inverse());
    BOOST_TEST(difference(after.inverse() * result.transformation * before, expected, source) < 1e-9);
    BOOST_TEST((result.inliers == expected.inliers));
  }
  for(const double scale : {1e-6, 1e6, 1e-100, 1e100})
  {
    Oriented_points p = source, q = target;
    for(auto* points : {&p.points, &q.points})
      for(auto& x : *points)
        x *= scale;
    Eigen::Isometry3d scaled_start = start;
    scaled_start.translation() *= scale;
    const Rigid_alignment result = align(p, q, scaled_start);
    Eigen::Isometry3d motion = result;
    motion.translation() /= scale;
    BOOST_TEST(difference(motion, expected, source) < 1e-9);
    BOOST_TEST(std::abs(result.residual / (scale * expected.residual) - 1.) < 1e-6);
  }
  Oriented_points p = source, q = target;
  for(auto* normals : {&p.normals, &q.normals})
    for(auto& n : *normals)
      n = -n;
  BOOST_TEST((align(p, q, start).transformation.matrix() == expected.transformation.matrix())); // bit for bit
  // one surface seen from inside: no pair has like normals
  check_failure(align(p, target, start), Status::FEW_NEIGHBOURS);

  // the order of the points
  p = source;
  std::reverse(p.points.begin(), p.points.end());
  std::reverse(p.normals.begin(), p.normals.end());
  BOOST_TEST(difference(align(p, target, start), expected, source) < 1e-9);
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Eigen::Isometry3d identity = Eigen::Isometry3d::Identity();
  const Oriented_points points = bumpy_ball(300);
  check_failure(align({}, {}, identity), Status::FEW_NEIGHBOURS);
  check_failure(align(points, {}, identity), Status::FEW_NEIGHBOURS);
  check_failure(align({}, points, identity), Status::FEW_NEIGHBOURS);
  for(const std::size_t n : {1u, 2u, 5u})
    check_failure(align(bumpy_ball(n), points, identity), Status::FEW_NEIGHBOURS);

  Oriented_points bad = points; // points that can't be used are nobody's partner
  bad.points[0].x() = nan;
  bad.points[1].y() = inf;
  bad.normals[2].setConstant(nan);
  bad.normals[3].setZero();
  for(const bool is_source : {false, true})
  {
    const Rigid_alignment result = align(is_source ? bad : points, is_source ? points : bad, identity);
    BOOST_TEST(int(result.status) == int(Status::ESTIMATED));
    BOOST_TEST(difference(result, identity, points) < .01);
    for(const auto& c : result.inliers)
      BOOST_TEST((is_source ? c.source : c.target) >= 4u);
  }
  for(auto& p : bad.points)
    p.setConstant(nan);
  check_failure(align(bad, bad, identity), Status::DEGENERATE);

  bad = points; // all in one point
  for(auto& p : bad.points)
    p = {1., 2., 3.};
  check_failure(align(bad, bad, identity), Status::DEGENERATE);

  bad = points; // so far out that motions would leave the range of numbers
  for(auto& p : bad.points)
    p *= 1e308;
  check_failure(align(bad, bad, identity), Status::DEGENERATE);

  bad = points; // on a line, about which it may turn
  for(std::size_t i = 0; i < bad.size(); ++i)
  {
    bad.points[i] = double(i) * Eigen::Vector3d(1., 0., 0.);
    bad.normals[i] = Eigen::Vector3d(0., 0., 1.);
  }
  const Rigid_alignment line = align(bad, bad, identity);
  BOOST_TEST(line.conditioning < 1e-15);
  BOOST_TEST(difference(line, identity, bad) < 1e-9);

  Eigen::Isometry3d away = identity;
  away.translation().x() = 10.;
  check_failure(align(points, points, away), Status::FEW_NEIGHBOURS);
  away.translation().x() = nan;
  check_failure(align(points, points, away), Status::DEGENERATE);

  bad = points;
  bad.normals.pop_back();
  BOOST_CHECK_THROW(align(bad, points, identity), std::invalid_argument);
  BOOST_CHECK_THROW(align(points, bad, identity), std::invalid_argument);
  bad = points;
  bad.normals[7] *= 2.;
  BOOST_CHECK_THROW(align(bad, points, identity), std::invalid_argument);
  BOOST_CHECK_THROW(align(points, bad, identity), std::invalid_argument);
  Eigen::Isometry3d stretched = identity, mirrored = identity;
  stretched.linear() *= 1.1;
  mirrored.linear()(0, 0) = -1.;
  BOOST_CHECK_THROW(align(points, points, stretched), std::invalid_argument);
  BOOST_CHECK_THROW(align(points, points, mirrored), std::invalid_argument);
  namespace P = SC::parameters;
  BOOST_CHECK_THROW(align(points, points, identity, P::maximum_correspondence_distance(0.)),
                    std::invalid_argument);
  BOOST_CHECK_THROW(align(points, points, identity, P::minimum_normal_cosine(1.)), std::invalid_argument);
  BOOST_CHECK_THROW(align(points, points, identity, P::number_of_iterations(0)), std::invalid_argument);
  // however far points may be apart in the beginning, in the end they may not
  Eigen::Isometry3d near = identity;
  near.translation() = Eigen::Vector3d(.02, -.01, .01);
  for(const double distance : {1., 1e3, 1e300, inf})
  {
    const Rigid_alignment result = align(points, points, near, P::maximum_correspondence_distance(distance));
    BOOST_TEST(result.has_converged);
    BOOST_TEST(difference(result, identity, points) < 1e-6);
  }
  const Rigid_alignment one = align(points, points, identity, P::number_of_iterations(1));
  BOOST_TEST(one.number_of_iterations == 1u);
  BOOST_TEST(!one.has_converged);
}

BOOST_AUTO_TEST_SUITE_END()
