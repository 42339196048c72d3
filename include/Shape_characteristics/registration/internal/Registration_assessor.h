#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_REGISTRATION_ASSESSOR_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_REGISTRATION_ASSESSOR_H

#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/Registration_quality.h>
#include <Shape_characteristics/registration/internal/Point_grid.h>
#include <Shape_characteristics/registration/internal/centroid.h>
#include <Shape_characteristics/registration/internal/usable_points.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/property_map.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Compares two scans after motions of one of them: what doesn't depend on the motion is done once.
class Registration_assessor
{
public:
  // `spacing`: typical distance of neighboring points, of the coarser scan
  Registration_assessor(const Oriented_points& source, const Oriented_points& target, double spacing)
    : m_source(source, spacing),
      m_target(target, spacing),
      m_spacing(spacing),
      m_expected_agreement((std::min)(agreement_within(m_source), agreement_within(m_target)))
  {}

  // `step`: of how many points one is looked at
  Registration_quality operator()(const Eigen::Isometry3d& motion, std::size_t step = 1) const
  {
    Registration_quality quality;
    quality.expected_agreement = m_expected_agreement;
    if(!motion.matrix().allFinite()) // as that of a failed alignment
      return quality;
    Counts counts;
    compare(m_source, m_target, motion, step, counts);
    compare(m_target, m_source, motion.inverse(), step, counts);
    quality.number_of_near_points = counts.near;
    if(counts.usable > 0)
      quality.overlap = double(counts.near) / double(counts.usable);
    if(counts.near > 0)
    {
      quality.agreement = double(counts.meeting) / double(counts.near);
      quality.opposition = double(counts.opposed) / double(counts.near);
      quality.penetration = double(counts.beneath) / double(counts.near);
      quality.curvature_correlation = counts.correlation();
    }
    return quality;
  }

  // mean distance of the points to their 6 nearest ones elsewhere
  static double spacing(const Oriented_points& scan)
  {
    return Point_set_samples(scan.points, CGAL::Identity_property_map<Eigen::Vector3d>(),
                             Neighborhood::nearest(1))
        .mean_spacing();
  }

  // whether the target has a point near `p`
  bool is_near(const Eigen::Vector3d& p) const { return m_target.grid.nearest(p) != Point_grid::none; }

private:
  static constexpr double s_near = 3.;         // in spacings
  static constexpr double s_beside = 1.;       // in spacings, along the surface
  static constexpr double s_meeting = .35;     // in spacings
  static constexpr double s_cosine = .85;      // of normals that agree
  static constexpr std::size_t s_nearest = 16; // neighbors to smooth over
  static constexpr std::size_t s_few = 10;     // pairs that tell nothing of a correlation

  struct Surface
  {
    Surface(const Oriented_points& all, double spacing)
      : surface(usable_points(all)),
        grid(surface.points, centroid(surface.points), s_near * spacing)
    {
      smooth();
      for(std::size_t i = 0; i < surface.size(); ++i)
        grid.insert(std::uint32_t(i));
    }

    Surface(const Surface&) = delete; // the grid sees the points

    // Points and normals without most of their noise, and how fast normals diverge: twice the mean curvature where the surface
    // is round; its scale is of no importance.
    void smooth()
    {
      const Oriented_points noisy = surface;
      const Point_set_samples samples(noisy.points, CGAL::Identity_property_map<Eigen::Vector3d>(),
                                      Neighborhood::nearest(s_nearest));
      Point_set_samples::Workspace workspace;
      std::vector<std::vector<std::uint32_t> > neighbors(surface.size());
      for(std::size_t i = 0; i < surface.size(); ++i)
      {
        neighbors[i] = samples.neighbors(i, 0, workspace);
        Eigen::Vector3d mean = noisy.points[i], normal = noisy.normals[i];
        for(const auto j : neighbors[i])
        {
          mean += noisy.points[j];
          normal += noisy.normals[j];
        }
        mean /= double(neighbors[i].size() + 1);
        if(!(normal.norm() > 0.))
          continue;
        normal.normalize();
        // along the normal alone: points keep their distances along the surface
        surface.points[i] += normal.dot(mean - noisy.points[i]) * normal;
        surface.normals[i] = normal;
      }
      for(std::size_t i = 0; i < surface.size(); ++i)
      {
        nearest.push_back(neighbors[i].empty() ? std::uint32_t(i) : neighbors[i].front());
        double sum = 0., squares = 0.;
        for(const auto j : neighbors[i])
        {
          const Eigen::Vector3d d = surface.points[j] - surface.points[i];
          sum += (surface.normals[j] - surface.normals[i]).dot(d);
          squares += d.squaredNorm();
        }
        curvatures.push_back(squares > 0. ? sum / squares : 0.);
      }
    }

