#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_INTERPOLATION_DATA_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_INTERPOLATION_DATA_H

#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/Polyharmonic_logarithmic.h>

#include <CGAL/Kernel_traits.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// What interpolants do with their input before the system of equations: check it, convert it, scale it.

template <typename Range>
using Range_value = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

template <typename PointRange>
using Kernel_of_points = typename CGAL::Kernel_traits<Range_value<PointRange>>::Kernel;

template <typename Range, typename T, typename = void>
constexpr bool is_range_of_v = false;
template <typename Range, typename T>
constexpr bool is_range_of_v<Range, T, std::void_t<Range_value<Range>>> =
    std::is_convertible_v<Range_value<Range>, T>;

// Whether a basis function has second derivatives at the origin, without which there are no equations for normals.
template <typename RadialBasisFunction>
constexpr bool suits_normals = true;
template <>
inline constexpr bool suits_normals<Polyharmonic<1>> = false;
template <>
inline constexpr bool suits_normals<Polyharmonic_logarithmic<2>> = false;

template <typename RadialBasisFunction>
void require_basis_function_for_normals(const char* caller)
{
  if(!suits_normals<RadialBasisFunction>)
    throw std::invalid_argument(std::string(caller) +
                                ": normals need a basis function with second derivatives at the origin: "
                                "`Polyharmonic<3>`, `Polyharmonic_logarithmic<4>`, or greater exponents");
}

template <typename RadialBasisFunction>
void require_valid_basis_function(const char* caller)
{
  if(!RadialBasisFunction::is_valid)
    throw std::invalid_argument(std::string(caller) +
                                ": `basis_function` is not a valid one (`Polyharmonic<t>` needs an "
                                "odd, `Polyharmonic_logarithmic<t>` an even exponent)");
}

// the elements as columns
template <typename Range>
Eigen::Matrix3Xd coordinates_of(const char* caller, const char* parameter, const Range& range)
{
  std::vector<Eigen::Vector3d> columns;
  for(const auto& element : range)
  {
    columns.push_back(to_eigen(element));
    if(!columns.back().allFinite())
      throw std::invalid_argument(std::string(caller) + ": a coordinate in `" + parameter +
                                  "` is not finite");
  }
  if(columns.empty())
    throw std::invalid_argument(std::string(caller) + ": `" + parameter + "` is empty");
  Eigen::Matrix3Xd result(3, columns.size());
  for(std::size_t i = 0; i < columns.size(); ++i)
    result.col(i) = columns[i];
  return result;
}

template <typename Range>
Eigen::Matrix3Xd unit_vectors_of(const char* caller, const char* parameter, const Range& range)
{
  Eigen::Matrix3Xd result = coordinates_of(caller, parameter, range);
  for(auto column : result.colwise())
  {
    const double largest = column.cwiseAbs().maxCoeff();
    if(largest == 0)
      throw std::invalid_argument(std::string(caller) + ": an element of `" + parameter +
                                  "` is the zero vector");
    column /= largest; // so that no square overflows or vanishes
    column.normalize();
  }
  return result;
}

// The frame of the data: origin in their centroid, unit of length their root mean square distance from it.
class Unit_frame
{
public:
  Unit_frame() = default;

  explicit Unit_frame(const Eigen::Matrix3Xd& points) : origin(points.col(0))
  {
    // relative to one of the points, and scaled by the largest deviation: sums of far or huge coordinates
    // would lose digits or overflow
    Eigen::Matrix3Xd local = points.colwise() - origin;
    const double largest = local.cwiseAbs().maxCoeff();
    if(!(largest > 0))
      return;
    local /= largest;
    const Eigen::Vector3d mean = local.rowwise().mean();
    local.colwise() -= mean;
    origin += largest * mean;
    length = largest * std::sqrt(local.squaredNorm() / static_cast<double>(local.cols()));
    degenerate = false;
  }

  Unit_frame(const Eigen::Matrix3Xd& points, double size)
    : origin(points.col(0)),
      length(size),
      degenerate(false)
  {}

  // all points coincide; the size is 1 then
  bool is_degenerate() const noexcept { return degenerate; }
  double size() const noexcept { return length; }

  Eigen::Vector3d to_local(const Eigen::Vector3d& p) const { return (p - origin) / length; }

  void apply(Eigen::Matrix3Xd& points) const
  {
    points.colwise() -= origin;
    points /= length;
  }

private:
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double length = 1;
  bool degenerate = true;
};

// in quadratic time, as what follows
inline double smallest_distance(const Eigen::Matrix3Xd& points)
{
  double square = std::numeric_limits<double>::infinity();
  for(Eigen::Index i = 0; i < points.cols(); ++i)
    for(Eigen::Index j = 0; j < i; ++j)
      square = (std::min)(square, (points.col(i) - points.col(j)).squaredNorm());
  return std::sqrt(square);
}

// mean distance of a point to its nearest neighbor, in quadratic time as anything else that is done with dense matrices;
// 0 for a single point
inline double mean_spacing(const Eigen::Matrix3Xd& points)
{
  if(points.cols() < 2)
    return 0;
  double sum = 0;
  for(Eigen::Index i = 0; i < points.cols(); ++i)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for(Eigen::Index j = 0; j < points.cols(); ++j)
      if(j != i)
        nearest = std::min(nearest, (points.col(i) - points.col(j)).squaredNorm());
    sum += std::sqrt(nearest);
  }
  return sum / static_cast<double>(points.cols());
}

// the basis function with the shape parameter for which phi(distance) is half, or double, phi(0); basis functions are
// monotone in the shape parameter
template <typename RadialBasisFunction>
RadialBasisFunction shape_parameter_of_half_value(const RadialBasisFunction& phi, double distance)
{
  if(!(distance > 0))
    return phi;
  const auto is_beyond = [&](double logarithm)
  {
    const double ratio = phi.with_shape_parameter(std::exp(logarithm))(distance) / phi(0);
    return ratio < 0.5 || ratio > 2;
  };
  double low = -200, high = 200; // the logarithm: the parameter is a power of 1 / distance, up to the third
  while(high - low > 1e-10)
  {
    const double middle = 0.5 * (low + high);
    (is_beyond(middle) ? high : low) = middle;
  }
  return phi.with_shape_parameter(std::exp(low));
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_INTERPOLATION_DATA_H
