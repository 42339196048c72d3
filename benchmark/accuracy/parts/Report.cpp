#include "Report.h"

#include "printed_figures.h"

#if __has_include(<support/Plot.h>) // what the examples share, where its dependencies are found
#include <support/Plot.h>
#define SHAPE_CHARACTERISTICS_ACCURACY_PLOTS
#endif

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

namespace accuracy {

namespace {

using benchmark_support::Error_statistics;

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

// the figure that the thesis prints in `column` for the i-th surface of a table, or NaN
double printed(const Table& table, const std::string& column, std::size_t i)
{
  const Printed_column* c = column.empty() ? nullptr : printed_column(table.name, column);
  return c == nullptr ? nan_value : c->figures.at(i);
}

std::string cell_text(double value, double figure, std::size_t flagged)
{
  std::ostringstream out;
  out << to_text(value);
  if(std::isfinite(figure))
    out << " (" << figure << ")";
  if(flagged != 0)
    out << " [" << flagged << " flagged]";
  return out.str();
}

std::string csv_text(double value)
{
  if(!std::isfinite(value))
    return "";
  std::ostringstream out;
  out << std::setprecision(8) << value;
  return out.str();
}

// names have commas
std::string csv_text(const std::string& name)
{
  return '"' + name + '"';
}

void print_heading(const std::string& what, const Table& table, bool seconds = false)
{
  std::cout << "\n" << what << "\n\n| estimator";
  for(const std::string& surface : table.surfaces)
    std::cout << " | " << surface;
  std::cout << (seconds ? " | seconds |\n|---|---:" : " |\n|---");
  for(std::size_t i = 0; i < table.surfaces.size(); ++i)
    std::cout << "|---:";
  std::cout << "|\n";
}

template <typename Rows, typename Value>
void print_body(const Rows& rows, const Value& value)
{
  for(const auto& row : rows)
  {
    std::cout << "| " << row.label();
    for(const auto& errors : row.errors)
      std::cout << " | " << to_text(value(errors));
    std::cout << " |\n";
  }
}

// what the thesis prints for methods that are not among the rows
template <typename Rows>
std::vector<const Printed_column*> others(const Table& table, const Rows& rows)
{
  std::vector<const Printed_column*> result;
  for(const Printed_column& c : printed_figures())
    if(c.table == table.name &&
       std::none_of(rows.begin(), rows.end(), [&](const auto& row) { return row.column == c.column; }))
      result.push_back(&c);
  return result;
}

template <typename Rows>
void print_others(const Table& table, const Rows& rows, const char* end)
{
  for(const Printed_column* c : others(table, rows))
  {
    std::cout << "| " << c->column << " of the thesis";
    for(double figure : c->figures)
      std::cout << " | (" << figure << ")";
    std::cout << end << "\n";
  }
}

} // namespace

std::string to_text(double value)
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

Report::Report(const std::string& csv, const std::string& plot) : m_plot(plot)
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
  m_normals_csv << "table,surface,tessellation,estimator,neighbourhood,mean_error,vertices,flagged,printed\n";
}

void Report::add(const Table& table, const std::vector<Row<Errors>>& rows)
{
  const bool gaussian = table.quantity == Quantity::GAUSSIAN_CURVATURE;
  const auto all = [&](const Errors& e) -> const Error_statistics&
  { return gaussian ? e.gaussian_all : e.all; };
  const auto inner = [&](const Errors& e) -> const Error_statistics&
  { return gaussian ? e.gaussian_inner : e.inner; };
  const std::string mean = gaussian ? "MAE(K)" : "MAE(k_max) + MAE(k_min)";

  std::cout << "\n## Table " << table.name << ": " << table.title << "\n";
  print_heading(mean + ", all vertices; in parentheses what the thesis prints", table, true);
  std::vector<Line> lines;
  for(const Row<Errors>& row : rows)
  {
    lines.emplace_back(row.label(), std::vector<double>());
    double seconds = 0.;
    std::cout << "| " << row.label();
    for(std::size_t i = 0; i < row.errors.size(); ++i)
    {
      const Error_statistics& e = all(row.errors[i]);
      const double figure = printed(table, row.column, i);
      std::cout << " | " << cell_text(e.mae(), figure, e.flagged());
      seconds += row.errors[i].seconds;
      lines.back().second.push_back(e.mae());
      m_cells.push_back({&table, i, row.label(), row.column, e.mae(), figure, e.flagged()});
      if(m_csv.is_open())
        for(const bool all_vertices : {true, false})
        {
          const Error_statistics& s = all_vertices ? e : inner(row.errors[i]);
          m_csv << table.name << (all_vertices ? "" : " inner") << ',' << table.surfaces[i] << ','
                << to_string(tessellation(table, table.surfaces[i])) << ',' << to_string(table.normals) << ','
                << noise_name(table) << ',' << csv_text(row.name) << ',' << csv_text(row.neighbourhood) << ','
                << csv_text(s.mae_k_max()) << ',' << csv_text(s.mae_k_min()) << ',' << csv_text(s.mse_k_max())
                << ',' << csv_text(s.mse_k_min()) << ',' << csv_text(s.median()) << ',' << s.vertices() << ','
                << s.flagged() << ',' << csv_text(all_vertices ? figure : nan_value) << '\n';
        }
    }
    std::cout << " | " << std::fixed << std::setprecision(2) << seconds << std::defaultfloat << " |\n";
  }
  print_others(table, rows, " | |");
  plot(table, gaussian ? "MAE(K)" : "MAE(k_{max}) + MAE(k_{min})", lines, 1.);

  print_heading("The same over vertices farther than 4 rings from the border", table);
  print_body(rows, [&](const Errors& e) { return inner(e).mae(); });
  print_heading(gaussian ? "MSE(K), all vertices" : "MSE(k_max) + MSE(k_min), all vertices", table);
  print_body(rows, [&](const Errors& e) { return all(e).mse(); });
  print_heading(gaussian ? "Median of |error of K|, all vertices"
                         : "Median of |error of k_max| + |error of k_min|, all vertices",
                table);
  print_body(rows, [&](const Errors& e) { return all(e).median(); });
}

