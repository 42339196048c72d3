#include "Score_learner.h"

#include <Shape_characteristics/curvature/internal/adaptive_scores.h>

#include <CGAL/for_each.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <ostream>
#include <sstream>
#include <utility>

namespace adaptive {
namespace {

constexpr auto features = Eigen::Index(number_of_statistics + 1); // the constant, and all statistics
constexpr auto candidates = Eigen::Index(number_of_candidates);

constexpr std::array<const char*, number_of_statistics> statistic_names = {
    "EXACT_2_ANGLES",       "EXACT_3_ANGLES",        "POINTS_2_ANGLES",
    "POINTS_3_ANGLES",      "POINTS_4_ANGLES",       "NORMALS_2_ANGLES",
    "NORMALS_3_ANGLES",     "SMOOTHED_3_ANGLES",     "SMOOTHED_4_ANGLES",
    "GENTLY_4_ANGLES",      "BARELY_4_ANGLES",       "CHECKED_2_ANGLES",
    "CHECKED_3_ANGLES",     "EXACT_2_TURNS",         "EXACT_3_TURNS",
    "POINTS_2_TURNS",       "POINTS_3_TURNS",        "POINTS_4_TURNS",
    "NORMALS_2_TURNS",      "NORMALS_3_TURNS",       "SMOOTHED_3_TURNS",
    "SMOOTHED_4_TURNS",     "GENTLY_4_TURNS",        "BARELY_4_TURNS",
    "CHECKED_2_TURNS",      "CHECKED_3_TURNS",       "EXACT_2_EXACT_3",
    "POINTS_2_POINTS_3",    "POINTS_3_POINTS_4",     "EXACT_3_POINTS_3",
    "EXACT_2_NORMALS_2",    "NORMALS_2_NORMALS_3",   "EXACT_3_NORMALS_3",
    "POINTS_3_NORMALS_3",   "POINTS_3_SMOOTHED_3",   "POINTS_4_SMOOTHED_4",
    "NORMALS_3_SMOOTHED_3", "SMOOTHED_3_SMOOTHED_4", "SMOOTHED_3_GENTLY_4",
    "SMOOTHED_4_GENTLY_4",  "GENTLY_4_BARELY_4",     "POINTS_4_BARELY_4",
    "CHECKED_2_CHECKED_3",  "CHECKED_3_POINTS_3",    "CHECKED_2_NORMALS_2",
    "CHECKED_3_NORMALS_3",  "EXACT_3_CHECKED_3",     "POINTS_3_NORMALS",
    "SMOOTHED_3_NORMALS",   "POINTS_3_BEND",         "SMOOTHED_3_BEND",
    "SMOOTHED_3_MOVES",     "SMOOTHED_3_DRIFT",      "NOISE",
    "IRREGULARITY"};

float exactness_of(const std::array<float, number_of_statistics>& s)
{
  using Name = Shape_characteristics::internal::Adaptive_statistic;
  return s[std::size_t(Name::EXACT_3_ANGLES)] - s[std::size_t(Name::POINTS_3_ANGLES)];
}

// of the fit that takes the share of a candidate
const Vertex_record::Error& error_of_share(const Vertex_record& vertex, std::size_t candidate)
{
  const auto heir = std::size_t(Shape_characteristics::internal::adaptive_heir(
      Shape_characteristics::Adaptive_estimator_choice(candidate)));
  return vertex.errors[std::isfinite(vertex.errors[heir].k_max) ? heir : candidate];
}

constexpr auto of_exact_normals =
    std::size_t(Shape_characteristics::Adaptive_estimator_choice::CHECKED_3_RINGS);
constexpr auto first_checked = std::size_t(Shape_characteristics::Adaptive_estimator_choice::CHECKED_2_RINGS);

using Matrix = Eigen::MatrixXd;

// The vertices of a row: what is known, and the candidates' errors in units of the best one's mean; one line per vertex.
struct Data
{
  Matrix statistics, k_max, k_min;
  Matrix penalties;     // of the scores: large where there is no estimate
  std::size_t part = 0; // of the surfaces
};

/*
  Minimizes, over the weights, the mean of the logarithms of the rows' errors, and of the squares of what they exceed that of
  the row's best candidate by, if at each vertex the candidates are blended in proportion to exp(-score): by gradients (Adam's
  method), for all rows but those of a part. Where the weights of the other candidates are kept, those of the checked ones start
  somewhat worse than those of normals that are trusted.
*/
class Learner
{
public:
  Learner(const std::vector<Calibration_row>& rows, const Scores* kept) : m_rows(rows), m_kept(kept)
  {
    std::map<std::string, std::size_t> groups;
    for(const Calibration_row& row : rows)
    {
      constexpr double largest = 30.; // a few vertices mustn't decide alone
      const auto bounded = [&](float error)
      { return (std::max)(-largest, (std::min)(double(error) / row.best_error, largest)); };
      Data data;
      data.part = groups.emplace(row.group, groups.size()).first->second % parts;
      data.statistics.resize(Eigen::Index(row.vertices.size()), features);
      data.k_max.resize(data.statistics.rows(), candidates);
      data.k_min = data.penalties = data.k_max;
      for(Eigen::Index v = 0; v < data.statistics.rows(); ++v)
      {
        const Vertex_record& vertex = row.vertices[std::size_t(v)];
        data.statistics(v, 0) = 1.;
        for(std::size_t s = 0; s < number_of_statistics; ++s)
          data.statistics(v, Eigen::Index(s + 1)) = double(vertex.statistics[s]);
        for(std::size_t c = 0; c < number_of_candidates; ++c)
        {
          data.k_max(v, Eigen::Index(c)) = bounded(error_of_share(vertex, c).k_max);
          data.k_min(v, Eigen::Index(c)) = bounded(error_of_share(vertex, c).k_min);
          data.penalties(v, Eigen::Index(c)) = std::isfinite(vertex.errors[c].k_max) ? 0. : 1e3;
        }
      }
      m_data.push_back(std::move(data));
    }
    normalize();
    if(kept != nullptr)
    {
      m_exactness = kept->exactness;
      return;
    }
    // where normals are exact beyond doubt: as many vertices as cost nearly nothing
    for(double exactness = -3.; exactness <= 0.; exactness += .05)
      if(cost_of_gate(exactness) < .002)
        m_exactness = exactness;
  }

