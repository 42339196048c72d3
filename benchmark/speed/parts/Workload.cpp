#include "Workload.h"

#include "build_face_graph.h"
#include "tessellations.h"
#include "test_functions.h"

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace speed {
namespace {

using benchmark_support::Explicit_function;
using benchmark_support::Triangle_arrays;
using benchmark_support::Vector;

// Renumbers the points of a graph along a Hilbert curve in the xy plane, and the triangles by their first vertex.
void sort_along_curve(Triangle_arrays& arrays)
{
  const std::size_t n = arrays.points.size();
  std::vector<Kernel::Point_2> projected;
  projected.reserve(n);
  for(const Vector& p : arrays.points)
    projected.emplace_back(p.x, p.y);
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  using Map = CGAL::Pointer_property_map<Kernel::Point_2>::type;
  CGAL::hilbert_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>(CGAL::make_property_map(projected)));

  std::vector<std::size_t> new_number(n);
  std::vector<Vector> points(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    new_number[order[i]] = i;
    points[i] = arrays.points[order[i]];
  }
  arrays.points = std::move(points);
  for(benchmark_support::Triangle& t : arrays.triangles)
  {
    for(std::size_t& v : t)
      v = new_number[v];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(arrays.triangles.begin(), arrays.triangles.end());
}

} // namespace

const char* to_string(Order order)
{
  return order == Order::CURVE ? "curve" : "random";
}

Workload::Workload(const std::string& surface, std::size_t points, std::uint64_t seed, Order order)
{
  Triangle_arrays arrays;
  if(surface.back() == 'e')
  {
    const Explicit_function& f = benchmark_support::explicit_function(surface);
    arrays = benchmark_support::random_tessellation(f, points, seed);
    if(order == Order::CURVE)
      sort_along_curve(arrays);
    exact.reserve(points);
    for(const Vector& p : arrays.points)
      exact.push_back(f.exact(p.x, p.y));
  }
  else
  {
    const auto& f = benchmark_support::implicit_function(surface);
    arrays =
        benchmark_support::marching_cubes_tessellation(f, points, benchmark_support::Edge_crossing::EXACT);
    for(const Vector& p : arrays.points)
      exact.push_back(f.exact(p));
  }
  mesh = benchmark_support::build_face_graph<Mesh>(arrays.points, arrays.triangles);
  vertices.assign(mesh.vertices().begin(), mesh.vertices().end());

  normals = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normals").first;
  for(const Vertex v : vertices)
  {
    const Vector& n = exact[v].normal;
    normals[v] = Kernel::Vector_3(n.x, n.y, n.z);
  }
  curvatures = mesh.add_property_map<Vertex, Curvatures>("v:curvatures").first;
  statuses = mesh.add_property_map<Vertex, SC::Estimation_status>("v:statuses").first;
}

void Workload::clear_results()
{
  for(const Vertex v : vertices)
  {
    curvatures[v].min_curvature = curvatures[v].max_curvature = std::numeric_limits<double>::quiet_NaN();
    statuses[v] = SC::Estimation_status::UNREFERENCED;
  }
}

benchmark_support::Error_statistics Workload::errors() const
{
  benchmark_support::Error_statistics errors;
  for(const Vertex v : vertices)
  {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    const bool estimated = SC::is_estimated(statuses[v]);
    errors.add(estimated ? curvatures[v].max_curvature - exact[v].k_max : nothing,
               estimated ? curvatures[v].min_curvature - exact[v].k_min : nothing);
  }
  return errors;
}

} // namespace speed
