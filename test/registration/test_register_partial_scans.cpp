#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/assess_registration.h>
#include <Shape_characteristics/registration/register_partial_scans.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include "check_names.h"
#include "oriented_point_maps.h"
#include "raise_to.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(register_partial_scans)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Scan = std::vector<test_support::Oriented_point>;
using Result = SC::Registration_result<Kernel>;
using Eigen::Vector3d;
using SC::Registration_obstacle;
using SC::Registration_verdict;

namespace {

const auto maps = test_support::oriented_point_maps();

Result registered(const Scan& source, const Scan& target)
{
  return SC::register_partial_scans<CGAL::Sequential_tag>(source, target, maps, maps);
}

double random_number(std::mt19937& generator) // the library's distributions differ
{
  return double(generator()) / 4294967296.;
}

// A unit ball with bumps and dents that no motion and no reflection brings to itself.
struct Lumpy_ball
{
  static double distance(const Vector3d& d)
  {
    static const double bumps[][5] = {{1, 0, 0, .3, .35},    {0, 1, .3, -.2, .3},    {-.6, .5, .6, .25, .25},
                                      {.2, -.9, .4, .3, .4}, {-.8, -.4, .1, .2, .3}, {.1, .2, -1, -.25, .35},
                                      {.6, .5, .6, .2, .2},  {-.3, .7, -.6, .2, .3}, {.5, -.5, -.7, .25, .3}};
    double r = 1.;
    for(const auto& b : bumps)
    {
      const Vector3d c = Vector3d(b[0], b[1], b[2]).normalized();
      r += b[3] * std::exp(-(d - c).squaredNorm() / (b[4] * b[4]));
    }
    return r;
  }
  static Vector3d point(const Vector3d& d) { return distance(d) * d; }
};

// one whose two sides are mirror images of each other, and nothing else
struct Symmetric_ball
{
  static Vector3d point(const Vector3d& d)
  {
    return Lumpy_ball::distance(Vector3d(std::abs(d.x()), d.y(), d.z())) * d;
  }
};

struct Round_ball
{
  static Vector3d point(const Vector3d& d) { return d; }
};

// Points spread evenly over what `Shape` makes of a sphere, from another place for each seed, where `is_in` says so.
template <typename Shape>
Scan scan_of(std::size_t number, unsigned seed, const std::function<bool(const Vector3d&)>& is_in)
{
  std::mt19937 generator(seed);
  const double phase = random_number(generator), turn = (3. - std::sqrt(5.)) * CGAL_PI;
  Scan scan;
  for(std::size_t i = 0; i < number; ++i)
  {
    const double z = 1. - 2. * (double(i) + .5) / double(number), angle = turn * (double(i) + 100. * phase);
    // jittered, as no two scans have the same pattern
    Vector3d d(std::sqrt(1. - z * z) * std::cos(angle), std::sqrt(1. - z * z) * std::sin(angle), z);
    const double s = .6 / std::sqrt(double(number));
    d += Vector3d(random_number(generator) - .5, random_number(generator) - .5,
                  random_number(generator) - .5) *
         s;
    d.normalize();
    const Vector3d u = d.unitOrthogonal(), v = d.cross(u);
    constexpr double h = 1e-5;
    const Vector3d p = Shape::point(d), pu = Shape::point((d + h * u).normalized()) - p,
                   pv = Shape::point((d + h * v).normalized()) - p, n = pu.cross(pv).normalized();
    if(is_in(p))
      scan.emplace_back(Point(p.x(), p.y(), p.z()), Vector(n.x(), n.y(), n.z()));
  }
  return scan;
}

bool all(const Vector3d&)
{
  return true;
}

Scan left_part(unsigned seed)
{
  return scan_of<Lumpy_ball>(2600, seed, [](const Vector3d& p) { return p.x() + .2 * p.y() < .45; });
}

Scan right_part(unsigned seed)
{
  return scan_of<Lumpy_ball>(2600, seed, [](const Vector3d& p) { return p.x() + .2 * p.y() > -.45; });
}

Vector3d to_eigen(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}

Scan moved(const Scan& scan, const Eigen::Affine3d& motion)
{
  const Eigen::Matrix3d linear = motion.linear() / std::cbrt(std::abs(motion.linear().determinant()));
  Scan result;
  for(const auto& [p, n] : scan)
  {
    const Vector3d q = motion * to_eigen(p), m = linear * Vector3d(n.x(), n.y(), n.z());
    result.emplace_back(Point(q.x(), q.y(), q.z()), Vector(m.x(), m.y(), m.z()));
  }
  return result;
}

Eigen::Affine3d some_motion()
{
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.linear() = Eigen::AngleAxisd(2.1, Vector3d(1, -2, .5).normalized()).toRotationMatrix();
  motion.translation() = Vector3d(3, -1, 2);
  return motion;
}

Eigen::Affine3d to_eigen(const CGAL::Aff_transformation_3<Kernel>& transformation)
{
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  for(int row = 0; row < 3; ++row)
    for(int column = 0; column < 4; ++column)
      motion.matrix()(row, column) = transformation.m(row, column);
  return motion;
}

// the largest distance of a point from its place
double error(const Scan& scan, const CGAL::Aff_transformation_3<Kernel>& found, const Eigen::Affine3d& right)
{
  double largest = 0.;
  for(const auto& [p, n] : scan)
    test_support::raise_to(largest, (to_eigen(p.transform(found)) - right * to_eigen(p)).norm());
  return largest;
}

// of unit size, with points on the faces of a box
Scan box(const Vector3d& size, std::size_t per_edge, unsigned seed)
{
  std::mt19937 generator(seed);
  Scan scan;
  for(int axis = 0; axis < 3; ++axis)
    for(const double side : {-.5, .5})
      for(std::size_t i = 0; i < per_edge; ++i)
        for(std::size_t j = 0; j < per_edge; ++j)
        {
          Vector3d p, n = Vector3d::Zero();
          p[axis] = side;
          p[(axis + 1) % 3] = (double(i) + random_number(generator)) / double(per_edge) - .5;
          p[(axis + 2) % 3] = (double(j) + random_number(generator)) / double(per_edge) - .5;
          n[axis] = side < 0. ? -1. : 1.;
          p = p.cwiseProduct(size);
          scan.emplace_back(Point(p.x(), p.y(), p.z()), Vector(n.x(), n.y(), n.z()));
        }
  return scan;
}

// of radius 1, open at both ends
Scan cylinder(std::size_t around, std::size_t along, double height, unsigned seed)
{
  std::mt19937 generator(seed);
  Scan scan;
  for(std::size_t i = 0; i < around; ++i)
    for(std::size_t j = 0; j < along; ++j)
    {
      const double angle = 2. * CGAL_PI * (double(i) + random_number(generator)) / double(around);
      const double z = height * (double(j) + random_number(generator)) / double(along);
      scan.emplace_back(Point(std::cos(angle), std::sin(angle), z),
                        Vector(std::cos(angle), std::sin(angle), 0));
    }
  return scan;
}

Scan plane(std::size_t per_edge, unsigned seed)
{
  std::mt19937 generator(seed);
  Scan scan;
  for(std::size_t i = 0; i < per_edge; ++i)
    for(std::size_t j = 0; j < per_edge; ++j)
      scan.emplace_back(Point((double(i) + random_number(generator)) / double(per_edge),
                              (double(j) + random_number(generator)) / double(per_edge), 0),
                        Vector(0, 0, 1));
  return scan;
}

// A building that comes with CGAL, each second point of it; empty if it isn't there.
Scan building(std::size_t first)
{
  std::ifstream file(SHAPE_CHARACTERISTICS_DATA_DIR "/points_3/building.ply");
  for(std::string line; std::getline(file, line) && line != "end_header";)
    ;
  Scan scan;
  double x, y, z, nx, ny, nz, segment;
  for(std::size_t i = 0; file >> x >> y >> z >> nx >> ny >> nz >> segment; ++i)
    if(i % 2 == first)
      scan.emplace_back(Point(x, y, z), Vector(nx, ny, nz));
  return scan;
}

Scan part_of(const Scan& scan, const std::function<bool(const Point&)>& is_in)
{
  Scan part;
  std::copy_if(scan.begin(), scan.end(), std::back_inserter(part),
               [&](const Scan::value_type& p) { return is_in(p.first); });
  return part;
}

} // namespace

