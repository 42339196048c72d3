#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_ESTIMATOR_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_ESTIMATOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/curvature/Adaptive_estimator_choice.h>
#include <Shape_characteristics/curvature/internal/Adaptive_statistics.h>
#include <Shape_characteristics/curvature/internal/Fitted_sample.h>
#include <Shape_characteristics/curvature/internal/Quadric_through_neighbors.h>
#include <Shape_characteristics/curvature/internal/adaptive_scores.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

struct Adaptive_estimates
{
  std::vector<Curvature_estimate> estimates;
  std::vector<Adaptive_estimator_choice> choices;
};

// Blends the estimators at each sample, in proportion to exp(-score). Where points or normals are those of a quadric, or normals are exact
// beyond doubt, nothing else is asked for, and of the other fits only those are made that have a part elsewhere.
template <typename ConcurrencyTag, typename SampledSurface>
class Adaptive_estimator
{
  using Statistics = Adaptive_statistics<ConcurrencyTag, SampledSurface>;
  using Choice = Adaptive_estimator_choice;
  using Index = typename Statistics::Index;
  using Fields = std::array<const Fitted_field*, number_of_adaptive_candidates>;
  using Scores = std::array<double, number_of_adaptive_candidates>;

public:
  // `size`: of how many samples the estimates are wanted
  Adaptive_estimator(Statistics& statistics, std::size_t size) : m_statistics(statistics), m_size(size) {}

  Adaptive_estimates operator()()
  {
    Adaptive_estimates result = no_estimates();
    std::vector<Index> others = take_quadrics(result);
    if(!others.empty())
    {
      if(others.size() < m_size)
        m_statistics.restrict_to(others);
      others = take_exact_ones(others, result);
    }
    if(!others.empty() && !m_statistics.is_cancelled())
    {
      m_statistics.restrict_to(others);
      blend(others, result);
    }
    if(m_statistics.is_cancelled()) // all or nothing: what would be chosen isn't known
      result = no_estimates();
    m_statistics.finish();
    return result;
  }

private:
  Adaptive_estimates no_estimates() const
  {
    Adaptive_estimates result;
    result.estimates.resize(m_size);
    result.choices.assign(m_size, Choice::NONE);
    return result;
  }

  // returns the samples that are to be estimated otherwise: not those at the tip of a cone
  std::vector<Index> take_quadrics(Adaptive_estimates& result) const
  {
    std::vector<Index> others;
    Fitted_field quadrics(m_size);
    std::vector<unsigned char> is_tip(m_size);
    using Quadric = Quadric_through_neighbors<SampledSurface>;
    for_each_sample<ConcurrencyTag, Quadric>(m_size,
                                             [&](const std::size_t i, Quadric& quadric)
                                             {
                                               quadrics[i] = quadric(m_statistics.surface(), i);
                                               is_tip[i] = quadric.is_at_tip();
                                             });
    for(std::size_t i = 0; i < m_size; ++i)
    {
      const Estimation_status status = m_statistics.surface().status(i);
      if(!is_estimated(status))
        result.estimates[i] = Curvature_estimate(status);
      else if(is_tip[i])
        result.estimates[i] = Curvature_estimate(Estimation_status::DEGENERATE);
      else if(is_estimated(quadrics[i].status))
        take(quadrics[i], Choice::QUADRIC, i, result);
      else
        others.push_back(Index(i));
    }
    return others;
  }

  // of these samples, returns those that are to be estimated otherwise
  std::vector<Index> take_exact_ones(const std::vector<Index>& samples, Adaptive_estimates& result)
  {
    std::vector<Index> others;
    for(const Choice choice : {Choice::EXACT_3_RINGS, Choice::POINTS_3_RINGS})
      m_statistics.field(choice);
    const Fitted_field& checked = m_statistics.field(Choice::CHECKED_3_RINGS);
    if(m_statistics.is_cancelled())
      return others;
    for(const Index i : samples)
      if(is_estimated(checked[i].status) &&
         normals_are_exact([&](const Adaptive_statistic name) { return m_statistics.statistic(name)[i]; },
                           adaptive_exactness))
        take(checked[i], Choice::CHECKED_3_RINGS, i, result);
      else
        others.push_back(i);
    return others;
  }

  void blend(const std::vector<Index>& samples, Adaptive_estimates& result)
  {
    std::array<const std::vector<double>*, number_of_adaptive_statistics> statistics;
    for(std::size_t k = 0; k < statistics.size(); ++k)
      statistics[k] = &m_statistics.statistic(Adaptive_statistic(k));
    Fields fields;
    for(std::size_t c = 0; c < fields.size(); ++c)
      fields[c] = &m_statistics.field(Choice(c));
    if(m_statistics.is_cancelled())
      return;
    for(const Index i : samples)
    {
      Scores scores = adaptive_scores([&](const std::size_t k) { return (*statistics[k])[i]; });
      blend(fields, scores, i, result);
    }
  }

  // `statistic(k)`: the k-th one of a sample
  template <typename Statistic>
  static Scores adaptive_scores(const Statistic& statistic)
  {
    std::array<double, number_of_adaptive_units> units = adaptive_unit_weights[0];
    for(std::size_t k = 0; k < number_of_adaptive_statistics; ++k)
    {
      const double x = statistic(k);
      for(std::size_t u = 0; u < units.size(); ++u)
        units[u] += adaptive_unit_weights[k + 1][u] * x;
    }
    Scores scores = adaptive_score_weights[0];
    for(std::size_t u = 0; u < units.size(); ++u)
    {
      const double unit = std::tanh(units[u]);
      for(std::size_t c = 0; c < scores.size(); ++c)
        scores[c] += adaptive_score_weights[u + 1][c] * unit;
    }
    return scores;
  }

  static void blend(const Fields& fields, Scores& scores, std::size_t i, Adaptive_estimates& result)
  {
    std::size_t best = 0;
    for(std::size_t c = 0; c < scores.size(); ++c)
    {
      if(!is_estimated((*fields[c])[i].status))
        scores[c] = std::numeric_limits<double>::infinity();
      if(scores[c] < scores[best])
        best = c;
    }
    const auto heir = [&](const std::size_t c)
    {
      const auto h = std::size_t(adaptive_heir(Choice(c)));
      return is_estimated((*fields[h])[i].status) ? h : c;
    };
    Fitted_sample mean = (*fields[heir(best)])[i];
    if(is_estimated(mean.status))
    {
      double sum = 1.;
      for(std::size_t c = 0; c < scores.size(); ++c)
        if(const double share = adaptive_share(scores[c] - scores[best]); c != best && share > 0.)
        {
          mean.add((*fields[heir(c)])[i], share);
          sum += share;
        }
      mean.divide(sum);
    }
    take(mean, is_estimated(mean.status) ? Choice(heir(best)) : Choice::NONE, i, result);
  }

  static void take(const Fitted_sample& fit, Choice choice, std::size_t i, Adaptive_estimates& result)
  {
    result.estimates[i] = fit.estimate();
    result.choices[i] = is_estimated(result.estimates[i].status) ? choice : Choice::NONE;
  }

  Statistics& m_statistics;
  std::size_t m_size;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_ESTIMATOR_H
