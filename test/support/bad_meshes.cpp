#include "bad_meshes.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_support {

Polygon_arrays polygons_of(const std::string& name, const Analytic_surface& s)
{
  Polygon_arrays m{name, s.points, {}};
  for(const Triangle& t : s.triangles)
    m.faces.push_back({t[0], t[1], t[2]});
  return m;
}

void append(Polygon_arrays& m, const Polygon_arrays& part, const Vector& offset)
{
  const std::size_t first = m.points.size();
  for(const Vector& p : part.points)
    m.points.push_back(p + offset);
  for(std::vector<std::size_t> face : part.faces)
  {
    for(std::size_t& i : face)
      i += first;
    m.faces.push_back(face);
  }
}

Polygon_arrays empty_mesh()
{
  return {"empty mesh", {}, {}};
}

Polygon_arrays single_vertex()
{
  return {"single vertex", {{1, 2, 3}}, {}};
}

Polygon_arrays single_triangle()
{
  return {"single triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
}

Polygon_arrays open_fan()
{
  return {"open fan",
          {{0, 0, .3}, {1, 0, 0}, {.5, 1, 0}, {-.5, 1, .1}, {-1, 0, 0}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}};
}

Polygon_arrays fan_of_three()
{
  return {"fan of three",
          {{0, 0, .4}, {1, 0, 0}, {-.5, .9, 0}, {-.5, -.9, 0}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}};
}

Polygon_arrays tetrahedron()
{
  return {"tetrahedron",
          {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

Polygon_arrays cube_of_quads()
{
  Polygon_arrays m{"cube of quads", {}, {}};
  for(int i = 0; i < 8; ++i)
    m.points.push_back({i & 1 ? 1. : -1., i & 2 ? 1. : -1., i & 4 ? 1. : -1.});
  m.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return m;
}

Polygon_arrays cube()
{
  Polygon_arrays m = cube_of_quads();
  m.name = "cube";
  std::vector<std::vector<std::size_t>> triangles;
  for(const auto& q : m.faces)
  {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
  m.faces = triangles;
  return m;
}

Polygon_arrays prism_of_polygons()
{
  Polygon_arrays m{"prism of polygons", {}, {}};
  for(int z : {-1, 1})
    for(int i = 0; i < 6; ++i)
      m.points.push_back({std::cos(i * CGAL_PI / 3.), std::sin(i * CGAL_PI / 3.), double(z)});
  m.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for(std::size_t i = 0; i < 6; ++i)
    m.faces.push_back({i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i});
  return m;
}

Polygon_arrays isolated_vertices(std::size_t count)
{
  Polygon_arrays m = polygons_of("isolated vertices", sphere(1., 2));
  for(std::size_t i = 0; i < count; ++i)
    m.points.push_back({.1 * double(i), 0., 1.});
  return m;
}

Polygon_arrays triangle_soup()
{
  const Analytic_surface s = sphere(1., 2);
  Polygon_arrays m{"triangle soup", {}, {}};
  for(const Triangle& t : s.triangles)
  {
    const std::size_t first = m.points.size();
    for(std::size_t i : t)
      m.points.push_back(s.points[i]);
    m.faces.push_back({first, first + 1, first + 2});
  }
  return m;
}

Polygon_arrays zero_area_triangles(std::size_t* vertex)
{
  Polygon_arrays m = polygons_of("zero-area triangles", waves(.1, 4., 1., 16, .15));
  const std::size_t middle = 8 * 17 + 8;
  m.points[middle] = m.points[middle + 1];
  if(vertex != nullptr)
    *vertex = middle;
  return m;
}

Polygon_arrays needle_triangles(std::size_t* vertex)
{
  Polygon_arrays m = polygons_of("needle triangles", waves(.1, 4., 1., 16, .15));
  const std::size_t middle = 8 * 17 + 8;
  m.points[middle] = m.points[middle + 1] + 1e-8 * (m.points[middle] - m.points[middle + 1]);
  if(vertex != nullptr)
    *vertex = middle;
  return m;
}

Polygon_arrays cap_triangle(std::size_t* vertex)
{
  Polygon_arrays m = polygons_of("cap triangle", saddle(1., 8));
  const std::vector<std::size_t> t = m.faces[2 * (4 * 8 + 4)];
  const Vector edge_middle = .5 * (m.points[t[0]] + m.points[t[1]]);
  const std::size_t added = m.points.size();
  m.points.push_back(edge_middle + 1e-8 * (m.points[t[2]] - edge_middle));
  m.faces[2 * (4 * 8 + 4)] = {t[0], t[1], added};
  m.faces.push_back({t[1], t[2], added});
  m.faces.push_back({t[2], t[0], added});
  if(vertex != nullptr)
    *vertex = added;
  return m;
}

Polygon_arrays border_ear()
{
  Polygon_arrays m = polygons_of("border ear", saddle(1., 8));
  m.points.push_back({-.875, -1.2, -.4});
  // the grid's first row (x = -1 ... along x at y = -1) has vertices 0, 9, 18, ...
  m.faces.push_back({9, 0, m.points.size() - 1});
  return m;
}

Polygon_arrays thin_strip(std::size_t length)
{
  Polygon_arrays m{"thin strip", {}, {}};
  for(std::size_t i = 0; i <= length; ++i)
    for(double y : {-.05, .05})
    {
      const double x = .1 * double(i);
      m.points.push_back({x, y, .2 * std::sin(x)});
    }
  for(std::size_t i = 0; i < length; ++i)
  {
    m.faces.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    m.faces.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  return m;
}

Polygon_arrays mixed_valences()
{
  const std::size_t n = 40;
  Polygon_arrays m{"mixed valences", {{0, 0, .5}, {0, 0, -.5}}, {}};
  for(std::size_t i = 0; i < n; ++i)
    m.points.push_back(
        {std::cos(2. * CGAL_PI * double(i) / double(n)), std::sin(2. * CGAL_PI * double(i) / double(n)), 0.});
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t a = 2 + i, b = 2 + (i + 1) % n, c = m.points.size();
    const Vector middle = (1. / 3.) * (m.points[0] + m.points[a] + m.points[b]);
    m.points.push_back(middle + Vector{0., 0., .02});
    m.faces.push_back({0, a, c});
    m.faces.push_back({a, b, c});
    m.faces.push_back({b, 0, c});
    m.faces.push_back({1, b, a});
  }
  return m;
}

Polygon_arrays several_components()
{
  Polygon_arrays m = polygons_of("several components", sphere(1., 2));
  append(m, polygons_of("", torus(1., .4, 24, 12)), {5., 0., 0.});
  append(m, single_triangle(), {10., 0., 0.});
  return m;
}

Polygon_arrays moebius_strip(std::size_t length, std::size_t width)
{
  Polygon_arrays m{"Moebius strip", {}, {}};
  for(std::size_t i = 0; i <= length; ++i)
    for(std::size_t j = 0; j <= width; ++j)
    {
      const double u = 2. * CGAL_PI * double(i) / double(length),
                   v = .4 * (2. * double(j) / double(width) - 1.);
      const double r = 1. + v * std::cos(.5 * u);
      m.points.push_back({r * std::cos(u), r * std::sin(u), v * std::sin(.5 * u)});
    }
  for(std::size_t j = 0; j <= width; ++j) // to the last bit
    m.points[length * (width + 1) + j] = m.points[width - j];
  for(std::size_t i = 0; i < length; ++i)
    for(std::size_t j = 0; j < width; ++j)
    {
      const std::size_t a = i * (width + 1) + j, b = a + width + 1;
      m.faces.push_back({a, b, b + 1});
      m.faces.push_back({a, b + 1, a + 1});
    }
  return m;
}

Polygon_arrays bow_tie()
{
  return {"bow tie",
          {{0, 0, 0}, {1, -.5, .1}, {1.2, 0, .1}, {1, .5, .1}, {-1, .5, -.1}, {-1.2, 0, -.1}, {-1, -.5, -.1}},
          {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 6}}};
}

Polygon_arrays two_sheets(double distance, std::size_t n)
{
  Polygon_arrays m = polygons_of("two sheets", plane(1., n, .1, 3));
  Polygon_arrays lower = polygons_of("", plane(1., n, .1, 4));
  for(auto& f : lower.faces)
    std::swap(f[1], f[2]);
  append(m, lower, {0., 0., -distance});
  return m;
}

Polygon_arrays schwarz_lantern(std::size_t around, std::size_t rings)
{
  Polygon_arrays m{"Schwarz lantern", {}, {}};
  for(std::size_t j = 0; j <= rings; ++j)
    for(std::size_t i = 0; i < around; ++i)
    {
      const double angle = 2. * CGAL_PI * (double(i) + (j % 2 == 1 ? .5 : 0.)) / double(around);
      m.points.push_back({std::cos(angle), std::sin(angle), 2. * double(j) / double(rings) - 1.});
    }
  for(std::size_t j = 0; j < rings; ++j)
    for(std::size_t i = 0; i < around; ++i)
    {
      const std::size_t a = j * around + i, b = j * around + (i + 1) % around, c = a + around, d = b + around;
      if(j % 2 == 0)
      {
        m.faces.push_back({a, b, c}); // c is half a step ahead of a
        m.faces.push_back({b, d, c});
      }
      else
      {
        m.faces.push_back({a, d, c}); // a is half a step ahead of c
        m.faces.push_back({a, b, d});
      }
    }
  return m;
}

std::vector<Polygon_arrays> all_bad_triangle_meshes()
{
  return {empty_mesh(),         single_vertex(), single_triangle(),   open_fan(),       fan_of_three(),
          tetrahedron(),        cube(),          isolated_vertices(), triangle_soup(),  zero_area_triangles(),
          needle_triangles(),   cap_triangle(),  border_ear(),        thin_strip(),     mixed_valences(),
          several_components(), moebius_strip(), two_sheets(),        schwarz_lantern()};
}

std::vector<Polygon_arrays> all_polygon_meshes()
{
  return {cube_of_quads(), prism_of_polygons()};
}

} // namespace test_support