  static constexpr std::size_t parts = 6;
  std::size_t part(std::size_t row) const { return m_data[row].part; }

  Scores learn(std::size_t left_out) const
  {
    constexpr int steps = 2000;
    constexpr double decay = .995;
    const double shrinkage = m_kept == nullptr ? 5e-6 : 1e-4;
    const Matrix start = start_weights();
    const auto kept = m_kept == nullptr ? Eigen::Index(0) : Eigen::Index(first_checked);
    const auto learned = candidates - kept;
    const std::vector<Matrix> known = known_shares(start.leftCols(kept));
    Matrix weights = start, mean = Matrix::Zero(features, learned), square = mean;
    std::size_t number = 0;
    for(const Data& data : m_data)
      number += data.part != left_out;
    double rate = .1, mean_share = 1., square_share = 1.;
    for(int step = 0; step < steps; ++step)
    {
      const Matrix gradient = shrinkage * (weights - start).rightCols(learned) +
                              sum_of_gradients(left_out, known, weights.rightCols(learned)) / double(number);
      mean = .9 * mean + .1 * gradient;
      square = .99 * square + .01 * gradient.cwiseAbs2();
      mean_share *= .9;
      square_share *= .99;
      const Matrix way = (rate * (mean.array() / (1. - mean_share)) /
                          ((square.array() / (1. - square_share)).sqrt() + 1e-10))
                             .matrix();
      weights.rightCols(learned) -= way;
      rate = (std::max)(rate * decay, .01);
    }
    // in units of the statistics themselves
    Scores scores;
    scores.exactness = m_exactness;
    scores.weights.resize(number_of_statistics + 1);
    for(std::size_t c = 0; c < number_of_candidates; ++c)
    {
      double constant = weights(0, Eigen::Index(c));
      for(Eigen::Index f = 1; f < features; ++f)
      {
        const double w = weights(f, Eigen::Index(c)) / m_deviation[f];
        scores.weights[std::size_t(f)][c] = w;
        constant -= w * m_mean[f];
      }
      scores.weights[0][c] = constant;
    }
    for(std::size_t s = 0; s < number_of_statistics; ++s)
      scores.statistics.push_back(s);
    return scores;
  }

private:
  // in units of the deviations: zero, or what is kept
  Matrix start_weights() const
  {
    using Choice = Shape_characteristics::Adaptive_estimator_choice;
    Matrix weights = Matrix::Zero(features, candidates);
    if(m_kept == nullptr)
      return weights;
    for(std::size_t c = 0; c < number_of_candidates; ++c)
    {
      const std::size_t from = c < first_checked    ? c
                               : c == first_checked ? std::size_t(Choice::NORMALS_2_RINGS)
                                                    : std::size_t(Choice::NORMALS_3_RINGS);
      const auto column = Eigen::Index(c);
      weights(0, column) = m_kept->weights[0][from] + (c < first_checked ? 0. : 1.);
      for(std::size_t k = 0; k < m_kept->statistics.size(); ++k)
      {
        const auto f = Eigen::Index(m_kept->statistics[k] + 1);
        weights(f, column) = m_kept->weights[k + 1][from] * m_deviation[f];
        weights(0, column) += m_kept->weights[k + 1][from] * m_mean[f];
      }
    }
    return weights;
  }

