// Poses of heads from any rotation, and refusals of what isn't a head. The heads in ../shared/data/heads are left out where that
// folder isn't there.
#include "../../examples/support/data_file.h"

#include <Shape_characteristics/head_features/estimate_head_pose.h>
#include <Shape_characteristics/head_features/nose_tip_candidates.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_type_config.h>
#include <CGAL/property_map.h>

#include "analytic_surfaces.h"
#include "check_names.h"

#include "../../benchmark/support/Random.h"

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/test/unit_test.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(head_pose)

namespace SC = Shape_characteristics;
namespace params = SC::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Pose = SC::Head_pose<Kernel>;
using benchmark_support::Random;
using SC::Head_obstacle;
using SC::Head_verdict;

namespace {

Mesh read(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("not a mesh: " + file);
  return mesh;
}

const Mesh& mannequin()
{
  static const Mesh mesh = read(support::data_file("meshes/mannequin-devil.off"));
  return mesh;
}

const Pose& pose_of_mannequin()
{
  static const Pose pose = SC::estimate_head_pose(mannequin());
  return pose;
}

Eigen::Affine3d random_motion(Random& random, const double scale)
{
  const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian(), d = random.gaussian();
  return Eigen::Translation3d(100. * a, 100. * b, 100. * c) * Eigen::Quaterniond(a, b, c, d).normalized() *
         Eigen::Scaling(scale);
}

Mesh moved(Mesh mesh, const Eigen::Affine3d& motion)
{
  for(const auto v : mesh.vertices())
  {
    const Eigen::Vector3d p = motion * SC::internal::to_eigen(mesh.point(v));
    mesh.point(v) = Point(p[0], p[1], p[2]);
  }
  return mesh;
}

Eigen::Affine3d transformation(const Pose& pose)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for(int row = 0; row < 3; ++row)
    for(int column = 0; column < 4; ++column)
      result.matrix()(row, column) = pose.transformation.m(row, column);
  return result;
}

// turns about the axes of the frame, in degrees, that are between two transformations: pitch, yaw, roll
Eigen::Vector3d turns(const Eigen::Affine3d& a, const Eigen::Affine3d& b)
{
  const Eigen::AngleAxisd turn(
      Eigen::Quaterniond(Eigen::Matrix3d(a.rotation() * b.rotation().transpose())).normalized());
  return turn.angle() * 180. / CGAL_PI * turn.axis();
}

std::filesystem::path heads()
{
  return std::filesystem::path(__FILE__).parent_path() / "../../../shared/data/heads";
}

} // namespace

BOOST_AUTO_TEST_CASE(the_same_head_in_any_pose_and_unit)
{
  const Pose& first = pose_of_mannequin();
  BOOST_TEST(int(first.verdict) == int(Head_verdict::HEAD));
  BOOST_TEST(int(first.obstacle) == int(Head_obstacle::NONE));
  BOOST_TEST(first.is_head());
  BOOST_TEST(first.confidence > .5);
  BOOST_TEST(transformation(first).linear().determinant() > 0.);
  // the nose is in front, on the plane of symmetry
  const Point tip = first.nose_tip.transform(first.transformation);
  BOOST_TEST(std::abs(tip.x()) < .02);
  BOOST_TEST(tip.z() > .35);
  BOOST_TEST(std::sqrt(CGAL::squared_distance(first.symmetry_plane, first.nose_tip)) < .02 * first.size);

  Random random(5);
  for(const double scale : {1e-5})
  {
    const Eigen::Affine3d motion = random_motion(random, scale);
    const Pose pose = SC::estimate_head_pose(moved(mannequin(), motion));
    BOOST_TEST(pose.is_head());
    BOOST_TEST(turns(transformation(pose) * motion, transformation(first)).norm() < .5);
    BOOST_TEST(std::abs(pose.size / (scale * first.size) - 1.) < .01);
    const Point p = pose.nose_tip.transform(pose.transformation);
    BOOST_TEST(std::sqrt(CGAL::squared_distance(p, tip)) < .02);
  }
}

