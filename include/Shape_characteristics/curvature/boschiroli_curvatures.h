#ifndef SHAPE_CHARACTERISTICS_CURVATURE_BOSCHIROLI_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_BOSCHIROLI_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/One_ring.h>
#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/curvature/internal/estimate_from_triangles.h>
#include <Shape_characteristics/internal/Blended_triangle.h>
#include <Shape_characteristics/internal/Cubic_triangle.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

class Boschiroli_estimator
{
  using Index = Face_graph_samples::Index;

  // an edge from the vertex to another one, of the triangle with this number
  struct Side
  {
    Index end, triangle;
  };

public:
  struct Workspace
  {
    Face_graph_samples::Workspace neighbors;
    One_ring::Workspace ring;
    std::vector<Side> sides;
    std::vector<std::array<Index, 2>>
        across; // by triangle: the numbers of those on the other sides of a and b
  };

  template <typename NamedParameters>
  Boschiroli_estimator(const Face_graph_samples& samples, const NamedParameters&) : m_samples(samples)
  {
    require_triangles(samples, "boschiroli_curvatures");
  }

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    const Estimation_status status = status_at_vertex(m_samples, i, workspace.neighbors);
    if(!is_estimated(status))
      return Curvature_estimate(status);

    const Tangent_frame frame(m_samples.normal(i));
    const One_ring ring(m_samples, i, workspace.ring);
    const One_ring::Workspace& triangles = ring.triangles();
    find_neighbors(triangles, workspace);
    Quadratic_form form;
    for(std::size_t k = 0; k < triangles.size(); ++k)
      add(triangles, k, workspace.across[k], frame, form);
    double l, m, n;
    if(!form.solve(l, m, n))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    return Curvature_estimate(status,
                              eigen_of_shape_operator(frame.normal, ring.scale() * l, ring.scale() * m,
                                                      ring.scale() * n, frame.t1, frame.t2));
  }

