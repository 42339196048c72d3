// A point set without normals: they are estimated and oriented, improved, and used to estimate curvatures. In narrow creases, some points
// have neighbors of both sides, which face each other: they are flagged, and carry NaN.
#include "../support/data_file.h"

#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/normals/hrbf_normals.h>
#include <Shape_characteristics/normals/point_normals.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO/XYZ.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
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

  // the file has normals: they are only compared with
  const auto given = points.normal_map();
  auto normals = points.add_property_map<Kernel::Vector_3>("estimated normals").first;
  const auto mean_angle = [&]
  {
    double sum = 0, number = 0;
    for(const Point_set::Index& i : points)
      if(!std::isnan(normals[i].x()))
      {
        sum += CGAL::approximate_angle(get(given, i), normals[i]);
        ++number;
      }
    return sum / number;
  };

  std::size_t failed = SC::point_normals(points, normals);
  const double angle = mean_angle();
  failed += SC::hrbf_normals(points, normals, SC::parameters::normal_map(normals));
  const double improved_angle = mean_angle();
  std::cout << "mean angle to the normals of the file, in degrees: " << angle << " estimated, "
            << improved_angle << " improved\n";

  auto H = points.add_property_map<double>("mean_curvature").first;
  failed += SC::hrbf_curvatures(points, SC::parameters::normal_map(normals).mean_curvature_map(H));
  double sum = 0, number = 0;
  for(const Point_set::Index& i : points)
    if(!std::isnan(H[i]))
    {
      sum += H[i];
      ++number;
    }
  std::cout << "mean of H: " << sum / number << ", of " << number << " of " << points.size() << " points\n";
  return failed < points.size() / 1000 && angle < 10 && improved_angle < angle && sum > 0 ? EXIT_SUCCESS
                                                                                          : EXIT_FAILURE;
}
