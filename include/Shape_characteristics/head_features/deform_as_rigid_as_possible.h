#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_DEFORM_AS_RIGID_AS_POSSIBLE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_DEFORM_AS_RIGID_AS_POSSIBLE_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/head_features/Surface_handle.h>
#include <Shape_characteristics/head_features/internal/Deform_handles.h>
#include <Shape_characteristics/head_features/internal/Deform_surface_distances.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the part of a mesh that its handles may move, and what they say of it
struct Deform_region
{
  struct Vertex
  {
    std::size_t nearest = 0; // of the points of handles, in its radii
    double distance = std::numeric_limits<double>::infinity();
    bool is_in_region() const { return distance <= 3.; }
    bool is_controlled() const { return distance <= .5; }
  };
  std::vector<Vertex> vertices;
  double unit = 0.; // the largest radius

  Deform_region(const Face_graph_samples& surface, const Deform_handles& handles) : vertices(surface.size())
  {
    Deform_surface_distances distances(surface);
    for(std::size_t k = 0; k < handles.points.size(); ++k)
    {
      const Handle_point& p = handles.points[k];
      const double radius = handles.motions[p.motion].radius;
      unit = (std::max)(unit, radius);
      for(const auto& [vertex, distance] : distances.from(p.vertex, p.position, 3. * radius))
        if(distance / radius < vertices[vertex].distance)
          vertices[vertex] = {k, distance / radius};
      if(!vertices[p.vertex].is_controlled()) // on coarse meshes
        vertices[p.vertex] = {k, .5};
    }
    for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
    {
      bool is_used = false;
      for(std::size_t c = 0; c < 3; ++c)
        is_used = is_used || vertices[surface.vertex(f, c)].is_in_region();
      const Eigen::Vector3d &p = surface.point(surface.vertex(f, 0)),
                            &q = surface.point(surface.vertex(f, 1)),
                            &r = surface.point(surface.vertex(f, 2));
      const double twice_area = length(((q - p) / unit).cross((r - p) / unit).eval());
      if(is_used && (!(twice_area > 0.) || !std::isfinite(twice_area)))
        throw std::invalid_argument(
            "Shape_characteristics: deform_as_rigid_as_possible: a face near a handle has no area");
    }
  }
};

