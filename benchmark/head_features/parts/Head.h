#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_HEAD_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_HEAD_H

#include <Shape_characteristics/head_features/Head_features.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <vector>

namespace head_features {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Features = SC::Head_features<Mesh, Kernel>;

/// A head and the true places of its features.
struct Head
{
  std::string name;    ///< of the person
  std::string variant; ///< "crop", "smile", ...
  Mesh mesh;
  Features truth; ///< what isn't known is not found; `head_height` is that of the top above the menton
  /// whether a vertex says something of regions: not those of eyeballs, nor those that subdivision has added (`loop1`), of which
  /// the truth knows nothing
  std::vector<bool> is_known;
};

/// A file `<name>_<variant>.ply` with `<name>_<variant>.json` beside it.
struct Head_file
{
  std::string name, variant;
  std::string mesh, truth; ///< paths
};

/*!
  The files of the heads in `folder` (by default that beside the checkout) whose variants are among `variants`, in the order of
  these and of their names. `comment` says what was found.
*/
std::vector<Head_file>
head_files(const std::string& folder, const std::vector<std::string>& variants, std::string& comment);

/*!
  reads a head: the mesh, and from the JSON file the points of the member `thesis` (`pos`, by the names of the data's README), the
  pose, and the vertices of its regions, which are in `regions.json` in the same folder, if there is one.

  Throws `std::runtime_error` that names the file.
*/
Head read_head(const Head_file& file);

/// reads a triangle mesh; throws `std::runtime_error` that names the file
Mesh read_mesh(const std::string& file);

} // namespace head_features

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_HEAD_H
