#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SCORE_LEARNER_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SCORE_LEARNER_H

#include "Row.h"

#include <array>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace adaptive {

/// The constants of adaptive_curvatures(). The estimators are blended in proportion to exp(-score), a constant and a linear
/// function of some statistics. Before that, where EXACT_3_ANGLES - POINTS_3_ANGLES is below `exactness`, CHECKED_3_RINGS is
/// chosen without asking further.
struct Scores
{
  double exactness = -1e3;
  std::vector<std::size_t> statistics;
  std::vector<std::array<double, number_of_candidates> > weights; ///< of 1, then of the statistics
};

/// A row with some of its vertices.
struct Calibration_row
{
  std::string group; ///< the surface: rows of one never judge what was learned from others of it
  double best_error; ///< mean error of the candidate that is best for these vertices
  std::vector<Vertex_record> vertices;
};

/// Takes at most about `at_most` vertices of a row.
Calibration_row calibration_row(const Row& row, std::size_t at_most);

/// The number of the candidate with the least mean error of a row.
std::size_t best_candidate(const Row& row);

/// The errors of the blend of candidates, as if their principal directions were the same.
Vertex_record::Error blend(const Scores& scores, const Vertex_record& vertex);

/// How much larger than that of the best candidate the mean error of the blend is.
double excess(const Scores& scores, const Calibration_row& row);

/// The constants that the library has.
Scores scores_of_library();

/// Learns the constants: those under which the mean over the rows of the logarithm of the error is least. Of those that are
/// `kept`, only the candidates that check normals get new ones; null pointer: all do. `log` is told how well they do, and how
/// well those do that are learned without the surfaces that they are tried on.
Scores learn_scores(const std::vector<Calibration_row>& rows, const Scores* kept, std::ostream& log);

/// The constants as the header that the library includes. `some_kept`: those of candidates that don't check normals weren't learned.
std::string to_header(const Scores& scores, bool some_kept);

} // namespace adaptive

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ADAPTIVE_SCORE_LEARNER_H
