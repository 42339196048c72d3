#include "errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace head_features {

using SC::Head_feature;

void Measurements::add(const Head& head, const std::string& mode, const Features& found)
{
  for(std::size_t i = 0; i < SC::number_of_head_features; ++i)
  {
    const auto& expected = head.truth.points[i];
    const auto& point = found.points[i];
    if(!expected.is_found)
      continue;
    Point_error e{head.name, head.variant, mode, static_cast<Head_feature>(i), point.is_found, 0., 0.};
    if(point.is_found)
    {
      e.error = 100. * std::sqrt(CGAL::squared_distance(point.position, expected.position)) /
                head.truth.head_height;
      e.confidence = point.confidence;
    }
    points.push_back(e);
  }
  for(std::size_t i = 0; i < SC::number_of_head_regions; ++i)
  {
    const auto& expected = head.truth.regions[i];
    const auto& region = found.regions[i];
    if(!expected.is_found)
      continue;
    Region_score s{head.name, head.variant, mode, static_cast<SC::Head_region>(i), region.is_found, 0., 0.};
    if(region.is_found && !region.vertices.empty())
    {
      std::vector<Mesh::Vertex_index> a = expected.vertices, b = region.vertices, common;
      b.erase(std::remove_if(b.begin(), b.end(), [&](const auto v) { return !head.is_known[v]; }), b.end());
      std::sort(a.begin(), a.end());
      std::sort(b.begin(), b.end());
      std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
      s.precision = b.empty() ? 0. : double(common.size()) / double(b.size());
      s.recall = double(common.size()) / double(a.size());
    }
    regions.push_back(s);
  }
}

const std::vector<Feature_group>& feature_groups()
{
  using F = Head_feature;
  static const std::vector<Feature_group> groups = {
      {"nose tip", {F::NOSE_TIP}, .5, 2.},
      {"top", {F::TOP}, 1., 3.},
      {"chin", {F::CHIN}, 1., 3.},
      {"eye corners (E1, E2)", {F::LEFT_E1, F::LEFT_E2, F::RIGHT_E1, F::RIGHT_E2}, .7, 2.},
      {"eye lids (E3 to E6)",
       {F::LEFT_E3, F::LEFT_E4, F::LEFT_E5, F::LEFT_E6, F::RIGHT_E3, F::RIGHT_E4, F::RIGHT_E5, F::RIGHT_E6},
       .7,
       2.},
      {"mouth corners (M1, M2)", {F::M1, F::M2}, .8, 2.5},
      {"lips (M3, M4)", {F::M3, F::M4}, 1., 3.},
      {"N1", {F::N1}, 1., 3.},
      {"N3", {F::N3}, 1., 3.},
      {"N4", {F::N4}, 1., 3.},
      {"sides of the nose (N5 to N8)", {F::N5, F::N6, F::N7, F::N8}, 1.5, 5.},
      {"ears (R1 to R5)",
       {F::LEFT_R1, F::LEFT_R2, F::LEFT_R3, F::LEFT_R4, F::LEFT_R5, F::RIGHT_R1, F::RIGHT_R2, F::RIGHT_R3,
        F::RIGHT_R4, F::RIGHT_R5},
       0.,
       0.}};
  return groups;
}

Error_summary summary(std::vector<double> errors)
{
  Error_summary s;
  s.found = s.all = errors.size();
  s.median = s.maximum = std::numeric_limits<double>::quiet_NaN();
  if(errors.empty())
    return s;
  std::sort(errors.begin(), errors.end());
  s.median = (errors[(errors.size() - 1) / 2] + errors[errors.size() / 2]) / 2.;
  s.maximum = errors.back();
  return s;
}

Error_summary summary(const Measurements& measurements,
                      const std::string& variant,
                      const std::string& mode,
                      const std::vector<Head_feature>& features)
{
  std::vector<double> errors;
  std::size_t all = 0;
  for(const Point_error& e : measurements.points)
    if(e.variant == variant && e.mode == mode &&
       std::find(features.begin(), features.end(), e.feature) != features.end())
    {
      ++all;
      if(e.is_found)
        errors.push_back(e.error);
    }
  Error_summary s = summary(std::move(errors));
  s.all = all;
  return s;
}

} // namespace head_features
