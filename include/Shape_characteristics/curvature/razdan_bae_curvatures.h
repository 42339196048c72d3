#ifndef SHAPE_CHARACTERISTICS_CURVATURE_RAZDAN_BAE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_RAZDAN_BAE_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/Least_squares_equations.h>
#include <Shape_characteristics/curvature/internal/estimate_curvatures.h>
#include <Shape_characteristics/curvature/internal/fit_to_neighbors.h>
#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/are_on_curve.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

template <typename SampledSurface>
class Razdan_bae_estimator
{
  using Index = typename SampledSurface::Index;
  using Vector = Eigen::Vector3d;

public:
  using Workspace = typename SampledSurface::Workspace;

  explicit Razdan_bae_estimator(const SampledSurface& surface) : m_surface(surface) {}

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    return fit_to_neighbors(m_surface, i, s_minimum, workspace,
                            [&](const std::vector<Index>& neighbors) { return fit(i, neighbors); });
  }

private:
  static constexpr std::size_t s_minimum = 8; // and the sample itself, for nine control points

  Curvature_estimate fit(std::size_t i, const std::vector<Index>& neighbors) const
  {
    const Curvature_estimate failure(Estimation_status::DEGENERATE);
    const Vector& p = m_surface.point(i);
    const Vector& n = m_surface.normal(i);
    const double size = size_of_neighborhood(m_surface, i, neighbors);
    if(!(size > 0. && std::isfinite(size)) || are_on_curve(m_surface, i, neighbors))
      return failure;

    // the direction of the nearest neighbor that isn't seen along the normal
    Vector t1 = Vector::Zero();
    for(const Index j : neighbors)
    {
      const Vector d = (m_surface.point(j) - p) / size;
      t1 = d - d.dot(n) * n;
      if(t1.squaredNorm() > s_least_square * d.squaredNorm())
        break;
    }
    const double length = t1.norm();
    if(!(length > 0.))
      return failure;
    t1 /= length;
    const Vector t2 = n.cross(t1);

    Least_squares_equations<9> equations;
    double p_sum = 0., q_sum = 0., r_sum = 0., s_sum = 0.;
    equations.add({1., 0., 0., 0., 0., 0., 0., 0., 0.}, 0.);
    for(const Index j : neighbors)
    {
      const Vector d = (m_surface.point(j) - p) / size;
      const double x = d.dot(t1), y = d.dot(t2), xx = x * x, yy = y * y;
      p_sum += xx;
      q_sum += x * y;
      r_sum += yy;
      s_sum += xx * yy;
      equations.add({1., x, y, .5 * xx, x * y, .5 * yy, xx * y, x * yy, xx * yy}, d.dot(n));
    }
    const double trace = p_sum + r_sum;
    if(!(determinant(p_sum, q_sum, r_sum) > s_least_square * trace * trace))
      return failure; // points on a line
    if(!(double(neighbors.size()) * s_sum > s_least_square_off_axes * p_sum * r_sum))
      return failure; // on both axes alone, as at a vertex of degree four: the products are rounding errors
    Least_squares_equations<9>::Coefficients c;
    if(!equations.solve(c, s_smallest_pivot) ||
       (std::min)({equations.independence(3), equations.independence(4), equations.independence(5)}) <
           s_least_independence)
      return failure;

    const Vector x_1 = t1 + c[1] * n, x_2 = t2 + c[2] * n;
    const double root = std::sqrt(1. + c[1] * c[1] + c[2] * c[2]), scale = 1. / (root * size);
    const Vector normal = (n - c[1] * t1 - c[2] * t2) / root;
    return Curvature_estimate(
        m_surface.status(i),
        eigen_of_second_fundamental_form(normal, c[3] * scale, c[4] * scale, c[5] * scale, x_1, x_2));
  }

  static constexpr double s_least_square = 1e-6; // of a sine
  // of the product of both coordinates, relative to the squares of each; about 1 where points are spread evenly
  static constexpr double s_least_square_off_axes = .01;
  // else a larger neighborhood is better
  static constexpr double s_smallest_pivot = 1e-3;
  static constexpr double s_least_independence = .01; // of the columns of the second derivatives

  const SampledSurface& m_surface;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a mesh by fitting biquadratic Bézier patches \cgalCite{razdan_bae} (thesis,
  section 5.2.1).

  Over the tangent plane of the vertex, with the first axis in the direction of the nearest neighbor, the vertex and its
  neighbors are described by a Bézier patch of degree two in both parameters, which are the coordinates in the plane. Its nine control
  points solve the equations of least squares. The first two coordinates of a point are met exactly, so
  that what is fitted is the height \f$ z = \sum_{i,j \le 2} c_{ij} x^i y^j \f$; as all bases of these polynomials give the same
  patch, the powers around the vertex are used, and not Bernstein's. The curvatures are those of the patch over the vertex, and the
  directions lie in its tangent plane there. The paper's weights that smooth noisy meshes are left out.

  Normals choose the tangent plane and the outer side alone: positions determine the curvatures. With a neighborhood of
  two rings, as the paper recommends, the error falls with the square of its size where neighbors lie symmetrically, and linearly
  elsewhere: patches have cubic terms, but not all of them. For the same reason it depends a little on the direction of the axes.

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
      \cgalParamDefault{`2`}
      \cgalParamExtra{Where the neighbors are fewer than eight, or don't determine a patch, up to two rings are
                      added. If that isn't enough, the status is `FEW_NEIGHBOURS` or `DEGENERATE`.}
    \cgalParamNEnd
    \scRadiusOfMeshParameter
    \scCallbackParameter
  \cgalNamedParamsEnd

  Where the points don't determine a patch (points on few lines, say), the status is `DEGENERATE`.

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if `number_of_rings` or `neighbor_radius` is out of its range

  Complexity: linear in the number of vertices \f$ n \f$: \f$ O(n m) \f$ for neighborhoods of \f$ m \f$ vertices.

  \cgalExample{curvature/razdan_bae_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t razdan_bae_curvatures(const FaceGraph& mesh,
                                  const NamedParameters& np = parameters::default_values())
{
  const Face_graph_samples surface =
      sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np);
  const internal::Razdan_bae_estimator<Face_graph_samples> estimator(surface);
  return internal::estimate_vertices<ConcurrencyTag>(mesh, surface, estimator, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a mesh: those that `razdan_bae_curvatures()` of the whole mesh
  gives, bit for bit.

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
Estimation_status razdan_bae_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                        const FaceGraph& mesh,
                                        const NamedParameters& np = parameters::default_values())
{
  using Estimator = internal::Razdan_bae_estimator<Face_graph_samples>;
  const Face_graph_samples surface = sampled_surface(v, mesh, internal::mesh_neighborhood(np), 1, np);
  const Estimator estimator(surface);
  typename Estimator::Workspace workspace;
  return internal::write_to_references(estimator(0, workspace), np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the points of a point set with normals, as `razdan_bae_curvatures()` of a mesh
  does.

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
      \cgalParamExtra{With fewer than eight, every status is `FEW_NEIGHBOURS`.}
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
std::size_t razdan_bae_curvatures(PointRange&& points,
                                  const NamedParameters& np = parameters::default_values())
{
  const Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np), np);
  const internal::Razdan_bae_estimator<Point_set_samples> estimator(surface);
  return internal::estimate_points<ConcurrencyTag>(points, surface.size(), estimator, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_RAZDAN_BAE_CURVATURES_H
