#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/registration/match_descriptors.h>
#include <Shape_characteristics/registration/tuple_test.h>

#include "bumpy_ball.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(matching)

namespace SC = Shape_characteristics;
using SC::Correspondence;
using SC::Descriptor_matrix;
using SC::Oriented_points;
using test_support::bumpy_ball;
using test_support::moved;
using test_support::Random;
using test_support::random_motion;
using Correspondences = std::vector<Correspondence>;
using Status = SC::Estimation_status;

namespace {

template <typename Function>
Descriptor_matrix make_matrix(std::size_t rows, std::size_t columns, const Function& value)
{
  Descriptor_matrix result;
  result.values.resize(Eigen::Index(rows), Eigen::Index(columns));
  for(Eigen::Index i = 0; i < result.values.rows(); ++i)
    for(Eigen::Index k = 0; k < result.values.cols(); ++k)
      result.values(i, k) = float(value());
  result.status.assign(rows, Status::ESTIMATED);
  return result;
}

long double
plain_distance(const Descriptor_matrix& a, std::size_t i, const Descriptor_matrix& b, std::size_t j)
{
  long double sum = 0;
  for(Eigen::Index k = 0; k < a.values.cols(); ++k)
  {
    const long double d = (long double)a.values(Eigen::Index(i), k) - b.values(Eigen::Index(j), k);
    sum += d * d;
  }
  return sum;
}

bool has_descriptor(const Descriptor_matrix& a, std::size_t i)
{
  return SC::is_estimated(a.status[i]) && a.values.row(Eigen::Index(i)).allFinite();
}

// for each row of `a` the first of the nearest rows of `b`, or its number of rows
std::vector<std::size_t> plain_neighbors(const Descriptor_matrix& a, const Descriptor_matrix& b)
{
  std::vector<std::size_t> result(a.status.size(), b.status.size());
  for(std::size_t i = 0; i < a.status.size(); ++i)
    if(has_descriptor(a, i))
    {
      long double least = std::numeric_limits<long double>::infinity();
      for(std::size_t j = 0; j < b.status.size(); ++j)
        if(has_descriptor(b, j))
          if(const long double d = plain_distance(a, i, b, j); d < least)
          {
            least = d;
            result[i] = j;
          }
    }
  return result;
}

Correspondences plain_matches(const Descriptor_matrix& a, const Descriptor_matrix& b)
{
  const auto of_a = plain_neighbors(a, b), of_b = plain_neighbors(b, a);
  Correspondences result;
  for(std::size_t i = 0; i < of_a.size(); ++i)
    if(of_a[i] < b.status.size() && of_b[of_a[i]] == i)
      result.push_back({std::uint32_t(i), std::uint32_t(of_a[i])});
  return result;
}

void check_matches(const Descriptor_matrix& a, const Descriptor_matrix& b)
{
  const Correspondences expected = plain_matches(a, b);
  BOOST_TEST((SC::match_descriptors<CGAL::Sequential_tag>(a, b) == expected));
  BOOST_TEST((SC::match_descriptors(a, b) == expected));

  // with vectors of every size, all neighbors are those of the plain search
  const auto of_a = plain_neighbors(a, b), of_b = plain_neighbors(b, a);
  for(const std::size_t panel : {2u, 8u, 16u, 32u})
  {
    SC::internal::Descriptor_matcher matcher(a, b, panel);
    matcher.run<CGAL::Sequential_tag>();
    if(matcher.source_rows().empty() || matcher.target_rows().empty())
      continue;
    std::size_t wrong = 0;
    for(std::size_t i = 0; i < matcher.source_rows().size(); ++i)
      wrong += matcher.of_source()[i].row != of_a[matcher.source_rows()[i]];
    for(std::size_t j = 0; j < matcher.target_rows().size(); ++j)
      wrong += matcher.of_target()[j].row != of_b[matcher.target_rows()[j]];
    BOOST_TEST(wrong == 0u, "panels of " << panel << ": " << wrong << " wrong neighbors");
  }
}

// the source and the target of the test of tuples, and correspondences of each point with itself
struct Scene
{
  Oriented_points source, target;
  Correspondences correspondences;
};

Scene make_scene(std::size_t n, double scale, std::uint64_t seed)
{
  Random random(seed);
  Scene scene;
  scene.source = bumpy_ball(n);
  for(auto& p : scene.source.points)
    p *= scale;
  scene.target = moved(scene.source, random_motion(random, 5. * scale));
  for(std::uint32_t i = 0; i < n; ++i)
    scene.correspondences.push_back({i, i});
  return scene;
}

// of every second correspondence the target is drawn at random
void add_wrong(Scene& scene, std::uint64_t seed)
{
  Random random(seed);
  for(std::size_t i = 0; i < scene.correspondences.size(); i += 2)
    scene.correspondences[i].target = std::uint32_t(random.uniform() * double(scene.target.size()));
}

// what the documentation says of a triple
struct Plain_tuple_test
{
  long double similarity = .95L, tolerance = .3L;

