#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_SPIN_IMAGE_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_SPIN_IMAGE_DESCRIPTORS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/Spin_image_descriptor.h>
#include <Shape_characteristics/descriptors/internal/compute_descriptors_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

template <typename ConcurrencyTag, typename SampledSurface, typename NamedParameters>
Descriptor_matrix spin_image_descriptors_of(const SampledSurface& surface, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const std::int64_t given_width = whole_number(np, internal_np::image_width, std::int64_t(8), "image_width");
  // what is out of its range stays so
  const auto image_width =
      static_cast<unsigned int>((std::clamp)(given_width, std::int64_t(0), std::int64_t(1) << 31));
  const double support_angle = choose_parameter(get_parameter(np, internal_np::support_angle), CGAL_PI / 2.);
  return compute_descriptors_of<ConcurrencyTag>(
      Spin_image_descriptor<SampledSurface>(surface, image_width, support_angle), surface.size(), np);
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the spin images of the vertices of a mesh \cgalCite{spin_images}: what `Spin_image_descriptor` says.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`; faces may have any number of vertices
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshInputParameters
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{the radius of the ball in which the cylinder is inscribed that is shown, in the unit of the points}
      \cgalParamType{`FT`}
      \cgalParamDefault{not used}
      \cgalParamExtra{The one to take where surfaces that are sampled differently are compared.}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_rings}
      \cgalParamDescription{the size of the neighborhood, in edges, if there is no radius; then the farthest neighbor's
                            distance is the radius}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`2`}
    \cgalParamNEnd
    \cgalParamNBegin{image_width}
      \cgalParamDescription{how many cells the picture has from the normal outward, from 1 to 1000; it has twice as many along the
                            normal}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`8`}
      \cgalParamExtra{The papers take cells as large as the distance of neighboring vertices.}
    \cgalParamNEnd
    \cgalParamNBegin{support_angle}
      \cgalParamDescription{by how much the normal of a neighbor that counts may be turned away, in radians, \f$ \pi \f$ at most}
      \cgalParamType{`double`}
      \cgalParamDefault{\f$ \pi / 2 \f$}
      \cgalParamExtra{With \f$ \pi \f$, all neighbors count; with less, less of what else is near.}
    \cgalParamNEnd
    \scDescriptorSamplesParameter{vertices}
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return a row for each vertex, or for each of `descriptor_samples`: 153 values, or \f$ (w + 1) (2 w + 1) \f$ for an
          `image_width` of \f$ w \f$

  \throws std::invalid_argument if a parameter is out of its range

  Complexity: linear in the number of descriptors \f$ n \f$: \f$ O(n m \log m) \f$ for neighborhoods of \f$ m \f$ vertices.

  \cgalExample{descriptors/spin_image_descriptors.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
Descriptor_matrix spin_image_descriptors(const FaceGraph& mesh,
                                         const NamedParameters& np = parameters::default_values())
{
  return internal::spin_image_descriptors_of<ConcurrencyTag>(
      sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np), np);
}

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the spin images of the points of a point set with normals, as `spin_image_descriptors()` of a mesh does.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetInputParameters
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{the radius of the ball in which the cylinder is inscribed that is shown, in the unit of the points}
      \cgalParamType{`FT`}
      \cgalParamDefault{not used}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_neighbors}
      \cgalParamDescription{the size of the neighborhood, if there is no radius: as many nearest points}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`18`}
    \cgalParamNEnd
    \cgalParamNBegin{image_width}
      \cgalParamDescription{how many cells the picture has from the normal outward, from 1 to 1000; it has twice as many along the
                            normal}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`8`}
    \cgalParamNEnd
    \cgalParamNBegin{support_angle}
      \cgalParamDescription{by how much the normal of a neighbor that counts may be turned away, in radians, \f$ \pi \f$ at most}
      \cgalParamType{`double`}
      \cgalParamDefault{\f$ \pi / 2 \f$}
    \cgalParamNEnd
    \scDescriptorSamplesParameter{points}
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return a row for each point, or for each of `descriptor_samples`

  \throws std::invalid_argument as for meshes, and if there is no normal map

  Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ points, and that of meshes.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
Descriptor_matrix spin_image_descriptors(const PointRange& points,
                                         const NamedParameters& np = parameters::default_values())
{
  return internal::spin_image_descriptors_of<ConcurrencyTag>(
      sampled_surface(points, internal::point_set_neighborhood(np), np), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_SPIN_IMAGE_DESCRIPTORS_H
