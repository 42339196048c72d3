#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_EXACT_FIT_ATTEMPTS_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_EXACT_FIT_ATTEMPTS_H

#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/interpolation/internal/Hermite_fit_rules.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// What a solved system (see Hermite_batch) says about its data, which are points and exact normals.
struct Fit_evidence
{
  std::size_t number_of_points = 0;
  double residual = 0., mahalanobis_square = 0., log_likelihood = 0.;

  double equations() const { return double(3 * number_of_points); }

  // The surface may bend much or little: of all factors that its covariance may have, the one that makes the data likeliest. Up to
  // a constant.
  double log_likelihood_of_any_amplitude() const
  {
    return log_likelihood + 0.5 * mahalanobis_square -
           0.5 * equations() * std::log(mahalanobis_square / equations());
  }
};

/*
  The attempts to fit exact normals. Where no smooth surface has these points and normals, they aren't exact, whatever was said of
  them: files round coordinates to single precision or to six digits, and normals to bytes; points lie beside the surface; normals
  are those of faces. A function that follows them all the same takes huge weights and bends wildly. Then points, normals or both
  are trusted less, step by step, as long as that makes the data much likelier.
*/
class Exact_fit_attempts
{
public:
  Exact_fit_attempts() = default;
  explicit Exact_fit_attempts(const Scaled_neighborhood& neighborhood)
  {
    m_tried.values = m_tried.derivatives = nugget(neighborhood.rounding_error);
  }

  double value_variance() const { return m_tried.values; }
  double derivative_variance() const { return m_tried.derivatives; }

  // whether the function describes a surface at a sample; `derivative`: along its normal
  static bool is_surface(const Fit_quality& quality, double derivative)
  {
    return quality.gradient_length > 0.1 && derivative > 0.5 * quality.gradient_length &&
           quality.largest_curvature < largest_plausible_curvature;
  }

  // after an attempt that failed: whether there is another, in which points and normals are trusted alike
  bool next()
  {
    m_tried.values = m_tried.derivatives = s_step * (std::min)(m_tried.values, m_tried.derivatives);
    return ++m_failures < s_attempts;
  }

  bool is_doubted() const { return m_stage != Stage::TRUST; }

  // after an attempt: whether the data may not be exact, by all but their likelihood
  bool is_in_doubt(const Fit_evidence& evidence) const
  {
    return m_stage == Stage::TRUST ? is_doubtful(evidence) : m_stage != Stage::VERDICT;
  }

  // if so: whether there is another attempt
  bool next_if_inexact(const Fit_evidence& evidence)
  {
    judge(evidence);
    if(m_stage == Stage::TRUST)
    {
      m_kept = m_likeliest = m_tried;
      m_is_first_kept = true;
      m_stage = Stage::VALUES;
    }
    else
    {
      if(m_tried.log_likelihood > m_likeliest.log_likelihood)
        m_likeliest = m_tried;
      if(m_stage == Stage::BOTH)
        end_round(evidence);
      else
        m_stage = m_stage == Stage::VALUES ? Stage::DERIVATIVES : Stage::BOTH;
    }
    const bool was_tried = m_tried.values == m_kept.values && m_tried.derivatives == m_kept.derivatives;
    m_tried = m_kept;
    if(m_stage == Stage::VERDICT)
      return !was_tried;
    const double factor = std::pow(s_step, m_hundredfolds);
    if(m_stage == Stage::VALUES || m_stage == Stage::BOTH)
      m_tried.values *= factor;
    if(m_stage == Stage::DERIVATIVES || m_stage == Stage::BOTH)
      m_tried.derivatives *= factor;
    return true;
  }

  // of the last attempt: whether it is the first one again, since nothing was found to be likelier
  bool is_first_again() const { return m_stage == Stage::VERDICT && m_is_first_kept; }

private:
  // variances, and what a system with them says
  struct Trust
  {
    double values = 0., derivatives = 0.;
    double log_likelihood = 0.;
    bool is_unlikely = false; // that the data are those of a surface
  };

  // what an attempt is: the first; those of a round: with less trust in points, normals, or both; the one with what was kept
  enum class Stage
  {
    TRUST,
    VALUES,
    DERIVATIVES,
    BOTH,
    VERDICT
  };

  static bool is_doubtful(const Fit_evidence& evidence)
  {
    const bool is_mostly_noise = evidence.residual > s_least_doubtful_residual * evidence.equations() &&
                                 evidence.residual > s_least_doubtful_share * evidence.mahalanobis_square;
    return is_mostly_noise || is_unlikely(evidence, s_least_absurd_square);
  }

  static bool is_unlikely(const Fit_evidence& evidence, double least_square)
  {
    return evidence.residual > s_least_unlikely_residual * evidence.equations() &&
           evidence.mahalanobis_square > least_square * evidence.equations();
  }

  void judge(const Fit_evidence& evidence)
  {
    m_tried.log_likelihood = evidence.log_likelihood_of_any_amplitude();
    m_tried.is_unlikely = is_unlikely(evidence, s_least_unlikely_square);
  }

  // Goes on with the likeliest of a round. If it hardly gains, and the data remain unlikely, they may be so far from exact that it takes
  // a larger step to see it, which has to gain more.
  void end_round(const Fit_evidence& evidence)
  {
    const double least_gain = s_least_gain * evidence.equations() * m_hundredfolds;
    const bool is_gain = m_likeliest.log_likelihood > m_kept.log_likelihood + least_gain;
    if(is_gain)
    {
      m_kept = m_likeliest;
      m_is_first_kept = false;
    }
    m_hundredfolds = is_gain ? 1 : m_hundredfolds + 1;
    const bool goes_on =
        (is_gain || (m_kept.is_unlikely && m_hundredfolds <= s_most_hundredfolds)) && ++m_rounds < s_rounds;
    m_stage = goes_on ? Stage::VALUES : Stage::VERDICT;
  }

  static constexpr int s_attempts = 8, s_rounds = 12, s_most_hundredfolds = 4;
  static constexpr double s_step = 100.;
  // Of an equation, on average, and of the Mahalanobis square. Coordinates in single precision leave more on fine meshes, a tenth of
  // the square and more. Exact data of coarse meshes mostly leave some thousandths of it: less trust would seldom gain as much. What a
  // step has to gain is of an equation, too.
  static constexpr double s_least_doubtful_residual = 1e-4, s_least_doubtful_share = 0.02, s_least_gain = 0.3;
  // Of an equation, on average. Exact normals of waves with 6 samples a period reach .1 and 30, mostly .001 and 1; those of faces
  // 10 and 1000, on fine meshes as well as on coarse ones. Where an exact surface bends more than samples can tell, it mostly keeps
  // to one of both.
  static constexpr double s_least_unlikely_residual = 0.1, s_least_absurd_square = 200.;
  // The same, of data that are doubted already. Those of a surface have one on average.
  static constexpr double s_least_unlikely_square = 5.;

  Trust m_tried, m_kept, m_likeliest;
  Stage m_stage = Stage::TRUST;
  int m_failures = 0, m_rounds = 0;
  bool m_is_first_kept = false;
  int m_hundredfolds = 1; // less trust than in what was kept, in an attempt
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_EXACT_FIT_ATTEMPTS_H
