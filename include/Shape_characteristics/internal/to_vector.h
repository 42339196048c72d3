#ifndef SHAPE_CHARACTERISTICS_INTERNAL_TO_VECTOR_H
#define SHAPE_CHARACTERISTICS_INTERNAL_TO_VECTOR_H

#include <Shape_characteristics/internal/to_number.h>

#include <CGAL/Kernel_traits.h>

#include <Eigen/Core>

namespace Shape_characteristics {
namespace internal {

// of a result, which may be NaN
template <typename Vector_3>
Vector_3 to_vector(const Eigen::Vector3d& v)
{
  using FT = typename CGAL::Kernel_traits<Vector_3>::Kernel::FT;
  return Vector_3(to_number<FT>(v.x()), to_number<FT>(v.y()), to_number<FT>(v.z()));
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_TO_VECTOR_H
