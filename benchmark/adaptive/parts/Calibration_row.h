#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_CALIBRATION_ROW_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_CALIBRATION_ROW_H

#include "Row.h"

#include <cstddef>
#include <string>
#include <vector>

namespace adaptive {

/// A row with some of its vertices.
struct Calibration_row
{
  std::string group; ///< the shape: rows of one never judge what was learned from others of it
  double best_error; ///< mean error of the candidate that is best for these vertices
  std::vector<Vertex_record> vertices;
};

/// Takes at most about `at_most` vertices of a row, of those with an estimate.
Calibration_row calibration_row(const Row& row, std::size_t at_most);

/// Writes rows to a file, for this machine to read again.
void write_rows(const std::string& file, const std::vector<Calibration_row>& rows);

/// Reads rows that were written. None if there is no such file.
/// \throws std::runtime_error if it has others
std::vector<Calibration_row> read_rows(const std::string& file);

} // namespace adaptive

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_CALIBRATION_ROW_H
