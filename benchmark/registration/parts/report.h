#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_REPORT_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_REPORT_H

#include "Trial.h"

#include <set>
#include <string>

namespace registration {

/// tables of some of the trials, those of the thesis's table 10.1 first
std::string markdown_report(const Trials& trials, const std::set<Trial_id>& asked);

/// success over overlap, as PNG; returns `false` without the library that draws
bool write_plot(const std::string& file, const Trials& trials, const std::set<Trial_id>& asked);

} // namespace registration

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_REGISTRATION_PARTS_REPORT_H
