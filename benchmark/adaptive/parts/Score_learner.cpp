#include "Score_learner.h"

#include "Random.h"

#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace adaptive {
namespace {

constexpr auto features = Eigen::Index(number_of_statistics + 1); // 1, and all statistics
constexpr auto candidates = Eigen::Index(number_of_candidates);
constexpr Eigen::Index units = 48;

// clang-format off
constexpr std::array<const char*, number_of_statistics> statistic_names = {
    "EXACT_2_ANGLES", "EXACT_3_ANGLES", "POINTS_2_ANGLES", "POINTS_3_ANGLES", "POINTS_4_ANGLES",
    "NORMALS_2_ANGLES", "NORMALS_3_ANGLES", "SMOOTHED_3_ANGLES", "SMOOTHED_4_ANGLES", "GENTLY_4_ANGLES",
    "BARELY_4_ANGLES", "CHECKED_2_ANGLES", "CHECKED_3_ANGLES", "EXACT_2_TURNS", "EXACT_3_TURNS",
    "POINTS_2_TURNS", "POINTS_3_TURNS", "POINTS_4_TURNS", "NORMALS_2_TURNS", "NORMALS_3_TURNS",
    "SMOOTHED_3_TURNS", "SMOOTHED_4_TURNS", "GENTLY_4_TURNS", "BARELY_4_TURNS", "CHECKED_2_TURNS",
    "CHECKED_3_TURNS", "EXACT_2_EXACT_3", "POINTS_2_POINTS_3", "POINTS_3_POINTS_4", "EXACT_3_POINTS_3",
    "EXACT_2_NORMALS_2", "NORMALS_2_NORMALS_3", "EXACT_3_NORMALS_3", "POINTS_3_NORMALS_3",
    "POINTS_3_SMOOTHED_3", "POINTS_4_SMOOTHED_4", "NORMALS_3_SMOOTHED_3", "SMOOTHED_3_SMOOTHED_4",
    "SMOOTHED_3_GENTLY_4", "SMOOTHED_4_GENTLY_4", "GENTLY_4_BARELY_4", "POINTS_4_BARELY_4",
    "CHECKED_2_CHECKED_3", "CHECKED_3_POINTS_3", "CHECKED_2_NORMALS_2", "CHECKED_3_NORMALS_3",
    "EXACT_3_CHECKED_3", "POINTS_3_NORMALS", "SMOOTHED_3_NORMALS", "POINTS_3_BEND", "SMOOTHED_3_BEND",
    "SMOOTHED_3_MOVES", "SMOOTHED_3_DRIFT", "NOISE", "NOISE_BESIDE_BENDS", "IRREGULARITY",
    "NORMALS_BY_1E_3", "NORMALS_BY_1E_2", "NORMALS_BY_1E_1", "POINTS_BY_1E_6", "POINTS_BY_1E_3",
    "POINTS_BY_1E_2", "POINTS_BY_3E_2", "LIKELY_NOISE_OF_POINTS", "LIKELY_NOISE_OF_NORMALS",
    "NEITHER_IS_NOISY", "ROUGH_NORMALS_BY_1E_3", "ROUGH_NORMALS_BY_1E_2", "ROUGH_NORMALS_BY_1E_1",
    "ROUGH_POINTS_BY_1E_6", "ROUGH_POINTS_BY_1E_3", "ROUGH_POINTS_BY_1E_2", "ROUGH_POINTS_BY_3E_2",
    "ROUGH_LIKELY_NOISE_OF_POINTS", "ROUGH_LIKELY_NOISE_OF_NORMALS", "ROUGH_NEITHER_IS_NOISY"};
// clang-format on
static_assert(statistic_names.back() != nullptr);

using Matrix = Eigen::MatrixXf;
using Statistic = Shape_characteristics::internal::Adaptive_statistic;

float exactness_of(const std::array<float, number_of_statistics>& s)
{
  return s[std::size_t(Statistic::EXACT_3_ANGLES)] - s[std::size_t(Statistic::POINTS_3_ANGLES)];
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

bool are_exact(const Vertex_record& vertex, double exactness)
{
  return std::isfinite(vertex.errors[of_exact_normals].k_max) &&
         Shape_characteristics::internal::normals_are_exact(
             [&](const Statistic name) { return double(vertex.statistics[std::size_t(name)]); }, exactness);
}

// The vertices of a row: what is known, and the candidates' errors in units of the best one's mean; one column per vertex.
struct Data
{
  Matrix statistics, k_max, k_min;
  Matrix penalties;        // of the scores: large where there is no estimate
  std::vector<float> told; // the error where exact normals are chosen, or else negative
  std::size_t part = 0;    // of the surfaces
};

// what is learned, for statistics in units of their deviations
struct Net
{
  Matrix units_of_statistics, scores_of_units;

  void operator+=(const Net& other)
  {
    units_of_statistics += other.units_of_statistics;
    scores_of_units += other.scores_of_units;
  }

  static Net zero() { return {Matrix::Zero(features, units), Matrix::Zero(units + 1, candidates)}; }

  static Net random()
  {
    Net net = zero();
    benchmark_support::Random random(1);
    for(Eigen::Index u = 0; u < units; ++u)
      for(Eigen::Index f = 0; f < features; ++f)
        net.units_of_statistics(f, u) = float(random.gaussian() / std::sqrt(double(features)));
    for(Eigen::Index c = 0; c < candidates; ++c)
      for(Eigen::Index u = 1; u <= units; ++u)
        net.scores_of_units(u, c) = float(.1 * random.gaussian());
    return net;
  }
};

// a step against the gradient for each number, in units of how large its gradients are (Adam's method)
class Descent
{
public:
  explicit Descent(const Matrix& start) : m_mean(Matrix::Zero(start.rows(), start.cols())), m_square(m_mean)
  {}

  void step(Matrix& weights, const Matrix& gradient, double rate)
  {
    constexpr float of_mean = .1f, of_square = .01f;
    m_mean += of_mean * (gradient - m_mean);
    m_square += of_square * (gradient.cwiseAbs2() - m_square);
    m_mean_share *= 1. - double(of_mean);
    m_square_share *= 1. - double(of_square);
    const auto of_mean_yet = float(1. - m_mean_share), of_square_yet = float(1. - m_square_share);
    weights -=
        (float(rate) * (m_mean.array() / of_mean_yet) / ((m_square.array() / of_square_yet).sqrt() + 1e-8f))
            .matrix();
  }

private:
  Matrix m_mean, m_square;
  double m_mean_share = 1., m_square_share = 1.;
};

/*
  Minimizes the mean of the logarithms of the rows' errors, and of the squares of what they exceed that of the row's best candidate by,
  if at each vertex the candidates are blended in proportion to exp(-score): by gradients over a few rows at a time, for all
  rows but those of a part. The net is the mean of those of the last steps.
*/
class Learner
{
public:
  explicit Learner(const std::vector<Calibration_row>& rows) : m_rows(rows)
  {
    // where normals are exact beyond doubt: as many vertices as cost nearly nothing
    for(double exactness = -3.; exactness <= 0.; exactness += .05)
      if(cost_of_gate(exactness) < .002)
        m_exactness = exactness;
    find_deviations();
    std::map<std::string, std::size_t> groups;
    for(const Calibration_row& row : rows)
    {
      m_data.push_back(data_of(row));
      m_data.back().part = groups.emplace(row.group, groups.size()).first->second % parts;
    }
  }

  static constexpr std::size_t parts = 6;
  std::size_t part(std::size_t row) const { return m_data[row].part; }

  Scores learn(std::size_t left_out) const
  {
    constexpr std::size_t rounds = 200, batch = 48;
    constexpr double largest_rate = .01, least_rate = 1e-5, of_last_steps = .8;
    std::vector<std::size_t> order;
    for(std::size_t r = 0; r < m_data.size(); ++r)
      if(m_data[r].part != left_out)
        order.push_back(r);
    Net net = Net::random(), sum = Net::zero();
    Descent of_units(net.units_of_statistics), of_scores(net.scores_of_units);
    const std::size_t batches = (order.size() + batch - 1) / batch, steps = rounds * batches;
    std::size_t last_steps = 0;
    benchmark_support::Random random(2);
    for(std::size_t step = 0; step < steps; ++step)
    {
      if(step % batches == 0)
        for(std::size_t k = order.size(); k > 1; --k)
          std::swap(order[k - 1], order[std::size_t(random.uniform(0., 1.) * double(k))]);
      const std::size_t begin = step % batches * batch, end = (std::min)(begin + batch, order.size());
      const Net gradient = gradient_of(net, order, begin, end);
      const double progress = double(step + 1) / double(steps);
      const double rate = largest_rate * .5 * (1. + std::cos(CGAL_PI * progress)) + least_rate;
      of_units.step(net.units_of_statistics, gradient.units_of_statistics, rate);
      of_scores.step(net.scores_of_units, gradient.scores_of_units, rate);
      if(progress > of_last_steps)
      {
        sum += net;
        ++last_steps;
      }
    }
    return scores_of(sum, 1. / double(last_steps));
  }

private:
  Data data_of(const Calibration_row& row) const
  {
    constexpr double largest = 30., largest_told = 100.; // a few vertices mustn't decide alone
    const auto bounded = [&](float error)
    { return float((std::max)(-largest, (std::min)(double(error) / row.best_error, largest))); };
    Data data;
    const auto n = Eigen::Index(row.vertices.size());
    data.statistics.resize(features, n);
    data.k_max.resize(candidates, n);
    data.k_min = data.penalties = data.k_max;
    for(Eigen::Index v = 0; v < n; ++v)
    {
      const Vertex_record& vertex = row.vertices[std::size_t(v)];
      data.statistics(0, v) = 1.f;
      for(Eigen::Index f = 1; f < features; ++f)
        data.statistics(f, v) =
            float((double(vertex.statistics[std::size_t(f - 1)]) - m_mean[f]) / m_deviation[f]);
      for(Eigen::Index c = 0; c < candidates; ++c)
      {
        data.k_max(c, v) = bounded(error_of_share(vertex, std::size_t(c)).k_max);
        data.k_min(c, v) = bounded(error_of_share(vertex, std::size_t(c)).k_min);
        data.penalties(c, v) = std::isfinite(vertex.errors[std::size_t(c)].k_max) ? 0.f : 1e3f;
      }
      data.told.push_back(
          are_exact(vertex, m_exactness)
              ? float((std::min)(vertex.errors[of_exact_normals].sum() / row.best_error, largest_told))
              : -1.f);
    }
    return data;
  }

  void find_deviations()
  {
    m_mean = m_deviation = Eigen::VectorXd::Zero(features);
    double number = 0.;
    for(const Calibration_row& row : m_rows)
      for(const Vertex_record& v : row.vertices)
      {
        ++number;
        for(Eigen::Index f = 1; f < features; ++f)
        {
          const auto x = double(v.statistics[std::size_t(f - 1)]);
          m_mean[f] += x;
          m_deviation[f] += x * x;
        }
      }
    m_mean /= number;
    m_deviation = (m_deviation / number - m_mean.cwiseAbs2()).cwiseMax(1e-12).cwiseSqrt();
  }

  // that of some rows, `order[begin]` and so on: the same for any number of threads
  Net gradient_of(const Net& net,
                  const std::vector<std::size_t>& order,
                  std::size_t begin,
                  std::size_t end) const
  {
    constexpr std::size_t number = 8;
    constexpr float shrinkage = 3e-4f;
    std::vector<Net> gradients(number, Net::zero());
    Shape_characteristics::for_each_sample<CGAL::Parallel_if_available_tag,
                                           Shape_characteristics::No_workspace>(
        number,
        [&](const std::size_t chunk, Shape_characteristics::No_workspace&)
        {
          for(std::size_t k = begin + chunk; k < end; k += number)
            add_gradient(m_data[order[k]], net, 1.f / float(end - begin), gradients[chunk]);
        },
        {}, 1);
    Net sum = Net::zero();
    for(const Net& gradient : gradients)
      sum += gradient;
    sum.units_of_statistics += shrinkage * net.units_of_statistics;
    sum.scores_of_units.bottomRows(units) += shrinkage * net.scores_of_units.bottomRows(units);
    return sum;
  }

  static void add_gradient(const Data& data, const Net& net, float weight, Net& gradient)
  {
    const Eigen::Index n = data.statistics.cols();
    Matrix of_units(units + 1, n);
    of_units.row(0).setOnes();
    of_units.bottomRows(units) =
        (net.units_of_statistics.transpose() * data.statistics).array().tanh().matrix();
    Matrix shares = -net.scores_of_units.transpose() * of_units - data.penalties;
    const Eigen::RowVectorXf largest = shares.colwise().maxCoeff();
    shares = (shares.rowwise() - largest).array().exp().matrix().eval();
    const Eigen::RowVectorXf sums = shares.colwise().sum();
    shares.array().rowwise() /= sums.array();
    const Eigen::RowVectorXf k_max = shares.cwiseProduct(data.k_max).colwise().sum(),
                             k_min = shares.cwiseProduct(data.k_min).colwise().sum();
    // d error / d share, then d error / d score
    Matrix of_shares = (data.k_max.array().rowwise() * k_max.array().sign() +
                        data.k_min.array().rowwise() * k_min.array().sign())
                           .matrix();
    double error = 0.;
    for(Eigen::Index v = 0; v < n; ++v)
      if(const float told = data.told[std::size_t(v)]; told < 0.f)
        error += double(std::abs(k_max[v]) + std::abs(k_min[v]));
      else
      {
        error += double(told);
        of_shares.col(v).setZero();
      }
    const Eigen::RowVectorXf means = shares.cwiseProduct(of_shares).colwise().sum();
    // of what the row's error exceeds that of its best candidate by, as a logarithm
    constexpr double borne = .05;
    const double excess = (std::max)(std::log(error / double(n)) - borne, 0.);
    const Matrix of_scores =
        (-weight * float((1. + 2. * excess) / error)) * shares.cwiseProduct(of_shares.rowwise() - means);
    gradient.scores_of_units += of_units * of_scores.transpose();
    const Matrix of_tangents =
        (net.scores_of_units.bottomRows(units) * of_scores)
            .cwiseProduct((1.f - of_units.bottomRows(units).array().square()).matrix());
    gradient.units_of_statistics += data.statistics * of_tangents.transpose();
  }

  // of a net times `factor`, in units of the statistics themselves
  Scores scores_of(const Net& net, double factor) const
  {
    Scores result;
    result.exactness = m_exactness;
    result.units.assign(std::size_t(features), std::vector<double>(std::size_t(units)));
    for(Eigen::Index u = 0; u < units; ++u)
    {
      double constant = factor * double(net.units_of_statistics(0, u));
      for(Eigen::Index f = 1; f < features; ++f)
      {
        const double w = factor * double(net.units_of_statistics(f, u)) / m_deviation[f];
        result.units[std::size_t(f)][std::size_t(u)] = w;
        constant -= w * m_mean[f];
      }
      result.units[0][std::size_t(u)] = constant;
    }
    result.scores.resize(std::size_t(units + 1));
    for(Eigen::Index u = 0; u <= units; ++u)
      for(Eigen::Index c = 0; c < candidates; ++c)
        result.scores[std::size_t(u)][std::size_t(c)] = factor * double(net.scores_of_units(u, c));
    return result;
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
  std::vector<Data> m_data;
  Eigen::VectorXd m_mean, m_deviation;
  double m_exactness = -1e3;
};

// the errors of the blend
Vertex_record::Error blend(const Scores& scores, const Vertex_record& vertex)
{
  if(are_exact(vertex, scores.exactness))
    return vertex.errors[of_exact_normals];
  std::array<double, number_of_candidates> score = scores.scores[0];
  for(std::size_t u = 0; u + 1 < scores.scores.size(); ++u)
  {
    double sum = scores.units[0][u];
    for(std::size_t s = 0; s < number_of_statistics; ++s)
      sum += scores.units[s + 1][u] * double(vertex.statistics[s]);
    for(std::size_t c = 0; c < number_of_candidates; ++c)
      score[c] += scores.scores[u + 1][c] * std::tanh(sum);
  }
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

} // namespace

double excess(const Scores& scores, const Calibration_row& row)
{
  constexpr double largest = 100.; // a single vertex mustn't decide alone
  double sum = 0.;
  for(const Vertex_record& v : row.vertices)
    sum += (std::min)(blend(scores, v).sum() / row.best_error, largest);
  return sum / double(row.vertices.size());
}

Scores learn_scores(const std::vector<Calibration_row>& rows, std::ostream& log)
{
  const Learner learner(rows);
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

std::string to_header(const Scores& scores)
{
  const auto text = [](const double x)
  {
    char result[32];
    std::snprintf(result, sizeof result, "%.4f", x);
    return std::string(result);
  };
  std::ostringstream out;
  const auto write_line = [&](const auto& numbers, bool is_last, const std::string& what)
  {
    out << "    {{";
    for(std::size_t k = 0; k < numbers.size(); ++k)
      out << text(numbers[k]) << (k + 1 < numbers.size() ? ", " : "}}");
    out << (is_last ? "}};" : ",") << " // " << what << "\n";
  };
  out << "#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H\n"
         "#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H\n\n"
         "#include <Shape_characteristics/curvature/internal/Adaptive_statistics.h>\n\n"
         "#include <array>\n#include <cstddef>\n\n"
         "namespace Shape_characteristics {\nnamespace internal {\n\n"
         "// The constants of adaptive_curvatures(), learned from surfaces whose curvature is known. Not "
         "written by hand: they are the\n// output of\n//   benchmark_adaptive_adaptive --calibrate "
         "adaptive_scores.h\n\n"
         "// where EXACT_3_ANGLES - POINTS_3_ANGLES is less, CHECKED_3_RINGS is chosen\n"
         "inline constexpr double adaptive_exactness = "
      << text(scores.exactness)
      << ";\n\n// Elsewhere the estimators are blended in proportion to exp(-score): a linear function of "
         "the "
         "hyperbolic tangents of linear\n"
         "// functions of all statistics, the units.\n"
         "inline constexpr std::size_t number_of_adaptive_units = "
      << scores.scores.size() - 1
      << ";\n\n// clang-format off\n"
         "inline constexpr std::array<std::array<double, number_of_adaptive_units>, "
         "number_of_adaptive_statistics + 1> adaptive_unit_weights = {{\n";
  for(std::size_t k = 0; k < scores.units.size(); ++k)
    write_line(scores.units[k], k + 1 == scores.units.size(), k == 0 ? "1" : statistic_names[k - 1]);
  out << "inline constexpr std::array<std::array<double, number_of_adaptive_candidates>, "
         "number_of_adaptive_units + 1> adaptive_score_weights = {{\n";
  for(std::size_t k = 0; k < scores.scores.size(); ++k)
    write_line(scores.scores[k], k + 1 == scores.scores.size(), k == 0 ? "1" : "unit " + std::to_string(k));
  out << "// clang-format on\n\n} // namespace internal\n} // namespace Shape_characteristics\n\n"
         "#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_ADAPTIVE_SCORES_H\n";
  return out.str();
}

} // namespace adaptive
