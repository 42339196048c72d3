#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_ANALYTIC_SURFACES_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_ANALYTIC_SURFACES_H

#include "../../benchmark/support/Random.h"
#include "../../benchmark/support/Triangle_arrays.h"
#include "../../benchmark/support/exact_curvature.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

// Triangulated surfaces whose normals and curvatures are known at every vertex.
//
// Every function takes `jitter`, the greatest displacement of a vertex in its parameter plane as a fraction of
// the spacing (0: regular; at most 0.2; from 0.25 on triangles may turn over), and a seed. Vertices stay on the surface. With
// jitter, the diagonals of quadrilateral grids are drawn too, so that valences vary between 4 and 8. Test with
// both: symmetric neighborhoods cancel errors that others show.
namespace test_support {

using benchmark_support::Exact_curvature;
using benchmark_support::Random;
using benchmark_support::Symmetric_matrix;
using benchmark_support::Triangle;
using benchmark_support::Vector;

/// The truth at a vertex; what it adds to `Exact_curvature` (normal, k_min, k_max, d_min, d_max) are flags.
struct Exact_vertex : Exact_curvature
{
  bool border = false; ///< on the border of the mesh
  bool singular =
      false; ///< the surface is not smooth here: the normal is the axis' direction, curvatures are NaN
  bool umbilic = false; ///< k_min equals k_max: d_min and d_max are any tangent directions
};

/// A triangle mesh (counterclockwise seen from outside) with the truth at each vertex.
struct Analytic_surface
{
  std::string name;
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  std::vector<Exact_vertex> exact; ///< exact[i] belongs to points[i]

  /// mean length of the edges
  double mean_edge_length() const;
};

/// Unit icosphere: 12 vertices, each triangle divided in four `subdivisions` times.
void icosphere(unsigned int subdivisions, std::vector<Vector>& points, std::vector<Triangle>& triangles);

/// Sphere around the origin, an icosahedron divided `subdivisions` times (10 4^s + 2 vertices).
Analytic_surface
sphere(double radius = 1., unsigned int subdivisions = 3, double jitter = 0., std::uint64_t seed = 1);

/// Ellipsoid with half axes a, b, c along x, y, z: an icosphere, stretched.
Analytic_surface ellipsoid(double a = 1.,
                           double b = .8,
                           double c = .6,
                           unsigned int subdivisions = 3,
                           double jitter = 0.,
                           std::uint64_t seed = 1);

/// Ellipsoid with half axes a, b, c along x, y, z, of circles of `longitudes` vertices from pole to pole. The poles are the
/// last two vertices; the first circle and the last one are beside them.
Analytic_surface ellipsoid_of_longitudes(double a, double b, double c, std::size_t longitudes);

/// Side of a cylinder around the z axis, z from 0 to `height`, open at both ends.
Analytic_surface cylinder(double radius = 1.,
                          double height = 2.,
                          std::size_t around = 40,
                          std::size_t along = 12,
                          double jitter = 0.,
                          std::uint64_t seed = 1);

/// Side of a cone with its apex at the origin opening downwards to a circle of `radius` at z = -`height`. The
/// apex is the last vertex, and singular.
Analytic_surface cone(double radius = 1.,
                      double height = 1.5,
                      std::size_t around = 40,
                      std::size_t along = 16,
                      double jitter = 0.,
                      std::uint64_t seed = 1);

/// Torus around the z axis: a tube of radius `tube` around a circle of radius `ring`.
Analytic_surface torus(double ring = 1.,
                       double tube = .4,
                       std::size_t around_ring = 48,
                       std::size_t around_tube = 24,
                       double jitter = 0.,
                       std::uint64_t seed = 1);

/// Graph z = f(x, y) over the square [-half, half]^2, upward normals. `value(x, y)` is f, `gradient(x, y)` the
/// pair (f_x, f_y) and `hessian(x, y)` the triple (f_xx, f_xy, f_yy), each an std::array.
Analytic_surface graph(const std::string& name,
                       const std::function<double(double, double)>& value,
                       const std::function<std::array<double, 2>(double, double)>& gradient,
                       const std::function<std::array<double, 3>(double, double)>& hessian,
                       double half = 1.,
                       std::size_t n = 24,
                       double jitter = 0.,
                       std::uint64_t seed = 1);

/// Square of the plane z = 0.
Analytic_surface plane(double half = 1., std::size_t n = 24, double jitter = 0., std::uint64_t seed = 1);

/// Paraboloid z = (a x^2 + b y^2) / 2; at the origin the curvatures are -a and -b. `a` and `b` of the same sign
/// make a bowl, of opposite signs a saddle.
Analytic_surface paraboloid(double a,
                            double b,
                            double half = 1.,
                            std::size_t n = 24,
                            double jitter = 0.,
                            std::uint64_t seed = 1);

/// Saddle z = (x^2 - y^2) / 2.
Analytic_surface saddle(double half = 1., std::size_t n = 24, double jitter = 0., std::uint64_t seed = 1);

/// Monkey saddle z = x^3 - 3 x y^2; the origin is a flat umbilic.
Analytic_surface
monkey_saddle(double half = .5, std::size_t n = 24, double jitter = 0., std::uint64_t seed = 1);

/// Waves z = h (sin(w x) + cos(w y)): curvatures of both signs, and flat points.
Analytic_surface waves(double height = .1,
                       double frequency = 4.,
                       double half = 1.,
                       std::size_t n = 32,
                       double jitter = 0.,
                       std::uint64_t seed = 1);

/// A surface with Gaussian noise of standard deviation `level`, in mean edge lengths, on each coordinate of its points;
/// normals and curvatures stay those of the surface.
Analytic_surface with_noise(Analytic_surface s, double level);

/// One of each, for tests that run over all surfaces.
std::vector<Analytic_surface> all_analytic_surfaces(double jitter = 0., std::uint64_t seed = 1);

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_ANALYTIC_SURFACES_H
