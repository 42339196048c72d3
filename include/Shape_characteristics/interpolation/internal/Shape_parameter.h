#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SHAPE_PARAMETER_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SHAPE_PARAMETER_H

#include <cmath>
#include <stdexcept>

namespace Shape_characteristics {
namespace internal {

// What the radial basis functions with a shape parameter have in common. `Basis_function` derives from this class
// and inherits its constructors.
template <typename Basis_function>
class Shape_parameter
{
public:
  static constexpr bool has_shape_parameter = true;
  static constexpr bool is_valid = true;

  Shape_parameter() = default;

  explicit Shape_parameter(double epsilon) : epsilon(epsilon), is_set(true)
  {
    if(!(std::isfinite(epsilon) && epsilon > 0))
      throw std::invalid_argument("Shape_characteristics: the shape parameter `epsilon` of a radial basis "
                                  "function must be finite and positive");
  }

  double shape_parameter() const noexcept { return epsilon; }
  bool is_shape_parameter_set() const noexcept { return is_set; }
  Basis_function with_shape_parameter(double value) const { return Basis_function(value); }

protected:
  double epsilon = 1;

private:
  bool is_set = false;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_SHAPE_PARAMETER_H
