#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_SURFACE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_SURFACE_H

#include <Shape_characteristics/head_features/internal/pose_grid.h>
#include <Shape_characteristics/head_features/internal/pose_strays.h>
#include <Shape_characteristics/sampling/Nearest_point_search.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// points of a surface, their unit normals and their principal curvatures; what isn't finite is left out by `Pose_surface`
struct Pose_points
{
  std::vector<Eigen::Vector3d> points, normals;
  std::vector<double> min_curvatures, max_curvatures;
  std::vector<std::uint32_t> numbers; // of the vertices or points; `none` for points between them
  static constexpr std::uint32_t none = 0xffffffff;

  void add(const Eigen::Vector3d& point,
           const Eigen::Vector3d& normal,
           const double min_curvature,
           const double max_curvature,
           const std::uint32_t number)
  {
    points.push_back(point);
    normals.push_back(normal);
    min_curvatures.push_back(min_curvature);
    max_curvatures.push_back(max_curvature);
    numbers.push_back(number);
  }
};

// the same surface with the normals to the other side
inline Pose_points reversed(Pose_points points)
{
  for(Eigen::Vector3d& n : points.normals)
    n = -n;
  points.min_curvatures.swap(points.max_curvatures);
  for(std::vector<double>* k : {&points.min_curvatures, &points.max_curvatures})
    for(double& x : *k)
      x = -x;
  return points;
}

/*
  A surface as the search for its symmetry and its pose takes it: some thousand samples, evenly spread whatever the
  tessellation, in coordinates of their own: their mean is the origin, and the farthest of them is at distance 1.

  Normals and curvatures of the samples are means over a ball, so that noise on the points doesn't matter much; the density of
  the samples, in which everything is measured, follows from the surface and not from its tessellation, unless
  that is coarser.
*/
class Pose_surface
{
public:
  static constexpr std::size_t few = 100, many = 2500;

  explicit Pose_surface(const Pose_points& all)
  {
    Pose_points usable;
    for(std::size_t i = 0; i < all.points.size(); ++i)
      if(all.points[i].allFinite() && all.normals[i].allFinite() &&
         std::abs(all.normals[i].norm() - 1.) < 1e-3)
        usable.add(all.points[i], all.normals[i], all.min_curvatures[i], all.max_curvatures[i],
                   all.numbers[i]);
    if(usable.points.size() < few)
      return;
    const std::vector<std::size_t> spread = leave_out_strays(usable);
    if(usable.points.size() < few)
      return;
    set_frame(usable.points, spread);
    if(!(m_size > 0.) || !std::isfinite(m_size))
      return;
    for(Eigen::Vector3d& p : usable.points)
      p = (p - m_center) / m_size;
    for(std::vector<double>* k : {&usable.min_curvatures, &usable.max_curvatures})
      for(double& x : *k)
        x *= m_size;
    m_all = std::move(usable);
    m_chosen = evenly_spread(m_all.points, many);
    if(m_chosen.size() < few)
      return;
    m_search = std::make_unique<Nearest_point_search>(m_all.points);
    average();
  }

  bool is_valid() const noexcept { return !m_points.empty(); }
  const Eigen::Vector3d& center() const noexcept { return m_center; }
  double size() const noexcept { return m_size; }

  // the samples
  const std::vector<Eigen::Vector3d>& points() const noexcept { return m_points; }
  const std::vector<Eigen::Vector3d>& normals() const noexcept { return m_normals; }
  // whether most normals point to the middle
  bool is_inside_out() const
  {
    double sum = 0.;
    for(std::size_t i = 0; i < m_points.size(); ++i)
      sum += m_normals[i].dot(m_points[i]);
    return sum < 0.;
  }
  // median distance of neighboring samples
  double spacing() const noexcept { return m_spacing; }
  // mean and Gaussian curvature, averaged over the two radii
  const std::vector<double>& mean_curvatures(const int scale) const { return m_mean[scale]; }
  const std::vector<double>& Gaussian_curvatures(const int scale) const { return m_Gaussian[scale]; }
  // radii over which curvatures are averaged
  static constexpr double radii[2] = {.06, .15};

