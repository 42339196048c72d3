#include "Table.h"

#include <sstream>

namespace accuracy {

namespace {

Table made(std::string name,
           std::string title,
           std::vector<std::string> surfaces,
           Normals normals,
           Quantity quantity = Quantity::PRINCIPAL_CURVATURES)
{
  Table table;
  table.name = std::move(name);
  table.title = std::move(title);
  table.surfaces = std::move(surfaces);
  table.normals = normals;
  table.quantity = quantity;
  return table;
}

Table on(Tessellation tessellation, Table table)
{
  (is_graph(table.surfaces.front()) ? table.of_graphs : table.of_level_sets) = tessellation;
  return table;
}

Table displaced(Displacement displacement, double sigma, Table table)
{
  table.displacement = displacement;
  table.sigma = sigma;
  table.title += ", " + noise_name(table) + " noise";
  return table;
}

std::vector<Table> make_tables()
{
  const std::vector<std::string> graphs = {"f1e", "f2e", "f3e", "f4e"},
                                 level_sets = {"f1i", "f2i", "f3i", "f4i", "f5i"},
                                 both = {"f1e", "f2e", "f3e", "f1i", "f2i", "f3i"};
  constexpr Tessellation original = Tessellation::MARCHING_CUBES_ORIGINAL, grid = Tessellation::UNIFORM_GRID,
                         dual = Tessellation::DUAL_CONTOURING;
  std::vector<Table> list = {
      made("8.3", "explicit functions, exact normals", graphs, Normals::EXACT),
      made("8.4", "explicit functions, Max's normals", graphs, Normals::MAX),
      made("8.5", "explicit functions, average normals", graphs, Normals::AVERAGE),
      made("8.6", "explicit functions, Max's normals, Gaussian curvature", graphs, Normals::MAX,
           Quantity::GAUSSIAN_CURVATURE),
      made("8.7", "explicit functions, exact normals, basis functions", graphs, Normals::EXACT),
      on(original, made("8.8", "implicit functions by original marching cubes, exact normals", level_sets,
                        Normals::EXACT)),
      on(original, made("8.9", "implicit functions by original marching cubes, Max's normals", level_sets,
                        Normals::MAX)),
      on(original, made("8.10", "implicit functions by original marching cubes, average normals", level_sets,
                        Normals::AVERAGE)),
      made("8.11", "implicit functions by exact marching cubes, exact normals", level_sets, Normals::EXACT),
      made("8.12", "implicit functions by exact marching cubes, Max's normals", level_sets, Normals::MAX),
      made("8.13", "implicit functions by exact marching cubes, average normals", level_sets,
           Normals::AVERAGE),
      made("8.14", "normals against exact ones", both, Normals::EXACT, Quantity::NORMALS),
      made("8.15", "Rusinkiewicz's estimator with normals of others", both, Normals::EXACT,
           Quantity::RUSINKIEWICZ),
      made("8.16", "Goldfeather's and Interrante's estimator with normals of others", both, Normals::EXACT,
           Quantity::GOLDFEATHER_INTERRANTE),
      on(grid,
         made("8.3-grid", "explicit functions on a uniform grid, exact normals", graphs, Normals::EXACT)),
      on(grid, made("8.4-grid", "explicit functions on a uniform grid, Max's normals", graphs, Normals::MAX)),
      on(dual, made("8.11-dual", "implicit functions by dual contouring, exact normals", level_sets,
                    Normals::EXACT)),
      on(dual, made("8.12-dual", "implicit functions by dual contouring, Max's normals", level_sets,
                    Normals::MAX))};
  for(const char* number : {"8.4", "8.12"})
    for(const Table& table : std::vector<Table>(list))
      if(table.name == number)
      {
        const auto add = [&](const char* suffix, Displacement displacement, double sigma)
        {
          list.push_back(displaced(displacement, sigma, table));
          list.back().name += suffix;
        };
        add("-noise-0.01", Displacement::GAUSSIAN_NOISE, .01);
        add("-noise-0.03", Displacement::GAUSSIAN_NOISE, .03);
        add("-noise-0.1", Displacement::GAUSSIAN_NOISE, .1);
        add("-uniform-noise-0.1", Displacement::UNIFORM_NOISE, .1);
      }
  return list;
}

} // namespace

const std::vector<Table>& tables()
{
  static const std::vector<Table> list = make_tables();
  return list;
}

bool is_graph(const std::string& surface)
{
  return surface.back() == 'e';
}

Tessellation tessellation(const Table& table, const std::string& surface)
{
  return is_graph(surface) ? table.of_graphs : table.of_level_sets;
}

std::string to_string(Normals normals)
{
  return normals == Normals::EXACT ? "exact" : (normals == Normals::MAX ? "Max" : "average");
}

std::string to_string(Tessellation tessellation)
{
  switch(tessellation)
  {
  case Tessellation::RANDOM_POINTS:
    return "random";
  case Tessellation::UNIFORM_GRID:
    return "grid";
  case Tessellation::MARCHING_CUBES_ORIGINAL:
    return "marching cubes original";
  case Tessellation::MARCHING_CUBES_EXACT:
    return "marching cubes exact";
  case Tessellation::DUAL_CONTOURING:
    return "dual contouring";
  }
  return "";
}

std::string noise_name(const Table& table)
{
  if(table.displacement == Displacement::NONE)
    return "none";
  std::ostringstream out;
  out << (table.displacement == Displacement::GAUSSIAN_NOISE ? "Gaussian " : "uniform ") << table.sigma;
  return out.str();
}

} // namespace accuracy
