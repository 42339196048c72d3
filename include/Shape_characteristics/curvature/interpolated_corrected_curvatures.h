#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERPOLATED_CORRECTED_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERPOLATED_CORRECTED_CURVATURES_H

#include <Shape_characteristics/internal/CGAL_compatibility.h>

#ifdef SHAPE_CHARACTERISTICS_HAS_INTERPOLATED_CORRECTED_CURVATURES

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/estimate_curvatures.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/callback_of.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// CGAL's mean and Gaussian curvatures are measured by themselves, and not those of its principal curvatures.
struct Corrected_curvature_estimate : Curvature_estimate
{
  using Curvature_estimate::Curvature_estimate;
  double measured_mean = std::numeric_limits<double>::quiet_NaN();
  double measured_Gaussian = std::numeric_limits<double>::quiet_NaN();
};

/*
  Hands CGAL the faces that matter to a vertex as a mesh of their own, for three reasons. CGAL's result depends on the
  unit of length, whatever the point map: concave curvatures near or above 1000 times the mean edge of the mesh are
  taken for the normal's direction. A single point that isn't finite spoils the mean edge, and with it all curvatures.
  And the order of the faces, which decides the last bits, is not the same for all types of meshes.
*/
class Interpolated_corrected_estimator
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Vertex = Mesh::Vertex_index;
  using Normal_map = Mesh::Property_map<Vertex, Kernel::Vector_3>;
  using Index = Face_graph_samples::Index;

public:
  class Workspace
  {
    friend class Interpolated_corrected_estimator;
    Mesh m_mesh;
    Normal_map m_normals = m_mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normal").first;
    std::vector<Index> m_faces;
    std::vector<Vertex> m_corners;
    std::unordered_set<Index> m_visited;
    std::unordered_map<Index, Vertex> m_vertices;
    Face_graph_samples::Workspace m_neighbors;
  };

  // `radius`: of the ball, or 0 for the faces at the vertex
  Interpolated_corrected_estimator(const Face_graph_samples& samples, double radius)
    : m_samples(samples),
      m_radius(radius)
  {}

  Corrected_curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    const Estimation_status status = m_samples.status(i);
    if(!is_estimated(status))
      return Corrected_curvature_estimate(status);
    const auto [begin, end] = m_samples.incident_faces(i);
    if(end - begin < 2 && m_samples.neighbors(i, 3, workspace.m_neighbors).size() < 3)
      return Corrected_curvature_estimate(Estimation_status::FEW_NEIGHBOURS);

    collect_faces(i, workspace);
    const double edge_length = mean_edge_length(workspace.m_faces);
    const double sign = side(workspace.m_faces, edge_length);
    if(sign == 0.)
      return Corrected_curvature_estimate(Estimation_status::DEGENERATE);
    if(has_equal_normals(i, workspace.m_faces))
      return plane(status, m_samples.normal(i));

    for(const double unit : s_units)
      if(const Corrected_curvature_estimate estimate =
             measure(i, status, edge_length / unit, sign, workspace);
         is_estimated(estimate.status))
        return estimate;
    return Corrected_curvature_estimate(Estimation_status::DEGENERATE);
  }

