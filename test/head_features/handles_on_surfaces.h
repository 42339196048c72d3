#ifndef SHAPE_CHARACTERISTICS_TEST_HEAD_FEATURES_HANDLES_ON_SURFACES_H
#define SHAPE_CHARACTERISTICS_TEST_HEAD_FEATURES_HANDLES_ON_SURFACES_H

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "analytic_surfaces.h"
#include "build_mesh.h"
#include "raise_to.h"

#include <Shape_characteristics/head_features/Surface_handle.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// Surfaces to deform, and what is asked of them, for all tests of deformation.
namespace handles_on_surfaces {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Handle = SC::Surface_handle<Mesh>;
using Points = std::vector<Point_3>;

inline Points points_of(const Mesh& mesh)
{
  Points points;
  for(const Vertex v : mesh.vertices())
    points.push_back(mesh.point(v));
  return points;
}

template <typename Graph>
typename boost::graph_traits<Graph>::vertex_descriptor
vertex_at(const Graph& mesh, double x, double y, double z)
{
  typename boost::graph_traits<Graph>::vertex_descriptor best = *vertices(mesh).begin();
  double least = std::numeric_limits<double>::infinity();
  const auto vpm = get(CGAL::vertex_point, mesh);
  for(const auto v : vertices(mesh))
  {
    const auto p = get(vpm, v);
    const double d = std::hypot(p.x() - x, p.y() - y, p.z() - z);
    if(d < least)
    {
      least = d;
      best = v;
    }
  }
  return best;
}

inline double gaussian(double distance, double radius)
{
  return std::exp(-distance * distance / (2. * radius * radius));
}

inline double length(const Vector_3& v)
{
  return std::sqrt(v.squared_length());
}

inline double largest_difference(const Points& a, const Points& b)
{
  double largest = a.size() == b.size() ? 0. : std::numeric_limits<double>::infinity();
  for(std::size_t i = 0; i < (std::min)(a.size(), b.size()); ++i)
    test_support::raise_to(largest, length(a[i] - b[i]));
  return largest;
}

/// the square [-1, 1]^2 in the plane z = 0 with a slit along x = 0 from y = -1 to its middle, as between two lips
inline Mesh plane_with_slit(std::size_t n = 24)
{
  test_support::Analytic_surface s = test_support::plane(1., n);
  std::vector<std::size_t> twin(s.points.size());
  const std::size_t before = s.points.size();
  for(std::size_t i = 0; i < before; ++i)
  {
    twin[i] = i;
    if(std::abs(s.points[i][0]) < 1e-9 && s.points[i][1] < -1e-9)
    {
      twin[i] = s.points.size();
      s.points.push_back(s.points[i]);
    }
  }
  for(auto& t : s.triangles)
    if(s.points[t[0]][0] + s.points[t[1]][0] + s.points[t[2]][0] > 0.)
      for(std::size_t k = 0; k < 3; ++k)
        t[k] = twin[t[k]];
  return test_support::build_mesh<Mesh>(s);
}

} // namespace handles_on_surfaces

#endif // SHAPE_CHARACTERISTICS_TEST_HEAD_FEATURES_HANDLES_ON_SURFACES_H
