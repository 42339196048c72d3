#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_POINTS_OF_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_POINTS_OF_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/head_features/internal/pose_surface.h>
#include <Shape_characteristics/internal/point_set_parameters.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The kernel in which curvatures are estimated, whatever that of the surface is: what samples hold.
using Pose_kernel = CGAL::Simple_cartesian<double>;
using Pose_curvatures = Principal_curvatures_and_directions<Pose_kernel>;

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

template <typename ConcurrencyTag, typename FaceGraph, typename NamedParameters>
Pose_points pose_points_of_mesh(const FaceGraph& mesh, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  using Map_tag = internal_np::vertex_principal_curvatures_and_directions_map_t;

  const Face_graph_samples samples = sampled_surface<ConcurrencyTag>(
      mesh, Neighborhood::rings(1), np, Face_graph_samples::Connectivity::NEIGHBORS_AND_FACES);
  Pose_points all;
  const auto add = [&](const std::size_t i, const double min_curvature, const double max_curvature)
  {
    const bool usable = samples.is_usable(i);
    const Eigen::Vector3d none = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    all.add(usable ? samples.point(i) : none, usable ? samples.normal(i) : none, min_curvature, max_curvature,
            std::uint32_t(i));
  };
  if constexpr(!is_default_parameter<NamedParameters, Map_tag>::value)
  {
    const auto map = get_parameter(np, internal_np::vertex_principal_curvatures_and_directions_map);
    std::size_t i = 0;
    for(const auto v : vertices(mesh))
    {
      const auto c = get(map, v);
      add(i++, CGAL::to_double(c.min_curvature), CGAL::to_double(c.max_curvature));
    }
  }
  else
  {
    auto points = get(CGAL::dynamic_vertex_property_t<Pose_kernel::Point_3>(), mesh);
    auto normals = get(CGAL::dynamic_vertex_property_t<Pose_kernel::Vector_3>(), mesh);
    auto curvatures = get(CGAL::dynamic_vertex_property_t<Pose_curvatures>(), mesh);
    std::size_t i = 0;
    for(const auto v : vertices(mesh))
    {
      const Eigen::Vector3d &p = samples.point(i), &n = samples.normal(i);
      put(points, v, Pose_kernel::Point_3(p.x(), p.y(), p.z()));
      put(normals, v, Pose_kernel::Vector_3(n.x(), n.y(), n.z()));
      ++i;
    }
    rusinkiewicz_curvatures<ConcurrencyTag>(mesh,
                                            parameters::vertex_point_map(points)
                                                .vertex_normal_map(normals)
                                                .vertex_principal_curvatures_and_directions_map(curvatures));
    i = 0;
    for(const auto v : vertices(mesh))
    {
      const Pose_curvatures c = get(curvatures, v);
      add(i++, c.min_curvature, c.max_curvature);
    }
  }
  add_points_of_large_faces(samples, all);
  return all;
}

// property maps of the numbers of samples

struct Pose_point_map
{
  using key_type = std::uint32_t;
  using value_type = Pose_kernel::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  const Point_set_samples* samples;
  friend value_type get(const Pose_point_map& map, const key_type i)
  {
    const Eigen::Vector3d& p = map.samples->point(i);
    return {p.x(), p.y(), p.z()};
  }
};

struct Pose_normal_map
{
  using key_type = std::uint32_t;
  using value_type = Pose_kernel::Vector_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  const Point_set_samples* samples;
  friend value_type get(const Pose_normal_map& map, const key_type i)
  {
    const Eigen::Vector3d& n = map.samples->normal(i);
    return {n.x(), n.y(), n.z()};
  }
};

struct Pose_curvature_map
{
  using key_type = std::uint32_t;
  using value_type = Pose_curvatures;
  using reference = value_type&;
  using category = boost::writable_property_map_tag;
  std::vector<value_type>* values;
  friend void put(const Pose_curvature_map& map, const key_type i, const value_type& value)
  {
    (*map.values)[i] = value;
  }
};

template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
Pose_points pose_points_of_range(const PointRange& points, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  const Point_set_samples samples = sampled_surface(points, Neighborhood::nearest(1), np);
  Pose_points all;
  const auto add = [&](const std::size_t i, const double min_curvature, const double max_curvature)
  {
    const bool usable = samples.is_usable(i);
    const Eigen::Vector3d none = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    all.add(usable ? samples.point(i) : none, usable ? samples.normal(i) : none, min_curvature, max_curvature,
            std::uint32_t(i));
  };
  if constexpr(!is_default_parameter<NamedParameters,
                                     internal_np::principal_curvatures_and_directions_map_t>::value)
  {
    const auto map = get_parameter(np, internal_np::principal_curvatures_and_directions_map);
    std::size_t i = 0;
    for(const auto& item : points)
    {
      const auto c = get(map, item);
      add(i++, CGAL::to_double(c.min_curvature), CGAL::to_double(c.max_curvature));
    }
  }
  else
  {
    std::vector<std::uint32_t> numbers;
    for(std::size_t i = 0; i < samples.size(); ++i)
      numbers.push_back(std::uint32_t(i));
    std::vector<Pose_curvatures> curvatures(samples.size());
    hrbf_curvatures<ConcurrencyTag>(
        numbers, parameters::point_map(Pose_point_map{&samples})
                     .normal_map(Pose_normal_map{&samples})
                     .principal_curvatures_and_directions_map(Pose_curvature_map{&curvatures}));
    for(std::size_t i = 0; i < samples.size(); ++i)
      add(i, curvatures[i].min_curvature, curvatures[i].max_curvature);
  }
  return all;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_POINTS_OF_H
