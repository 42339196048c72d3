#include "Progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>

namespace support {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string duration_text(double seconds)
{
  char text[60];
  const long whole = std::lround(std::min(seconds, 1e7));
  if(whole < 60)
    std::snprintf(text, sizeof text, "%ld s", whole);
  else if(whole < 3600)
    std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole / 60 % 60);
  return text;
}

} // namespace

struct Progress_bar::State
{
  std::string label;
  std::ostream* stream;
  bool terminal;
  double period;
  Clock::time_point start = Clock::now(), last_shown = start;
  bool on_screen = false;

  ~State() { clear(); }

  void clear()
  {
    if(on_screen)
      *stream << "\r\033[K" << std::flush;
    on_screen = false;
  }

  void show(double done)
  {
    const double passed = seconds_since(start);
    char percent[20];
    std::snprintf(percent, sizeof percent, "%3.0f %%", std::floor(100 * done));
    std::string text = label + "  ";
    if(terminal)
    {
      const int length = 30, filled = int(done * length);
      text += "[" + std::string(std::size_t(filled), '#') + std::string(std::size_t(length - filled), '.') +
              "]  ";
    }
    text += percent;
    // what has been done says nothing yet about what remains in the very beginning
    if(done > 0.01 && done < 1)
      text += ", " + duration_text(passed / done * (1 - done)) + " left";
    if(terminal)
      *stream << "\r" << text << "\033[K" << std::flush;
    else
      *stream << text << std::endl;
    on_screen = terminal;
    last_shown = Clock::now();
  }
};

Progress_bar::Progress_bar(std::string label)
  : Progress_bar(std::move(label), std::cerr, isatty(STDERR_FILENO) != 0)
{}

Progress_bar::Progress_bar(std::string label,
                           std::ostream& stream,
                           bool terminal,
                           double seconds_between_lines)
  : state_(std::make_shared<State>())
{
  state_->label = std::move(label);
  state_->stream = &stream;
  state_->terminal = terminal;
  state_->period = terminal ? 0.1 : seconds_between_lines;
}

bool Progress_bar::operator()(double done) const
{
  done = done >= 0 ? std::min(done, 1.) : 0; // NaN too
  if(done >= 1)
    finish();
  else if(seconds_since(state_->last_shown) >= state_->period)
    state_->show(done);
  return true;
}

void Progress_bar::finish() const
{
  state_->clear();
}

} // namespace support
