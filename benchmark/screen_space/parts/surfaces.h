#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_SURFACES_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_SURFACES_H

#include "Triangle_arrays.h"
#include "exact_curvature.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace screen_space {

using benchmark_support::Exact_curvature;
using benchmark_support::Triangle_arrays;
using benchmark_support::Vector;

/// A surface whose curvature is known everywhere, and a mesh of it with exact normals.
struct Surface
{
  std::string name;
  Triangle_arrays mesh;
  std::vector<Vector> normals; ///< of the mesh's vertices
  std::function<Exact_curvature(const Vector&)>
      truth;          ///< at the point of the surface that is drawn at this one
  Vector towards_eye; ///< from where its best side shows
  Vector up;
};

/// The surfaces of the chapter's experiments: "sphere" (radius 6), "torus" (of as many vertices as asked, about), "f1" and "f2" (graphs
/// over random points).
/// \throws std::invalid_argument for another name
Surface surface(const std::string& name, std::size_t vertices, std::uint64_t seed);

/// The relief of the test picture for normal maps: a torus, a sphere, a cone and a pyramid on the square [-2, 2]^2.
struct Relief
{
  double height = 0.;
  Vector normal{};
  Exact_curvature curvature;
  bool is_smooth = true; ///< false near edges, tips, and where the relief meets the square
};

/// The relief at (x, y); `margin` is how far from edges it has to be called smooth.
Relief relief(double x, double y, double margin);

} // namespace screen_space

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_SURFACES_H
