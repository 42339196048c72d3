#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_PEAK_MEMORY_IN_BYTES_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_PEAK_MEMORY_IN_BYTES_H

#include <sys/resource.h>

namespace benchmark_support {

/// The most memory that this process has had at a time. It never falls: measure small inputs before large ones.
inline double peak_memory_in_bytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * double(usage.ru_maxrss); // Linux counts in kilobytes
}

} // namespace benchmark_support

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SUPPORT_PEAK_MEMORY_IN_BYTES_H