  void normalize()
  {
    m_mean = Eigen::VectorXd::Zero(features);
    m_deviation = Eigen::VectorXd::Zero(features);
    double number = 0.;
    for(const Data& data : m_data)
    {
      m_mean += data.statistics.colwise().sum().transpose();
      number += double(data.statistics.rows());
    }
    m_mean /= number;
    for(const Data& data : m_data)
      m_deviation += (data.statistics.rowwise() - m_mean.transpose()).cwiseAbs2().colwise().sum().transpose();
    m_deviation = (m_deviation / number).cwiseSqrt();
    m_mean[0] = 0.; // the constant
    m_deviation[0] = 1.;
    for(Data& data : m_data)
      data.statistics = ((data.statistics.rowwise() - m_mean.transpose()).array().rowwise() /
                         m_deviation.transpose().array())
                            .matrix()
                            .eval();
  }

  // what is known of the logarithms of the shares: of each row, those of the candidates whose weights are kept
  std::vector<Matrix> known_shares(const Matrix& weights) const
  {
    std::vector<Matrix> result;
    for(const Data& data : m_data)
      result.push_back(-data.statistics * weights);
    return result;
  }

  // the sum over the rows, in the same order for any number of threads; by the weights of the last candidates
  Matrix sum_of_gradients(std::size_t left_out, const std::vector<Matrix>& known, const Matrix& weights) const
  {
    constexpr std::size_t number = 16;
    std::vector<std::size_t> chunks(number);
    std::iota(chunks.begin(), chunks.end(), std::size_t(0));
    std::vector<Matrix> sums(number, Matrix::Zero(weights.rows(), weights.cols()));
    CGAL::for_each<CGAL::Parallel_if_available_tag>(
        chunks,
        [&](const std::size_t chunk)
        {
          for(std::size_t r = chunk; r < m_data.size(); r += number)
            if(m_data[r].part != left_out)
              add_gradient(m_data[r], known[r], weights, sums[chunk]);
          return true;
        });
    return std::accumulate(sums.begin(), sums.end(), Matrix(Matrix::Zero(weights.rows(), weights.cols())));
  }

  static void add_gradient(const Data& data, const Matrix& known, const Matrix& weights, Matrix& gradient)
  {
    Matrix shares = -data.penalties;
    shares.leftCols(known.cols()) += known;
    shares.rightCols(weights.cols()) -= data.statistics * weights;
    const Eigen::VectorXd largest = shares.rowwise().maxCoeff();
    shares = (shares.colwise() - largest).array().exp().matrix().eval();
    const Eigen::VectorXd sums = shares.rowwise().sum();
    for(Eigen::Index v = 0; v < shares.rows(); ++v)
      shares.row(v) /= sums[v];
    const Eigen::VectorXd k_max = shares.cwiseProduct(data.k_max).rowwise().sum(),
                          k_min = shares.cwiseProduct(data.k_min).rowwise().sum();
    const double error = k_max.cwiseAbs().sum() + k_min.cwiseAbs().sum();
    // d error / d share, then d error / d score
    const Matrix of_shares = (data.k_max.array().colwise() * k_max.array().sign() +
                              data.k_min.array().colwise() * k_min.array().sign())
                                 .matrix();
    const Eigen::VectorXd means = shares.cwiseProduct(of_shares).rowwise().sum();
    const Matrix of_scores = -shares.cwiseProduct(of_shares.colwise() - means);
    // of what the row's error exceeds that of its best candidate by, as a logarithm
    constexpr double borne = .05;
    const double excess = (std::max)(std::log(error / double(shares.rows())) - borne, 0.);
    gradient +=
        (1. + 2. * excess) / error * data.statistics.transpose() * of_scores.rightCols(weights.cols());
  }