  using Vector = Eigen::Matrix<long double, 3, 1>;
  static Vector cast(const Eigen::Vector3d& v) { return v.cast<long double>(); }

  bool lengths(const Scene& s, const Correspondence* c) const
  {
    for(int i = 0; i < 3; ++i)
    {
      const auto &a = c[i], &b = c[(i + 1) % 3];
      const long double d = (cast(s.source.points[a.source]) - cast(s.source.points[b.source])).norm();
      const long double e = (cast(s.target.points[a.target]) - cast(s.target.points[b.target])).norm();
      if(!(std::min(d, e) > similarity * std::max(d, e)))
        return false;
    }
    return true;
  }
  static long double volume(const Oriented_points& points, std::uint32_t i, std::uint32_t j, std::uint32_t k)
  {
    const Vector u = (cast(points.points[j]) - cast(points.points[i])).normalized(),
                 v = (cast(points.points[k]) - cast(points.points[i])).normalized();
    return (cast(points.normals[i]) + cast(points.normals[j]) + cast(points.normals[k])).dot(u.cross(v)) / 3;
  }
  bool orientation(const Scene& s, const Correspondence* c) const
  {
    const long double a = volume(s.source, c[0].source, c[1].source, c[2].source),
                      b = volume(s.target, c[0].target, c[1].target, c[2].target);
    return a * b > 0 || (std::abs(a) < .05L && std::abs(b) < .05L);
  }
  static std::vector<long double> angles(const Oriented_points& points, std::uint32_t i, std::uint32_t j)
  {
    const Vector d = (cast(points.points[j]) - cast(points.points[i])).normalized(),
                 m = cast(points.normals[i]), n = cast(points.normals[j]);
    return {m.dot(n), m.dot(d), n.dot(d), d.dot(m.cross(n))};
  }
  bool normals(const Scene& s, const Correspondence* c) const
  {
    for(int i = 0; i < 3; ++i)
    {
      const auto &a = c[i], &b = c[(i + 1) % 3];
      const auto x = angles(s.source, a.source, b.source), y = angles(s.target, a.target, b.target);
      for(std::size_t k = 0; k < 4; ++k)
        if(std::abs(x[k] - y[k]) > tolerance)
          return false;
    }
    return true;
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(neighbors_are_those_of_the_plain_search)
{
  Random random(1);
  const auto uniform = [&] { return random.uniform(); };
  // sizes around those of groups, panels and blocks
  for(const auto& [n, m] : std::vector<std::pair<std::size_t, std::size_t>>{
          {1, 1}, {3, 40}, {40, 3}, {64, 64}, {255, 33}, {257, 31}, {515, 100}})
    for(const std::size_t d : {1u, 7u, 33u})
      check_matches(make_matrix(n, d, uniform), make_matrix(m, d, uniform));
  check_matches(make_matrix(300, 352, uniform), make_matrix(90, 352, uniform));
}

BOOST_AUTO_TEST_CASE(of_equal_distances_the_first_row_counts)
{
  Random random(2);
  const auto small_integer = [&] { return std::floor(3. * random.uniform()); };
  for(const std::size_t d : {1u, 2u, 5u})
    check_matches(make_matrix(600, d, small_integer), make_matrix(300, d, small_integer));
  const auto constant = [] { return .1; };
  check_matches(make_matrix(300, 33, constant), make_matrix(70, 33, constant));
  BOOST_TEST((SC::match_descriptors(make_matrix(300, 33, constant), make_matrix(70, 33, constant)) ==
              Correspondences{{0, 0}}));
}

// as of planes and spheres
BOOST_AUTO_TEST_CASE(descriptors_that_are_all_the_same)
{
  for(const double value : {0., 1., 1e30})
    check_matches(make_matrix(40, 33, [&] { return value; }), make_matrix(50, 33, [&] { return value; }));
}

BOOST_AUTO_TEST_CASE(numbers_of_every_size)
{
  Random random(3);
  for(const double scale : {1e-38, 1e-30, 1e-20, 1e-6, 1e6, 1e20, 3e38})
  {
    const auto value = [&] { return scale * random.uniform(); };
    check_matches(make_matrix(100, 5, value), make_matrix(120, 5, value));
  }
  // differences of a few units in the last place
  const auto offset = [&] { return 1e6 + 2. * random.uniform(); };
  check_matches(make_matrix(200, 3, offset), make_matrix(120, 3, offset));
  // and all of them in one matrix
  const auto any = [&] { return std::pow(10., random.uniform(-38., 38.)); };
  check_matches(make_matrix(200, 3, any), make_matrix(120, 3, any));
}

BOOST_AUTO_TEST_CASE(rows_without_a_descriptor_have_no_partner)
{
  Random random(4);
  const auto uniform = [&] { return random.uniform(); };
  Descriptor_matrix a = make_matrix(120, 4, uniform), b = make_matrix(90, 4, uniform);
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  a.status[3] = Status::FEW_NEIGHBOURS;
  a.status[4] = Status::BORDER; // has one
  a.values(5, 3) = nan;
  b.values(7, 0) = inf;
  b.status[8] = Status::NON_FINITE_INPUT;
  b.values.row(8).setConstant(nan);
  check_matches(a, b);
  for(auto& s : b.status)
    s = Status::DEGENERATE;
  BOOST_TEST(SC::match_descriptors(a, b).empty());
  BOOST_TEST(SC::match_descriptors(b, a).empty());
  BOOST_TEST(SC::match_descriptors(Descriptor_matrix(), a).empty());
  BOOST_TEST(SC::match_descriptors(a, Descriptor_matrix()).empty());
  BOOST_TEST(SC::match_descriptors(Descriptor_matrix(), Descriptor_matrix()).empty());
}

BOOST_AUTO_TEST_CASE(samples_of_the_rows)
{
  Random random(5);
  const auto uniform = [&] { return random.uniform(); };
  const Descriptor_matrix a = make_matrix(50, 4, uniform), b = make_matrix(60, 4, uniform);
  std::vector<std::size_t> of_a(50);
  std::vector<int> of_b(60);
  for(std::size_t i = 0; i < of_a.size(); ++i)
    of_a[i] = 1000 + 3 * i;
  for(std::size_t i = 0; i < of_b.size(); ++i)
    of_b[i] = 500 - int(i);
  Correspondences expected = plain_matches(a, b);
  for(auto& c : expected)
    c = {std::uint32_t(of_a[c.source]), std::uint32_t(of_b[c.target])};
  BOOST_TEST(
      (SC::match_descriptors(a, b, SC::parameters::source_samples(of_a).target_samples(of_b)) == expected));
  BOOST_TEST((SC::match_descriptors(
                  a, b, SC::parameters::target_samples(std::cref(of_b)).source_samples(std::cref(of_a))) ==
              expected));
  for(const std::int64_t number : {std::int64_t(-1), std::int64_t(1) << 32})
  {
    std::vector<std::int64_t> out_of_range(of_a.begin(), of_a.end());
    out_of_range[7] = number;
    BOOST_CHECK_THROW(SC::match_descriptors(a, b, SC::parameters::source_samples(out_of_range)),
                      std::invalid_argument);
  }
  of_a.pop_back();
  BOOST_CHECK_THROW(SC::match_descriptors(a, b, SC::parameters::source_samples(of_a)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_order_of_the_rows_does_not_count)
{
  Random random(6);
  const auto uniform = [&] { return random.uniform(); };
  const Descriptor_matrix a = make_matrix(300, 4, uniform), b = make_matrix(280, 4, uniform);
  std::vector<std::uint32_t> order(300);
  std::iota(order.begin(), order.end(), 0u);
  for(std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[std::size_t(random.uniform() * double(i))]);
  Descriptor_matrix permuted = a;
  for(std::size_t i = 0; i < order.size(); ++i)
    permuted.values.row(Eigen::Index(i)) = a.values.row(Eigen::Index(order[i]));
  Correspondences matches = SC::match_descriptors(permuted, b, SC::parameters::source_samples(order));
  std::sort(matches.begin(), matches.end());
  BOOST_TEST((matches == SC::match_descriptors(a, b)));
}

BOOST_AUTO_TEST_CASE(matches_nearer_to_the_mirrored_descriptor_are_dropped)
{
  Random random(7);
  const auto uniform = [&] { return random.uniform(); };
  const Descriptor_matrix a = make_matrix(200, 6, uniform), b = make_matrix(200, 6, uniform);
  Descriptor_matrix mirrored = b;
  mirrored.values = b.values.rowwise().reverse();
  mirrored.status[b.status.size() / 2] = Status::DEGENERATE;
  Correspondences expected;
  for(const Correspondence& c : plain_matches(a, b))
    if(!SC::is_estimated(mirrored.status[c.target]) ||
       plain_distance(a, c.source, mirrored, c.target) >= plain_distance(a, c.source, b, c.target))
      expected.push_back(c);
  BOOST_TEST(expected.size() < plain_matches(a, b).size());
  BOOST_TEST(
      (SC::match_descriptors(a, b, SC::parameters::mirrored_target_descriptors(mirrored)) == expected));
  BOOST_TEST((SC::match_descriptors(a, b, SC::parameters::mirrored_target_descriptors(std::cref(mirrored))) ==
              expected));
  BOOST_CHECK_THROW(
      SC::match_descriptors(a, b, SC::parameters::mirrored_target_descriptors(make_matrix(3, 6, uniform))),
      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(matrices_that_do_not_fit)
{
  const auto zero = [] { return 0.; };
  Descriptor_matrix a = make_matrix(3, 4, zero);
  BOOST_CHECK_THROW(SC::match_descriptors(a, make_matrix(3, 5, zero)), std::invalid_argument);
  a.status.pop_back();
  BOOST_CHECK_THROW(SC::match_descriptors(a, make_matrix(3, 4, zero)), std::invalid_argument);
  BOOST_CHECK_THROW(SC::match_descriptors(make_matrix(3, 4, zero), a), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(triples_pass_the_plain_test)
{
  Scene scene = make_scene(200, 1., 8);
  add_wrong(scene, 9);
  const Plain_tuple_test plain;
  for(const bool orientation : {false, true})
    for(const bool normals : {false, true})
    {
      const Correspondences triples = SC::tuple_test(scene.source, scene.target, scene.correspondences,
                                                     SC::parameters::orientation_is_tested(orientation)
                                                         .normals_are_tested(normals)
                                                         .number_of_tuples(2000));
      BOOST_REQUIRE(triples.size() % 3 == 0u);
      BOOST_TEST(triples.size() > 300u);
      std::size_t wrong = 0, mirrored = 0, twisted = 0;
      for(std::size_t t = 0; t < triples.size(); t += 3)
      {
        wrong += !plain.lengths(scene, &triples[t]);
        mirrored += !plain.orientation(scene, &triples[t]);
        twisted += !plain.normals(scene, &triples[t]);
      }
      BOOST_TEST(wrong == 0u);
      BOOST_TEST((mirrored == 0u || !orientation));
      BOOST_TEST((twisted == 0u || !normals));
      if(!orientation && !normals) // each test has something to do
        BOOST_TEST((mirrored > 0u && twisted > 0u));
    }
}

// All triples of some correspondences: those that are kept are those of the plain test.
BOOST_AUTO_TEST_CASE(no_triple_is_dropped_that_passes)
{
  Scene scene = make_scene(60, 1., 10);
  add_wrong(scene, 11);
  scene.correspondences.resize(12);
  const Plain_tuple_test plain;
  std::set<Correspondences> expected, found;
  const Correspondences& c = scene.correspondences;
  for(std::size_t i = 0; i < c.size(); ++i)
    for(std::size_t j = 0; j < c.size(); ++j)
      for(std::size_t k = 0; k < c.size(); ++k)
        if(const Correspondence triple[3] = {c[i], c[j], c[k]};
           i != j && j != k && k != i && plain.lengths(scene, triple) && plain.orientation(scene, triple) &&
           plain.normals(scene, triple))
          expected.insert({c[i], c[j], c[k]});
  const Correspondences triples = SC::tuple_test(
      scene.source, scene.target, c,
      SC::parameters::number_of_tuples(1000000).tries_per_correspondence(3000)); // 20 times each
  for(std::size_t t = 0; t < triples.size(); t += 3)
    found.insert({triples[t], triples[t + 1], triples[t + 2]});
  BOOST_TEST(expected.size() >= 100u);
  BOOST_TEST((found == expected));
}

BOOST_AUTO_TEST_CASE(a_mirrored_surface_has_no_triples)
{
  Scene scene = make_scene(300, 1., 12);
  for(std::size_t i = 0; i < scene.target.size(); ++i)
  {
    scene.target.points[i].x() *= -1.;
    scene.target.normals[i].x() *= -1.;
  }
  const auto count = [&](bool orientation, bool normals)
  {
    return SC::tuple_test(scene.source, scene.target, scene.correspondences,
                          SC::parameters::orientation_is_tested(orientation).normals_are_tested(normals))
               .size() /
           3;
  };
  BOOST_TEST(count(false, false) == 1000u); // lengths say nothing
  // what is left are slim triangles, on which the orientation says nothing
  const std::size_t flat = count(true, false), both = count(true, true);
  BOOST_TEST(both <= flat);
  const Scene same = make_scene(300, 1., 12);
  const Correspondences triples = SC::tuple_test(scene.source, scene.target, scene.correspondences,
                                                 SC::parameters::normals_are_tested(false));
  for(std::size_t t = 0; t < triples.size(); t += 3)
    BOOST_TEST(std::abs(Plain_tuple_test::volume(same.source, triples[t].source, triples[t + 1].source,
                                                 triples[t + 2].source)) <= .0500001L);
}

BOOST_AUTO_TEST_CASE(number_and_seed_of_triples)
{
  Scene scene = make_scene(100, 1., 13);
  add_wrong(scene, 14);
  const auto test = [&](int tuples, int tries, unsigned seed)
  {
    return SC::tuple_test(
        scene.source, scene.target, scene.correspondences,
        SC::parameters::number_of_tuples(tuples).tries_per_correspondence(tries).random_seed(seed));
  };
  BOOST_TEST(test(10, 100, 0).size() == 30u);
  BOOST_TEST(test(0, 100, 0).empty());
  BOOST_TEST(test(10, 0, 0).empty());
  BOOST_TEST((test(100, 100, 1) == test(100, 100, 1)));
  BOOST_TEST((test(100, 100, 1) != test(100, 100, 2)));
  const Correspondences few = test(10, 100, 3), more = test(100, 100, 3);
  BOOST_TEST(std::equal(few.begin(), few.end(), more.begin())); // the draws are the same
}

BOOST_AUTO_TEST_CASE(triples_do_not_depend_on_unit_position_and_side)
{
  Scene scene = make_scene(150, 1., 15);
  add_wrong(scene, 16);
  const auto test = [&](const Scene& s) { return SC::tuple_test(s.source, s.target, s.correspondences); };
  const Correspondences expected = test(scene);
  BOOST_TEST(expected.size() > 300u);

  for(const double scale : {1e-6, 1e6, 1e-100, 1e100, 1e-200, 1e200})
  {
    Scene other = scene;
    for(auto* points : {&other.source.points, &other.target.points})
      for(auto& p : *points)
        p *= scale;
    BOOST_TEST((test(other) == expected));
  }
  Random random(17);
  Scene other = scene;
  other.source = moved(scene.source, random_motion(random, 10.));
  BOOST_TEST((test(other) == expected));

  other = scene;
  for(auto* normals : {&other.source.normals, &other.target.normals})
    for(auto& n : *normals)
      n = -n;
  BOOST_TEST((test(other) == expected));

  other = {scene.target, scene.source, scene.correspondences};
  for(auto& c : other.correspondences)
    std::swap(c.source, c.target);
  Correspondences swapped = test(other);
  for(auto& c : swapped)
    std::swap(c.source, c.target);
  BOOST_TEST((swapped == expected));
}

BOOST_AUTO_TEST_CASE(bad_input_of_triples)
{
  const Scene scene = make_scene(50, 1., 18);
  const auto test = [](const Scene& s) { return SC::tuple_test(s.source, s.target, s.correspondences); };
  const double nan = std::numeric_limits<double>::quiet_NaN();

  BOOST_TEST(test(Scene()).empty());
  Scene bad = scene;
  bad.correspondences.resize(2);
  BOOST_TEST(test(bad).empty());
  bad = scene;
  bad.correspondences.assign(100, {3, 3});
  BOOST_TEST(test(bad).empty());

  bad = scene;
  bad.source.points[1].x() = nan;
  bad.target.normals[2].setConstant(nan);
  const Correspondences triples = test(bad);
  BOOST_TEST(!triples.empty());
  for(const auto& c : triples)
    BOOST_TEST((c.source != 1u && c.target != 2u));

  bad = scene; // all in one point
  for(auto& p : bad.source.points)
    p = {1., 2., 3.};
  BOOST_TEST(test(bad).empty());
  for(auto& p : bad.target.points)
    p = {1., 2., 3.};
  BOOST_TEST(test(bad).empty());

  bad = scene; // on a line: no orientation speaks against it
  for(auto* points : {&bad.source, &bad.target})
    for(std::size_t i = 0; i < points->size(); ++i)
    {
      points->points[i] = double(i) * Eigen::Vector3d(1., 2., 3.);
      points->normals[i] = Eigen::Vector3d(3., 0., -1.).normalized();
    }
  BOOST_TEST(test(bad).size() == 3000u);

  bad = scene;
  bad.correspondences.push_back({50, 0});
  BOOST_CHECK_THROW(test(bad), std::invalid_argument);
  bad = scene;
  bad.target.normals.pop_back();
  BOOST_CHECK_THROW(test(bad), std::invalid_argument);
  namespace P = SC::parameters;
  const auto throws = [&](const auto& np)
  {
    BOOST_CHECK_THROW(SC::tuple_test(scene.source, scene.target, scene.correspondences, np),
                      std::invalid_argument);
  };
  throws(P::edge_length_similarity(1.));
  throws(P::edge_length_similarity(nan));
  throws(P::normal_tolerance(-1.));
  throws(P::number_of_tuples(-1));
  throws(P::number_of_tuples(1.5));
  throws(P::tries_per_correspondence(-1));
}

BOOST_AUTO_TEST_SUITE_END()
