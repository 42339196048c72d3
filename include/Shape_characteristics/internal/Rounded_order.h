#ifndef SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_ORDER_H
#define SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_ORDER_H

#include <Shape_characteristics/internal/Rounded_comparison.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>

#include <Eigen/Core>

namespace Shape_characteristics {
namespace internal {

/*
  The lexicographic order of points by coordinates that are rounded to a millionth of `size`. Those of regular surfaces
  often are the same but for rounding; then the next ones decide, and decide alike however large the surface is. Points
  that no coordinate tells apart are compared with all digits.

  The points are finite, or `size` isn't.
*/
class Rounded_order
{
public:
  Rounded_order(const Eigen::Vector3d& origin, double size) : m_origin(origin), m_unit(0x1p-20 * size) {}

  bool operator()(const Eigen::Vector3d& p, const Eigen::Vector3d& q) const
  {
    for(int c = 0; c < 3; ++c)
      if(const int sign = Rounded_comparison(m_origin[c], m_unit)(p[c], q[c]); sign != 0)
        return sign < 0;
    return lexicographically_smaller(p, q);
  }

private:
  Eigen::Vector3d m_origin;
  double m_unit;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_ROUNDED_ORDER_H
