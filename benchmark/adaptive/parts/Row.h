#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_ROW_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_ROW_H

#include "surfaces.h"

#include <Shape_characteristics/curvature/internal/Adaptive_statistics.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace adaptive {

constexpr std::size_t number_of_statistics = Shape_characteristics::internal::number_of_adaptive_statistics;
constexpr std::size_t number_of_candidates = Shape_characteristics::internal::number_of_adaptive_candidates;

/// What is given of a surface: with which normals, and how noisy.
struct Conditions
{
  std::string normals; ///< "exact", "Max", "average", or "noisy": exact ones, and noise
  double point_noise;  ///< standard deviation of each coordinate, in mean edge lengths
  double
      normal_noise; ///< standard deviation of each component of a unit normal, before it is normalized again

  std::string name() const;
};

/// A surface in certain conditions.
struct Experiment
{
  Surface surface;
  Conditions conditions;
};

/// All those with the surfaces for a purpose that have `only` in their name.
std::vector<Experiment> experiments(Purpose purpose, double scale, const std::string& only);

/// A vertex: what is known of it, and the errors of the candidates.
struct Vertex_record
{
  /// of k_max and k_min, with their signs; infinite where there is no estimate
  struct Error
  {
    float k_max, k_min;

    double sum() const { return std::abs(double(k_max)) + std::abs(double(k_min)); }
  };

  std::array<float, number_of_statistics> statistics;
  std::array<Error, number_of_candidates> errors;
};

/// The mean error of a candidate, where there is an estimate.
double mean_error(const std::vector<Vertex_record>& vertices, std::size_t candidate);

/// What comes of an experiment: a row of a table.
struct Row
{
  std::string surface; ///< its name
  std::string shape;   ///< of the surface
  Conditions conditions;
  std::vector<Vertex_record> vertices;
  std::vector<double> mean_errors; ///< of the candidates, over all vertices, where there is an estimate
  double adaptive_error = 0.;      ///< of adaptive_curvatures()
  double adaptive_seconds = 0.;    ///< that it takes
  double shared_error = 0.;        ///< of adaptive_curvatures() with shared fits
  double shared_seconds = 0.;      ///< that it takes
  std::vector<std::pair<std::string, double> > others; ///< of other estimators
};

/// What is to be measured.
struct Measurements
{
  bool records = false;  ///< statistics and errors of candidates at all vertices
  bool adaptive = false; ///< `adaptive_curvatures()`
  bool shared = false;   ///< the same with shared fits
  bool others = false;   ///< other estimators
};

/// Makes an experiment. `seed`: of random points and noise.
Row measure(const Experiment& experiment, std::uint64_t seed, const Measurements& measurements);

} // namespace adaptive

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_ROW_H
