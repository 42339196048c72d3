#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_KALOGERAKIS_ESTIMATOR_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_KALOGERAKIS_ESTIMATOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/internal/fit_to_neighbors.h>
#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/are_on_curve.h>
#include <Shape_characteristics/internal/median.h>
#include <Shape_characteristics/internal/passes.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/internal/write_normals.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The shape operator [l m; m n] that explains weighted pairs of points best: (da, db) = S (x, y) per unit of length.
class Pair_equations
{
public:
  void add(double weight, double x, double y, double a, double b)
  {
    m_xx += weight * x * x;
    m_xy += weight * x * y;
    m_yy += weight * y * y;
    m_l += weight * x * a;
    m_m += weight * (y * a + x * b);
    m_n += weight * y * b;
  }

  bool solve(Eigen::Vector3d& s) const
  {
    const double trace = m_xx + m_yy, d = determinant(m_xx, m_xy, m_yy);
    if(!(d > 1e-10 * trace * trace))
      return false;
    const double inverse = 1. / (trace * d), b2 = -m_xy * m_yy, b5 = -m_xx * m_xy, qq = m_xy * m_xy;
    s = {((m_yy * m_yy + d) * m_l + b2 * m_m + qq * m_n) * inverse,
         (b2 * m_l + m_xx * m_yy * m_m + b5 * m_n) * inverse,
         (qq * m_l + b5 * m_m + (m_xx * m_xx + d) * m_n) * inverse};
    return s.allFinite();
  }

  // how well the pairs determine the operator in all directions: 0 if all are parallel, 1/4 if they are spread evenly
  double spread() const
  {
    const double trace = m_xx + m_yy;
    return determinant(m_xx, m_xy, m_yy) / (trace * trace);
  }

private:
  double m_xx = 0., m_xy = 0., m_yy = 0., m_l = 0., m_m = 0., m_n = 0.;
};

// how often normals are to be estimated anew
template <typename NamedParameters>
unsigned int passes_of_kalogerakis(const NamedParameters& np, std::int64_t fewest)
{
  const std::int64_t passes =
      whole_number(np, internal_np::number_of_passes, std::int64_t(2), "number_of_passes");
  check_number_of_passes(passes, fewest);
  return static_cast<unsigned int>(passes);
}

template <typename SampledSurface>
class Kalogerakis_estimator
{
  using Index = typename SampledSurface::Index;
  using Vector = Eigen::Vector3d;

  // a sample in the frame of the one in the middle: position, and normal without its part along the axis
  struct Point
  {
    double x, y, a, b;
  };

  // the difference of two of them, per unit of length
  struct Pair
  {
    double x, y, a, b;
    std::uint32_t farther; // of the two, the place among the neighbors
  };

public:
  struct Workspace
  {
    typename SampledSurface::Workspace neighbors;
    std::vector<Point> points;
    std::vector<Pair> pairs;
    std::vector<std::size_t> central; // of the pairs, those that the sample in the middle is part of
    std::vector<double> residuals, sorted, weights;
    std::vector<Index> seen; // neighbors that had a say in the last answer
  };

  // For all samples: normals are estimated anew `passes` times, each time from neighbors with the normals before. Where the
  // callback stops it, there are no new normals.
  template <typename ConcurrencyTag>
  Kalogerakis_estimator(SampledSurface& surface,
                        unsigned int passes,
                        ConcurrencyTag,
                        const std::function<bool(double)>& callback = {})
    : m_surface(surface),
      m_status_of_normal(surface.size(), Estimation_status::CANCELLED)
  {
    for(unsigned int pass = 0; pass < passes; ++pass)
    {
      std::function<bool(double)> callback_of_all;
      if(callback)
        callback_of_all = Callback_of_pass(callback, pass, passes);
      std::vector<Vector> normals(surface.size());
      const bool is_complete = for_each_sample<ConcurrencyTag, Workspace>(
          surface.size(),
          [&](const std::size_t i, Workspace& workspace) { normals[i] = improved_normal(i, workspace); },
          callback_of_all);
      if(!is_complete)
      {
        m_status_of_normal.assign(surface.size(), Estimation_status::CANCELLED);
        return;
      }
      surface.set_normals(std::move(normals));
    }
  }

