// In a file of its own: CGAL's exact predicates are compiled once, not with each program.
#include "delaunay_triangles.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace benchmark_support {

std::vector<Triangle> delaunay_triangles(const std::vector<Vector>& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Triangulation =
      CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base>>;

  std::vector<std::pair<Kernel::Point_2, std::size_t>> indexed;
  indexed.reserve(points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    indexed.emplace_back(Kernel::Point_2(points[i].x, points[i].y), i);
  const Triangulation triangulation(indexed.begin(), indexed.end());

  std::vector<Triangle> triangles;
  triangles.reserve(triangulation.number_of_faces());
  for(auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
  {
    Triangle t{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  // CGAL's order depends on its spatial sorting
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

} // namespace benchmark_support
