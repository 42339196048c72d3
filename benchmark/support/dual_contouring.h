#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_DUAL_CONTOURING_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_DUAL_CONTOURING_H

#include "Triangle_arrays.h"
#include "marching_cubes.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace benchmark_support {

namespace internal {

/// For each case of marching cubes and each of the 12 edges, which loop of the case crosses the edge; -1 if none does.
inline std::array<int, 12> loops_of_edges(unsigned int inside)
{
  std::array<int, 12> loop;
  loop.fill(-1);
  int count = 0;
  for(const std::array<int, 3>& t : Marching_cubes_cases::instance().triangles(inside))
  {
    int found = -1;
    for(int e : t)
      found = std::max(found, loop[e]);
    if(found < 0)
      found = count++;
    for(int e : t)
      loop[e] = found;
  }
  return loop;
}

/// The place in the box [lower, upper] from which the planes through `points` with `normals` are least far (in the sense of
/// squares); where they leave a direction open, as near to the middle of the points as possible.
inline Vector nearest_to_planes(const std::vector<Vector>& points,
                                const std::vector<Vector>& normals,
                                const Vector& lower,
                                const Vector& upper)
{
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for(const Vector& p : points)
    middle += Eigen::Vector3d(p.x, p.y, p.z) / double(points.size());
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Eigen::Vector3d n(normals[i].x, normals[i].y, normals[i].z),
        p(points[i].x, points[i].y, points[i].z);
    a += n * n.transpose();
    b += n * n.dot(p - middle);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  Eigen::Vector3d at = middle;
  for(int i = 0; i < 3; ++i)
    if(solver.eigenvalues()[i] > .1 * solver.eigenvalues()[2]) // the rest is noise of nearly parallel planes
      at += solver.eigenvectors().col(i) * (solver.eigenvectors().col(i).dot(b) / solver.eigenvalues()[i]);
  Vector result;
  for(int i = 0; i < 3; ++i)
    result[i] = std::clamp(at[i], lower[i], upper[i]);
  return result;
}

} // namespace internal

