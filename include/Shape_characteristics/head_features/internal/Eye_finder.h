#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_EYE_FINDER_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_EYE_FINDER_H

#include <Shape_characteristics/head_features/internal/Face_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// An eye as it is seen from the front.
struct Eye_outline
{
  struct Place
  {
    double u = 0., v = 0.;
  };
  Place outer_corner, inner_corner;
  std::array<Place, 2> upper, lower; // on the lids, the outer one first
  double width = 0.;                 // of what is seen of the ball
  double certainty = 0.;             // 0: not found
};

// Between the lids, skin ends: there is the ball of the eye, or a hole. What isn't skin around the place where an eye is to be
// expected is the opening; its rim is the edge of the lids. Where the ball is of one piece with the lids, the crease between them
// is the rim.
class Eye_finder
{
public:
  // `side`: -1 for the eye at negative x, 1 for the other; `(u, v)`: about the middle of the eye; `width`: about that of the
  // opening, if it is not closed in part
  Eye_finder(const Face_view& view, int side, double u, double v, double width)
    : m_view(view),
      m_side(side),
      m_u(u),
      m_v(v),
      m_usual_width(width)
  {}

  Eye_outline find()
  {
    if(!find_opening() && !find_creases())
      return {};
    return outline();
  }

private:
  static constexpr double s_half_width = .1, s_half_height = .062;
  static constexpr double s_least_width = .025, s_greatest_width = .17;
  static constexpr double s_least_crease = 40.; // in 1 / height of the head

  struct Column
  {
    double u, low, high; // the edges of the lids
  };

  // the pixels next to each other that aren't skin
  bool find_opening()
  {
    const int i_min = m_view.column(m_u - s_half_width), i_max = m_view.column(m_u + s_half_width),
              j_min = m_view.row(m_v - s_half_height), j_max = m_view.row(m_v + s_half_height);
    const int columns = i_max - i_min + 1;
    std::vector<bool> visited(std::size_t(columns) * std::size_t(j_max - j_min + 1), false);
    const auto index = [&](int i, int j)
    { return std::size_t(j - j_min) * std::size_t(columns) + std::size_t(i - i_min); };
    std::size_t largest = 0;
    bool found = false;
    for(int j0 = j_min; j0 <= j_max; ++j0)
      for(int i0 = i_min; i0 <= i_max; ++i0)
      {
        if(m_view.is_skin(i0, j0) || visited[index(i0, j0)])
          continue;
        std::vector<std::pair<int, int> > part = {{i0, j0}};
        visited[index(i0, j0)] = true;
        bool touches_rim = false;
        for(std::size_t k = 0; k < part.size(); ++k)
        {
          const auto [i, j] = part[k];
          touches_rim = touches_rim || i == i_min || i == i_max || j == j_min || j == j_max;
          for(const auto& [a, b] :
              {std::pair(i + 1, j), std::pair(i - 1, j), std::pair(i, j + 1), std::pair(i, j - 1)})
          {
            if(a < i_min || a > i_max || b < j_min || b > j_max || m_view.is_skin(a, b) ||
               visited[index(a, b)])
              continue;
            visited[index(a, b)] = true;
            part.push_back({a, b});
          }
        }
        if(touches_rim || part.size() <= largest)
          continue;
        if(take(part))
        {
          largest = part.size();
          found = true;
        }
      }
    if(!found)
      return false;
    m_certainty = 1.;
    follow_closed_lids();
    return true;
  }

  bool take(const std::vector<std::pair<int, int> >& part)
  {
    int first = part[0].first, last = part[0].first;
    for(const auto& p : part)
    {
      first = std::min(first, p.first);
      last = std::max(last, p.first);
    }
    const double width = (last - first + 1) * Face_view::pixel;
    const double middle = m_view.u(.5 * (first + last));
    if(width < s_least_width || width > s_greatest_width || std::abs(middle - m_u) > .06)
      return false;
    std::vector<std::pair<int, int> > rows(std::size_t(last - first + 1), {m_view.rows(), -1});
    for(const auto& [i, j] : part)
    {
      auto& [low, high] = rows[std::size_t(i - first)];
      low = std::min(low, j);
      high = std::max(high, j);
    }
    m_columns.clear();
    for(int i = first; i <= last; ++i)
    {
      const auto& [low, high] = rows[std::size_t(i - first)];
      m_columns.push_back({m_view.u(i), m_view.v(low - .5), m_view.v(high + .5)});
    }
    return true;
  }

  // An eye that is closed in part: its opening is too narrow. The crease between the lids leads to the outer corner.
  void follow_closed_lids()
  {
    const double width = m_columns.back().u - m_columns.front().u;
    if(width > .88 * m_usual_width)
      return;
    Column end = m_side < 0 ? m_columns.front() : m_columns.back();
    double row = .5 * (m_view.row(end.low) + m_view.row(end.high));
    std::vector<Column> lids;
    for(int k = 1; k * Face_view::pixel < m_usual_width - width; ++k)
    {
      const int i = m_view.column(end.u) + m_side * k, j0 = int(std::lround(row));
      int best = j0;
      for(int j = j0 - 3; j <= j0 + 3; ++j)
        if(m_view.crease(i, j) - .5 * std::abs(j - row) > m_view.crease(i, best) - .5 * std::abs(best - row))
          best = j;
      if(m_view.crease(i, best) < s_least_crease)
        break;
      row = best;
      lids.push_back({m_view.u(i), m_view.v(best), m_view.v(best)});
    }
    if(m_side < 0)
      m_columns.insert(m_columns.begin(), lids.rbegin(), lids.rend());
    else
      m_columns.insert(m_columns.end(), lids.begin(), lids.end());
    m_certainty = .7;
  }

