#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_SKIN_VIEW_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_SKIN_VIEW_H

#include <Shape_characteristics/head_features/internal/Depth_image.h>
#include <Shape_characteristics/head_features/internal/Head_surface.h>
#include <Shape_characteristics/head_features/internal/Scalar_image.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The face from the front: its depth, and what of it is one connected skin.
// The unit is the height of the head, the origin the tip of the nose; x points to the right, y upwards, z towards the eye.
class Skin_view
{
public:
  static constexpr double pixel = .001;
  static constexpr double left = -.45, bottom = -.62, width = .9, height = 1.12;

  // `components` numbers the connected parts of the surface, by vertex
  Skin_view(const Head_surface& surface, const std::vector<Head_surface::Index>& components)
    : m_surface(surface),
      m_image(surface,
              Eigen::Vector3d::UnitX(),
              Eigen::Vector3d::UnitY(),
              Eigen::Vector3d::UnitZ(),
              left,
              bottom,
              width,
              height,
              pixel),
      m_is_skin(std::size_t(columns()) * std::size_t(rows()), false)
  {
    find_skin(components);
  }

  int columns() const { return m_image.depth().width(); }
  int rows() const { return m_image.depth().height(); }
  double u(double i) const { return m_image.u(i); }
  double v(double j) const { return m_image.v(j); }
  int column(double u) const { return clamp_to(m_image.column(u), columns()); }
  int row(double v) const { return clamp_to(m_image.row(v), rows()); }

  const Depth_image& image() const { return m_image; }

  // A part of the depth image after a Gaussian of the standard deviation `sigma`, with the numbers of its first column and row.
  struct Smooth_part
  {
    Scalar_image depth;
    int first_column, first_row;
    double operator()(int i, int j) const
    {
      i -= first_column;
      j -= first_row;
      return depth.contains(i, j) ? depth(i, j) : std::numeric_limits<double>::quiet_NaN();
    }
  };

  Smooth_part smooth_part(double u_min, double u_max, double v_min, double v_max, double sigma) const
  {
    const double margin = 3. * sigma;
    const int i = column(u_min - margin), j = row(v_min - margin);
    return {m_image.depth().part(i, column(u_max + margin), j, row(v_max + margin)).smoothed(sigma / pixel),
            i, j};
  }

  // whether a pixel shows the skin that the tip of the nose belongs to, without a step in between
  bool is_skin(int i, int j) const
  {
    return m_image.depth().contains(i, j) &&
           m_is_skin[std::size_t(j) * std::size_t(columns()) + std::size_t(i)];
  }
  bool is_empty(int i, int j) const { return !m_image.depth().has_value(i, j); }

  // what is seen at `(u, v)`
  Surface_point point(double u, double v) const { return m_image.point(u, v); }

  // the skin that is seen at `(u, v)`, or next to it if something else is
  Surface_point skin_point(double u, double v) const
  {
    const auto accepts = [&](int i, int j) { return is_skin(i, j); };
    const int i0 = column(u), j0 = row(v);
    const Surface_point here = m_image.point(u, v, accepts);
    if(here.is_valid())
      return here;
    double nearest = std::numeric_limits<double>::infinity();
    int i_best = -1, j_best = -1;
    constexpr int reach = int(.012 / pixel);
    for(int j = j0 - reach; j <= j0 + reach; ++j)
      for(int i = i0 - reach; i <= i0 + reach; ++i)
      {
        const double distance = std::hypot(this->u(i) - u, this->v(j) - v);
        if(is_skin(i, j) && distance < nearest)
        {
          nearest = distance;
          i_best = i;
          j_best = j;
        }
      }
    return i_best < 0 ? Surface_point() : m_image.point(this->u(i_best), this->v(j_best), accepts);
  }

  // The greatest value of a function of the pixels of a window, and where: `(u, v)` by a parabola through it and its neighbors.
  struct Extremum
  {
    double u = 0., v = 0., value = -std::numeric_limits<double>::infinity();
    bool is_inside = false; // not at the rim of the window
  };

  template <typename Function>
  Extremum maximum(double u_min, double u_max, double v_min, double v_max, const Function& function) const
  {
    const int i_min = column(u_min), i_max = column(u_max), j_min = row(v_min), j_max = row(v_max);
    Extremum best;
    int i_best = -1, j_best = -1;
    for(int j = j_min; j <= j_max; ++j)
      for(int i = i_min; i <= i_max; ++i)
      {
        const double value = function(i, j);
        if(value > best.value)
        {
          best.value = value;
          i_best = i;
          j_best = j;
        }
      }
    if(i_best < 0)
      return best;
    best.is_inside = i_best > i_min && i_best < i_max && j_best > j_min && j_best < j_max;
    best.u = u(i_best +
               vertex_of_parabola(function(i_best - 1, j_best), best.value, function(i_best + 1, j_best)));
    best.v = v(j_best +
               vertex_of_parabola(function(i_best, j_best - 1), best.value, function(i_best, j_best + 1)));
    return best;
  }

  // where, between -1/2 and 1/2, the parabola through (-1, a), (0, b), (1, c) is greatest
  static double vertex_of_parabola(double a, double b, double c)
  {
    const double bend = a - 2 * b + c;
    if(!(bend < 0.))
      return 0.;
    return std::min(std::max(.5 * (a - c) / bend, -.5), .5);
  }

private:
  static int clamp_to(double x, int size)
  {
    return int(std::lround(std::min(std::max(x, 0.), double(size - 1))));
  }

  // Skin is what can be reached from the tip of the nose in the image without a step in depth: lids end where the ball of the
  // eye or a hole begins, lips where the mouth is open.
  void find_skin(const std::vector<Head_surface::Index>& components)
  {
    constexpr double steepest = 4.; // of a slope
    const int i0 = column(0.), j0 = row(0.);
    if(is_empty(i0, j0))
      return;
    const auto component = [&](int i, int j)
    { return components[m_surface.triangles[m_image.triangle(i, j)][0]]; };
    const auto index = [&](int i, int j) { return std::size_t(j) * std::size_t(columns()) + std::size_t(i); };
    const Head_surface::Index skin = component(i0, j0);
    std::vector<std::pair<int, int> > stack = {{i0, j0}};
    m_is_skin[index(i0, j0)] = true;
    const Scalar_image& z = m_image.depth();
    while(!stack.empty())
    {
      const auto [i, j] = stack.back();
      stack.pop_back();
      for(const auto& [a, b] :
          {std::pair(i + 1, j), std::pair(i - 1, j), std::pair(i, j + 1), std::pair(i, j - 1)})
      {
        if(is_empty(a, b) || m_is_skin[index(a, b)] || std::abs(z(a, b) - z(i, j)) > steepest * pixel ||
           component(a, b) != skin)
          continue;
        m_is_skin[index(a, b)] = true;
        stack.push_back({a, b});
      }
    }
  }

  const Head_surface& m_surface;
  Depth_image m_image;
  std::vector<bool> m_is_skin;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_SKIN_VIEW_H
