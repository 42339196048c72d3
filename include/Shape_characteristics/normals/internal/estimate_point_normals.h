#ifndef SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_ESTIMATE_POINT_NORMALS_H
#define SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_ESTIMATE_POINT_NORMALS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/normals/Point_normal_method.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/Dimension.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/linear_least_squares_fitting_3.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

struct Point_normals
{
  std::vector<Eigen::Vector3d> normals; // NaN unless estimated
  std::vector<Estimation_status> status;
};

// What CGAL's functions get: distinct finite points, in the order of their coordinates, around the origin and of
// about unit size, so that neither their order nor their unit matters, and nothing over- or underflows.
class Distinct_points
{
public:
  using Kernel = CGAL::Simple_cartesian<double>;
  static constexpr std::size_t none = std::size_t(-1);

  explicit Distinct_points(const std::vector<Eigen::Vector3d>& input) : m_place(input.size(), none)
  {
    std::vector<std::size_t> order;
    for(std::size_t i = 0; i < input.size(); ++i)
      if(input[i].allFinite())
        order.push_back(i);
    if(order.empty())
      return;
    std::sort(order.begin(), order.end(),
              [&](const std::size_t i, const std::size_t j)
              { return lexicographically_smaller(input[i], input[j]); });
    Eigen::Vector3d low = input[order[0]], high = low;
    for(const std::size_t i : order)
    {
      low = low.cwiseMin(input[i]);
      high = high.cwiseMax(input[i]);
    }
    const Eigen::Vector3d center = low / 2. + high / 2.;
    const double size = (high / 2. - low / 2.).maxCoeff();
    std::frexp(size, &m_exponent);
    for(const std::size_t i : order)
    {
      if(m_points.empty() || input[i] != input[m_first.back()])
      {
        // halves: the difference of the largest numbers doesn't overflow
        const Eigen::Vector3d p =
            (input[i] / 2. - center / 2.).unaryExpr([&](double x) { return std::ldexp(x, 1 - m_exponent); });
        m_points.emplace_back(p.x(), p.y(), p.z());
        m_first.push_back(i);
      }
      m_place[i] = m_points.size() - 1;
    }
  }

  const std::vector<Kernel::Point_3>& points() const { return m_points; }
  // where a point of the input is found; `none` if it isn't finite
  std::size_t place(std::size_t i) const { return m_place[i]; }
  double to_local(double length) const { return std::ldexp(length, -m_exponent); }

private:
  std::vector<Kernel::Point_3> m_points;
  std::vector<std::size_t> m_place, m_first;
  int m_exponent = 0;
};

// property map: whether a point is the one from which directions propagate
struct Seed_map
{
  using key_type = std::size_t;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  std::size_t seed = 0;

  friend bool get(const Seed_map& map, std::size_t i) { return i == map.seed; }
};

template <typename ConcurrencyTag>
class Point_normal_estimator
{
public:
  using Kernel = Distinct_points::Kernel;
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;

  Point_normal_estimator(const std::vector<Point_3>& points,
                         const Neighborhood& neighborhood,
                         Point_normal_method method)
    : m_points(points),
      m_samples(points, CGAL::Identity_property_map<Point_3>(), neighborhood),
      m_normals(points.size(), Vector_3(0., 0., 0.)),
      m_status(points.size(), Estimation_status::FEW_NEIGHBOURS)
  {
    // those that a plane, or a quadric, needs besides the point itself
    const std::size_t needed = method == Point_normal_method::PCA ? 2 : 5;
    constexpr unsigned int no_limit = (std::numeric_limits<int>::max)();
    const bool is_ball = neighborhood.kind() == Neighborhood::Kind::BALL;
    m_k = is_ball ? no_limit : unsigned((std::min)(neighborhood.count(), points.size()));
    m_radius = is_ball ? neighborhood.reach() : 0.;
    if(points.size() <= needed || m_k < needed)
      return;

    find_status(needed);
    estimate(method);
    orient_parts();
  }

