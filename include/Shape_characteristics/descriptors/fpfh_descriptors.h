#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_FPFH_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_FPFH_DESCRIPTORS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/Fpfh_descriptor.h>
#include <Shape_characteristics/descriptors/Fpfh_variant.h>
#include <Shape_characteristics/descriptors/internal/compute_descriptors_of.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

template <typename ConcurrencyTag, typename SampledSurface, typename NamedParameters>
Descriptor_matrix fpfh_descriptors_of(const SampledSurface& surface, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  const Fpfh_variant variant =
      choose_parameter(get_parameter(np, internal_np::fpfh_variant), Fpfh_variant::PCL);
  const std::function<bool(double)> callback = callback_of(np);
  // Most of the work is what the descriptors share.
  bool goes_on = true;
  std::function<bool(double)> at_first, at_last;
  if(callback)
  {
    at_first = [&](const double advancement) { return goes_on = callback(0.8 * advancement); };
    at_last = [&](const double advancement) { return goes_on && callback(0.8 + 0.2 * advancement); };
  }
  const ConcurrencyTag tag{};
  if constexpr(is_default_parameter<NamedParameters, internal_np::descriptor_samples_t>::value)
  {
    const Fpfh_descriptor<SampledSurface> descriptor(surface, variant, tag, at_first);
    return compute_descriptors<ConcurrencyTag>(descriptor, surface.size(), at_last);
  }
  else
  {
    const std::vector<std::size_t> samples = descriptor_samples_of(surface.size(), np);
    const Fpfh_descriptor<SampledSurface> descriptor(surface, samples, variant, tag, at_first);
    return compute_descriptors<ConcurrencyTag>(descriptor, samples, at_last);
  }
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the fast point feature histograms of the vertices of a mesh \cgalCite{rusu_fpfh}: what `Fpfh_descriptor` says.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`; faces may have any number of vertices
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshInputParameters
    \cgalParamNBegin{fpfh_variant}
      \cgalParamDescription{how the histograms of neighbors are put together}
      \cgalParamType{`Fpfh_variant`}
      \cgalParamDefault{`Fpfh_variant::PCL`}
    \cgalParamNEnd
    \scDescriptorSamplesParameter{vertices}
    \cgalParamNBegin{number_of_rings}
      \cgalParamDescription{the size of the neighborhood, in edges}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`2`}
      \cgalParamExtra{To find a place again, two to four times of what normals and curvatures are estimated from.}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{the radius of the neighborhood, in the unit of the points, instead of a number of rings}
      \cgalParamType{`FT`}
      \cgalParamDefault{not used}
      \cgalParamExtra{The one to take where surfaces that are sampled differently are compared.}
    \cgalParamNEnd
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return a row of 33 values per vertex, and its status

  \throws std::invalid_argument if `descriptor_samples`, `number_of_rings` or `neighbor_radius` is out of its range

  Complexity: \f$ O(n m) \f$ for \f$ n \f$ vertices with neighborhoods of \f$ m \f$, beside the search for them.

  \cgalExample{descriptors/fpfh_descriptors.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
Descriptor_matrix fpfh_descriptors(const FaceGraph& mesh,
                                   const NamedParameters& np = parameters::default_values())
{
  return internal::fpfh_descriptors_of<ConcurrencyTag>(
      sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np), np);
}

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the fast point feature histograms of the points of a point set with normals, as those of the vertices of a mesh.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetInputParameters
    \cgalParamNBegin{fpfh_variant}
      \cgalParamDescription{how the histograms of neighbors are put together}
      \cgalParamType{`Fpfh_variant`}
      \cgalParamDefault{`Fpfh_variant::PCL`}
    \cgalParamNEnd
    \scDescriptorSamplesParameter{points}
    \cgalParamNBegin{number_of_neighbors}
      \cgalParamDescription{the size of the neighborhood: as many nearest points}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`18`}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{the radius of the neighborhood, instead of a number of neighbors}
      \cgalParamType{`FT`}
      \cgalParamDefault{not used}
      \cgalParamExtra{The one to take where point sets that are sampled differently are compared.}
    \cgalParamNEnd
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return a row of 33 values per point, and its status

  \throws std::invalid_argument as for meshes, and if there is no normal map

  Complexity: \f$ O(n (\log n + m \log m)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
Descriptor_matrix fpfh_descriptors(const PointRange& points,
                                   const NamedParameters& np = parameters::default_values())
{
  return internal::fpfh_descriptors_of<ConcurrencyTag>(
      sampled_surface(points, internal::point_set_neighborhood(np), np), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_FPFH_DESCRIPTORS_H
