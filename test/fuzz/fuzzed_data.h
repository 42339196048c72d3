#ifndef SHAPE_CHARACTERISTICS_TEST_FUZZ_FUZZED_DATA_H
#define SHAPE_CHARACTERISTICS_TEST_FUZZ_FUZZED_DATA_H

#include <fuzzer/FuzzedDataProvider.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

// Numbers that libFuzzer makes up.
namespace fuzz {

#ifdef CGAL_LINKED_WITH_TBB
// What is tried next depends on what the code went through before: with several threads, on chance.
inline const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
#endif

// A number of any kind: usual, on a small grid, or any bits at all (infinite, NaN, denormal, huge).
inline double number(FuzzedDataProvider& data)
{
  switch(data.ConsumeIntegralInRange<int>(0, 15))
  {
  case 0:
  {
    const std::uint64_t bits = data.ConsumeIntegral<std::uint64_t>();
    double x;
    std::memcpy(&x, &bits, sizeof(x));
    return x;
  }
  case 1:
    return std::ldexp(1. + data.ConsumeProbability<double>(), data.ConsumeIntegralInRange<int>(-1080, 1030));
  case 2:
    return data.PickValueInArray({0., -0., std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::infinity(),
                                  (std::numeric_limits<double>::max)(), (std::numeric_limits<double>::min)(),
                                  std::numeric_limits<double>::denorm_min()});
  case 3:
  case 4:
  case 5:
    return double(data.ConsumeIntegral<std::int8_t>()) / 16.;
  default:
    return double(data.ConsumeIntegral<std::int16_t>()) / 8192.;
  }
}

// A factor that all coordinates share, so that whole inputs are tiny or huge.
inline double scale(FuzzedDataProvider& data)
{
  return data.ConsumeBool() ? 1. : std::ldexp(1., data.ConsumeIntegralInRange<int>(-1070, 1020));
}

// of a point, or a vector
template <typename T>
bool is_finite(const T& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

// Ends the program if there is a complaint of what was tried.
inline void require(const std::string& what, const std::string& complaint)
{
  if(complaint.empty())
    return;
  std::fprintf(stderr, "%s: %s\n", what.c_str(), complaint.c_str());
  std::abort();
}

// The same with a condition, and the complaint if it doesn't hold.
inline void require(bool holds, const std::string& what, const char* complaint)
{
  if(!holds)
    require(what, complaint);
}

} // namespace fuzz

#endif // SHAPE_CHARACTERISTICS_TEST_FUZZ_FUZZED_DATA_H
