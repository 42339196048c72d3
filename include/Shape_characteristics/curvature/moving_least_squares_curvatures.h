#ifndef SHAPE_CHARACTERISTICS_CURVATURE_MOVING_LEAST_SQUARES_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_MOVING_LEAST_SQUARES_CURVATURES_H

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

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// a function of space at a point: value, gradient and Hessian matrix
struct Second_order_jet
{
  double value = 0.;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();

  void add(const Second_order_jet& other, double factor)
  {
    value += factor * other.value;
    gradient += factor * other.gradient;
    hessian += factor * other.hessian;
  }

  // f(*this), with f and its first two derivatives at the value
  Second_order_jet composed(double f, double df, double ddf) const
  {
    Second_order_jet result;
    result.value = f;
    result.gradient = df * gradient;
    result.hessian = df * hessian + ddf * gradient * gradient.transpose();
    return result;
  }
};

inline Second_order_jet operator*(const Second_order_jet& a, const Second_order_jet& b)
{
  Second_order_jet result;
  result.value = a.value * b.value;
  result.gradient = a.value * b.gradient + b.value * a.gradient;
  const Eigen::Matrix3d outer = a.gradient * b.gradient.transpose();
  result.hessian = a.value * b.hessian + b.value * a.hessian + outer + outer.transpose();
  return result;
}

template <typename SampledSurface>
class Moving_least_squares_estimator
{
  using Index = typename SampledSurface::Index;
  using Vector = Eigen::Vector3d;

  struct Point
  {
    Vector position, normal;
  };

public:
  struct Workspace
  {
    typename SampledSurface::Workspace neighbors;
    std::vector<Point> points;
    std::vector<Second_order_jet> weights;
  };

  explicit Moving_least_squares_estimator(const SampledSurface& surface) : m_surface(surface) {}

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    return fit_to_neighbors(m_surface, i, s_minimum, workspace.neighbors,
                            [&](const std::vector<Index>& neighbors)
                            { return fit(i, neighbors, workspace); });
  }

