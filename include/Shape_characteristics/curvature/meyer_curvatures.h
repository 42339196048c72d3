#ifndef SHAPE_CHARACTERISTICS_CURVATURE_MEYER_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_MEYER_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/One_ring.h>
#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/curvature/internal/estimate_curvatures.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The Gaussian curvature is measured by itself: that of the principal curvatures can't exceed the square of the mean one.
struct Meyer_estimate : Curvature_estimate
{
  using Curvature_estimate::Curvature_estimate;
  double measured_Gaussian = std::numeric_limits<double>::quiet_NaN();
};

class Meyer_estimator
{
  using Index = Face_graph_samples::Index;

public:
  struct Workspace
  {
    Face_graph_samples::Workspace neighbors;
    One_ring::Workspace ring;
  };

  explicit Meyer_estimator(const Face_graph_samples& samples) : m_samples(samples)
  {
    require_triangles(samples, "meyer_curvatures");
  }

  Meyer_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    const Estimation_status status = status_from_faces(m_samples, i, workspace.neighbors);
    if(!is_estimated(status))
      return Meyer_estimate(status);
    const Tangent_frame frame(m_samples.normal(i));
    Measures measures;
    if(status == Estimation_status::ESTIMATED && measure(i, frame, measures, workspace))
      return estimate(status, frame, measures, 1.);
    return mean_of_inner_vertices(i, frame, workspace);
  }

