#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNED_VOLUMES_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNED_VOLUMES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/Signal_scaling.h>
#include <Shape_characteristics/descriptors/Signed_volume_descriptor.h>
#include <Shape_characteristics/descriptors/Signed_volume_method.h>
#include <Shape_characteristics/descriptors/internal/compute_descriptors_of.h>
#include <Shape_characteristics/descriptors/internal/curvatures_of_samples.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <type_traits>
#include <utility>

namespace Shape_characteristics {
namespace internal {

template <typename ConcurrencyTag, typename SampledSurface, typename NamedParameters>
Descriptor_matrix
signed_volumes_of(const SampledSurface& surface, Sample_curvatures curvatures, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const Signed_volume_method method =
      choose_parameter(get_parameter(np, internal_np::signed_volume_method), Signed_volume_method::EXTREMA);
  const Signal_scaling scaling =
      choose_parameter(get_parameter(np, internal_np::signal_scaling), Signal_scaling::UNIT_FREE);
  const Signed_volume_descriptor<SampledSurface> descriptor(surface, std::move(curvatures.mean),
                                                            std::move(curvatures.Gaussian), method, scaling);
  return compute_descriptors_of<ConcurrencyTag>(descriptor, surface.size(), np);
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the signed volumes of the vertices of a mesh by mean and by Gaussian curvature, two numbers each, which change
  their signs when the surface is mirrored. `Signed_volume_descriptor` says what they are.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshInputParameters
    \scMeshNeighborhoodParameters
    \scCurvatureInputOfMeshParameter
    \cgalParamNBegin{signed_volume_method}
      \cgalParamDescription{what spans the volumes}
      \cgalParamType{`Signed_volume_method`}
      \cgalParamDefault{`Signed_volume_method::EXTREMA`}
    \cgalParamNEnd
    \scSignalScalingParameter
    \scDescriptorSamplesParameter{vertices}
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return a row for each vertex, or for each of `descriptor_samples`

  \throws std::invalid_argument if a parameter is out of its range, or curvatures are to be estimated and a face is not a triangle

  Complexity: \f$ O(n m \log m) \f$ for \f$ n \f$ vertices with neighborhoods of \f$ m \f$.

  \cgalExample{descriptors/symmetry_signals.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
Descriptor_matrix signed_volumes(const FaceGraph& mesh,
                                 const NamedParameters& np = parameters::default_values())
{
  const Face_graph_samples surface =
      sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np);
  return internal::signed_volumes_of<ConcurrencyTag>(
      surface, internal::curvatures_of_samples<ConcurrencyTag>(mesh, surface, np), np);
}

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the signed volumes of the points of a point set with normals, as `signed_volumes()` of a mesh does.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetInputParameters
    \scPointSetNeighborhoodParameters
    \scCurvatureInputOfPointSetParameter
    \cgalParamNBegin{signed_volume_method}
      \cgalParamDescription{what spans the volumes}
      \cgalParamType{`Signed_volume_method`}
      \cgalParamDefault{`Signed_volume_method::EXTREMA`}
    \cgalParamNEnd
    \scSignalScalingParameter
    \scDescriptorSamplesParameter{points}
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return a row for each point, or for each of `descriptor_samples`

  \throws std::invalid_argument if a parameter is out of its range, or there is no normal map

  Complexity: \f$ O(n (\log n + m \log m)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
Descriptor_matrix signed_volumes(const PointRange& points,
                                 const NamedParameters& np = parameters::default_values())
{
  const Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np), np);
  return internal::signed_volumes_of<ConcurrencyTag>(
      surface, internal::curvatures_of_samples<ConcurrencyTag>(points, surface, np), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNED_VOLUMES_H
