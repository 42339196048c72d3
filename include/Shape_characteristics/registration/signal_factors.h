#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_SIGNAL_FACTORS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_SIGNAL_FACTORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/registration/internal/check_statuses.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  finds the factors that give signals the root mean square `weight`, whatever their units and sizes: for each column, `weight`
  divided by the root mean square of that column over all rows of all matrices that have a value.

  Descriptors that are compared need the same factors: give the signals of source and target at once.

  \tparam Matrices `Descriptor_matrix`, as often as wanted

  \param weight what the root mean square shall be. 60 suits FPFH, whose three histograms have the sum 100 each.
  \param first signals
  \param rest more of the same signals, of other scans

  \return a factor for each column; 0 for a column of zeros or without values

  \throws std::invalid_argument if the weight is not finite, the numbers of columns differ, or a matrix has not a status for each row

  Complexity: linear in the size of the matrices.
*/
template <typename... Matrices>
std::vector<double> signal_factors(double weight, const Descriptor_matrix& first, const Matrices&... rest)
{
  if(!std::isfinite(weight))
    throw std::invalid_argument("Shape_characteristics: the weight of signals must be finite");
  for(const Descriptor_matrix* m : {&first, &rest...})
  {
    if(m->values.cols() != first.values.cols())
      throw std::invalid_argument("Shape_characteristics: signals must have as many columns as others");
    internal::check_statuses(*m);
  }
  std::vector<double> factors;
  for(Eigen::Index k = 0; k < first.values.cols(); ++k)
  {
    // Relative to the largest: squares of tiny units are out of the range of numbers.
    double largest = 0., sum = 0., count = 0.;
    const auto for_each_value = [&](const auto& function)
    {
      for(const Descriptor_matrix* m : {&first, &rest...})
        for(std::size_t i = 0; i < m->status.size(); ++i)
          if(is_estimated(m->status[i]))
            function(double(m->values(Eigen::Index(i), k)));
    };
    for_each_value([&](const double x) { largest = std::abs(x) > largest ? std::abs(x) : largest; });
    if(largest > 0.)
      for_each_value(
          [&](const double x)
          {
            sum += x / largest * (x / largest);
            count += 1.;
          });
    factors.push_back(sum > 0. ? weight / largest / std::sqrt(sum / count) : 0.);
  }
  return factors;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_SIGNAL_FACTORS_H
