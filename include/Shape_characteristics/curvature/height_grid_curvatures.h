#ifndef SHAPE_CHARACTERISTICS_CURVATURE_HEIGHT_GRID_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_HEIGHT_GRID_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/height_field_curvatures.h>
#include <Shape_characteristics/curvature/internal/estimate_curvatures.h>
#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/callback_of.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace Shape_characteristics {
namespace internal {

template <typename HeightRange>
class Height_grid_estimator
{
public:
  struct Workspace
  {};

  Height_grid_estimator(const HeightRange& heights,
                        std::size_t columns,
                        double spacing_u,
                        double spacing_v,
                        Height_field_normal normal)
    : m_first(std::begin(heights)),
      m_size(std::size_t(std::distance(std::begin(heights), std::end(heights)))),
      m_columns(columns),
      m_spacing_u(spacing_u),
      m_spacing_v(spacing_v),
      m_normal(normal)
  {
    if(m_size != 0 && (columns == 0 || m_size % columns != 0))
      throw std::invalid_argument("Shape_characteristics: height_grid_curvatures: " + std::to_string(m_size) +
                                  " heights don't fill rows of " + std::to_string(columns) + " columns");
    for(const double spacing : {spacing_u, spacing_v})
      if(!(spacing > 0. && std::isfinite(spacing)))
        throw std::invalid_argument(
            "Shape_characteristics: height_grid_curvatures: a spacing is not positive, or not finite");
  }

  std::size_t size() const { return m_size; }
  std::size_t number_of_rows() const { return m_size == 0 ? 0 : m_size / m_columns; }

  Curvature_estimate operator()(std::size_t i, Workspace&) const
  {
    if(!std::isfinite(height(i)))
      return Curvature_estimate(Estimation_status::NON_FINITE_INPUT);
    const Neighbors neighbors(*this, i);
    const Stencil along_u([&](int k) { return neighbors(k, 0); }),
        along_v([&](int k) { return neighbors(0, k); });
    double mixed;
    bool is_whole = along_u.is_central() && along_v.is_central();
    if(!along_u.is_valid() || !along_v.is_valid() ||
       !mixed_difference(neighbors, along_u, along_v, mixed, is_whole))
      return Curvature_estimate(Estimation_status::FEW_NEIGHBOURS);

    const double sign = m_normal == Height_field_normal::UPWARD ? 1. : -1.;
    const Eigen::Vector3d gradient(-sign * (along_u.first() / m_spacing_u),
                                   -sign * (along_v.first() / m_spacing_v), sign);
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    hessian(0, 0) = -sign * (along_u.second() / m_spacing_u / m_spacing_u);
    hessian(0, 1) = hessian(1, 0) = -sign * (mixed / m_spacing_u / m_spacing_v);
    hessian(1, 1) = -sign * (along_v.second() / m_spacing_v / m_spacing_v);
    return Curvature_estimate(is_whole ? Estimation_status::ESTIMATED : Estimation_status::BORDER,
                              curvatures_of_implicit(gradient, hessian));
  }

private:
  // heights near a sample, relative to its own; not finite where there is none
  class Neighbors
  {
  public:
    Neighbors(const Height_grid_estimator& grid, std::size_t i)
      : m_grid(grid),
        m_column(i % grid.m_columns),
        m_row(i / grid.m_columns),
        m_height(grid.height(i))
    {}

    double operator()(int du, int dv) const
    {
      // a step below zero is a huge number
      const std::size_t column = m_column + std::size_t(du), row = m_row + std::size_t(dv);
      if(column >= m_grid.m_columns || row >= m_grid.number_of_rows())
        return std::numeric_limits<double>::quiet_NaN();
      return m_grid.height(row * m_grid.m_columns + column) - m_height;
    }

  private:
    const Height_grid_estimator& m_grid;
    std::size_t m_column, m_row;
    double m_height;
  };

  // Differences along one axis, for a spacing of 1, and the coefficients of the first one at the places -2 to 2.
  class Stencil
  {
  public:
    template <typename Line> // relative to that at 0
    explicit Stencil(const Line& line)
    {
      const double before = line(-1), after = line(1);
      if(std::isfinite(before) && std::isfinite(after))
      {
        m_is_central = m_is_valid = true;
        m_first = (after - before) / 2.;
        m_second = after + before;
        m_coefficients[1] = -.5;
        m_coefficients[3] = .5;
        return;
      }
      for(const int side : {1, -1})
      {
        const double a = line(side), b = line(2 * side), c = line(3 * side);
        if(!std::isfinite(a) || !std::isfinite(b))
          continue;
        m_is_valid = true;
        m_first = side * (2. * a - b / 2.);
        m_second = std::isfinite(c) ? 4. * b - 5. * a - c : b - 2. * a;
        m_coefficients[2] = -1.5 * side;
        m_coefficients[std::size_t(2 + side)] = 2. * side;
        m_coefficients[std::size_t(2 + 2 * side)] = -.5 * side;
      }
    }

