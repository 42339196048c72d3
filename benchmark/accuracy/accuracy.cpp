// Accuracy of curvature estimators on the surfaces of the thesis's experiments (chapter 8), next to the figures
// it prints. What the thesis calls MSE is reproduced as the mean absolute error of k_max plus that of k_min over all
// vertices, border included; squared errors are printed beside it.
#include "Command_line.h"
#include "parts/Report.h"
#include "parts/Sample.h"
#include "parts/Table.h"
#include "parts/estimators.h"
#include "parts/measure.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace accuracy {

struct Options
{
  std::vector<std::string> tables;
  std::vector<std::uint64_t> seeds;
  Resolution resolution;
  std::vector<std::string> only; ///< estimators of curvatures: parts of their names (all if empty)
  bool costly;    ///< run the costly estimators, too, and not only those that an expected order names
  bool all_seeds; ///< for the costly estimators, too
};

bool is_among(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_wanted(const std::string& label, const Options& options)
{
  return options.only.empty() ||
         std::any_of(options.only.begin(), options.only.end(),
                     [&](const std::string& part) { return label.find(part) != std::string::npos; });
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

/// Whether an order that is expected in this table names the estimator.
bool is_ordered(const std::string& table, const std::string& label)
{
  for(const Expected_order& o : expected_orders())
    if(o.table == table && (o.better == label || o.worse == label))
      return true;
  return false;
}

/// Prints the expected orders of the tables that were run. Returns whether all of them hold.
bool check_orders(const Report& report, const Options& options)
{
  bool all_hold = true;
  std::cout << "\n## Order of the estimators\n\nGeometric means over the surfaces of a table.\n\n"
            << "| table | better | mean | worse | mean | holds |\n|---|---|---:|---|---:|---|\n";
  for(const Expected_order& o : expected_orders())
    if(is_among(options.tables, o.table) && is_wanted(o.better, options) && is_wanted(o.worse, options))
    {
      const double better = report.mean(o.table, o.better), worse = report.mean(o.table, o.worse);
      const bool holds = better < worse; // false for NaN as well
      all_hold = all_hold && holds;
      std::cout << "| " << o.table << " | " << o.better << " | " << to_text(better) << " | " << o.worse
                << " | " << to_text(worse) << " | " << (holds ? "yes" : "NO") << " |\n";
    }
  return all_hold;
}

/// Calls `measure_all(sample, i, is_first)` for each seed on the i-th surface of the table.
template <typename Measure_all>
void for_each_sample(const Table& table, const Options& options, const Measure_all& measure_all)
{
  for(std::size_t i = 0; i < table.surfaces.size(); ++i)
  {
    std::vector<std::uint64_t> seeds = options.seeds;
    if(!depends_on_seed(table, table.surfaces[i]))
      seeds.resize(1);
    for(std::size_t s = 0; s < seeds.size(); ++s)
    {
      Sample sample = make_sample(table, table.surfaces[i], seeds[s], options.resolution);
      measure_all(sample, i, seeds[s], s == 0);
    }
  }
}

void run_estimators(const Table& table,
                    const Options& options,
                    std::map<std::string, Errors>& done,
                    Report& report)
{
  std::vector<const Estimator*> chosen;
  std::vector<Row<Errors>> rows;
  for(const Estimator& e : estimators())
    for(const Appearance& a : e.appearances)
      if(a.table == table.number() && is_wanted(e.label(), options) &&
         (options.costly || e.cost == Cost::LOW || is_ordered(table.name, e.label())))
      {
        chosen.push_back(&e);
        rows.push_back({e.name, e.neighbourhood, a.column, std::vector<Errors>(table.surfaces.size())});
      }

  for_each_sample(
      table, options,
      [&](Sample& sample, std::size_t i, std::uint64_t seed, bool is_first)
      {
        const Normal_map normals = make_normals(sample, table.normals);
        for(std::size_t r = 0; r < rows.size(); ++r)
        {
          if(!is_first && !options.all_seeds && chosen[r]->cost == Cost::HIGH)
            continue;
          // tables overlap: 8.7 has a column of 8.3, 8.6 is of the runs of 8.4
          const std::string key = rows[r].label() + "|" + table.surfaces[i] + "|" + std::to_string(seed) +
                                  "|" + to_string(table.normals) + "|" +
                                  to_string(tessellation(table, table.surfaces[i])) + "|" + noise_name(table);
          auto found = done.find(key);
          if(found == done.end())
            found = done.emplace(key, measure(*chosen[r], sample, normals, table.normals == Normals::EXACT))
                        .first;
          rows[r].errors[i].add(found->second);
        }
      });
  report.add(table, rows);
}

void run_normal_estimators(const Table& table, const Options& options, Report& report)
{
  std::vector<Row<Normal_errors>> rows;
  for(const Normal_estimator& e : normal_estimators())
    rows.push_back({e.name, e.neighbourhood, e.column, std::vector<Normal_errors>(table.surfaces.size())});
  for_each_sample(table, options,
                  [&](Sample& sample, std::size_t i, std::uint64_t, bool is_first)
                  {
                    for(std::size_t r = 0; r < rows.size(); ++r)
                      if(is_first || options.all_seeds || normal_estimators()[r].cost == Cost::LOW)
                        measure(normal_estimators()[r], sample, rows[r].errors[i]);
                  });
  report.add(table, rows);
}

/// What estimators of curvatures make of the normals of all estimators of normals, and of the exact ones.
void run_with_normals(const Table& table,
                      const std::vector<const Estimator*>& estimators,
                      const Options& options,
                      Report& report)
{
  std::vector<Row<Errors>> rows;
  const auto add_rows =
      [&](const std::string& name, const std::string& neighbourhood, const std::string& column)
  {
    for(const Estimator* e : estimators)
      rows.push_back({name, neighbourhood + "; " + e->neighbourhood, column,
                      std::vector<Errors>(table.surfaces.size())});
  };
  add_rows("exact", "none", "exact");
  for(const Normal_estimator& e : normal_estimators())
    add_rows(e.name, e.neighbourhood, e.column);
  for_each_sample(
      table, options,
      [&](Sample& sample, std::size_t i, std::uint64_t, bool is_first)
      {
        const auto measure_all = [&](std::size_t first_row, const Normal_map& normals, bool are_exact)
        {
          for(std::size_t e = 0; e < estimators.size(); ++e)
            rows[first_row + e].errors[i].add(measure(*estimators[e], sample, normals, are_exact));
        };
        measure_all(0, make_normals(sample, Normals::EXACT), true);
        for(std::size_t n = 0; n < normal_estimators().size(); ++n)
        {
          const Normal_estimator& of_normals = normal_estimators()[n];
          Normal_errors unused;
          if(is_first || options.all_seeds || of_normals.cost == Cost::LOW)
            measure_all((n + 1) * estimators.size(), measure(of_normals, sample, unused), false);
        }
      });
  report.add(table, rows);
}

const Estimator& estimator(const std::string& label)
{
  for(const Estimator& e : estimators())
    if(e.label() == label)
      return e;
  throw std::logic_error("no estimator " + label);
}

void run(const Table& table, const Options& options, std::map<std::string, Errors>& done, Report& report)
{
  switch(table.quantity)
  {
  case Quantity::PRINCIPAL_CURVATURES:
  case Quantity::GAUSSIAN_CURVATURE:
    return run_estimators(table, options, done, report);
  case Quantity::NORMALS:
    return run_normal_estimators(table, options, report);
  case Quantity::RUSINKIEWICZ:
    return run_with_normals(table, {&estimator("Rusinkiewicz, 1 ring")}, options, report);
  case Quantity::GOLDFEATHER_INTERRANTE:
    return run_with_normals(
        table, {&estimator("Goldfeather-Interrante, 1 ring"), &estimator("Goldfeather-Interrante, 2 rings")},
        options, report);
  }
}

const char* const help =
    "Errors of curvature estimators on surfaces with known curvature, next to the thesis's figures.\n\n"
    "  --tables 8.3,8.4,...  which tables (all; --list lists them)\n"
    "  --only TEXT,...       which estimators of curvatures: those with one of these in their names (all)\n"
    "  --seeds 1,2,3         seeds of the random points (1,2,3); errors are pooled over them\n"
    "  --points N            points of an explicit surface (10000)\n"
    "  --grid N              samples per axis of marching cubes (128)\n"
    "  --quick               one seed, 800 points, a grid of 24, the tables whose order is checked, unless\n"
    "                        given otherwise, and --no-costly; fails if the estimators are not in the order\n"
    "                        that is expected\n"
    "  --no-costly           leaves out what takes minutes a table, the thesis's fits over 4 rings and "
    "balls\n"
    "                        of 3 edges and more, but for those whose order is checked\n"
    "  --all-seeds           all seeds for the costly estimators, too, which else take the first one only\n"
    "  --plot PREFIX         writes a plot of each table to PREFIX_<table>.png\n"
    "  --csv FILE            writes the figures to FILE, those of normals to FILE with _normals in its name\n"
    "  --list                lists the tables\n"
    "  --help                this text\n";

int main(int argc, char** argv)
{
  const benchmark_support::Command_line arguments(
      argc, argv, {"tables", "only", "seeds", "points", "grid", "csv", "plot"},
      {"quick", "no-costly", "all-seeds", "list", "help"});
  if(arguments.has("help"))
  {
    std::cout << help;
    return 0;
  }
  if(arguments.has("list"))
  {
    for(const Table& t : tables())
      std::cout << t.name << ": " << t.title << "\n";
    return 0;
  }
  Options options;
  const bool quick = arguments.has("quick");
  options.costly = !quick && !arguments.has("no-costly");
  std::string names;
  for(const Table& t : tables())
    names += t.name + ",";
  options.tables = arguments.list("tables", quick ? "8.3,8.4,8.5,8.7,8.12,8.14" : names);
  options.only = arguments.list("only", "");
  options.seeds = arguments.numbers("seeds", quick ? "1" : "1,2,3");
  options.resolution.points = arguments.number("points", quick ? 800 : 10000, 10);
  options.resolution.grid = arguments.number("grid", quick ? 24 : 128, 2);
  options.all_seeds = arguments.has("all-seeds");
  if(options.seeds.empty())
    throw std::invalid_argument("--seeds: one at least");
  for(const std::string& name : options.tables)
    if(std::none_of(tables().begin(), tables().end(), [&](const Table& t) { return t.name == name; }))
      throw std::invalid_argument("--tables: no table " + name);

  Report report(arguments.text("csv", ""), arguments.text("plot", ""));
  std::cout << "# Accuracy\n\n"
            << options.resolution.points << " points per explicit surface and seed, " << options.seeds.size()
            << " seed(s), implicit surfaces on " << options.resolution.grid << "^3 samples.\n";
  std::map<std::string, Errors> done;
  for(const Table& table : tables())
    if(is_among(options.tables, table.name))
    {
      run(table, options, done, report);
      std::cout.flush();
    }
  if(!quick) // what the thesis prints is of other resolutions
    report.print_conclusions();
  const bool ordered = check_orders(report, options);
  report.finish();
  return quick && !ordered ? 1 : 0;
}

} // namespace accuracy

int main(int argc, char** argv)
{
  try
  {
    return accuracy::main(argc, argv);
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
