#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_OF_MESH_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_OF_MESH_H

#include <Shape_characteristics/head_features/internal/Head_surface.h>
#include <Shape_characteristics/internal/to_eigen.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// A mesh as the detection sees it: in the frame of the head, without triangles that have corners nowhere. Vertices without triangles
// are nowhere, too.
template <typename FaceGraph>
struct Head_of_mesh
{
  using Vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;

  Head_surface surface;
  std::vector<Vertex_descriptor> descriptors;             // of the vertices
  Eigen::Affine3d to_frame = Eigen::Affine3d::Identity(); // a similarity

  template <typename VertexPointMap>
  Head_of_mesh(const FaceGraph& mesh, const VertexPointMap& vpm)
  {
    auto index_map = get(CGAL::dynamic_vertex_property_t<Head_surface::Index>(), mesh);
    for(const Vertex_descriptor v : vertices(mesh))
    {
      put(index_map, v, Head_surface::Index(descriptors.size()));
      descriptors.push_back(v);
      surface.points.push_back(to_eigen(get(vpm, v)));
    }
    for(const auto f : faces(mesh))
    {
      std::array<Head_surface::Index, 3> t{};
      std::size_t k = 0;
      bool is_finite = true;
      for(const Vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      {
        if(k == 3)
          ++k;
        if(k > 3)
          break;
        t[k] = get(index_map, v);
        is_finite = is_finite && surface.points[t[k]].allFinite();
        ++k;
      }
      if(k != 3)
        throw std::invalid_argument("Shape_characteristics: detect_head_features() needs a triangle mesh");
      if(is_finite)
        surface.triangles.push_back(t);
    }
    std::vector<bool> is_used(surface.points.size());
    for(const auto& t : surface.triangles)
      for(const auto v : t)
        is_used[v] = true;
    for(std::size_t v = 0; v < is_used.size(); ++v)
      if(!is_used[v])
        surface.points[v].setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  void transform(const Eigen::Affine3d& motion)
  {
    for(Eigen::Vector3d& p : surface.points)
      p = motion * p;
    to_frame = motion * to_frame;
  }

  // of the frame: how long in it what has the length 1 is
  double scale() const { return std::cbrt(std::abs(to_frame.linear().determinant())); }

  // of the vertices of triangles
  Eigen::AlignedBox3d box() const
  {
    Eigen::AlignedBox3d result;
    for(const auto& t : surface.triangles)
      for(const auto v : t)
        result.extend(surface.points[v]);
    return result;
  }

  // whether no vertex has more than one triangle
  bool is_soup() const
  {
    std::vector<bool> is_used(surface.points.size());
    for(const auto& t : surface.triangles)
      for(const auto v : t)
      {
        if(is_used[v])
          return false;
        is_used[v] = true;
      }
    return surface.triangles.size() > 1;
  }

  // Turns all triangles if the surface is inside out: seen from the back of its box, a head or a scan of a face faces away.
  void orient()
  {
    const Eigen::AlignedBox3d b = box();
    const Eigen::Vector3d back(b.center().x(), b.center().y(), b.min().z());
    double volume = 0.;
    for(const auto& [i, j, k] : surface.triangles)
      volume += (surface.points[i] - back).dot((surface.points[j] - back).cross(surface.points[k] - back));
    if(volume < 0.)
      for(auto& t : surface.triangles)
        std::swap(t[1], t[2]);
  }

  // scales and moves the surface so that its box has the center 0 and the longest side 1
  void fit_box()
  {
    const Eigen::AlignedBox3d b = box();
    if(b.isEmpty() || !(b.sizes().maxCoeff() > 0.))
      return;
    Eigen::Affine3d motion = Eigen::Affine3d::Identity();
    motion.scale(1. / b.sizes().maxCoeff()).translate(-b.center());
    transform(motion);
  }
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_OF_MESH_H