  // For sample 0 alone: the last pass for its neighbors, the one before for the neighbors of those, and so on. Which ones these are
  // depends on normals: where a fit fails, it asks for more neighbors. So passes are made for those that are known to be needed, until
  // no more turn up.
  Kalogerakis_estimator(SampledSurface& surface, unsigned int passes)
    : m_surface(surface),
      m_status_of_normal(surface.size(), Estimation_status::CANCELLED)
  {
    Workspace workspace;
    std::vector<Vector> original(surface.size());
    for(std::size_t i = 0; i < surface.size(); ++i)
      original[i] = surface.normal(i);
    std::vector<Index> needed(1, 0);
    std::vector<unsigned int> passes_of(surface.size(), 0); // that its normal has to be the result of
    passes_of[0] = passes;
    // what the last answer, at sample `i`, has seen is needed, after so many passes
    const auto need = [&](const Index i, const unsigned int number)
    {
      bool is_new = false;
      if(workspace.seen.empty() && is_estimated(surface.status(i))) // there was no fit
        workspace.seen = surface.neighbors(i, s_minimum, workspace.neighbors);
      for(const Index j : workspace.seen)
        if(passes_of[j] < number)
        {
          if(passes_of[j] == 0)
            needed.push_back(j);
          passes_of[j] = number;
          is_new = true;
        }
      return is_new;
    };
    for(bool is_complete = passes == 0; !is_complete;)
    {
      is_complete = true;
      std::vector<Vector> normals = original;
      surface.set_normals(normals);
      for(unsigned int pass = 1; pass <= passes; ++pass)
      {
        for(std::size_t k = 0, end = needed.size(); k < end; ++k)
          if(const Index j = needed[k]; passes_of[j] >= pass)
          {
            normals[j] = improved_normal(j, workspace);
            is_complete = !need(j, pass - 1) && is_complete;
          }
        surface.set_normals(normals);
      }
      (*this)(0, workspace);
      is_complete = !need(0, passes) && is_complete;
    }
  }

  Curvature_estimate operator()(std::size_t i, Workspace& workspace) const
  {
    workspace.seen.clear();
    return fit_to_neighbors(m_surface, i, s_minimum, workspace.neighbors,
                            [&](const std::vector<Index>& neighbors)
                            {
                              workspace.seen = neighbors;
                              Vector t1, t2, s;
                              double size;
                              if(!fit(i, neighbors, workspace, t1, t2, size, s))
                                return Curvature_estimate(Estimation_status::DEGENERATE);
                              return Curvature_estimate(m_surface.status(i),
                                                        eigen_of_shape_operator(m_surface.normal(i),
                                                                                s[0] / size, s[1] / size,
                                                                                s[2] / size, t1, t2));
                            });
  }

  // the normal that was estimated anew
  Normal_estimate normal(std::size_t i) const
  {
    Normal_estimate estimate;
    estimate.status = m_status_of_normal[i];
    if(is_estimated(estimate.status))
      estimate.normal = m_surface.normal(i);
    return estimate;
  }

private:
  static constexpr std::size_t s_minimum = 3;
  static constexpr int s_steps = 30;
  // A median of residuals times this is the standard deviation of a normal distribution.
  static constexpr double s_deviation_of_median = 1.4826;
  // Residuals that are this small compared to the bend of the neighborhood, or absolutely (a plane), are no outliers.
  static constexpr double s_smallest_deviation = 1e-3, s_rounding = 1e-12;
  // Points that are nearer to each other in the tangent plane, in units of the neighborhood's size, say nothing.
  static constexpr double s_shortest = 1e-3;
  // of deviations: what is farther is across a feature, and cut off
  static constexpr double s_cut_off = 3.;
  // of the pairs that are left, relative to that of all; of those on one side of a corner it is above .5
  static constexpr double s_least_spread = .4;