    Oriented_points surface;
    Point_grid grid;
    std::vector<double> curvatures;
    std::vector<std::uint32_t> nearest; // other point
  };

  struct Counts
  {
    std::size_t usable = 0, near = 0, meeting = 0, opposed = 0, beneath = 0;
    std::vector<std::array<double, 2>> curvatures;

    // of ranks: a few creases, where curvatures are as large as the sampling is fine, would rule otherwise
    double correlation() const
    {
      const std::size_t n = curvatures.size();
      if(n < s_few)
        return 0.;
      std::array<std::vector<double>, 2> ranks;
      std::vector<std::size_t> order(n);
      for(std::size_t c = 0; c < 2; ++c)
      {
        for(std::size_t i = 0; i < n; ++i)
          order[i] = i;
        std::sort(order.begin(), order.end(),
                  [&](const std::size_t a, const std::size_t b)
                  { return curvatures[a][c] < curvatures[b][c]; });
        ranks[c].resize(n);
        for(std::size_t first = 0, last = 0; first < n; first = last) // equal ones share their mean rank
        {
          while(last < n && curvatures[order[last]][c] == curvatures[order[first]][c])
            ++last;
          for(std::size_t k = first; k < last; ++k)
            ranks[c][order[k]] = .5 * double(first + last - 1) - .5 * double(n - 1);
        }
      }
      double product = 0., squares[2] = {0., 0.};
      for(std::size_t i = 0; i < n; ++i)
      {
        product += ranks[0][i] * ranks[1][i];
        for(std::size_t c = 0; c < 2; ++c)
          squares[c] += ranks[c][i] * ranks[c][i];
      }
      return squares[0] > 0. && squares[1] > 0. ? product / std::sqrt(squares[0] * squares[1]) : 0.;
    }
  };

  bool meets(double cosine, double height) const
  {
    return cosine > s_cosine && std::abs(height) < s_meeting * m_spacing;
  }

  // share of the points that meet their own surface, at the nearest other point: as noise allows
  double agreement_within(const Surface& surface) const
  {
    const Oriented_points& s = surface.surface;
    std::size_t meeting = 0;
    for(std::size_t i = 0; i < s.size(); ++i)
    {
      const std::size_t j = surface.nearest[i];
      meeting += j != i && meets(s.normals[j].dot(s.normals[i]), s.normals[j].dot(s.points[i] - s.points[j]));
    }
    return s.size() > 0 ? double(meeting) / double(s.size()) : 0.;
  }

  void compare(const Surface& from,
               const Surface& to,
               const Eigen::Isometry3d& motion,
               std::size_t step,
               Counts& counts) const
  {
    for(std::size_t i = 0; i < from.surface.size(); i += step)
    {
      ++counts.usable;
      const Eigen::Vector3d q = motion * from.surface.points[i];
      const std::uint32_t j = to.grid.nearest(q);
      if(j == Point_grid::none)
        continue;
      const Eigen::Vector3d d = q - to.surface.points[j];
      const double height = to.surface.normals[j].dot(d);
      // beyond the border, there is nothing to meet
      if(d.squaredNorm() - height * height > s_beside * s_beside * m_spacing * m_spacing)
        continue;
      ++counts.near;
      const double cosine = to.surface.normals[j].dot(motion.linear() * from.surface.normals[i]);
      if(meets(cosine, height))
        ++counts.meeting;
      if(cosine < 0.)
        ++counts.opposed;
      if(height < -s_meeting * m_spacing)
        ++counts.beneath;
      counts.curvatures.push_back({from.curvatures[i], to.curvatures[j]});
    }
  }

  Surface m_source, m_target;
  double m_spacing, m_expected_agreement;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_REGISTRATION_ASSESSOR_H
