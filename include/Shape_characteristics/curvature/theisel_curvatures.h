#ifndef SHAPE_CHARACTERISTICS_CURVATURE_THEISEL_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_THEISEL_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/One_ring.h>
#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/curvature/internal/estimate_from_triangles.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

class Theisel_estimator
{
public:
  struct Workspace
  {
    Face_graph_samples::Workspace neighbors;
    One_ring::Workspace ring;
  };

  template <typename NamedParameters>
  Theisel_estimator(const Face_graph_samples& samples, const NamedParameters&) : m_samples(samples)
  {
    require_triangles(samples, "theisel_curvatures");
  }

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    const Estimation_status status = status_at_vertex(m_samples, i, workspace.neighbors);
    if(!is_estimated(status))
      return Curvature_estimate(status);

    const Eigen::Vector3d& n = m_samples.normal(i);
    const Tangent_frame frame(n);
    const One_ring ring(m_samples, i, workspace.ring);
    double s_11 = 0., s_12_and_21 = 0., s_22 = 0., area = 0., seen_area = 0.;
    for(const Ring_triangle& t : ring.triangles())
    {
      // The operator takes the edges, seen along the normal, to the differences of the normals: [da db] [a b]^-1. Times
      // its weight there is nothing to divide by, however steep the triangle is.
      const double a_u = t.a.dot(frame.t1), a_v = t.a.dot(frame.t2), b_u = t.b.dot(frame.t1),
                   b_v = t.b.dot(frame.t2);
      const Eigen::Vector3d da = m_samples.normal(t.first) - n, db = m_samples.normal(t.second) - n;
      const double da_u = da.dot(frame.t1), da_v = da.dot(frame.t2), db_u = db.dot(frame.t1),
                   db_v = db.dot(frame.t2);
      const double determinant = a_u * b_v - a_v * b_u; // twice the area that is seen
      const double corner = t.corner_area();
      const double weight = std::copysign(corner / t.doubled_area, determinant);
      s_11 += weight * (da_u * b_v - db_u * a_v);
      s_12_and_21 += weight * (db_u * a_u - da_u * b_u + da_v * b_v - db_v * a_v);
      s_22 += weight * (db_v * a_u - da_v * b_u);
      area += corner;
      seen_area += weight * determinant;
    }
    constexpr double rounding = 64. * std::numeric_limits<double>::epsilon();
    if(!(seen_area > rounding * area))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    const double factor = ring.scale() / seen_area;
    return Curvature_estimate(status, eigen_of_shape_operator(n, factor * s_11, .5 * factor * s_12_and_21,
                                                              factor * s_22, frame.t1, frame.t2));
  }

private:
  const Face_graph_samples& m_samples;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a triangle mesh from linearly interpolated normals \cgalCite{theisel} (thesis,
  section 5.1.2).

  Over a triangle with points \f$ x_0, x_1, x_2 \f$, both the points and the normals \f$ n_0, n_1, n_2 \f$ are interpolated
  linearly, to \f$ x(u, v) \f$ and \f$ n(u, v) \f$. A surface with these normals has

  \f[ K_G = \frac{\det(n_0, n_1, n_2)}{\lVert n \rVert^2 \, (n \cdot m)}, \qquad
      K_H = \frac{n \cdot h}{2 \lVert n \rVert (n \cdot m)}, \f]

  where \f$ m = (x_1 - x_0) \times (x_2 - x_0) \f$ and \f$ h = n_0 \times (x_1 - x_2) + n_1 \times (x_2 - x_0) + n_2 \times (x_0 - x_1)
  \f$: they are determinant and half of the trace of the operator that takes the edges, projected along \f$ n \f$, to the
  change of the unit normal. At a vertex, the operators of all its triangles act in the tangent plane of the vertex.
  The estimate is their mean, weighted with the part of the triangle that belongs to the vertex (the mixed area of Meyer et al.
  \cgalCite{meyer}), seen along the normal: triangles at which the normal looks askance count less, as in the paper. The
  principal curvatures and directions are those of the symmetric part, which has the mean curvature of the whole and a
  Gaussian curvature that is smaller by the square of what is left out.

  The lengths of normals would matter to the paper's formulas; here all are made unit vectors. With exact normals,
  spheres, cylinders and planes are met exactly, and the error falls with the square of the edge length on regular meshes, and
  linearly on others. With normals computed from the mesh it doesn't vanish on irregular meshes.

  Triangles without an area, or with points or normals that are not finite, count for nothing.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh. All its faces must be triangles.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \scMeshInputParameters
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if a face is not a triangle

  Complexity: linear in the size of the mesh.

  \cgalExample{curvature/theisel_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t theisel_curvatures(const FaceGraph& mesh,
                               const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<ConcurrencyTag, internal::Theisel_estimator>(mesh, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a triangle mesh: those that `theisel_curvatures()` of the whole mesh gives,
  bit for bit.

  \param v the vertex
  \param mesh the mesh. Its faces near the vertex must be triangles.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scVertexOutputParameters
    \scMeshInputParameters
  \cgalNamedParamsEnd

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument if a face near the vertex is not a triangle

  Complexity: that of the neighborhood, whatever the size of the mesh.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status theisel_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                     const FaceGraph& mesh,
                                     const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<internal::Theisel_estimator>(v, mesh, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_THEISEL_CURVATURES_H
