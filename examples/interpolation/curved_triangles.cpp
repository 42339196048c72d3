// Curved patches over the triangles of an icosahedron: PN triangles, and PNG1 triangles, which join smoothly.
#include <Shape_characteristics/curvature/parametric_surface_curvatures.h>
#include <Shape_characteristics/interpolation/Pn_triangle.h>
#include <Shape_characteristics/interpolation/Png1_triangle.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Png1 = SC::Png1_triangle<Kernel>;

namespace {

Mesh mesh;

// The corners of the icosahedron lie on the unit sphere: their normals are themselves. Corner 0 is the target of `h`.
std::array<Point, 3> corners(Mesh::Halfedge_index h)
{
  return {mesh.point(target(h, mesh)), mesh.point(target(next(h, mesh), mesh)), mesh.point(source(h, mesh))};
}
std::array<Vector, 3> normals(Mesh::Halfedge_index h)
{
  const auto p = corners(h);
  return {p[0] - CGAL::ORIGIN, p[1] - CGAL::ORIGIN, p[2] - CGAL::ORIGIN};
}

Png1 smooth_patch(Mesh::Halfedge_index h)
{
  Png1 patch(corners(h), normals(h));
  // the edge opposite of the target of h is the one after the next
  for(unsigned int i = 0; i < 3; ++i, h = next(h, mesh))
  {
    const auto across = opposite(prev(h, mesh), mesh);
    const Point p = mesh.point(target(next(across, mesh), mesh));
    patch.set_neighbor(i, p, p - CGAL::ORIGIN);
  }
  return patch;
}

template <typename Patch>
Vector normal(const Patch& patch, const std::array<double, 3>& c)
{
  const auto d = patch.derivatives(c);
  const Vector n = CGAL::cross_product(d.u, d.v);
  return n / std::sqrt(n.squared_length());
}

double distance_from_sphere(const Point& p)
{
  return std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.);
}

} // namespace

int main()
{
  CGAL::make_icosahedron(mesh, Point(0., 0., 0.), 1.);

  // how far the patches are from the sphere, and which angles their normals make in the middles of edges
  double pn_distance = 0., png1_distance = 0., pn_angle = 0., png1_angle = 0.;
  const std::array<double, 3> middle = {.5, 0., .5}; // of h, whose ends are the corners 0 and 2
  for(const auto h : mesh.halfedges())
  {
    const auto o = opposite(h, mesh);
    const SC::Pn_triangle<Kernel> plain(corners(h), normals(h)), plain_other(corners(o), normals(o));
    const Png1 smooth = smooth_patch(h), smooth_other = smooth_patch(o);
    const auto angle = [](const Vector& a, const Vector& b)
    { return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b); };
    pn_angle = std::max(pn_angle, angle(normal(plain, middle), normal(plain_other, middle)));
    png1_angle = std::max(png1_angle, angle(normal(smooth, middle), normal(smooth_other, middle)));
    for(int i = 0; i <= 10; ++i)
      for(int j = 0; i + j <= 10; ++j)
      {
        const std::array<double, 3> c = {.1 * i, .1 * j, 1. - .1 * i - .1 * j};
        pn_distance = std::max(pn_distance, distance_from_sphere(plain.point(c)));
        png1_distance = std::max(png1_distance, distance_from_sphere(smooth.point(c)));
      }
  }
  std::cout << "PN: " << pn_distance << " from the sphere, " << pn_angle << " between normals at edges\n"
            << "PNG1: " << png1_distance << " from the sphere, " << png1_angle
            << " between normals at edges\n";

  // its curvatures in the middle of a triangle
  const auto d = smooth_patch(*mesh.halfedges().begin()).derivatives({1. / 3., 1. / 3., 1. / 3.});
  const auto curvatures = SC::parametric_surface_curvatures(d.u, d.v, d.uu, d.uv, d.vv);
  std::cout << "curvatures in the middle of a triangle: " << curvatures.min_curvature << " and "
            << curvatures.max_curvature << " (1 on the sphere)\n";

  // each triangle divided into 100
  std::ofstream off("curved_triangles.off");
  off << "OFF\n" << 66 * num_faces(mesh) << ' ' << 100 * num_faces(mesh) << " 0\n";
  const int n = 10;
  for(const auto f : faces(mesh))
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j)
        off << smooth_patch(halfedge(f, mesh)).point({double(n - i - j) / n, double(i) / n, double(j) / n})
            << '\n';
  const auto place = [](int i, int j) { return i * (n + 1) - i * (i - 1) / 2 + j; };
  for(int first = 0; first < 66 * int(num_faces(mesh)); first += 66)
    for(int i = 0; i < n; ++i)
      for(int j = 0; i + j < n; ++j)
      {
        off << "3 " << first + place(i, j) << ' ' << first + place(i + 1, j) << ' ' << first + place(i, j + 1)
            << '\n';
        if(i + j + 1 < n)
          off << "3 " << first + place(i + 1, j) << ' ' << first + place(i + 1, j + 1) << ' '
              << first + place(i, j + 1) << '\n';
      }

  const bool is_right = png1_angle < 1e-12 && pn_distance < .06 && png1_distance < .05 &&
                        std::abs(curvatures.max_curvature - 1.) < .3;
  return off && is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
