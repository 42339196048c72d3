// Point feature histograms of one kind of place and another: what they look like on a sphere, on a cylinder, in a corner.
#include <Shape_characteristics/descriptors/pfh_descriptors.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace SC = Shape_characteristics;
namespace params = SC::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Oriented_point = std::pair<Kernel::Point_3, Kernel::Vector_3>;

int main()
{
  std::vector<Oriented_point> sphere, cylinder, edge;
  for(int i = -10; i <= 10; ++i)
    for(int j = -10; j <= 10; ++j)
    {
      const double x = 0.04 * i, y = 0.04 * j;
      const double z = std::sqrt(1 - x * x - y * y);
      sphere.emplace_back(Kernel::Point_3(x, y, z), Kernel::Vector_3(x, y, z));
      cylinder.emplace_back(Kernel::Point_3(std::sin(x), y, std::cos(x)),
                            Kernel::Vector_3(std::sin(x), 0, std::cos(x)));
      edge.emplace_back(i < 0 ? Kernel::Point_3(0, y, x) : Kernel::Point_3(x, y, 0),
                        i < 0 ? Kernel::Vector_3(-1, 0, 0) : Kernel::Vector_3(0, 0, 1));
    }

  const std::vector<std::size_t> center = {21 * 10 + 10};
  const auto describe = [&](const std::string& name, const std::vector<Oriented_point>& points)
  {
    SC::Descriptor_matrix d =
        SC::pfh_descriptors(points, params::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
                                        .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>())
                                        .neighbor_radius(0.3)
                                        .descriptor_samples(center));
    std::cout << name << ":";
    for(Eigen::Index k = 0; k < d.values.cols(); ++k)
      if(d.values(0, k) > 1)
        std::cout << "  " << d.values(0, k) << " % in column " << k;
    std::cout << '\n';
    return d;
  };
  const SC::Descriptor_matrix of_sphere = describe("sphere", sphere);
  const SC::Descriptor_matrix of_cylinder = describe("cylinder", cylinder);
  const SC::Descriptor_matrix of_edge = describe("edge", edge);

  const float similar = (of_sphere.values - of_cylinder.values).norm();
  const float different = (of_sphere.values - of_edge.values).norm();
  std::cout << "The sphere differs from the cylinder by " << similar << ", from the edge by " << different
            << ".\n";
  return similar < different ? EXIT_SUCCESS : EXIT_FAILURE;
}
