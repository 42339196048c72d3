#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_CONVERSIONS_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_CONVERSIONS_H

#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/internal/to_number.h>
#include <Shape_characteristics/internal/to_vector.h>

#include <CGAL/number_utils.h>

namespace Shape_characteristics {

namespace internal {

// between CGAL's types and the ones that are computed with

// any matrix type with m(i, j); its symmetric part's upper triangle
template <typename Matrix>
Eigen::Matrix3d to_eigen_matrix(const Matrix& m)
{
  Eigen::Matrix3d result;
  for(int i = 0; i < 3; ++i)
    for(int j = i; j < 3; ++j)
      result(i, j) = result(j, i) = CGAL::to_double(m(i, j));
  return result;
}

template <typename GeomTraits>
Principal_curvatures_and_directions<GeomTraits> to_principal_curvatures(const Shape_operator_eigen& e)
{
  using FT = typename GeomTraits::FT;
  using Vector_3 = typename GeomTraits::Vector_3;
  return {to_number<FT>(e.min_curvature), to_number<FT>(e.max_curvature),
          to_vector<Vector_3>(e.min_direction), to_vector<Vector_3>(e.max_direction)};
}

} // namespace internal

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_CONVERSIONS_H
