// Two overlapping parts of a surface, of which one was moved, are brought together step by step: descriptors are matched,
// matches that contradict each other are dropped, the rest gives the motion, and the points make it exact.
#include "../support/data_file.h"

#include <Shape_characteristics/descriptors/fpfh_descriptors.h>
#include <Shape_characteristics/registration/fast_global_registration.h>
#include <Shape_characteristics/registration/iterative_closest_point.h>
#include <Shape_characteristics/registration/match_descriptors.h>
#include <Shape_characteristics/registration/tuple_test.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

namespace SC = Shape_characteristics;
namespace params = SC::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Oriented_point = std::pair<Kernel::Point_3, Kernel::Vector_3>;

namespace {

// every other vertex of the mesh between two heights, moved
SC::Oriented_points scan(const SC::Face_graph_samples& surface,
                         std::size_t first,
                         double lowest,
                         double highest,
                         const Eigen::Isometry3d& motion)
{
  SC::Oriented_points result;
  for(std::size_t i = first; i < surface.size(); i += 2)
    if(const double y = surface.point(i).y(); lowest < y && y < highest)
    {
      result.points.push_back(motion * surface.point(i));
      result.normals.push_back(motion.linear() * surface.normal(i));
    }
  return result;
}

SC::Descriptor_matrix descriptors(const SC::Oriented_points& scan, double radius)
{
  std::vector<Oriented_point> points;
  for(std::size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d &p = scan.points[i], &n = scan.normals[i];
    points.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  return SC::fpfh_descriptors(points, params::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                                          .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>())
                                          .neighbor_radius(radius));
}

} // namespace

int main(int argc, char** argv)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : support::data_file("meshes/lion-head.off"), mesh))
    return EXIT_FAILURE;
  const SC::Face_graph_samples surface = SC::sampled_surface(mesh, SC::Neighborhood::rings(1));
  double bottom = surface.point(0).y(), top = bottom;
  for(std::size_t i = 0; i < surface.size(); ++i)
  {
    bottom = std::min(bottom, surface.point(i).y());
    top = std::max(top, surface.point(i).y());
  }
  Eigen::Isometry3d truth(Eigen::AngleAxisd(2., Eigen::Vector3d(2., -1., 2.) / 3.));
  truth.translation() << 1., 2., 3.;
  // half of the height is on both
  const double fourth = (top - bottom) / 4.;
  const SC::Oriented_points target = scan(surface, 0, bottom, top - fourth, truth),
                            source = scan(surface, 1, bottom + fourth, top, Eigen::Isometry3d::Identity());

  // the largest distance of a point from where it belongs
  const auto error = [&](const Eigen::Isometry3d& motion)
  {
    double largest = 0.;
    for(const Eigen::Vector3d& p : source.points)
      largest = std::max(largest, (motion * p - truth * p).norm());
    return largest;
  };

  const double spacing = surface.mean_spacing(), radius = 8. * spacing;
  const auto matches = SC::match_descriptors(descriptors(source, radius), descriptors(target, radius));
  const auto congruent = SC::tuple_test(source, target, matches);
  const SC::Rigid_alignment coarse = SC::fast_global_registration(source, target, congruent);
  const SC::Rigid_alignment fine = SC::iterative_closest_point(source, target, coarse);

  std::cout << source.size() << " and " << target.size() << " points, " << matches.size() << " matches\n"
            << congruent.size() / 3 << " triples of matches are congruent\n"
            << coarse.inliers.size() << " of their " << congruent.size()
            << " matches agree on a motion, error " << error(coarse) / spacing << " spacings\n"
            << fine.inliers.size() << " points are on the other surface, error " << error(fine) / spacing
            << " spacings\n";
  return error(coarse) < 3. * spacing && error(fine) < 0.2 * spacing ? EXIT_SUCCESS : EXIT_FAILURE;
}
