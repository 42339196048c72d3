#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_BATCH_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_BATCH_H

#include <Shape_characteristics/internal/Axis_scaling.h>
#include <Shape_characteristics/internal/Shape_operator_eigen.h>
#include <Shape_characteristics/interpolation/internal/Height_polynomial.h>
#include <Shape_characteristics/interpolation/internal/Hermite_fit_rules.h>
#include <Shape_characteristics/interpolation/internal/Hermite_jet.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the equations of a system
enum class Hermite_equations
{
  TANGENTS, // value and both tangential derivatives at each center, and the derivative along the normal at the first: 3m + 1
  GRADIENTS // value and gradient at each center: 4m
};

/*
  What a fit is at a point: value, gradient, upper triangle of the Hessian matrix, quality, principal curvatures and directions, as
  every `stride`-th of some numbers.
*/
class Hermite_evaluation
{
public:
  static constexpr std::size_t size = 20;

  Hermite_evaluation(const double* numbers, std::size_t stride) : m_numbers(numbers), m_stride(stride) {}

  double operator[](std::size_t k) const { return m_numbers[k * m_stride]; }

  Hermite_jet jet() const
  {
    const Hermite_evaluation& e = *this;
    Hermite_jet result;
    result.value = e[0];
    result.gradient = gradient();
    result.hessian << e[4], e[5], e[6], e[5], e[7], e[8], e[6], e[8], e[9];
    return result;
  }

  Eigen::Vector3d gradient() const { return vector(1); }

  // its curvature is that of the scaled points
  Fit_quality quality() const
  {
    Fit_quality quality;
    quality.gradient_length = (*this)[10];
    quality.largest_curvature = (*this)[11];
    return quality;
  }

  // of the level set, in space before it was compressed along an axis, times `factor`; curvatures otherwise are those of the scaled
  // points
  Shape_operator_eigen curvatures(double factor) const
  {
    Shape_operator_eigen result;
    result.min_curvature = factor * (*this)[12];
    result.max_curvature = factor * (*this)[13];
    result.min_direction = vector(14);
    result.max_direction = vector(17);
    return result;
  }

private:
  Eigen::Vector3d vector(std::size_t k) const { return {(*this)[k], (*this)[k + 1], (*this)[k + 2]}; }

  const double* m_numbers;
  std::size_t m_stride;
};

/*
  Data, matrices and solutions of some systems of equations that are solved side by side, one in each lane: those of
  Hermite_system, with values 0 and normals for derivatives, and a positive definite basis function of shape parameter 1
  (the points are scaled by it). Number `k` of lane `l` is at `k * lanes + l` of each array.

  A lane with fewer centers than the others computes with zeros for those it lacks, which leaves its result as it is,
  to the last bit.
*/
class Hermite_batch
{
public:
  static constexpr std::size_t max_lanes = 8;

  Hermite_batch() { m_memory.resize(1); }

