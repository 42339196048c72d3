#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_PFH_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_PFH_DESCRIPTORS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/descriptors/Pfh_descriptor.h>
#include <Shape_characteristics/descriptors/internal/compute_descriptors_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the point feature histograms of the vertices of a mesh \cgalCite{rusu_pfh}: what `Pfh_descriptor` says.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`; faces may have any number of vertices
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshInputParameters
    \scDescriptorSamplesParameter{vertices}
    \cgalParamNBegin{number_of_rings}
      \cgalParamDescription{the size of the neighborhood, in edges}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`2`}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{the radius of the neighborhood, in the unit of the points, instead of a number of rings}
      \cgalParamType{`FT`}
      \cgalParamDefault{not used}
      \cgalParamExtra{The one to take where surfaces that are sampled differently are compared.}
    \cgalParamNEnd
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return a row of 125 values per vertex, and its status

  \throws std::invalid_argument if `descriptor_samples`, `number_of_rings` or `neighbor_radius` is out of its range

  Complexity: \f$ O(n m^2) \f$ for \f$ n \f$ vertices with neighborhoods of \f$ m \f$.

  \cgalExample{descriptors/pfh_descriptors.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
Descriptor_matrix pfh_descriptors(const FaceGraph& mesh,
                                  const NamedParameters& np = parameters::default_values())
{
  const Face_graph_samples surface =
      sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np);
  const Pfh_descriptor<Face_graph_samples> descriptor(surface);
  return internal::compute_descriptors_of<ConcurrencyTag>(descriptor, surface.size(), np);
}

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the point feature histograms of the points of a point set with normals, as those of the vertices of a mesh.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetInputParameters
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

  \return a row of 125 values per point, and its status

  \throws std::invalid_argument as for meshes, and if there is no normal map

  Complexity: \f$ O(n (\log n + m^2)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
Descriptor_matrix pfh_descriptors(const PointRange& points,
                                  const NamedParameters& np = parameters::default_values())
{
  const Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np), np);
  const Pfh_descriptor<Point_set_samples> descriptor(surface);
  return internal::compute_descriptors_of<ConcurrencyTag>(descriptor, surface.size(), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_PFH_DESCRIPTORS_H