  // mean over the rows of the logarithm of the excess, if CHECKED_3_RINGS was chosen there, and else what is best for the row
  double cost_of_gate(double exactness) const
  {
    double sum = 0.;
    for(const Calibration_row& row : m_rows)
    {
      double error = 0.;
      for(const Vertex_record& v : row.vertices)
        error += double(exactness_of(v.statistics)) < exactness
                     ? (std::max)((std::min)(v.errors[of_exact_normals].sum() / row.best_error, 100.), 1.)
                     : 1.;
      sum += std::log(error / double(row.vertices.size()));
    }
    return sum / double(m_rows.size());
  }

  const std::vector<Calibration_row>& m_rows;
  const Scores* m_kept;
  std::vector<Data> m_data;
  Eigen::VectorXd m_mean, m_deviation;
  double m_exactness = -1e3;
};

} // namespace

std::size_t best_candidate(const Row& row)
{
  return std::size_t(std::min_element(row.mean_errors.begin(), row.mean_errors.end()) -
                     row.mean_errors.begin());
}

Calibration_row calibration_row(const Row& row, std::size_t at_most)
{
  Calibration_row result;
  result.group = row.surface.substr(0, row.surface.find(" random"));
  for(const char* tessellation : {" grid", " exact cubes", " original cubes"})
    result.group = result.group.substr(0, result.group.find(tessellation));
  const std::size_t step = (std::max)(row.vertices.size() / at_most, std::size_t(1));
  for(std::size_t k = 0; k < row.vertices.size(); k += step)
    result.vertices.push_back(row.vertices[k]);
  result.best_error = std::numeric_limits<double>::infinity();
  for(std::size_t c = 0; c < number_of_candidates; ++c)
    result.best_error = (std::min)(result.best_error, mean_error(result.vertices, c));
  return result;
}

Vertex_record::Error blend(const Scores& scores, const Vertex_record& vertex)
{
  const auto statistic = [&](const Shape_characteristics::internal::Adaptive_statistic name)
  { return double(vertex.statistics[std::size_t(name)]); };
  if(Shape_characteristics::internal::normals_are_exact(statistic, scores.exactness))
    return vertex.errors[of_exact_normals];
  std::array<double, number_of_candidates> score = scores.weights[0];
  for(std::size_t k = 0; k < scores.statistics.size(); ++k)
    for(std::size_t c = 0; c < number_of_candidates; ++c)
      score[c] += scores.weights[k + 1][c] * double(vertex.statistics[scores.statistics[k]]);
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t c = 0; c < number_of_candidates; ++c)
    if(std::isfinite(vertex.errors[c].k_max))
      least = (std::min)(least, score[c]);
  double sum = 0., k_max = 0., k_min = 0.;
  for(std::size_t c = 0; c < number_of_candidates; ++c)
    if(std::isfinite(vertex.errors[c].k_max))
    {
      const double share = Shape_characteristics::internal::adaptive_share(score[c] - least);
      sum += share;
      k_max += share * double(error_of_share(vertex, c).k_max);
      k_min += share * double(error_of_share(vertex, c).k_min);
    }
  return {float(k_max / sum), float(k_min / sum)};
}

double excess(const Scores& scores, const Calibration_row& row)
{
  constexpr double largest = 100.; // a single vertex mustn't decide alone
  double sum = 0.;
  for(const Vertex_record& v : row.vertices)
    sum += (std::min)(blend(scores, v).sum() / row.best_error, largest);
  return sum / double(row.vertices.size());
}