BOOST_AUTO_TEST_CASE(two_parts)
{
  const Scan target = left_part(1), source = moved(right_part(2), some_motion());
  const Eigen::Affine3d right = some_motion().inverse();
  const Result result = registered(source, target);
  BOOST_TEST(int(result.verdict) == int(Registration_verdict::SUCCESS));
  BOOST_TEST(int(result.obstacle) == int(Registration_obstacle::NONE));
  BOOST_TEST(result.confidence > .9);
  BOOST_TEST(result.scale_ratio == 1.);
  BOOST_TEST(result.alternatives.empty());
  BOOST_TEST(result.quality.agreement > .6);
  BOOST_TEST(result.quality.overlap > .3);
  BOOST_TEST(result.quality.overlap < .8);
  BOOST_TEST(error(source, result.transformation, right) < .02);

  // by hand
  SC::Oriented_points s, t;
  for(const auto& [scan, points] : {std::make_pair(&source, &s), std::make_pair(&target, &t)})
    for(const auto& [p, n] : *scan)
    {
      points->points.push_back(to_eigen(p));
      points->normals.push_back({n.x(), n.y(), n.z()});
    }
  const SC::Registration_quality quality =
      SC::assess_registration(s, t, Eigen::Isometry3d(to_eigen(result.transformation).matrix()));
  BOOST_TEST(quality.agreement == result.quality.agreement, boost::test_tools::tolerance(.02));
  BOOST_TEST(quality.curvature_correlation > .5);
  BOOST_TEST(quality.curvature_correlation < 1.);
  BOOST_TEST(quality.opposition < .01);
  BOOST_TEST(quality.penetration < .2);
  const SC::Registration_quality wrong = SC::assess_registration(s, t, Eigen::Isometry3d::Identity());
  BOOST_TEST(wrong.agreement < .2);
  const SC::Registration_quality same = SC::assess_registration(t, t, Eigen::Isometry3d::Identity());
  BOOST_TEST(same.agreement == 1.);
  BOOST_TEST(std::abs(same.curvature_correlation - 1.) < 1e-12);
  const SC::Registration_quality none = SC::assess_registration(
      s, t, Eigen::Isometry3d(Eigen::Matrix4d::Constant(std::numeric_limits<double>::quiet_NaN())));
  BOOST_TEST(none.number_of_near_points == 0u);
  BOOST_TEST(none.expected_agreement == quality.expected_agreement);

  Eigen::Isometry3d stretched = Eigen::Isometry3d::Identity();
  stretched.linear() *= 2.;
  BOOST_CHECK_THROW(SC::assess_registration(s, t, stretched), std::invalid_argument);
  SC::Oriented_points bad = t;
  bad.normals[0] *= 2.;
  BOOST_CHECK_THROW(SC::assess_registration(s, bad, Eigen::Isometry3d::Identity()), std::invalid_argument);
  bad.normals.pop_back();
  BOOST_CHECK_THROW(SC::assess_registration(s, bad, Eigen::Isometry3d::Identity()), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(units_and_places)
{
  const Scan target = left_part(1), source = right_part(2);
  const Eigen::Affine3d moved_by = some_motion();
  const Result reference = registered(moved(source, moved_by), target);
  for(const double scale : {1e-6, 1e6})
  {
    const Eigen::Affine3d scaling(Eigen::Scaling(scale));
    const Scan s = moved(source, scaling * moved_by), t = moved(target, scaling);
    const Result result = registered(s, t);
    BOOST_TEST(int(result.verdict) == int(reference.verdict));
    BOOST_TEST(error(s, result.transformation,
                     scaling * to_eigen(reference.transformation) * scaling.inverse()) < 1e-6 * scale);
  }
  // lengths whose squares are out of the range of numbers, or nearly they themselves
  for(const double unit : {0x1p-900, 0x1p900, 0x1p1021})
  {
    Scan s = moved(source, moved_by), t = target;
    for(Scan* const scan : {&s, &t})
      for(auto& [p, n] : *scan)
        p = Point(unit * p.x(), unit * p.y(), unit * p.z());
    const Result result = registered(s, t);
    BOOST_TEST(int(result.verdict) == int(reference.verdict));
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 4; ++j)
        BOOST_TEST(result.transformation.m(i, j) == (j < 3 ? 1. : unit) * reference.transformation.m(i, j),
                   boost::test_tools::tolerance(1e-9));
  }
  // so far from each other that no number says how far
  Scan on_the_left = source, on_the_right = source;
  for(auto& [p, n] : on_the_left)
    p = Point(1e306 * p.x() - 1.5e308, 1e306 * p.y(), 1e306 * p.z());
  for(auto& [p, n] : on_the_right)
    p = Point(1e306 * p.x() + 1.5e308, 1e306 * p.y(), 1e306 * p.z());
  const Result beyond = registered(on_the_left, on_the_right);
  BOOST_TEST(int(beyond.verdict) == int(Registration_verdict::FAILED));
  BOOST_TEST(to_eigen(beyond.transformation).matrix().allFinite());
  // far away, as coordinates of maps are
  Eigen::Affine3d away = Eigen::Affine3d::Identity();
  away.translation() = Vector3d(5e5, 5e6, 300.);
  const Scan s = moved(source, moved_by), t = moved(target, away);
  const Result result = registered(s, t);
  BOOST_TEST(int(result.verdict) == int(Registration_verdict::SUCCESS));
  BOOST_TEST(error(s, result.transformation, away * to_eigen(reference.transformation)) < 1e-5);
}

BOOST_AUTO_TEST_CASE(starts_and_seeds)
{
  const Scan target = left_part(1), source = right_part(2);
  const Result reference = registered(moved(source, some_motion()), target);
  BOOST_TEST(int(reference.verdict) == int(Registration_verdict::SUCCESS));
  const Eigen::Affine3d right = to_eigen(reference.transformation) * some_motion();
  for(const double angle : {0., 1.5, 3.})
  {
    Eigen::Affine3d start(Eigen::AngleAxisd(angle, Vector3d(1., -2., .5).normalized()));
    start.translation() = Vector3d(3. * angle, -1., 2.);
    const Scan s = moved(source, start);
    for(const int seed : {0, 7, 123456})
    {
      const Result result =
          SC::register_partial_scans<CGAL::Sequential_tag>(s, target, maps.random_seed(seed), maps);
      BOOST_TEST(int(result.verdict) == int(Registration_verdict::SUCCESS));
      BOOST_TEST(error(s, result.transformation, right * start.inverse()) < 1e-6);
    }
  }
}

// One plane beneath the other by a spacing: the points of one are beneath, those of the other are not. The source is
// denser, so that it can be told which.
BOOST_AUTO_TEST_CASE(planes_beneath_each_other)
{
  for(const double unit : {1., 0x1p-900, 0x1p900})
  {
    const auto grid = [&](const int per_edge, const double spacing)
    {
      SC::Oriented_points points;
      for(int i = 0; i < per_edge; ++i)
        for(int j = 0; j < per_edge; ++j)
        {
          points.points.push_back({unit * spacing * i, unit * spacing * j, 0.});
          points.normals.push_back({0., 0., 1.});
        }
      return points;
    };
    const SC::Oriented_points source = grid(59, .5), target = grid(30, 1.);
    const double share_of_source = double(source.size()) / double(source.size() + target.size());
    for(const auto& [height, penetration] : std::vector<std::pair<double, double> >{
            {-1., share_of_source}, {-.1, 0.}, {0., 0.}, {.1, 0.}, {1., 1. - share_of_source}})
    {
      const SC::Registration_quality quality = SC::assess_registration(
          source, target, Eigen::Isometry3d(Eigen::Translation3d(0., 0., unit * height)));
      BOOST_TEST(quality.overlap == 1.);
      BOOST_TEST(quality.penetration == penetration, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(quality.agreement == (std::abs(height) < .5 ? 1. : 0.));
      BOOST_TEST(quality.opposition == 0.);
    }
  }
}

// Facades look alike turned by half a turn or moved by a window: right, or no success.
BOOST_AUTO_TEST_CASE(parts_of_a_building)
{
  const Scan first = building(0), second = building(1);
  if(first.empty())
  {
    BOOST_TEST_MESSAGE("skipped: the data of CGAL isn't there");
    return;
  }
  double low = HUGE_VAL, high = -HUGE_VAL;
  for(const auto& [p, n] : first)
  {
    low = (std::min)(low, p.y());
    high = (std::max)(high, p.y());
  }
  for(const double overlap : {.3, .1})
  {
    const double end = low + (.5 + overlap / 2.) * (high - low),
                 begin = low + (.5 - overlap / 2.) * (high - low);
    const Scan target = part_of(first, [&](const Point& p) { return p.y() < end; });
    const Scan source = moved(part_of(second, [&](const Point& p) { return p.y() > begin; }), some_motion());
    const Result result = registered(source, target);
    const double distance = error(source, result.transformation, some_motion().inverse());
    BOOST_TEST((result.verdict != Registration_verdict::SUCCESS || distance < .02 * (high - low)));
    if(overlap > .2)
    {
      BOOST_TEST(int(result.verdict) == int(Registration_verdict::SUCCESS));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_same_scan_twice)
{
  const Scan scan = left_part(1);
  const Result result = registered(scan, scan);
  BOOST_TEST(int(result.verdict) == int(Registration_verdict::SUCCESS));
  BOOST_TEST(error(scan, result.transformation, Eigen::Affine3d::Identity()) < 1e-12);
  BOOST_TEST(result.quality.agreement == 1.);
  BOOST_TEST(result.quality.overlap == 1.);
  BOOST_TEST(result.confidence == 1.);
}

BOOST_AUTO_TEST_CASE(more_points_than_are_used)
{
  const Scan target = left_part(1), source = moved(right_part(2), some_motion());
  const Result result = SC::register_partial_scans<CGAL::Sequential_tag>(
      source, target, maps.maximum_number_of_samples(900).number_of_neighbors(40), maps);
  BOOST_TEST(int(result.verdict) == int(Registration_verdict::SUCCESS));
  BOOST_TEST(error(source, result.transformation, some_motion().inverse()) < .05);

  // one three times as dense as the other
  const Scan dense = scan_of<Lumpy_ball>(7800, 3, [](const Vector3d& p) { return p.x() < .45; });
  const Result other = registered(source, dense);
  BOOST_TEST(int(other.verdict) == int(Registration_verdict::SUCCESS));
  BOOST_TEST(error(source, other.transformation, some_motion().inverse()) < .03);
}

// Which points are kept, and how sums are rounded, has nothing to do with their order.
BOOST_AUTO_TEST_CASE(order_of_the_points)
{
  Scan target = left_part(1), source = moved(right_part(2), some_motion());
  const auto result_of = [&]
  {
    return SC::register_partial_scans<CGAL::Sequential_tag>(source, target,
                                                            maps.maximum_number_of_samples(900), maps);
  };
  const Result expected = result_of();
  BOOST_TEST(int(expected.verdict) == int(Registration_verdict::SUCCESS));
  std::mt19937 generator(5);
  for(Scan* scan : {&source, &target})
    for(std::size_t i = scan->size() - 1; i > 0; --i)
      std::swap((*scan)[i], (*scan)[generator() % (i + 1)]);
  const Result result = result_of();
  BOOST_TEST(int(result.verdict) == int(expected.verdict));
  BOOST_TEST((to_eigen(result.transformation).matrix() == to_eigen(expected.transformation).matrix()));
  BOOST_TEST(result.quality.agreement == expected.quality.agreement);
}

BOOST_AUTO_TEST_CASE(no_overlap)
{
  const Scan target = scan_of<Lumpy_ball>(2600, 1, [](const Vector3d& p) { return p.x() < -.1; });
  const Scan source = scan_of<Lumpy_ball>(2600, 2, [](const Vector3d& p) { return p.x() > .1; });
  const Result result = registered(source, target);
  BOOST_TEST(int(result.verdict) == int(Registration_verdict::FAILED));
  BOOST_TEST(int(result.obstacle) != int(Registration_obstacle::NONE));
  BOOST_TEST(result.confidence == 0.);
}

BOOST_AUTO_TEST_CASE(few_points)
{
  const Scan scan = left_part(1);
  for(const std::size_t n : {0, 1, 2, 9})
  {
    const Scan few(scan.begin(), scan.begin() + std::ptrdiff_t(n));
    for(const Result& result : {registered(few, scan), registered(scan, few), registered(few, few)})
    {
      BOOST_TEST(int(result.verdict) == int(Registration_verdict::FAILED));
      BOOST_TEST(int(result.obstacle) == int(Registration_obstacle::FEW_SAMPLES));
    }
  }
  const Scan copies(100, scan.front());
  BOOST_TEST(int(registered(copies, copies).verdict) == int(Registration_verdict::FAILED));
  Scan line;
  for(int i = 0; i < 200; ++i)
    line.emplace_back(Point(i, 0, 0), Vector(0, 0, 1));
  BOOST_TEST(int(registered(line, line).verdict) != int(Registration_verdict::SUCCESS));
}

BOOST_AUTO_TEST_CASE(points_that_are_none)
{
  const Scan target = left_part(1);
  Scan source = moved(right_part(2), some_motion());
  const Result reference = registered(source, target);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  source.emplace_back(Point(nan, 0, 0), Vector(0, 0, 1));
  source.emplace_back(Point(0, inf, 0), Vector(0, 0, 1));
  source.emplace_back(Point(0, 0, 0), Vector(0, 0, 0));
  source.emplace_back(Point(0, 0, 0), Vector(nan, 0, 0));
  const Result result = registered(source, target);
  for(int row = 0; row < 3; ++row)
    for(int column = 0; column < 4; ++column)
      BOOST_TEST(result.transformation.m(row, column) == reference.transformation.m(row, column));
}

BOOST_AUTO_TEST_CASE(objects_without_features)
{
  const Eigen::Affine3d motion = some_motion();
  const auto is_ambiguous = [&](const Scan& source, const Scan& target, Registration_obstacle obstacle)
  {
    const Result result = registered(moved(source, motion), target);
    BOOST_TEST(int(result.verdict) == int(Registration_verdict::AMBIGUOUS));
    BOOST_TEST(int(result.obstacle) == int(obstacle));
    BOOST_TEST(!result.alternatives.empty());
    for(const Result::Candidate& c : result.alternatives)
    {
      BOOST_TEST(c.quality.agreement > .25);
      BOOST_TEST(error(moved(source, motion), c.transformation, to_eigen(result.transformation)) > .1);
    }
  };
  BOOST_TEST_CONTEXT("ball")
  is_ambiguous(scan_of<Round_ball>(1500, 1, all), scan_of<Round_ball>(1500, 2, all),
               Registration_obstacle::SLIDING);
  BOOST_TEST_CONTEXT("plane")
  is_ambiguous(plane(35, 1), plane(35, 2), Registration_obstacle::SLIDING);
  BOOST_TEST_CONTEXT("cylinder")
  is_ambiguous(cylinder(70, 25, 2.2, 1), cylinder(70, 25, 2.2, 2), Registration_obstacle::SLIDING);
  BOOST_TEST_CONTEXT("cube")
  is_ambiguous(box({1, 1, 1}, 18, 1), box({1, 1, 1}, 18, 2), Registration_obstacle::SEVERAL_MOTIONS);
}

BOOST_AUTO_TEST_CASE(mirrored_object)
{
  const Scan target = left_part(1);
  const Eigen::Affine3d mirror = some_motion() * Eigen::Scaling(1., 1., -1.);
  const Scan source = moved(right_part(2), mirror);
  const Result result = registered(source, target);
  BOOST_TEST(int(result.verdict) == int(Registration_verdict::AMBIGUOUS));
  BOOST_TEST(int(result.obstacle) == int(Registration_obstacle::REFLECTION));
  BOOST_TEST(result.confidence == 0.);
  BOOST_TEST(result.alternatives.size() == 1u);
  BOOST_TEST(result.alternatives.at(0).is_reflection);
  BOOST_TEST(error(source, result.alternatives.at(0).transformation, mirror.inverse()) < .02);
}

BOOST_AUTO_TEST_CASE(sides_of_a_symmetric_object)
{
  for(const double least : {0., .05})
    BOOST_TEST_CONTEXT("more than " << least << " from the plane of symmetry")
    {
      const Scan target = scan_of<Symmetric_ball>(4000, 1, [=](const Vector3d& p) { return p.x() < -least; });
      const Scan source = moved(
          scan_of<Symmetric_ball>(4000, 2, [=](const Vector3d& p) { return p.x() > least; }), some_motion());
      const Result result = registered(source, target);
      BOOST_TEST(int(result.verdict) == int(Registration_verdict::AMBIGUOUS));
      BOOST_TEST(int(result.obstacle) == int(Registration_obstacle::REFLECTION));
      BOOST_TEST_REQUIRE(!result.alternatives.empty());
      BOOST_TEST(result.alternatives[0].is_reflection);
      const Eigen::Affine3d mirror = Eigen::Scaling(-1., 1., 1.) * some_motion().inverse();
      BOOST_TEST(error(source, result.alternatives[0].transformation, mirror) < .02);
    }
}

BOOST_AUTO_TEST_CASE(other_units)
{
  const Scan target = scan_of<Lumpy_ball>(2600, 1, all);
  const Eigen::Affine3d motion = some_motion() * Eigen::Scaling(1000.);
  const Scan source = moved(scan_of<Lumpy_ball>(2600, 2, all), motion);
  const Result result = registered(source, target);
  BOOST_TEST(int(result.verdict) == int(Registration_verdict::FAILED));
  BOOST_TEST(int(result.obstacle) == int(Registration_obstacle::DIFFERENT_UNITS));
  BOOST_TEST(result.scale_ratio == 1000., boost::test_tools::tolerance(.02));
  BOOST_TEST(error(source, result.transformation, motion.inverse()) < .05);

  // of another size because they are other surfaces: there are enough points, if the unit is another
  const Scan left = scan_of<Lumpy_ball>(2600, 1, [](const Vector3d& p) { return p.x() < -.3; });
  const Scan right = scan_of<Lumpy_ball>(2600, 2, [](const Vector3d& p) { return p.x() > .3; });
  const Result unrelated = registered(moved(right, some_motion() * Eigen::Scaling(30.)), left);
  BOOST_TEST(int(unrelated.verdict) == int(Registration_verdict::FAILED));
  BOOST_TEST((unrelated.obstacle == Registration_obstacle::FEW_CORRESPONDENCES ||
              unrelated.obstacle == Registration_obstacle::SURFACES_DISAGREE));
}

BOOST_AUTO_TEST_CASE(wrong_parameters)
{
  const Scan scan = left_part(1);
  BOOST_CHECK_THROW(
      SC::register_partial_scans<CGAL::Sequential_tag>(scan, scan, maps.number_of_neighbors(7), maps),
      std::invalid_argument);
  BOOST_CHECK_THROW(
      SC::register_partial_scans<CGAL::Sequential_tag>(scan, scan, maps.maximum_number_of_samples(99), maps),
      std::invalid_argument);
  std::vector<double> advancement;
  const std::function<bool(double)> callback = [&](const double done)
  {
    advancement.push_back(done);
    return false;
  };
  const Result result =
      SC::register_partial_scans<CGAL::Sequential_tag>(scan, scan, maps.callback(callback), maps);
  BOOST_TEST(int(result.verdict) == int(Registration_verdict::FAILED));
  BOOST_TEST(int(result.obstacle) == int(Registration_obstacle::CANCELLED));
  BOOST_TEST(advancement.size() == 1u);
}

// Whatever is searched for, `false` is the last word, and the advancement never goes back.
BOOST_AUTO_TEST_CASE(cancelled_at_any_time)
{
  const Eigen::Affine3d motion = some_motion() * Eigen::Scaling(10., 10., -10.);
  const Scan target = left_part(1), source = moved(right_part(2), motion); // mirrored, and in other units
  std::size_t limit = 0;
  std::vector<double> advancement;
  const std::function<bool(double)> callback = [&](const double done)
  {
    advancement.push_back(done);
    return advancement.size() != limit;
  };
  const auto search = [&](const std::size_t calls)
  {
    limit = calls;
    advancement.clear();
    return SC::register_partial_scans<CGAL::Sequential_tag>(source, target, maps.callback(callback), maps);
  };
  const auto check_advancement = [&]
  {
    BOOST_TEST_REQUIRE(advancement.size() > 5u);
    BOOST_TEST(std::is_sorted(advancement.begin(), advancement.end()));
    BOOST_TEST(advancement.front() == 0.);
    BOOST_TEST(advancement.back() == 1.);
  };
  // where the first try does
  BOOST_TEST(int(SC::register_partial_scans<CGAL::Sequential_tag>(right_part(2), target,
                                                                  maps.callback(callback), maps)
                     .verdict) == int(Registration_verdict::SUCCESS));
  check_advancement();
  search(0); // to the end
  check_advancement();
  const std::size_t all = advancement.size();
  for(const std::size_t calls : {std::size_t(1), std::size_t(2), all / 2, all - 1, all})
  {
    const Result result = search(calls);
    BOOST_TEST(int(result.verdict) == int(Registration_verdict::FAILED));
    BOOST_TEST(int(result.obstacle) == int(Registration_obstacle::CANCELLED));
    BOOST_TEST(advancement.size() == calls);
  }
}

BOOST_AUTO_TEST_CASE(every_verdict_and_obstacle_has_its_name)
{
  test_support::check_names<Registration_verdict>({"SUCCESS", "AMBIGUOUS", "FAILED"});
  test_support::check_names<Registration_obstacle>({"NONE", "FEW_SAMPLES", "CANCELLED", "FEW_CORRESPONDENCES",
                                                    "SURFACES_DISAGREE", "DIFFERENT_UNITS", "REFLECTION",
                                                    "SLIDING", "SEVERAL_MOTIONS"});
}

BOOST_AUTO_TEST_SUITE_END()
