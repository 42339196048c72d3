#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_EXPERIMENT_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_EXPERIMENT_H

#include "Table.h"

#include <cstdint>
#include <string>
#include <vector>

namespace screen_space {

/// What all experiments are told.
struct Settings
{
  bool is_quick = false;           ///< small pictures, few of them
  std::string folder = ".";        ///< where pictures and plots go
  std::uint64_t seed = 1;          ///< of random tessellations
  double peak_bandwidth = 0.;      ///< of the memory, in GB/s; 0 if it isn't known
  int width = 1920, height = 1080; ///< of the pictures that are timed
};

/// What an experiment comes back with, beside the pictures that it wrote.
struct Findings
{
  Table all;                  ///< every figure, for CSV
  std::vector<Table> digests; ///< what people read
  bool is_plausible = true;   ///< whether the figures are such that nothing is broken
};

/// Figures 7.7 and 7.8: the error against the exact curvature, over the distance of the camera.
Findings measure_accuracy(const Settings& settings);

/// Figure 7.15: a plane whose relief is in a normal map alone.
Findings measure_normal_map(const Settings& settings);

/// Figure 7.17: ambient occlusion from curvature against rays.
Findings measure_occlusion(const Settings& settings);

/// Figure 7.16: the time of a frame over how much of the screen shows a surface.
Findings measure_frame_time(const Settings& settings);

} // namespace screen_space

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_EXPERIMENT_H
