#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_PROGRESS_BAR_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_PROGRESS_BAR_H

#include <memory>
#include <ostream>
#include <string>

namespace support {

/// Shows on the error stream how far a long step has come and when it will be done:
///
///     hrbf_curvatures(mesh, parameters::callback(Progress_bar("elephant, HRBF")));
///
/// On a terminal it is a line that changes, and that disappears at the end; elsewhere a line is written every
/// five seconds, so that steps that are quick leave nothing in a log. Copies belong to the same step; one
/// call at a time.
class Progress_bar
{
public:
  explicit Progress_bar(std::string label);

  /// The same on a stream of the caller's, which must outlive the bar; `terminal` says how.
  Progress_bar(std::string label, std::ostream& stream, bool terminal, double seconds_between_lines = 5);

  /// Reports that the fraction `done` in [0,1] is done. Returns true: the work shall go on.
  bool operator()(double done) const;

  /// Removes the line from the terminal; the last copy's destructor does so by itself.
  void finish() const;

private:
  struct State;
  std::shared_ptr<State> state_;
};

} // namespace support

#endif
