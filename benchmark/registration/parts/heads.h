#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_HEADS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_HEADS_H

#include "Scan.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace registration {

/// One model in two samplings that have no vertex in common, and a finer one to sample points from.
struct Head
{
  std::string name;
  Scan first, second; ///< meshes
  Scan fine;          ///< the mesh after one step of Loop's subdivision, with normals
};

/// The files of the heads in `folder`. If that is empty, of those beside the checkout, or, where there are none, one of the
/// busts that come with CGAL. `comment` says which.
/// \throws std::invalid_argument if there are none in a folder that is named
std::vector<std::string> head_files(const std::string& folder, std::string& comment);

/*!
  reads a head and samples it twice, as the thesis says (10.2.1): the largest component, one step of Loop's subdivision,
  vertices moved at random by .05 of the mean edge, and edges collapsed by the quadric error until `faces[0]` and
  `faces[1]` triangles are left.

  The result is kept in the folder `cache`, and read from there the next time. The model is scaled to a longest side of 1,
  and turned so that its plane of symmetry is x = 0 if it is one of the heads.
*/
Head read_head(const std::string& file,
               const std::size_t (&faces)[2],
               std::uint64_t seed,
               const std::string& cache);

/// `number` points of the surface of a mesh with the normals of their triangles, at random
Scan random_points(const Scan& mesh, std::size_t number, std::uint64_t seed);

/// `number` points of the surface of a mesh with the normals of their triangles, spread as evenly as a Poisson-disc
/// pattern, drawn by eliminating the most crowded of three times as many random ones (Yuksel 2015)
Scan poisson_disc_points(const Scan& mesh, std::size_t number, std::uint64_t seed);

/// normals of the vertices of a mesh
void set_mesh_normals(Scan& mesh);

/// replaces the normals of a point set by those of principal component analysis, on the same side
void estimate_point_normals(Scan& points);

} // namespace registration

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_HEADS_H