  // begins with a batch for up to `max_centers` centers in each of `lanes` systems
  void clear(std::size_t lanes, std::size_t max_centers, Hermite_equations equations)
  {
    m_lanes = lanes;
    m_centers = max_centers;
    m_equations = equations;
    number_of_equations = equations == Hermite_equations::TANGENTS ? 3 * max_centers + 1 : 4 * max_centers;
    panels = (number_of_equations + 3) / 4;
    const std::size_t tangents_size = equations == Hermite_equations::TANGENTS ? 8 * max_centers : 6;
    const std::size_t right_sides = equations == Hermite_equations::TANGENTS ? 1 : 4;
    const std::array<std::size_t, 10> sizes = {6 * max_centers, // points, normals
                                               tangents_size,
                                               3 + Height_polynomial<double>::size, // trend, bend
                                               9, // counts, noise, unit, scaling, bends
                                               4 * panels * right_sides, // solution, noise
                                               4 * max_centers,          // weights
                                               3 * max_centers + 5,      // at the first center, polynomial
                                               3 + Hermite_evaluation::size,        // evaluation
                                               8 * panels * (panels + 1),           // matrix
                                               8 * panels + 36 * max_centers + 10}; // refinement
    std::size_t size = 0;
    for(const std::size_t s : sizes)
      size += s * lanes;
    if(m_memory.size() * s_line < size + s_line)
      m_memory.resize(size / s_line + 2);
    double* begin = m_memory[0].numbers;
    const auto next = [&](const std::size_t k)
    {
      double* result = begin;
      begin += sizes[k] * lanes;
      return result;
    };
    points = next(0);
    normals = points + 3 * max_centers * lanes;
    tangents = next(1);
    along_tangents = tangents + 6 * max_centers * lanes;
    trend = next(2);
    bend = trend + 3 * lanes;
    count = next(3);
    value_noise = count + lanes;
    derivative_noise = value_noise + lanes;
    unit = derivative_noise + lanes;
    axis = unit + lanes;
    compression = axis + 3 * lanes;
    bends = compression + lanes;
    solution = next(4);
    first_noise = solution + 4 * panels * lanes;
    weights = next(5);
    at_first = next(6);
    polynomial = at_first + 3 * max_centers * lanes;
    where = next(7);
    jet = where + 3 * lanes;
    matrix = next(8);
    right_side = next(9);
    known = right_side + 4 * panels * lanes;
    exact_weights = known + 4 * panels * lanes;
    jets_at_centers = exact_weights + 8 * max_centers * lanes;
    split_points = jets_at_centers + 8 * max_centers * lanes;
    split_weights = split_points + 6 * max_centers * lanes;
    split_functions = split_weights + 8 * max_centers * lanes;
    exact_polynomial = split_functions + 6 * max_centers * lanes;
    smallest_count = max_centers;
    is_any_scaled = false;
  }

  std::size_t lanes() const { return m_lanes; }
  // Always inline: into functions that are tuned otherwise than the rest, GCC doesn't inline on its own.
  [[gnu::always_inline]] std::size_t centers() const { return m_centers; }
  [[gnu::always_inline]] Hermite_equations equations() const { return m_equations; }

  void set(double* array, std::size_t k, std::size_t lane, double value)
  {
    array[k * m_lanes + lane] = value;
  }
  double get(const double* array, std::size_t k, std::size_t lane) const { return array[k * m_lanes + lane]; }

  // three numbers from number `k` on
  void set_vector(double* array, std::size_t k, std::size_t lane, const Eigen::Vector3d& v)
  {
    set(array, k, lane, v.x());
    set(array, k + 1, lane, v.y());
    set(array, k + 2, lane, v.z());
  }

  void set_count(std::size_t lane, std::size_t number_of_centers)
  {
    set(count, 0, lane, double(number_of_centers));
    smallest_count = (std::min)(smallest_count, number_of_centers);
  }

  void set_scaling(std::size_t lane, const Axis_scaling& scaling)
  {
    set_vector(axis, 0, lane, scaling.axis);
    set(compression, 0, lane, scaling.factor - 1.);
    is_any_scaled = is_any_scaled || !scaling.is_identity();
  }

  Hermite_evaluation evaluation_of(std::size_t lane) const { return {jet + lane, m_lanes}; }

  // after solving: the logarithm of the probability density of the data, up to a constant
  double log_likelihood_of(std::size_t lane) const
  {
    double result = -0.5 * mahalanobis_square[lane] + std::log(inverse_root_of_noise[lane]);
    // Four pivots are of 1e-6 or more each; their product is a number whatever becomes of that of all.
    for(std::size_t p = 0; p < panels; ++p)
    {
      const std::size_t corner = panel(p) + 16 * p;
      result += std::log((get(matrix, corner, lane) * get(matrix, corner + 5, lane)) *
                         (get(matrix, corner + 10, lane) * get(matrix, corner + 15, lane)));
    }
    return result;
  }