private:
  // The mean edge lengths with which CGAL is called, until one suits. CGAL adds 1000 times the mean edge to the
  // eigenvalue in the direction of the normal to tell it from the others. The less it adds, the less rounding errors
  // the others have (6e-9 per mean edge with the first); but concave curvatures near or above 1000 times the square of
  // the mean edge, per mean edge, then look like the normal's.
  static constexpr double s_units[] = {1. / 32., 1., 32.};

  void collect_faces(std::size_t i, Workspace& workspace) const
  {
    std::vector<Index>& faces = workspace.m_faces;
    faces.clear();
    const auto [begin, end] = m_samples.incident_faces(i);
    std::copy_if(begin, end, std::back_inserter(faces), [&](const Index f) { return is_usable(f); });
    if(m_radius == 0.)
      return;
    // Those that don't touch the ball stay out: where only a part of a mesh is known, they may be missing.
    workspace.m_visited.clear();
    workspace.m_visited.insert(faces.begin(), faces.end());
    for(std::size_t next = 0; next < faces.size(); ++next)
      for(std::size_t k = 0; k < m_samples.degree(faces[next]); ++k)
      {
        const auto [first, last] = m_samples.incident_faces(m_samples.vertex(faces[next], k));
        for(const Index* g = first; g != last; ++g)
          if(workspace.m_visited.insert(*g).second && is_usable(*g) && touches_ball(*g, i))
            faces.push_back(*g);
      }
  }

  bool is_usable(Index f) const
  {
    for(std::size_t k = 0; k < m_samples.degree(f); ++k)
      if(!m_samples.is_usable(m_samples.vertex(f, k)))
        return false;
    return true;
  }

  // whether the normals of all corners are the one of `i`, up to rounding errors
  bool has_equal_normals(std::size_t i, const std::vector<Index>& faces) const
  {
    double largest = 0.;
    for(const Index f : faces)
      for(std::size_t k = 0; k < m_samples.degree(f); ++k)
        largest =
            (std::max)(largest, (m_samples.normal(m_samples.vertex(f, k)) - m_samples.normal(i)).norm());
    return !faces.empty() && largest <= 8. * std::numeric_limits<double>::epsilon();
  }

  // what the eigenvalues' rounding errors would hide
  static Corrected_curvature_estimate plane(Estimation_status status, const Eigen::Vector3d& normal)
  {
    Shape_operator_eigen zero;
    zero.min_curvature = zero.max_curvature = 0.;
    tangent_basis(normal, zero.min_direction, zero.max_direction);
    Corrected_curvature_estimate estimate(status, zero);
    estimate.measured_mean = estimate.measured_Gaussian = 0.;
    return estimate;
  }

  // whether a vertex or the center of a face is in the ball, as CGAL asks
  bool touches_ball(Index f, std::size_t i) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double nearest = std::numeric_limits<double>::infinity();
    for(std::size_t k = 0; k < m_samples.degree(f); ++k)
    {
      const Eigen::Vector3d d = m_samples.point(m_samples.vertex(f, k)) - m_samples.point(i);
      nearest = (std::min)(nearest, length(d));
      sum += d;
    }
    return (std::min)(nearest, length(sum / double(m_samples.degree(f)))) < m_radius;
  }

  double mean_edge_length(const std::vector<Index>& faces) const
  {
    double sum = 0.;
    std::size_t count = 0;
    for(const Index f : faces)
      for(std::size_t k = 0; k < m_samples.degree(f); ++k, ++count)
        sum += length(point(f, k + 1) - point(f, k));
    return sum / double(count);
  }

  const Eigen::Vector3d& point(Index f, std::size_t k) const
  {
    return m_samples.point(m_samples.vertex(f, k % m_samples.degree(f)));
  }

  // 1 if the normals point to the side from which the faces are counterclockwise, -1 if to the other, and 0 if
  // they say neither, for faces without an area too
  double side(const std::vector<Index>& faces, double edge_length) const
  {
    double corrected_area = 0., area = 0.;
    for(const Index f : faces)
    {
      Eigen::Vector3d doubled_area = Eigen::Vector3d::Zero(), normals = Eigen::Vector3d::Zero();
      for(std::size_t k = 0; k < m_samples.degree(f); ++k)
      {
        doubled_area +=
            ((point(f, k) - point(f, 0)) / edge_length).cross((point(f, k + 1) - point(f, 0)) / edge_length);
        normals += m_samples.normal(m_samples.vertex(f, k));
      }
      corrected_area += doubled_area.dot(normals) / double(m_samples.degree(f));
      area += doubled_area.norm();
    }
    const double tolerance = std::sqrt(std::numeric_limits<double>::epsilon());
    if(!(std::abs(corrected_area) > tolerance * area) ||
       !(area > std::numeric_limits<double>::epsilon() * double(faces.size())))
      return 0.;
    return corrected_area > 0. ? 1. : -1.;
  }

  // the faces as a mesh around `i`, in units of `unit`, with normals on the side that `sign` says; false if they don't
  // make a mesh
  bool build_mesh(std::size_t i, double unit, double sign, Workspace& workspace) const
  {
    Mesh& mesh = workspace.m_mesh;
    mesh.clear_without_removing_property_maps();
    workspace.m_vertices.clear();
    const auto add_vertex = [&](const Index j)
    {
      const Eigen::Vector3d p = (m_samples.point(j) - m_samples.point(i)) / unit,
                            n = sign * m_samples.normal(j);
      const Vertex v = mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
      workspace.m_normals[v] = Kernel::Vector_3(n.x(), n.y(), n.z());
      return v;
    };
    workspace.m_vertices.emplace(Index(i), add_vertex(Index(i)));
    for(const Index f : workspace.m_faces)
    {
      workspace.m_corners.clear();
      for(std::size_t k = 0; k < m_samples.degree(f); ++k)
      {
        const Index j = m_samples.vertex(f, k);
        // Without a ball CGAL only goes around the vertex. Faces that share nothing but it do: however many fans
        // they belong to, all of them are seen.
        if(m_radius == 0. && j != i)
          workspace.m_corners.push_back(add_vertex(j));
        else
        {
          auto found = workspace.m_vertices.find(j);
          if(found == workspace.m_vertices.end())
            found = workspace.m_vertices.emplace(j, add_vertex(j)).first;
          workspace.m_corners.push_back(found->second);
        }
      }
      if(mesh.add_face(workspace.m_corners) == Mesh::null_face())
        return false;
    }
    return true;
  }

  Corrected_curvature_estimate
  measure(std::size_t i, Estimation_status status, double unit, double sign, Workspace& workspace) const
  {
    const Corrected_curvature_estimate failure(Estimation_status::DEGENERATE);
    if(!(unit > 0. && std::isfinite(unit)) || !build_mesh(i, unit, sign, workspace))
      return failure;

    double mean = 0., Gaussian = 0.;
    CGAL::Polygon_mesh_processing::Principal_curvatures_and_directions<Kernel> principal;
    CGAL::Polygon_mesh_processing::interpolated_corrected_curvatures(
        Vertex(0), workspace.m_mesh,
        CGAL::parameters::vertex_normal_map(workspace.m_normals)
            .ball_radius(m_radius == 0. ? -1. : m_radius / unit)
            .vertex_mean_curvature(std::ref(mean))
            .vertex_Gaussian_curvature(std::ref(Gaussian))
            .vertex_principal_curvatures_and_directions(std::ref(principal)));

    // CGAL takes the two smallest of three eigenvalues; if the third was that of a tangent, the values are wrong.
    const Eigen::Vector3d& n = m_samples.normal(i);
    const Eigen::Vector3d d = to_eigen(principal.max_direction);
    constexpr double largest_cosine = .1;
    if(!(std::abs(n.dot(d)) < largest_cosine) ||
       !(std::abs(n.dot(to_eigen(principal.min_direction))) < largest_cosine))
      return failure;

    Shape_operator_eigen result;
    result.max_direction = (d - n.dot(d) * n).normalized();
    result.min_direction = n.cross(result.max_direction);
    result.max_curvature = principal.max_curvature / unit;
    result.min_curvature = principal.min_curvature / unit;
    if(sign < 0.)
    {
      std::swap(result.min_direction, result.max_direction);
      std::swap(result.min_curvature, result.max_curvature);
      result.min_curvature = -result.min_curvature;
      result.max_curvature = -result.max_curvature;
    }
    Corrected_curvature_estimate estimate(status, result);
    if(is_estimated(estimate.status))
    {
      estimate.measured_mean = sign * mean / unit;
      estimate.measured_Gaussian = Gaussian / unit / unit;
    }
    return estimate;
  }

  const Face_graph_samples& m_samples;
  double m_radius;
};

