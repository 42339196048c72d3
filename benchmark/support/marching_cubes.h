#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_MARCHING_CUBES_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_MARCHING_CUBES_H

#include "Triangle_arrays.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace benchmark_support {

/// Where marching cubes puts a vertex on an edge of the grid.
enum class Edge_crossing
{
  LINEAR, ///< where the linear interpolant of the values at the ends is 0 (the thesis's "original" variant)
  EXACT   ///< where the function is, by bisection (the thesis's "exact" variant)
};

namespace internal {

/// The triangles of the 256 cases of marching cubes, derived from one rule about the faces of a cube.
///
/// Corner c lies at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge 4 a + k runs along axis a from the k-th of the corners whose
/// coordinate a is 0.
///
/// On each face, every run of inside corners is cut off by a segment of its own; if two diagonally opposite
/// corners are inside, so are the two runs of one corner each. The rule looks at the corners of the face alone, so
/// the cubes on both sides agree and the surface has no gap. Walking around a face counterclockwise as seen
/// from outside of the cube, a segment goes from the edge where the run is entered to where it is left; each crossed
/// edge is entered on one of its faces and left on the other, so segments join into directed loops.
///
/// Loops are divided into triangles by diagonals between edges that share no face: a diagonal within a face
/// might be chosen by the neighboring cube, too, and would then have four triangles.
class Marching_cubes_cases
{
public:
  static const Marching_cubes_cases& instance()
  {
    static const Marching_cubes_cases cases;
    return cases;
  }

  /// triples of edges for the case whose bit c says that corner c is inside
  const std::vector<std::array<int, 3>>& triangles(unsigned int inside) const { return m_triangles[inside]; }

  /// first corner of an edge; the second one is reached along axis `edge / 4`
  static int first_corner(int edge)
  {
    const int axis = edge / 4, k = edge % 4, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    return (k & 1 ? u : 0) | (k & 2 ? v : 0);
  }

private:
  // edge between two corners that differ in one coordinate
  static int edge(int c0, int c1)
  {
    const int bit = c0 ^ c1, axis = bit == 1 ? 0 : (bit == 2 ? 1 : 2);
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    return 4 * axis + (c0 & u ? 1 : 0) + (c0 & v ? 2 : 0);
  }

  static bool share_face(int e0, int e1)
  {
    const int a0 = first_corner(e0), b0 = a0 | 1 << e0 / 4, a1 = first_corner(e1), b1 = a1 | 1 << e1 / 4;
    // a coordinate that is the same at all four ends
    return (a0 & b0 & a1 & b1) != 0 || ((a0 | b0 | a1 | b1) & 7) != 7;
  }

  // divides the part [i, j] of the loop, whose chord (i, j) may be used; false if that's impossible
  static bool
  divide(const std::vector<int>& loop, std::size_t i, std::size_t j, std::vector<std::array<int, 3>>& out)
  {
    if(j - i < 2)
      return true;
    const auto allowed = [&](std::size_t a, std::size_t b)
    { return b - a == 1 || !share_face(loop[a], loop[b]); };
    for(std::size_t k = i + 1; k < j; ++k)
      if(allowed(i, k) && allowed(k, j))
      {
        const std::size_t size = out.size();
        out.push_back({loop[i], loop[k], loop[j]});
        if(divide(loop, i, k, out) && divide(loop, k, j, out))
          return true;
        out.resize(size);
      }
    return false;
  }

  Marching_cubes_cases() : m_triangles(256)
  {
    for(unsigned int inside = 0; inside < 256; ++inside)
    {
      std::array<int, 12> next;
      next.fill(-1);
      for(int axis = 0; axis < 3; ++axis)
        for(int side = 0; side < 2; ++side)
        {
          const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
          // counterclockwise from outside: u, then v, on the upper side
          std::array<int, 4> c = {base, base | u, base | u | v, base | v};
          if(side == 0)
            std::swap(c[1], c[3]);
          const auto is_inside = [&](int i) { return (inside >> c[i % 4] & 1) != 0; };
          for(int i = 0; i < 4; ++i)
            if(!is_inside(i) && is_inside(i + 1))
            {
              int j = i + 1;
              while(is_inside(j + 1))
                ++j;
              next[edge(c[i], c[(i + 1) % 4])] = edge(c[j % 4], c[(j + 1) % 4]);
            }
        }
      std::array<bool, 12> done{};
      for(int e = 0; e < 12; ++e)
      {
        if(next[e] < 0 || done[e])
          continue;
        std::vector<int> loop;
        for(int at = e; !done[at]; at = next[at])
        {
          done[at] = true;
          loop.push_back(at);
        }
        if(!divide(loop, 0, loop.size() - 1, m_triangles[inside]))
          throw std::logic_error("Marching_cubes_cases: a loop cannot be divided");
      }
    }
  }