/// Dual contouring of the level set 0 of `function` in the box [lower, upper] on a grid of `samples` points per axis: a vertex in
/// each cell that the surface crosses, where the planes through its crossings with the edges (exact ones, with the normals of
/// `gradient`) come together, and two triangles for each edge of the grid that is crossed. A cell that the surface crosses
/// several times has as many vertices. Negative is inside, triangles are counterclockwise seen from outside.
///
/// Vertices are near the level set, not on it.
template <typename Function, typename Gradient>
Triangle_arrays dual_contouring(const Function& function,
                                const Gradient& gradient,
                                const Vector& lower,
                                const Vector& upper,
                                std::size_t samples)
{
  using internal::Marching_cubes_cases;
  using Index = std::array<std::size_t, 3>;
  if(samples < 2)
    throw std::invalid_argument("dual_contouring: two samples per axis at least");
  const auto coordinate = [&](int axis, std::size_t i)
  { return lower[axis] + (upper[axis] - lower[axis]) * (double(i) / double(samples - 1)); };
  const auto position = [&](const Index& i) {
    return Vector{coordinate(0, i[0]), coordinate(1, i[1]), coordinate(2, i[2])};
  };
  const auto index = [samples](const Index& i) { return (i[2] * samples + i[1]) * samples + i[0]; };

  std::vector<char> inside(samples * samples * samples);
  for(std::size_t z = 0; z < samples; ++z)
    for(std::size_t y = 0; y < samples; ++y)
      for(std::size_t x = 0; x < samples; ++x)
        inside[index({x, y, z})] = function(position({x, y, z})) < 0.;

  const auto corner = [](const Index& cell, int c) {
    return Index{cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2 & 1)};
  };
  const auto crossing = [&](const Index& i, int axis)
  {
    Index j = i;
    ++j[axis];
    Vector p = position(i);
    double low = p[axis], high = coordinate(axis, j[axis]);
    for(int step = 0; step < 60; ++step)
    {
      p[axis] = .5 * (low + high);
      ((function(p) < 0.) == bool(inside[index(i)]) ? low : high) = p[axis];
    }
    return p;
  };

  Triangle_arrays mesh;
  std::unordered_map<std::uint64_t, std::size_t> vertex_of; // 12 * cell + edge of the cell
  for(std::size_t z = 0; z + 1 < samples; ++z)
    for(std::size_t y = 0; y + 1 < samples; ++y)
      for(std::size_t x = 0; x + 1 < samples; ++x)
      {
        const Index cell = {x, y, z};
        unsigned int inside_corners = 0;
        for(int c = 0; c < 8; ++c)
          inside_corners |= (inside[index(corner(cell, c))] ? 1u : 0u) << c;
        const std::array<int, 12> loops = internal::loops_of_edges(inside_corners);
        const int count = 1 + *std::max_element(loops.begin(), loops.end());
        for(int loop = 0; loop < count; ++loop)
        {
          std::vector<Vector> points, normals;
          for(int e = 0; e < 12; ++e)
            if(loops[e] == loop)
            {
              points.push_back(crossing(corner(cell, Marching_cubes_cases::first_corner(e)), e / 4));
              normals.push_back(normalized(gradient(points.back())));
              vertex_of[12 * std::uint64_t(index(cell)) + std::uint64_t(e)] = mesh.points.size();
            }
          mesh.points.push_back(
              internal::nearest_to_planes(points, normals, position(cell), position(corner(cell, 7))));
        }
      }

  // the four cells around an edge along `axis`, counterclockwise seen from its end
  for(std::size_t z = 0; z < samples; ++z)
    for(std::size_t y = 0; y < samples; ++y)
      for(std::size_t x = 0; x < samples; ++x)
        for(int axis = 0; axis < 3; ++axis)
        {
          const Index i = {x, y, z};
          const int u = (axis + 1) % 3, v = (axis + 2) % 3;
          if(i[axis] + 1 == samples || i[u] == 0 || i[v] == 0 || i[u] + 1 == samples || i[v] + 1 == samples)
            continue;
          Index j = i;
          ++j[axis];
          if(inside[index(i)] == inside[index(j)])
            continue;
          std::array<std::size_t, 4> quad;
          for(int k = 0; k < 4; ++k)
          {
            const bool before_in_u = k == 1 || k == 2, before_in_v = k >= 2;
            Index cell = i;
            cell[u] -= before_in_u ? 1 : 0;
            cell[v] -= before_in_v ? 1 : 0;
            const int first = (before_in_u ? 1 << u : 0) | (before_in_v ? 1 << v : 0);
            int edge = 0;
            while(edge / 4 != axis || Marching_cubes_cases::first_corner(edge) != first)
              ++edge;
            quad[k] = vertex_of.at(12 * std::uint64_t(index(cell)) + std::uint64_t(edge));
          }
          if(!inside[index(i)])
            std::reverse(quad.begin(), quad.end());
          // the shorter diagonal
          if(length(mesh.points[quad[0]] - mesh.points[quad[2]]) <=
             length(mesh.points[quad[1]] - mesh.points[quad[3]]))
          {
            mesh.triangles.push_back({quad[0], quad[1], quad[2]});
            mesh.triangles.push_back({quad[0], quad[2], quad[3]});
          }
          else
          {
            mesh.triangles.push_back({quad[1], quad[2], quad[3]});
            mesh.triangles.push_back({quad[1], quad[3], quad[0]});
          }
        }

  // what only edges in the faces of the box have crossed is on no triangle
  std::vector<std::size_t> number(mesh.points.size(), mesh.points.size());
  std::vector<Vector> used;
  for(Triangle& t : mesh.triangles)
    for(std::size_t& p : t)
    {
      if(number[p] == mesh.points.size())
      {
        number[p] = used.size();
        used.push_back(mesh.points[p]);
      }
      p = number[p];
    }
  mesh.points = std::move(used);
  return mesh;
}

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_DUAL_CONTOURING_H
