#ifndef SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_MAKE_UNIT_H
#define SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_MAKE_UNIT_H

#include <Shape_characteristics/Estimation_status.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Gives all normals unit length. Those that have it, up to rounding, keep their bits, and so do those that differ from such
// by a power of two; samples of those that have no direction get the status `failure`, if nothing else was wrong with them.
inline void make_unit(std::vector<Eigen::Vector3d>& normals,
                      std::vector<Estimation_status>& status,
                      Estimation_status failure)
{
  constexpr double rounding = 8. * std::numeric_limits<double>::epsilon();
  for(std::size_t i = 0; i < normals.size(); ++i)
  {
    Eigen::Vector3d& n = normals[i];
    const double largest = n.cwiseAbs().maxCoeff();
    if(!n.allFinite() || largest == 0.)
    {
      if(is_estimated(status[i]))
        status[i] = failure;
      continue;
    }
    if(!(largest > .5 && largest <= 1.)) // as it is in unit vectors
    {
      int exponent;
      if(std::frexp(largest, &exponent) == .5)
        --exponent;
      for(Eigen::Index c = 0; c < 3; ++c)
        n[c] = std::ldexp(n[c], -exponent);
    }
    if(const double square = n.squaredNorm(); std::abs(square - 1.) > rounding)
      n /= std::sqrt(square);
  }
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_INTERNAL_MAKE_UNIT_H
