#ifndef SHAPE_CHARACTERISTICS_CURVATURE_GOLDFEATHER_INTERRANTE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_GOLDFEATHER_INTERRANTE_CURVATURES_H

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
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

using Cubic_fit_equations = Least_squares_equations<7>;

template <typename SampledSurface>
class Goldfeather_interrante_estimator
{
  using Index = typename SampledSurface::Index;
  using Vector = Eigen::Vector3d;

public:
  using Workspace = typename SampledSurface::Workspace;

  explicit Goldfeather_interrante_estimator(const SampledSurface& surface) : m_surface(surface) {}

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    return fit_to_neighbors(m_surface, i, s_minimum, workspace,
                            [&](const std::vector<Index>& neighbors) { return fit(i, neighbors); });
  }

private:
  static constexpr std::size_t s_minimum = 3; // neighbors, of three equations each

  Curvature_estimate fit(std::size_t i, const std::vector<Index>& neighbors) const
  {
    // in the frame of the sample, and of unit size: results don't depend on the unit of length
    const Vector& n = m_surface.normal(i);
    Vector t1, t2;
    tangent_basis(n, t1, t2);
    const double size = size_of_neighborhood(m_surface, i, neighbors);
    if(!(size > 0. && std::isfinite(size)) || are_on_curve(m_surface, i, neighbors))
      return Curvature_estimate(Estimation_status::DEGENERATE);

    Cubic_fit_equations equations = equations_of(i, neighbors, t1, t2, size);
    Cubic_fit_equations::Coefficients solution;
    if(!equations.solve(solution) || are_in_line(equations, i, neighbors, t1, t2, size))
      return Curvature_estimate(Estimation_status::DEGENERATE);

    // the height is (l x^2 + 2 m x y + n y^2) / 2 + ...: negative where convex
    return Curvature_estimate(
        m_surface.status(i),
        eigen_of_shape_operator(n, -solution[0] / size, -solution[1] / size, -solution[2] / size, t1, t2));
  }

  // Over the axes `t1` and `t2` of the tangent plane.
  Cubic_fit_equations equations_of(std::size_t i,
                                   const std::vector<Index>& neighbors,
                                   const Vector& t1,
                                   const Vector& t2,
                                   double size) const
  {
    const Vector& p = m_surface.point(i);
    const Vector& n = m_surface.normal(i);
    Cubic_fit_equations equations;
    for(const Index j : neighbors)
    {
      const Vector d = (m_surface.point(j) - p) / size;
      const Vector& normal = m_surface.normal(j);
      const double x = d.dot(t1), y = d.dot(t2), z = d.dot(n);
      const double a = normal.dot(t1), b = normal.dot(t2), c = normal.dot(n);
      const double xx = x * x, xy = x * y, yy = y * y;
      equations.add({0.5 * xx, xy, 0.5 * yy, xx * x, xx * y, x * yy, y * yy}, z);
      // The slopes are -a / c and -b / c. Multiplied by c, the equations of a steep surface don't outweigh all others.
      equations.add({c * x, c * y, 0., 3. * c * xx, 2. * c * xy, c * yy, 0.}, -a);
      equations.add({0., c * x, c * y, 0., c * xx, 2. * c * xy, 3. * c * yy}, -b);
    }
    return equations;
  }

  // Whether the solved `equations` say little about the curvature across a line that the neighbors are near to. Then what a cubic
  // polynomial can't describe is taken for that curvature. How near they are doesn't tell: rows of long triangles are near to a
  // line, too, and determine a polynomial well, where neighbors on one curve don't.
  bool are_in_line(const Cubic_fit_equations& equations,
                   std::size_t i,
                   const std::vector<Index>& neighbors,
                   const Vector& t1,
                   const Vector& t2,
                   double size) const
  {
    const double l = equations.error_factor(0), m = equations.error_factor(1), n = equations.error_factor(2);
    if(l * l + 2. * m * m + n * n < s_largest_error_factor * s_largest_error_factor)
      return false;
    // along the line and across it, coefficients differ in size alone, and that plays no role
    double p = 0., q = 0., r = 0.;
    for(const Index j : neighbors)
    {
      const Vector d = (m_surface.point(j) - m_surface.point(i)) / size;
      const double x = d.dot(t1), y = d.dot(t2);
      p += x * x;
      q += x * y;
      r += y * y;
    }
    const double angle = .5 * std::atan2(2. * q, p - r), cosine = std::cos(angle), sine = std::sin(angle);
    Cubic_fit_equations along =
        equations_of(i, neighbors, cosine * t1 + sine * t2, cosine * t2 - sine * t1, size);
    Cubic_fit_equations::Coefficients solution;
    return !along.solve(solution) || (std::min)({along.independence(0), along.independence(1),
                                                 along.independence(2)}) < s_least_independence;
  }

  // of the shape operator; of usual neighborhoods, below 10; of rows of triangles ten times as long as wide, below 100
  static constexpr double s_largest_error_factor = 300.;
  // of usual neighborhoods, above 0.1
  static constexpr double s_least_independence = .03;

  const SampledSurface& m_surface;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a mesh by fitting cubic polynomials to points and normals
  \cgalCite{goldfeather_interrante}.

  Over the tangent plane of the vertex, its neighbors are described as a height \f$ z = \frac{1}{2} (a x^2 + 2 b x y + c y^2) +
  d x^3 + e x^2 y + f x y^2 + g y^3 \f$. Each neighbor gives three equations: of its height, and of the two slopes that its
  normal tells; they are solved by least squares. The curvatures are those of the polynomial at the vertex. With
  exact normals, the error falls with the square of the size of the neighborhood.

  The equations of the slopes are multiplied by the cosine between the normals, in contrast to the paper: otherwise a
  neighbor on a steep part outweighs all others.

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
      \cgalParamExtra{Where the neighbors are fewer than three, or don't determine a polynomial, up to two rings are
                      added. If that isn't enough, the status is `FEW_NEIGHBOURS` or `DEGENERATE`.}
    \cgalParamNEnd
    \scRadiusOfMeshParameter
    \scCallbackParameter
  \cgalNamedParamsEnd

  Where points and normals don't determine a polynomial (points on a line, or near to one and on one curve), the status is
  `DEGENERATE`.

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if `number_of_rings` or `neighbor_radius` is out of its range

  Complexity: linear in the number of vertices \f$ n \f$: \f$ O(n m) \f$ for neighborhoods of \f$ m \f$ vertices.

  \cgalExample{curvature/goldfeather_interrante_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t goldfeather_interrante_curvatures(const FaceGraph& mesh,
                                              const NamedParameters& np = parameters::default_values())
{
  const Face_graph_samples surface =
      sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np);
  const internal::Goldfeather_interrante_estimator<Face_graph_samples> estimator(surface);
  return internal::estimate_vertices<ConcurrencyTag>(mesh, surface, estimator, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a mesh: those that `goldfeather_interrante_curvatures()` of the whole mesh
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
Estimation_status goldfeather_interrante_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                                    const FaceGraph& mesh,
                                                    const NamedParameters& np = parameters::default_values())
{
  using Estimator = internal::Goldfeather_interrante_estimator<Face_graph_samples>;
  const Face_graph_samples surface = sampled_surface(v, mesh, internal::mesh_neighborhood(np), 1, np);
  const Estimator estimator(surface);
  typename Estimator::Workspace workspace;
  return internal::write_to_references(estimator(0, workspace), np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the points of a point set with normals, as `goldfeather_interrante_curvatures()` of a mesh
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
      \cgalParamExtra{With fewer than three, every status is `FEW_NEIGHBOURS`.}
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
std::size_t goldfeather_interrante_curvatures(PointRange&& points,
                                              const NamedParameters& np = parameters::default_values())
{
  const Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np), np);
  const internal::Goldfeather_interrante_estimator<Point_set_samples> estimator(surface);
  return internal::estimate_points<ConcurrencyTag>(points, surface.size(), estimator, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_GOLDFEATHER_INTERRANTE_CURVATURES_H