// what a scanner leaves around the head
BOOST_AUTO_TEST_CASE(strays_do_not_matter)
{
  const Pose& pose = pose_of_mannequin();
  for(const double away : {2., 30., 1e6, 1e150, 1e300}) // times the size of the head
  {
    Mesh mesh = mannequin();
    for(int k = 0; k < 3; ++k)
    {
      const double x = away * pose.size * (k - 1), y = away * pose.size;
      const auto a = mesh.add_vertex(Point(x, y, 0)), b = mesh.add_vertex(Point(x + .1 * pose.size, y, 0)),
                 c = mesh.add_vertex(Point(x, y + .1 * pose.size, 0));
      mesh.add_face(a, b, c);
    }
    const Pose with_strays = SC::estimate_head_pose(mesh);
    BOOST_TEST(int(with_strays.verdict) == int(pose.verdict));
    BOOST_TEST(std::abs(with_strays.size / pose.size - 1.) < .01);
    BOOST_TEST(turns(transformation(with_strays), transformation(pose)).norm() < .5);
    const auto noses = SC::nose_tip_candidates(mesh);
    BOOST_TEST(noses.size() > 20u);
    for(const auto& nose : noses)
      BOOST_TEST(
          (away < 10. || std::sqrt(CGAL::squared_distance(nose.point, pose.nose_tip)) < 5. * pose.size));

    std::vector<std::pair<Point, Kernel::Vector_3> > points;
    for(const auto v : mesh.vertices())
      points.emplace_back(mesh.point(v), CGAL::Polygon_mesh_processing::compute_vertex_normal(v, mesh));
    const auto np = params::point_map(CGAL::First_of_pair_property_map<std::pair<Point, Kernel::Vector_3> >())
                        .normal_map(CGAL::Second_of_pair_property_map<std::pair<Point, Kernel::Vector_3> >());
    BOOST_TEST(int(SC::estimate_head_pose(points, np).verdict) == int(pose.verdict));
  }
}

BOOST_AUTO_TEST_CASE(threads_do_not_matter)
{
  const Pose pose = SC::estimate_head_pose<CGAL::Sequential_tag>(mannequin());
  BOOST_TEST((transformation(pose).matrix() == transformation(pose_of_mannequin()).matrix()));
}

BOOST_AUTO_TEST_CASE(the_way_up)
{
  const Eigen::Vector3d up = transformation(pose_of_mannequin()).rotation().row(1);
  const Kernel::Vector_3 upward(up[0], up[1], up[2]);
  BOOST_TEST(SC::estimate_head_pose(mannequin(), params::upward_direction(upward)).is_head());
  const Pose pose = SC::estimate_head_pose(mannequin(), params::upward_direction(-upward));
  BOOST_TEST(int(pose.verdict) == int(Head_verdict::NOT_A_HEAD));
  BOOST_TEST(int(pose.obstacle) == int(Head_obstacle::WRONG_WAY_UP));
  BOOST_TEST(pose.confidence == 0.);
  BOOST_CHECK_THROW(SC::estimate_head_pose(mannequin(), params::upward_direction(Kernel::Vector_3(0, 0, 0))),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(places_like_a_nose)
{
  const auto candidates = SC::nose_tip_candidates(mannequin());
  const Pose& pose = pose_of_mannequin();
  BOOST_REQUIRE(!candidates.empty());
  double nearest = HUGE_VAL;
  for(std::size_t i = 0; i < candidates.size(); ++i)
  {
    nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(candidates[i].point, pose.nose_tip)));
    BOOST_TEST(std::abs(candidates[i].normal.squared_length() - 1.) < 1e-12);
    BOOST_TEST(candidates[i].asymmetry >= 0.);
    BOOST_TEST(candidates[i].prominence <= candidates[i > 0 ? i - 1 : 0].prominence);
    for(std::size_t j = 0; j < i; ++j)
      BOOST_TEST(candidates[i].point != candidates[j].point);
  }
  BOOST_TEST(nearest < .05 * pose.size);

  BOOST_TEST(SC::nose_tip_candidates(Mesh()).empty());
}