  std::vector<std::vector<std::array<int, 3>>> m_triangles;
};

} // namespace internal

/// Triangulates the level set 0 of `function` (called with a `Vector`) in the box [lower, upper] on a grid of
/// `samples` points per axis. Negative is inside, triangles are counterclockwise seen from outside.
///
/// Each edge of the grid has one vertex at most, so the mesh is an orientable manifold whatever the values; it
/// has a border where the level set leaves the box. Vertices are not merged: where the level set runs through
/// a point of the grid, or close to it, several of them lie at the same place or nearly so.
///
/// With `Edge_crossing::EXACT` bisection ends where |function| < `tolerance`, or the interval has no inner number.
template <typename Function>
Triangle_arrays marching_cubes(const Function& function,
                               const Vector& lower,
                               const Vector& upper,
                               std::size_t samples,
                               Edge_crossing crossing,
                               double tolerance = 1e-7)
{
  if(samples < 2)
    throw std::invalid_argument("marching_cubes: two samples per axis at least");
  const internal::Marching_cubes_cases& cases = internal::Marching_cubes_cases::instance();
  const auto coordinate = [&](int axis, std::size_t i)
  { return lower[axis] + (upper[axis] - lower[axis]) * (double(i) / double(samples - 1)); };
  const auto position = [&](const std::array<std::size_t, 3>& i) {
    return Vector{coordinate(0, i[0]), coordinate(1, i[1]), coordinate(2, i[2])};
  };
  const auto index = [samples](const std::array<std::size_t, 3>& i)
  { return (i[2] * samples + i[1]) * samples + i[0]; };

  std::vector<double> values(samples * samples * samples);
  for(std::size_t z = 0; z < samples; ++z)
    for(std::size_t y = 0; y < samples; ++y)
      for(std::size_t x = 0; x < samples; ++x)
        values[index({x, y, z})] = function(position({x, y, z}));

  Triangle_arrays mesh;
  std::unordered_map<std::uint64_t, std::size_t> vertex_of_edge; // first grid point * 3 + axis

  const auto vertex = [&](const std::array<std::size_t, 3>& i, int axis)
  {
    const auto inserted = vertex_of_edge.insert({std::uint64_t(index(i)) * 3 + axis, mesh.points.size()});
    if(inserted.second)
    {
      std::array<std::size_t, 3> j = i;
      ++j[axis];
      const double a = values[index(i)], b = values[index(j)];
      Vector p = position(i);
      double low = p[axis], high = coordinate(axis, j[axis]);
      p[axis] = low + (high - low) * (a / (a - b));
      if(crossing == Edge_crossing::EXACT)
        while(true)
        {
          p[axis] = .5 * (low + high);
          const double value = function(p);
          if(std::abs(value) < tolerance || p[axis] == low || p[axis] == high)
            break;
          ((value < 0.) == (a < 0.) ? low : high) = p[axis];
        }
      mesh.points.push_back(p);
    }
    return inserted.first->second;
  };

  for(std::size_t z = 0; z + 1 < samples; ++z)
    for(std::size_t y = 0; y + 1 < samples; ++y)
      for(std::size_t x = 0; x + 1 < samples; ++x)
      {
        const auto corner = [&](int c) {
          return std::array<std::size_t, 3>{x + (c & 1), y + (c >> 1 & 1), z + (c >> 2 & 1)};
        };
        unsigned int inside = 0;
        for(int c = 0; c < 8; ++c)
          inside |= (values[index(corner(c))] < 0. ? 1u : 0u) << c;
        for(const std::array<int, 3>& t : cases.triangles(inside))
        {
          Triangle triangle;
          for(int i = 0; i < 3; ++i)
            triangle[i] = vertex(corner(internal::Marching_cubes_cases::first_corner(t[i])), t[i] / 4);
          mesh.triangles.push_back(triangle);
        }
      }
  return mesh;
}

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_MARCHING_CUBES_H
