#include "goals.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace speed {
namespace {

double microseconds(const Session& session, const std::string& label)
{
  const Figure* f = session.find("comparison", label);
  return f == nullptr ? nan_value : f->microseconds_per_vertex();
}

double best_gflops(const Session& session, const std::string& group, const std::string& neighbourhood)
{
  double best = nan_value;
  for(const Figure& f : session.figures())
    if(f.group == group && f.neighbourhood == neighbourhood)
      best = std::fmax(best, f.gflops());
  return best;
}

// the longest time per vertex over the shortest one, from 30000 vertices on
double spread_over_sizes(const Session& session, const std::string& label, const std::string& order)
{
  double least = nan_value, most = nan_value;
  std::size_t sizes = 0;
  for(const Figure& f : session.figures())
    if(f.group == "sizes" && f.label() == label && f.order == order && f.threads == 1 &&
       f.vertices >= 30000 && f.is_complete())
    {
      least = std::fmin(least, f.microseconds_per_vertex());
      most = std::fmax(most, f.microseconds_per_vertex());
      ++sizes;
    }
  return sizes < 2 ? nan_value : most / least;
}

// on the largest surface that was measured with one thread and with two
double gain_of_two_threads(const Session& session, const std::string& label)
{
  double gain = nan_value;
  std::size_t largest = 0;
  for(const Figure& one : session.figures())
    for(const Figure& two : session.figures())
      if(one.group == "sizes" && one.label() == label && one.threads == 1 && two.group == "sizes" &&
         two.label() == label && two.threads == 2 && one.vertices == two.vertices && one.order == two.order &&
         one.vertices > largest)
      {
        largest = one.vertices;
        gain = one.seconds / two.seconds;
      }
  return gain;
}

// how much more two threads computed in their registers than one
std::string gain_of_the_machine(const Session& session)
{
  double one = nan_value, two = nan_value;
  for(const Figure& f : session.figures())
    if(f.group == "threads" && f.threads <= 2)
      (f.threads == 1 ? one : two) = f.gflops();
  std::ostringstream text;
  text << std::setprecision(3) << two / one;
  return std::isfinite(two / one) ? text.str() : "–";
}

} // namespace

std::vector<Goal> goals(const Session& session)
{
  // CGAL's fits alone, without the search of neighbours that ours contain
  const double jet_2 = microseconds(session, "CGAL jet d=4, 2 rings given");
  const double jet_3 = microseconds(session, "CGAL jet d=4, 3 rings given");
  const double hrbf_2 = microseconds(session, "HRBF, exact normals, 2 rings");
  const double hrbf_3 = microseconds(session, "HRBF, exact normals, 3 rings");
  const double estimated = microseconds(session, "HRBF, estimated normals, 2 rings");
  const double thesis = microseconds(session, "HRBF of the thesis, plain, 2 rings");
  const double our_thesis = microseconds(session, "HRBF of the thesis, r^5, 2 rings");
  const double factorization = best_gflops(session, "factorization", "58 equations");
  const double product = best_gflops(session, "peak", "512 x 512"), peak = best_gflops(session, "peak", "");
  const std::string hrbf = "HRBF, exact normals, 2 rings";

  std::vector<Goal> list = {
      {"HRBF, exact normals, 2 rings: times faster than CGAL's jets d=4", jet_2 / hrbf_2, true, 40., ""},
      {"HRBF, exact normals, 2 rings: times faster than the thesis's path, plain", thesis / hrbf_2, true, 40.,
       ""},
      {"HRBF, exact normals, 2 rings: times faster than the thesis's path, ours", our_thesis / hrbf_2, true,
       40., ""},
      {"HRBF, exact normals, 3 rings: times faster than CGAL's jets d=4 on 3 rings", jet_3 / hrbf_3, true,
       10., ""},
      {"HRBF, estimated normals, 2 rings: times faster than CGAL's jets d=4", jet_2 / estimated, true, 25.,
       ""},
      {"Rusinkiewicz: part of the time of CGAL's jets",
       100. * microseconds(session, "Rusinkiewicz, 1 ring") / jet_2, false, 1.5, " %"},
      {"tangent space: part of the time of CGAL's jets",
       100. * microseconds(session, "tangent space, 1 ring") / jet_2, false, 2., " %"},
      {"Goldfeather-Interrante: part of the time of CGAL's jets",
       100. * microseconds(session, "Goldfeather-Interrante, 2 rings") / jet_2, false, 5., " %"},
      {"factorization of 58 equations: part of the matrix product's speed", 100. * factorization / product,
       true, 50., " %"},
      {"factorization of 58 equations: part of the arithmetic peak", 100. * factorization / peak, true, 50.,
       " %"},
      {"HRBF, exact normals, 2 rings: slowest time per vertex over the quickest one, from 30000 vertices on",
       spread_over_sizes(session, hrbf, "curve"), false, 1.15, ""},
      {"the same, vertices in random order", spread_over_sizes(session, hrbf, "random"), false, 1.15, ""},
      {"HRBF, exact normals, 2 rings: gain by a second thread (the machine's own meanwhile: " +
           gain_of_the_machine(session) + ")",
       gain_of_two_threads(session, hrbf), true, 1.8, ""}};
  for(const auto& [surface, bound] :
      std::vector<std::pair<std::string, double>>{{"f1e", 2e-5}, {"f2e", 4e-5}, {"f4e", .05}, {"f1i", 4e-4}})
  {
    double mae = nan_value;
    for(const Figure& f : session.figures())
      if((f.group == "comparison" || f.group == "surfaces") && f.surface == surface && f.label() == hrbf)
        mae = f.mae;
    list.push_back(
        {"HRBF, exact normals, 2 rings: mean absolute error on " + surface, mae, false, bound, ""});
  }
  return list;
}

} // namespace speed