BOOST_AUTO_TEST_CASE(not_heads)
{
  const auto refuses = [](const Mesh& mesh)
  {
    const Pose pose = SC::estimate_head_pose(mesh);
    return pose.verdict == Head_verdict::NOT_A_HEAD && pose.obstacle != Head_obstacle::NONE &&
           pose.confidence == 0.;
  };
  for(const char* name : {"elephant", "fandisk", "cow", "lion-head", "sphere", "cube"})
    BOOST_TEST(refuses(read(support::data_file(std::string("meshes/") + name + ".off"))), name);

  // half a head
  const Pose& pose = pose_of_mannequin();
  Mesh half = mannequin();
  std::vector<Mesh::Face_index> others;
  for(const auto f : half.faces())
    if(pose.symmetry_plane.has_on_negative_side(half.point(half.target(half.halfedge(f)))))
      others.push_back(f);
  for(const auto f : others)
    CGAL::Euler::remove_face(half.halfedge(f), half);
  half.collect_garbage();
  BOOST_TEST(half.number_of_faces() > 1000u);
  BOOST_TEST(refuses(half));

  const Pose none = SC::estimate_head_pose(Mesh());
  BOOST_TEST(int(none.verdict) == int(Head_verdict::NOT_A_HEAD));
  BOOST_TEST(int(none.obstacle) == int(Head_obstacle::FEW_SAMPLES));
  // fewer vertices than a head has features
  const Pose cube = SC::estimate_head_pose(read(support::data_file("meshes/cube.off")));
  BOOST_TEST(int(cube.obstacle) == int(Head_obstacle::FEW_SAMPLES));
}

BOOST_AUTO_TEST_CASE(cancelling)
{
  const Pose pose =
      SC::estimate_head_pose(mannequin(), params::callback([](const double x) { return x < .3; }));
  BOOST_TEST(int(pose.verdict) == int(Head_verdict::NOT_A_HEAD));
  BOOST_TEST(int(pose.obstacle) == int(Head_obstacle::CANCELLED));
}

BOOST_AUTO_TEST_CASE(heads_with_known_poses)
{
  if(!std::filesystem::is_directory(heads()))
  {
    BOOST_TEST_MESSAGE("skipped: there are no heads in " << heads());
    return;
  }
  Random random(11);
  for(const char* name : {"id0001_crop", "id0002_posed", "id0005_jawopen", "id0009_noisy", "id0012_smile"})
  {
    const std::string file = (heads() / name).string();
    boost::property_tree::ptree json;
    boost::property_tree::read_json(file + ".json", json);
    Eigen::Affine3d placed = Eigen::Affine3d::Identity();
    if(const auto matrix = json.get_child_optional("pose"))
    {
      int row = 0;
      for(const auto& r : *matrix)
      {
        int column = 0;
        for(const auto& x : r.second)
          placed.matrix()(row, column++) = x.second.get_value<double>();
        ++row;
      }
    }
    const Eigen::Affine3d motion = random_motion(random, 20.);
    const Pose pose = SC::estimate_head_pose(moved(read(file + ".ply"), motion));
    BOOST_TEST(pose.is_head(), name);
    const Eigen::Vector3d error = turns(transformation(pose) * motion * placed, Eigen::Affine3d::Identity());
    BOOST_TEST_MESSAGE(name << ": pitch " << error[0] << ", yaw " << error[1] << ", roll " << error[2]);
    // what "level" is differs from face to face, more with the jaw open
    BOOST_TEST(std::abs(error[0]) < (std::string(name).find("jawopen") == std::string::npos ? 2.5 : 4.),
               name);
    BOOST_TEST(std::abs(error[1]) < 1., name);
    BOOST_TEST(std::abs(error[2]) < 1., name);
  }
}

BOOST_AUTO_TEST_CASE(every_verdict_and_obstacle_has_its_name)
{
  test_support::check_names<Head_verdict>({"HEAD", "UNCERTAIN", "NOT_A_HEAD"});
  test_support::check_names<Head_obstacle>({"NONE", "FEW_SAMPLES", "CANCELLED", "INSIDE_OUT", "NO_NOSE",
                                            "SHAPE_DISAGREES", "FACE_IS_INCOMPLETE", "NO_SYMMETRY",
                                            "WRONG_WAY_UP", "DUPLICATE"});
}

BOOST_AUTO_TEST_SUITE_END()
