#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_FEATURES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_FEATURES_H

#include <Shape_characteristics/head_features/Head_feature.h>
#include <Shape_characteristics/head_features/Head_verdict.h>

#include <CGAL/Aff_transformation_3.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  holds what `detect_head_features()` found on a head: its feature points and regions.

      const auto head = detect_head_features(mesh);
      if(head.is_head && head[Head_feature::M1].is_found)
        mark(head[Head_feature::M1].position);

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam GeomTraits a \cgal kernel
*/
template <typename FaceGraph, typename GeomTraits>
struct Head_features
{
  /// a vertex of the mesh
  using Vertex_descriptor = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  /// a point of the mesh
  using Point_3 = typename GeomTraits::Point_3;

  /// a feature point
  struct Feature_point
  {
    bool is_found = false; ///< whether the feature is there. If it isn't, the rest says nothing.
    Point_3 position =
        Point_3(0, 0, 0); ///< on the surface, in the mesh's own coordinates; in general between vertices
    Vertex_descriptor vertex =
        boost::graph_traits<FaceGraph>::null_vertex(); ///< the vertex nearest to `position`
    double confidence = 0.;                            ///< how sure, in [0, 1]
  };

  /// a region of the surface
  struct Feature_region
  {
    bool is_found = false;                   ///< whether the region is there
    std::vector<Vertex_descriptor> vertices; ///< its vertices, in the order of `vertices(mesh)`
    double confidence = 0.;                  ///< how sure, in [0, 1]
  };

  /// whether the mesh is a head. If it isn't, nothing is found; nor is it on one whose shape has the pose of a head and no face.
  bool is_head = false;
  /// the same in more detail: what `estimate_head_pose()` says, or what the search for features adds to it
  Head_verdict verdict = Head_verdict::NOT_A_HEAD;
  /// why the mesh was not taken for a head, or why a head has no features
  Head_obstacle obstacle = Head_obstacle::FEW_SAMPLES;
  /// from the mesh to the frame in which the features were found: nose towards +z, top towards +y, in the unit of `Head_pose`
  CGAL::Aff_transformation_3<GeomTraits> transformation =
      CGAL::Aff_transformation_3<GeomTraits>(CGAL::IDENTITY);
  /// the height of the head, from its top to the lower end of the chin, in the unit of the mesh, by the proportions of heads from
  /// what was found; 0 if the mesh is no head, or has no face
  double head_height = 0.;
  /// the feature points, by `Head_feature`
  std::array<Feature_point, number_of_head_features> points;
  /// the regions, by `Head_region`
  std::array<Feature_region, number_of_head_regions> regions;

  /// the point of a feature
  const Feature_point& operator[](Head_feature feature) const
  {
    return points[static_cast<std::size_t>(feature)];
  }
  /// the same, to be changed
  Feature_point& operator[](Head_feature feature) { return points[static_cast<std::size_t>(feature)]; }

  /// a region
  const Feature_region& operator[](Head_region region) const
  {
    return regions[static_cast<std::size_t>(region)];
  }
  /// the same, to be changed
  Feature_region& operator[](Head_region region) { return regions[static_cast<std::size_t>(region)]; }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_FEATURES_H
