#include "surfaces.h"

#include "tessellations.h"
#include "test_functions.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace screen_space {
namespace {

using namespace benchmark_support;

// An icosahedron whose triangles are cut into four again and again; the corners lie on the sphere.
Triangle_arrays icosphere(double radius, std::size_t vertices)
{
  const double g = (1. + std::sqrt(5.)) / 2.;
  Triangle_arrays mesh;
  for(const double a : {-1., 1.})
    for(const double b : {-g, g})
      for(const Vector& p : {Vector{a, b, 0.}, Vector{0., a, b}, Vector{b, 0., a}})
        mesh.points.push_back(normalized(p));
  // its triangles: all triples of corners at the distance of neighbors
  const auto near = [&](std::size_t i, std::size_t j) { return dot(mesh.points[i], mesh.points[j]) > .4; };
  for(std::size_t i = 0; i < 12; ++i)
    for(std::size_t j = i + 1; j < 12; ++j)
      for(std::size_t k = j + 1; k < 12; ++k)
        if(near(i, j) && near(j, k) && near(k, i))
        {
          const Vector n = cross(mesh.points[j] - mesh.points[i], mesh.points[k] - mesh.points[i]);
          mesh.triangles.push_back(dot(n, mesh.points[i]) > 0. ? Triangle{i, j, k} : Triangle{i, k, j});
        }
  while(mesh.points.size() * 2 < vertices)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t i, std::size_t j)
    {
      const auto inserted = middles.insert({std::minmax(i, j), mesh.points.size()});
      if(inserted.second)
        mesh.points.push_back(normalized(mesh.points[i] + mesh.points[j]));
      return inserted.first->second;
    };
    std::vector<Triangle> finer;
    for(const Triangle& t : mesh.triangles)
    {
      const std::size_t a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
    }
    mesh.triangles = std::move(finer);
  }
  for(Vector& p : mesh.points)
    p = radius * p;
  return mesh;
}

constexpr double torus_major = 1., torus_minor = .4;

// the torus about the z axis
Exact_curvature torus_truth(const Vector& p)
{
  const double distance = std::hypot(p.x, p.y);
  const Vector center{torus_major * p.x / distance, torus_major * p.y / distance, 0.};
  Exact_curvature result;
  result.normal = normalized(p - center);
  const double outwards = (result.normal.x * p.x + result.normal.y * p.y) / distance;
  const double around = outwards / (torus_major + torus_minor * outwards);
  result.k_min = std::min(around, 1. / torus_minor);
  result.k_max = std::max(around, 1. / torus_minor);
  return result;
}

Triangle_arrays torus_mesh(std::size_t vertices)
{
  // edges of about equal length around both circles
  const double ratio = torus_major / torus_minor;
  const auto across = std::max<std::size_t>(std::size_t(std::lround(std::sqrt(double(vertices) / ratio))), 3);
  const std::size_t along = std::max<std::size_t>(vertices / across, 3);
  Triangle_arrays mesh;
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < across; ++j)
    {
      const double a = 2. * CGAL_PI * double(i) / double(along),
                   b = 2. * CGAL_PI * double(j) / double(across);
      const double r = torus_major + torus_minor * std::cos(b);
      mesh.points.push_back({r * std::cos(a), r * std::sin(a), torus_minor * std::sin(b)});
      const std::size_t i1 = (i + 1) % along, j1 = (j + 1) % across;
      const std::size_t p = i * across + j, q = i1 * across + j, r1 = i1 * across + j1, s = i * across + j1;
      mesh.triangles.push_back({p, q, r1});
      mesh.triangles.push_back({p, r1, s});
    }
  return mesh;
}

} // namespace