void Report::add(const Table& table, const std::vector<Row<Normal_errors>>& rows)
{
  const double unit = 1e-4; // of the thesis's figures
  std::cout << "\n## Table " << table.name << ": " << table.title << "\n";
  print_heading("Mean of 1 - n . n_estimated in 1e-4, all vertices; in parentheses what the thesis prints",
                table);
  std::vector<Line> lines;
  for(const Row<Normal_errors>& row : rows)
  {
    lines.emplace_back(row.label(), std::vector<double>());
    std::cout << "| " << row.label();
    for(std::size_t i = 0; i < row.errors.size(); ++i)
    {
      const Normal_errors& e = row.errors[i];
      const double figure = printed(table, row.column, i);
      std::cout << " | " << cell_text(e.mean_all() / unit, figure, e.flagged);
      lines.back().second.push_back(e.mean_all());
      m_cells.push_back({&table, i, row.label(), row.column, e.mean_all() / unit, figure, e.flagged});
      if(m_normals_csv.is_open())
        m_normals_csv << table.name << ',' << table.surfaces[i] << ','
                      << to_string(tessellation(table, table.surfaces[i])) << ',' << csv_text(row.name) << ','
                      << csv_text(row.neighbourhood) << ',' << csv_text(e.mean_all()) << ',' << e.all << ','
                      << e.flagged << ',' << csv_text(unit * figure) << '\n';
    }
    std::cout << " |\n";
  }
  print_others(table, rows, " |");
  plot(table, "mean of 1 - n . n_{estimated}", lines, unit);
  print_heading("The same over vertices farther than 4 rings from the border", table);
  print_body(rows, [&](const Normal_errors& e) { return e.mean_inner() / unit; });
}

double Report::mean(const std::string& table, const std::string& label) const
{
  double sum = 0.;
  std::size_t count = 0;
  for(const Cell& c : m_cells)
    if(c.table->name == table && c.label == label)
    {
      sum += std::log(c.error);
      ++count;
    }
  return count == 0 ? nan_value : std::exp(sum / double(count));
}

void Report::print_conclusions() const
{
  print_against_the_thesis();
  print_best("HRBF default", false);
  print_best("adaptive", true);
  print_ranking();
}

// Where several of our rows bear the name of a printed column, the thesis doesn't say which neighborhood it took: the nearest
// to what it prints counts.
void Report::print_against_the_thesis() const
{
  std::cout << "\n## Measured / printed\n\nFor each column of the thesis, the smallest quotient of those "
               "rows that bear its "
               "name. Above 1.25 in bold.\n\n| table | column | quotients by surface |\n|---|---|---|\n";
  std::size_t count = 0, missed = 0;
  for(const Printed_column& c : printed_figures())
  {
    std::vector<double> quotients(c.figures.size(), nan_value);
    for(const Cell& cell : m_cells)
      if(cell.table->name == c.table && cell.column == c.column)
        quotients[cell.surface] = std::fmin(quotients[cell.surface], cell.error / cell.printed);
    if(std::none_of(quotients.begin(), quotients.end(), [](double q) { return std::isfinite(q); }))
      continue;
    std::cout << "| " << c.table << " | " << c.column << " |";
    for(double q : quotients)
    {
      const bool is_missed = !(q <= 1.25);
      ++count;
      missed += is_missed;
      std::cout << (is_missed ? " **" : " ") << to_text(q) << (is_missed ? "**" : "");
    }
    std::cout << " |\n";
  }
  std::cout << "\n" << count - missed << " of " << count << " figures at most 25 % above what is printed.\n";
}

