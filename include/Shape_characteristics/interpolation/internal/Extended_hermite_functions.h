#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_EXTENDED_HERMITE_FUNCTIONS_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_EXTENDED_HERMITE_FUNCTIONS_H

#include <Shape_characteristics/interpolation/internal/Hermite_batch.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch_factorization.h>
#include <Shape_characteristics/interpolation/internal/Hermite_function_on_lanes.h>
#include <Shape_characteristics/interpolation/internal/Lanes.h>
#ifdef SHAPE_CHARACTERISTICS_HERMITE_BATCH_FUNCTIONS_ARE_COMPILED
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#endif

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

/*
  Hermite_function_on_lanes of a single system, with more digits than a double has, and what else it takes to correct a solution
  that was found without them: nearly singular systems of exact data have solutions of large weights of opposite signs, in which
  the rounding errors of the matrix are seen. The matrix isn't needed for it: what a solution leaves of the right side is
  what the function leaves of the data.
*/
template <typename RadialBasisFunction>
struct Extended_hermite_functions
{
  using Number = Extended_lane::Number;
  using Batch = Basic_hermite_batch<Number>;

  static constexpr std::size_t lanes = 1;

  // whether there is anything to gain
  static constexpr bool are_useful =
      Basis_function_on_lanes<RadialBasisFunction>::is_extended &&
      std::numeric_limits<Number>::digits > std::numeric_limits<double>::digits;

  // what is to be done first
  static void prepare(Batch& batch, const RadialBasisFunction& phi);

  // says that `batch.solution` is the one
  static void take_solution(Batch& batch);

  static void evaluate(Batch& batch, const RadialBasisFunction& phi);       // value, gradient, Hessian matrix
  static void evaluate_value(Batch& batch, const RadialBasisFunction& phi); // value and gradient

  // what the solution leaves of the right side, after take_solution()
  static void find_remainder(Batch& batch, const RadialBasisFunction& phi, std::vector<double>& remainder);

private:
  using Function = Hermite_function_on_lanes<Extended_lane, RadialBasisFunction>;
  using Vector = Eigen::Matrix<Number, 3, 1>;
};

template <typename RadialBasisFunction>
void Extended_hermite_functions<RadialBasisFunction>::prepare(Batch& batch, const RadialBasisFunction& phi)
{
  Function::prepare(batch, phi);
}

template <typename RadialBasisFunction>
void Extended_hermite_functions<RadialBasisFunction>::take_solution(Batch& batch)
{
  Hermite_batch_factorization<Extended_lane>::take_solution(batch);
}

template <typename RadialBasisFunction>
void Extended_hermite_functions<RadialBasisFunction>::evaluate(Batch& batch, const RadialBasisFunction& phi)
{
  Function::template evaluate<true>(batch, phi);
}

template <typename RadialBasisFunction>
void Extended_hermite_functions<RadialBasisFunction>::evaluate_value(Batch& batch,
                                                                     const RadialBasisFunction& phi)
{
  Function::template evaluate<false>(batch, phi);
}

template <typename RadialBasisFunction>
void Extended_hermite_functions<RadialBasisFunction>::find_remainder(Batch& batch,
                                                                     const RadialBasisFunction& phi,
                                                                     std::vector<double>& remainder)
{
  const auto vector = [](const Number* const numbers) { return Vector(Eigen::Map<const Vector>(numbers)); };
  const bool are_tangents = batch.equations() == Hermite_equations::TANGENTS;
  const Number value_noise = *batch.value_noise, derivative_noise = *batch.derivative_noise;
  remainder.clear();
  Number at_first = 0; // what is left there, which has a part in the other equations
  Vector gradient_at_first = Vector::Zero();
  for(std::size_t i = 0; i < batch.centers(); ++i)
  {
    const Vector point = vector(batch.points + 3 * i), normal = vector(batch.normals + 3 * i);
    std::copy(point.data(), point.data() + 3, batch.where);
    evaluate_value(batch, phi);
    const Number* const weights = batch.weights + 4 * i;
    Number value = -batch.jet[0] - value_noise * weights[0];
    Vector gradient = normal - vector(batch.jet + 1) - derivative_noise * vector(weights + 1);
    if(i == 0)
    {
      at_first = value;
      gradient_at_first = gradient;
    }
    else
      value -= at_first + point.dot(gradient_at_first);
    remainder.push_back(double(value));
    if(are_tangents)
    {
      if(i > 0)
        gradient -= gradient_at_first;
      for(std::size_t k = 0; k < 2; ++k)
        remainder.push_back(double(gradient.dot(vector(batch.tangents + 6 * i + 3 * k))));
      if(i == 0)
        remainder.push_back(double(gradient.dot(normal)));
    }
    else
      for(Eigen::Index k = 0; k < 3; ++k)
        remainder.push_back(double(gradient[k]));
  }
}

#ifdef SHAPE_CHARACTERISTICS_HERMITE_BATCH_FUNCTIONS_ARE_COMPILED
// by another source of the program, as Hermite_batch_functions are
extern template struct Extended_hermite_functions<Inverse_multiquadric>;
extern template struct Extended_hermite_functions<Matern_9_2>;
#endif

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_EXTENDED_HERMITE_FUNCTIONS_H
