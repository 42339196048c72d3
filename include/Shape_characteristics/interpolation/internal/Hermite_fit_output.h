#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_FIT_OUTPUT_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_FIT_OUTPUT_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/Shape_operator_eigen.h>
#include <Shape_characteristics/interpolation/Local_hermite_rbf.h>

#include <cstddef>
#include <functional>

namespace Shape_characteristics {
namespace internal {

// Where fits go, those of several threads at a time: each sample to one of the functions. They aren't types of the caller's: what
// fits is compiled once for a surface and a basis function.
struct Hermite_fit_output
{
  // the function that was fitted at a sample, or why there is none
  std::function<void(std::size_t, const Local_implicit_surface&)> surface;

  // Instead, if it is given, the principal curvatures of a fit, where they were computed side by side with others. They may be too
  // large for a number.
  std::function<void(std::size_t, Estimation_status, const Shape_operator_eigen&)> curvatures = {};
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_FIT_OUTPUT_H