  // An eye of one piece with its lids. There is a crease where the lids meet the ball; the corners are its deepest places. Folds
  // of the lids are as deep: what is near where lids usually are is taken.
  bool find_creases()
  {
    const auto crease_near = [&](double u, double v, double reach_u, double reach_v)
    {
      return m_view.maximum(u - 2 * reach_u, u + 2 * reach_u, v - 2 * reach_v, v + 2 * reach_v,
                            [&](int i, int j)
                            {
                              const double x = (m_view.u(i) - u) / reach_u, y = (m_view.v(j) - v) / reach_v;
                              return m_view.crease(i, j) * std::exp(-.5 * (x * x + y * y));
                            });
    };
    const Face_view::Extremum outer = crease_near(m_u + .059 * m_side, m_v + .001, .015, .015),
                              inner = crease_near(m_u - .059 * m_side, m_v - .009, .015, .015);
    if(outer.value < s_least_crease || inner.value < s_least_crease ||
       (outer.u - inner.u) * m_side < .5 * m_usual_width)
      return false;
    m_columns.clear();
    double weakest = outer.value;
    const int i_first = m_view.column(std::min(outer.u, inner.u)),
              i_last = m_view.column(std::max(outer.u, inner.u));
    for(int i = i_first; i <= i_last; ++i)
    {
      const double t = (m_view.u(i) - outer.u) / (inner.u - outer.u), v = outer.v + t * (inner.v - outer.v),
                   arch = 4 * t * (1 - t);
      const Face_view::Extremum high = crease_near(m_view.u(i), v + .026 * arch, Face_view::pixel,
                                                   .002 + .008 * arch),
                                low = crease_near(m_view.u(i), v - .012 * arch, Face_view::pixel,
                                                  .002 + .008 * arch);
      m_columns.push_back({m_view.u(i), low.v, high.v});
      if(t > .2 && t < .8)
        weakest = std::min({weakest, high.value, low.value});
    }
    m_certainty = weakest > .25 * s_least_crease ? .4 : .2;
    m_is_whole = true;
    return true;
  }

  Eye_outline outline() const
  {
    const double width = m_columns.back().u - m_columns.front().u + Face_view::pixel;
    const auto middle = [](const Column& c) { return .5 * (c.low + c.high); };
    const bool outer_first = m_side < 0;
    const Column &outer = outer_first ? m_columns.front() : m_columns.back(),
                 &inner = outer_first ? m_columns.back() : m_columns.front();
    Eye_outline result;
    result.certainty = m_certainty;
    result.width = width;
    // The lids meet a little beyond the end of what is seen of the ball; at the inner corner the caruncle is in between.
    const double outwards = m_is_whole ? 0. : m_side * width, drop = m_is_whole ? 0. : s_inner_drop * width;
    result.outer_corner = {outer.u + s_outer_margin * outwards, middle(outer)};
    result.inner_corner = {inner.u - s_inner_margin * outwards, middle(inner) - drop};
    for(std::size_t k = 0; k < 2; ++k)
    {
      const double upper = s_upper_places[k], lower = s_lower_places[k];
      const auto u_at = [&](double t) { return (1 - t) * result.outer_corner.u + t * result.inner_corner.u; };
      result.upper[k] = {u_at(upper), edge(u_at(upper), true)};
      result.lower[k] = {u_at(lower), edge(u_at(lower), false)};
    }
    return result;
  }

  // the edge of a lid at `u`, by a line through the columns near it
  double edge(double u, bool is_upper) const
  {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    constexpr double reach = .006;
    for(const Column& c : m_columns)
    {
      const double weight = 1. - std::abs(c.u - u) / reach;
      if(weight <= 0.)
        continue;
      const double dx = c.u - u, value = is_upper ? c.high : c.low;
      n += weight;
      x += weight * dx;
      y += weight * value;
      xx += weight * dx * dx;
      xy += weight * dx * value;
    }
    if(!(n > 0.))
    {
      const Column& nearest = std::abs(m_columns.front().u - u) < std::abs(m_columns.back().u - u)
                                  ? m_columns.front()
                                  : m_columns.back();
      return .5 * (nearest.low + nearest.high);
    }
    const double determinant = n * xx - x * x;
    return determinant > 1e-9 * n * n * reach * reach ? (xx * y - x * xy) / determinant : y / n;
  }

  // in units of the width of what is seen of the ball
  static constexpr double s_outer_margin = .012, s_inner_margin = .125, s_inner_drop = .07;
  // where on the way from the outer to the inner corner
  static constexpr std::array<double, 2> s_upper_places = {.222, .645}, s_lower_places = {.228, .652};

  const Face_view& m_view;
  int m_side;
  double m_u, m_v, m_usual_width;
  std::vector<Column> m_columns; // from left to right
  double m_certainty = 0.;
  bool m_is_whole = false; // the columns reach from corner to corner
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_EYE_FINDER_H
