#include "Trial.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace registration {
namespace {

const char* const header =
    "surface,protocol,variant,neighbors,head,number,error,overlap,mirrored,agreement,near,expected,"
    "correlation,registration_verdict,describe,match,solve";

} // namespace

Trials::Trials(const std::string& file) : m_file(file)
{
  if(file.empty())
    return;
  std::ifstream in(file);
  std::string line;
  if(!std::getline(in, line))
  {
    std::ofstream out(file);
    out << header << '\n';
    if(!out)
      throw std::runtime_error("can't write " + file);
    return;
  }
  if(line != header)
    throw std::runtime_error(file + " is of another version: move it away");
  while(std::getline(in, line))
  {
    std::vector<std::string> cells;
    std::istringstream parts(line);
    for(std::string cell; std::getline(parts, cell, ',');)
      cells.push_back(cell);
    if(cells.size() != 17)
      continue; // cut off when the program was
    const auto number = [&](const std::size_t k) { return std::stod(cells[k]); };
    const auto count = [&](const std::size_t k) { return std::size_t(std::stoull(cells[k])); };
    Trial_result result;
    result.error = number(6);
    result.overlap = number(7);
    result.mirrored = number(8);
    result.agreement = number(9);
    result.near = number(10);
    result.expected = number(11);
    result.correlation = number(12);
    result.verdict = cells[13];
    result.describe = number(14);
    result.match = number(15);
    result.solve = number(16);
    m_results[{cells[0], cells[1], cells[2], count(3), count(4), count(5)}] = result;
  }
}

void Trials::add(const Trial_id& id, const Trial_result& result)
{
  m_results[id] = result;
  if(m_file.empty())
    return;
  std::ofstream out(m_file, std::ios::app);
  out << id.surface << ',' << id.protocol << ',' << id.variant << ',' << id.neighbors << ',' << id.head << ','
      << id.number << ',' << std::setprecision(6) << result.error << ',' << result.overlap << ','
      << result.mirrored << ',' << result.agreement << ',' << result.near << ',' << result.expected << ','
      << result.correlation << ',' << result.verdict << ',' << result.describe << ',' << result.match << ','
      << result.solve << '\n';
  if(!out)
    throw std::runtime_error("can't write " + m_file);
}

double Share::bound(double side) const
{
  if(trials == 0)
    return side < 0. ? 0. : 1.;
  const double z = 1.959963984540054, n = double(trials), p = value();
  return (p + z * z / (2. * n) + side * z * std::sqrt(p * (1. - p) / n + z * z / (4. * n * n))) /
         (1. + z * z / n);
}

std::string Share::text() const
{
  std::ostringstream out;
  const double percent = 100. * value();
  // finer where little is left, and 0 instead of -0
  const auto rounded = [](const double share)
  {
    const double steps = share < .02 || share > .98 ? 10. : 1.; // of a percent
    return std::round(100. * steps * share) / steps + 0.;
  };
  out << std::setprecision(percent > 0. && percent < 2. ? 2 : 3) << percent << " % (" << rounded(lower())
      << "-" << rounded(upper()) << ")";
  return out.str();
}

} // namespace registration
