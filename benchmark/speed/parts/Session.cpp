#include "Session.h"

#include <benchmark/benchmark.h>

#include <time.h>

#include <algorithm>
#include <iostream>
#include <utility>

namespace speed {
namespace {

double seconds(clockid_t clock)
{
  timespec now{};
  clock_gettime(clock, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// Times each iteration by itself as well: the quickest one was disturbed least. What runs on one thread is measured in the
// time that the processor spent with it: that of other programs on the machine isn't counted.
template <typename Run>
void iterate(benchmark::State& state, Figure& figure, const std::function<void()>& prepare, const Run& run)
{
  const clockid_t clock = figure.threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC;
  double quickest = std::numeric_limits<double>::infinity();
  for([[maybe_unused]] auto _ : state)
  {
    if(prepare)
      prepare();
    const double start = seconds(clock);
    run();
    quickest = std::min(quickest, seconds(clock) - start);
  }
  figure.seconds = std::fmin(figure.seconds, quickest); // NaN before the first repetition
  if(figure.vertices != 0)
  {
    state.counters["us/vertex"] = 1e6 * quickest / double(figure.vertices);
    state.counters["vertices/s"] = double(figure.vertices) / quickest;
  }
  if(figure.operations > 0.)
    state.counters["GFLOP/s"] = 1e-9 * figure.operations / quickest;
}

} // namespace

// Google Benchmark's, with a line for the quickest repetition only, and away from the tables of the standard output.
struct Session::Reporter : benchmark::ConsoleReporter
{
  Reporter() : benchmark::ConsoleReporter(OO_Tabular) { SetOutputStream(&std::cerr); }

  bool ReportContext(const Context& context) override
  {
    return std::exchange(has_context, true) || benchmark::ConsoleReporter::ReportContext(context);
  }

  void ReportRuns(const std::vector<Run>& runs) override
  {
    const Run* quickest = nullptr;
    for(const Run& r : runs)
      if(r.run_type == Run::RT_Iteration &&
         (quickest == nullptr || r.GetAdjustedRealTime() < quickest->GetAdjustedRealTime()))
        quickest = &r;
    if(quickest != nullptr)
      benchmark::ConsoleReporter::ReportRuns({*quickest});
  }

  bool has_context = false;
};

Session::Session(int& argc, char** argv)
{
  // before the user's own, which win
  std::string program = argc > 0 ? argv[0] : "", shuffle = "--benchmark_enable_random_interleaving=true";
  char* own[] = {program.data(), shuffle.data(), nullptr};
  int number = 2;
  benchmark::Initialize(&number, own);
  benchmark::Initialize(&argc, argv);
  m_reporter = std::make_shared<Reporter>();
}

void Session::add(Figure figure,
                  const std::shared_ptr<Workload>& workload,
                  const std::function<void(Workload&)>& run)
{
  m_figures.push_back(std::move(figure));
  Figure& f = m_figures.back();
  f.vertices = workload->size();
  const auto measure = [&f, workload, run](benchmark::State& state)
  {
    workload->clear_results();
    iterate(state, f, {}, [&] { run(*workload); });
    if(!f.has_errors)
      return;
    const benchmark_support::Error_statistics errors = workload->errors();
    f.mae = errors.mae();
    f.median = errors.median();
    f.not_estimated = errors.flagged();
    state.counters["MAE"] = f.mae;
  };
  m_added.push_back(
      [this, &f, measure](int repetitions)
      {
        const std::string name = f.group + "/" + f.label() + "/" + f.surface + "/" + f.order + "/" +
                                 std::to_string(f.vertices) + "/threads:" + std::to_string(f.threads);
        auto* b = benchmark::RegisterBenchmark(name.c_str(), measure);
        b->UseRealTime()->Unit(benchmark::kMillisecond)->Repetitions(repetitions);
        if(m_shortest_time > 0.)
          b->MinTime(m_shortest_time);
        else
          b->Iterations(1);
      });
}

void Session::add(Figure figure, const std::function<void()>& prepare, const std::function<void()>& run)
{
  m_figures.push_back(std::move(figure));
  Figure& f = m_figures.back();
  const auto measure = [&f, prepare, run](benchmark::State& state) { iterate(state, f, prepare, run); };
  m_added.push_back(
      [this, &f, measure](int repetitions)
      {
        auto* b = benchmark::RegisterBenchmark((f.group + "/" + f.label()).c_str(), measure);
        b->UseRealTime()->Unit(benchmark::kMicrosecond)->Repetitions(repetitions);
        if(m_shortest_time > 0.)
          b->MinTime(m_shortest_time);
        else
          b->Iterations(1);
      });
}

void Session::run(int repetitions)
{
  for(const auto& add_to_google : m_added)
    add_to_google(repetitions);
  benchmark::RunSpecifiedBenchmarks(m_reporter.get());
  benchmark::ClearRegisteredBenchmarks();
  m_added.clear();
}

const Figure* Session::find(const std::string& group, const std::string& label) const
{
  for(const Figure& f : m_figures)
    if(f.group == group && f.label() == label && f.threads == 1 && f.is_complete())
      return &f;
  return nullptr;
}

} // namespace speed
