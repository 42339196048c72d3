#ifndef SHAPE_CHARACTERISTICS_CURVATURE_ZHIHONG_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_ZHIHONG_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/Face_weighting.h>
#include <Shape_characteristics/curvature/Patch_evaluation.h>
#include <Shape_characteristics/curvature/internal/One_ring.h>
#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/curvature/internal/estimate_from_triangles.h>
#include <Shape_characteristics/internal/Cubic_triangle.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

class Zhihong_estimator
{
public:
  struct Workspace
  {
    Face_graph_samples::Workspace neighbors;
    One_ring::Workspace ring;
  };

  template <typename NamedParameters>
  Zhihong_estimator(const Face_graph_samples& samples, const NamedParameters& np) : m_samples(samples)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    require_triangles(samples, "zhihong_curvatures");
    m_evaluation =
        choose_parameter(get_parameter(np, internal_np::patch_evaluation), Patch_evaluation::CENTER);
    m_weighting = choose_parameter(get_parameter(np, internal_np::face_weighting), Face_weighting::AREA);
  }

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    const Estimation_status status = status_at_vertex(m_samples, i, workspace.neighbors);
    if(!is_estimated(status))
      return Curvature_estimate(status);

    const Tangent_frame frame(m_samples.normal(i));
    const One_ring ring(m_samples, i, workspace.ring);
    double l = 0., m = 0., n = 0., weights = 0.;
    for(const Ring_triangle& t : ring.triangles())
    {
      double of_patch[3];
      if(!shape_operator(t, frame, of_patch))
        continue;
      // Errors of points and normals make errors of the curvature that grow with the square of the inverse of the shape: then
      // the weights are inverse to their variance. Two thirds of the half of a square are good enough.
      const double longest = (std::max)({t.aa, t.bb, (t.a - t.b).squaredNorm()});
      const double shape = (std::min)(1., 3. * t.doubled_area / longest);
      const double weight =
          (m_weighting == Face_weighting::AREA ? t.corner_area() : 1.) * (shape * shape) * (shape * shape);
      l += weight * of_patch[0];
      m += weight * of_patch[1];
      n += weight * of_patch[2];
      weights += weight;
    }
    if(!(weights > 0.))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    const double factor = ring.scale() / weights;
    return Curvature_estimate(status, eigen_of_shape_operator(frame.normal, factor * l, factor * m,
                                                              factor * n, frame.t1, frame.t2));
  }