    bool is_valid() const { return m_is_valid; }
    bool is_central() const { return m_is_central; }
    double first() const { return m_first; }
    double second() const { return m_second; }
    double coefficient(int k) const { return m_coefficients[std::size_t(k + 2)]; }

  private:
    bool m_is_valid = false, m_is_central = false;
    double m_first = 0., m_second = 0.;
    std::array<double, 5> m_coefficients = {0., 0., 0., 0., 0.};
  };

  // The difference of first differences, of second order. Where a height is missing for that, the mean over two quadrants
  // opposite of each other, which is of second order as well, or over those that there are.
  static bool mixed_difference(const Neighbors& neighbors,
                               const Stencil& along_u,
                               const Stencil& along_v,
                               double& mixed,
                               bool& is_whole)
  {
    mixed = 0.;
    for(int j = -2; j <= 2; ++j)
      for(int i = -2; i <= 2; ++i)
        if(const double c = along_u.coefficient(i) * along_v.coefficient(j); c != 0.)
          mixed += c * neighbors(i, j);
    if(std::isfinite(mixed))
      return true;

    is_whole = false;
    const auto quadrant = [&](int i, int j)
    { return i * j * (neighbors(i, j) - neighbors(i, 0) - neighbors(0, j)); };
    for(const int side : {1, -1})
    {
      mixed = (quadrant(1, side) + quadrant(-1, -side)) / 2.;
      if(std::isfinite(mixed))
        return true;
    }
    double sum = 0.;
    int count = 0;
    for(const int i : {1, -1})
      for(const int j : {1, -1})
        if(const double q = quadrant(i, j); std::isfinite(q))
        {
          sum += q;
          ++count;
        }
    mixed = sum / count;
    return count > 0;
  }

  double height(std::size_t i) const
  {
    const auto& height = m_first[typename std::iterator_traits<Iterator>::difference_type(i)];
    if constexpr(std::is_arithmetic_v<std::decay_t<decltype(height)> >) // CGAL doesn't know all of them
      return double(height);
    else
      return CGAL::to_double(height);
  }