Scores scores_of_library()
{
  namespace internal = Shape_characteristics::internal;
  Scores scores;
  scores.exactness = internal::adaptive_exactness;
  for(const internal::Adaptive_statistic s : internal::adaptive_score_statistics)
    scores.statistics.push_back(std::size_t(s));
  scores.weights.assign(internal::adaptive_score_weights.begin(), internal::adaptive_score_weights.end());
  return scores;
}

Scores learn_scores(const std::vector<Calibration_row>& rows, const Scores* kept, std::ostream& log)
{
  const Learner learner(rows, kept);
  double sum = 0.;
  std::size_t missed = 0;
  for(std::size_t part = 0; part < Learner::parts; ++part)
  {
    const Scores scores = learner.learn(part);
    for(std::size_t r = 0; r < rows.size(); ++r)
      if(learner.part(r) == part)
      {
        const double ratio = excess(scores, rows[r]);
        sum += std::log(ratio);
        missed += ratio > 1.1;
      }
  }
  log << "Surfaces left out in turns: the mean error is " << std::exp(sum / double(rows.size()))
      << " times that of the best candidate of each row (geometric), more than 1.1 times in " << missed
      << " of " << rows.size() << " rows\n";
  const Scores scores = learner.learn(Learner::parts);
  sum = 0.;
  missed = 0;
  for(const Calibration_row& row : rows)
  {
    const double ratio = excess(scores, row);
    sum += std::log(ratio);
    missed += ratio > 1.1;
  }
  log << "With all surfaces: " << std::exp(sum / double(rows.size())) << ", in " << missed << " rows\n";
  return scores;
}

std::string to_header(const Scores& scores, bool some_kept)
{
  const auto text = [](const double x)
  {
    char result[32];
    std::snprintf(result, sizeof result, "%.4f", x);
    return std::string(result);
  };
  std::ostringstream out;
  out << "#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H\n"
         "#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H\n\n"
         "#include <Shape_characteristics/curvature/internal/Adaptive_statistics.h>\n\n"
         "#include <array>\n#include <cstddef>\n\n"
         "namespace Shape_characteristics {\nnamespace internal {\n\n"
         "// The constants of adaptive_curvatures(), learned from surfaces whose curvature is known. Not "
         "written by hand: they are the\n// output of\n//   benchmark_adaptive_adaptive --calibrate "
         "adaptive_scores.h"
      << (some_kept ? " --keep\n// as for CHECKED_2_RINGS and CHECKED_3_RINGS; the others, and the "
                      "exactness, are of an "
                      "earlier one without --keep."
                    : "")
      << "\n\n// where EXACT_3_ANGLES - POINTS_3_ANGLES is less, CHECKED_3_RINGS is chosen\n"
         "inline constexpr double adaptive_exactness = "
      << text(scores.exactness)
      << ";\n\n// Elsewhere the estimators are blended in proportion to exp(-score): a linear function of "
         "these "
         "statistics.\n"
         "// clang-format off\n"
         "inline constexpr std::array<Adaptive_statistic, "
      << scores.statistics.size() << "> adaptive_score_statistics = {{\n";
  for(std::size_t k = 0; k < scores.statistics.size(); ++k)
    out << "    Adaptive_statistic::" << statistic_names[scores.statistics[k]]
        << (k + 1 < scores.statistics.size() ? ",\n" : "}};\n");
  out << "inline constexpr std::array<std::array<double, number_of_adaptive_candidates>, "
      << scores.weights.size() << "> adaptive_score_weights = {{\n";
  for(std::size_t k = 0; k < scores.weights.size(); ++k)
  {
    out << "    {{";
    for(std::size_t c = 0; c < number_of_candidates; ++c)
      out << text(scores.weights[k][c]) << (c + 1 < number_of_candidates ? ", " : "}}");
    out << (k + 1 < scores.weights.size() ? "," : "}};") << " // "
        << (k == 0 ? "1" : statistic_names[scores.statistics[k - 1]]) << "\n";
  }
  out << "// clang-format on\n\n} // namespace internal\n} // namespace Shape_characteristics\n\n"
         "#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H\n";
  return out.str();
}

} // namespace adaptive