  // first number of panel `p` of the matrix: of four rows of the lower triangle, column by column
  [[gnu::always_inline]] static std::size_t panel(std::size_t p) { return 8 * p * (p + 1); }

  std::size_t number_of_equations = 0, panels = 0;
  double radius = 0.;             // largest distance of a center from the first
  std::size_t smallest_count = 0; // centers that no lane lacks
  double* points = nullptr;       // 3 numbers for each center
  double* normals = nullptr;      // 3 numbers for each center
  double* tangents =
      nullptr; // 6 numbers for each center, found from the normals; of GRADIENTS, for the trend
  double* along_tangents = nullptr; // of TANGENTS: how far each center lies along its tangents, 2 numbers
  double* trend = nullptr;          // 3 numbers; of TANGENTS also the normal of the first center
  double* bend = nullptr;        // Height_polynomial over the tangents of the first center, or of the trend
  double* count = nullptr;       // number of centers
  double* value_noise = nullptr; // variances of the data
  double* derivative_noise = nullptr;
  double* unit = nullptr; // root mean square distance of the points from the first
  double* axis =
      nullptr; // of unit length: along it, space is the number in `compression` plus 1 times as long
  double* compression = nullptr;
  double* bends = nullptr;    // of GRADIENTS: whether the trend may, 1 or 0
  bool is_any_scaled = false; // whether `compression` is other than 0
  double* solution = nullptr;
  // of GRADIENTS: how much of the noise of each derivative at the first center is in an equation, 3 right sides more; the matrix
  // leaves it out
  double* first_noise = nullptr;
  double* weights = nullptr;    // of the basis function and its gradient: 4 numbers for each center
  double* at_first = nullptr;   // psi, P and B of Basis_function_on_lanes between each center and the first
  double* polynomial = nullptr; // what the weights leave out: constant, linear and quadratic terms, 5 numbers
  double* where = nullptr;      // point to evaluate at
  double* jet = nullptr;        // what was evaluated there
  double* matrix = nullptr;     // after solving: its Cholesky factor, with inverse diagonal
  double* right_side = nullptr; // what `solution` was before
  // of Hermite_refinement_on_lanes: the solution it was given; then numbers with more digits: the weights and the polynomial, and
  // what function and noise are at each center (value and gradient)
  double* known = nullptr;
  double* exact_weights = nullptr;
  double* exact_polynomial = nullptr;
  double* jets_at_centers = nullptr;
  // of Hermite_refinement_on_lanes: what is multiplied there, in two parts: points, weights, and psi, P and B between a center and others
  double* split_points = nullptr;
  double* split_weights = nullptr;
  double* split_functions = nullptr;
  alignas(64) std::array<double, max_lanes> is_refined{};           // which solutions are to be: 1 or 0
  alignas(64) std::array<double, max_lanes> is_positive_definite{}; // after solving: 1 or 0
  // after solving: of what noise that isn't in the matrix adds to the determinant
  alignas(64) std::array<double, max_lanes> inverse_root_of_noise{};
  // after solving: of the data from the trend; on average the number of equations, if their covariance is what the matrix says
  alignas(64) std::array<double, max_lanes> mahalanobis_square{};
  // after solving: the sum of the squares of the weights, but of those of the first center
  alignas(64) std::array<double, max_lanes> weight_square{};
  // after solving: what the function leaves of the data, but at the first center, as a sum of squares, each divided
  // by the variance of its noise
  alignas(64) std::array<double, max_lanes> residual{};

private:
  static constexpr std::size_t s_line = 8;
  struct alignas(64) Line
  {
    double numbers[s_line];
  };

  std::size_t m_lanes = 1;
  std::size_t m_centers = 0;
  Hermite_equations m_equations = Hermite_equations::TANGENTS;
  std::vector<Line> m_memory;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_HERMITE_BATCH_H
