// Mean curvature of volume data: of a torus that is given by the values of voxels, and of a mesh that is made into voxels.
#include <Shape_characteristics/curvature/Voxel_octree.h>
#include <Shape_characteristics/curvature/voxel_curvatures.h>
#include <Shape_characteristics/curvature/voxelize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Point_with_curvature = std::pair<Point_3, double>;

int main()
{
  const double center = 2., tube = 1., voxel = .1;
  const double half = center + tube + 2. * voxel;
  const auto count = std::size_t(std::ceil(2. * half / voxel));
  const auto coordinate = [=](std::size_t i) { return -half + (double(i) + .5) * voxel; };
  // grey values: where the surface passes through a voxel, a share of it that follows from the distance
  const auto share = [=](std::size_t i, std::size_t j, std::size_t k)
  {
    const double r = std::hypot(coordinate(i), coordinate(j)) - center;
    const double distance = std::hypot(r, coordinate(k)) - tube;
    return std::clamp(.5 - distance / voxel, 0., 1.);
  };
  const SC::Voxel_octree octree({count, count, count}, Point_3(-half, -half, -half), {voxel, voxel, voxel},
                                share);

  std::vector<Point_with_curvature> points;
  for(const Point_3& p : octree.surface_points())
    points.emplace_back(p, 0.);
  const std::size_t failures =
      SC::voxel_curvatures(octree, points,
                           SC::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_curvature>())
                               .mean_curvature_map(CGAL::Second_of_pair_property_map<Point_with_curvature>())
                               .neighbor_radius(5. * voxel));
  double sum = 0.;
  for(const auto& [p, mean] : points)
  {
    const double r = std::hypot(p.x(), p.y()) - center, cosine = r / std::hypot(r, p.z());
    sum += std::abs(mean - .5 * (1. / tube + cosine / (center + tube * cosine)));
  }
  const double error = sum / double(points.size());
  std::cout << count << "^3 voxels, " << octree.number_of_nodes() << " nodes of the octree, " << points.size()
            << " points: mean error " << error << ", " << failures << " failures\n";

  CGAL::Surface_mesh<Point_3> mesh;
  CGAL::make_icosahedron(mesh, Point_3(0., 0., 0.), 1.);
  const double phi = (1. + std::sqrt(5.)) / 2., side = 1. / std::sin(.4 * CGAL_PI);
  const double exact = 5. / 6. * phi * phi * side * side * side;
  const double volume = SC::voxelize(mesh, .05).volume_in_ball(Point_3(0., 0., 0.), 2.);
  std::cout << "volume of an icosahedron: " << volume << " in voxels, " << exact << " in fact\n";
  return failures == 0 && error < .05 && std::abs(volume - exact) < .01 * exact ? EXIT_SUCCESS : EXIT_FAILURE;
}
