#include "report.h"

#include "fitted_exponent.h"
#include "goals.h"

#if __has_include(<support/Plot.h>) // what the examples share, where its dependencies are found
#include <support/Plot.h>
#define SHAPE_CHARACTERISTICS_SPEED_PLOTS
#endif

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <set>
#include <sstream>
#include <vector>

namespace speed {
namespace {

std::string number(double value, int digits = 3)
{
  if(!std::isfinite(value))
    return "–";
  std::ostringstream out;
  if(value != 0. && (std::abs(value) < 1e-2 || std::abs(value) >= 1e6))
    out << std::scientific << std::setprecision(std::min(digits, 3) - 1) << value;
  else if(std::abs(value) >= 100.)
    out << std::fixed << std::setprecision(0) << value;
  else
    out << std::setprecision(digits) << value;
  return out.str();
}

std::vector<const Figure*> of_group(const Session& session, const std::string& group)
{
  std::vector<const Figure*> result;
  for(const Figure& f : session.figures())
    if(f.group == group)
      result.push_back(&f);
  return result;
}

// Figures that make one curve: those with the same name, in their order.
struct Curve
{
  std::string name;
  std::vector<double> x, y;
};

std::vector<Curve> curves(const std::vector<const Figure*>& figures,
                          const std::function<std::string(const Figure&)>& name,
                          const std::function<double(const Figure&)>& x,
                          const std::function<double(const Figure&)>& y)
{
  std::vector<Curve> result;
  for(const Figure* f : figures)
    if(f->is_complete())
    {
      auto found =
          std::find_if(result.begin(), result.end(), [&](const Curve& c) { return c.name == name(*f); });
      if(found == result.end())
        found = result.insert(result.end(), {name(*f), {}, {}});
      found->x.push_back(x(*f));
      found->y.push_back(y(*f));
    }
  return result;
}

double time_per_vertex(const Figure& f)
{
  return f.microseconds_per_vertex();
}
double rate(const Figure& f)
{
  return f.vertices_per_second();
}
double vertices_of(const Figure& f)
{
  return double(f.vertices);
}
double size_of(const Figure& f)
{
  return f.size;
}
double rings_of(const Figure& f)
{
  return std::stod(f.neighbourhood); // "2 rings"
}

std::string estimator_of(const Figure& f)
{
  return f.estimator;
}

std::string threads_of(const Figure& f)
{
  return f.threads == 1 ? "1 thread" : std::to_string(f.threads) + " threads";
}

std::string curve_of_sizes(const Figure& f)
{
  return f.label() + (f.order == "curve" ? "" : ", " + f.order + " order") +
         (f.threads == 1 ? "" : ", " + threads_of(f));
}

std::vector<Curve> costs_by_rings(const Session& session)
{
  return curves(of_group(session, "rings"), estimator_of, rings_of, time_per_vertex);
}

// by the size of the neighbourhood, whether rings or nearest points
std::vector<Curve> costs_by_size(const Session& session)
{
  std::vector<const Figure*> figures = of_group(session, "rings");
  const std::vector<const Figure*> nearest = of_group(session, "nearest");
  figures.insert(figures.end(), nearest.begin(), nearest.end());
  return curves(figures, estimator_of, size_of, time_per_vertex);
}

std::vector<Curve> costs_by_number(const Session& session)
{
  return curves(of_group(session, "sizes"), curve_of_sizes, vertices_of, time_per_vertex);
}

void write_arithmetic(const Session& session, std::ostream& out)
{
  std::vector<const Figure*> figures = of_group(session, "peak");
  if(figures.empty())
    return;
  double peak = 0., product = 0.;
  for(const Figure* f : figures)
    (f->neighbourhood.empty() ? peak : product) =
        std::max(f->neighbourhood.empty() ? peak : product, f->gflops());
  out << "\n## Arithmetic of one core\n\n"
      << "The peak is that of multiplications and additions in registers alone.\n\n"
      << "| | | GFLOP/s | of the peak | of the matrix product |\n|---|---|---:|---:|---:|\n";
  const std::vector<const Figure*> factorizations = of_group(session, "factorization");
  figures.insert(figures.end(), factorizations.begin(), factorizations.end());
  for(const Figure* f : figures)
    out << "| " << f->estimator << " | " << f->neighbourhood << " | " << number(f->gflops()) << " | "
        << number(100. * f->gflops() / peak) << " % | " << number(100. * f->gflops() / product) << " % |\n";
}

void write_comparison(const Session& session, std::ostream& out)
{
  const std::vector<const Figure*> figures = of_group(session, "comparison");
  if(figures.empty())
    return;
  const Figure* jet = session.find("comparison", "CGAL jet d=4, 2 rings given");
  out << "\n## " << figures.front()->vertices << " random points of " << figures.front()->surface
      << ", one thread\n\nThe neighbours are searched within the time, unless they are \"given\". Errors: "
         "MAE(k_max) + "
         "MAE(k_min), all vertices.\n\n"
      << "| estimator | neighbourhood | vertices in it | µs/vertex | vertices/s | times faster than CGAL's "
         "jets | MAE "
         "| median | not estimated |\n|---|---|---:|---:|---:|---:|---:|---:|---:|\n";
  for(const Figure* f : figures)
    out << "| " << f->estimator << " | " << f->neighbourhood << " | " << number(f->size) << " | "
        << number(f->microseconds_per_vertex()) << " | " << number(f->vertices_per_second()) << " | "
        << number(jet == nullptr ? nan_value : jet->microseconds_per_vertex() / f->microseconds_per_vertex())
        << " | " << number(f->mae) << " | " << number(f->median) << " | " << f->not_estimated << " |\n";
}

void write_surfaces(const Session& session, std::ostream& out)
{
  const std::vector<const Figure*> figures = of_group(session, "surfaces");
  if(figures.empty())
    return;
  out << "\n## Other surfaces\n\n| surface | vertices | estimator | µs/vertex | MAE | median |\n"
         "|---|---:|---|---:|---:|---:|\n";
  for(const Figure* f : figures)
    out << "| " << f->surface << " | " << f->vertices << " | " << f->label() << " | "
        << number(f->microseconds_per_vertex()) << " | " << number(f->mae) << " | " << number(f->median)
        << " |\n";
}

void write_costs(const std::vector<Curve>& list,
                 const std::string& title,
                 const std::string& symbol,
                 std::ostream& out)
{
  if(list.empty())
    return;
  std::set<double> columns;
  for(const Curve& c : list)
    columns.insert(c.x.begin(), c.x.end());
  out << "\n## " << title << "\n\nµs/vertex, and the exponent p of the fitted power law " << symbol
      << "^p.\n\n| estimator";
  for(double x : columns)
    out << " | " << symbol << " = " << number(x);
  out << " | p |\n|---";
  for(std::size_t i = 0; i <= columns.size(); ++i)
    out << "|---:";
  out << "|\n";
  for(const Curve& c : list)
  {
    out << "| " << c.name;
    for(double x : columns)
    {
      const auto found = std::find(c.x.begin(), c.x.end(), x);
      out << " | " << (found == c.x.end() ? "–" : number(c.y[std::size_t(found - c.x.begin())]));
    }
    out << " | " << number(benchmark_support::fitted_exponent(c.x, c.y), 2) << " |\n";
  }
}

void write_goals(const Session& session, std::ostream& out)
{
  out << "\n## Goals\n\n| | measured | goal | |\n|---|---:|---:|---|\n";
  for(const Goal& g : goals(session))
    out << "| " << g.name << " | " << number(g.figure) << (std::isfinite(g.figure) ? g.unit : "") << " | "
        << (g.is_lower_bound ? "≥ " : "≤ ") << number(g.bound) << g.unit << " | "
        << (std::isfinite(g.figure) ? (g.is_met() ? "met" : "missed") : "not measured") << " |\n";
}

#ifdef SHAPE_CHARACTERISTICS_SPEED_PLOTS
void draw(const std::vector<Curve>& list, support::Plot plot, const std::string& file)
{
  if(list.empty())
    return;
  plot.x_logarithmic = plot.y_logarithmic = true;
  for(const Curve& c : list)
  {
    support::Plot_series series;
    series.name = c.name;
    series.x = c.x;
    series.y = c.y;
    plot.series.push_back(series);
  }
  support::write_png(file, plot.image(1500, 900));
}
#endif

} // namespace

void write_csv(const Session& session, std::ostream& out)
{
  const auto text = [](const std::string& s) { return '"' + s + '"'; };
  const auto value = [](double x)
  {
    std::ostringstream digits;
    if(std::isfinite(x))
      digits << std::setprecision(6) << x;
    return digits.str();
  };
  out << "group,estimator,neighbourhood,surface,order,threads,vertices,neighbourhood_size,seconds,us_per_"
         "vertex,"
         "vertices_per_s,gflops,mae,median,not_estimated\n";
  for(const Figure& f : session.figures())
  {
    const bool of_vertices = f.vertices != 0;
    out << f.group << ',' << text(f.estimator) << ',' << text(f.neighbourhood) << ',' << f.surface << ','
        << f.order << ',' << f.threads << ',' << f.vertices << ',' << value(f.size) << ',' << value(f.seconds)
        << ',' << value(of_vertices ? f.microseconds_per_vertex() : nan_value) << ','
        << value(of_vertices ? f.vertices_per_second() : nan_value) << ','
        << value(f.operations > 0. ? f.gflops() : nan_value) << ',' << value(f.mae) << ',' << value(f.median)
        << ',' << f.not_estimated << '\n';
  }
}

void write_markdown(const Session& session, std::ostream& out)
{
  out << "# Speed\n";
  write_arithmetic(session, out);
  write_comparison(session, out);
  write_surfaces(session, out);
  write_costs(costs_by_rings(session), "Cost against the number k of rings", "k", out);
  write_costs(costs_by_size(session), "Cost against the number m of vertices in a neighbourhood", "m", out);
  write_costs(costs_by_number(session), "Cost against the number n of vertices", "n", out);
  write_goals(session, out);
}

bool has_plots()
{
#ifdef SHAPE_CHARACTERISTICS_SPEED_PLOTS
  return true;
#else
  return false;
#endif
}

void draw_plots(const Session& session, const std::string& folder)
{
#ifdef SHAPE_CHARACTERISTICS_SPEED_PLOTS
  std::filesystem::create_directories(folder);
  const auto file = [&](const std::string& name)
  { return (std::filesystem::path(folder) / ("speed_" + name + ".png")).string(); };
  support::Plot plot;
  plot.y_label = "µs/vertex";
  plot.title = "Cost against the number of rings";
  plot.x_label = "rings";
  draw(costs_by_rings(session), plot, file("rings"));
  plot.title = "Cost against the size of the neighbourhood";
  plot.x_label = "vertices in a neighbourhood";
  draw(costs_by_size(session), plot, file("neighbourhood"));
  plot.title = "Cost against the number of vertices";
  plot.x_label = "vertices";
  draw(costs_by_number(session), plot, file("time_per_vertex"));

  plot.y_label = "vertices/s";
  std::set<unsigned int> numbers_of_threads;
  for(const Figure& f : session.figures())
    numbers_of_threads.insert(f.threads);
  for(unsigned int threads : numbers_of_threads)
  {
    std::vector<const Figure*> figures;
    for(const Figure* f : of_group(session, "sizes"))
      if(f->threads == threads && f->order == "curve")
        figures.push_back(f);
    plot.title = "Speed, " + (threads == 1 ? "one thread" : std::to_string(threads) + " threads");
    draw(curves(
             figures, [](const Figure& f) { return f.label(); }, vertices_of, rate),
         plot, file("threads_" + std::to_string(threads)));
  }
#else
  (void)session, (void)folder;
#endif
}

} // namespace speed
