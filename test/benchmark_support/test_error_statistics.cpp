#include <boost/test/unit_test.hpp>

#include "Command_line.h"
#include "Error_statistics.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(error_statistics)

using namespace benchmark_support;

namespace {

Command_line parse(std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), "program");
  std::vector<char*> argv;
  for(std::string& a : arguments)
    argv.push_back(&a[0]);
  return Command_line(int(argv.size()), argv.data(), {"seeds", "points", "csv"}, {"quick"});
}

} // namespace

BOOST_AUTO_TEST_CASE(means_and_median)
{
  Error_statistics s;
  s.add(1., -.5);
  s.add(-3., 0.);
  s.add(.5, .25);
  BOOST_TEST(s.vertices() == 3u);
  BOOST_TEST(s.flagged() == 0u);
  BOOST_TEST(s.mae_k_max() == 1.5);
  BOOST_TEST(s.mae_k_min() == .25);
  BOOST_TEST(s.mae() == 1.75);
  BOOST_TEST(s.mse_k_max() == 10.25 / 3.);
  BOOST_TEST(s.mse_k_min() == .3125 / 3.);
  BOOST_TEST(s.median() == 1.5); // of 1.5, 3, 0.75
}

BOOST_AUTO_TEST_CASE(flagged_vertices_are_counted_and_left_out)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  Error_statistics s;
  s.add(nan, 1.);
  s.add(1., -infinity);
  BOOST_TEST(s.flagged() == 2u);
  BOOST_TEST(std::isnan(s.mae()));
  BOOST_TEST(std::isnan(s.median()));
  s.add(2., 1.);
  BOOST_TEST(s.vertices() == 3u);
  BOOST_TEST(s.mae() == 3.);
  BOOST_TEST(s.median() == 3.);
}

BOOST_AUTO_TEST_CASE(adding_pools_the_vertices)
{
  Error_statistics a, b, together;
  for(int i = 0; i < 7; ++i)
  {
    (i < 2 ? a : b).add(i, -2. * i);
    together.add(i, -2. * i);
  }
  a.add(std::nan(""), 0.);
  together.add(std::nan(""), 0.);
  a.add(b);
  BOOST_TEST(a.vertices() == together.vertices());
  BOOST_TEST(a.flagged() == together.flagged());
  BOOST_TEST(a.mae() == together.mae());
  BOOST_TEST(a.mse() == together.mse());
  BOOST_TEST(a.median() == together.median());
}

BOOST_AUTO_TEST_CASE(command_lines)
{
  const Command_line c = parse({"--seeds", "3,1,,2", "--quick", "--points", "250"});
  BOOST_TEST(c.has("quick"));
  BOOST_TEST(!c.has("csv"));
  BOOST_TEST(c.text("csv", "x") == "x");
  BOOST_TEST(c.number("points", 1) == 250u);
  BOOST_TEST((c.numbers("seeds", "7") == std::vector<std::uint64_t>{3, 1, 2}));
  BOOST_TEST((parse({}).numbers("seeds", "7") == std::vector<std::uint64_t>{7}));
  BOOST_CHECK_THROW(parse({"--pionts", "3"}), std::invalid_argument);
  BOOST_CHECK_THROW(parse({"points"}), std::invalid_argument);
  BOOST_CHECK_THROW(parse({"--points"}), std::invalid_argument);
  for(const char* bad : {"", "x", "3x", "-3", "1e3", "99999999999999999999999"})
    BOOST_CHECK_THROW(parse({"--points", bad}).number("points", 1), std::invalid_argument);
  BOOST_CHECK_THROW(parse({"--points", "3"}).number("points", 1, 4), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
