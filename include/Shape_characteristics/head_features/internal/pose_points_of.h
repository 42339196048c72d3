#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_POINTS_OF_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_POINTS_OF_H

#include <Shape_characteristics/curvature/given_or_estimated_curvatures.h>
#include <Shape_characteristics/head_features/internal/pose_surface.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Points within faces whose edges are long by the size of the surface, so that a box of twelve triangles has as many as a fine
// mesh of it. Normals and curvatures are those of the corners, interpolated.
inline void add_points_of_large_faces(const Face_graph_samples& samples, Pose_points& all)
{
  Eigen::Vector3d lowest = Eigen::Vector3d::Constant(HUGE_VAL), highest = -lowest;
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(samples.is_usable(i))
    {
      lowest = lowest.cwiseMin(samples.point(i));
      highest = highest.cwiseMax(samples.point(i));
    }
  const double longest = (highest - lowest).norm() / 50.;
  if(!(longest > 0.) || !std::isfinite(longest))
    return;
  for(std::size_t f = 0; f < samples.number_of_faces(); ++f)
    for(std::size_t k = 2; k < samples.degree(f); ++k)
    {
      const Face_graph_samples::Index corner[3] = {samples.vertex(f, 0), samples.vertex(f, k - 1),
                                                   samples.vertex(f, k)};
      if(!samples.is_usable(corner[0]) || !samples.is_usable(corner[1]) || !samples.is_usable(corner[2]))
        continue;
      double edge = 0.;
      for(int c = 0; c < 3; ++c)
        edge = (std::max)(edge, (samples.point(corner[c]) - samples.point(corner[(c + 1) % 3])).norm());
      const int parts = int((std::min)(std::ceil(edge / longest), 64.));
      if(parts < 2)
        continue;
      // corners with normals far from the face's are those of a sharp edge: the face is flat then
      const Eigen::Vector3d flat = (samples.point(corner[1]) - samples.point(corner[0]))
                                       .cross(samples.point(corner[2]) - samples.point(corner[0]))
                                       .normalized();
      const bool is_flat =
          !(flat.dot(samples.normal(corner[0])) > .8 && flat.dot(samples.normal(corner[1])) > .8 &&
            flat.dot(samples.normal(corner[2])) > .8);
      for(int a = 0; a <= parts; ++a)
        for(int b = 0; a + b <= parts; ++b)
        {
          const int c = parts - a - b;
          if(a == parts || b == parts || c == parts)
            continue; // a vertex
          const double t[3] = {double(a) / parts, double(b) / parts, double(c) / parts};
          Eigen::Vector3d point = Eigen::Vector3d::Zero(), normal = is_flat ? flat : point;
          double min_curvature = 0., max_curvature = 0.;
          for(int i = 0; i < 3; ++i)
          {
            point += t[i] * samples.point(corner[i]);
            if(!is_flat)
              normal += t[i] * samples.normal(corner[i]);
            min_curvature += t[i] * all.min_curvatures[corner[i]];
            max_curvature += t[i] * all.max_curvatures[corner[i]];
          }
          all.add(point, normal.normalized(), min_curvature, max_curvature, Pose_points::none);
        }
    }
}

// one for each sample; those that can't be used are NaN
template <typename Samples>
Pose_points pose_points_of_samples(const Samples& samples,
                                   const std::vector<Sample_principal_curvatures>& curvatures)
{
  const Eigen::Vector3d none = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Pose_points all;
  for(std::size_t i = 0; i < samples.size(); ++i)
  {
    const bool usable = samples.is_usable(i);
    all.add(usable ? samples.point(i) : none, usable ? samples.normal(i) : none, curvatures[i].min_curvature,
            curvatures[i].max_curvature, std::uint32_t(i));
  }
  return all;
}

template <typename ConcurrencyTag, typename FaceGraph, typename NamedParameters>
Pose_points pose_points_of_mesh(const FaceGraph& mesh, const NamedParameters& np)
{
  const Face_graph_samples samples = sampled_surface<ConcurrencyTag>(
      mesh, Neighborhood::rings(1), np, Face_graph_samples::Connectivity::NEIGHBORS_AND_FACES);
  Pose_points all =
      pose_points_of_samples(samples, given_or_estimated_curvatures<ConcurrencyTag>(mesh, samples, np));
  add_points_of_large_faces(samples, all);
  return all;
}

template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
Pose_points pose_points_of_range(const PointRange& points, const NamedParameters& np)
{
  const Point_set_samples samples = sampled_surface(points, Neighborhood::nearest(1), np);
  return pose_points_of_samples(samples,
                                given_or_estimated_curvatures<ConcurrencyTag>(points, samples, np, true));
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_POINTS_OF_H
