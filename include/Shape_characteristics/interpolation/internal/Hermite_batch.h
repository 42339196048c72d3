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
                                               4 * panels * right_sides,  // solution, noise
                                               4 * max_centers,           // weights
                                               3 * max_centers + 5,       // at the first center, polynomial
                                               3 + s_jet,                 // evaluation
                                               8 * panels * (panels + 1), // matrix
                                               8 * panels + 16 * max_centers + 10}; // refinement
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
    exact_polynomial = jets_at_centers + 8 * max_centers * lanes;
    smallest_count = max_centers;
    is_any_scaled = false;
    wants_log_likelihood = false;
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

  // what was evaluated in a lane
  Hermite_jet jet_of(std::size_t lane) const
  {
    Hermite_jet result;
    result.value = get(jet, 0, lane);
    result.gradient = gradient_of(lane);
    const double xx = get(jet, 4, lane), xy = get(jet, 5, lane), xz = get(jet, 6, lane),
                 yy = get(jet, 7, lane), yz = get(jet, 8, lane), zz = get(jet, 9, lane);
    result.hessian << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return result;
  }

  Eigen::Vector3d gradient_of(std::size_t lane) const
  {
    return {get(jet, 1, lane), get(jet, 2, lane), get(jet, 3, lane)};
  }

  // of what was evaluated in a lane; its curvature is that of the scaled points
  Fit_quality quality_of(std::size_t lane) const
  {
    Fit_quality quality;
    quality.gradient_length = get(jet, 10, lane);
    quality.largest_curvature = get(jet, 11, lane);
    return quality;
  }

  // of the level set of what was evaluated in a lane, in space before it was compressed along an axis, times `factor`; curvatures
  // otherwise are those of the scaled points
  Shape_operator_eigen curvatures_of(std::size_t lane, double factor) const
  {
    Shape_operator_eigen result;
    result.min_curvature = factor * get(jet, 12, lane);
    result.max_curvature = factor * get(jet, 13, lane);
    result.min_direction = {get(jet, 14, lane), get(jet, 15, lane), get(jet, 16, lane)};
    result.max_direction = {get(jet, 17, lane), get(jet, 18, lane), get(jet, 19, lane)};
    return result;
  }

  // first number of panel `p` of the matrix: of four rows of the lower triangle, column by column
  [[gnu::always_inline]] static std::size_t panel(std::size_t p) { return 8 * p * (p + 1); }

  // value, gradient, upper triangle of the Hessian matrix, quality, principal curvatures and directions
  static constexpr std::size_t s_jet = 20;

  std::size_t number_of_equations = 0, panels = 0;
  bool wants_log_likelihood = false;
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
  alignas(64) std::array<double, max_lanes> is_refined{};           // which solutions are to be: 1 or 0
  alignas(64) std::array<double, max_lanes> is_positive_definite{}; // after solving: 1 or 0
  alignas(64) std::array<double, max_lanes> log_likelihood{}; // after solving, if wanted: up to a constant
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
