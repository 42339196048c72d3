#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_MOUTH_FINDER_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_MOUTH_FINDER_H

#include <Shape_characteristics/head_features/internal/Face_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// A mouth as it is seen from the front, open or closed.
struct Mouth_outline
{
  struct Place
  {
    double u = 0., v = 0.;
  };
  std::array<Place, 2> corners; // left and right
  double upper_lip = 0.;        // the lower edge of the upper lip at the middle
  double lower_lip = 0.;        // the upper edge of the lower lip there: the same if the mouth is closed
  double certainty = 0.;        // 0: not found
};

// The lips meet in the deepest crease below the nose; where the mouth is open, skin ends there. From the middle it is followed
// to both sides until it fades.
class Mouth_finder
{
public:
  // `middle`: x of the midline near the mouth; the line of the lips is looked for between `v_min` and `v_max`
  Mouth_finder(const Face_view& view, double middle, double v_min, double v_max)
    : m_view(view),
      m_middle(middle),
      m_v_min(v_min),
      m_v_max(v_max)
  {}

  Mouth_outline find() const
  {
    Mouth_outline result;
    Row start = opening_or_crease(m_view.column(m_middle), m_view.row(m_v_min), m_view.row(m_v_max), 0.);
    if(!start.is_open && start.crease < s_least_crease)
      return result;
    result.lower_lip = m_view.v(start.low);
    result.upper_lip = m_view.v(start.high);
    result.certainty = start.is_open ? 1. : std::min(1., start.crease / (2. * s_corner_crease));
    for(const int side : {-1, 1})
      result.corners[side < 0 ? 0 : 1] = corner(side, start);
    return result;
  }

private:
  static constexpr double s_least_crease = 25., s_corner_crease = 90.; // in 1 / height of the head
  static constexpr double s_beyond_opening = .012; // from where the lips part to the corner
  static constexpr double s_greatest_half_width = .22;

  struct Row
  {
    double low = 0., high = 0., crease = 0.; // rows; equal if the lips meet
    bool is_open = false;
    double middle() const { return .5 * (low + high); }
  };

  // the largest opening between two rows, or else the deepest crease; rows far from `expected` count less by `pull` per row
  Row opening_or_crease(int i, int j_min, int j_max, double pull, double expected = 0.) const
  {
    Row row;
    int longest = 0;
    for(int j = j_min; j <= j_max; ++j)
    {
      if(m_view.is_skin(i, j))
        continue;
      int low = j, high = j;
      while(low > 1 && !m_view.is_skin(i, low - 1))
        --low;
      while(high + 2 < m_view.rows() && !m_view.is_skin(i, high + 1))
        ++high;
      if(high - low + 1 > longest && (high - low + 1) * Face_view::pixel < .25)
      {
        longest = high - low + 1;
        row.low = low;
        row.high = high;
        row.is_open = true;
      }
      j = high;
    }
    if(row.is_open)
      return row;
    double best = -1e300;
    for(int j = j_min; j <= j_max; ++j)
    {
      const double crease = m_view.crease(i, j), value = crease - pull * std::abs(j - expected);
      if(value > best)
      {
        best = value;
        row.crease = crease;
        row.low = row.high = j;
      }
    }
    return row;
  }

  Mouth_outline::Place corner(int side, const Row& start) const
  {
    const int i_start = m_view.column(m_middle);
    double row = start.middle();
    // where the opening ends, and where the crease is strong for the last time
    double u_open = m_middle, v_open = m_view.v(row), u_creased = m_middle, v_creased = v_open;
    // of a mouth that is modelled coarsely, the crease is weak everywhere
    const double least = start.is_open ? s_corner_crease : std::min(s_corner_crease, .5 * start.crease);
    double previous = 2 * least;
    for(int i = i_start; std::abs(m_view.u(i) - m_middle) < s_greatest_half_width; i += side)
    {
      const int j = int(std::lround(row));
      const int reach = i == i_start ? 0 : 7;
      Row here = opening_or_crease(i, j - reach, j + reach, 0.);
      if(here.is_open)
      {
        row = here.middle();
        u_open = u_creased = m_view.u(i);
        v_open = v_creased = m_view.v(row);
        previous = 2 * least;
        continue;
      }
      here = opening_or_crease(i, j - 2, j + 2, .5, row);
      row = here.middle();
      if(here.crease >= least)
      {
        u_creased = m_view.u(i);
        v_creased = m_view.v(row);
      }
      else if(previous >= least)
      {
        const double t = (previous - least) / (previous - here.crease);
        u_creased = m_view.u(i - side + t * side);
        v_creased = m_view.v(row);
      }
      if(here.crease < .5 * least && std::abs(m_view.u(i) - u_open) > 2 * s_beyond_opening &&
         std::abs(m_view.u(i) - m_middle) > .05)
        break;
      previous = here.crease;
    }
    if((u_creased - u_open) * side < s_beyond_opening)
      return {u_open + side * s_beyond_opening, v_open + s_rise};
    return {u_creased, v_creased + s_rise};
  }

  static constexpr double s_rise = .003; // the corner is at the upper side of the crease

  const Face_view& m_view;
  double m_middle, m_v_min, m_v_max;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_MOUTH_FINDER_H
