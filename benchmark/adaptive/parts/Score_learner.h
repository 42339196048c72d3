#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SCORE_LEARNER_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SCORE_LEARNER_H

#include "Calibration_row.h"

#include <array>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace adaptive {

/// The constants of adaptive_curvatures(). The estimators are blended in proportion to exp(-score), a constant and a linear
/// function of the hyperbolic tangents of some linear functions of the statistics, the units. Before that, where EXACT_3_ANGLES -
/// POINTS_3_ANGLES is below `exactness`, CHECKED_3_RINGS is chosen without asking further.
struct Scores
{
  double exactness = -1e3;
  std::vector<std::vector<double> > units; ///< for 1, then for each statistic, the weights in all units
  std::vector<std::array<double, number_of_candidates> > scores; ///< for 1, then for each unit
};

/// How much larger than that of the best candidate the mean error of the blend is, as if the principal directions of the candidates
/// were the same.
double excess(const Scores& scores, const Calibration_row& row);

/// Learns the constants: those under which the mean over the rows of the logarithm of the error is least. `log` is told how well they
/// do, and how well those do that are learned without the surfaces that they are tried on.
Scores learn_scores(const std::vector<Calibration_row>& rows, std::ostream& log);

/// The constants as the header that the library includes.
std::string to_header(const Scores& scores);

} // namespace adaptive

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SCORE_LEARNER_H