  // weights of M-estimation by Geman and McClure, relative to that of no residual
  static double weight(double residual, double deviation)
  {
    if(residual > s_cut_off * deviation)
      return 0.;
    const double r = residual / deviation, w = 1. / (1. + r * r);
    return w * w;
  }

  static double residual(const Pair& p, const Vector& s)
  {
    const double a = s[0] * p.x + s[1] * p.y - p.a, b = s[1] * p.x + s[2] * p.y - p.b;
    return std::sqrt(a * a + b * b); // std::hypot() would take most of the time of all
  }

  // the residuals of all pairs
  void measure(const Vector& s, Workspace& w) const
  {
    w.residuals.resize(w.pairs.size());
    for(std::size_t k = 0; k < w.pairs.size(); ++k)
      w.residuals[k] = residual(w.pairs[k], s);
  }

  // the median of the residuals of the central pairs
  double median_of_central(const Vector& s, Workspace& w) const
  {
    w.sorted.clear();
    for(const std::size_t k : w.central)
      w.sorted.push_back(residual(w.pairs[k], s));
    return median(w.sorted);
  }

  // The shape operator, in units of the neighborhood's size, and the weights of the pairs in the end. False if the neighbors
  // don't determine it.
  bool fit(std::size_t i,
           const std::vector<Index>& neighbors,
           Workspace& w,
           Vector& t1,
           Vector& t2,
           double& size,
           Vector& s) const
  {
    const Vector& p = m_surface.point(i);
    const Vector& n = m_surface.normal(i);
    tangent_basis(n, t1, t2);
    size = size_of_neighborhood(m_surface, i, neighbors);
    if(!(size > 0. && std::isfinite(size)))
      return false;
    w.points.assign(1, {0., 0., 0., 0.});
    for(const Index j : neighbors)
    {
      const Vector d = (m_surface.point(j) - p) / size, change = m_surface.normal(j) - n;
      w.points.push_back({d.dot(t1), d.dot(t2), change.dot(t1), change.dot(t2)});
    }
    const auto for_each_place = [&](const auto& f)
    {
      for(std::size_t j = 1; j < w.points.size(); ++j)
        f(w.points[j].x, w.points[j].y);
    };
    if(are_on_curve(for_each_place))
      return false;
    // every point with every other one
    w.pairs.clear();
    w.central.clear();
    for(std::size_t j = 1; j < w.points.size(); ++j)
      for(std::size_t k = 0; k < j; ++k)
      {
        const Point &a = w.points[j], &b = w.points[k];
        const double length = std::hypot(a.x - b.x, a.y - b.y);
        if(!(length > s_shortest))
          continue;
        if(k == 0)
          w.central.push_back(w.pairs.size());
        w.pairs.push_back({(a.x - b.x) / length, (a.y - b.y) / length, (a.a - b.a) / length,
                           (a.b - b.b) / length, std::uint32_t(j)});
      }
    if(w.pairs.size() < 3 || w.central.empty())
      return false;

    // The first guess is the one with the least median of residuals, of fits by least squares to the nearest points, to the
    // nearer ones, and to all, and of fits to the triangles of the sample and two points.
    double least = -1.;
    const auto consider = [&](const Pair_equations& equations)
    {
      Vector guess;
      if(!equations.solve(guess))
        return;
      const double m = median_of_central(guess, w);
      if(least < 0. || m < least)
      {
        least = m;
        s = guess;
      }
    };
    const std::size_t count = neighbors.size();
    Pair_equations of_all; // as the last of these leaves it
    for(const std::size_t nearest : {(count + 2) / 3, (2 * count + 2) / 3, count})
    {
      of_all = Pair_equations();
      for(const Pair& pair : w.pairs)
        if(pair.farther <= nearest)
          of_all.add(1., pair.x, pair.y, pair.a, pair.b);
      consider(of_all);
    }
    for(std::size_t j = 1; j <= count; ++j)
      for(const std::size_t step : {std::size_t(1), std::size_t(2)})
      {
        const std::size_t k = j + step;
        if(k > count)
          continue;
        Pair_equations equations;
        for(const auto& [f, g] :
            {std::pair(j, std::size_t(0)), std::pair(k, std::size_t(0)), std::pair(k, j)})
        {
          const Point &a = w.points[f], &b = w.points[g];
          const double length = std::hypot(a.x - b.x, a.y - b.y);
          if(length > s_shortest)
            equations.add(1., (a.x - b.x) / length, (a.y - b.y) / length, (a.a - b.a) / length,
                          (a.b - b.b) / length);
        }
        consider(equations);
      }
    if(least < 0.)
      return false;

    // Reweighted least squares, with the deviation that the first guess has.
    measure(s, w);
    const double bend = std::sqrt(s[0] * s[0] + 2. * s[1] * s[1] + s[2] * s[2]);
    // so few residuals have too small a median: Rousseeuw's and Leroy's correction
    const double few = 1. + 5. / (std::max)(double(count) - 3., 1.);
    const double deviation =
        (std::max)({s_deviation_of_median * few * least, s_smallest_deviation * bend, s_rounding});
    for(int step = 0; step < s_steps; ++step)
    {
      Pair_equations equations;
      w.weights.resize(w.pairs.size());
      for(std::size_t k = 0; k < w.pairs.size(); ++k)
      {
        const Pair& pair = w.pairs[k];
        w.weights[k] = weight(w.residuals[k], deviation);
        equations.add(w.weights[k], pair.x, pair.y, pair.a, pair.b);
      }
      // Along rows of long triangles few pairs tell of the bend across, and look like outliers of a guess from the others.
      if(!(equations.spread() >= s_least_spread * of_all.spread()))
      {
        w.weights.assign(w.pairs.size(), 1.);
        return of_all.solve(s);
      }
      Vector next;
      if(!equations.solve(next))
        break; // what is left is on a line: the fit before is the answer
      const double change = (next - s).cwiseAbs().maxCoeff();
      s = next;
      measure(s, w);
      if(change <= 1e-9 * (std::max)(bend, s_rounding))
        break;
    }
    return true;
  }

