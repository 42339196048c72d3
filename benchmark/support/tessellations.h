#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_TESSELLATIONS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_TESSELLATIONS_H

#include "Random.h"
#include "Triangle_arrays.h"
#include "delaunay_triangles.h"
#include "dual_contouring.h"
#include "marching_cubes.h"
#include "test_functions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace benchmark_support {

/// How the convex hull of random points is filled.
enum class Hull
{
  WHOLE, ///< by a Delaunay triangulation of the points alone
  /// As an incremental Delaunay triangulation does that starts inside a large triangle and drops its corners in the
  /// end: without the flattest triangles along the border. With it, though its size is a guess, the figures come out
  /// that the thesis prints; those of average normals hang on these triangles.
  OF_INCREMENTAL_TRIANGULATION
};

/// `count` points of the graph, uniformly distributed over its square (Delaunay triangulation in the xy plane).
/// No point is put on the border of the square.
inline Triangle_arrays random_tessellation(const Explicit_function& f,
                                           std::size_t count,
                                           std::uint64_t seed,
                                           Hull hull = Hull::WHOLE)
{
  Random random(seed);
  Triangle_arrays mesh;
  mesh.points.reserve(count + 3);
  for(std::size_t i = 0; i < count; ++i)
  {
    const double x = random.uniform(-f.half, f.half), y = random.uniform(-f.half, f.half);
    mesh.points.push_back(f.point(x, y));
  }
  if(hull == Hull::WHOLE)
  {
    mesh.triangles = delaunay_triangles(mesh.points);
    return mesh;
  }
  const double far = 10. * f.half; // five times the side of the square
  for(const Vector& corner : {Vector{-far, -far, 0.}, Vector{far, -far, 0.}, Vector{0., far, 0.}})
    mesh.points.push_back(corner);
  for(const Triangle& t : delaunay_triangles(mesh.points))
    if(*std::max_element(t.begin(), t.end()) < count)
      mesh.triangles.push_back(t);
  mesh.points.resize(count);
  return mesh;
}

/// `columns` by `rows` points `point(x, y)` over the square [-half, half]^2, all diagonals in the same direction.
template <typename Point>
Triangle_arrays grid(double half, std::size_t columns, std::size_t rows, const Point& point)
{
  Triangle_arrays mesh;
  const double width = 2. * half / double(columns - 1), height = 2. * half / double(rows - 1);
  for(std::size_t i = 0; i < rows; ++i)
    for(std::size_t j = 0; j < columns; ++j)
      mesh.points.push_back(point(-half + width * double(j), -half + height * double(i)));
  for(std::size_t i = 0; i + 1 < rows; ++i)
    for(std::size_t j = 0; j + 1 < columns; ++j)
    {
      const std::size_t a = i * columns + j, b = a + columns;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  return mesh;
}

/// `per_axis`^2 points of the graph on a uniform grid over its square.
inline Triangle_arrays grid_tessellation(const Explicit_function& f, std::size_t per_axis)
{
  return grid(f.half, per_axis, per_axis, [&](double x, double y) { return f.point(x, y); });
}

/// Marching cubes in the function's box on a grid of `samples`^3 points.
inline Triangle_arrays
marching_cubes_tessellation(const Implicit_function& f, std::size_t samples, Edge_crossing crossing)
{
  return marching_cubes(f.value, {-f.half, -f.half, -f.half}, {f.half, f.half, f.half}, samples, crossing);
}

/// Dual contouring in the function's box on a grid of `samples`^3 points.
inline Triangle_arrays dual_contouring_tessellation(const Implicit_function& f, std::size_t samples)
{
  return dual_contouring(f.value, f.gradient, {-f.half, -f.half, -f.half}, {f.half, f.half, f.half}, samples);
}

/// Mean length of the edges, each counted once.
inline double mean_edge_length(const Triangle_arrays& mesh)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(const Triangle& t : mesh.triangles)
    for(int i = 0; i < 3; ++i)
      edges.push_back(std::minmax(t[i], t[(i + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  double sum = 0.;
  for(const auto& e : edges)
    sum += length(mesh.points[e.first] - mesh.points[e.second]);
  return edges.empty() ? 0. : sum / double(edges.size());
}

enum class Noise
{
  GAUSSIAN,
  UNIFORM
};

/// Moves every coordinate by noise of standard deviation `sigma` mean edge lengths.
inline void add_noise(Triangle_arrays& mesh, Noise noise, double sigma, std::uint64_t seed)
{
  Random random(seed);
  const double deviation = sigma * mean_edge_length(mesh);
  const double half = std::sqrt(3.) * deviation; // a uniform distribution's half width
  for(Vector& p : mesh.points)
    for(std::size_t i = 0; i < 3; ++i)
      p[i] += noise == Noise::GAUSSIAN ? deviation * random.gaussian() : random.uniform(-half, half);
}

/// For each vertex, the number of edges to the nearest vertex of the border; the number of vertices if there is
/// no border to be reached.
inline std::vector<std::size_t> rings_from_border(const Triangle_arrays& mesh)
{
  const std::size_t n = mesh.points.size();
  std::vector<std::pair<std::size_t, std::size_t>> halfedges;
  for(const Triangle& t : mesh.triangles)
    for(int i = 0; i < 3; ++i)
      halfedges.emplace_back(t[i], t[(i + 1) % 3]);
  std::sort(halfedges.begin(), halfedges.end());

  std::vector<std::vector<std::size_t>> neighbors(n);
  std::vector<std::size_t> rings(n, n), front;
  for(const auto& [a, b] : halfedges)
  {
    neighbors[a].push_back(b);
    neighbors[b].push_back(a);
    if(!std::binary_search(halfedges.begin(), halfedges.end(), std::make_pair(b, a)))
      for(std::size_t v : {a, b})
        if(rings[v] != 0)
        {
          rings[v] = 0;
          front.push_back(v);
        }
  }
  for(std::size_t i = 0; i < front.size(); ++i) // breadth first
    for(std::size_t v : neighbors[front[i]])
      if(rings[v] == n)
      {
        rings[v] = rings[front[i]] + 1;
        front.push_back(v);
      }
  return rings;
}

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_TESSELLATIONS_H
