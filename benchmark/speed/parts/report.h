#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_REPORT_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_REPORT_H

#include "Session.h"

#include <ostream>
#include <string>

namespace speed {

/// Writes all figures, a line each.
void write_csv(const Session& session, std::ostream& out);

/// Writes tables of the parts that were run, and the goals.
void write_markdown(const Session& session, std::ostream& out);

/// whether plots can be drawn: they need what the examples share
bool has_plots();

/// Draws the parts that were run, as `speed_….png` in the folder.
void draw_plots(const Session& session, const std::string& folder);

} // namespace speed

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_SPEED_REPORT_H