private:
  // the shape operator [l m; m n], and the Gaussian curvature
  struct Measures
  {
    double l = 0., m = 0., n = 0., Gaussian = 0.;
  };

  static Meyer_estimate
  estimate(Estimation_status status, const Tangent_frame& frame, const Measures& sum, double count)
  {
    Meyer_estimate result(status, eigen_of_shape_operator(frame.normal, sum.l / count, sum.m / count,
                                                          sum.n / count, frame.t1, frame.t2));
    if(is_estimated(result.status))
      result.measured_Gaussian = sum.Gaussian / count;
    return result;
  }

  // from the triangles all around a vertex; false if one is missing
  bool measure(std::size_t i, const Tangent_frame& frame, Measures& measures, Workspace& workspace) const
  {
    const One_ring ring(m_samples, i, workspace.ring);
    if(!ring.is_complete() || ring.triangles().size() < 3)
      return false;

    Eigen::Vector3d gradient_of_area = Eigen::Vector3d::Zero();
    double area = 0., angles = 0.;
    for(const Ring_triangle& t : ring.triangles())
    {
      gradient_of_area -= .5 * (t.cotangent_at_second() * t.a + t.cotangent_at_first() * t.b);
      area += t.corner_area();
      angles += t.angle();
    }
    const double mean = .5 * gradient_of_area.dot(frame.normal) / area;
    // An angle defect that is all rounding errors is none: the difference of the principal curvatures is a square root.
    constexpr double full = 2. * CGAL_PI, rounding = 8. * std::numeric_limits<double>::epsilon();
    const double defect = std::abs(full - angles) > rounding * full ? full - angles : 0.;
    const double Gaussian = defect / area;

    double c = 0., s = 0.;
    find_direction(ring, frame, mean, c, s);
    const double radius = std::sqrt((std::max)(0., mean * mean - Gaussian)), k = ring.scale();
    measures.l = k * (mean + radius * c);
    measures.m = k * (radius * s);
    measures.n = k * (mean - radius * c);
    measures.Gaussian = k * k * Gaussian;
    return std::isfinite(measures.l + measures.m + measures.n);
  }

  // cosine and sine of twice the angle from the first tangent to the direction of the largest curvature: by least squares
  // of the normal curvatures along the edges, with that mean curvature
  static void
  find_direction(const One_ring& ring, const Tangent_frame& frame, double mean, double& c, double& s)
  {
    double cc = 0., cs = 0., ss = 0., c_side = 0., s_side = 0.;
    const auto add = [&](const Eigen::Vector3d& edge, double square, double weight)
    {
      const double u = edge.dot(frame.t1), v = edge.dot(frame.t2), tangential = u * u + v * v;
      if(!(tangential > 0.))
        return;
      const double cosine = (u * u - v * v) / tangential, sine = 2. * u * v / tangential;
      const double excess = -2. * edge.dot(frame.normal) / square - mean;
      cc += weight * cosine * cosine;
      cs += weight * cosine * sine;
      ss += weight * sine * sine;
      c_side += weight * cosine * excess;
      s_side += weight * sine * excess;
    };
    for(const Ring_triangle& t : ring.triangles())
    {
      add(t.a, t.aa, t.first_corner);
      add(t.b, t.bb, t.second_corner);
    }
    // Edges in two orthogonal directions alone say nothing of other directions: of all solutions the smallest.
    const double ridge = 1e-10 * (cc + ss);
    c = (ss + ridge) * c_side - cs * s_side;
    s = (cc + ridge) * s_side - cs * c_side;
    const double length = std::sqrt(c * c + s * s);
    if(length > 0. && std::isfinite(1. / length))
    {
      c /= length;
      s /= length;
    }
    else
    {
      c = 1.;
      s = 0.;
    }
  }

  // The sum of angles and the gradient of the area around a part of a vertex tell of the border, not of the curvature.
  Meyer_estimate mean_of_inner_vertices(std::size_t i, const Tangent_frame& frame, Workspace& workspace) const
  {
    for(std::size_t minimum = 0;;)
    {
      const std::vector<Index>& neighbors = m_samples.neighbors(i, minimum, workspace.neighbors);
      Measures sum;
      double count = 0.;
      for(const Index j : neighbors)
      {
        if(m_samples.status(j) != Estimation_status::ESTIMATED)
          continue;
        const Tangent_frame other(m_samples.normal(j));
        Measures measures;
        if(!measure(j, other, measures, workspace))
          continue;
        const Eigen::Vector3d u = turned_tangent(frame.t1, frame.normal, other.normal),
                              v = turned_tangent(frame.t2, frame.normal, other.normal);
        const double u_1 = u.dot(other.t1), u_2 = u.dot(other.t2), v_1 = v.dot(other.t1),
                     v_2 = v.dot(other.t2);
        const auto [l, m, n, Gaussian] = measures;
        sum.l += l * u_1 * u_1 + 2. * m * u_1 * u_2 + n * u_2 * u_2;
        sum.m += l * u_1 * v_1 + m * (u_1 * v_2 + u_2 * v_1) + n * u_2 * v_2;
        sum.n += l * v_1 * v_1 + 2. * m * v_1 * v_2 + n * v_2 * v_2;
        sum.Gaussian += Gaussian;
        ++count;
      }
      if(count > 0.)
        return estimate(Estimation_status::BORDER, frame, sum, count);
      if(neighbors.size() < minimum)
        return Meyer_estimate(Estimation_status::DEGENERATE);
      minimum = neighbors.size() + 1; // up to two rings more
    }
  }

  const Face_graph_samples& m_samples;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a triangle mesh from the gradient of the area and the angle defect
  \cgalCite{meyer} (thesis, section 5.1.2).

  With \f$ A \f$ the mixed area of a vertex \f$ x \f$ (the part of its triangles that is closer to it than to
  other vertices; of an obtuse triangle half, or a quarter), with \f$ \alpha \f$ and \f$ \beta \f$ the angles opposite of the edge to
  the neighbor \f$ x_j \f$, and with \f$ \theta \f$ the angles at the vertex,

  \f[ 2 K_H n = \frac{1}{2A} \sum_j (\cot \alpha_j + \cot \beta_j) (x - x_j), \qquad
      K_G = \frac{1}{A} \left( 2 \pi - \sum \theta \right). \f]

  \f$ K_H \f$ is taken from the component along the vertex's normal. The paper takes the length of the whole sum, with the sign of
  this component: where the mean curvature vanishes, that leaves what is tangential, of either sign. The principal curvatures are \f$ K_H \pm \sqrt{\max(K_H^2 - K_G,
  0)} \f$. The directions are those of the quadratic form with trace \f$ 2 K_H \f$ that fits the normal curvatures along
  the edges by least squares, weighted with their parts of the area.

  The Gaussian curvature is the measured one: over a closed mesh, its sum times the mixed areas is exactly \f$ 2 \pi \chi \f$. It
  is not the product of the principal curvatures where it exceeds \f$ K_H^2 \f$.

  Errors of the normals matter in second order alone: positions determine the curvatures. On regular meshes the error falls
  with the square of the edge length; on irregular ones it doesn't vanish, and needles make it large.

  On a border, and where a triangle around a vertex has no area or a point that is not finite, neither the sum of angles nor
  that of cotangents speaks of curvature alone. There the estimate is the mean of those of the inner vertices in
  the nearest ring that has some (of at most three rings), turned into the tangent plane, and the status is `BORDER`; without such
  vertices it is `DEGENERATE`.

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

  \cgalExample{curvature/meyer_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t meyer_curvatures(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  const Face_graph_samples samples = sampled_surface<ConcurrencyTag>(mesh, Neighborhood::rings(1), np,
                                                                     Face_graph_samples::Connectivity::FACES);
  const internal::Meyer_estimator estimator(samples);
  const auto measured =
      internal::estimate_curvatures<ConcurrencyTag>(estimator, samples.size(), internal::callback_of(np));
  std::vector<internal::Curvature_estimate> estimates(measured.begin(), measured.end());
  const std::size_t failures = internal::write_to_mesh(mesh, samples, estimates, np);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_Gaussian_curvature_map_t>::value)
  {
    std::size_t i = 0;
    for(const auto v : vertices(mesh))
      internal::put_number(get_parameter(np, internal_np::vertex_Gaussian_curvature_map), v,
                           measured[i++].measured_Gaussian);
  }
  return failures;
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a triangle mesh: those that `meyer_curvatures()` of the whole mesh gives, bit
  for bit.

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
Estimation_status meyer_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                   const FaceGraph& mesh,
                                   const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter_reference;
  using parameters::is_default_parameter;

  // twice the neighborhood: a border takes the curvatures of its neighbors
  const Face_graph_samples samples = sampled_surface(v, mesh, Neighborhood::rings(1), 2, np);
  const internal::Meyer_estimator estimator(samples);
  internal::Meyer_estimator::Workspace workspace;
  const internal::Meyer_estimate estimate = estimator(0, workspace);
  internal::write_to_references(estimate, np);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_Gaussian_curvature_t>::value)
  {
    auto& value = get_parameter_reference(np, internal_np::vertex_Gaussian_curvature);
    value = std::decay_t<decltype(value)>(estimate.measured_Gaussian);
  }
  return estimate.status;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_MEYER_CURVATURES_H