private:
  static constexpr std::size_t s_minimum = 3;
  // Of the Gaussian weights, in root mean square distances: the farthest neighbors of a disk have weights of e^-8. They
  // are cut off there, and with larger weights the second derivatives would see that.
  static constexpr double s_width = .5;

  Curvature_estimate fit(std::size_t i, const std::vector<Index>& neighbors, Workspace& workspace) const
  {
    const Curvature_estimate failure(Estimation_status::DEGENERATE);
    const Vector& p = m_surface.point(i);
    const Vector& n = m_surface.normal(i);
    const double size = size_of_neighborhood(m_surface, i, neighbors);
    // the farther half hardly counts
    const std::vector<Index> nearest(neighbors.begin(),
                                     neighbors.begin() + std::ptrdiff_t((neighbors.size() + 1) / 2));
    if(!(size > 0. && std::isfinite(size)) || are_on_curve(m_surface, i, nearest))
      return failure;
    std::vector<Point>& points = workspace.points;
    points.assign(1, {Vector::Zero(), n});
    for(const Index j : neighbors)
      points.push_back({(m_surface.point(j) - p) / size, m_surface.normal(j)});
    if(!spans_a_plane(points, n))
      return failure;

    // from the sample to the surface, and the function there
    Vector x = Vector::Zero();
    Second_order_jet g;
    for(int step = 0; step < s_steps; ++step)
    {
      if(!evaluate(x, workspace, g))
        return failure;
      const double square = g.gradient.squaredNorm();
      const Vector move = -(g.value / square) * g.gradient;
      if(!(square > 0.) || !((x + move).norm() < s_longest_move))
        return failure;
      if(move.norm() < 1e-9) // the function is as good as that here
        break;
      x += move;
    }
    if(!(g.gradient.dot(n) > s_smallest_cosine * g.gradient.norm()))
      return failure;
    Shape_operator_eigen curvatures = curvatures_of_implicit(g.gradient, g.hessian);
    curvatures.min_curvature /= size;
    curvatures.max_curvature /= size;
    return Curvature_estimate(m_surface.status(i), curvatures);
  }

  static constexpr int s_steps = 12;
  static constexpr double s_longest_move = 1., s_smallest_cosine = .1;
  // of the mean of the normals: of those around a thin cylinder or a leaf, rounding errors are all there is
  static constexpr double s_least_normal = 1e-3;

  // not all points are on a line along the normal or in the tangent plane
  static bool spans_a_plane(const std::vector<Point>& points, const Vector& n)
  {
    Vector t1, t2;
    tangent_basis(n, t1, t2);
    double p = 0., q = 0., r = 0.;
    for(const Point& point : points)
    {
      const double x = point.position.dot(t1), y = point.position.dot(t2);
      p += x * x;
      q += x * y;
      r += y * y;
    }
    return determinant(p, q, r) > 1e-10 * (p + r) * (p + r);
  }

  // the sum of theta d (1 - d^2 / h^2) at `x`, with d = (x - q) n(x); false if there is no n(x)
  static bool evaluate(const Vector& x, Workspace& workspace, Second_order_jet& sum)
  {
    constexpr double hh = s_width * s_width;
    std::array<Second_order_jet, 3> n;
    double weights = 0.;
    workspace.weights.clear();
    for(const Point& point : workspace.points)
    {
      const Vector d = x - point.position;
      const double weight = std::exp(-d.squaredNorm() / hh);
      Second_order_jet theta;
      theta.value = weight;
      theta.gradient = (-2. / hh * weight) * d;
      theta.hessian = (4. / (hh * hh) * weight) * d * d.transpose();
      theta.hessian.diagonal().array() -= 2. / hh * weight;
      for(int c = 0; c < 3; ++c)
        n[std::size_t(c)].add(theta, point.normal[c]);
      workspace.weights.push_back(theta);
      weights += weight;
    }
    Second_order_jet square;
    for(const Second_order_jet& component : n)
      square.add(component * component, 1.);
    if(!(square.value > s_least_normal * s_least_normal * weights * weights) || !(square.value > 1e-200))
      return false;
    const double length = std::sqrt(square.value);
    const Second_order_jet inverse = square.composed(1. / length, -.5 / (length * square.value),
                                                     .75 / (length * square.value * square.value));
    Eigen::Matrix3d jacobian;
    Vector normal;
    for(int c = 0; c < 3; ++c)
    {
      Second_order_jet& component = n[std::size_t(c)];
      component = component * inverse;
      normal[c] = component.value;
      jacobian.row(c) = component.gradient.transpose();
    }

    sum = Second_order_jet();
    for(std::size_t k = 0; k < workspace.points.size(); ++k)
    {
      const Vector d = x - workspace.points[k].position;
      Second_order_jet distance;
      distance.value = d.dot(normal);
      distance.gradient = normal + jacobian.transpose() * d;
      distance.hessian = jacobian + jacobian.transpose();
      for(int c = 0; c < 3; ++c)
        distance.hessian += d[c] * n[std::size_t(c)].hessian;
      const double v = distance.value;
      sum.add(workspace.weights[k] *
                  distance.composed(v * (1. - v * v / hh), 1. - 3. * v * v / hh, -6. * v / hh),
              1.);
    }
    return true;
  }

  const SampledSurface& m_surface;
};