// `mesh` has the vertices of the surface, in their order
template <typename Mesh>
std::vector<Deformed_vertex> deform_rigidly(Mesh& mesh,
                                            const std::vector<typename Mesh::Vertex_index>& vertex_of,
                                            const Face_graph_samples& surface,
                                            const Deform_handles& handles,
                                            unsigned int iterations)
{
  using Point_3 = typename Mesh::Point;
  const Deform_region region(surface, handles);
  std::vector<Deformed_vertex> result;
  if(handles.points.empty())
    return result;
  // CGAL works with a mesh of about unit size near the origin, whatever the unit
  const Eigen::Vector3d origin = handles.points.front().position;
  const auto scaled = [&](const Eigen::Vector3d& p)
  {
    const Eigen::Vector3d q = (p - origin) / region.unit;
    return Point_3(q.x(), q.y(), q.z());
  };
  for(std::size_t i = 0; i < surface.size(); ++i)
    mesh.point(vertex_of[i]) = scaled(surface.point(i));

  CGAL::Surface_mesh_deformation<Mesh> deformation(mesh);
  for(std::size_t i = 0; i < surface.size(); ++i)
    if(region.vertices[i].is_in_region())
      deformation.insert_roi_vertex(vertex_of[i]);
  for(std::size_t i = 0; i < surface.size(); ++i)
    if(region.vertices[i].is_controlled())
      deformation.insert_control_vertex(vertex_of[i]);
  if(!deformation.preprocess())
    throw std::invalid_argument("Shape_characteristics: deform_as_rigid_as_possible: the faces near the "
                                "handles are too badly shaped for the system of equations to be solved");
  for(std::size_t i = 0; i < surface.size(); ++i)
    if(region.vertices[i].is_controlled())
    {
      const Eigen::Vector3d& p = surface.point(i);
      const Handle_motion& motion = handles.motions[handles.points[region.vertices[i].nearest].motion];
      deformation.set_target_position(vertex_of[i], scaled(p + motion.offset(p, 1.)));
    }
  deformation.deform(iterations, 1e-6);

  for(std::size_t i = 0; i < surface.size(); ++i)
    if(region.vertices[i].is_in_region())
    {
      const Eigen::Vector3d& p = surface.point(i);
      const Handle_motion& motion = handles.motions[handles.points[region.vertices[i].nearest].motion];
      const Eigen::Vector3d moved = region.vertices[i].is_controlled()
                                        ? Eigen::Vector3d(p + motion.offset(p, 1.))
                                        : origin + region.unit * to_eigen(mesh.point(vertex_of[i]));
      if(!moved.allFinite())
        throw std::invalid_argument("Shape_characteristics: deform_as_rigid_as_possible: the faces near the "
                                    "handles are too badly shaped");
      result.push_back({Face_graph_samples::Index(i), moved});
    }
  return result;
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  deforms a triangle mesh by handles so that it stays locally as rigid as possible, with
  `CGAL::Surface_mesh_deformation`: the same handles as those of `deform_by_handles()`, of which \f$ \sigma \f$ means something
  else here.

  Vertices within \f$ \sigma / 2 \f$ of a point of a handle, measured over the surface, move as that handle says, by the whole of its
  motion. Those beyond \f$ 3 \sigma \f$ of all points stay. In between, the surface finds its place by itself: the change of the
  edges, up to a rotation of each vertex's faces, is as small as possible (\cgal's \"spokes and rims\"). Where several handles
  are near, the nearest one counts, in units of \f$ \sigma \f$.

  Details of the surface keep their shape, which a Gaussian neighborhood shears and stretches; large motions look more natural, and
  cost a system of linear equations. It is less independent of how the surface is tessellated.

  Neither the unit nor the place of the mesh matters.

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam HandleRange a model of `ConstRange` with value type `Surface_handle<FaceGraph, GeomTraits>`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh; its points change if there is no `deformed_vertex_point_map`. All its faces must be triangles.
  \param handles the handles, all acting at once
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a model of `ReadWritePropertyMap` with value type `%Point_3`; of `ReadablePropertyMap` if there is a
                     `deformed_vertex_point_map`}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
    \cgalParamNBegin{deformed_vertex_point_map}
      \cgalParamDescription{where the points of all vertices are written to, those that don't move as well}
      \cgalParamType{a model of `WritablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`vertex_point_map`: the mesh is deformed in place}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_iterations}
      \cgalParamDescription{how many steps are made at most, at least 1; less if the energy hardly changes any more}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`20`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of vertices that moved

  \throws std::invalid_argument if a face is not a triangle, one near a handle has no area, the system of equations can't be
          solved, or `number_of_iterations` is less than 1; and as `deform_by_handles()` does for handles

  Complexity: linear in the size of the mesh, and the solution of a sparse system of \f$ m \f$ unknowns for \f$ m \f$ vertices
  within \f$ 3 \sigma \f$.

  \cgalExample{head_features/deform_head.cpp}
*/
template <typename FaceGraph,
          typename HandleRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t deform_as_rigid_as_possible(FaceGraph& mesh,
                                        const HandleRange& handles,
                                        const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Graph = std::remove_const_t<FaceGraph>;
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Copy = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

  const std::int64_t iterations =
      internal::whole_number(np, internal_np::number_of_iterations, std::int64_t(20), "number_of_iterations");
  if(iterations < 1)
    throw std::invalid_argument("Shape_characteristics: number_of_iterations must be at least 1");
  const Face_graph_samples surface = internal::surface_to_deform(
      mesh, choose_parameter(get_parameter(np, internal_np::vertex_point),
                             CGAL::get_const_property_map(CGAL::vertex_point, mesh)));
  const internal::Deform_handles numbers(mesh, surface, handles);
  if(!surface.is_triangle_mesh())
    throw std::invalid_argument(
        "Shape_characteristics: deform_as_rigid_as_possible needs a mesh of triangles");

  // a copy: one instantiation of CGAL's class for all types of meshes
  Copy copy;
  std::unordered_map<vertex_descriptor, Copy::Vertex_index> copy_of;
  CGAL::copy_face_graph(mesh, copy,
                        CGAL::parameters::vertex_to_vertex_map(boost::make_assoc_property_map(copy_of)));
  std::vector<Copy::Vertex_index> vertex_of;
  vertex_of.reserve(surface.size());
  for(const vertex_descriptor v : vertices(mesh))
  {
    const auto found = copy_of.find(v); // vertices without faces are left out
    vertex_of.push_back(found != copy_of.end() ? found->second : copy.add_vertex());
  }
  return internal::write_deformed(
      mesh,
      internal::deform_rigidly(copy, vertex_of, surface, numbers,
                               static_cast<unsigned int>((std::min<std::int64_t>)(iterations, 1000000))),
      np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_DEFORM_AS_RIGID_AS_POSSIBLE_H
