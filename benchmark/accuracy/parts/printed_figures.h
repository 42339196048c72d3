#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_PRINTED_FIGURES_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_PRINTED_FIGURES_H

#include <string>
#include <vector>

namespace accuracy {

/// A column of a table of the thesis (in Table 8.7 a row): what it prints for one estimator on each surface.
struct Printed_column
{
  std::string table, column;
  std::vector<double> figures; ///< in the order of the table's surfaces
};

/// The figures of the thesis's chapter 8, as printed. Table 8.14 is in units of 1e-4.
const std::vector<Printed_column>& printed_figures();

/// The figures of a column, or null if the thesis has none.
const Printed_column* printed_column(const std::string& table, const std::string& column);

} // namespace accuracy

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PARTS_PRINTED_FIGURES_H
