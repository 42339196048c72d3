#ifndef SHAPE_CHARACTERISTICS_CHARACTERISTICS_SALIENCY_H
#define SHAPE_CHARACTERISTICS_CHARACTERISTICS_SALIENCY_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/characteristics/internal/Saliency_estimator.h>
#include <Shape_characteristics/characteristics/mean_curvature.h>
#include <Shape_characteristics/curvature/given_or_estimated_curvatures.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/put_number.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the scale that named parameters ask for, or that suits the samples; 0 if they all are at one place
template <typename SampledSurface, typename NamedParameters>
double saliency_scale(const SampledSurface& samples, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  if constexpr(!is_default_parameter<NamedParameters, internal_np::saliency_scale_t>::value)
  {
    const double scale = CGAL::to_double(get_parameter(np, internal_np::saliency_scale));
    if(!(scale > 0. && std::isfinite(reach_of_saliency * scale)))
      throw std::invalid_argument("Shape_characteristics: saliency_scale must be positive and finite");
    return scale;
  }
  else
  {
    Eigen::AlignedBox3d box;
    for(std::size_t i = 0; i < samples.size(); ++i)
      if(is_estimated(samples.status(i)))
        box.extend(samples.point(i));
    return box.isEmpty() ? 0. : (std::max)(.003 * length(box.diagonal()), .5 * samples.mean_spacing());
  }
}

