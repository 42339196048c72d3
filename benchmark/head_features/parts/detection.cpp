#include "detection.h"

#include <Shape_characteristics/curvature/adaptive_curvatures.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/normal_cycle_curvatures.h>
#include <Shape_characteristics/head_features/Head_feature_method.h>
#include <Shape_characteristics/head_features/Head_verdict.h>
#include <Shape_characteristics/head_features/detect_head_features.h>
#include <Shape_characteristics/head_features/estimate_head_pose.h>

#include <stdexcept>

namespace head_features {
namespace {

namespace params = SC::parameters;

auto thesis()
{
  // the eyes' number is the one that works best on these heads; the others are as critical
  return params::head_feature_method(SC::Head_feature_method::THESIS)
      .head_is_aligned(true)
      .number_of_eye_vertices(300)
      .number_of_nose_vertices(200)
      .number_of_ear_vertices(100);
}

} // namespace

std::vector<std::string> all_modes()
{
  return {"default", "aligned", "thesis", "thesis_hrbf", "thesis_adaptive", "thesis_normal_cycle"};
}

Features detect(const Mesh& mesh, const std::string& mode)
{
  if(mode == "default")
    return SC::detect_head_features(mesh);
  if(mode == "aligned")
    return SC::detect_head_features(mesh, params::head_is_aligned(true));
  if(mode == "thesis")
    return SC::detect_head_features(mesh, thesis());
  if(mode == "thesis_hrbf")
    return SC::detect_head_features(mesh,
                                    thesis().curvature_estimator([](const Mesh& m, const auto& np)
                                                                 { return SC::hrbf_curvatures(m, np); }));
  if(mode == "thesis_adaptive")
    return SC::detect_head_features(mesh,
                                    thesis().curvature_estimator([](const Mesh& m, const auto& np)
                                                                 { return SC::adaptive_curvatures(m, np); }));
  if(mode == "thesis_normal_cycle")
    return SC::detect_head_features(
        mesh, thesis().curvature_estimator([](const Mesh& m, const auto& np)
                                           { return SC::normal_cycle_curvatures(m, np); }));
  throw std::invalid_argument("there is no mode " + mode);
}

Verdict judge(const Mesh& mesh)
{
  const auto pose = SC::estimate_head_pose(mesh);
  return {pose.verdict, pose.obstacle, pose.confidence,
          SC::detect_head_features(mesh, params::head_pose(pose))};
}

} // namespace head_features
