#ifndef SHAPE_CHARACTERISTICS_CURVATURE_JET_FITTING_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_JET_FITTING_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/estimate_curvatures.h>
#include <Shape_characteristics/curvature/internal/fit_to_neighbors.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/Eigen_svd.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

template <typename NamedParameters>
std::int64_t degree_of_jets(const NamedParameters& np)
{
  const std::int64_t degree =
      whole_number(np, internal_np::degree_fitting, std::int64_t(4), "degree_fitting");
  // CGAL computes factorials of the degree in unsigned int
  if(degree < 2 || degree > 12)
    throw std::invalid_argument("Shape_characteristics: degree_fitting must be from 2 to 12");
  return degree;
}

template <typename SampledSurface>
class Jet_fitting_estimator
{
  using Index = typename SampledSurface::Index;
  using Kernel = CGAL::Simple_cartesian<double>;
  using Monge_via_jet_fitting = CGAL::Monge_via_jet_fitting<Kernel, Kernel, CGAL::Eigen_svd>;

public:
  struct Workspace
  {
    typename SampledSurface::Workspace neighbors;
    std::vector<Kernel::Point_3> points;
  };

  template <typename NamedParameters>
  Jet_fitting_estimator(const SampledSurface& surface, const NamedParameters& np) : m_surface(surface)
  {
    m_degree = static_cast<std::size_t>(degree_of_jets(np));
  }

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    return fit_to_neighbors(m_surface, i, (m_degree + 1) * (m_degree + 2) / 2 - 1, workspace.neighbors,
                            [&](const std::vector<Index>& neighbors)
                            { return fit(i, neighbors, workspace.points); });
  }

