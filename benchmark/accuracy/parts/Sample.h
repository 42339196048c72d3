#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_SAMPLE_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_SAMPLE_H

#include "Table.h"
#include "estimators.h"

#include "exact_curvature.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace accuracy {

/// How finely a surface is tessellated.
struct Resolution
{
  std::size_t points = 10000; ///< of a graph; on a uniform grid, the square number next below
  std::size_t grid = 128;     ///< samples per axis of a level set
};

/// A tessellated surface with the truth at its vertices.
struct Sample
{
  Mesh mesh;
  std::vector<benchmark_support::Exact_curvature> exact; ///< in the order of the vertices
  std::vector<bool> inner;                               ///< farther than 4 rings from the border
};

/// The surface of a table. Where chance plays no part, the seed doesn't matter.
Sample
make_sample(const Table& table, const std::string& surface, std::uint64_t seed, const Resolution& resolution);

/// Whether another seed makes another sample.
bool depends_on_seed(const Table& table, const std::string& surface);

/// The exact normals, or those estimated from the mesh.
Normal_map make_normals(Sample& sample, Normals normals);

} // namespace accuracy

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_SAMPLE_H
