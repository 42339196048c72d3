// A point set without normals: CGAL estimates and orients them, then curvatures can be estimated.
#include "../support/data_file.h"

#include <Shape_characteristics/curvature/hrbf_curvatures.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO/XYZ.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

int main()
{
  Point_set points;
  std::ifstream file(support::data_file("points_3/kitten.xyz"));
  if(!CGAL::IO::read_XYZ(file, points) || !points.has_normal_map())
    return EXIT_FAILURE;

  // the file has normals: they are set aside, to be compared with
  auto given = points.add_property_map<Kernel::Vector_3>("given").first;
  for(const Point_set::Index& i : points)
    given[i] = points.normal(i);

  CGAL::pca_estimate_normals<CGAL::Parallel_if_available_tag>(points, 18, points.parameters());
  CGAL::mst_orient_normals(points, 18, points.parameters());

  // mst_orient_normals() makes the normal of the highest point point upwards: outwards, then
  std::size_t agree = 0;
  for(const Point_set::Index& i : points)
    agree += given[i] * points.normal(i) > 0.9;
  std::cout << agree << " of " << points.size()
            << " normals agree with those of the file within 26 degrees\n";

  auto H = points.add_property_map<double>("mean_curvature").first;
  const std::size_t failed = SC::hrbf_curvatures(points, SC::parameters::mean_curvature_map(H));
  double sum = 0;
  for(const Point_set::Index& i : points)
    sum += H[i] == H[i] ? H[i] : 0; // NaN where it could not be estimated
  std::cout << "mean of H: " << sum / double(points.size() - failed) << ", " << failed
            << " points could not be estimated\n";
  return agree > points.size() * 9 / 10 && sum > 0 && failed < points.size() / 10 ? EXIT_SUCCESS
                                                                                  : EXIT_FAILURE;
}
