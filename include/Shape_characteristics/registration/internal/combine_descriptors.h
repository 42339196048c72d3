#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_COMBINE_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_COMBINE_DESCRIPTORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/registration/internal/check_statuses.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// of what is made of two: the first that isn't estimated says why
inline Estimation_status combined_status(Estimation_status a, Estimation_status b)
{
  if(!is_estimated(a))
    return a;
  return b == Estimation_status::ESTIMATED ? a : b;
}

inline void check_combination(const Descriptor_matrix& a, const Descriptor_matrix& b)
{
  for(const Descriptor_matrix* m : {&a, &b})
    check_statuses(*m);
  if(a.status.size() != b.status.size())
    throw std::invalid_argument(
        "Shape_characteristics: descriptors that are combined must have the same number of rows");
}

// `status`, or why there is nothing: what isn't finite is no descriptor, and all of the row becomes NaN then
inline Estimation_status finish_row(Estimation_status status, std::size_t dimension, float* row)
{
  if(is_estimated(status) &&
     !std::all_of(row, row + dimension, [](const float x) { return std::isfinite(x); }))
    status = Estimation_status::DEGENERATE; // a product out of the range of numbers
  if(!is_estimated(status))
    std::fill_n(row, dimension, std::numeric_limits<float>::quiet_NaN());
  return status;
}

inline std::vector<float> checked_factors(const std::vector<double>& factors, std::size_t dimension)
{
  if(!factors.empty() && factors.size() != dimension)
    throw std::invalid_argument("Shape_characteristics: there must be a factor for each component appended");
  std::vector<float> result(dimension, 1.f);
  for(std::size_t k = 0; k < factors.size(); ++k)
  {
    result[k] = float(factors[k]);
    if(!std::isfinite(result[k]))
      throw std::invalid_argument("Shape_characteristics: factors must be finite");
  }
  return result;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_COMBINE_DESCRIPTORS_H
