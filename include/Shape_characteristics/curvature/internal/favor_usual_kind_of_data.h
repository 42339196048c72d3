#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FAVOR_USUAL_KIND_OF_DATA_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FAVOR_USUAL_KIND_OF_DATA_H

#include <Shape_characteristics/curvature/Adaptive_estimator_choice.h>
#include <Shape_characteristics/curvature/internal/Adaptive_statistics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Shape_characteristics {
namespace internal {

using Adaptive_scores = std::array<double, number_of_adaptive_candidates>;

// The shares of candidates with these scores in a blend, as multiples of the best one's. A score is finite at least; those of
// candidates without an estimate are infinite.
inline Adaptive_scores adaptive_shares(const Adaptive_scores& scores)
{
  const double best = *std::min_element(scores.begin(), scores.end());
  Adaptive_scores shares;
  for(std::size_t c = 0; c < shares.size(); ++c)
    shares[c] = std::isfinite(scores[c]) ? adaptive_share(scores[c] - best) : 0.;
  return shares;
}

// what a candidate takes data for
enum class Kind_of_data
{
  EXACT,        // both points and normals
  EXACT_POINTS, // with normals that are worth little
  NOISY,
  COUNT
};

constexpr Kind_of_data kind_of_data(Adaptive_estimator_choice choice)
{
  switch(choice)
  {
  case Adaptive_estimator_choice::EXACT_2_RINGS:
  case Adaptive_estimator_choice::EXACT_3_RINGS:
  case Adaptive_estimator_choice::CHECKED_2_RINGS:
  case Adaptive_estimator_choice::CHECKED_3_RINGS:
    return Kind_of_data::EXACT;
  case Adaptive_estimator_choice::POINTS_2_RINGS:
  case Adaptive_estimator_choice::POINTS_3_RINGS:
  case Adaptive_estimator_choice::POINTS_4_RINGS:
    return Kind_of_data::EXACT_POINTS;
  default:
    return Kind_of_data::NOISY;
  }
}

/*
  Lowers the scores of candidates for the kind of data that most samples seem to be. The data of a surface mostly come from one source,
  so that this is probably what those samples are as well whose neighborhoods don't tell. Scores know of a neighborhood alone, and were
  learned from all kinds of data. Where they are negative logarithms of probabilities, the proportions of the kinds among these samples
  are found by expectation maximization, and become part of the probabilities: M. Saerens, P. Latinne, C. Decaestecker, Adjusting the
  outputs of a classifier to new a priori probabilities: a simple procedure, Neural Computation 14(1), 2002.

  Each kind counts as ten samples more than it seems to have, and a twentieth of all: few samples tell little of others, and a part of
  a surface may differ from the rest.
*/
inline void favor_usual_kind_of_data(std::vector<Adaptive_scores>& scores)
{
  constexpr int steps = 4; // more of them change hardly anything
  constexpr double more_samples = 10., larger_part = .05;
  constexpr double unit = 0x1p-30; // in whole ones, shares have the same sum in whatever order samples are
  std::array<double, std::size_t(Kind_of_data::COUNT)> advantages{};
  const auto kind = [](const std::size_t c)
  { return std::size_t(kind_of_data(Adaptive_estimator_choice(c))); };
  const auto with_advantages = [&](Adaptive_scores of_sample)
  {
    for(std::size_t c = 0; c < of_sample.size(); ++c)
      of_sample[c] -= advantages[kind(c)];
    return of_sample;
  };
  for(int step = 0; step < steps; ++step)
  {
    std::array<std::int64_t, std::size_t(Kind_of_data::COUNT)> units{};
    for(const Adaptive_scores& of_sample : scores)
    {
      const Adaptive_scores shares = adaptive_shares(with_advantages(of_sample));
      double sum = 0.;
      for(const double share : shares)
        sum += share;
      for(std::size_t c = 0; c < shares.size(); ++c)
        units[kind(c)] += std::llround(shares[c] / (unit * sum));
    }
    for(std::size_t k = 0; k < units.size(); ++k)
      advantages[k] =
          std::log((double(units[k]) * unit + more_samples) / double(scores.size()) + larger_part);
  }
  for(Adaptive_scores& of_sample : scores)
    of_sample = with_advantages(of_sample);
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FAVOR_USUAL_KIND_OF_DATA_H
