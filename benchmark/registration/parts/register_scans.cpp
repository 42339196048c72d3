#include "register_scans.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/affine_conversions.h>
#include <Shape_characteristics/registration/register_partial_scans.h>

#include <CGAL/property_map.h>
#include <CGAL/tags.h>

namespace registration {

namespace SC = Shape_characteristics;

Point_range to_range(const Scan& scan)
{
  Point_range range;
  range.reserve(scan.points.size());
  for(std::size_t i = 0; i < scan.points.size(); ++i)
  {
    const Eigen::Vector3d &p = scan.points[i], &n = scan.normals[i];
    range.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  return range;
}

Registration_result
register_scans(const Point_range& source, const Point_range& target, std::size_t neighbors)
{
  using Point_and_normal = Point_range::value_type;
  const auto maps = SC::parameters::point_map(CGAL::First_of_pair_property_map<Point_and_normal>())
                        .normal_map(CGAL::Second_of_pair_property_map<Point_and_normal>());
  return SC::register_partial_scans<CGAL::Sequential_tag>(source, target, maps.number_of_neighbors(neighbors),
                                                          maps);
}

Registration_result register_scans(const Mesh& source, const Mesh& target, std::size_t neighbors)
{
  return SC::register_partial_scans<CGAL::Sequential_tag>(source, target,
                                                          SC::parameters::number_of_neighbors(neighbors));
}

Eigen::Isometry3d motion(const Registration_result& result)
{
  return Eigen::Isometry3d(SC::internal::affine_to_eigen(result.transformation).matrix());
}

} // namespace registration
