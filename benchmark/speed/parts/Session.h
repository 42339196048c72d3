#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_SESSION_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_SESSION_H

#include "Figure.h"
#include "Workload.h"

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace speed {

/// Runs things by Google Benchmark, and keeps their figures. The repetitions of all that was added since the last run()
/// are shuffled: changes of the processor's clock hit all of them alike.
class Session
{
public:
  /// \param argc, argv the program's arguments; those of Google Benchmark are taken out
  Session(int& argc, char** argv);

  /// Sets how long a repetition takes at least, in seconds: what is quick is run several times. 0: all is run once.
  void set_shortest_time(double seconds) { m_shortest_time = seconds; }

  /// Adds what computes curvatures of `workload`. The figure is measured by the next run().
  void
  add(Figure figure, const std::shared_ptr<Workload>& workload, const std::function<void(Workload&)>& run);

  /// Adds something else. `prepare`, which may be empty, comes before each run and isn't timed.
  void add(Figure figure, const std::function<void()>& prepare, const std::function<void()>& run);

  /// Runs what was added `repetitions` times, and forgets it: the figures stay.
  void run(int repetitions);

  const std::deque<Figure>& figures() const { return m_figures; }

  /// \returns the figure of `label` in `group`, on one thread; the first if there are several
  /// (nullptr if there is none, or if it wasn't measured)
  const Figure* find(const std::string& group, const std::string& label) const;

private:
  struct Reporter;

  std::deque<Figure> m_figures; // whose elements stay where they are
  std::vector<std::function<void(int repetitions)>> m_added;
  std::shared_ptr<Reporter> m_reporter;
  double m_shortest_time = .1;
};

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_SESSION_H
