#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_GOALS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_GOALS_H

#include "Session.h"

#include <string>
#include <vector>

namespace speed {

/// What the library means to reach, as a ratio of figures of one session: it doesn't depend on the machine as times do.
struct Goal
{
  std::string name;
  double figure; ///< NaN if it wasn't measured
  bool is_lower_bound;
  double bound;
  std::string unit;

  bool is_met() const { return is_lower_bound ? figure >= bound : figure <= bound; }
};

std::vector<Goal> goals(const Session& session);

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_GOALS_H
