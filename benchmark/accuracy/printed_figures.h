#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PRINTED_FIGURES_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PRINTED_FIGURES_H

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
inline const std::vector<Printed_column>& printed_figures()
{
  static const std::vector<Printed_column> figures = {
      // f1e, f2e, f3e, f4e
      {"8.3", "HRBF 2", {0.007, 0.004, 0.009, 0.346}},
      {"8.3", "HRBF 4", {0.0001, 0.0003, 0.0001, 0.063}},
      {"8.3", "Rus", {0.054, 0.046, 0.093, 4.453}},
      {"8.3", "GI", {0.039, 0.022, 0.071, 2.773}},
      {"8.3", "Kal", {0.070, 0.062, 0.121, 5.962}},
      {"8.3", "HP", {0.136, 0.090, 0.288, 9.620}},

      {"8.4", "HRBF 2", {0.059, 0.037, 0.079, 3.160}},
      {"8.4", "HRBF 4", {0.043, 0.027, 0.064, 3.195}},
      {"8.4", "Rus", {0.091, 0.067, 0.148, 5.472}},
      {"8.4", "GI", {0.057, 0.035, 0.105, 3.237}},
      {"8.4", "Kal", {0.070, 0.062, 0.121, 5.962}},
      {"8.4", "HP", {0.136, 0.090, 0.288, 9.620}},

      {"8.5", "HRBF 2", {0.079, 0.063, 0.168, 3.590}},
      {"8.5", "HRBF 4", {0.066, 0.054, 0.164, 3.704}},
      {"8.5", "Rus", {0.159, 0.125, 0.362, 6.089}},
      {"8.5", "GI", {0.087, 0.062, 0.176, 4.476}},
      {"8.5", "Kal", {0.070, 0.062, 0.121, 5.962}},
      {"8.5", "HP", {0.136, 0.440, 0.288, 9.620}},

      {"8.7", "r^3", {0.006, 0.003, 0.010, 0.838}},
      {"8.7", "r^5", {0.0005, 0.0003, 0.0004, 0.154}},
      {"8.7", "r^7", {0.0002, 0.0002, 0.0002, 0.071}},
      {"8.7", "r^9", {0.0001, 0.0003, 0.0001, 0.063}},
      {"8.7", "r^4 ln r", {0.002, 0.001, 0.002, 0.288}},
      {"8.7", "1/sqrt(1+(er)^2)", {0.577, 0.501, 1.141, 21.650}},
      {"8.7", "1/sqrt(1+(er)^3)", {0.011, 0.007, 0.018, 1.347}},

      // f1i, f2i, f3i, f4i, f5i
      {"8.12", "HRBF 2", {0.131, 0.021, 0.028, 0.114, 0.403}},
      {"8.12", "HRBF 4", {0.111, 0.017, 0.022, 0.023, 0.330}},
      {"8.12", "Rus", {0.293, 0.058, 0.064, 0.075, 0.688}},
      {"8.12", "GI", {0.154, 0.019, 0.021, 0.044, 0.495}},
      {"8.12", "Kal", {0.218, 0.019, 0.019, 0.049, 0.341}},
      {"8.12", "HP", {0.301, 0.033, 0.053, 0.070, 0.521}},

      // f1e, f2e, f3e, f1i, f2i, f3i
      {"8.14", "HRBF 2", {0.979, 0.736, 0.104, 0.130, 0.022, 0.038}},
      {"8.14", "HRBF 4", {0.898, 0.671, 0.097, 0.123, 0.022, 0.036}},
      {"8.14", "Avg", {5.530, 3.369, 0.578, 4.888, 1.675, 1.217}},
      {"8.14", "Max", {1.533, 0.813, 0.132, 0.895, 1.996, 1.362}},
      {"8.14", "Kal", {1.533, 0.813, 0.132, 0.894, 1.995, 1.361}}};
  return figures;
}

/// The figures of a column, or null if the thesis has none.
inline const Printed_column* printed_column(const std::string& table, const std::string& column)
{
  for(const Printed_column& c : printed_figures())
    if(c.table == table && c.column == column)
      return &c;
  return nullptr;
}

} // namespace accuracy

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_PRINTED_FIGURES_H
