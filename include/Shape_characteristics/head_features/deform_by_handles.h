#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_DEFORM_BY_HANDLES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_DEFORM_BY_HANDLES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Surface_handle.h>
#include <Shape_characteristics/head_features/internal/Deform_handles.h>
#include <Shape_characteristics/head_features/internal/Deform_surface_distances.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The Gaussian neighborhoods of all points of all handles, put together; deform_by_handles() says how.
inline std::vector<Deformed_vertex> deform_gaussian(const Face_graph_samples& surface,
                                                    const Deform_handles& handles)
{
  constexpr double reach = 6.; // in radii: a part of 1.5e-8 of the motion is left there
  struct Influence
  {
    std::size_t motion;
    double rest; // 1 - the Gaussian
  };
  std::vector<std::vector<Influence> > influences(surface.size());
  Deform_surface_distances distances(surface);
  for(const Handle_point& p : handles.points)
  {
    const double radius = handles.motions[p.motion].radius;
    for(const auto& [vertex, distance] : distances.from(p.vertex, p.position, reach * radius))
    {
      const double s = distance / radius;
      influences[vertex].push_back({p.motion, -std::expm1(-s * s / 2.)});
    }
  }

  std::vector<Deformed_vertex> result;
  for(std::size_t i = 0; i < surface.size(); ++i)
  {
    if(influences[i].empty())
      continue;
    double smallest_rest = 1.,
           log_of_rest = 0.; // the latter of all: their product may be too small for a number
    for(const Influence& f : influences[i])
    {
      smallest_rest = (std::min)(smallest_rest, f.rest);
      log_of_rest += std::log(f.rest);
    }
    const Eigen::Vector3d& p = surface.point(i);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0.;
    for(const Influence& f : influences[i])
    {
      // Relative to the largest: if there are points here, with no rest, none but they count.
      const double weight = (1. - f.rest) * (f.rest == smallest_rest ? 1. : smallest_rest / f.rest);
      sum += weight * handles.motions[f.motion].offset(p, -std::expm1(log_of_rest));
      weights += weight;
    }
    result.push_back({Face_graph_samples::Index(i), p + sum / weights});
  }
  return result;
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  deforms a mesh by handles: sets of points that are displaced, scaled or turned and take their Gaussian neighborhoods
  along, over the surface. This is how the thesis deforms heads by their feature points (9.2.3).

  Let \f$ g_i = \exp(-s_i^2 / 2 \sigma_i^2) \f$ be the Gaussian of point \f$ i \f$ of all points of all handles, at the distance
  \f$ s_i \f$ from it, and \f$ t = 1 - \prod_i (1 - g_i) \f$. A vertex \f$ p \f$ moves by
  \f[ \frac{\sum_i a_i (M_{t,i}(p) - p)}{\sum_i a_i}, \qquad a_i = \frac{g_i}{1 - g_i}, \f]
  where \f$ M_{t,i} \f$ is the part \f$ t \f$ of the motion of the point's handle (`Surface_handle`). With one point this is its
  Gaussian. With more, vertices that are points of handles go exactly where their handles take them, however near the others are
  (to the mean, where one vertex is a point of several), handles with the same motion act as one, and the result is smooth and
  doesn't depend on the order of the handles, up to rounding. Handles that are to act one after the other are given in as many calls.

  The distance is measured over the surface: it doesn't jump over gaps such as that between the lips. It is exact where the surface
  can be unfolded into the plane and no hole is near the way, and elsewhere within a few percent of the shortest path, a good
  deal better than that along edges; so it hardly depends on the tessellation. Beyond \f$ 6 \sigma \f$ nothing moves.

  Neither the unit nor the place of the mesh matters.

  \tparam FaceGraph a model of `FaceListGraph`. Faces of more than three corners are taken for flat and convex.
  \tparam HandleRange a model of `ConstRange` with value type `Surface_handle<FaceGraph, GeomTraits>`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh; its points change if there is no `deformed_vertex_point_map`
  \param handles the handles, all acting at once
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a model of `ReadWritePropertyMap` with value type `%Point_3`; of `ReadablePropertyMap` if there is a
                     `deformed_vertex_point_map`}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
    \cgalParamNBegin{deformed_vertex_point_map}
      \cgalParamDescription{where the points of all vertices are written to, those that don't move as well}
      \cgalParamType{a model of `WritablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`vertex_point_map`: the mesh is deformed in place}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of vertices that moved. Vertices with points that aren't finite, and those without faces, stay, and nothing
          is reached by way of them.

  \throws std::invalid_argument if a handle has no points, or one that isn't a vertex of the mesh, has no faces or isn't finite;
          if its motion is not finite, its radius or factor not positive, or its axis of length zero where it turns

  Complexity: \f$ O(n + k m \log m) \f$ for \f$ n \f$ vertices and \f$ k \f$ points with neighborhoods of \f$ m \f$ vertices.

  \cgalExample{head_features/deform_head.cpp}
*/
template <typename FaceGraph,
          typename HandleRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t deform_by_handles(FaceGraph& mesh,
                              const HandleRange& handles,
                              const NamedParameters& np = parameters::default_values())
{
  const Face_graph_samples surface = internal::surface_to_deform(
      mesh, parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                         CGAL::get_const_property_map(CGAL::vertex_point, mesh)));
  return internal::write_deformed(
      mesh, internal::deform_gaussian(surface, internal::Deform_handles(mesh, surface, handles)), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_DEFORM_BY_HANDLES_H
