// Calibrates adaptive_curvatures() on surfaces whose curvature is known, and compares it with the estimators among
// which it chooses, and with others: on the thesis's surfaces and on further ones, none of which it was calibrated on.
#include "Command_line.h"
#include "parts/Calibration_row.h"
#include "parts/Row.h"
#include "parts/Score_learner.h"

#include <Shape_characteristics/curvature/Adaptive_estimator_choice.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace adaptive {
namespace {

std::string number(double value)
{
  std::ostringstream out;
  out.precision(3);
  out << value;
  return out.str();
}

std::string candidate_name(std::size_t c)
{
  return to_string(Shape_characteristics::Adaptive_estimator_choice(c));
}

/// Compares adaptive_curvatures() with single estimators, row by row.
class Comparison
{
public:
  /// \param shared whether rows say how it fares with shared fits
  Comparison(const std::string& title, bool shared) : m_shared(shared)
  {
    std::cout
        << "\n## " << title
        << "\n\nMAE(k_max) + MAE(k_min), all vertices. Best: of the estimators that it blends, and of the "
           "others.\n\n"
           "| surface | given | adaptive | best | | ratio | best other | | ratio | seconds |"
        << (shared ? " with shared fits | seconds |" : "")
        << "\n|---|---|---:|---:|---|---:|---:|---|---:|---:|" << (shared ? "---:|---:|" : "") << "\n";
  }

  void add(const Row& row)
  {
    std::vector<std::pair<std::string, double> > singles = row.others;
    const std::pair<std::string, double> best_other = best_of(singles);
    m_missed_others += row.adaptive_error > 1.1 * best_other.second;
    for(std::size_t c = 0; c < row.mean_errors.size(); ++c)
      singles.emplace_back(candidate_name(c), row.mean_errors[c]);
    const std::pair<std::string, double> best = best_of(singles);
    const double ratio = row.adaptive_error / best.second;
    std::cout << "| " << row.surface << " | " << row.conditions.name() << " | " << number(row.adaptive_error)
              << " | " << number(best.second) << " | " << best.first << " | " << number(ratio) << " | "
              << number(best_other.second) << " | " << best_other.first << " | "
              << number(row.adaptive_error / best_other.second) << " | " << number(row.adaptive_seconds)
              << " |";
    if(m_shared)
    {
      std::cout << " " << number(row.shared_error) << " | " << number(row.shared_seconds) << " |";
      m_sum_of_shared_errors += std::log(row.shared_error / row.adaptive_error);
      m_sum_of_shared_times += std::log(row.shared_seconds / row.adaptive_seconds);
    }
    std::cout << "\n";
    std::cout.flush();
    ++m_rows;
    m_missed += ratio > 1.1;
    m_sum += std::log(row.adaptive_error);
    m_ratios.push_back(ratio);
    for(const auto& [name, error] : singles)
      m_sums[name] += std::log(error);
  }

  void finish()
  {
    std::sort(m_ratios.begin(), m_ratios.end());
    std::cout << "\nRows: " << m_rows << ", more than 10 % worse than the best single one: " << m_missed
              << ", than the best of those that it doesn't blend: " << m_missed_others;
    if(!m_ratios.empty())
      std::cout << ", median ratio " << number(m_ratios[m_ratios.size() / 2]) << ", largest "
                << number(m_ratios.back());
    if(m_shared)
      std::cout << "\n\nWith shared fits (geometric means): error " << number(mean(m_sum_of_shared_errors))
                << ", time " << number(mean(m_sum_of_shared_times)) << " of that without";
    std::cout << "\n\n| estimator | mean error over the rows (geometric), in that of the adaptive one "
                 "|\n|---|---:|\n";
    std::vector<std::pair<double, std::string> > order;
    for(const auto& [name, sum] : m_sums)
      order.emplace_back(mean(sum - m_sum), name);
    std::sort(order.begin(), order.end());
    for(const auto& [ratio, name] : order)
      std::cout << "| " << name << " | " << number(ratio) << " |\n";
    m_is_best = order.empty() || order.front().first > 1.;
  }

  /// whether no single estimator has a smaller mean over the rows
  bool is_best() const { return m_is_best; }

private:
  static std::pair<std::string, double> best_of(const std::vector<std::pair<std::string, double> >& singles)
  {
    std::pair<std::string, double> best("none", std::numeric_limits<double>::infinity());
    for(const auto& single : singles)
      if(single.second < best.second)
        best = single;
    return best;
  }

  /// of logarithms over the rows
  double mean(double sum_of_logarithms) const { return std::exp(sum_of_logarithms / double(m_rows)); }

