#ifndef SHAPE_CHARACTERISTICS_CURVATURE_ADAPTIVE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_ADAPTIVE_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/Adaptive_estimator_choice.h>
#include <Shape_characteristics/curvature/internal/Adaptive_estimator.h>
#include <Shape_characteristics/curvature/internal/Adaptive_statistics.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

template <typename NamedParameters>
std::function<bool(double)> adaptive_callback(const NamedParameters& np)
{
  static_assert(number_of_neighborhoods<NamedParameters> == 0,
                "adaptive_curvatures() chooses the neighborhoods itself");
  return callback_of(np);
}

template <typename NamedParameters>
bool adaptive_fits_are_shared(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::fits_are_shared), false);
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a mesh by the estimators that suit the data around each vertex, after
  an idea of Váša et al. (L. Váša, P. Vaněček, M. Prantl, V. Skorkovská, P. Martínek, I. Kolingerová, Mesh statistics for
  robust curvature estimation, Computer Graphics Forum 35(5), 2016).

  Nobody has to say what kind of data it is: whether normals are exact, estimated or noisy, how noisy the points are,
  how coarsely the surface was sampled. The candidates (`Adaptive_estimator_choice`) are Hermite radial basis functions as in
  `hrbf_curvatures()`, that trust points and normals to different degrees. Their shape operators are averaged with
  weights \f$ e^{-s} \f$; the scores \f$ s \f$ are what a neural network with one hidden layer, which a program has trained on
  surfaces whose curvature is known (`benchmark/adaptive`), makes of statistics without units, means over the neighbors of a vertex:

  - how well normals and curvatures of a fit agree with its points along edges (of exact data they do up to the fifth power
    of the edge length),
  - how much the fits differ that trust the data to different degrees, and from the given normals,
  - how far the points were moved by smoothing them, and whether to one side,
  - how much the surface bends between samples, how irregular they are, and the likeliest noise level,
  - how likely different levels of noise, of points and of normals, make the data.

  Where the first of these, or that and the noise level, say that normals are exact beyond doubt, nothing else is asked; elsewhere
  mostly one or two have a part in the average. Those with less than a fiftieth of the largest weight have none.

  Before all this, it is tried whether a vertex and its neighbors lie on a quadric, to eight digits of their distances: on a
  sphere, a cylinder, a cone, an ellipsoid, a paraboloid, a hyperboloid, as the faces of technical parts do, or on two planes that
  meet. There the curvatures are the quadric's, as exact as the points are, up to the border and whatever the normals are, unless
  that of the vertex leans by more than 37 degrees.
  Where a profile was moved, or scaled, with vertices in rows and columns, there are five points of the profile within two rings, and
  a conic goes through any five: there the third ring has to agree, if it isn't a circle. The normals may tell a quadric, too, if they
  are exact: where marching cubes interpolate a quadratic function linearly, as that of a ball or a tube, the curvatures are
  those of its level set through each vertex.

  Level sets that marching cubes take from a coarse grid are its weak point: they are off in the same direction for some vertices,
  which four rings hardly tell from the shape. Who knows that it is so does better with `hrbf_curvatures()` of four rings and a
  `noise_level` of some thousandths.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`; faces may have any number of vertices
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \cgalParamNBegin{vertex_estimator_map}
      \cgalParamDescription{gets which estimator has the largest weight at each vertex}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Adaptive_estimator_choice`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{fits_are_shared}
      \cgalParamDescription{whether a function that was fitted at a vertex may serve the vertices near it as well}
      \cgalParamType{`bool`}
      \cgalParamDefault{`false`}
      \cgalParamExtra{`true` is faster and less accurate: on clean surfaces some six times as fast, with errors larger by a
                      third to two thirds; over noise, which leaves less to be shared, not twice as fast.}
    \cgalParamNEnd
    \scMeshInputParameters
    \scCallbackParameter
  \cgalNamedParamsEnd

  If the callback stops the computation, no vertex has an estimate: they are `CANCELLED`.

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  Complexity: linear in the number of vertices. A quadric takes some microseconds on one processor. Where there is none and normals
  are exact beyond doubt, three fits are made at a vertex: tens of microseconds. Elsewhere, and some rings around, it is up to
  nineteen, eight of them over four rings, and sixty over the nearest neighbors, which tell of the noise: milliseconds. The results of
  thirteen of them are kept at the same time, which takes some three kilobytes a vertex.

  \cgalExample{curvature/adaptive_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t adaptive_curvatures(const FaceGraph& mesh,
                                const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  internal::Adaptive_statistics<ConcurrencyTag, Face_graph_samples> statistics(
      [&](const unsigned int rings)
      { return sampled_surface<ConcurrencyTag>(mesh, Neighborhood::rings(rings), np); },
      internal::adaptive_callback(np), internal::adaptive_fits_are_shared(np));
  internal::Adaptive_estimates result =
      internal::Adaptive_estimator<ConcurrencyTag, Face_graph_samples>(statistics, statistics.size())();
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_estimator_map_t>::value)
  {
    const auto map = get_parameter(np, internal_np::vertex_estimator_map);
    std::size_t i = 0;
    for(const auto v : vertices(mesh))
      put(map, v, result.choices[i++]);
  }
  return internal::write_to_mesh(mesh, statistics.surface(), result.estimates, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a mesh, as `adaptive_curvatures()` of the whole mesh does.

  \param v the vertex
  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": those of the whole mesh, with
         other outputs:

  \cgalNamedParamsBegin
    \scVertexOutputParameters
  \cgalNamedParamsEnd

  The noise level is estimated from the surroundings of the vertex alone, some ten edges wide, and points farther away aren't
  smoothed. Where normals are exact beyond doubt, that says nothing but that they are, and the result has the bits of the whole
  mesh's.

  \return whether the curvatures were estimated, or why not

  Complexity: that of the surroundings, some hundred vertices, whatever the size of the mesh. For many vertices, the
  estimates of the whole mesh are faster.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status adaptive_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                      const FaceGraph& mesh,
                                      const NamedParameters& np = parameters::default_values())
{
  // Copies for neighborhoods of 2, 3 and 4 rings, which begin with the same vertices: the rings around `v`, one by one. Statistics
  // are means over two rings, of what is known of edges to neighbors up to two rings farther.
  const auto surface = [&](const unsigned int rings)
  { return sampled_surface(v, mesh, Neighborhood::rings(rings), rings == 2 ? 3 : 2, np); };
  const std::array<Face_graph_samples, 3> surfaces = {surface(2), surface(3), surface(4)};
  internal::Adaptive_statistics<CGAL::Sequential_tag, Face_graph_samples> statistics(
      [&](const unsigned int rings) { return surfaces[rings - 2]; }, internal::adaptive_callback(np),
      internal::adaptive_fits_are_shared(np));
  Face_graph_samples::Workspace workspace;
  std::size_t size = 1;
  for(const auto i : surfaces[2].neighbors(0, 0, workspace))
    size = (std::max)(size, std::size_t(i) + 1);
  statistics.set_size((std::min)(size, surfaces[1].size()));
  const internal::Adaptive_estimates result =
      internal::Adaptive_estimator<CGAL::Sequential_tag, Face_graph_samples>(statistics, 1)();
  return internal::write_to_references(result.estimates[0], np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the points of a point set with normals, as `adaptive_curvatures()` of a mesh does. Instead of
  2, 3 and 4 rings, the nearest 18, 36 and 60 points are the neighbors.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetOutputParameters
    \cgalParamNBegin{estimator_map}
      \cgalParamDescription{gets which estimator has the largest weight at each point}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Adaptive_estimator_choice`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{fits_are_shared}
      \cgalParamDescription{whether a function that was fitted at a point may serve the points near it as well}
      \cgalParamType{`bool`}
      \cgalParamDefault{`false`}
      \cgalParamExtra{`true` is faster and less accurate: on clean surfaces some six times as fast, with errors larger by a
                      third to two thirds; over noise, which leaves less to be shared, not twice as fast.}
    \cgalParamNEnd
    \scPointSetInputParameters
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of points that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if there is no normal map

  Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ points, and as long as for a mesh.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
std::size_t adaptive_curvatures(PointRange&& points, const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  internal::Adaptive_statistics<ConcurrencyTag, Point_set_samples> statistics(
      [&](const unsigned int rings)
      { return sampled_surface(points, Neighborhood::nearest(3 * rings * (rings + 1)), np); },
      internal::adaptive_callback(np), internal::adaptive_fits_are_shared(np));
  const internal::Adaptive_estimates result =
      internal::Adaptive_estimator<ConcurrencyTag, Point_set_samples>(statistics, statistics.size())();
  if constexpr(!is_default_parameter<NamedParameters, internal_np::estimator_map_t>::value)
  {
    const auto map = get_parameter(np, internal_np::estimator_map);
    auto choice = result.choices.begin();
    for(auto&& item : points)
      put(map, item, *choice++);
  }
  return internal::write_to_points(points, result.estimates, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_ADAPTIVE_CURVATURES_H
