#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_ERRORS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_ERRORS_H

#include "Head.h"

#include <Shape_characteristics/head_features/Head_feature.h>

#include <string>
#include <vector>

namespace head_features {

/// Of one feature point.
struct Point_error
{
  std::string name, variant, mode;
  SC::Head_feature feature;
  bool is_found = false;
  double error = 0.; ///< in percent of the head's height
  double confidence = 0.;
};

/// Of one region, by numbers of vertices.
struct Region_score
{
  std::string name, variant, mode;
  SC::Head_region region;
  bool is_found = false;
  double precision = 0., recall = 0.;
};

/// All that was measured.
struct Measurements
{
  std::vector<Point_error> points;
  std::vector<Region_score> regions;

  /// compares what was found with the truth, as far as that is known
  void add(const Head& head, const std::string& mode, const Features& found);
};

/// Feature points that belong together in a table, with the goals for their errors; 0 where there is none.
struct Feature_group
{
  std::string name;
  std::vector<SC::Head_feature> features;
  double median_goal = 0., maximum_goal = 0.;
};

const std::vector<Feature_group>& feature_groups();

/// The median and the largest of errors.
struct Error_summary
{
  std::size_t found = 0, all = 0;
  double median = 0., maximum = 0.; ///< of those found, quiet NaN if there are none
};

Error_summary summary(const Measurements& measurements,
                      const std::string& variant,
                      const std::string& mode,
                      const std::vector<SC::Head_feature>& features);

/// the same of any errors, all of which were found
Error_summary summary(std::vector<double> errors);

} // namespace head_features

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_ERRORS_H
