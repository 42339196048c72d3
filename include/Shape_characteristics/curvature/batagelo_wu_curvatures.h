#ifndef SHAPE_CHARACTERISTICS_CURVATURE_BATAGELO_WU_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_BATAGELO_WU_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/estimate_curvatures.h>
#include <Shape_characteristics/curvature/internal/fit_to_neighbors.h>
#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/are_on_curve.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

template <typename SampledSurface>
class Batagelo_wu_estimator
{
  using Index = typename SampledSurface::Index;
  using Vector = Eigen::Vector3d;

public:
  using Workspace = typename SampledSurface::Workspace;

  explicit Batagelo_wu_estimator(const SampledSurface& surface) : m_surface(surface) {}

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    return fit_to_neighbors(m_surface, i, s_minimum, workspace,
                            [&](const std::vector<Index>& neighbors) { return fit(i, neighbors); });
  }

private:
  static constexpr std::size_t s_minimum = 3; // neighbors, of two equations each

  Curvature_estimate fit(std::size_t i, const std::vector<Index>& neighbors) const
  {
    const Vector& p = m_surface.point(i);
    const Vector& n = m_surface.normal(i);
    Vector t1, t2;
    tangent_basis(n, t1, t2);
    const double size = size_of_neighborhood(m_surface, i, neighbors);
    if(!(size > 0. && std::isfinite(size)))
      return Curvature_estimate(Estimation_status::DEGENERATE);

    // Sums over the unit directions (x, y) and the changes (a, b) of the normal per length; the equations of
    // [l m; m n] (x, y) = (a, b) are those of a triangle's shape operator with p = sum x^2, q = sum x y, r = sum y^2.
    double p_sum = 0., q_sum = 0., r_sum = 0., s_l = 0., s_m = 0., s_n = 0.;
    for(const Index j : neighbors)
    {
      const Vector edge = (m_surface.point(j) - p) / size;
      const Vector change = m_surface.normal(j) - n;
      const double u = edge.dot(t1), v = edge.dot(t2), tangential = std::sqrt(u * u + v * v);
      if(!(tangential > 0.))
        continue; // along the normal: no direction
      const double x = u / tangential, y = v / tangential;
      const double a = change.dot(t1) / tangential, b = change.dot(t2) / tangential;
      // of a neighbor that is seen at a low angle, the projection is short for its distance
      const double weight = tangential * tangential / edge.squaredNorm();
      p_sum += weight * x * x;
      q_sum += weight * x * y;
      r_sum += weight * y * y;
      s_l += weight * x * a;
      s_m += weight * (y * a + x * b);
      s_n += weight * y * b;
    }
    // p r - q^2 is half of the sum of weighted squares of sines between the directions: zero if all are parallel
    const double trace = p_sum + r_sum, d = determinant(p_sum, q_sum, r_sum);
    if(!(d > s_smallest_determinant * trace * trace))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    const auto for_each_place = [&](const auto& f)
    {
      for(const Index j : neighbors)
      {
        const Vector edge = (m_surface.point(j) - p) / size;
        f(edge.dot(t1), edge.dot(t2));
      }
    };
    if(d < s_usual_determinant * trace * trace && are_on_curve(for_each_place))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    const double inverse = 1. / (trace * d * size);
    const double b2 = -q_sum * r_sum, b5 = -p_sum * q_sum, qq = q_sum * q_sum;
    return Curvature_estimate(
        m_surface.status(i),
        eigen_of_shape_operator(n, ((r_sum * r_sum + d) * s_l + b2 * s_m + qq * s_n) * inverse,
                                (b2 * s_l + p_sum * r_sum * s_m + b5 * s_n) * inverse,
                                (qq * s_l + b5 * s_m + (p_sum * p_sum + d) * s_n) * inverse, t1, t2));
  }

  // compared to the square of the trace: 0.25 for directions all around; sines of 1e-5
  static constexpr double s_smallest_determinant = 1e-10;
  // neighbors with more aren't on a curve
  static constexpr double s_usual_determinant = .1;

  const SampledSurface& m_surface;
};