// The best row whose label begins with `ours` against the best of the others. Those of the other kinds that are ours to choose
// from (`others_count`: the default fits) are left out where the fits themselves are judged.
void Report::print_best(const std::string& ours, bool others_count) const
{
  const auto begins = [](const std::string& text, const std::string& start)
  { return text.compare(0, start.size(), start) == 0; };
  const auto is_other = [&](const Cell& c)
  {
    return !begins(c.label, ours) && !begins(c.label, "adaptive") &&
           (others_count || !begins(c.label, "HRBF default"));
  };
  if(std::none_of(m_cells.begin(), m_cells.end(), [&](const Cell& c) { return begins(c.label, ours); }))
    return;

  std::cout << "\n## " << ours << " against the best of the others\n\n| table | surface | " << ours
            << " | error | best other | error | quotient |\n|---|---|---|---:|---|---:|---:|\n";
  std::size_t count = 0, won = 0, close = 0;
  double sum = 0.;
  for(const Table& table : tables())
  {
    const bool is_compared = table.quantity == Quantity::PRINCIPAL_CURVATURES ||
                             table.quantity == Quantity::GAUSSIAN_CURVATURE ||
                             table.quantity == Quantity::NORMALS;
    for(std::size_t i = 0; i < table.surfaces.size() && is_compared; ++i)
    {
      const Cell *best = nullptr, *other = nullptr;
      for(const Cell& c : m_cells)
        if(c.table == &table && c.surface == i && std::isfinite(c.error))
        {
          if(begins(c.label, ours) && (best == nullptr || c.error < best->error))
            best = &c;
          if(is_other(c) && (other == nullptr || c.error < other->error))
            other = &c;
        }
      if(best == nullptr || other == nullptr)
        continue;
      const double quotient = best->error / other->error;
      ++count;
      won += quotient <= 1.;
      close += quotient <= 1.1;
      sum += std::log(quotient);
      std::cout << "| " << table.name << " | " << table.surfaces[i] << " | " << best->label << " | "
                << to_text(best->error) << " | " << other->label << " | " << to_text(other->error) << " | "
                << (quotient <= 1. ? "" : "**") << to_text(quotient) << (quotient <= 1. ? "" : "**")
                << " |\n";
    }
  }
  std::cout << "\n"
            << won << " of " << count << " cells won, " << close
            << " within 10 %; geometric mean of the quotients " << to_text(std::exp(sum / double(count)))
            << ".\n";
}

// Errors of different surfaces can't be added: each is divided by the best one in its cell.
void Report::print_ranking() const
{
  std::map<std::pair<const Table*, std::size_t>, double> best;
  for(const Cell& c : m_cells)
    if(c.table->quantity == Quantity::PRINCIPAL_CURVATURES && std::isfinite(c.error))
    {
      const auto inserted = best.insert({{c.table, c.surface}, c.error});
      inserted.first->second = std::min(inserted.first->second, c.error);
    }
  struct Quotients
  {
    double sum_of_logarithms = 0., worst = 0.;
    std::size_t count = 0;
  };
  std::map<std::string, Quotients> of_estimators;
  for(const Cell& c : m_cells)
  {
    const auto found = best.find({c.table, c.surface});
    if(found == best.end() || !(found->second > 0.) || !std::isfinite(c.error))
      continue;
    const double quotient = c.error / found->second;
    Quotients& q = of_estimators[c.label];
    q.sum_of_logarithms += std::log(quotient);
    q.worst = std::max(q.worst, quotient);
    ++q.count;
  }
  std::vector<std::pair<double, std::string>> ranking;
  for(const auto& [label, q] : of_estimators)
    if(q.count == best.size())
      ranking.emplace_back(std::exp(q.sum_of_logarithms / double(q.count)), label);
  if(ranking.size() < 2)
    return;
  std::sort(ranking.begin(), ranking.end());
  std::cout << "\n## Error / smallest error in the cell\n\nOver the " << best.size()
            << " cells of all tables, of the estimators that take part in all.\n\n"
            << "| estimator | geometric mean | worst |\n|---|---:|---:|\n";
  for(const auto& [mean, label] : ranking)
    std::cout << "| " << label << " | " << to_text(mean) << " | " << to_text(of_estimators[label].worst)
              << " |\n";
}

void Report::finish()
{
  for(std::ofstream* file : {&m_csv, &m_normals_csv})
    if(file->is_open() && !file->flush())
      throw std::runtime_error("cannot write the CSV files");
}

// Every estimator is a line over the surfaces; what the thesis prints is grey.
void Report::plot(const Table& table,
                  const std::string& y_label,
                  const std::vector<Line>& lines,
                  double unit) const
{
  if(m_plot.empty())
    return;
#ifdef SHAPE_CHARACTERISTICS_ACCURACY_PLOTS
  support::Plot plot;
  plot.title = "Table " + table.name + ": " + table.title;
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
    if(c.table == table.name)
    {
      std::vector<double> values;
      for(double figure : c.figures)
        values.push_back(unit * figure);
      add(c.column + " of the thesis", values, true);
    }
  support::write_png(m_plot + "_" + table.name + ".png", plot.image());
#else
  (void)table, (void)y_label, (void)lines, (void)unit;
#endif
}

} // namespace accuracy
