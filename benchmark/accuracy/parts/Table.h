#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_TABLE_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_TABLE_H

#include <string>
#include <vector>

namespace accuracy {

/// Which normals the estimators get.
enum class Normals
{
  EXACT,
  MAX,
  AVERAGE
};

/// How a surface becomes a mesh: the first two are for graphs of functions of x and y, the others for level sets.
enum class Tessellation
{
  RANDOM_POINTS,
  UNIFORM_GRID,
  MARCHING_CUBES_ORIGINAL,
  MARCHING_CUBES_EXACT,
  DUAL_CONTOURING
};

/// What moves the points of a mesh; the truth remains that of the place where they were.
enum class Displacement
{
  NONE,
  GAUSSIAN_NOISE,
  UNIFORM_NOISE
};

/// What is compared in a table.
enum class Quantity
{
  PRINCIPAL_CURVATURES, ///< of the estimators
  GAUSSIAN_CURVATURE,   ///< of the estimators
  NORMALS,              ///< of the estimators of normals
  RUSINKIEWICZ,         ///< its principal curvatures with each estimator's normals
  GOLDFEATHER_INTERRANTE
};

/// An experiment of the thesis, or one that it tells of without figures.
struct Table
{
  std::string name; ///< its number; those without figures of their own have more after it
  std::string title;
  std::vector<std::string> surfaces;
  Normals normals = Normals::EXACT;
  Quantity quantity = Quantity::PRINCIPAL_CURVATURES;
  Tessellation of_graphs = Tessellation::RANDOM_POINTS;
  Tessellation of_level_sets = Tessellation::MARCHING_CUBES_EXACT;
  Displacement displacement = Displacement::NONE;
  double sigma = 0.; ///< standard deviation of the noise, in mean lengths of edges

  /// the number of the table whose estimators take part
  std::string number() const { return name.substr(0, name.find('-')); }
};

/// All tables, in their order.
const std::vector<Table>& tables();

bool is_graph(const std::string& surface);
Tessellation tessellation(const Table& table, const std::string& surface);

std::string to_string(Normals normals);
std::string to_string(Tessellation tessellation);
/// as in "Gaussian 0.1", or "none"
std::string noise_name(const Table& table);

} // namespace accuracy

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_TABLE_H
