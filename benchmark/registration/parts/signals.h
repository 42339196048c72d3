#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_SIGNALS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_SIGNALS_H

#include "Scan.h"

#include <vector>

namespace registration {

/// What tells left from right at each point of a scan; 0 where it can't be computed.
struct Signals
{
  std::vector<float> flux;                         ///< F_s of the points (10.12), as printed
  std::vector<float> mean_volume, Gaussian_volume; ///< V_s (10.13) of mean and Gaussian curvature, as printed
  std::vector<float> chirality; ///< of mean curvature and curvedness, in a larger neighborhood
};

/// \param scale the unit of length, in which the thesis's features aren't free of units
Signals signals_of(const Scan& scan, double radius, double radius_of_chirality, double scale);

} // namespace registration

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_SIGNALS_H
