// Accuracy of curvature estimators on the surfaces of the thesis's experiments (chapter 8), next to the figures
// it prints. What the thesis calls MSE is reproduced as the mean absolute error of k_max plus that of k_min over all
// vertices, border included; squared errors are printed beside it.
#include "Command_line.h"
#include "Error_statistics.h"
#include "build_face_graph.h"
#include "estimators.h"
#include "printed_figures.h"
#include "tessellations.h"
#include "test_functions.h"

#if __has_include(<support/Plot.h>) // what the examples share, where its dependencies are found
#include <support/Plot.h>
#define SHAPE_CHARACTERISTICS_ACCURACY_PLOTS
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace accuracy {

using benchmark_support::Error_statistics;
using benchmark_support::Exact_curvature;
using benchmark_support::Triangle_arrays;
using benchmark_support::Vector;

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

enum class Normals
{
  EXACT,
  MAX,
  AVERAGE
};

const char* to_string(Normals normals)
{
  return normals == Normals::EXACT ? "exact" : (normals == Normals::MAX ? "Max" : "average");
}

struct Table
{
  std::string number, title;
  std::vector<std::string> surfaces;
  Normals normals;
};

const std::vector<Table>& tables()
{
  static const std::vector<std::string> e = {"f1e", "f2e", "f3e", "f4e"},
                                        i = {"f1i", "f2i", "f3i", "f4i", "f5i"};
  static const std::vector<Table> list = {
      {"8.3", "explicit functions, exact normals", e, Normals::EXACT},
      {"8.4", "explicit functions, Max's normals", e, Normals::MAX},
      {"8.5", "explicit functions, average normals", e, Normals::AVERAGE},
      {"8.7", "explicit functions, exact normals, basis functions", e, Normals::EXACT},
      {"8.12", "implicit functions by exact marching cubes, Max's normals", i, Normals::MAX},
      {"8.14", "normals against exact ones", {"f1e", "f2e", "f3e", "f1i", "f2i", "f3i"}, Normals::EXACT}};
  return list;
}

struct Options
{
  std::vector<std::string> tables;
  std::vector<std::uint64_t> seeds;
  std::size_t points, grid;
  bool all_seeds; ///< for the costly estimators, too
};

/// A tessellated surface with the truth at its vertices.
struct Sample
{
  Mesh mesh;
  std::vector<Exact_curvature> exact; ///< in the order of the vertices
  std::vector<bool> inner;            ///< farther than 4 rings from the border
};

bool is_explicit(const std::string& surface)
{
  return surface.back() == 'e';
}

const char* tessellation_name(const std::string& surface)
{
  return is_explicit(surface) ? "random" : "marching cubes exact";
}

/// Marching cubes knows no chance: one seed is enough.
std::vector<std::uint64_t> seeds_of(const std::string& surface, const Options& options)
{
  return is_explicit(surface) ? options.seeds : std::vector<std::uint64_t>{0};
}

Sample make_sample(const std::string& surface, std::uint64_t seed, const Options& options)
{
  using namespace benchmark_support;
  Sample sample;
  Triangle_arrays arrays;
  if(is_explicit(surface))
  {
    const Explicit_function& f = explicit_function(surface);
    arrays = random_tessellation(f, options.points, seed);
    for(const Vector& p : arrays.points)
      sample.exact.push_back(f.exact(p.x, p.y));
  }
  else
  {
    const Implicit_function& f = implicit_function(surface);
    arrays = marching_cubes_tessellation(f, options.grid, Edge_crossing::EXACT);
    for(const Vector& p : arrays.points)
      sample.exact.push_back(f.exact(p));
  }
  sample.mesh = build_face_graph<Mesh>(arrays.points, arrays.triangles);
  for(std::size_t rings : rings_from_border(arrays))
    sample.inner.push_back(rings > 4);
  return sample;
}

Normal_map make_normals(Sample& sample, Normals normals)
{
  Normal_map map = sample.mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normals").first;
  if(normals == Normals::EXACT)
    for(Vertex v : vertices(sample.mesh))
    {
      const Vector& n = sample.exact[v].normal;
      map[v] = Kernel::Vector_3(n.x, n.y, n.z);
    }
  else
    weighted(normals == Normals::MAX ? SC::Normal_weighting::MAX : SC::Normal_weighting::AVERAGE)(sample.mesh,
                                                                                                  map);
  return map;
}

/// The errors of one estimator on one surface, over all seeds.
struct Errors
{
  Error_statistics all, inner;
  double seconds = 0.;

  void add(const Errors& other)
  {
    all.add(other.all);
    inner.add(other.inner);
    seconds += other.seconds;
  }
};

Errors measure(const Estimator& estimator, Sample& sample, Normal_map normals, bool normals_are_exact)
{
  Curvature_map curvatures =
      sample.mesh.add_property_map<Vertex, SC::Principal_curvatures_and_directions<Kernel>>("v:curvatures")
          .first;
  Status_map statuses = sample.mesh.add_property_map<Vertex, SC::Estimation_status>("v:statuses").first;
  for(Vertex v :
      vertices(sample.mesh)) // what an estimator leaves alone must not count as the last one's result
  {
    curvatures[v].min_curvature = curvatures[v].max_curvature = nan_value;
    statuses[v] = SC::Estimation_status::UNREFERENCED;
  }

  Errors errors;
  const auto start = std::chrono::steady_clock::now();
  estimator.run({sample.mesh, normals, normals_are_exact, curvatures, statuses});
  errors.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  for(Vertex v : vertices(sample.mesh))
  {
    const bool estimated = SC::is_estimated(statuses[v]);
    const double k_max = estimated ? curvatures[v].max_curvature - sample.exact[v].k_max : nan_value;
    const double k_min = estimated ? curvatures[v].min_curvature - sample.exact[v].k_min : nan_value;
    errors.all.add(k_max, k_min);
    if(sample.inner[v])
      errors.inner.add(k_max, k_min);
  }
  return errors;
}

/// 1 - n . n_estimated (equation 8.9), over all seeds.
struct Normal_errors
{
  double sum_all = 0., sum_inner = 0.;
  std::size_t all = 0, inner = 0, flagged = 0;

  double mean_all() const { return sum_all / double(all - flagged); }
  double mean_inner() const { return sum_inner / double(inner); }
};

void measure(const Normal_estimator& estimator, Sample& sample, Normal_errors& errors)
{
  Normal_map normals = sample.mesh.add_property_map<Vertex, Kernel::Vector_3>("v:estimated_normals").first;
  for(Vertex v : vertices(sample.mesh))
    normals[v] = Kernel::Vector_3(nan_value, nan_value, nan_value);
  estimator.run(sample.mesh, normals);
  for(Vertex v : vertices(sample.mesh))
  {
    const Vector& n = sample.exact[v].normal;
    const Vector d = n - Vector{normals[v].x(), normals[v].y(), normals[v].z()};
    const double error = .5 * dot(d, d); // 1 - cosine of unit vectors, without cancellation
    ++errors.all;
    if(!std::isfinite(error))
    {
      ++errors.flagged;
      continue;
    }
    errors.sum_all += error;
    if(sample.inner[v])
    {
      ++errors.inner;
      errors.sum_inner += error;
    }
  }
}

std::string number(double value)
{
  if(!std::isfinite(value))
    return "–";
  std::ostringstream out;
  if(value != 0. && value < 1e-3)
    out << std::scientific << std::setprecision(1) << value;
  else
    out << std::setprecision(3) << value;
  return out.str();
}

// the figure the thesis prints for `column` on the i-th surface of a table, or NaN
double printed(const std::string& table, const std::string& column, std::size_t i)
{
  const Printed_column* c = printed_column(table, column);
  return c == nullptr ? nan_value : c->figures.at(i);
}

std::string cell(double value, double figure, std::size_t flagged)
{
  std::ostringstream out;
  out << number(value);
  if(std::isfinite(figure))
    out << " (" << figure << ")";
  if(flagged != 0)
    out << " [" << flagged << " flagged]";
  return out.str();
}

/// Prints Markdown, writes CSV, and remembers the means for the checks of the ordering.
class Report
{
public:
  Report(const std::string& csv, const std::string& plot) : m_plot(plot)
  {
#ifndef SHAPE_CHARACTERISTICS_ACCURACY_PLOTS
    if(!plot.empty())
      throw std::invalid_argument("--plot: built without the support for plots");
#endif
    if(csv.empty())
      return;
    m_csv.open(csv);
    const std::size_t dot = csv.rfind('.');
    const std::string normals_csv =
        dot == std::string::npos ? csv + "_normals" : csv.substr(0, dot) + "_normals" + csv.substr(dot);
    m_normals_csv.open(normals_csv);
    if(!m_csv || !m_normals_csv)
      throw std::runtime_error("cannot write " + csv + " and " + normals_csv);
    m_csv << "table,surface,tessellation,normals,noise,estimator,neighbourhood,mae_kmax,mae_kmin,mse_kmax,"
             "mse_kmin,"
             "median,vertices,flagged,printed\n";
    m_normals_csv
        << "table,surface,tessellation,estimator,neighbourhood,mean_error,vertices,flagged,printed\n";
  }

  /// `rows`: the errors of each estimator on each surface of the table
  void add(const Table& table,
           const std::vector<std::pair<const Estimator*, std::string>>& columns,
           const std::vector<std::vector<Errors>>& rows)
  {
    std::cout << "\n## Table " << table.number << ": " << table.title << "\n";
    heading("MAE(k_max) + MAE(k_min), all vertices; in parentheses what the thesis prints", table, "seconds");
    std::set<std::string> compared;
    std::vector<std::pair<std::string, std::vector<double>>> lines;
    for(std::size_t r = 0; r < rows.size(); ++r)
    {
      lines.emplace_back(columns[r].first->label(), std::vector<double>());
      double seconds = 0.;
      std::cout << "| " << columns[r].first->label();
      for(std::size_t i = 0; i < rows[r].size(); ++i)
      {
        const Error_statistics& all = rows[r][i].all;
        const double figure = printed(table.number, columns[r].second, i);
        std::cout << " | " << cell(all.mae(), figure, all.flagged());
        lines.back().second.push_back(all.mae());
        seconds += rows[r][i].seconds;
        m_means[table.number + "|" + columns[r].first->label() + "|" + table.surfaces[i]] = all.mae();
        write(table, table.number, table.surfaces[i], *columns[r].first, all, figure);
        write(table, table.number + " inner", table.surfaces[i], *columns[r].first, rows[r][i].inner,
              nan_value);
      }
      compared.insert(columns[r].second);
      std::cout << " | " << std::fixed << std::setprecision(2) << seconds << std::defaultfloat << " |\n";
    }
    print_others(table, compared, " | |");
    plot(table, "MAE(k_{max}) + MAE(k_{min})", lines, compared, 1.);

    heading("The same over vertices farther than 4 rings from the border", table, "");
    body(columns, rows, [](const Errors& e) { return e.inner.mae(); });
    heading("MSE(k_max) + MSE(k_min), all vertices", table, "");
    body(columns, rows, [](const Errors& e) { return e.all.mse(); });
    heading("Median of |error of k_max| + |error of k_min|, all vertices", table, "");
    body(columns, rows, [](const Errors& e) { return e.all.median(); });
  }

  void add(const Table& table, const std::vector<std::vector<Normal_errors>>& rows)
  {
    std::cout << "\n## Table " << table.number << ": " << table.title << "\n";
    heading("Mean of 1 - n . n_estimated in 1e-4, all vertices; in parentheses what the thesis prints", table,
            "");
    std::set<std::string> compared;
    std::vector<std::pair<std::string, std::vector<double>>> lines;
    for(std::size_t r = 0; r < rows.size(); ++r)
    {
      lines.emplace_back(normal_estimators()[r].label(), std::vector<double>());
      const Normal_estimator& estimator = normal_estimators()[r];
      std::cout << "| " << estimator.label();
      for(std::size_t i = 0; i < rows[r].size(); ++i)
      {
        const Normal_errors& e = rows[r][i];
        const double figure = printed(table.number, estimator.column, i);
        std::cout << " | " << cell(1e4 * e.mean_all(), figure, e.flagged);
        lines.back().second.push_back(e.mean_all());
        m_means[table.number + "|" + estimator.label() + "|" + table.surfaces[i]] = e.mean_all();
        if(m_normals_csv.is_open())
          m_normals_csv << table.number << ',' << table.surfaces[i] << ','
                        << tessellation_name(table.surfaces[i]) << ',' << estimator.name << ','
                        << estimator.neighbourhood << ',' << csv(e.mean_all()) << ',' << e.all << ','
                        << e.flagged << ',' << csv(1e-4 * figure) << '\n';
      }
      compared.insert(estimator.column);
      std::cout << " |\n";
    }
    print_others(table, compared, " |");
    plot(table, "mean of 1 - n . n_{estimated}", lines, compared, 1e-4);
    heading("The same over vertices farther than 4 rings from the border", table, "");
    for(std::size_t r = 0; r < rows.size(); ++r)
    {
      std::cout << "| " << normal_estimators()[r].label();
      for(const Normal_errors& e : rows[r])
        std::cout << " | " << number(1e4 * e.mean_inner());
      std::cout << " |\n";
    }
  }

  /// geometric mean of the errors on the surfaces of a table, so that no surface decides alone; NaN if the table or the
  /// estimator was not run
  double mean(const std::string& table, const std::string& label) const
  {
    double sum = 0.;
    std::size_t count = 0;
    for(const Table& t : tables())
      for(const std::string& surface : t.surfaces)
        if(t.number == table)
        {
          const auto found = m_means.find(table + "|" + label + "|" + surface);
          if(found == m_means.end())
            return nan_value;
          sum += std::log(found->second);
          ++count;
        }
    return std::exp(sum / double(count));
  }

  /// \throws std::runtime_error if the CSV files could not be written
  void finish()
  {
    for(std::ofstream* file : {&m_csv, &m_normals_csv})
      if(file->is_open() && !file->flush())
        throw std::runtime_error("cannot write the CSV files");
  }

private:
  static void heading(const std::string& what, const Table& table, const std::string& more)
  {
    std::cout << "\n" << what << "\n\n| estimator";
    for(const std::string& surface : table.surfaces)
      std::cout << " | " << surface;
    std::cout << (more.empty() ? "" : " | " + more) << " |\n|---";
    const std::size_t extra = more.empty() ? 0 : 1 + std::size_t(std::count(more.begin(), more.end(), '|'));
    for(std::size_t i = 0; i < table.surfaces.size() + extra; ++i)
      std::cout << "|---:";
    std::cout << "|\n";
  }

  template <typename Value>
  static void body(const std::vector<std::pair<const Estimator*, std::string>>& columns,
                   const std::vector<std::vector<Errors>>& rows,
                   const Value& value)
  {
    for(std::size_t r = 0; r < rows.size(); ++r)
    {
      std::cout << "| " << columns[r].first->label();
      for(const Errors& e : rows[r])
        std::cout << " | " << number(value(e));
      std::cout << " |\n";
    }
  }

  // what the thesis prints for methods that are not in the list
  static void print_others(const Table& table, const std::set<std::string>& compared, const std::string& end)
  {
    for(const Printed_column& c : printed_figures())
      if(c.table == table.number && compared.count(c.column) == 0)
      {
        std::cout << "| " << c.column << " of the thesis";
        for(double figure : c.figures)
          std::cout << " | (" << figure << ")";
        std::cout << end << "\n";
      }
  }

  static std::string csv(double value)
  {
    if(!std::isfinite(value))
      return "";
    std::ostringstream out;
    out << std::setprecision(8) << value;
    return out.str();
  }

  void write(const Table& table,
             const std::string& rows,
             const std::string& surface,
             const Estimator& estimator,
             const Error_statistics& e,
             double figure)
  {
    if(!m_csv.is_open())
      return;
    m_csv << rows << ',' << surface << ',' << tessellation_name(surface) << ',' << to_string(table.normals)
          << ",none," << estimator.name << ',' << estimator.neighbourhood << ',' << csv(e.mae_k_max()) << ','
          << csv(e.mae_k_min()) << ',' << csv(e.mse_k_max()) << ',' << csv(e.mse_k_min()) << ','
          << csv(e.median()) << ',' << e.vertices() << ',' << e.flagged() << ',' << csv(figure) << '\n';
  }

  // Every estimator is a line over the surfaces; what the thesis prints for methods not in the list is grey.
  void plot(const Table& table,
            const std::string& y_label,
            const std::vector<std::pair<std::string, std::vector<double>>>& lines,
            const std::set<std::string>& compared,
            double unit) const
  {
    if(m_plot.empty())
      return;
#ifdef SHAPE_CHARACTERISTICS_ACCURACY_PLOTS
    support::Plot plot;
    plot.title = "Table " + table.number + ": " + table.title;
    plot.y_label = y_label;
    plot.y_logarithmic = true;
    std::vector<double> x;
    for(std::size_t i = 0; i < table.surfaces.size(); ++i)
    {
      x.push_back(double(i + 1));
      plot.x_label += (i == 0 ? "" : ", ") + std::to_string(i + 1) + ": " + table.surfaces[i];
    }
    const auto add = [&](const std::string& name, const std::vector<double>& y, bool of_the_thesis)
    {
      support::Plot_series series;
      series.name = name;
      series.x = x;
      series.y = y;
      series.dashed = series.grey = of_the_thesis;
      plot.series.push_back(series);
    };
    for(const auto& [name, values] : lines)
      add(name, values, false);
    for(const Printed_column& c : printed_figures())
      if(c.table == table.number && compared.count(c.column) == 0)
      {
        std::vector<double> values;
        for(double figure : c.figures)
          values.push_back(unit * figure);
        add(c.column + " of the thesis", values, true);
      }
    support::write_png(m_plot + "_" + table.number + ".png", plot.image());
#else
    (void)table, (void)y_label, (void)lines, (void)compared, (void)unit;
#endif
  }

  std::string m_plot;
  std::ofstream m_csv, m_normals_csv;
  std::map<std::string, double> m_means;
};

void run_curvature_table(const Table& table,
                         const Options& options,
                         std::map<std::string, Errors>& done,
                         Report& report)
{
  std::vector<std::pair<const Estimator*, std::string>> columns;
  for(const Estimator& e : estimators())
    for(const Appearance& a : e.appearances)
      if(a.table == table.number)
        columns.emplace_back(&e, a.column);

  std::vector<std::vector<Errors>> rows(columns.size(), std::vector<Errors>(table.surfaces.size()));
  for(std::size_t i = 0; i < table.surfaces.size(); ++i)
  {
    bool is_first = true;
    for(std::uint64_t seed : seeds_of(table.surfaces[i], options))
    {
      Sample sample = make_sample(table.surfaces[i], seed, options);
      const Normal_map normals = make_normals(sample, table.normals);
      for(std::size_t r = 0; r < columns.size(); ++r)
      {
        if(!is_first && !options.all_seeds && columns[r].first->cost == Cost::HIGH)
          continue;
        // tables overlap: 8.7 has a column of 8.3
        const std::string key = columns[r].first->label() + "|" + table.surfaces[i] + "|" +
                                std::to_string(seed) + "|" + to_string(table.normals);
        auto found = done.find(key);
        if(found == done.end())
          found =
              done.emplace(key, measure(*columns[r].first, sample, normals, table.normals == Normals::EXACT))
                  .first;
        rows[r][i].add(found->second);
      }
      is_first = false;
    }
  }
  report.add(table, columns, rows);
}

void run_normal_table(const Table& table, const Options& options, Report& report)
{
  std::vector<std::vector<Normal_errors>> rows(normal_estimators().size(),
                                               std::vector<Normal_errors>(table.surfaces.size()));
  for(std::size_t i = 0; i < table.surfaces.size(); ++i)
  {
    bool is_first = true;
    for(std::uint64_t seed : seeds_of(table.surfaces[i], options))
    {
      Sample sample = make_sample(table.surfaces[i], seed, options);
      for(std::size_t r = 0; r < rows.size(); ++r)
        if(is_first || options.all_seeds || normal_estimators()[r].cost == Cost::LOW)
          measure(normal_estimators()[r], sample, rows[r][i]);
      is_first = false;
    }
  }
  report.add(table, rows);
}

/// The order of the estimators that must hold whatever the seed: `better` has the smaller mean error.
struct Expected_order
{
  std::string table, better, worse;
};

const std::vector<Expected_order>& expected_orders()
{
  static const std::vector<Expected_order> orders = {{"8.3", "HRBF default, 2 rings", "HRBF r^5, 2 rings"},
                                                     {"8.3", "HRBF default, 2 rings", "jet d=4, 2 rings"},
                                                     {"8.3", "HRBF r^9, 4 rings", "HRBF r^5, 2 rings"},
                                                     {"8.3", "HRBF r^5, 2 rings", "Rusinkiewicz, 1 ring"},
                                                     {"8.3", "HRBF r^5, 2 rings", "jet d=2, 2 rings"},
                                                     {"8.4", "HRBF default, 2 rings", "HRBF r^3, 2 rings"},
                                                     {"8.4", "HRBF r^3, 2 rings", "Rusinkiewicz, 1 ring"},
                                                     {"8.5", "HRBF default, 2 rings", "HRBF r^3, 2 rings"},
                                                     {"8.5", "HRBF r^3, 2 rings", "Rusinkiewicz, 1 ring"},
                                                     {"8.7", "HRBF r^5, 4 rings", "HRBF r^3, 4 rings"},
                                                     {"8.7", "HRBF r^7, 4 rings", "HRBF r^5, 4 rings"},
                                                     {"8.12", "HRBF default, 2 rings", "HRBF r^3, 4 rings"},
                                                     {"8.12", "HRBF r^3, 2 rings", "Rusinkiewicz, 1 ring"},
                                                     {"8.14", "HRBF default, 2 rings", "HRBF r^3, 2 rings"},
                                                     {"8.14", "HRBF r^3, 2 rings", "Max, 1 ring"},
                                                     {"8.14", "Max, 1 ring", "average, 1 ring"}};
  return orders;
}

/// Prints the expected orders of the tables that were run. Returns whether all of them hold.
bool check_orders(const Report& report, const Options& options)
{
  bool all_hold = true;
  std::cout << "\n## Order of the estimators\n\nGeometric means over the surfaces of a table.\n\n"
            << "| table | better | mean | worse | mean | holds |\n|---|---|---:|---|---:|---|\n";
  for(const Expected_order& o : expected_orders())
    if(std::find(options.tables.begin(), options.tables.end(), o.table) != options.tables.end())
    {
      const double better = report.mean(o.table, o.better), worse = report.mean(o.table, o.worse);
      const bool holds = better < worse; // false for NaN as well
      all_hold = all_hold && holds;
      std::cout << "| " << o.table << " | " << o.better << " | " << number(better) << " | " << o.worse
                << " | " << number(worse) << " | " << (holds ? "yes" : "NO") << " |\n";
    }
  return all_hold;
}

const char* const help =
    "Errors of curvature estimators on surfaces with known curvature, next to the thesis's figures.\n\n"
    "  --tables 8.3,8.4,...  which of the tables 8.3, 8.4, 8.5, 8.7, 8.12, 8.14 (all)\n"
    "  --seeds 1,2,3         seeds of the random points (1,2,3); errors are pooled over them\n"
    "  --points N            points of an explicit surface (10000)\n"
    "  --grid N              samples per axis of marching cubes (128)\n"
    "  --quick               one seed, 1000 points, a grid of 24, unless given otherwise; fails if the "
    "estimators are\n"
    "                        not in the expected order\n"
    "  --all-seeds           all seeds for the thesis's fits over 4 rings, too, which else take the first "
    "one only\n"
    "  --plot PREFIX         writes a plot of each table to PREFIX_<table>.png\n"
    "  --csv FILE            writes the figures to FILE, those of normals to FILE with _normals in its name\n"
    "  --help                this text\n";

int run(int argc, char** argv)
{
  const benchmark_support::Command_line arguments(
      argc, argv, {"tables", "seeds", "points", "grid", "csv", "plot"}, {"quick", "all-seeds", "help"});
  if(arguments.has("help"))
  {
    std::cout << help;
    return 0;
  }
  const bool quick = arguments.has("quick");
  Options options;
  options.tables = arguments.list("tables", "8.3,8.4,8.5,8.7,8.12,8.14");
  options.seeds = arguments.numbers("seeds", quick ? "1" : "1,2,3");
  options.points = arguments.number("points", quick ? 1000 : 10000, 10);
  options.grid = arguments.number("grid", quick ? 24 : 128, 2);
  options.all_seeds = arguments.has("all-seeds");
  if(options.seeds.empty())
    throw std::invalid_argument("--seeds: one at least");
  for(const std::string& name : options.tables)
  {
    bool known = false;
    for(const Table& t : tables())
      known = known || t.number == name;
    if(!known)
      throw std::invalid_argument("--tables: no table " + name);
  }

  Report report(arguments.text("csv", ""), arguments.text("plot", ""));
  std::cout << "# Accuracy\n\n"
            << options.points << " random points per explicit surface and seed, " << options.seeds.size()
            << " seed(s), marching cubes on " << options.grid << "^3 samples.\n";
  std::map<std::string, Errors> done;
  for(const Table& table : tables())
    if(std::find(options.tables.begin(), options.tables.end(), table.number) != options.tables.end())
    {
      if(table.number == "8.14")
        run_normal_table(table, options, report);
      else
        run_curvature_table(table, options, done, report);
      std::cout.flush();
    }
  const bool ordered = check_orders(report, options);
  report.finish();
  return quick && !ordered ? 1 : 0;
}

} // namespace accuracy

int main(int argc, char** argv)
{
  try
  {
    return accuracy::run(argc, argv);
  }
  catch(const std::invalid_argument& error)
  {
    std::cerr << error.what() << "\n\n" << accuracy::help;
    return 2;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
