#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_TRIANGLE_ARRAYS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_TRIANGLE_ARRAYS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// What benchmarks and tests share: meshes as plain arrays, so that every mesh type can be built from the same
// data in the same order of vertices and faces, and a few operations on plain vectors. Nothing here uses the
// library, so that it can judge the library.
namespace benchmark_support {

/// A point or a vector.
struct Vector
{
  double x = 0., y = 0., z = 0.;

  double operator[](std::size_t i) const { return i == 0 ? x : (i == 1 ? y : z); }
  double& operator[](std::size_t i) { return i == 0 ? x : (i == 1 ? y : z); }

  friend bool operator==(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
  friend bool operator!=(const Vector& a, const Vector& b) { return !(a == b); }
};

using Symmetric_matrix = std::array<Vector, 3>;
using Triangle = std::array<std::size_t, 3>;

/// A triangle mesh: counterclockwise triangles seen from outside, as indices of points.
struct Triangle_arrays
{
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
};

inline Vector operator+(const Vector& a, const Vector& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator*(double s, const Vector& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double length(const Vector& a)
{
  return std::sqrt(dot(a, a));
}
inline Vector normalized(const Vector& a)
{
  return (1. / length(a)) * a;
}

inline Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vector multiply(const Symmetric_matrix& m, const Vector& a)
{
  return {dot(m[0], a), dot(m[1], a), dot(m[2], a)};
}

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_TRIANGLE_ARRAYS_H