  // The mean of what the neighbors' normals and the shape operator say of the normal, with the weights of the pairs that the
  // sample is part of, and of the normal that it has.
  Vector improved_normal(std::size_t i, Workspace& w)
  {
    const Vector& n = m_surface.normal(i);
    Vector result = n;
    Estimation_status& status = m_status_of_normal[i];
    w.seen.clear();
    status = fit_to_neighbors(m_surface, i, s_minimum, w.neighbors,
                              [&](const std::vector<Index>& neighbors)
                              {
                                w.seen = neighbors;
                                Vector t1, t2, s;
                                double size;
                                if(!fit(i, neighbors, w, t1, t2, size, s))
                                  return Curvature_estimate(Estimation_status::DEGENERATE);
                                double sum_a = 0., sum_b = 0., weights = 1.;
                                for(const std::size_t k : w.central)
                                {
                                  const Point& q = w.points[w.pairs[k].farther];
                                  sum_a += w.weights[k] * (q.a - (s[0] * q.x + s[1] * q.y));
                                  sum_b += w.weights[k] * (q.b - (s[1] * q.x + s[2] * q.y));
                                  weights += w.weights[k];
                                }
                                result = (n + (sum_a / weights) * t1 + (sum_b / weights) * t2).normalized();
                                return Curvature_estimate(m_surface.status(i));
                              })
                 .status;
    if(result.allFinite())
      return result;
    if(is_estimated(status))
      status = Estimation_status::DEGENERATE;
    return n;
  }

  const SampledSurface& m_surface;
  std::vector<Estimation_status> m_status_of_normal;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_KALOGERAKIS_ESTIMATOR_H
