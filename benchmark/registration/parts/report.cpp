#include "report.h"

#include "variants.h"

#include <Shape_characteristics/registration/Registration_verdict.h>

#if __has_include(<support/Plot.h>) // what the examples share, where its dependencies are found
#include <support/Plot.h>
#define SHAPE_CHARACTERISTICS_REGISTRATION_PLOTS
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>
#include <vector>

namespace registration {
namespace {

using Shape_characteristics::Registration_verdict;
using Group = std::pair<std::string, std::string>; // surface, protocol

constexpr double first_overlap = .2, overlap_step = .15;
constexpr std::size_t overlap_classes = 5;

std::size_t overlap_class(double overlap)
{
  const double k = std::floor((overlap - first_overlap) / overlap_step);
  return std::size_t((std::min)((std::max)(k, 0.), double(overlap_classes - 1)));
}

std::string percent(double share)
{
  return std::to_string(std::lround(100. * share));
}

// the trials in the order of the variants
std::vector<std::string> variants_of(const std::set<Trial_id>& asked)
{
  std::vector<std::string> result;
  for(const Variant& v : variants())
    if(std::any_of(asked.begin(), asked.end(), [&](const Trial_id& id) { return id.variant == v.name; }))
      result.push_back(v.name);
  return result;
}

void write_success(std::ostream& out,
                   const Trials& trials,
                   const std::set<Trial_id>& asked,
                   const Group& group)
{
  std::set<std::size_t> sizes;
  std::map<std::pair<std::string, std::size_t>, Share> shares;
  for(const Trial_id& id : asked)
    if(id.surface == group.first && id.protocol == group.second)
    {
      sizes.insert(id.neighbors);
      Share& share = shares[{id.variant, id.neighbors}];
      ++share.trials;
      share.hits += trials.results().at(id).is_correct() ? 1 : 0;
    }
  out << "| variant |";
  for(const std::size_t n : sizes)
    out << " size " << n << " |";
  out << " trials each |\n|---|";
  for(std::size_t k = 0; k <= sizes.size(); ++k)
    out << "---:|";
  out << '\n';
  for(const std::string& v : variants_of(asked))
  {
    std::size_t number = 0;
    out << "| " << v << " |";
    for(const std::size_t n : sizes)
    {
      const Share share = shares[{v, n}];
      number = (std::max)(number, share.trials);
      out << ' ' << (share.trials == 0 ? "-" : share.text()) << " |";
    }
    out << ' ' << number << " |\n";
  }
  out << '\n';
}

void write_overlaps(std::ostream& out,
                    const Trials& trials,
                    const std::set<Trial_id>& asked,
                    const Group& group)
{
  out << "Success by the share of the source that the target has, all sizes:\n\n| variant |";
  for(std::size_t k = 0; k < overlap_classes; ++k)
    out << ' ' << percent(first_overlap + overlap_step * double(k)) << "-"
        << percent((std::min)(1., first_overlap + overlap_step * double(k + 1))) << " % |";
  out << "\n|---|";
  for(std::size_t k = 0; k < overlap_classes; ++k)
    out << "---:|";
  out << '\n';
  for(const std::string& v : variants_of(asked))
  {
    std::vector<Share> shares(overlap_classes);
    for(const Trial_id& id : asked)
      if(id.surface == group.first && id.protocol == group.second && id.variant == v)
      {
        const Trial_result& result = trials.results().at(id);
        Share& share = shares[overlap_class(result.overlap)];
        ++share.trials;
        share.hits += result.is_correct() ? 1 : 0;
      }
    out << "| " << v << " |";
    for(const Share& share : shares)
      out << ' ' << (share.trials == 0 ? "-" : share.text()) << " |";
    out << '\n';
  }
  out << '\n';
}

void write_failures(std::ostream& out,
                    const Trials& trials,
                    const std::set<Trial_id>& asked,
                    const Group& group)
{
  out << "Failures, and time of one registration on one thread in milliseconds (of `pipeline`, all is in the "
         "last column but "
         "one):\n\n"
         "| variant | size | failures | most inliers mirrored | descriptors | matches | solution | all |\n"
         "|---|---:|---:|---:|---:|---:|---:|---:|\n";
  for(const std::string& v : variants_of(asked))
  {
    struct Sum
    {
      Share mirrored;
      std::size_t trials = 0;
      double times[3] = {0., 0., 0.};
    };
    std::map<std::size_t, Sum> sums;
    for(const Trial_id& id : asked)
      if(id.surface == group.first && id.protocol == group.second && id.variant == v)
      {
        const Trial_result& result = trials.results().at(id);
        Sum& sum = sums[id.neighbors];
        ++sum.trials;
        sum.times[0] += result.describe;
        sum.times[1] += result.match;
        sum.times[2] += result.solve;
        if(!result.is_correct())
        {
          ++sum.mirrored.trials;
          sum.mirrored.hits += result.mirrored > .5 ? 1 : 0;
        }
      }
    for(const auto& [neighbors, sum] : sums)
    {
      out << "| " << v << " | " << neighbors << " | " << sum.mirrored.trials << " | " << sum.mirrored.hits
          << " |";
      double all = 0.;
      for(const double time : sum.times)
      {
        all += time;
        out << ' ' << std::lround(1e3 * time / double(sum.trials)) << " |";
      }
      out << ' ' << std::lround(1e3 * all / double(sum.trials)) << " |\n";
    }
  }
  out << '\n';
}

void write_verdicts(std::ostream& out, const Trials& trials, const std::set<Trial_id>& asked)
{
  // verdict, whether it is right
  using Numbers = std::map<std::pair<std::string, bool>, std::size_t>;
  // surface, protocol, variant
  std::map<std::tuple<std::string, std::string, std::string>, Numbers> counts;
  for(const Trial_id& id : asked)
  {
    const Trial_result& result = trials.results().at(id);
    if(result.verdict != "-")
      ++counts[{id.surface, id.protocol, id.variant}][{result.verdict, result.is_correct()}];
  }
  if(counts.empty())
    return;
  out << "Verdicts:\n\n"
         "| | trials | success, right | success, wrong | ambiguous, right | ambiguous, wrong | failed, right "
         "| failed, wrong | wrong ones accepted | right ones rejected |\n"
         "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for(auto& [group, numbers] : counts)
  {
    const auto number = [&numbers = numbers](const Registration_verdict verdict, const bool is_right) {
      return numbers[{to_string(verdict), is_right}];
    };
    std::size_t all = 0, right = 0;
    for(const auto& [verdict, count] : numbers)
    {
      all += count;
      right += verdict.second ? count : 0;
    }
    out << "| " << std::get<0>(group) << ", " << std::get<1>(group) << ", " << std::get<2>(group) << " | "
        << all << " |";
    for(const Registration_verdict verdict :
        {Registration_verdict::SUCCESS, Registration_verdict::AMBIGUOUS, Registration_verdict::FAILED})
      for(const bool is_right : {true, false})
        out << ' ' << number(verdict, is_right) << " |";
    const std::size_t accepted_right = number(Registration_verdict::SUCCESS, true),
                      accepted_wrong = number(Registration_verdict::SUCCESS, false);
    const Share accepted{accepted_wrong, accepted_wrong + accepted_right};
    const Share rejected{right - accepted_right, right};
    out << ' ' << accepted.text() << " | " << rejected.text() << " |\n";
  }
  out << '\n';
}

// how well a threshold of the check tells right from wrong, of the variants that have no verdict
void write_check(std::ostream& out, const Trials& trials, const std::set<Trial_id>& asked)
{
  std::vector<std::pair<double, bool> > results;
  std::size_t right = 0;
  for(const Trial_id& id : asked)
  {
    const Trial_result& result = trials.results().at(id);
    if(result.verdict != "-")
      continue;
    results.emplace_back(result.agreement, result.is_correct());
    right += result.is_correct() ? 1 : 0;
  }
  const std::size_t wrong = results.size() - right;
  if(right == 0 || wrong == 0)
    return;
  std::sort(results.begin(), results.end());
  double area = 0.;
  std::size_t wrong_below = 0;
  for(const auto& r : results)
    if(r.second)
      area += double(wrong_below) / double(right) / double(wrong);
    else
      ++wrong_below;
  out << "The check (share of near points that meet) on " << results.size()
      << " results without refinement: area under the curve " << std::setprecision(4) << area << "\n\n"
      << "| threshold | right ones rejected | wrong ones accepted |\n|---:|---:|---:|\n";
  for(const double threshold : {.15, .2, .25, .3, .35, .4})
  {
    Share rejected{0, right}, accepted{0, wrong};
    for(const auto& r : results)
      if(r.second && r.first < threshold)
        ++rejected.hits;
      else if(!r.second && r.first >= threshold)
        ++accepted.hits;
    out << "| " << threshold << " | " << rejected.text() << " | " << accepted.text() << " |\n";
  }
  out << '\n';
}

} // namespace

std::string markdown_report(const Trials& trials, const std::set<Trial_id>& asked)
{
  std::ostringstream out;
  std::set<Group> groups;
  for(const Trial_id& id : asked)
    groups.insert({id.surface, id.protocol});
  for(const Group& group : groups)
  {
    out << "### " << group.first << ", " << group.second << "\n\n";
    write_success(out, trials, asked, group);
    write_overlaps(out, trials, asked, group);
    write_failures(out, trials, asked, group);
  }
  out << "### Verdict\n\n";
  write_verdicts(out, trials, asked);
  write_check(out, trials, asked);
  return out.str();
}

#ifdef SHAPE_CHARACTERISTICS_REGISTRATION_PLOTS
bool write_plot(const std::string& file, const Trials& trials, const std::set<Trial_id>& asked)
{
  support::Plot plot;
  plot.title = "Parts of heads registered, by their overlap";
  plot.x_label = "share of the source that the target has, in percent";
  plot.y_label = "right registrations, in percent";
  plot.y_from_zero = true;
  for(const std::string& v : variants_of(asked))
  {
    std::vector<Share> shares(overlap_classes);
    for(const Trial_id& id : asked)
      if(id.variant == v)
      {
        const Trial_result& result = trials.results().at(id);
        Share& share = shares[overlap_class(result.overlap)];
        ++share.trials;
        share.hits += result.is_correct() ? 1 : 0;
      }
    support::Plot_series series;
    series.name = v;
    for(std::size_t k = 0; k < overlap_classes; ++k)
      if(shares[k].trials > 0)
      {
        series.x.push_back(100. * (first_overlap + overlap_step * (double(k) + .5)));
        series.y.push_back(100. * shares[k].value());
      }
    plot.series.push_back(series);
  }
  support::write_png(file, plot.image());
  return true;
}
#else
bool write_plot(const std::string&, const Trials&, const std::set<Trial_id>&)
{
  return false;
}
#endif

} // namespace registration