  using Iterator = decltype(std::begin(std::declval<const HeightRange&>()));
  Iterator m_first;
  std::size_t m_size, m_columns;
  double m_spacing_u, m_spacing_v;
  Height_field_normal m_normal;
};

template <typename HeightRange, typename NamedParameters>
Height_grid_estimator<HeightRange> height_grid_estimator(const HeightRange& heights,
                                                         std::size_t columns,
                                                         double spacing_u,
                                                         double spacing_v,
                                                         const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  return Height_grid_estimator<HeightRange>(
      heights, columns, spacing_u, spacing_v,
      choose_parameter(get_parameter(np, internal_np::height_field_normal), Height_field_normal::UPWARD));
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures of a height field that is sampled on a regular grid, by finite differences (thesis, section 5.1.1).

  The sample in column \f$ i \f$ and row \f$ j \f$ is the point \f$ (i\, s_u, j\, s_v, h_{ij}) \f$ with the spacings \f$ s_u \f$
  and \f$ s_v \f$, which may differ. It has the curvatures of the Monge patch (`height_field_curvatures()`; thesis, section 4.3.3)
  with the derivatives

  \f[ h_u = \frac{h_{i+1,j} - h_{i-1,j}}{2 s_u}, \quad h_{uu} = \frac{h_{i+1,j} - 2 h_{ij} + h_{i-1,j}}{s_u^2}, \quad
      h_{uv} = \frac{h_{i+1,j+1} - h_{i-1,j+1} - h_{i+1,j-1} + h_{i-1,j-1}}{4 s_u s_v}, \f]

  and so along the rows. Their errors fall with the square of the spacings. The directions are vectors in space.

  A height that isn't finite is a hole: its own status is `NON_FINITE_INPUT`. On the border of the grid and beside holes the
  differences are one-sided, and the status is `BORDER`. They are of second order as well as long as there are four
  samples in a row (three, for the second derivative to be of first order), and the block of samples for \f$ h_{uv} \f$ has no hole.
  With fewer than three in a row or column, or none of the diagonal neighbors that \f$ h_{uv} \f$ needs, the status is
  `FEW_NEIGHBOURS`.

  Heights need no smoothing to be differentiated, but noise is: \f$ \sigma \f$ in the heights becomes about
  \f$ 2.4\, \sigma / s^2 \f$ in the second derivatives. For noisy heights, the estimators of points with normals average.

  \scConcurrencyTag
  \tparam HeightRange a range with random access (a `std::vector`, say) of numbers
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param heights the heights, one row after the other
  \param columns the number of heights in a row
  \param spacing_u the distance of samples that are next to each other in a row
  \param spacing_v the distance of rows
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{principal_curvatures_and_directions_map}
      \cgalParamDescription{gets the principal curvatures and directions}
      \cgalParamType{a model of `WritablePropertyMap` with key type `std::size_t`, the place of the sample in the range, and value type
                     `Principal_curvatures_and_directions`}
      \cgalParamDefault{they are not written}
    \cgalParamNEnd
    \cgalParamNBegin{mean_curvature_map}
      \cgalParamDescription{gets the mean curvature}
      \cgalParamType{a model of `WritablePropertyMap` with key type `std::size_t` and a number type as value type}
      \cgalParamDefault{it is not written}
    \cgalParamNEnd
    \cgalParamNBegin{Gaussian_curvature_map}
      \cgalParamDescription{gets the Gaussian curvature}
      \cgalParamType{a model of `WritablePropertyMap` with key type `std::size_t` and a number type as value type}
      \cgalParamDefault{it is not written}
    \cgalParamNEnd
    \cgalParamNBegin{status_map}
      \cgalParamDescription{gets the status}
      \cgalParamType{a model of `WritablePropertyMap` with key type `std::size_t` and value type `Estimation_status`}
      \cgalParamDefault{it is not written}
    \cgalParamNEnd
    \cgalParamNBegin{height_field_normal}
      \cgalParamDescription{the outer side: convex seen from there is positive}
      \cgalParamType{`Height_field_normal`}
      \cgalParamDefault{`Height_field_normal::UPWARD`}
    \cgalParamNEnd
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of samples that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if the heights don't fill the rows, or a spacing is not positive and finite

  Complexity: linear in the number of samples.

  \cgalExample{curvature/height_grid_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename HeightRange,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t height_grid_curvatures(const HeightRange& heights,
                                   std::size_t columns,
                                   double spacing_u,
                                   double spacing_v,
                                   const NamedParameters& np = parameters::default_values())
{
  const auto estimator = internal::height_grid_estimator(heights, columns, spacing_u, spacing_v, np);
  std::size_t failures = 0;
  internal::estimate_and_write<ConcurrencyTag>(
      estimator, estimator.size(), internal::callback_of(np),
      [&](const std::size_t first, const std::size_t last, const internal::Curvature_estimate* estimate)
      {
        for(std::size_t i = first; i < last; ++i, ++estimate)
        {
          failures += !is_estimated(estimate->status);
          internal::write_to_item(i, *estimate, np);
        }
      });
  return failures;
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one sample of a height field on a regular grid: those that `height_grid_curvatures()` of the whole
  grid gives, bit for bit.

  \tparam HeightRange a range with random access (a `std::vector`, say) of numbers
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param column the column of the sample, from 0
  \param row its row, from 0
  \param heights the heights, one row after the other
  \param columns the number of heights in a row
  \param spacing_u the distance of samples that are next to each other in a row
  \param spacing_v the distance of rows
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scVertexOutputParameters
    \cgalParamNBegin{height_field_normal}
      \cgalParamDescription{the outer side: convex seen from there is positive}
      \cgalParamType{`Height_field_normal`}
      \cgalParamDefault{`Height_field_normal::UPWARD`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument if the heights don't fill the rows, a spacing is not positive and finite, or there is no such
  sample

  Constant time.
*/
template <typename HeightRange, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status height_grid_curvatures(std::size_t column,
                                         std::size_t row,
                                         const HeightRange& heights,
                                         std::size_t columns,
                                         double spacing_u,
                                         double spacing_v,
                                         const NamedParameters& np = parameters::default_values())
{
  const auto estimator = internal::height_grid_estimator(heights, columns, spacing_u, spacing_v, np);
  if(column >= columns || row >= estimator.number_of_rows())
    throw std::invalid_argument(
        "Shape_characteristics: height_grid_curvatures: there is no sample in column " +
        std::to_string(column) + " and row " + std::to_string(row));
  typename internal::Height_grid_estimator<HeightRange>::Workspace workspace;
  return internal::write_to_references(estimator(row * columns + column, workspace), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_HEIGHT_GRID_CURVATURES_H
