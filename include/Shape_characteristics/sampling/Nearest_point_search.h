#ifndef SHAPE_CHARACTERISTICS_SAMPLING_NEAREST_POINT_SEARCH_H
#define SHAPE_CHARACTERISTICS_SAMPLING_NEAREST_POINT_SEARCH_H

#include <Shape_characteristics/sampling/internal/Kd_tree.h>
#include <Shape_characteristics/sampling/internal/typical_distance.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsSampling

  finds the point of a set that is nearest to a place in space. Points with infinite or NaN coordinates are never found.

  The functions may be called by several threads at a time.
*/
class Nearest_point_search
{
public:
  using Index = std::uint32_t;                                               ///< number of a point
  static constexpr Index none = (std::numeric_limits<std::uint32_t>::max)(); ///< the number of no point

  /// copies the points and builds the search structure
  /// \throws std::length_error if there are more than \f$ 2^{32} - 2 \f$ points
  ///
  /// Complexity: \f$ O(n \log n) \f$.
  explicit Nearest_point_search(const std::vector<Eigen::Vector3d>& points)
    : m_tree(checked(points), internal::typical_distance(points))
  {}

  /*!
    returns the point nearest to `place`, of equally near ones the one with the lowest number; `none` if there is none
    within `maximum_distance`, or `place` isn't finite.

    Complexity: \f$ O(\log n) \f$ on average.
  */
  Index nearest(const Eigen::Vector3d& place,
                double maximum_distance = std::numeric_limits<double>::infinity()) const
  {
    return place.allFinite() ? search(m_tree.scaled(place), m_tree.scale() * maximum_distance, false) : none;
  }

  /// returns the point nearest to point `i` among those with other coordinates, or `none`; see `nearest()`.
  Index nearest_elsewhere(std::size_t i) const
  {
    return m_tree.contains(i) ? search(m_tree.point(i), std::numeric_limits<double>::infinity(), true) : none;
  }

private:
  using Entry = internal::Kd_tree::Entry;

  struct Search
  {
    const Eigen::Vector3d& place;
    double radius; // squared
    bool elsewhere;
    Index found = none;

    double squared_radius() const { return radius; }
    void operator()(const Entry& entry, double squared_distance)
    {
      if(squared_distance > radius || (elsewhere && entry.point == place))
        return;
      if(squared_distance < radius || entry.index < found)
        found = entry.index;
      radius = squared_distance;
    }
  };

  // in the unit of the tree
  Index search(const Eigen::Vector3d& place, double maximum_distance, bool elsewhere) const
  {
    if(m_tree.entries().empty())
      return none;
    Search search{place, maximum_distance * maximum_distance, elsewhere};
    m_tree.search(place, search);
    return search.found;
  }

  static const std::vector<Eigen::Vector3d>& checked(const std::vector<Eigen::Vector3d>& points)
  {
    if(points.size() >= none)
      throw std::length_error("Shape_characteristics: the point set has too many points");
    return points;
  }

  internal::Kd_tree m_tree;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_NEAREST_POINT_SEARCH_H
