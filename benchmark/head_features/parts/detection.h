#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_DETECTION_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_DETECTION_H

#include "Head.h"

#include <Shape_characteristics/head_features/Head_verdict.h>

#include <string>
#include <vector>

namespace head_features {

/*!
  The ways of detection:
  - `default`: the pose is found, and features by the surface;
  - `aligned`: the pose is given by the coordinates;
  - `thesis`: chapter 9 to the letter, with Rusinkiewicz's curvatures; the pose is given by the coordinates, and the numbers of
    vertices suit a head of 12000 vertices;
  - `thesis_hrbf`, `thesis_adaptive`, `thesis_normal_cycle`: the same with other curvatures.
*/
std::vector<std::string> all_modes();

/// Throws `std::invalid_argument` for a mode that there isn't.
Features detect(const Mesh& mesh, const std::string& mode);

/// What is said of a shape.
struct Verdict
{
  Shape_characteristics::Head_verdict verdict;
  Shape_characteristics::Head_obstacle obstacle;
  double confidence; ///< of the pose
  Features features; ///< by mode `default`
};

Verdict judge(const Mesh& mesh);

} // namespace head_features

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_DETECTION_H