template <typename NamedParameters>
Neighborhood batagelo_wu_mesh_neighborhood(const NamedParameters& np)
{
  // one ring, unless something is asked for
  if constexpr(number_of_neighborhoods<NamedParameters> == 0)
    return Neighborhood::rings(1);
  else
    return mesh_neighborhood(np);
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a mesh from the change of the normal in the directions of the neighbors
  \cgalCite{batagelo_wu} (thesis, section 5.1.2).

  Each neighbor is a sample of the derivative of the normal: in the unit direction \f$ d \f$ of its projection on the tangent plane, the
  normal changes by \f$ \Delta n \f$ over the length \f$ r \f$ of the projection. The shape operator is the symmetric one that explains all
  samples best: \f$ S d = \Delta n / r \f$ in the tangent plane, by least squares, solved at once for the vertex, and
  not for triangles that are averaged then. So faces may have any number of vertices, point sets have no faces at all, and no thin triangle
  spoils the system: only directions that are all parallel do. A neighbor whose edge is steep counts with the square of
  the cosine.

  With exact normals, spheres and planes are met exactly, and the error falls with the square of the edge length on
  regular meshes, and linearly on others. With normals computed from the mesh it doesn't vanish on irregular meshes.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`; faces may have any number of vertices
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \scMeshInputParameters
    \cgalParamNBegin{number_of_rings}
      \cgalParamDescription{the size of the neighborhood, in edges}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`1`}
      \cgalParamExtra{Where the neighbors are fewer than three, or all in one direction, up to two rings are added. If
                      that isn't enough, the status is `FEW_NEIGHBOURS` or `DEGENERATE`.}
    \cgalParamNEnd
    \scRadiusOfMeshParameter
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if `number_of_rings` or `neighbor_radius` is out of its range

  Complexity: \f$ O(n m) \f$ for \f$ n \f$ vertices with neighborhoods of \f$ m \f$.

  \cgalExample{curvature/batagelo_wu_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t batagelo_wu_curvatures(const FaceGraph& mesh,
                                   const NamedParameters& np = parameters::default_values())
{
  const Face_graph_samples surface =
      sampled_surface<ConcurrencyTag>(mesh, internal::batagelo_wu_mesh_neighborhood(np), np);
  const internal::Batagelo_wu_estimator<Face_graph_samples> estimator(surface);
  return internal::estimate_vertices<ConcurrencyTag>(mesh, surface, estimator, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a mesh: those that `batagelo_wu_curvatures()` of the whole mesh gives, bit for
  bit.

  \param v the vertex
  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `number_of_rings` and `neighbor_radius`
         as for the whole mesh, and the ones listed below

  \cgalNamedParamsBegin
    \scVertexOutputParameters
    \scMeshInputParameters
  \cgalNamedParamsEnd

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument as for the whole mesh

  Complexity: that of the neighborhood, whatever the size of the mesh.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status batagelo_wu_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                         const FaceGraph& mesh,
                                         const NamedParameters& np = parameters::default_values())
{
  using Estimator = internal::Batagelo_wu_estimator<Face_graph_samples>;
  const Face_graph_samples surface =
      sampled_surface(v, mesh, internal::batagelo_wu_mesh_neighborhood(np), 1, np);
  const Estimator estimator(surface);
  typename Estimator::Workspace workspace;
  return internal::write_to_references(estimator(0, workspace), np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the points of a point set with normals, as `batagelo_wu_curvatures()` of a mesh does.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetOutputParameters
    \scPointSetInputParameters
    \cgalParamNBegin{number_of_neighbors}
      \cgalParamDescription{the size of the neighborhood: as many nearest points}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`18`}
      \cgalParamExtra{With fewer than three, every status is `FEW_NEIGHBOURS`. With all of them in one
                      row, as in scans whose rows are far apart, it is `DEGENERATE`. Six are about what a ring of a mesh has.}
    \cgalParamNEnd
    \scRadiusOfPointSetParameter
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of points that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument as for meshes, and if there is no normal map

  Complexity: \f$ O(n (\log n + m)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
std::size_t batagelo_wu_curvatures(PointRange&& points,
                                   const NamedParameters& np = parameters::default_values())
{
  const Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np), np);
  const internal::Batagelo_wu_estimator<Point_set_samples> estimator(surface);
  return internal::estimate_points<ConcurrencyTag>(points, surface.size(), estimator, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_BATAGELO_WU_CURVATURES_H