Surface surface(const std::string& name, std::size_t vertices, std::uint64_t seed)
{
  Surface result;
  result.name = name;
  if(name == "sphere")
  {
    constexpr double radius = 6.;
    result.mesh = icosphere(radius, vertices);
    result.truth = [](const Vector& p)
    {
      Exact_curvature truth;
      truth.normal = normalized(p);
      truth.k_min = truth.k_max = 1. / radius;
      return truth;
    };
    result.towards_eye = {.3, .4, 1.};
    result.up = {0., 1., 0.};
  }
  else if(name == "torus")
  {
    result.mesh = torus_mesh(vertices);
    result.truth = torus_truth;
    result.towards_eye = {.3, -.8, 1.};
    result.up = {0., 0., 1.};
  }
  else if(name == "f1" || name == "f2")
  {
    const Explicit_function& f = explicit_function(name + "e");
    result.mesh = random_tessellation(f, vertices, seed);
    result.truth = [&f](const Vector& p) { return f.exact(p.x, p.y); };
    result.towards_eye = {.2, -.7, 1.};
    result.up = {0., 0., 1.};
  }
  else
    throw std::invalid_argument("no surface " + name);
  for(const Vector& p : result.mesh.points)
    result.normals.push_back(result.truth(p).normal);
  return result;
}

Relief relief(double x, double y, double margin)
{
  Relief result;
  result.normal = {0., 0., 1.};
  // a hemisphere, the upper half of a torus, a cone and a pyramid, one in each quarter of the square
  constexpr double radius = .8, minor = .25, slope = 1.;
  const double u = std::abs(x) - 1., v = std::abs(y) - 1., r = std::hypot(u, v);
  const double sx = x < 0. ? -1. : 1., sy = y < 0. ? -1. : 1.; // the mirrored quarters
  double gu = 0., gv = 0.;                                     // the gradient in u and v
  double edge = 0.;                                            // the distance from where it is not smooth
  std::array<double, 3> h{0., 0., 0.};                         // the Hessian
  bool is_raised = true;
  if(x < 0. && y >= 0.) // sphere
  {
    edge = std::abs(r - radius);
    is_raised = r < radius;
    if(is_raised)
    {
      result.height = std::sqrt(radius * radius - r * r);
      const double z = result.height;
      gu = -u / z;
      gv = -v / z;
      h = {-(1. + gu * gu) / z, -gu * gv / z, -(1. + gv * gv) / z};
    }
  }
  else if(x >= 0. && y >= 0.) // torus
  {
    const double ring = radius - minor, d = r - ring;
    edge = std::abs(std::abs(d) - minor);
    is_raised = std::abs(d) < minor;
    if(is_raised)
    {
      const double z = std::sqrt(minor * minor - d * d), first = -d / z, second = -(1. + first * first) / z;
      result.height = z;
      gu = first * u / r;
      gv = first * v / r;
      const double c = u / r, s = v / r, side = first / r; // f'' along the radius, f' / r across
      h = {second * c * c + side * s * s, (second - side) * c * s, second * s * s + side * c * c};
    }
  }
  else if(x < 0.) // cone
  {
    edge = std::min(std::abs(r - radius), r);
    is_raised = r < radius;
    if(is_raised)
    {
      result.height = slope * (radius - r);
      gu = r > 0. ? -slope * u / r : 0.;
      gv = r > 0. ? -slope * v / r : 0.;
      if(r > 0.)
        h = {-slope * v * v / (r * r * r), slope * u * v / (r * r * r), -slope * u * u / (r * r * r)};
    }
  }
  else // pyramid
  {
    const double m = std::max(std::abs(u), std::abs(v));
    edge = std::min(std::abs(m - radius), std::abs(std::abs(u) - std::abs(v)) / std::sqrt(2.));
    is_raised = m < radius;
    if(m > radius)
      edge = m - radius;
    if(is_raised)
    {
      result.height = slope * (radius - m);
      (std::abs(u) > std::abs(v) ? gu : gv) =
          std::abs(u) > std::abs(v) ? (u < 0. ? slope : -slope) : (v < 0. ? slope : -slope);
    }
  }
  result.is_smooth = edge > margin;
  const Vector gradient{-gu * sx, -gv * sy, 1.};
  result.curvature = exact_curvature(
      gradient, {Vector{-h[0], -h[1] * sx * sy, 0.}, Vector{-h[1] * sx * sy, -h[2], 0.}, Vector{0., 0., 0.}});
  result.normal = result.curvature.normal;
  return result;
}

} // namespace screen_space