  // all points
  const Pose_points& all() const noexcept { return m_all; }
  // the number of the nearest of all points, or `Nearest_point_search::none`
  Nearest_point_search::Index nearest(const Eigen::Vector3d& place, const double limit) const
  {
    return m_search->nearest(place, limit);
  }
  // of each of all points, a normal that is averaged like those of samples: the one of the nearest sample serves where normals
  // are compared coarsely
  const Eigen::Vector3d& smooth_normal(const std::size_t i) const { return m_smooth_normals[i]; }

private:
  // returns the numbers of some of the others, evenly spread
  static std::vector<std::size_t> leave_out_strays(Pose_points& all)
  {
    std::vector<std::size_t> spread = evenly_spread(all.points, many);
    const std::vector<bool> is_stray = find_strays(all.points, spread);
    if(std::find(is_stray.begin(), is_stray.end(), true) == is_stray.end())
      return spread;
    Pose_points kept;
    for(std::size_t i = 0; i < all.points.size(); ++i)
      if(!is_stray[i])
        kept.add(all.points[i], all.normals[i], all.min_curvatures[i], all.max_curvatures[i], all.numbers[i]);
    all = std::move(kept);
    return evenly_spread(all.points, many);
  }

  void set_frame(const std::vector<Eigen::Vector3d>& points, const std::vector<std::size_t>& spread)
  {
    // relative to a point of the surface: coordinates may be large
    const Eigen::Vector3d first = points[spread[0]];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for(const std::size_t i : spread)
      sum += points[i] - first;
    m_center = first + sum / double(spread.size());
    for(const std::size_t i : spread)
      m_size = (std::max)(m_size, (points[i] - m_center).norm());
  }

  void average()
  {
    const std::size_t n = m_chosen.size();
    Pose_grid grid(m_all.points, radii[0]);
    for(std::size_t i = 0; i < m_all.points.size(); ++i)
      grid.insert(i);
    for(const std::size_t i : m_chosen)
      m_points.push_back(m_all.points[i]);
    m_normals.assign(n, Eigen::Vector3d::Zero());
    for(int scale = 0; scale < 2; ++scale)
    {
      m_mean[scale].assign(n, 0.);
      m_Gaussian[scale].assign(n, 0.);
    }
    m_spacing = spacing_of(m_points);

    const double radius = (std::min)((std::max)(1.5 * m_spacing, .03), radii[0]);
    m_smooth_normals.assign(m_all.points.size(), Eigen::Vector3d::Zero());
    for(std::size_t i = 0; i < m_all.points.size(); ++i)
      m_smooth_normals[i] = m_all.normals[i];
    for(std::size_t s = 0; s < n; ++s)
    {
      const std::size_t i = m_chosen[s];
      Eigen::Vector3d normal = m_all.normals[i] * 1e-3;
      double weights = 0., mean = 0., Gaussian = 0.;
      grid.for_each_within(m_points[s], radii[0],
                           [&](const std::size_t j, const double d)
                           {
                             if(m_all.normals[j].dot(m_all.normals[i]) < 0.)
                               return true; // the other side of a thin part
                             if(d < radius * radius)
                               normal += (1. - d / (radius * radius)) * m_all.normals[j];
                             const double k = m_all.min_curvatures[j], l = m_all.max_curvatures[j];
                             if(std::isfinite(k) && std::isfinite(l))
                             {
                               const double w = 1. - d / (radii[0] * radii[0]);
                               weights += w;
                               mean += w * .5 * (k + l);
                               Gaussian += w * k * l;
                             }
                             return true;
                           });
      m_normals[s] = normal.normalized();
      m_smooth_normals[i] = m_normals[s];
      if(weights > 0.)
      {
        m_mean[0][s] = mean / weights;
        m_Gaussian[0][s] = Gaussian / weights;
      }
    }
    // the larger balls, from the samples alone
    Pose_grid coarse(m_points, radii[1]);
    for(std::size_t s = 0; s < n; ++s)
      coarse.insert(s);
    for(std::size_t s = 0; s < n; ++s)
    {
      double weights = 0., mean = 0., Gaussian = 0.;
      coarse.for_each_within(m_points[s], radii[1],
                             [&](const std::size_t j, const double d)
                             {
                               if(m_normals[j].dot(m_normals[s]) < 0.)
                                 return true;
                               const double w = 1. - d / (radii[1] * radii[1]);
                               weights += w;
                               mean += w * m_mean[0][j];
                               Gaussian += w * m_Gaussian[0][j];
                               return true;
                             });
      m_mean[1][s] = mean / weights;
      m_Gaussian[1][s] = Gaussian / weights;
    }
  }

  Eigen::Vector3d m_center = Eigen::Vector3d::Zero();
  double m_size = 0., m_spacing = 0.;
  Pose_points m_all;
  std::vector<std::size_t> m_chosen;
  std::unique_ptr<Nearest_point_search> m_search;
  std::vector<Eigen::Vector3d> m_points, m_normals, m_smooth_normals;
  std::vector<double> m_mean[2], m_Gaussian[2];
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_SURFACE_H