template <typename NamedParameters>
double corrected_curvatures_radius(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const double radius = CGAL::to_double(choose_parameter(get_parameter(np, internal_np::ball_radius), -1.));
  if(radius == -1.)
    return 0.;
  if(!(radius > 0. && std::isfinite(radius)))
    throw std::invalid_argument(
        "Shape_characteristics: ball_radius must be positive and finite, or -1 for none");
  return radius;
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a mesh by interpolated corrected curvature measures \cgalCite{lachaud}, with
  `CGAL::Polygon_mesh_processing::interpolated_corrected_curvatures()`. Needs \cgal 6.

  The curvature measures of the faces at a vertex, or of those in a ball around it, with normals interpolated over the faces,
  are divided by their area. Mean and Gaussian curvature are measured by themselves, and so are only about those of the
  principal curvatures.

  In contrast to calling \cgal directly, the result doesn't depend on the unit of length, on the order of vertices and
  faces, or on faraway points that are not finite; a failure is told from a plane; and normals may point to either
  side.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`; faces may have any number of vertices
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \scMeshInputParameters
    \cgalParamNBegin{ball_radius}
      \cgalParamDescription{the radius of the ball in which faces count, in the unit of the points}
      \cgalParamType{`FT`}
      \cgalParamDefault{`-1`: the faces at the vertex count}
    \cgalParamNEnd
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if `ball_radius` is neither positive and finite nor -1

  Complexity: linear in the size of the mesh, times the number of faces in a ball.

  \cgalExample{curvature/interpolated_corrected_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t interpolated_corrected_curvatures(const FaceGraph& mesh,
                                              const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  const double radius = internal::corrected_curvatures_radius(np);
  const Face_graph_samples samples = sampled_surface<ConcurrencyTag>(mesh, Neighborhood::rings(1), np,
                                                                     Face_graph_samples::Connectivity::FACES);
  const internal::Interpolated_corrected_estimator estimator(samples, radius);
  const auto measured =
      internal::estimate_curvatures<ConcurrencyTag>(estimator, samples.size(), internal::callback_of(np));
  std::vector<internal::Curvature_estimate> estimates(measured.begin(), measured.end());
  const std::size_t failures = internal::write_to_mesh(mesh, samples, estimates, np);

  std::size_t i = 0;
  for(const auto v : vertices(mesh))
  {
    if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_mean_curvature_map_t>::value)
      internal::put_number(get_parameter(np, internal_np::vertex_mean_curvature_map), v,
                           measured[i].measured_mean);
    if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_Gaussian_curvature_map_t>::value)
      internal::put_number(get_parameter(np, internal_np::vertex_Gaussian_curvature_map), v,
                           measured[i].measured_Gaussian);
    (void)v;
    ++i;
  }
  return failures;
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a mesh: those that `interpolated_corrected_curvatures()` of the whole mesh
  gives, bit for bit, unless there are triangles much longer than the radius of the ball.

  \param v the vertex
  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": `ball_radius` as for the whole mesh, and
         the ones listed below

  \cgalNamedParamsBegin
    \scVertexOutputParameters
    \scMeshInputParameters
  \cgalNamedParamsEnd

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument as for the whole mesh

  Complexity: that of the neighborhood, whatever the size of the mesh.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status interpolated_corrected_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                                    const FaceGraph& mesh,
                                                    const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter_reference;
  using parameters::is_default_parameter;

  const double radius = internal::corrected_curvatures_radius(np);
  const Neighborhood neighborhood = radius == 0. ? Neighborhood::rings(1) : Neighborhood::ball(radius);
  // twice the ball: the faces that touch it, and those that give their vertices normals
  const Face_graph_samples samples = sampled_surface(v, mesh, neighborhood, 2, np);
  const internal::Interpolated_corrected_estimator estimator(samples, radius);
  internal::Interpolated_corrected_estimator::Workspace workspace;
  const auto estimate = estimator(0, workspace);
  internal::write_to_references(estimate, np);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_mean_curvature_t>::value)
  {
    auto& value = get_parameter_reference(np, internal_np::vertex_mean_curvature);
    value = std::decay_t<decltype(value)>(estimate.measured_mean);
  }
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_Gaussian_curvature_t>::value)
  {
    auto& value = get_parameter_reference(np, internal_np::vertex_Gaussian_curvature);
    value = std::decay_t<decltype(value)>(estimate.measured_Gaussian);
  }
  return estimate.status;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HAS_INTERPOLATED_CORRECTED_CURVATURES

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERPOLATED_CORRECTED_CURVATURES_H
