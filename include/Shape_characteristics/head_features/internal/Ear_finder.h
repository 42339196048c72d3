#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_EAR_FINDER_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_EAR_FINDER_H

#include <Shape_characteristics/head_features/internal/Depth_image.h>
#include <Shape_characteristics/head_features/internal/Head_surface.h>
#include <Shape_characteristics/head_features/internal/Range_image_curvature.h>
#include <Shape_characteristics/head_features/internal/Scalar_image.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// How far an ear reaches: along z, along y, and how far from the middle of the head.
struct Ear_box
{
  double back = 0., front = 0., bottom = 0., top = 0., outside = 0.;
};

// An ear as it is seen from its side of the head.
class Ear_outline
{
public:
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2; // forward (z) and up (y)

  Ear_outline() = default;
  Ear_outline(std::vector<Point_2> hull, const Ear_box& box, double certainty)
    : m_hull(std::move(hull)),
      m_box(box),
      m_certainty(certainty)
  {
    for(const Point_2& p : m_hull)
      m_z_middle += p.x() / double(m_hull.size());
  }

  double certainty() const { return m_certainty; }            // 0: not found
  const std::vector<Point_2>& hull() const { return m_hull; } // counterclockwise
  const Ear_box& box() const { return m_box; }
  double z_middle() const { return m_z_middle; }

  // how far a point is outside of the outline, negative inside
  double distance(double z, double y) const
  {
    double outside = -std::numeric_limits<double>::infinity(),
           nearest = std::numeric_limits<double>::infinity();
    for(std::size_t k = 0; k < m_hull.size(); ++k)
    {
      const Point_2 &a = m_hull[k], &b = m_hull[(k + 1) % m_hull.size()];
      const double dz = b.x() - a.x(), dy = b.y() - a.y(), squared = dz * dz + dy * dy;
      if(!(squared > 0.))
        continue;
      outside = std::max(outside, ((z - a.x()) * dy - (y - a.y()) * dz) / std::sqrt(squared));
      const double t = std::min(std::max(((z - a.x()) * dz + (y - a.y()) * dy) / squared, 0.), 1.);
      nearest = std::min(nearest, std::hypot(z - a.x() - t * dz, y - a.y() - t * dy));
    }
    return outside > 0. ? nearest : outside;
  }

private:
  std::vector<Point_2> m_hull;
  Ear_box m_box;
  double m_z_middle = 0., m_certainty = 0.;
};

// The folds of an ear are the sharpest on the side of a head. Where they lie close together at the place where an ear is to be
// expected, the ear is what they enclose; if it is neither too large nor too small for one, and stands out from the head at the
// back.
class Ear_finder
{
public:
  // `surface` is seen from the tip of the nose, in heights of the head; `side`: -1 for the ear at negative x, 1 for the other
  Ear_finder(const Head_surface& surface, int side)
    : m_side(side),
      m_image(surface,
              Eigen::Vector3d(0, 0, -side),
              Eigen::Vector3d::UnitY(),
              Eigen::Vector3d(side, 0, 0),
              side < 0 ? s_back : -s_front,
              s_bottom,
              s_front - s_back,
              s_top - s_bottom,
              s_pixel)
  {}

  Ear_outline find() const
  {
    const Range_image_curvature curvature(m_image.depth().smoothed(.007 / s_pixel), s_pixel);
    const int columns = m_image.depth().width(), rows = m_image.depth().height();
    const auto is_fold = [&](int i, int j)
    { return curvature.max.has_value(i, j) && curvature.max(i, j) > s_fold; };

    // the group of folds, none far from the next, with most pixels of them
    std::vector<bool> visited(std::size_t(columns) * std::size_t(rows), false);
    const int reach = int(s_gap / s_pixel);
    std::vector<std::pair<int, int> > ear;
    for(int j0 = 0; j0 < rows; ++j0)
      for(int i0 = 0; i0 < columns; ++i0)
      {
        if(!is_fold(i0, j0) || visited[index(i0, j0)])
          continue;
        std::vector<std::pair<int, int> > group = {{i0, j0}};
        visited[index(i0, j0)] = true;
        for(std::size_t k = 0; k < group.size(); ++k)
        {
          const auto [i, j] = group[k];
          for(int b = std::max(j - reach, 0); b <= std::min(j + reach, rows - 1); ++b)
            for(int a = std::max(i - reach, 0); a <= std::min(i + reach, columns - 1); ++a)
              if(!visited[index(a, b)] && is_fold(a, b))
              {
                visited[index(a, b)] = true;
                group.push_back({a, b});
              }
        }
        if(group.size() > ear.size())
          ear = std::move(group);
      }
    if(ear.size() < 3)
      return {};

    // of numbers of pixels: those are computed with exactly
    std::vector<Ear_outline::Point_2> pixels, hull;
    for(const auto& [i, j] : ear)
      pixels.emplace_back(-m_side * i, j);
    CGAL::convex_hull_2(pixels.begin(), pixels.end(), std::back_inserter(hull));
    for(Ear_outline::Point_2& p : hull)
      p = Ear_outline::Point_2(-m_side * m_image.u(-m_side * p.x()), m_image.v(p.y()));
    return Ear_outline(hull, box(curvature.max, ear), certainty(hull));
  }

private:
  static constexpr double s_pixel = .003;
  static constexpr double s_back = -.85, s_front = -.40, s_bottom = -.2, s_top = .27;
  static constexpr double s_fold = 25.; // curvature in 1 / height of the head
  static constexpr double s_gap = .02;

