#include "report.h"

#if __has_include(<support/Plot.h>) // what the examples share, where its dependencies are found
#include <support/Plot.h>
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_PLOTS
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace head_features {
namespace {

std::string text(double value, int digits = 2)
{
  if(std::isnan(value))
    return "-";
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

// "0.40 / 1.60 (23 of 24)": the numbers only if something is missing
std::string text(const Error_summary& s)
{
  if(s.all == 0)
    return "";
  std::string result = s.found > 0 ? text(s.median) + " / " + text(s.maximum) : "none";
  if(s.found != s.all)
    result += " (" + std::to_string(s.found) + " of " + std::to_string(s.all) + ")";
  return result;
}

std::string goal_text(const Feature_group& g)
{
  return g.maximum_goal > 0. ? text(g.median_goal, 1) + " / " + text(g.maximum_goal, 1) : "";
}

// bold where it is missed
std::string marked(const std::string& words, bool is_missed)
{
  return is_missed ? "**" + words + "**" : words;
}

bool misses(const Error_summary& s, const Feature_group& g)
{
  return s.all > 0 && g.maximum_goal > 0. &&
         !(s.found == s.all && s.median <= g.median_goal && s.maximum <= g.maximum_goal);
}

std::string head_row(const std::string& first, const std::vector<std::string>& columns)
{
  std::string result = "| " + first + " |", line = "\n|---|";
  for(const std::string& c : columns)
  {
    result += " " + c + " |";
    line += "---|";
  }
  return result + line + "\n";
}

std::vector<std::string> measured(const Measurements& measurements, const std::vector<std::string>& variants)
{
  std::vector<std::string> result;
  for(const std::string& v : variants)
    if(std::any_of(measurements.points.begin(), measurements.points.end(),
                   [&](const Point_error& e) { return e.variant == v; }))
      result.push_back(v);
  return result;
}

} // namespace

std::string markdown_errors(const Measurements& measurements,
                            const std::vector<std::string>& variants,
                            const std::string& mode,
                            bool with_goals)
{
  const std::vector<std::string> present = measured(measurements, variants);
  std::vector<std::string> columns = present;
  if(with_goals)
    columns.insert(columns.begin(), "goal");
  std::string out = head_row("points", columns);
  for(const Feature_group& g : feature_groups())
  {
    out += "| " + g.name + " |";
    if(with_goals)
      out += " " + goal_text(g) + " |";
    for(const std::string& v : present)
    {
      const Error_summary s = summary(measurements, v, mode, g.features);
      out += " " + marked(text(s), with_goals && misses(s, g)) + " |";
    }
    out += "\n";
  }
  return out + "\n";
}

std::string markdown_modes(const Measurements& measurements,
                           const std::string& variant,
                           const std::vector<std::string>& modes)
{
  std::string out = head_row("points", modes);
  for(const Feature_group& g : feature_groups())
  {
    out += "| " + g.name + " |";
    for(const std::string& mode : modes)
      out += " " + text(summary(measurements, variant, mode, g.features)) + " |";
    out += "\n";
  }
  return out + "\n";
}

std::string markdown_ratio(const Measurements& measurements,
                           const std::string& variant,
                           const std::string& mode,
                           const std::string& reference,
                           const std::string& mode_of_reference,
                           double goal)
{
  std::string out = head_row("points", {reference + ", " + mode_of_reference, variant + ", " + mode,
                                        "median, times", "maximum, times", "goal, times"});
  for(const Feature_group& g : feature_groups())
  {
    const Error_summary a = summary(measurements, reference, mode_of_reference, g.features),
                        b = summary(measurements, variant, mode, g.features);
    const double median = b.median / a.median, maximum = b.maximum / a.maximum;
    out += "| " + g.name + " | " + text(a) + " | " + text(b) + " | " +
           marked(text(median), !(median <= goal)) + " | " + marked(text(maximum), !(maximum <= goal)) +
           " | " + text(goal, 1) + " |\n";
  }
  return out + "\n";
}

std::string markdown_regions(const Measurements& measurements,
                             const std::vector<std::string>& variants,
                             const std::string& mode)
{
  std::string out = head_row("region", measured(measurements, variants));
  for(std::size_t i = 0; i < SC::number_of_head_regions; ++i)
  {
    const auto region = static_cast<SC::Head_region>(i);
    out += std::string("| ") + SC::to_string(region) + " |";
    for(const std::string& v : measured(measurements, variants))
    {
      std::vector<double> precision, recall;
      std::size_t all = 0;
      for(const Region_score& s : measurements.regions)
        if(s.variant == v && s.mode == mode && s.region == region)
        {
          ++all;
          if(s.is_found)
          {
            precision.push_back(s.precision);
            recall.push_back(s.recall);
          }
        }
      if(all == 0)
      {
        out += " |";
        continue;
      }
      if(precision.empty())
      {
        out += " none |";
        continue;
      }
      const bool is_ear = region == SC::Head_region::LEFT_EAR || region == SC::Head_region::RIGHT_EAR;
      const double least_p = *std::min_element(precision.begin(), precision.end()),
                   least_r = *std::min_element(recall.begin(), recall.end());
      out += " " +
             marked(text(summary(precision).median) + " (" + text(least_p) + "), " +
                        text(summary(recall).median) + " (" + text(least_r) + ")",
                    is_ear && (least_p < .9 || least_r < .9)) +
             (precision.size() < all
                  ? " (" + std::to_string(precision.size()) + " of " + std::to_string(all) + ")"
                  : "") +
             " |";
    }
    out += "\n";
  }
  return out + "\n";
}

std::string markdown_tessellations(const std::vector<Tessellation_row>& rows)
{
  std::string out =
      head_row("head and mode", {"points on both", "median", "maximum", "above 0.3 %", "on one alone"});
  for(const Tessellation_row& row : rows)
  {
    const Error_summary s = summary(row.distances);
    const auto listed = [](const std::vector<std::string>& names)
    {
      std::string all;
      for(const std::string& name : names)
        all += (all.empty() ? "" : ", ") + name;
      return all;
    };
    out += "| " + row.name + " | " + std::to_string(s.all) + " | " + text(s.median, 3) + " | " +
           marked(text(s.maximum, 3), !(s.maximum <= .3)) + " | " + listed(row.far) + " | " +
           listed(row.only_on_one) + " |\n";
  }
  return out + "\n";
}

std::string markdown_shapes(const std::vector<Shape_row>& rows)
{
  std::string out = head_row("shape", {"verdict", "why", "confidence", "points found", "remark"});
  for(const Shape_row& row : rows)
    out += "| " + row.name + " | " + row.verdict + " | " + row.obstacle + " | " + text(row.confidence) +
           " | " + std::to_string(row.found) + " | " + row.remark + " |\n";
  return out + "\n";
}

std::string markdown_deformations(const std::vector<Deformation_difference>& differences)
{
  std::string out = head_row(
      "deformation", {"heads", "largest motion (median)", "same vertex, farthest (median / max)",
                      "surface distance, mean (median / max)", "surface distance, farthest (median / max)"});
  for(std::size_t i = 0; i < SC::number_of_head_expressions; ++i)
  {
    const auto expression = static_cast<SC::Head_expression>(i);
    std::vector<double> motion, vertex, mean, farthest;
    std::size_t all = 0;
    for(const Deformation_difference& d : differences)
      if(d.expression == expression)
      {
        ++all;
        if(!d.is_deformed)
          continue;
        motion.push_back(d.largest_motion);
        vertex.push_back(d.largest_difference);
        mean.push_back(d.mean_distance);
        farthest.push_back(d.largest_distance);
      }
    if(all == 0)
      continue;
    const auto both = [](const std::vector<double>& x)
    { return text(summary(x).median) + " / " + text(summary(x).maximum); };
    out += std::string("| ") + SC::to_string(expression) + " | " + std::to_string(motion.size()) + " of " +
           std::to_string(all) + " | " + text(summary(motion).median) + " | " + both(vertex) + " | " +
           both(mean) + " | " + both(farthest) + " |\n";
  }
  return out + "\n";
}

void write_csv(const std::string& file, const Measurements& measurements)
{
  std::ofstream out(file);
  out << "kind,name,variant,mode,feature,found,error_percent,confidence,precision,recall\n";
  for(const Point_error& e : measurements.points)
  {
    out << "point," << e.name << ',' << e.variant << ',' << e.mode << ',' << SC::to_string(e.feature) << ','
        << e.is_found << ',';
    if(e.is_found)
      out << e.error << ',' << e.confidence;
    else
      out << ',';
    out << ",,\n";
  }
  for(const Region_score& s : measurements.regions)
  {
    out << "region," << s.name << ',' << s.variant << ',' << s.mode << ',' << SC::to_string(s.region) << ','
        << s.is_found << ",,,";
    if(s.is_found)
      out << s.precision << ',' << s.recall;
    else
      out << ',';
    out << '\n';
  }
  if(!out)
    throw std::runtime_error("can't write " + file);
}

#ifdef SHAPE_CHARACTERISTICS_HEAD_FEATURES_PLOTS
bool write_plot(const std::string& file,
                const Measurements& measurements,
                const std::vector<std::string>& variants,
                const std::vector<std::string>& modes)
{
  support::Plot plot;
  plot.title = "Feature points of heads, by their errors";
  plot.x_label = "error in percent of the head's height";
  plot.y_label = "points with at most this error, in percent";
  plot.y_from_zero = true;
  for(const std::string& mode : modes)
    for(const std::string& v : measured(measurements, variants))
    {
      std::vector<double> errors;
      std::size_t all = 0;
      for(const Point_error& e : measurements.points)
        if(e.variant == v && e.mode == mode)
        {
          ++all;
          if(e.is_found)
            errors.push_back(e.error);
        }
      if(all == 0 || (mode == "thesis" && v != "crop"))
        continue;
      std::sort(errors.begin(), errors.end());
      support::Plot_series series;
      series.name = mode == "default" ? v : v + ", " + mode;
      series.markers = false;
      series.dashed = series.grey = mode == "thesis";
      constexpr double end = 6.; // what is farther off is beyond the picture
      series.x.push_back(0.);
      series.y.push_back(0.);
      for(std::size_t k = 0; k < errors.size() && errors[k] <= end; ++k)
      {
        series.x.push_back(errors[k]);
        series.y.push_back(100. * double(k + 1) / double(all));
      }
      series.x.push_back(end);
      series.y.push_back(series.y.back());
      plot.series.push_back(series);
    }
  support::write_png(file, plot.image());
  return true;
}
#else
bool write_plot(const std::string&,
                const Measurements&,
                const std::vector<std::string>&,
                const std::vector<std::string>&)
{
  return false;
}
#endif

} // namespace head_features