// three rings, or as many points, unless something is asked for
template <typename SampledSurface, typename NamedParameters>
Neighborhood moving_least_squares_neighborhood(const NamedParameters& np)
{
  constexpr bool is_mesh = std::is_same<SampledSurface, Face_graph_samples>::value;
  if constexpr(number_of_neighborhoods<NamedParameters> == 0)
    return is_mesh ? Neighborhood::rings(3) : Neighborhood::nearest(36);
  else if constexpr(is_mesh)
    return mesh_neighborhood(np);
  else
    return point_set_neighborhood(np);
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the points of a point set with normals as those of its moving least squares surface
  \cgalCite{yang_qian} (thesis, section 5.2.2).

  With Gaussian weights \f$ \theta_i = \exp(-\lVert x - q_i \rVert^2 / h^2) \f$ of the points \f$ q_i \f$, and with the direction
  \f$ n(x) = \sum \theta_i n_i / \lVert \sum \theta_i n_i \rVert \f$ of the weighted mean of their normals, the surface is the set of points that
  are the best ones along \f$ n(x) \f$: where

  \f[ g(x) = \sum_i \theta_i \, d_i \left( 1 - \frac{d_i^2}{h^2} \right), \qquad d_i = (x - q_i) \cdot n(x), \f]

  vanishes. The curvatures are those of this implicit surface, from exact derivatives of \f$ g \f$, at the point of
  the surface to which Newton's steps along the gradient lead from the sample. The directions are orthogonal to the surface's
  normal there. The width \f$ h \f$ is 0.5 times the root mean square distance of the neighbors:
  the farthest of them hardly matter, so that their sudden end doesn't.

  The surface doesn't pass through the points, but smooths them. A part of the error remains however fine the sampling
  is, because its second derivatives see how the points are spread: on a torus, about 5 % of the largest curvature. Larger
  neighborhoods make it smaller on irregular samples.

  \scConcurrencyTag
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
      \cgalParamDefault{`36`}
      \cgalParamExtra{With fewer than three, every status is `FEW_NEIGHBOURS`.}
    \cgalParamNEnd
    \scRadiusOfPointSetParameter
    \scCallbackParameter
  \cgalNamedParamsEnd

  Where neighbors lie on a line, where normals cancel, or where the surface is farther from the sample than
  the neighborhood's size or turned away from its normal, the status is `DEGENERATE`.

  \return the number of points that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if `number_of_neighbors` or `neighbor_radius` is out of its range, or if there is no normal
          map

  Complexity: \f$ O(n (\log n + m)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$.

  \cgalExample{curvature/moving_least_squares_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
std::size_t moving_least_squares_curvatures(PointRange&& points,
                                            const NamedParameters& np = parameters::default_values())
{
  const Point_set_samples surface =
      sampled_surface(points, internal::moving_least_squares_neighborhood<Point_set_samples>(np), np);
  const internal::Moving_least_squares_estimator<Point_set_samples> estimator(surface);
  return internal::estimate_points<ConcurrencyTag>(points, surface.size(), estimator, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a mesh as `moving_least_squares_curvatures()` of a point set does, with
  neighbors that are found along the edges.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
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
      \cgalParamDefault{`3`}
      \cgalParamExtra{Where the neighbors are fewer than three, or on a line, up to two rings are added. If that isn't
                      enough, the status is `FEW_NEIGHBOURS` or `DEGENERATE`.}
    \cgalParamNEnd
    \scRadiusOfMeshParameter
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if `number_of_rings` or `neighbor_radius` is out of its range

  Complexity: \f$ O(n m) \f$ for \f$ n \f$ vertices with neighborhoods of \f$ m \f$.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t moving_least_squares_curvatures(const FaceGraph& mesh,
                                            const NamedParameters& np = parameters::default_values())
{
  const Face_graph_samples surface = sampled_surface<ConcurrencyTag>(
      mesh, internal::moving_least_squares_neighborhood<Face_graph_samples>(np), np);
  const internal::Moving_least_squares_estimator<Face_graph_samples> estimator(surface);
  return internal::estimate_vertices<ConcurrencyTag>(mesh, surface, estimator, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a mesh: those that `moving_least_squares_curvatures()` of the whole mesh gives,
  bit for bit.

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
Estimation_status moving_least_squares_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                                  const FaceGraph& mesh,
                                                  const NamedParameters& np = parameters::default_values())
{
  using Estimator = internal::Moving_least_squares_estimator<Face_graph_samples>;
  const Face_graph_samples surface =
      sampled_surface(v, mesh, internal::moving_least_squares_neighborhood<Face_graph_samples>(np), 1, np);
  const Estimator estimator(surface);
  typename Estimator::Workspace workspace;
  return internal::write_to_references(estimator(0, workspace), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_MOVING_LEAST_SQUARES_CURVATURES_H
