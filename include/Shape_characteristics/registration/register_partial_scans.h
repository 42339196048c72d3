#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_REGISTER_PARTIAL_SCANS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_REGISTER_PARTIAL_SCANS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/affine_conversions.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/normals/Normal_weighting.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/Registration_result.h>
#include <Shape_characteristics/registration/internal/Scan_registrar.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

template <typename Scan, typename NamedParameters, bool = is_face_graph<Scan> >
struct Scan_kernel
{
  using type = typename Point_set_helper<Scan, NamedParameters>::Geom_traits;
};

template <typename Scan, typename NamedParameters>
struct Scan_kernel<Scan, NamedParameters, true>
{
  using type = typename CGAL::GetGeomTraits<Scan, NamedParameters>::type;
};

template <typename ConcurrencyTag, typename Scan, typename NamedParameters>
Oriented_points oriented_points_of(const Scan& scan, const NamedParameters& np)
{
  if constexpr(is_face_graph<Scan>)
  {
    // Large triangles have the normals that noise turns least.
    const Normal_weighting weighting = parameters::choose_parameter(
        parameters::get_parameter(np, internal_np::normal_weighting), Normal_weighting::AREA);
    return Oriented_points::of(sampled_surface<ConcurrencyTag>(
        scan, Neighborhood::rings(1), parameters::extend(np).normal_weighting(weighting)));
  }
  else
    return Oriented_points::of(sampled_surface(scan, Neighborhood::nearest(1), np));
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  finds the motion that brings two scans of one object together that overlap in part, and says whether it did.

  Both are thinned out to a bounded number of samples, equally dense. Their FPFH descriptors \cgalCite{rusu_fpfh} are matched;
  matches that the mirrored descriptor would suit better are dropped, and so are triples of matches that turn the surface
  inside out or its normals elsewhere (`tuple_test()`), because objects with a plane of symmetry have matches between their two
  sides in plenty. The motion on which the rest agrees (`fast_global_registration()`) is refined (`iterative_closest_point()`) and
  then judged by the surfaces alone, which know nothing of descriptors: by the share of points that lie on the other scan where
  it is near. Where that isn't convincing, neighborhoods of other sizes are tried; where it is, other motions that might do as
  well.

  No parameter has a unit, and nothing depends on the unit and the place of the scans, up to rounding, nor on the order of their
  points. Which points are kept of more than `maximum_number_of_samples` depends a little on the pose, and the motion by a part of their
  distance.

  \scConcurrencyTag
  \tparam Source a model of `FaceListGraph`, or of `ConstRange` for a point set with normals
  \tparam Target likewise, not necessarily the same
  \tparam NamedParametersOfSource a sequence of \ref sc_namedparameters "Named Parameters"
  \tparam NamedParametersOfTarget a sequence of \ref sc_namedparameters "Named Parameters"

  \param source the scan that is moved
  \param target the scan to which it is moved
  \param np_source an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below
  \param np_target the same for the target; of those below, maps and `normal_weighting` alone

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{of a mesh: the points of the vertices}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
    \cgalParamNBegin{vertex_normal_map}
      \cgalParamDescription{of a mesh: the outward normals of the vertices, of any length}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Vector_3`}
      \cgalParamDefault{computed by `vertex_normals()` with `normal_weighting`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_weighting}
      \cgalParamDescription{of a mesh: how the normals of faces count in that of their vertex}
      \cgalParamType{`Normal_weighting`}
      \cgalParamDefault{`Normal_weighting::AREA`, which noise disturbs least}
    \cgalParamNEnd
    \cgalParamNBegin{point_map}
      \cgalParamDescription{of a point set: the points of the elements of the range}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map`, or the map of a `CGAL::Point_set_3`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{of a point set: the outward normals of the elements of the range, of any length}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Vector_3`}
      \cgalParamDefault{the map of a `CGAL::Point_set_3`; other ranges need it}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_neighbors}
      \cgalParamDescription{how many samples the neighborhoods of the descriptors have on average, at least 8}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`60`}
    \cgalParamNEnd
    \cgalParamNBegin{maximum_number_of_samples}
      \cgalParamDescription{to how many points a scan is thinned out, at least 100}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`6000`}
    \cgalParamNEnd
    \cgalParamNBegin{random_seed}
      \cgalParamDescription{the seed of the triples of matches that are drawn}
      \cgalParamType{an integer type}
      \cgalParamDefault{`0`}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{called with the advancement in [0, 1], by one thread at a time; `false` stops the search, and the verdict is `FAILED`}
      \cgalParamType{convertible to `std::function<bool(double)>`}
      \cgalParamDefault{unused}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the motion and the verdict. `AMBIGUOUS` are objects that can slide on themselves (the parts of a plane, a sphere, a
          cylinder) or that a rotation brings to themselves (a cube): the other motions are among the alternatives. So are scans
          that only a reflection brings together, as the two sides of an object that have nothing in common but its plane of
          symmetry: the reflection is the first of the alternatives. Points with coordinates or normals that aren't finite, and
          those with normals of no length, are left out; with less than 10 others the verdict is `FAILED`.

  \throws std::invalid_argument if a point set has no normal map, or a parameter is out of its range

  Complexity: \f$ O(n \log n) \f$ in the number of points; the features and their matches depend on the number of samples alone, of whose square the time of matching is.

  \cgalExample{registration/register_scans.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename Source,
          typename Target,
          typename NamedParametersOfSource = parameters::Default_named_parameters,
          typename NamedParametersOfTarget = parameters::Default_named_parameters>
auto register_partial_scans(const Source& source,
                            const Target& target,
                            const NamedParametersOfSource& np_source = parameters::default_values(),
                            const NamedParametersOfTarget& np_target = parameters::default_values())
    -> Registration_result<typename internal::Scan_kernel<Source, NamedParametersOfSource>::type>
{
  using Kernel = typename internal::Scan_kernel<Source, NamedParametersOfSource>::type;

  internal::Registration_options options;
  const std::int64_t neighbors = internal::whole_number(np_source, internal_np::number_of_neighbors,
                                                        std::int64_t(60), "number_of_neighbors");
  const std::int64_t samples = internal::whole_number(np_source, internal_np::maximum_number_of_samples,
                                                      std::int64_t(6000), "maximum_number_of_samples");
  if(neighbors < 8)
    throw std::invalid_argument("Shape_characteristics: number_of_neighbors must be at least 8");
  if(samples < 100)
    throw std::invalid_argument("Shape_characteristics: maximum_number_of_samples must be at least 100");
  options.number_of_neighbors = static_cast<std::size_t>(neighbors);
  options.maximum_number_of_samples = static_cast<std::size_t>(samples);
  options.seed = internal::whole_number(np_source, internal_np::random_seed, std::uint64_t(0), "random_seed");
  options.callback = internal::callback_of(np_source);

  const internal::Registration_outcome outcome = internal::Scan_registrar<ConcurrencyTag>::run(
      internal::oriented_points_of<ConcurrencyTag>(source, np_source),
      internal::oriented_points_of<ConcurrencyTag>(target, np_target), options);

  Registration_result<Kernel> result;
  result.verdict = outcome.verdict;
  result.obstacle = outcome.obstacle;
  result.confidence = outcome.confidence;
  result.scale_ratio = outcome.scale_ratio;
  for(const internal::Registration_hypothesis& h : outcome.hypotheses)
    result.alternatives.push_back({internal::affine_to_cgal<Kernel>(h.motion), h.quality, h.is_reflection});
  if(!result.alternatives.empty() && !result.alternatives.front().is_reflection)
  {
    result.transformation = result.alternatives.front().transformation;
    result.quality = result.alternatives.front().quality;
    result.alternatives.erase(result.alternatives.begin());
  }
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_REGISTER_PARTIAL_SCANS_H
