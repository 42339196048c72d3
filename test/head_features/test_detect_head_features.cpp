#include <boost/test/unit_test.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "bad_meshes.h"
#include "build_mesh.h"
#include "drawn_head.h"

#include <Shape_characteristics/head_features/detect_head_features.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(detect_head_features)

namespace SC = Shape_characteristics;
using SC::Head_feature;
using SC::Head_region;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Head = SC::Head_features<Mesh, Kernel>;

namespace {

Mesh drawn(const drawn_head::Options& options = drawn_head::Options())
{
  return test_support::build_mesh<Mesh>(drawn_head::draw(options));
}

const Mesh& usual_head()
{
  static const Mesh mesh = drawn();
  return mesh;
}

Head detected(const Mesh& mesh)
{
  return SC::detect_head_features<CGAL::Sequential_tag>(mesh, SC::parameters::head_is_aligned(true));
}

const Head& usual_features()
{
  static const Head head = detected(usual_head());
  return head;
}

double distance(const Point_3& p, const Point_3& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

void check_alike(const Head& a, const Head& b, double tolerance)
{
  BOOST_TEST(a.is_head == b.is_head);
  for(std::size_t k = 0; k < SC::number_of_head_features; ++k)
  {
    BOOST_TEST_CONTEXT(SC::to_string(Head_feature(k)))
    {
      BOOST_REQUIRE_EQUAL(a.points[k].is_found, b.points[k].is_found);
      BOOST_TEST(distance(a.points[k].position, b.points[k].position) <= tolerance);
      BOOST_TEST(std::abs(a.points[k].confidence - b.points[k].confidence) <= 1e-4);
    }
  }
  for(std::size_t k = 0; k < SC::number_of_head_regions; ++k)
    BOOST_TEST(a.regions[k].vertices.size() == b.regions[k].vertices.size());
}

bool is_in_group(Head_feature f, const std::string& prefix)
{
  return std::string(SC::to_string(f)).rfind(prefix, 0) == 0;
}

void check_found(const Head& head, const std::string& prefix, bool expected)
{
  for(std::size_t k = 0; k < SC::number_of_head_features; ++k)
    if(is_in_group(Head_feature(k), prefix))
      BOOST_TEST_CONTEXT(SC::to_string(Head_feature(k)))
  BOOST_TEST(head.points[k].is_found == expected);
}

} // namespace

BOOST_AUTO_TEST_CASE(features_are_where_they_were_drawn)
{
  const Head& head = usual_features();
  BOOST_REQUIRE(head.is_head);
  BOOST_TEST((head.verdict == SC::Head_verdict::HEAD));
  for(const auto& [feature, truth] : drawn_head::truth())
    BOOST_TEST_CONTEXT(SC::to_string(feature))
    {
      BOOST_REQUIRE(head[feature].is_found);
      const Point_3& p = head[feature].position;
      BOOST_TEST_CONTEXT("found at " << p << ", drawn at " << truth.x << " " << truth.y)
      BOOST_TEST(std::hypot(p.x() - truth.x, p.y() - truth.y) <= truth.tolerance);
    }
  BOOST_TEST(std::abs(head.head_height - 1.) < .06);
  for(std::size_t k = 0; k < SC::number_of_head_features; ++k)
    BOOST_TEST_CONTEXT(SC::to_string(Head_feature(k)))
    {
      const auto& p = head.points[k];
      BOOST_REQUIRE(p.is_found);
      BOOST_TEST((p.confidence >= 0. && p.confidence <= 1.));
      // the vertex is a corner of the triangle that the point lies on
      BOOST_TEST(distance(p.position, usual_head().point(p.vertex)) < .02);
    }
  BOOST_TEST(head[Head_feature::N1].position.y() < head[Head_feature::N2].position.y());
  BOOST_TEST(head[Head_feature::N3].position.y() > head[Head_feature::N2].position.y());
  BOOST_TEST(head[Head_feature::N4].position.y() > head[Head_feature::N3].position.y());
  for(const auto& r : head.regions)
  {
    BOOST_TEST(r.is_found);
    BOOST_TEST(std::is_sorted(r.vertices.begin(), r.vertices.end()));
  }
}

BOOST_AUTO_TEST_CASE(ears_are_their_rings)
{
  // the rings come last: two times 72 * 12 vertices
  const std::size_t n = usual_head().number_of_vertices(), ring = 72 * 12;
  for(const int side : {-1, 1})
  {
    const auto& ear = usual_features()[side < 0 ? Head_region::LEFT_EAR : Head_region::RIGHT_EAR];
    const std::size_t first = n - (side < 0 ? 2 : 1) * ring;
    const auto on_ring =
        std::count_if(ear.vertices.begin(), ear.vertices.end(),
                      [&](const auto v) { return std::size_t(v) >= first && std::size_t(v) < first + ring; });
    BOOST_TEST(double(on_ring) > .8 * ring); // the outline follows the crest of a ring, not its foot
    for(const auto v : ear.vertices)
      BOOST_TEST(side * usual_head().point(v).x() > 0.);
  }
}

BOOST_AUTO_TEST_CASE(neither_unit_nor_place_matters)
{
  for(const double scale : {1e-6, 1e6})
    for(const double offset : {0., 3.})
    {
      Mesh mesh = usual_head();
      const Kernel::Vector_3 shift(offset, -2 * offset, offset);
      for(const auto v : mesh.vertices())
        mesh.point(v) = CGAL::ORIGIN + scale * ((mesh.point(v) - CGAL::ORIGIN) + shift);
      Head head = detected(mesh);
      for(auto& p : head.points)
        p.position = CGAL::ORIGIN + ((p.position - CGAL::ORIGIN) / scale - shift);
      check_alike(head, usual_features(), 1e-4); // of two pixels alike, rounding decides which is higher
      BOOST_TEST(std::abs(head.head_height / scale - usual_features().head_height) < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(order_of_vertices_and_faces_does_not_matter)
{
  drawn_head::Arrays head = drawn_head::draw();
  const std::size_t n = head.points.size();
  drawn_head::Arrays reversed;
  reversed.points.assign(head.points.rbegin(), head.points.rend());
  for(auto t = head.triangles.rbegin(); t != head.triangles.rend(); ++t)
    reversed.triangles.push_back({n - 1 - (*t)[1], n - 1 - (*t)[2], n - 1 - (*t)[0]});
  check_alike(detected(test_support::build_mesh<Mesh>(reversed)), usual_features(), 1e-9);
}

BOOST_AUTO_TEST_CASE(any_mesh_and_any_number_of_threads)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const auto polyhedron = test_support::build_mesh<Polyhedron>(drawn_head::draw());
  const auto a = SC::detect_head_features(polyhedron, SC::parameters::head_is_aligned(true));
  const Head b = SC::detect_head_features(usual_head(), SC::parameters::head_is_aligned(true));
  for(std::size_t k = 0; k < SC::number_of_head_features; ++k)
  {
    BOOST_TEST(a.points[k].position == usual_features().points[k].position);
    BOOST_TEST(b.points[k].position == usual_features().points[k].position);
  }
}

// Edges half as long, and the same points but for what the coarse one misses of the shape.
// What is found has the kernel that is asked for.
BOOST_AUTO_TEST_CASE(kernel_of_the_result)
{
  using Other_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const SC::Head_features<Mesh, Other_kernel> head = SC::detect_head_features(
      usual_head(), SC::parameters::head_is_aligned(true).geom_traits(Other_kernel()));
  for(std::size_t k = 0; k < SC::number_of_head_features; ++k)
  {
    const auto& p = head.points[k].position;
    BOOST_TEST(Point_3(p.x(), p.y(), p.z()) == usual_features().points[k].position);
  }
  // whose pose is to be estimated
  const Head expected = SC::detect_head_features(usual_head());
  const SC::Head_features<Mesh, Other_kernel> posed =
      SC::detect_head_features(usual_head(), SC::parameters::geom_traits(Other_kernel()));
  BOOST_TEST(int(posed.verdict) == int(expected.verdict));
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 4; ++j)
      BOOST_TEST(posed.transformation.m(i, j) == expected.transformation.m(i, j));
}

BOOST_AUTO_TEST_CASE(tessellation_hardly_matters)
{
  const Head fine = detected(test_support::build_mesh<Mesh>(drawn_head::draw(drawn_head::Options(), 7)));
  for(const auto& [feature, truth] : drawn_head::truth())
    BOOST_TEST_CONTEXT(SC::to_string(feature))
    {
      BOOST_REQUIRE(fine[feature].is_found);
      BOOST_TEST(distance(fine[feature].position, usual_features()[feature].position) < .015);
    }
}

BOOST_AUTO_TEST_CASE(a_pose_is_taken_as_it_is)
{
  // turned about x by 90 degrees, the pose turns it back
  Mesh mesh = usual_head();
  for(const auto v : mesh.vertices())
  {
    const Point_3 p = mesh.point(v);
    mesh.point(v) = Point_3(5 + p.x(), -p.z(), p.y());
  }
  SC::Head_pose<Kernel> pose;
  pose.verdict = SC::Head_verdict::HEAD;
  pose.obstacle = SC::Head_obstacle::NONE;
  pose.size = 1 / .905;
  pose.transformation =
      CGAL::Aff_transformation_3<Kernel>(.905, 0, 0, -.905 * 5, 0, 0, .905, 0, 0, -.905, 0, 0);
  pose.nose_tip = Point_3(5, 0, .01);
  const Head head = SC::detect_head_features(mesh, SC::parameters::head_pose(pose));
  BOOST_REQUIRE(head.is_head);
  for(const auto& [feature, truth] : drawn_head::truth())
    BOOST_TEST_CONTEXT(SC::to_string(feature))
    {
      BOOST_REQUIRE(head[feature].is_found);
      const Point_3& p = head[feature].position;
      BOOST_TEST(std::hypot(p.x() - 5 - truth.x, p.z() - truth.y) <= truth.tolerance + .003);
    }

  pose.verdict = SC::Head_verdict::NOT_A_HEAD;
  pose.obstacle = SC::Head_obstacle::WRONG_WAY_UP;
  const Head refused = SC::detect_head_features(mesh, SC::parameters::head_pose(pose));
  BOOST_TEST(!refused.is_head);
  BOOST_TEST((refused.obstacle == SC::Head_obstacle::WRONG_WAY_UP));
  check_found(refused, "", false);
}

BOOST_AUTO_TEST_CASE(what_is_not_there_is_not_found)
{
  drawn_head::Options options;
  options.has_ears = false;
  Head head = detected(drawn(options));
  check_found(head, "LEFT_R", false);
  check_found(head, "RIGHT_R", false);
  check_found(head, "LEFT_E", true);
  BOOST_TEST(!head[Head_region::LEFT_EAR].is_found);

  options = drawn_head::Options();
  options.has_eyes = false;
  head = detected(drawn(options));
  check_found(head, "LEFT_E", false);
  check_found(head, "RIGHT_E", false);
  check_found(head, "M", true);
  check_found(head, "LEFT_R", true);

  options = drawn_head::Options();
  options.is_kept = [](const drawn_head::Vector& p) { return p[1] < .3; };
  SC::Head_pose<Kernel> pose; // its box is no measure of this one
  pose.verdict = SC::Head_verdict::HEAD;
  pose.transformation = CGAL::Aff_transformation_3<Kernel>(CGAL::SCALING, .905);
  head = SC::detect_head_features(drawn(options), SC::parameters::head_pose(pose));
  check_found(head, "TOP", false);
  check_found(head, "LEFT_E", true);
  check_found(head, "M", true);

  options.is_kept = [](const drawn_head::Vector& p) { return p[0] < .03; };
  options.has_ears = false;
  head = SC::detect_head_features(drawn(options), SC::parameters::head_pose(pose));
  check_found(head, "LEFT_E", true);
  check_found(head, "RIGHT_E", false);
  check_found(head, "RIGHT_R", false);
}

BOOST_AUTO_TEST_CASE(not_a_head)
{
  for(const auto& surface :
      {test_support::sphere(1., 4), test_support::torus(1., .4), test_support::ellipsoid(1., .7, .5)})
  {
    const Head head = detected(test_support::build_mesh<Mesh>(surface));
    BOOST_TEST(!head.is_head);
    BOOST_TEST((head.verdict == SC::Head_verdict::NOT_A_HEAD));
    BOOST_TEST((head.obstacle != SC::Head_obstacle::NONE));
    check_found(head, "", false);
  }
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  BOOST_TEST(!detected(Mesh()).is_head);
  for(const auto& polygons : test_support::all_bad_triangle_meshes())
  {
    const Head head = detected(test_support::build_mesh<Mesh>(polygons));
    BOOST_TEST(!head.is_head);
    check_found(head, "", false);
  }
  BOOST_CHECK_THROW(detected(test_support::build_mesh<Mesh>(test_support::cube_of_quads())),
                    std::invalid_argument);

  // a soup: whether its pose is known or not
  Mesh soup;
  for(const auto f : usual_head().faces())
  {
    std::vector<Mesh::Vertex_index> corners;
    for(const auto v : usual_head().vertices_around_face(usual_head().halfedge(f)))
      corners.push_back(soup.add_vertex(usual_head().point(v)));
    soup.add_face(corners);
  }
  const auto aligned = SC::parameters::head_is_aligned(true);
  const auto thesis = aligned.head_feature_method(SC::Head_feature_method::THESIS)
                          .number_of_eye_vertices(300)
                          .number_of_nose_vertices(200)
                          .number_of_ear_vertices(150);
  SC::Head_pose<Kernel> pose;
  pose.verdict = SC::Head_verdict::HEAD;
  pose.obstacle = SC::Head_obstacle::NONE;
  const Head posed = SC::detect_head_features<CGAL::Sequential_tag>(soup, SC::parameters::head_pose(pose));
  BOOST_TEST(posed.is_head);
  for(const Head& head :
      {posed, detected(soup), SC::detect_head_features<CGAL::Sequential_tag>(soup, thesis)})
  {
    BOOST_TEST((head.obstacle == SC::Head_obstacle::DUPLICATE));
    check_found(head, "", false);
  }

  // a vertex that is nowhere, far from all features
  Mesh mesh = usual_head();
  const auto v =
      *std::min_element(mesh.vertices().begin(), mesh.vertices().end(),
                        [&](const auto a, const auto b) { return mesh.point(a).z() < mesh.point(b).z(); });
  mesh.point(v) = Point_3(0, std::nan(""), 0);
  mesh.add_vertex(Point_3(0, 0, 100)); // and some without faces
  const Mesh::Vertex_index stranger = mesh.add_vertex(usual_features()[Head_feature::NOSE_TIP].position);
  const Head head = detected(mesh);
  BOOST_REQUIRE(head.is_head);
  for(const auto& region : head.regions)
    BOOST_TEST(std::count(region.vertices.begin(), region.vertices.end(), stranger) == 0);
  for(const auto& [feature, truth] : drawn_head::truth())
    BOOST_TEST(distance(head[feature].position, usual_features()[feature].position) < 1e-3);
}

BOOST_AUTO_TEST_CASE(the_method_of_the_thesis)
{
  const Mesh& mesh = usual_head();
  const auto np = [](int eyes, int nose, int ear)
  {
    return SC::parameters::head_is_aligned(true)
        .head_feature_method(SC::Head_feature_method::THESIS)
        .number_of_eye_vertices(eyes)
        .number_of_nose_vertices(nose)
        .number_of_ear_vertices(ear);
  };
  const Head head = SC::detect_head_features<CGAL::Sequential_tag>(mesh, np(300, 200, 150));
  BOOST_TEST(head.is_head);

  // by looking at all vertices
  auto top = *mesh.vertices().begin(), tip = top;
  for(const auto v : mesh.vertices())
  {
    top = mesh.point(v).y() > mesh.point(top).y() ? v : top;
    tip = mesh.point(v).z() > mesh.point(tip).z() ? v : tip;
  }
  BOOST_TEST(head[Head_feature::TOP].position == mesh.point(top));
  BOOST_TEST(head[Head_feature::NOSE_TIP].position == mesh.point(tip));
  // with the printed radius of 0.6 the chin is at the tip of the nose, and there is no mouth between the two
  BOOST_TEST(distance(head[Head_feature::CHIN].position, mesh.point(tip)) < .01);
  check_found(head, "M", false);

  BOOST_TEST(head[Head_region::LEFT_EYE].vertices.size() + head[Head_region::RIGHT_EYE].vertices.size() ==
             300u);
  BOOST_TEST(head[Head_region::NOSE].vertices.size() == 200u);
  BOOST_TEST(head[Head_region::LEFT_EAR].vertices.size() == 150u);
  BOOST_TEST(head[Head_region::RIGHT_EAR].vertices.size() == 150u);
  for(const auto v : head[Head_region::NOSE].vertices)
    BOOST_TEST(mesh.point(v).y() > mesh.point(tip).y());

  // vertices without faces are no features
  Mesh with_strangers = mesh;
  with_strangers.add_vertex(Point_3(0, 100, 100));
  const Head same = SC::detect_head_features<CGAL::Sequential_tag>(with_strangers, np(300, 200, 150));
  for(std::size_t k = 0; k < SC::number_of_head_features; ++k)
    BOOST_TEST(same.points[k].position == head.points[k].position);

  const double radius = .02;
  const Head sparse =
      SC::detect_head_features<CGAL::Sequential_tag>(mesh, np(30, 20, 15).detection_radius(radius));
  const auto& nose = sparse[Head_region::NOSE].vertices;
  double nearest = 1e9;
  for(const auto a : nose)
    for(const auto b : nose)
      if(a != b)
        nearest = std::min(nearest, distance(mesh.point(a), mesh.point(b)));
  BOOST_TEST(nose.size() == 20u);
  BOOST_TEST(nearest * .9 > .9 * radius * .95); // the box is about 1 / 0.9 in size

  // any estimator will do
  bool was_called = false;
  SC::detect_head_features<CGAL::Sequential_tag>(
      mesh, np(300, 200, 150)
                .curvature_estimator(
                    [&](const auto& m, const auto& outputs)
                    {
                      was_called = true;
                      SC::rusinkiewicz_curvatures<CGAL::Sequential_tag>(m, outputs);
                    }));
  BOOST_TEST(was_called);

  const auto thesis =
      SC::parameters::head_is_aligned(true).head_feature_method(SC::Head_feature_method::THESIS);
  BOOST_CHECK_THROW(SC::detect_head_features(mesh, thesis), std::invalid_argument);
  BOOST_CHECK_THROW(SC::detect_head_features(mesh, np(0, 200, 150)), std::invalid_argument);
  BOOST_CHECK_THROW(SC::detect_head_features(mesh, np(300, -1, 150)), std::invalid_argument);
  BOOST_CHECK_THROW(SC::detect_head_features(mesh, np(300, 200, 150).detection_radius(-1.)),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