  const std::vector<Vector_3>& normals() const { return m_normals; }
  const std::vector<Estimation_status>& status() const { return m_status; }

private:
  using Indices = std::vector<std::size_t>;

  auto parameters()
  {
    return CGAL::parameters::point_map(CGAL::make_property_map(m_points))
        .normal_map(CGAL::make_property_map(m_normals))
        .neighbor_radius(m_radius)
        .geom_traits(Kernel());
  }

  void find_status(std::size_t needed)
  {
    const auto find = [&](const std::size_t i, Point_set_samples::Workspace& workspace)
    {
      const auto& neighbors = m_samples.neighbors(i, needed, workspace);
      if(neighbors.size() >= needed)
        m_status[i] = is_flat(i, neighbors) ? Estimation_status::ESTIMATED : Estimation_status::DEGENERATE;
    };
    for_each_sample<ConcurrencyTag, Point_set_samples::Workspace>(m_points.size(), find);
  }

  // whether the points are spread less in one direction than in any other
  template <typename Neighbors>
  bool is_flat(std::size_t i, const Neighbors& neighbors) const
  {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    double largest = 0.;
    for(const auto j : neighbors)
    {
      const Eigen::Vector3d d = m_samples.point(j) - m_samples.point(i);
      mean += d / double(neighbors.size() + 1);
      largest = (std::max)(largest, d.lpNorm<Eigen::Infinity>());
    }
    Eigen::Matrix3d covariance = (mean / largest) * (mean / largest).transpose(); // the point itself
    for(const auto j : neighbors)
    {
      const Eigen::Vector3d d = (m_samples.point(j) - m_samples.point(i) - mean) / largest;
      covariance += d * d.transpose();
    }
    const Eigen::Vector3d variances =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance, Eigen::EigenvaluesOnly).eigenvalues();
    return variances[1] - variances[0] > 1e-12 * variances[2];
  }

  void estimate(Point_normal_method method)
  {
    for_each_sample<ConcurrencyTag, Workspace>(m_points.size(),
                                               [&](const std::size_t i, Workspace& workspace)
                                               {
                                                 if(is_estimated(m_status[i]))
                                                   m_normals[i] = normal(i, method, workspace);
                                               });
    for(std::size_t i = 0; i < m_points.size(); ++i)
    {
      const double length = std::sqrt(m_normals[i].squared_length());
      if(length > 0. && std::isfinite(length))
        m_normals[i] = m_normals[i] / length;
      else if(is_estimated(m_status[i]))
        m_status[i] = Estimation_status::DEGENERATE;
    }
  }

  struct Workspace
  {
    Point_set_samples::Workspace samples;
    std::vector<Point_3> points;
  };

  // What CGAL::pca_estimate_normals() and CGAL::jet_estimate_normals() do for a number of neighbors, but that rounding doesn't
  // decide between neighbors that are equally far. (With a radius, the latter takes the normal at any point of the ball, for
  // its search doesn't return the center first.)
  Vector_3 normal(std::size_t i, Point_normal_method method, Workspace& workspace) const
  {
    workspace.points.assign(1, m_points[i]);
    for(const auto j : m_samples.neighbors(i, 0, workspace.samples))
      workspace.points.push_back(m_points[j]);
    if(method == Point_normal_method::JET)
      return CGAL::Monge_via_jet_fitting<Kernel>()(workspace.points.begin(), workspace.points.end(), 2, 1)
          .normal_direction();
    Kernel::Plane_3 plane;
    CGAL::linear_least_squares_fitting_3(workspace.points.begin(), workspace.points.end(), plane,
                                         CGAL::Dimension_tag<0>());
    return plane.orthogonal_vector();
  }

  // CGAL orients what it reaches from its seeds: each part of the point set needs one.
  void orient_parts()
  {
    Indices parent(m_points.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto root = [&](std::size_t i)
    {
      while(parent[i] != i)
        i = parent[i] = parent[parent[i]];
      return i;
    };
    Point_set_samples::Workspace workspace;
    for(std::size_t i = 0; i < m_points.size(); ++i)
      if(is_estimated(m_status[i]))
        for(const auto j : m_samples.neighbors(i, 0, workspace))
          if(is_estimated(m_status[j]))
          {
            const std::size_t a = root(i), b = root(j);
            parent[(std::max)(a, b)] = (std::min)(a, b);
          }
    std::vector<Indices> parts(m_points.size());
    for(std::size_t i = 0; i < m_points.size(); ++i)
      if(is_estimated(m_status[i]))
        parts[root(i)].push_back(i);
    for(Indices& part : parts)
      if(!part.empty())
        orient(part);
  }

  void orient(Indices& part)
  {
    const std::size_t seed = outward_point(part);
    // more neighbors than there are points are none
    const unsigned int k = (std::max)(2u, (std::min)(m_k, unsigned(part.size())));
    const auto end = CGAL::mst_orient_normals(part, k, parameters().point_is_constrained_map(Seed_map{seed}));
    for(auto i = end; i != part.end(); ++i)
      m_status[*i] = Estimation_status::DEGENERATE;
  }

  // Of the points farthest out along the axes, the one whose normal is the nearest to its axis: turned outward.
  std::size_t outward_point(const Indices& part)
  {
    const std::array<Vector_3, 6> axes{Vector_3(0, 0, 1),  Vector_3(0, 1, 0),  Vector_3(1, 0, 0),
                                       Vector_3(0, 0, -1), Vector_3(0, -1, 0), Vector_3(-1, 0, 0)};
    std::size_t best = part[0];
    double best_cosine = -1., best_sign = 1.;
    for(const Vector_3& axis : axes)
    {
      const std::size_t farthest = *std::max_element(
          part.begin(), part.end(),
          [&](const std::size_t i, const std::size_t j)
          { return (m_points[i] - CGAL::ORIGIN) * axis < (m_points[j] - CGAL::ORIGIN) * axis; });
      const double cosine = m_normals[farthest] * axis;
      if(std::abs(cosine) > best_cosine)
      {
        best = farthest;
        best_cosine = std::abs(cosine);
        best_sign = cosine < 0. ? -1. : 1.;
      }
    }
    m_normals[best] = best_sign * m_normals[best];
    return best;
  }

  std::vector<Point_3> m_points;
  Point_set_samples m_samples;
  std::vector<Vector_3> m_normals;
  std::vector<Estimation_status> m_status;
  unsigned int m_k = 0;
  double m_radius = 0.; // 0: not used
};

template <typename ConcurrencyTag>
Point_normals estimate_point_normals(const std::vector<Eigen::Vector3d>& points,
                                     const Neighborhood& neighborhood,
                                     Point_normal_method method)
{
  const Distinct_points distinct(points);
  const bool is_ball = neighborhood.kind() == Neighborhood::Kind::BALL;
  const double radius = is_ball ? distinct.to_local(neighborhood.radius()) : 1.;
  const Point_normal_estimator<ConcurrencyTag> estimator(
      distinct.points(),
      is_ball ? Neighborhood::ball((std::min)((std::max)(radius, 1e-150), 1e150)) : neighborhood, method);

  Point_normals result;
  result.normals.assign(points.size(), Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  result.status.assign(points.size(), Estimation_status::NON_FINITE_INPUT);
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const std::size_t place = distinct.place(i);
    if(place == Distinct_points::none)
      continue;
    result.status[i] = estimator.status()[place];
    const auto& n = estimator.normals()[place];
    if(is_estimated(result.status[i]))
      result.normals[i] = Eigen::Vector3d(n.x(), n.y(), n.z());
  }
  return result;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_NORMALS_INTERNAL_ESTIMATE_POINT_NORMALS_H
