#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SURFACES_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SURFACES_H

#include "Triangle_arrays.h"
#include "exact_curvature.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace adaptive {

/// Which surfaces: those from whose errors the constants of adaptive_curvatures() are learned; those of the thesis's tables, further
/// ones, and those of technical parts. Only the first have a part in the constants.
enum class Purpose
{
  CALIBRATION,
  TABLES,
  VALIDATION,
  SHAPES
};

/// A tessellated surface that knows the truth.
struct Surface
{
  std::string shape;
  std::string tessellation; ///< empty, if there is only one of the shape
  std::function<benchmark_support::Triangle_arrays(std::uint64_t seed)> mesh;
  std::function<benchmark_support::Exact_curvature(const benchmark_support::Vector&)> exact;
  bool is_noise_added = true; ///< in the experiments with noise
  double share = 1.;          ///< of the conditions, in which it is tried for calibration: at random

  std::string name() const { return tessellation.empty() ? shape : shape + " " + tessellation; }
};

/// The surfaces for a purpose. `scale`: of the number of vertices, 1 for that of the published figures.
std::vector<Surface> surfaces(Purpose purpose, double scale);

} // namespace adaptive

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SURFACES_H
