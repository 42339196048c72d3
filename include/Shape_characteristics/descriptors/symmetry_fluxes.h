#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_SYMMETRY_FLUXES_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_SYMMETRY_FLUXES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/Flux_method.h>
#include <Shape_characteristics/descriptors/Signal_scaling.h>
#include <Shape_characteristics/descriptors/Symmetry_flux_descriptor.h>
#include <Shape_characteristics/descriptors/internal/compute_descriptors_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/number_utils.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the areas of all items of a range, in its order, if the named parameters have any
template <typename Range, typename NamedParameters>
std::vector<double> areas_of(const Range& range, const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  std::vector<double> areas;
  if constexpr(!is_default_parameter<NamedParameters, internal_np::area_map_t>::value)
  {
    const auto map = get_parameter(np, internal_np::area_map);
    for(const auto& item : range)
      areas.push_back(CGAL::to_double(get(map, item)));
  }
  return areas;
}

template <typename NamedParameters>
Flux_method flux_method_of(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  return choose_parameter(get_parameter(np, internal_np::flux_method), Flux_method::POINTS);
}

template <typename ConcurrencyTag, typename SampledSurface, typename NamedParameters>
Descriptor_matrix
symmetry_fluxes_of(const SampledSurface& surface, std::vector<double> areas, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const Signal_scaling scaling =
      choose_parameter(get_parameter(np, internal_np::signal_scaling), Signal_scaling::UNIT_FREE);
  const Symmetry_flux_descriptor<SampledSurface> descriptor(surface, flux_method_of(np), scaling,
                                                            std::move(areas));
  return compute_descriptors_of<ConcurrencyTag>(descriptor, surface.size(), np);
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the symmetry-aware flux of the vertices of a mesh, one number each, which changes its sign when the surface is
  mirrored. `Symmetry_flux_descriptor` says what it is.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshInputParameters
    \scMeshNeighborhoodParameters
    \cgalParamNBegin{flux_method}
      \cgalParamDescription{over what the flux is summed}
      \cgalParamType{`Flux_method`}
      \cgalParamDefault{`Flux_method::POINTS`}
      \cgalParamExtra{The others need a mesh of triangles, and give 0 but for rounding errors where its border is far.}
    \cgalParamNEnd
    \cgalParamNBegin{area_map}
      \cgalParamDescription{the areas that the vertices stand for in a sum over points}
      \cgalParamType{a model of `ReadablePropertyMap` with a number type as value type}
      \cgalParamDefault{all alike}
    \cgalParamNEnd
    \scSignalScalingParameter
    \scDescriptorSamplesParameter{vertices}
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return a row for each vertex, or for each of `descriptor_samples`

  \throws std::invalid_argument if a parameter is out of its range, or `flux_method` doesn't fit the mesh

  Complexity: \f$ O(n m \log m) \f$ for \f$ n \f$ vertices with neighborhoods of \f$ m \f$.

  \cgalExample{descriptors/symmetry_signals.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
Descriptor_matrix symmetry_fluxes(const FaceGraph& mesh,
                                  const NamedParameters& np = parameters::default_values())
{
  using Connectivity = Face_graph_samples::Connectivity;
  const Connectivity connectivity = internal::flux_method_of(np) == Flux_method::POINTS
                                        ? Connectivity::NEIGHBORS
                                        : Connectivity::NEIGHBORS_AND_FACES;
  return internal::symmetry_fluxes_of<ConcurrencyTag>(
      sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np, connectivity),
      internal::areas_of(vertices(mesh), np), np);
}

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the symmetry-aware flux of the points of a point set with normals, as `symmetry_fluxes()` of a mesh does.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetInputParameters
    \scPointSetNeighborhoodParameters
    \cgalParamNBegin{area_map}
      \cgalParamDescription{the areas that the points stand for in a sum over points}
      \cgalParamType{a model of `ReadablePropertyMap` with a number type as value type}
      \cgalParamDefault{all alike}
    \cgalParamNEnd
    \scSignalScalingParameter
    \scDescriptorSamplesParameter{points}
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return a row for each point, or for each of `descriptor_samples`

  \throws std::invalid_argument as for meshes, and if there is no normal map

  Complexity: \f$ O(n (\log n + m \log m)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
Descriptor_matrix symmetry_fluxes(const PointRange& points,
                                  const NamedParameters& np = parameters::default_values())
{
  return internal::symmetry_fluxes_of<ConcurrencyTag>(
      sampled_surface(points, internal::point_set_neighborhood(np), np), internal::areas_of(points, np), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_SYMMETRY_FLUXES_H