  bool m_shared;
  std::size_t m_rows = 0, m_missed = 0, m_missed_others = 0;
  double m_sum = 0., m_sum_of_shared_errors = 0., m_sum_of_shared_times = 0.;
  std::vector<double> m_ratios;
  std::map<std::string, double> m_sums;
  bool m_is_best = false;
};

std::vector<Calibration_row> measure_rows(double scale)
{
  constexpr std::size_t vertices = 100;
  Measurements measurements;
  measurements.records = true;
  const std::vector<Experiment> list = experiments(Purpose::CALIBRATION, scale, "");
  std::vector<Calibration_row> rows(list.size());
  Shape_characteristics::for_each_sample<CGAL::Parallel_if_available_tag,
                                         Shape_characteristics::No_workspace>(
      list.size(),
      [&](const std::size_t k, Shape_characteristics::No_workspace&)
      { rows[k] = calibration_row(measure(list[k], 1, measurements), vertices); },
      [&](const double advancement)
      {
        const auto measured = std::size_t(std::lround(advancement * double(list.size())));
        if(measured % 100 == 0 || measured == list.size())
          std::cout << measured << " of " << list.size() << " rows measured" << std::endl;
        return true;
      },
      1);
  return rows;
}

// `rows_file`: none, if it is empty
void calibrate(const std::string& file, const std::string& rows_file, double scale)
{
  std::vector<Calibration_row> rows;
  if(!rows_file.empty())
    rows = read_rows(rows_file);
  if(rows.empty())
  {
    rows = measure_rows(scale);
    if(!rows_file.empty())
      write_rows(rows_file, rows);
  }
  const Scores scores = learn_scores(rows, std::cout);
  std::ofstream out(file);
  out << to_header(scores);
  if(!out.flush())
    throw std::runtime_error("cannot write " + file);
}

const char* const help =
    "Errors of adaptive_curvatures() next to those of single estimators.\n\n"
    "  --purpose P        which surfaces: tables (the thesis's), shapes (sphere, cylinder ...), calibration, "
    "or\n"
    "                     validation (validation)\n"
    "  --only TEXT        only surfaces with this in their name\n"
    "  --scale S          of the number of vertices (1)\n"
    "  --seed N           of random points and noise (1)\n"
    "  --quick            few vertices of two surfaces; fails if a single estimator has a smaller mean over "
    "the rows\n"
    "  --shared           with shared fits, too\n"
    "  --calibrate FILE   makes the constants of the library instead, and writes them as a header\n"
    "  --rows FILE        with --calibrate: what is measured for it, which takes longest, is read from the\n"
    "                     file if there is one, and written to it if not\n"
    "  --help             this text\n";

int run(int argc, char** argv)
{
  const benchmark_support::Command_line arguments(
      argc, argv, {"purpose", "only", "scale", "seed", "calibrate", "rows"}, {"quick", "shared", "help"});
  if(arguments.has("help"))
  {
    std::cout << help;
    return 0;
  }
  const bool quick = arguments.has("quick");
  double scale = 0.;
  std::istringstream(arguments.text("scale", quick ? "0.05" : "1")) >> scale;
  if(!(scale > 0. && scale <= 100.))
    throw std::invalid_argument("--scale must be a positive number");
  if(arguments.has("rows") && !arguments.has("calibrate"))
    throw std::invalid_argument("--rows goes with --calibrate");
  if(arguments.has("calibrate"))
  {
    calibrate(arguments.text("calibrate", ""), arguments.text("rows", ""), scale);
    return 0;
  }
  const std::string name = arguments.text("purpose", "validation");
  const std::map<std::string, Purpose> purposes = {{"tables", Purpose::TABLES},
                                                   {"validation", Purpose::VALIDATION},
                                                   {"shapes", Purpose::SHAPES},
                                                   {"calibration", Purpose::CALIBRATION}};
  if(purposes.count(name) == 0)
    throw std::invalid_argument("--purpose: no " + name);
  Measurements measurements;
  measurements.records = measurements.adaptive = measurements.others = true;
  measurements.shared = arguments.has("shared");
  Comparison comparison(name, measurements.shared);
  for(const Experiment& experiment :
      experiments(purposes.at(name), scale, arguments.text("only", quick ? "monkey" : "")))
    comparison.add(measure(experiment, arguments.number("seed", 1), measurements));
  comparison.finish();
  return quick && !comparison.is_best() ? 1 : 0;
}

} // namespace
} // namespace adaptive

int main(int argc, char** argv)
{
  try
  {
    return adaptive::run(argc, argv);
  }
  catch(const std::invalid_argument& error)
  {
    std::cerr << error.what() << "\n\n" << adaptive::help;
    return 2;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
