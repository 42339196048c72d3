#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_REPORT_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_REPORT_H

#include "deformation.h"
#include "errors.h"

#include <string>
#include <vector>

namespace head_features {

/// A row of the table of other shapes.
struct Shape_row
{
  std::string name;
  std::string verdict, obstacle;
  double confidence = 0.;
  std::size_t found = 0; ///< number of feature points
  std::string remark;
};

/// The points of one head found on two tessellations of it, in percent of its height.
struct Tessellation_row
{
  std::string name;
  std::vector<double> distances; ///< of the features found on both
  std::vector<std::string> far;  ///< names of the features that are more than 0.3 % apart
  std::vector<std::string> only_on_one;
};

/// median and maximum of each group of features, a column for each variant, against the goals where `with_goals`
std::string markdown_errors(const Measurements& measurements,
                            const std::vector<std::string>& variants,
                            const std::string& mode,
                            bool with_goals);
/// a column for each mode instead
std::string markdown_modes(const Measurements& measurements,
                           const std::string& variant,
                           const std::vector<std::string>& modes);
/// how many times larger the errors of `variant` in `mode` are than those of `reference` in its mode
std::string markdown_ratio(const Measurements& measurements,
                           const std::string& variant,
                           const std::string& mode,
                           const std::string& reference,
                           const std::string& mode_of_reference,
                           double goal);
std::string markdown_regions(const Measurements& measurements,
                             const std::vector<std::string>& variants,
                             const std::string& mode);
std::string markdown_tessellations(const std::vector<Tessellation_row>& rows);
std::string markdown_shapes(const std::vector<Shape_row>& rows);
std::string markdown_deformations(const std::vector<Deformation_difference>& differences);

/// every point and every region, one a line. Throws `std::runtime_error` if the file can't be written.
void write_csv(const std::string& file, const Measurements& measurements);

/// the share of points with at most some error. Says whether it was drawn: not without the library of the examples.
bool write_plot(const std::string& file,
                const Measurements& measurements,
                const std::vector<std::string>& variants,
                const std::vector<std::string>& modes);

} // namespace head_features

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_HEAD_FEATURES_PARTS_REPORT_H
