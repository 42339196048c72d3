#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_GPU_TIMER_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_GPU_TIMER_H

#include <functional>
#include <string>

namespace screen_space {

/// How long a frame takes, in milliseconds: the median over frames.
struct Frame_time
{
  double gpu = 0.;  ///< by the timer of the GPU
  double wall = 0.; ///< on the clock, from the call until glFinish() returns
  double processor =
      0.; ///< of all threads of the process: what a software renderer takes, whoever else is at work
  int frames = 0;
};

/// Times `frame`, after a few frames that don't count, for as many frames as take `seconds`, at least 3 (1 if it takes seconds) and 200 at the most.
Frame_time time_of(const std::function<void()>& frame, double seconds);

/// The name of the renderer.
std::string renderer_name();

/// Whether the renderer is a program on the processor.
bool is_software_renderer();

/// The bytes per second, in GB/s, that a shader reads and writes when it copies a large texture; NaN for a software renderer, which calculation
/// keeps busy.
double measured_bandwidth();

} // namespace screen_space

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SCREEN_SPACE_PARTS_GPU_TIMER_H