private:
  using Vector = Eigen::Vector3d;
  static constexpr Index s_none = (std::numeric_limits<Index>::max)();

  // The quadratic form that fits normal curvatures in directions by least squares.
  class Quadratic_form
  {
  public:
    // x = cos of the angle to the first tangent, y = sin
    void add(double x, double y, double curvature, double weight)
    {
      // in the basis 1, cos 2a, sin 2a
      const double c = x * x - y * y, s = 2. * x * y;
      m_1 += weight;
      m_c += weight * c;
      m_s += weight * s;
      m_cc += weight * c * c;
      m_cs += weight * c * s;
      m_ss += weight * s * s;
      m_k += weight * curvature;
      m_kc += weight * curvature * c;
      m_ks += weight * curvature * s;
    }

    // [l m; m n]; false if the directions don't determine it
    bool solve(double& l, double& m, double& n) const
    {
      if(!(m_1 > 0.))
        return false;
      // elimination without pivoting, in the order 1, c, s: definite
      const double cc = m_cc - m_c * m_c / m_1, cs = m_cs - m_c * m_s / m_1, ss = m_ss - m_s * m_s / m_1;
      const double kc = m_kc - m_c * m_k / m_1, ks = m_ks - m_s * m_k / m_1;
      const double determinant = cc * ss - cs * cs;
      constexpr double least = 1e-6; // of that of all directions
      if(!(determinant > least * .25 * m_1 * m_1))
        return false;
      const double c = (ss * kc - cs * ks) / determinant, s = (cc * ks - cs * kc) / determinant;
      const double mean = (m_k - m_c * c - m_s * s) / m_1;
      l = mean + c;
      m = s;
      n = mean - c;
      return std::isfinite(l + m + n);
    }

  private:
    double m_1 = 0., m_c = 0., m_s = 0., m_cc = 0., m_cs = 0., m_ss = 0., m_k = 0., m_kc = 0., m_ks = 0.;
  };

  static void find_neighbors(const One_ring::Workspace& triangles, Workspace& workspace)
  {
    workspace.sides.clear();
    workspace.across.assign(triangles.size(), {s_none, s_none});
    for(std::size_t k = 0; k < triangles.size(); ++k)
    {
      workspace.sides.push_back({triangles[k].first, Index(k)});
      workspace.sides.push_back({triangles[k].second, Index(k)});
    }
    std::sort(workspace.sides.begin(), workspace.sides.end(),
              [](const Side& a, const Side& b)
              { return a.end != b.end ? a.end < b.end : a.triangle < b.triangle; });
    for(std::size_t k = 0; k + 1 < workspace.sides.size(); ++k)
    {
      const Side &a = workspace.sides[k], &b = workspace.sides[k + 1];
      if(a.end != b.end)
        continue;
      workspace.across[a.triangle][triangles[a.triangle].first == a.end ? 0 : 1] = b.triangle;
      workspace.across[b.triangle][triangles[b.triangle].first == b.end ? 0 : 1] = a.triangle;
    }
  }

  void add(const One_ring::Workspace& triangles,
           std::size_t number,
           const std::array<Index, 2>& across,
           const Tangent_frame& frame,
           Quadratic_form& form) const
  {
    const Ring_triangle& t = triangles[number];
    const Vector &normal_1 = m_samples.normal(t.first), &normal_2 = m_samples.normal(t.second);
    const Cubic_triangle<double> patch({Vector::Zero(), t.a, t.b}, {frame.normal, normal_1, normal_2});
    const Patch_jet<double> jet = patch({1., 0., 0.});

    const double length_u = jet.u.norm(), length_v = jet.v.norm(), lengths = length_u * length_v;
    const double area = jet.u.cross(jet.v).norm();
    constexpr double rounding = 64. * std::numeric_limits<double>::epsilon();
    if(!(area > rounding * lengths))
      return;
    // between edges more than a right angle apart there is more and more to guess
    const double weight = area * (std::min)(1., 1. + jet.u.dot(jet.v) / lengths);

    double e[2] = {0., 0.}; // how the blend moves the middle control point, along the normal
    for(int k = 0; k < 2; ++k)
    {
      if(across[k] == s_none)
        continue;
      const Ring_triangle& other = triangles[across[k]];
      const Index end = k == 0 ? t.first : t.second;
      const bool is_first = other.first == end; // in the other one
      const Vector& far = is_first ? other.b : other.a;
      const Vector& far_normal = m_samples.normal(is_first ? other.second : other.first);
      if(k == 0)
      {
        // the edge opposite of corner 2
        const Cubic_triangle<double> other_patch({far, t.a, Vector::Zero()},
                                                 {far_normal, normal_1, frame.normal});
        e[0] = Edge_correction<double>(patch, 2, other_patch).at_first().dot(frame.normal);
      }
      else
      {
        const Cubic_triangle<double> other_patch({far, Vector::Zero(), t.b},
                                                 {far_normal, frame.normal, normal_2});
        e[1] = Edge_correction<double>(patch, 1, other_patch).at_second().dot(frame.normal);
      }
    }

    const double L = jet.uu.dot(frame.normal), M = jet.uv.dot(frame.normal), N = jet.vv.dot(frame.normal);
    const double ratio = std::sqrt(length_u / length_v);
    for(std::size_t k = 0; k < s_nodes.size(); ++k)
    {
      // Towards the place v on the opposite side: in equal parts of it there are equal parts of the area. The nodes are
      // denser near the shorter edge, where most directions are.
      const double t = s_nodes[k], w = 1. - t + ratio * t, v = ratio * t / w, u = (1. - t) / w;
      const Vector direction = u * jet.u + v * jet.v;
      const double square = direction.squaredNorm(), length = std::sqrt(square);
      const double blend = 12. * u * v * (u * e[0] + v * e[1]);
      const double curvature = -(L * u * u + 2. * M * u * v + N * v * v + blend) / square;
      if(std::isfinite(curvature))
        form.add(direction.dot(frame.t1) / length, direction.dot(frame.t2) / length, curvature,
                 s_weights[k] * weight * ratio / (w * w));
    }
  }

  // Gauss and Legendre's quadrature on [0, 1]
  static constexpr std::array<double, 10> s_nodes = {
      .0130467357414141, .0674683166555077, .1602952158504878, .2833023029353764, .4255628305091844,
      .5744371694908156, .7166976970646236, .8397047841495122, .9325316833444923, .9869532642585859};
  static constexpr std::array<double, 10> s_weights = {
      .0333356721543440, .0747256745752903, .1095431812579910, .1346333596549982, .1477621123573765,
      .1477621123573765, .1346333596549982, .1095431812579910, .0747256745752903, .0333356721543440};

  const Face_graph_samples& m_samples;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a triangle mesh from the PNG1 triangles over its faces \cgalCite{boschiroli}
  (thesis, section 5.2.1).

  Over each triangle there is a patch that joins its neighbors with a continuous tangent plane (`Png1_triangle`), and whose
  second derivatives are known. At a vertex they depend on the direction from which it is approached: the surface is smooth, but
  its curvature isn't continuous there. What it has is a normal curvature in each direction. In the parameters \f$ (u, v) \f$ of
  the patch of one triangle, with the directions \f$ x_u u + x_v v \f$, it is

  \f[ k_n = -\frac{L u^2 + 2 M u v + N v^2 + 12 u v (u\, e_1 + v\, e_2) / (u + v)}{\lVert x_u u + x_v v \rVert^2}, \f]

  where \f$ L, M, N \f$ are the second fundamental form of the PN triangle, and \f$ e_1, e_2 \f$ the components along the normal
  of what the blend adds to its middle control point at the two edges. The estimate is the shape operator that fits \f$ k_n \f$ by
  least squares: over the triangles at the vertex, such that each direction counts as much as there is area in it. Of angles
  larger than \f$ 90^\circ \f$, directions count less, with the factor \f$ 1 + \cos \f$: what is between two edges follows
  from what is along them, the less so the farther they are apart. Where a surface has a continuous
  curvature, this is the one.

  Normals and positions determine the result alike. With exact normals, the error falls with the square of the edge length on
  regular meshes. On others it falls linearly in the end, and is smaller than that of `rusinkiewicz_curvatures()` where the
  surface is well sampled: along the edges alone normal curvatures have quadratic errors. With normals computed from the mesh it doesn't vanish on irregular
  meshes, and is larger than that of estimators that average more. The curvature along a short edge is as wrong as the inverse
  of its length, if normals are, and as its inverse square, if points are: so meshes of marching cubes, unless their
  points are on the surface, are nothing for it.

  Triangles without an area, or with points or normals that are not finite, count for nothing, and their neighbors' edges are
  those of PN triangles, as on a border.

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

  \cgalExample{curvature/boschiroli_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t boschiroli_curvatures(const FaceGraph& mesh,
                                  const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<ConcurrencyTag, internal::Boschiroli_estimator>(mesh, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a triangle mesh: those that `boschiroli_curvatures()` of the whole mesh gives,
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
Estimation_status boschiroli_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                        const FaceGraph& mesh,
                                        const NamedParameters& np = parameters::default_values())
{
  return internal::estimate_from_triangles<internal::Boschiroli_estimator>(v, mesh, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_BOSCHIROLI_CURVATURES_H
