// Curvatures of point sets with normals: of a CGAL::Point_set_3, and of a vector of whatever has a point and a normal.
#include "../support/data_file.h"

#include <Shape_characteristics/curvature/hrbf_curvatures.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO/XYZ.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <tuple>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

int main()
{
  Point_set points;
  std::ifstream file(support::data_file("points_3/kitten.xyz"));
  if(!CGAL::IO::read_XYZ(file, points) || !points.has_normal_map())
    return EXIT_FAILURE;

  // A Point_set_3 knows its points and normals. The neighborhood is of 18 nearest points if nothing is said.
  auto H = points.add_property_map<double>("mean_curvature").first;
  auto status = points.add_property_map<SC::Estimation_status>("status").first;
  const std::size_t failed =
      SC::hrbf_curvatures(points, SC::parameters::mean_curvature_map(H).status_map(status));
  std::size_t convex = 0;
  for(const Point_set::Index& i : points)
    convex += SC::is_estimated(status[i]) && H[i] > 0;
  std::cout << points.size() << " points, " << failed << " could not be estimated, " << convex
            << " are convex\n";

  // Of other ranges it is said where points and normals are, and where the results shall go. Here all are in
  // one element of a vector; maps are cheap to copy, and read or write an element.
  using Element = std::tuple<Kernel::Point_3, Kernel::Vector_3, double>;
  std::vector<Element> elements;
  for(const Point_set::Index& i : points)
    elements.emplace_back(points.point(i), points.normal(i), 0.);
  const std::size_t failed_elements =
      SC::hrbf_curvatures(elements, SC::parameters::point_map(CGAL::Nth_of_tuple_property_map<0, Element>())
                                        .normal_map(CGAL::Nth_of_tuple_property_map<1, Element>())
                                        .mean_curvature_map(CGAL::Nth_of_tuple_property_map<2, Element>())
                                        .number_of_neighbors(18));

  bool is_equal = failed == failed_elements;
  std::size_t n = 0;
  for(const Point_set::Index& i : points)
  {
    const double value = std::get<2>(elements[n++]);
    is_equal = is_equal && (value == H[i] || !SC::is_estimated(status[i]));
  }
  std::cout << "the vector has " << (is_equal ? "the same" : "other") << " curvatures\n";
  return is_equal && failed < points.size() / 10 && convex > points.size() / 2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