private:
  Curvature_estimate
  fit(std::size_t i, const std::vector<Index>& neighbors, std::vector<Kernel::Point_3>& points) const
  {
    // Relative to the sample, and of unit size: otherwise digits are lost far from the origin, and squares of lengths
    // are not in the range of numbers.
    const Eigen::Vector3d& p = m_surface.point(i);
    const double size = size_of_neighborhood(m_surface, i, neighbors);
    if(!(size > 0. && std::isfinite(size)))
      return Curvature_estimate(Estimation_status::DEGENERATE);

    points.assign(1, Kernel::Point_3(0., 0., 0.)); // where the jet is taken
    for(const Index j : neighbors)
    {
      const Eigen::Vector3d d = (m_surface.point(j) - p) / size;
      points.emplace_back(d.x(), d.y(), d.z());
    }

    Monge_via_jet_fitting jet_fitting;
    auto monge = jet_fitting(points.begin(), points.end(), m_degree, 2);
    if(!(jet_fitting.condition_number() < s_largest_condition))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    const Eigen::Vector3d& n = m_surface.normal(i);
    const double cosine = n.dot(to_eigen(monge.normal_direction()));
    const double cosine_of_plane = n.dot(to_eigen(jet_fitting.pca_basis(2).second));
    if(!(std::abs(cosine) > s_smallest_cosine && std::abs(cosine_of_plane) > s_smallest_cosine_of_plane))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    monge.comply_wrt_given_normal(Kernel::Vector_3(n.x(), n.y(), n.z()));

    // the height over the tangent plane is (k_0 x^2 + k_1 y^2) / 2 with k_0 >= k_1: negative where convex
    Shape_operator_eigen result;
    result.min_curvature = -monge.principal_curvatures(0) / size;
    result.max_curvature = -monge.principal_curvatures(1) / size;
    // Of a steep polynomial, the directions are as inexact as the products of its slopes.
    result.min_direction = to_eigen(monge.maximal_principal_direction()).normalized();
    const Eigen::Vector3d max_direction = to_eigen(monge.minimal_principal_direction()).normalized();
    const double inexactness = result.min_direction.dot(max_direction);
    if(!(std::abs(inexactness) < s_largest_inexactness))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    result.max_direction = (max_direction - inexactness * result.min_direction).normalized();
    return Curvature_estimate(m_surface.status(i), result);
  }

  // As many times as this, what the polynomial leaves of the surface may become; where more would, as beside a border, where points are on
  // few lines, a larger neighborhood is better. Points on a curve, which determine no surface, give the reciprocal of the machine
  // precision.
  static constexpr double s_largest_condition = 1e6;
  // a fitted surface nearly perpendicular to the given one has no outside
  static constexpr double s_smallest_cosine = 0.1;
  // A neighborhood that bends by more than it is wide fits best a plane that is seen from its side: there the surface isn't a
  // height, whatever normal the polynomial has.
  static constexpr double s_smallest_cosine_of_plane = 0.3;
  // of the cosine between the principal directions
  static constexpr double s_largest_inexactness = 1e-5;

  const SampledSurface& m_surface;
  std::size_t m_degree;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a mesh by fitting polynomials, with
  `CGAL::Monge_via_jet_fitting` \cgalCite{cazals_pouget}.

  The vertex and its neighbors are described as a height over the plane that fits them best, and a polynomial of
  the given degree is fitted to it by least squares. The curvatures are those of the polynomial at the vertex. Normals
  don't take part, but for saying which side is outside and refusing what is perpendicular to them. On a smooth surface without noise, the error falls with the power
  `degree_fitting` - 1 of the size of the neighborhood.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`; faces may have any number of vertices
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \scMeshInputParameters
    \cgalParamNBegin{degree_fitting}
      \cgalParamDescription{the degree \f$ d \f$ of the polynomials, from 2 to 12}
      \cgalParamType{an integer type}
      \cgalParamDefault{`4`}
      \cgalParamExtra{They have \f$ (d+1)(d+2)/2 \f$ coefficients, and need as many points.}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_rings}
      \cgalParamDescription{the size of the neighborhood, in edges}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`2`}
      \cgalParamExtra{Where the neighbors are too few for the degree, or don't determine a polynomial, up to two rings are added. If that isn't enough, the
                      status is `FEW_NEIGHBOURS` or `DEGENERATE`. The degree is never lowered.}
    \cgalParamNEnd
    \scRadiusOfMeshParameter
    \scCallbackParameter
  \cgalNamedParamsEnd

  The principal directions are orthogonal to the normal of the fitted surface, which is not exactly the given one. Where
  the points don't determine a polynomial (points on a line, say), or the given normal is almost perpendicular to that of the
  polynomial or of the plane, the status is `DEGENERATE`. The plane is seen from its side where rows of long triangles
  bend by more than they are wide.

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if `degree_fitting`, `number_of_rings` or `neighbor_radius` is out of its range

  Complexity: linear in the number of vertices \f$ n \f$: \f$ O(n m d^4) \f$ for neighborhoods of \f$ m \f$ vertices.

  \cgalExample{curvature/jet_fitting_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t jet_fitting_curvatures(const FaceGraph& mesh,
                                   const NamedParameters& np = parameters::default_values())
{
  const Face_graph_samples surface =
      sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np);
  const internal::Jet_fitting_estimator<Face_graph_samples> estimator(surface, np);
  return internal::estimate_vertices<ConcurrencyTag>(mesh, surface, estimator, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a mesh: those that `jet_fitting_curvatures()` of the whole mesh gives, bit for
  bit.

  \param v the vertex
  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `degree_fitting`, `number_of_rings` and
         `neighbor_radius` as for the whole mesh, and the ones listed below

  \cgalNamedParamsBegin
    \scVertexOutputParameters
    \scMeshInputParameters
  \cgalNamedParamsEnd

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument as for the whole mesh

  Complexity: that of the neighborhood, whatever the size of the mesh.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status jet_fitting_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                         const FaceGraph& mesh,
                                         const NamedParameters& np = parameters::default_values())
{
  using Estimator = internal::Jet_fitting_estimator<Face_graph_samples>;
  const Face_graph_samples surface = sampled_surface(v, mesh, internal::mesh_neighborhood(np), 1, np);
  const Estimator estimator(surface, np);
  typename Estimator::Workspace workspace;
  return internal::write_to_references(estimator(0, workspace), np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the points of a point set with normals, as `jet_fitting_curvatures()` of a mesh does.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetOutputParameters
    \scPointSetInputParameters
    \cgalParamNBegin{degree_fitting}
      \cgalParamDescription{the degree of the polynomials, from 2 to 12}
      \cgalParamType{an integer type}
      \cgalParamDefault{`4`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_neighbors}
      \cgalParamDescription{the size of the neighborhood: as many nearest points}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{twice as many as the polynomial has coefficients, and 2, or at least 18: of degree 4, 32}
      \cgalParamExtra{With fewer than the polynomial needs, every status is `FEW_NEIGHBOURS`. Where points lie in rows, as on a
                      grid, hardly more than these are all in few rows, and the polynomial between is anything, or the status
                      `DEGENERATE`.}
    \cgalParamNEnd
    \scRadiusOfPointSetParameter
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of points that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument as for meshes, and if there is no normal map

  Complexity: \f$ O(n (\log n + m d^4)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
std::size_t jet_fitting_curvatures(PointRange&& points,
                                   const NamedParameters& np = parameters::default_values())
{
  const std::int64_t degree = internal::degree_of_jets(np);
  const std::int64_t usual = (std::max)((degree + 1) * (degree + 2) + 2, std::int64_t(18));
  const Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np, usual), np);
  const internal::Jet_fitting_estimator<Point_set_samples> estimator(surface, np);
  return internal::estimate_points<ConcurrencyTag>(points, surface.size(), estimator, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_JET_FITTING_CURVATURES_H