  std::size_t index(int i, int j) const
  {
    return std::size_t(j) * std::size_t(m_image.depth().width()) + std::size_t(i);
  }

  // Where single folds end depends on the mesh, where most of them are doesn't: the box is that of nine tenths of all folds along
  // either axis, and wider by what lies beyond them on the ears of twelve heads.
  Ear_box box(const Scalar_image& curvature, const std::vector<std::pair<int, int> >& ear) const
  {
    constexpr double weakest = 15., strongest = 40.; // curvature of what is a fold not at all, and wholly
    constexpr double left_out = .05;
    const int columns = curvature.width(), rows = curvature.height(), reach = int(s_gap / s_pixel);
    std::vector<bool> is_near(std::size_t(columns) * std::size_t(rows), false);
    for(const auto& [i, j] : ear)
      for(int b = std::max(j - reach, 0); b <= std::min(j + reach, rows - 1); ++b)
        for(int a = std::max(i - reach, 0); a <= std::min(i + reach, columns - 1); ++a)
          if((a - i) * (a - i) + (b - j) * (b - j) <= reach * reach)
            is_near[index(a, b)] = true;

    std::vector<double> by_column(std::size_t(columns), 0.), by_row(std::size_t(rows), 0.);
    std::vector<std::pair<double, double> > depths; // and how much of a fold is there
    for(int j = 0; j < rows; ++j)
      for(int i = 0; i < columns; ++i)
        if(is_near[index(i, j)] && curvature.has_value(i, j) && curvature(i, j) > weakest)
        {
          const double fold = std::min((curvature(i, j) - weakest) / (strongest - weakest), 1.);
          by_column[std::size_t(i)] += fold;
          by_row[std::size_t(j)] += fold;
          depths.emplace_back(m_image.depth()(i, j), fold);
        }
    const double first = -m_side * m_image.u(quantile(by_column, left_out)),
                 last = -m_side * m_image.u(quantile(by_column, 1. - left_out));
    Ear_box box;
    box.back = std::min(first, last) - .033;
    box.front = std::max(first, last) + .010;
    box.bottom = m_image.v(quantile(by_row, left_out)) - .032;
    box.top = m_image.v(quantile(by_row, 1. - left_out)) + .018;

    std::sort(depths.begin(), depths.end());
    double all = 0., sum = 0.;
    for(const auto& d : depths)
      all += d.second;
    for(const auto& [depth, fold] : depths)
    {
      box.outside = depth + .012;
      if((sum += fold) >= (1. - left_out) * all)
        break;
    }
    return box;
  }

  // where, in pixels, a part of the sum of all pixels is reached; each is spread over its width
  static double quantile(const std::vector<double>& values, double part)
  {
    double wanted = 0.;
    for(const double value : values)
      wanted += part * value;
    for(std::size_t i = 0; i < values.size(); ++i)
    {
      if(values[i] > 0. && wanted <= values[i])
        return double(i) - .5 + wanted / values[i];
      wanted -= values[i];
    }
    return double(values.size());
  }

  double certainty(const std::vector<Ear_outline::Point_2>& hull) const
  {
    double z_min = hull[0].x(), z_max = z_min, y_min = hull[0].y(), y_max = y_min;
    for(const auto& p : hull)
    {
      z_min = std::min(z_min, p.x());
      z_max = std::max(z_max, p.x());
      y_min = std::min(y_min, p.y());
      y_max = std::max(y_max, p.y());
    }
    const double margin = 2 * s_pixel;
    if(z_min < s_back + margin || z_max > s_front - margin || y_min < s_bottom + margin ||
       y_max > s_top - margin)
      return 0.;
    const double height = y_max - y_min, width = z_max - z_min;
    if(height < .13 || height > .38 || width < .06 || width > .24 || width > height)
      return 0.;
    return stands_out(hull, .5 * (z_min + z_max), .5 * (y_min + y_max));
  }

  // at what part of its back and its top an ear is nearer to the eye than the head behind it, up to 1 if it is at most places
  double stands_out(const std::vector<Ear_outline::Point_2>& hull, double z_middle, double y_middle) const
  {
    constexpr double step = .012, inside = .01, outside = .025;
    double places = 0., steps = 0.;
    for(std::size_t k = 0; k < hull.size(); ++k)
    {
      const Ear_outline::Point_2 &a = hull[k], &b = hull[(k + 1) % hull.size()];
      const double z = .5 * (a.x() + b.x()), y = .5 * (a.y() + b.y()), dz = z - z_middle, dy = y - y_middle,
                   distance = std::hypot(dz, dy), length = std::hypot(b.x() - a.x(), b.y() - a.y());
      if(dz > 0. || !(distance > 0.))
        continue;
      const double in = depth(z - inside * dz / distance, y - inside * dy / distance),
                   out = depth(z + outside * dz / distance, y + outside * dy / distance);
      places += length;
      if(in - out > step) // nothing is behind the ear of a scan
        steps += length;
      else if(!std::isnan(in) && std::isnan(out))
        steps += .5 * length;
    }
    return places > 0. && steps > .4 * places ? std::min(1., 1.25 * steps / places) : 0.;
  }

  double depth(double z, double y) const
  {
    const int i = int(std::lround(m_image.column(-m_side * z))), j = int(std::lround(m_image.row(y)));
    return m_image.depth().contains(i, j) ? m_image.depth()(i, j) : std::numeric_limits<double>::quiet_NaN();
  }

  int m_side;
  Depth_image m_image;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_EAR_FINDER_H
