#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_REGISTRATION_ASSESSOR_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_REGISTRATION_ASSESSOR_H

#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/Registration_quality.h>
#include <Shape_characteristics/registration/internal/Point_grid.h>
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
      m_spacing(spacing)
  {}

  Registration_quality operator()(const Eigen::Isometry3d& motion) const
  {
    Counts counts;
    compare(m_source, m_target, motion, counts);
    compare(m_target, m_source, motion.inverse(), counts);
    Registration_quality quality;
    quality.number_of_near_points = counts.near;
    if(counts.usable > 0)
      quality.overlap = double(counts.near) / double(counts.usable);
    if(counts.near > 0)
    {
      quality.agreement = double(counts.meeting) / double(counts.near);
      quality.opposition = double(counts.opposed) / double(counts.near);
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
  static constexpr double s_meeting = .35;     // in spacings
  static constexpr double s_cosine = .85;      // of normals that agree
  static constexpr std::size_t s_nearest = 20; // neighbors for a curvature
  static constexpr std::size_t s_few = 10;     // pairs that tell nothing of a correlation

  struct Surface
  {
    Surface(const Oriented_points& all, double spacing)
      : surface(usable_points(all)),
        grid(surface.points, mean_point(surface.points), s_near * spacing)
    {
      for(std::size_t i = 0; i < surface.size(); ++i)
        grid.insert(std::uint32_t(i));
      find_curvatures();
    }

    Surface(const Surface&) = delete; // the grid sees the points

    // How fast normals diverge, with the neighborhoods' sizes as unit: twice the mean curvature where they are round. Its
    // scale is of no importance.
    void find_curvatures()
    {
      const std::vector<Eigen::Vector3d>&points = surface.points, &normals = surface.normals;
      const Point_set_samples samples(points, CGAL::Identity_property_map<Eigen::Vector3d>(),
                                      Neighborhood::nearest(s_nearest));
      Point_set_samples::Workspace workspace;
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        double sum = 0., squares = 0.;
        for(const auto j : samples.neighbors(i, 0, workspace))
        {
          const Eigen::Vector3d d = points[j] - points[i];
          sum += (normals[j] - normals[i]).dot(d);
          squares += d.squaredNorm();
        }
        curvatures.push_back(squares > 0. ? sum / squares : 0.);
      }
    }

    Oriented_points surface;
    Point_grid grid;
    std::vector<double> curvatures;
  };

  struct Counts
  {
    std::size_t usable = 0, near = 0, meeting = 0, opposed = 0;
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

  void compare(const Surface& from, const Surface& to, const Eigen::Isometry3d& motion, Counts& counts) const
  {
    counts.usable += from.surface.size();
    for(std::size_t i = 0; i < from.surface.size(); ++i)
    {
      const Eigen::Vector3d q = motion * from.surface.points[i];
      const std::uint32_t j = to.grid.nearest(q);
      if(j == Point_grid::none)
        continue;
      ++counts.near;
      const double cosine = to.surface.normals[j].dot(motion.linear() * from.surface.normals[i]);
      const double height = to.surface.normals[j].dot(q - to.surface.points[j]);
      if(cosine > s_cosine && std::abs(height) < s_meeting * m_spacing)
        ++counts.meeting;
      if(cosine < 0.)
        ++counts.opposed;
      counts.curvatures.push_back({from.curvatures[i], to.curvatures[j]});
    }
  }

  Surface m_source, m_target;
  double m_spacing;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_REGISTRATION_ASSESSOR_H
