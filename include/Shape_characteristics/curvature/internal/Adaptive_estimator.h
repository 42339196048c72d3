#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_ESTIMATOR_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_ESTIMATOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/curvature/Adaptive_estimator_choice.h>
#include <Shape_characteristics/curvature/internal/Adaptive_statistics.h>
#include <Shape_characteristics/curvature/internal/Fitted_sample.h>
#include <Shape_characteristics/curvature/internal/adaptive_scores.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

struct Adaptive_estimates
{
  std::vector<Curvature_estimate> estimates;
  std::vector<Adaptive_estimator_choice> choices;
};

// Chooses the estimator with the lowest score for each sample, and gives its estimate. Where normals are exact beyond doubt,
// nothing else is asked for.
template <typename ConcurrencyTag, typename SampledSurface>
class Adaptive_estimator
{
  using Statistics = Adaptive_statistics<ConcurrencyTag, SampledSurface>;
  using Choice = Adaptive_estimator_choice;

public:
  // `size`: of how many samples the estimates are wanted
  Adaptive_estimator(Statistics& statistics, std::size_t size) : m_statistics(statistics), m_size(size) {}

  Adaptive_estimates operator()()
  {
    Adaptive_estimates result;
    result.estimates.resize(m_size);
    result.choices.assign(m_size, Choice::NONE);
    const std::vector<Choice> choices = choose();
    if(m_statistics.is_cancelled())
      return result;
    // whether there is an answer: else another fit may have one
    const auto take = [&](const std::size_t i, const Choice choice)
    {
      result.estimates[i] = m_statistics.field(choice)[i].estimate();
      result.choices[i] = choice;
      return result.estimates[i].status != Estimation_status::DEGENERATE;
    };
    std::vector<std::size_t> failed;
    for(std::size_t i = 0; i < m_size; ++i)
      if(choices[i] != Choice::NONE && !take(i, choices[i]))
        failed.push_back(i);
    for(const Choice choice :
        {Choice::POINTS_3_RINGS, Choice::SMOOTHED_3_RINGS, Choice::POINTS_2_RINGS, Choice::EXACT_2_RINGS})
      failed.erase(
          std::remove_if(failed.begin(), failed.end(), [&](const std::size_t i) { return take(i, choice); }),
          failed.end());
    for(std::size_t i = 0; i < m_size; ++i)
    {
      const Estimation_status status = m_statistics.surface().status(i);
      if(!is_estimated(status))
        result.estimates[i] = Curvature_estimate(status);
      if(!is_estimated(result.estimates[i].status))
        result.choices[i] = Choice::NONE;
    }
    if(m_statistics.is_cancelled()) // all or nothing: what would be chosen isn't known
    {
      result.estimates.assign(m_size, Curvature_estimate());
      result.choices.assign(m_size, Choice::NONE);
    }
    m_statistics.finish();
    return result;
  }

private:
  // the estimator of each sample, NONE where there is nothing to be estimated
  std::vector<Choice> choose()
  {
    std::vector<Choice> result(m_size, Choice::NONE);
    const std::vector<float>& exact_angles = m_statistics.statistic(Adaptive_statistic::EXACT_3_ANGLES);
    const std::vector<float>& points_angles = m_statistics.statistic(Adaptive_statistic::POINTS_3_ANGLES);
    if(m_statistics.is_cancelled())
      return result;
    std::vector<std::size_t> others;
    for(std::size_t i = 0; i < m_size; ++i)
      if(is_estimated(m_statistics.surface().status(i)))
      {
        if(double(exact_angles[i] - points_angles[i]) < adaptive_exactness)
          result[i] = Choice::EXACT_3_RINGS;
        else
          others.push_back(i);
      }
    if(others.empty())
      return result;
    std::array<const std::vector<float>*, adaptive_score_statistics.size()> statistics;
    for(std::size_t k = 0; k < statistics.size(); ++k)
    {
      statistics[k] = &m_statistics.statistic(adaptive_score_statistics[k]);
      if(m_statistics.is_cancelled())
        return result;
    }
    for(const std::size_t i : others)
    {
      std::array<double, number_of_adaptive_candidates> scores = adaptive_score_weights[0];
      for(std::size_t k = 0; k < statistics.size(); ++k)
        for(std::size_t c = 0; c < number_of_adaptive_candidates; ++c)
          scores[c] += adaptive_score_weights[k + 1][c] * double((*statistics[k])[i]);
      result[i] = Choice(std::min_element(scores.begin(), scores.end()) - scores.begin());
    }
    return result;
  }

  Statistics& m_statistics;
  std::size_t m_size;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_ESTIMATOR_H
