#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_DESCRIPTORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/characteristics/Willmore_energy.h>
#include <Shape_characteristics/characteristics/curvedness.h>
#include <Shape_characteristics/characteristics/mean_curvature.h>
#include <Shape_characteristics/characteristics/shape_index.h>
#include <Shape_characteristics/head_features/Head_descriptor.h>
#include <Shape_characteristics/head_features/internal/estimate_head_curvatures.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// shape index, curvedness, mean curvature, Willmore energy
using Characteristics_of_vertex = std::array<double, 4>;

// maps all but the shape index to [0, 1]
inline void map_to_unit_interval(std::vector<Characteristics_of_vertex>& characteristics)
{
  for(std::size_t k = 1; k < 4; ++k)
  {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for(const Characteristics_of_vertex& c : characteristics)
      if(std::isfinite(c[k]))
      {
        least = (std::min)(least, c[k]);
        greatest = (std::max)(greatest, c[k]);
      }
    for(Characteristics_of_vertex& c : characteristics)
      if(!std::isfinite(c[k]))
        c[k] = std::numeric_limits<double>::quiet_NaN();
      else // a head on which all values are alike has no features
        c[k] = greatest > least ? (c[k] - least) / (greatest - least) : 0.;
  }
}

// All are mapped to where they lie between others, so that the unit doesn't matter: the largest curvature is about 1, or squares
// might overflow.
inline std::vector<Characteristics_of_vertex> characteristics_without_unit(
    const std::vector<Principal_curvatures_and_directions<Sample_kernel> >& curvatures)
{
  double largest = 0.;
  for(const auto& c : curvatures)
    for(const double k : {c.min_curvature, c.max_curvature})
      if(std::isfinite(k))
        largest = (std::max)(largest, std::abs(k));
  const int exponent = largest > 0. ? std::ilogb(largest) : 0;
  std::vector<Characteristics_of_vertex> result;
  result.reserve(curvatures.size());
  for(auto c : curvatures)
  {
    c.min_curvature = std::ldexp(c.min_curvature, -exponent);
    c.max_curvature = std::ldexp(c.max_curvature, -exponent);
    result.push_back({shape_index(c), curvedness(c), mean_curvature(c), Willmore_energy(c)});
  }
  return result;
}

// the longest side of the box around the points that are finite
inline double longest_side(const Face_graph_samples& samples)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(infinity), high = -low;
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(samples.point(i).allFinite())
    {
      low = low.cwiseMin(samples.point(i));
      high = high.cwiseMax(samples.point(i));
    }
  return low.x() <= high.x() ? (high - low).maxCoeff() : 0.;
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  computes what the thesis describes the vertices of a head by (section 9.1.1): shape index, curvedness, mean curvature and
  Willmore energy, the last three mapped linearly to [0, 1], and all averaged within a radius of 0.01 of the head's size.

  The neighborhood over which a value is averaged are the vertices within the radius that are connected with it inside of it, and
  the vertex itself; those without a value count for nothing. The mapping takes the smallest and the largest value on the mesh: it
  is the thesis's, and a single spike changes it for all.

  Neither the unit nor the pose of the mesh matters, but for the box by which its size is measured if no pose is given.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np a sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_head_descriptor_map}
      \cgalParamDescription{the descriptors of the vertices. It has to be given.}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Head_descriptor`}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_status_map}
      \cgalParamDescription{whether the curvatures at a vertex were estimated, or why not}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Estimation_status`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{curvature_estimator}
      \cgalParamDescription{what estimates the curvatures, for example
                            `[](const auto& mesh, const auto& np) { hrbf_curvatures(mesh, np); }`}
      \cgalParamType{a function object that is called with the mesh and named parameters (`vertex_point_map`,
                     `vertex_principal_curvatures_and_directions_map`, `vertex_status_map`)}
      \cgalParamDefault{`rusinkiewicz_curvatures()`}
    \cgalParamNEnd
    \cgalParamNBegin{averaging_radius}
      \cgalParamDescription{the radius of the neighborhood, in units of the head's size; 0: no averaging}
      \cgalParamType{`double`}
      \cgalParamDefault{`0.01`}
    \cgalParamNEnd
    \cgalParamNBegin{head_pose}
      \cgalParamDescription{the pose of the head, whose size is the unit of `averaging_radius`}
      \cgalParamType{`Head_pose`}
      \cgalParamDefault{the unit is the longest side of the mesh's axis-parallel box}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of vertices whose curvatures could not be estimated. Their descriptors are quiet NaN.

  \throws std::invalid_argument if the radius is negative or not finite; what the estimator throws

  Complexity: that of the estimator, and linear in the number of vertices times that of their neighbors.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t head_descriptors(const FaceGraph& mesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  static_assert(
      !is_default_parameter<NamedParameters, internal_np::vertex_head_descriptor_map_t>::value,
      "Shape_characteristics: head_descriptors() needs the named parameter vertex_head_descriptor_map");

  const double relative_radius = choose_parameter(get_parameter(np, internal_np::averaging_radius), .01);
  if(!(relative_radius >= 0.))
    throw std::invalid_argument("Shape_characteristics: averaging_radius must not be negative");

  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  const auto curvatures = internal::estimate_head_curvatures<ConcurrencyTag>(mesh, np);
  std::vector<internal::Characteristics_of_vertex> mapped =
      internal::characteristics_without_unit(curvatures.values);
  internal::map_to_unit_interval(mapped);

  double size = 0.;
  if constexpr(is_default_parameter<NamedParameters, internal_np::head_pose_t>::value)
    size = internal::longest_side(Face_graph_samples(mesh, vpm, Neighborhood::rings(1)));
  else
    size = get_parameter(np, internal_np::head_pose).size;

  std::vector<internal::Characteristics_of_vertex> averaged = mapped;
  if(relative_radius * size > 0.)
  {
    const Face_graph_samples samples(mesh, vpm, Neighborhood::ball(relative_radius * size));
    for_each_sample<ConcurrencyTag, Face_graph_samples::Workspace>(
        samples.size(),
        [&](const std::size_t i, Face_graph_samples::Workspace& workspace)
        {
          const std::vector<Face_graph_samples::Index>& neighbors = samples.neighbors(i, 0, workspace);
          for(std::size_t k = 0; k < 4; ++k)
          {
            double sum = mapped[i][k], number = 1.;
            for(const auto j : neighbors)
              if(!std::isnan(mapped[j][k]))
              {
                sum += mapped[j][k];
                ++number;
              }
            averaged[i][k] = sum / number; // NaN if the vertex itself has no value
          }
        });
  }

  const auto descriptor_map = get_parameter(np, internal_np::vertex_head_descriptor_map);
  std::size_t i = 0, failures = 0;
  for(const auto v : vertices(mesh))
  {
    const bool is_known = is_estimated(curvatures.statuses[i]);
    failures += is_known ? 0 : 1;
    Head_descriptor d;
    if(is_known)
    {
      d.shape_index = averaged[i][0];
      d.curvedness = averaged[i][1];
      d.mean_curvature = averaged[i][2];
      d.Willmore_energy = averaged[i][3];
    }
    put(descriptor_map, v, d);
    if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_status_map_t>::value)
      put(get_parameter(np, internal_np::vertex_status_map), v, curvatures.statuses[i]);
    ++i;
  }
  return failures;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_DESCRIPTORS_H
