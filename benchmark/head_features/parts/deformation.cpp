#include "deformation.h"

#include <Shape_characteristics/head_features/deform_by_handles.h>
#include <Shape_characteristics/head_features/head_expression_handles.h>
#include <Shape_characteristics/internal/CGAL_compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace head_features {

Deformation_difference
deformation_difference(const Head& head, const Features& found, SC::Head_expression expression)
{
  Deformation_difference result{head.name, head.variant, expression};
  Mesh by_truth = head.mesh, by_found = head.mesh;
  try
  {
    SC::deform_by_handles(by_truth, SC::head_expression_handles(expression, head.truth));
    SC::deform_by_handles(by_found, SC::head_expression_handles(expression, found));
  }
  catch(const std::invalid_argument&) // a point is missing
  {
    return result;
  }
  result.is_deformed = true;

  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<SC::internal::AABB_traits_3<Kernel, Primitive> >;
  Tree tree(faces(by_truth).begin(), faces(by_truth).end(), by_truth);
  const double unit = 100. / head.truth.head_height;
  double sum = 0.;
  std::size_t moved = 0;
  for(const Mesh::Vertex_index v : head.mesh.vertices())
  {
    const Point_3 &p = head.mesh.point(v), &q = by_truth.point(v), &r = by_found.point(v);
    const double motion = unit * std::sqrt(CGAL::squared_distance(p, q)),
                 difference = unit * std::sqrt(CGAL::squared_distance(q, r));
    result.largest_motion = (std::max)(result.largest_motion, motion);
    result.largest_difference = (std::max)(result.largest_difference, difference);
    if(motion < .01 && difference < .01)
      continue;
    const double distance = difference > 0. ? unit * std::sqrt(tree.squared_distance(r)) : 0.;
    result.largest_distance = (std::max)(result.largest_distance, distance);
    sum += distance;
    ++moved;
  }
  result.mean_distance = moved > 0 ? sum / double(moved) : 0.;
  return result;
}

} // namespace head_features
