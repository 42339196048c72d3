#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_REPORT_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_REPORT_H

#include "Table.h"
#include "measure.h"

#include <cstddef>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace accuracy {

/// A row of a table: the errors of an estimator on each surface.
template <typename Errors_on_a_surface>
struct Row
{
  std::string name, neighbourhood;
  std::string column; ///< under which the thesis prints it, or empty
  std::vector<Errors_on_a_surface> errors;

  std::string label() const { return name + ", " + neighbourhood; }
};

/// Prints Markdown, writes CSV and plots, and remembers all figures for what is concluded at the end.
class Report
{
public:
  /// Writes CSV and plots to these files if their names are not empty.
  /// \throws std::runtime_error if a file can't be written
  Report(const std::string& csv, const std::string& plot);

  void add(const Table& table, const std::vector<Row<Errors>>& rows);
  void add(const Table& table, const std::vector<Row<Normal_errors>>& rows);

  /// geometric mean of the errors of an estimator on the surfaces of a table, so that no surface decides alone; NaN if it
  /// was not run
  double mean(const std::string& table, const std::string& label) const;

  /// Prints how the figures compare with those that the thesis prints, and which estimator is the best in each cell.
  void print_conclusions() const;

  /// \throws std::runtime_error if the CSV files could not be written
  void finish();

private:
  struct Cell
  {
    const Table* table;
    std::size_t surface;
    std::string label, column;
    double error, printed;
    std::size_t flagged;
  };
  using Line = std::pair<std::string, std::vector<double>>;

  void print_against_the_thesis() const;
  void print_best(const std::string& ours, bool others_count) const;
  void print_ranking() const;
  void
  plot(const Table& table, const std::string& y_label, const std::vector<Line>& lines, double unit) const;

  std::string m_plot;
  std::ofstream m_csv, m_normals_csv;
  std::vector<Cell> m_cells;
};

/// A figure with three digits.
std::string to_text(double value);

} // namespace accuracy

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_REPORT_H
