#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DEFORM_HANDLES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DEFORM_HANDLES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/internal/Deform_surface_distances.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the motion of a Surface_handle
struct Handle_motion
{
  Eigen::Vector3d displacement, center, axis;
  double factor, angle, radius;

  // where the part `t` of the motion takes `p`, relative to `p`
  Eigen::Vector3d offset(const Eigen::Vector3d& p, double t) const
  {
    const Eigen::Vector3d arm = p - center;
    Eigen::Vector3d turned = Eigen::Vector3d::Zero(); // relative to the arm
    if(angle != 0.)
    {
      const double half = std::sin(t * angle / 2.);
      turned = std::sin(t * angle) * axis.cross(arm) + 2. * half * half * axis.cross(axis.cross(arm));
    }
    const double growth = t * (factor - 1.);
    return (1. + growth) * turned + growth * arm + t * displacement;
  }
};

// one point of a handle
struct Handle_point
{
  std::size_t motion;
  Face_graph_samples::Index vertex;
  Eigen::Vector3d position;
};

// the handles of a mesh in numbers
struct Deform_handles
{
  std::vector<Handle_motion> motions;
  std::vector<Handle_point> points;

  template <typename FaceGraph, typename HandleRange>
  Deform_handles(const FaceGraph& mesh, const Face_graph_samples& surface, const HandleRange& handles)
  {
    using vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
    using Index = Face_graph_samples::Index;

    std::unordered_map<vertex_descriptor, Index> index_of;
    constexpr Index unknown = (std::numeric_limits<Index>::max)();
    for(const auto& handle : handles)
      for(const auto& point : handle.points)
        index_of.emplace(point.vertex, unknown);
    Index i = 0;
    for(const vertex_descriptor v : vertices(mesh))
    {
      if(const auto found = index_of.find(v); found != index_of.end())
        found->second = i;
      ++i;
    }

    for(const auto& handle : handles)
    {
      const Handle_motion motion{to_eigen(handle.displacement), to_eigen(handle.center),
                                 to_eigen(handle.axis),         double(handle.factor),
                                 double(handle.angle),          double(handle.radius)};
      if(handle.points.empty())
        refuse("a handle has no points");
      if(!(motion.radius > 0.) || !std::isfinite(motion.radius))
        refuse("the radius of a handle must be positive");
      if(!motion.displacement.allFinite() || !motion.center.allFinite() || !std::isfinite(motion.angle))
        refuse("the motion of a handle is not finite");
      if(!(motion.factor > 0.) || !std::isfinite(motion.factor))
        refuse("the factor of a handle must be positive");
      motions.push_back(motion);
      const double axis = length(motion.axis);
      if(motion.angle != 0. && (!(axis > 0.) || !std::isfinite(axis)))
        refuse("the axis of a handle has no direction");
      if(motion.angle != 0.)
        motions.back().axis /= axis;
      for(const auto& point : handle.points)
      {
        const Index vertex = index_of.at(point.vertex);
        if(vertex == unknown)
          refuse("a point of a handle is not on the mesh");
        if(!surface.is_usable(vertex))
          refuse("the vertex of a handle has no faces, or its point is not finite");
        const Eigen::Vector3d position =
            point.position ? to_eigen(*point.position) : Eigen::Vector3d(surface.point(vertex));
        if(!position.allFinite())
          refuse("a point of a handle is not finite");
        points.push_back({motions.size() - 1, vertex, position});
      }
    }
  }

private:
  [[noreturn]] static void refuse(const std::string& why)
  {
    throw std::invalid_argument("Shape_characteristics: " + why);
  }
};

// points and faces of the mesh that is deformed
template <typename FaceGraph, typename VertexPointMap>
Face_graph_samples surface_to_deform(const FaceGraph& mesh, const VertexPointMap& vpm)
{
  return Face_graph_samples(mesh, vpm, Neighborhood::rings(1), Face_graph_samples::Connectivity::FACES);
}

// where vertices go to
struct Deformed_vertex
{
  Face_graph_samples::Index vertex;
  Eigen::Vector3d point;
};

// Writes the points of `deformed`, which are in the order of the vertices, to `out`: all others as well, if it isn't the map of
// the mesh itself. Returns how many have moved.
template <typename FaceGraph, typename NamedParameters>
std::size_t
write_deformed(FaceGraph& mesh, const std::vector<Deformed_vertex>& deformed, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  constexpr bool is_in_place =
      parameters::is_default_parameter<NamedParameters, internal_np::deformed_vertex_point_map_t>::value;
  static_assert(!is_in_place || !std::is_const_v<FaceGraph> ||
                    !parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value,
                "a mesh that is const can't be deformed in place: give deformed_vertex_point_map");

  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get(CGAL::vertex_point, mesh));
  const auto out = choose_parameter(get_parameter(np, internal_np::deformed_vertex_point_map), vpm);
  using Point_3 =
      typename boost::property_traits<std::remove_cv_t<std::remove_reference_t<decltype(out)> > >::value_type;
  std::size_t moved = 0;
  auto next = deformed.begin();
  Face_graph_samples::Index i = 0;
  for(const auto v : vertices(mesh))
  {
    if(next != deformed.end() && next->vertex == i)
    {
      const Point_3 before = get(vpm, v), after(next->point.x(), next->point.y(), next->point.z());
      moved += before == after ? 0 : 1;
      put(out, v, after);
      ++next;
    }
    else if(!is_in_place)
      put(out, v, Point_3(get(vpm, v)));
    ++i;
  }
  return moved;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_DEFORM_HANDLES_H