private:
  using Vector = Eigen::Vector3d;

  // of the patch, in the tangents of the vertex, turned to those of the patch; false if the patch has no tangent plane
  bool shape_operator(const Ring_triangle& t, const Tangent_frame& frame, double result[3]) const
  {
    const Vector &normal_1 = m_samples.normal(t.first), &normal_2 = m_samples.normal(t.second);
    const Cubic_triangle<double> patch({Vector::Zero(), t.a, t.b}, {frame.normal, normal_1, normal_2});
    const bool at_vertex = m_evaluation == Patch_evaluation::VERTEX;
    const Patch_jet<double> jet = at_vertex ? patch({1., 0., 0.}) : patch({1. / 3., 1. / 3., 1. / 3.});

    const Vector cross = jet.u.cross(jet.v);
    const double square = cross.squaredNorm();
    constexpr double rounding = 64. * std::numeric_limits<double>::epsilon();
    if(!(square > rounding * rounding * jet.u.squaredNorm() * jet.v.squaredNorm()))
      return false;
    // The normals say which side is outside, not the order of the vertices.
    const double side = cross.dot(at_vertex ? frame.normal : Vector(frame.normal + (normal_1 + normal_2)));
    if(!(std::abs(side) > 0.))
      return false;
    const Vector normal = cross * (std::copysign(1., side) / std::sqrt(square));
    const double L = jet.uu.dot(normal), M = jet.uv.dot(normal), N = jet.vv.dot(normal);

    // the two tangents as sums of derivatives
    const double E = jet.u.squaredNorm(), F = jet.u.dot(jet.v), G = jet.v.squaredNorm();
    double u[2], v[2];
    const Vector tangents[2] = {turned_tangent(frame.t1, frame.normal, normal),
                                turned_tangent(frame.t2, frame.normal, normal)};
    for(int k = 0; k < 2; ++k)
    {
      const double along_u = jet.u.dot(tangents[k]), along_v = jet.v.dot(tangents[k]);
      u[k] = (G * along_u - F * along_v) / square;
      v[k] = (E * along_v - F * along_u) / square;
    }
    result[0] = -(L * u[0] * u[0] + 2. * M * u[0] * v[0] + N * v[0] * v[0]);
    result[1] = -(L * u[0] * u[1] + M * (u[0] * v[1] + u[1] * v[0]) + N * v[0] * v[1]);
    result[2] = -(L * u[1] * u[1] + 2. * M * u[1] * v[1] + N * v[1] * v[1]);
    return std::isfinite(result[0] + result[1] + result[2]);
  }

  const Face_graph_samples& m_samples;
  Patch_evaluation m_evaluation;
  Face_weighting m_weighting;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a triangle mesh from the PN triangles over its faces \cgalCite{zhihong} (thesis,
  section 5.2.1).

  Each triangle with its three normals makes a cubic Bézier patch (`Pn_triangle`), whose derivatives give a shape operator. That of a
  vertex is the mean of those of its triangles, each turned into the tangent plane of the vertex. The principal
  curvatures and directions are its eigenvalues and eigenvectors.

  The thesis takes the curvature in the middles of the patches, and leaves the choice of weights open. Here they are areas by
  default, times the fourth power of the triangle's shape \f$ \min(1, 6 A / l^2) \f$, with the area \f$ A \f$ and the longest
  edge \f$ l \f$: the curvature of a patch over a thin triangle is as wrong as the inverse square of its shape. With areas alone
  a few such triangles, on the border of a Delaunay triangulation say, drown all others.

  At the vertex itself all patches have its tangent plane. Taken there, the curvature averages over less of the surface: with
  exact normals it is better on irregular meshes, with estimated normals worse. See `patch_evaluation`.

  Normals and positions determine the result alike. With exact normals, the error falls with the square of the edge length on
  regular meshes, and linearly on others. With normals computed from the mesh it doesn't vanish on irregular meshes.

  Triangles without an area, or with points or normals that are not finite, count for nothing.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh. All its faces must be triangles.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \scMeshInputParameters
    \cgalParamNBegin{patch_evaluation}
      \cgalParamDescription{where on the patch of a triangle its curvature is taken}
      \cgalParamType{`Patch_evaluation`}
      \cgalParamDefault{`Patch_evaluation::CENTER`}
    \cgalParamNEnd
    \cgalParamNBegin{face_weighting}
      \cgalParamDescription{how the triangles are weighted besides their shape: alike, or with the part of their area
                            that belongs to the vertex (the mixed area of Meyer et al. \cgalCite{meyer})}
      \cgalParamType{`Face_weighting`}
      \cgalParamDefault{`Face_weighting::AREA`}
    \cgalParamNEnd
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if a face is not a triangle

  Complexity: linear in the size of the mesh.

  \cgalExample{curvature/zhihong_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t zhihong_curvatures(const FaceGraph& mesh,
                               const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<ConcurrencyTag, internal::Zhihong_estimator>(mesh, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a triangle mesh: those that `zhihong_curvatures()` of the whole mesh gives,
  bit for bit.

  \param v the vertex
  \param mesh the mesh. Its faces near the vertex must be triangles.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scVertexOutputParameters
    \scMeshInputParameters
    \cgalParamNBegin{patch_evaluation}
      \cgalParamDescription{where on the patch of a triangle its curvature is taken}
      \cgalParamType{`Patch_evaluation`}
      \cgalParamDefault{`Patch_evaluation::CENTER`}
    \cgalParamNEnd
    \cgalParamNBegin{face_weighting}
      \cgalParamDescription{how the triangles are weighted besides their shape: alike, or with the part of their area
                            that belongs to the vertex (the mixed area of Meyer et al. \cgalCite{meyer})}
      \cgalParamType{`Face_weighting`}
      \cgalParamDefault{`Face_weighting::AREA`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument if a face near the vertex is not a triangle

  Complexity: that of the neighborhood, whatever the size of the mesh.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status zhihong_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                     const FaceGraph& mesh,
                                     const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<internal::Zhihong_estimator>(v, mesh, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_ZHIHONG_CURVATURES_H