// `samples` with any neighborhood; `surface_with(neighborhood)` makes the same with another one
template <typename ConcurrencyTag, typename SampledSurface, typename SurfaceWith, typename NamedParameters>
std::vector<Saliency_estimate> saliency_of(const SampledSurface& samples,
                                           const SurfaceWith& surface_with,
                                           const std::vector<Sample_principal_curvatures>& curvatures,
                                           const NamedParameters& np)
{
  std::vector<double> mean_curvatures;
  mean_curvatures.reserve(curvatures.size());
  for(const Sample_principal_curvatures& c : curvatures)
    mean_curvatures.push_back(mean_curvature(c));
  const std::function<bool(double)> callback = internal::callback_of(np);
  const double scale = saliency_scale(samples, np);
  if(scale > 0.)
  {
    const SampledSurface surface = surface_with(Neighborhood::ball(reach_of_saliency * scale)),
                         with_fewer_neighbors = surface_with(Neighborhood::ball(reach_of_maxima * scale));
    return Saliency_estimator<ConcurrencyTag, SampledSurface>(surface, with_fewer_neighbors, mean_curvatures,
                                                              scale)(callback);
  }
  std::vector<Saliency_estimate> result(samples.size());
  for(std::size_t i = 0; i < samples.size(); ++i)
    result[i].status =
        is_estimated(samples.status(i)) ? Estimation_status::FEW_NEIGHBOURS : samples.status(i);
  return result;
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  computes the saliency of the vertices of a mesh: how much the mean curvature at a vertex differs from that around it, at scales
  at which people look at a shape \cgalCite{mesh_saliency} (the thesis's section 6.1.2). A bump is salient, and fine grain all over
  a surface is not.

  \f$ G_\sigma \f$ is the average of the mean curvatures within \f$ 2 \sigma \f$, weighted by a Gaussian of standard deviation
  \f$ \sigma \f$. At each of the scales \f$ \sigma_i = 2 \varepsilon, 3 \varepsilon, \dots, 6 \varepsilon \f$, the difference
  \f$ \lvert G_{\sigma_i} - G_{2 \sigma_i} \rvert \f$ is divided by its largest value, and multiplied by \f$ (1 - m_i)^2 \f$, where
  \f$ m_i \f$ is the mean of its local maxima but for the largest: a scale with one salient place counts more than one with many.
  The saliency is the sum over the scales. A local maximum is where no vertex within \f$ 2 \sigma_i \f$ has a larger value.

  The result is from 0 to 5, without a unit: it doesn't change when the mesh is moved or scaled, nor when all normals are flipped. It
  compares vertices of one mesh, not of two. Where the mean curvature is the same everywhere but for rounding, it is 0. As all
  vertices count alike, an evenly sampled mesh is best.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_saliency_map}
      \cgalParamDescription{gets the saliency of each vertex}
      \cgalParamType{a model of `WritablePropertyMap` with a floating point number as value type}
      \cgalParamDefault{none: has to be given}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_status_map}
      \cgalParamDescription{gets the status of each vertex}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Estimation_status`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_principal_curvatures_and_directions_map}
      \cgalParamDescription{the curvatures, by whichever estimator; NaN where there are none}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `Principal_curvatures_and_directions`}
      \cgalParamDefault{those of `rusinkiewicz_curvatures()`; then all faces have to be triangles}
    \cgalParamNEnd
    \cgalParamNBegin{saliency_scale}
      \cgalParamDescription{\f$ \varepsilon \f$, in the unit of the points: a sixth of the radius of what is salient, or less}
      \cgalParamType{`FT`}
      \cgalParamDefault{.003 of the diagonal of the bounding box, as in the paper, but half the mean distance of neighboring
                        vertices at least}
    \cgalParamNEnd
    \scMeshInputParameters
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of vertices without a saliency. Theirs is quiet NaN, and their status says why: `FEW_NEIGHBOURS` if there is no
          other one within \f$ 24 \varepsilon \f$ along edges, `DEGENERATE` if its curvature is NaN, or sums of those around it
          overflow. If the callback stops the computation, all are `CANCELLED`.

  \throws std::invalid_argument if `saliency_scale` isn't positive and finite, or curvatures are to be estimated and a face is no
          triangle

  Complexity: \f$ O(n m \log m) \f$ for \f$ n \f$ vertices with \f$ m \f$ others within \f$ 24 \varepsilon \f$, in two passes: of a
  mesh of 100000 vertices, by default some thousand.

  \cgalExample{characteristics/saliency.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t saliency(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  static_assert(!is_default_parameter<NamedParameters, internal_np::vertex_saliency_map_t>::value,
                "saliency() of a mesh needs a vertex_saliency_map");

  const auto surface_with = [&](const Neighborhood& neighborhood)
  { return sampled_surface<ConcurrencyTag>(mesh, neighborhood, np); };
  const Face_graph_samples samples = surface_with(Neighborhood::rings(1));
  const std::vector<internal::Saliency_estimate> estimates = internal::saliency_of<ConcurrencyTag>(
      samples, surface_with, given_or_estimated_curvatures<ConcurrencyTag>(mesh, samples, np), np);
  const auto map = get_parameter(np, internal_np::vertex_saliency_map);
  std::size_t failures = 0, i = 0;
  for(const auto v : vertices(mesh))
  {
    const internal::Saliency_estimate& estimate = estimates[i++];
    internal::put_number(map, v, estimate.value);
    failures += !is_estimated(estimate.status);
    if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_status_map_t>::value)
      put(get_parameter(np, internal_np::vertex_status_map), v, estimate.status);
  }
  return failures;
}

/*!
  \ingroup PkgShapeCharacteristicsCharacteristics

  computes the saliency of the points of a point set with normals, as `saliency()` of a mesh does.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{saliency_map}
      \cgalParamDescription{gets the saliency of each point}
      \cgalParamType{a model of `WritablePropertyMap` with a floating point number as value type}
      \cgalParamDefault{none: has to be given}
    \cgalParamNEnd
    \cgalParamNBegin{status_map}
      \cgalParamDescription{gets the status of each point}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Estimation_status`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{principal_curvatures_and_directions_map}
      \cgalParamDescription{the curvatures, by whichever estimator; NaN where there are none}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `Principal_curvatures_and_directions`}
      \cgalParamDefault{those of `hrbf_curvatures()`}
    \cgalParamNEnd
    \cgalParamNBegin{saliency_scale}
      \cgalParamDescription{\f$ \varepsilon \f$, in the unit of the points}
      \cgalParamType{`FT`}
      \cgalParamDefault{as for meshes}
    \cgalParamNEnd
    \scPointSetInputParameters
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of points without a saliency, as for meshes. Points within \f$ 24 \varepsilon \f$ count, connected or not.

  \throws std::invalid_argument if `saliency_scale` isn't positive and finite, or there is no normal map

  Complexity: that of meshes, and \f$ O(n \log n) \f$.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
std::size_t saliency(PointRange&& points, const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  static_assert(!is_default_parameter<NamedParameters, internal_np::saliency_map_t>::value,
                "saliency() of a point set needs a saliency_map");

  const auto surface_with = [&](const Neighborhood& neighborhood)
  { return sampled_surface(points, neighborhood, np); };
  const Point_set_samples samples = surface_with(Neighborhood::nearest(6));
  const std::vector<internal::Saliency_estimate> estimates = internal::saliency_of<ConcurrencyTag>(
      samples, surface_with, given_or_estimated_curvatures<ConcurrencyTag>(points, samples, np, false), np);
  const auto map = get_parameter(np, internal_np::saliency_map);
  std::size_t failures = 0, i = 0;
  for(auto&& item : points)
  {
    const internal::Saliency_estimate& estimate = estimates[i++];
    internal::put_number(map, item, estimate.value);
    failures += !is_estimated(estimate.status);
    if constexpr(!is_default_parameter<NamedParameters, internal_np::status_map_t>::value)
      put(get_parameter(np, internal_np::status_map), item, estimate.status);
  }
  return failures;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CHARACTERISTICS_SALIENCY_H
