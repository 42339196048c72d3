#ifndef SHAPE_CHARACTERISTICS_SAMPLING_POINT_SET_SAMPLES_H
#define SHAPE_CHARACTERISTICS_SAMPLING_POINT_SET_SAMPLES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/Rounded_distance.h>
#include <Shape_characteristics/internal/large_pages.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/internal/Kd_tree.h>
#include <Shape_characteristics/sampling/internal/make_unit.h>
#include <Shape_characteristics/sampling/internal/mean_of.h>
#include <Shape_characteristics/sampling/internal/neighbor_order.h>
#include <Shape_characteristics/sampling/internal/typical_distance.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsSampling

  holds the points of a range as samples of a surface: points, normals, and the neighbors of each point: the
  nearest ones, or those within a ball. The search runs on a kd-tree.

  \cgalModels{SampledSurface}
*/
class Point_set_samples
{
public:
  using Index = std::uint32_t; ///< number of a point

  /// scratch memory of `neighbors()`, for one thread at a time
  class Workspace
  {
    friend class Point_set_samples;
    std::vector<internal::Neighbor_order::Key> m_nearest;
    std::vector<Index> m_neighbors;
    internal::Neighbor_order m_order;
  };

  /*!
    copies the points of a range and builds the search structure.

    \tparam PointRange a model of `ConstRange`
    \tparam PointMap a model of `ReadablePropertyMap` from the value type of the range to 3D points
    \param points the range
    \param point_map its points
    \param neighborhood what the neighbors of a point are: `Neighborhood::nearest()` or `Neighborhood::ball()`
    \throws std::length_error if there are more than \f$ 2^{32} - 2 \f$ points
    \throws std::invalid_argument if the neighborhood is one of meshes

    Complexity: \f$ O(n \log n) \f$.
  */
  template <typename PointRange, typename PointMap>
  Point_set_samples(const PointRange& points, const PointMap& point_map, const Neighborhood& neighborhood)
    : m_neighborhood(checked(neighborhood)),
      m_points(copy(points, point_map)),
      m_tree(m_points,
             neighborhood.kind() == Neighborhood::Kind::BALL ? neighborhood.radius()
                                                             : internal::typical_distance(m_points)),
      m_rounded(m_tree.extent() * m_tree.extent())
  {
    m_status.assign(size(), Estimation_status::ESTIMATED);
    for(std::size_t i = 0; i < size(); ++i)
      if(!m_points[i].allFinite())
        m_status[i] = Estimation_status::NON_FINITE_INPUT;
  }

  /// \name Samples
  /// @{

  /// number of points
  std::size_t size() const noexcept { return m_points.size(); }
  /// point `i`
  const Eigen::Vector3d& point(std::size_t i) const { return m_points[i]; }
  /// the unit normal of point `i`
  /// \pre `has_normals()`
  const Eigen::Vector3d& normal(std::size_t i) const { return m_normals[i]; }
  /// whether normals were set
  bool has_normals() const noexcept { return !m_normals.empty() || m_points.empty(); }
  /// `ESTIMATED`, or why nothing can be estimated at point `i`
  Estimation_status status(std::size_t i) const { return m_status[i]; }
  /// whether point `i` may serve as somebody's neighbor
  bool is_usable(std::size_t i) const { return is_estimated(m_status[i]); }

  /*!
    returns the neighbors of point `i`, the nearest first; those that are equally far, to seven digits, in the
    lexicographic order of their coordinates, to six digits. `i` itself, points with the same coordinates as `i`, and
    points whose coordinates or normals are not finite are left out. So are points some \f$ 10^{150} \f$ times as far away as
    points usually are, where the nearest ones are asked for.

    The reference is valid until the next call with the same workspace.

    Complexity: \f$ O(\log n) \f$ on average, plus the sorting of the neighbors.
  */
  const std::vector<Index>& neighbors(std::size_t i, std::size_t /*minimum*/, Workspace& workspace) const
  {
    std::vector<Index>& neighbors = workspace.m_neighbors;
    neighbors.clear();
    if(!m_tree.contains(i))
      return neighbors;
    const auto add = [&](const Index j)
    {
      if(j != Index(i) && is_usable(j) && m_points[j] != m_points[i])
        neighbors.push_back(j);
    };
    if(m_neighborhood.kind() == Neighborhood::Kind::BALL)
    {
      auto in_ball = [&](const Entry& entry) { add(entry.index); };
      const double reach = m_tree.scale() * m_neighborhood.reach();
      Ball_search<decltype(in_ball)> search{reach * reach, in_ball};
      m_tree.search(m_tree.point(i), search);
    }
    else
    {
      const std::size_t count = (std::min)(m_neighborhood.count(), m_tree.entries().size());
      workspace.m_nearest.resize(room_for(count));
      const std::size_t found = collect_nearest(i, true, workspace.m_nearest.data(), count);
      for(std::size_t k = 0; k < found; ++k)
        add(workspace.m_nearest[k].second);
    }
    if(m_neighborhood.kind() == Neighborhood::Kind::BALL || m_has_moved)
      workspace.m_order.sort(*this, i, neighbors);
    return neighbors;
  }

  /// whether other points, with normals if there are any, have the same coordinates as point `i`
  bool has_coincident_points(std::size_t i) const
  {
    bool found = false;
    if(m_tree.contains(i))
    {
      auto is_other = [&](const Entry& entry)
      { found = found || (entry.index != Index(i) && is_usable(entry.index)); };
      Ball_search<decltype(is_other)> search{0., is_other};
      m_tree.search(m_tree.point(i), search);
    }
    return found;
  }

  /// mean distance of point `i` to the (at most) 6 nearest points elsewhere (0 if there is none)
  double spacing(std::size_t i) const
  {
    constexpr std::size_t count = 6; // as many as a vertex of a triangle mesh has neighbors
    std::array<Candidate, count> nearest;
    std::array<double, count> distances;
    std::size_t number = 0;
    if(m_tree.contains(i))
      for(std::size_t j = 0, found = collect_nearest(i, false, nearest.data(), count); j < found; ++j)
        if(const double d = spacing_between(nearest[j].second, i); std::isfinite(d))
        {
          // in ascending order, whatever the points' own: the sum then has the same bits
          std::size_t k = number++;
          for(; k > 0 && d < distances[k - 1]; --k)
            distances[k] = distances[k - 1];
          distances[k] = d;
        }
    double sum = 0.;
    for(std::size_t k = 0; k < number; ++k)
      sum += distances[k] / double(number);
    return sum;
  }

  /// mean of `spacing()` over all points: over some of them it would depend on their order, or on how they are turned
  ///
  /// Complexity: \f$ O(n \log n) \f$.
  double mean_spacing() const
  {
    std::vector<double> spacings;
    spacings.reserve(size());
    for(std::size_t i = 0; i < size(); ++i)
      if(const double s = spacing(i); s > 0.)
        spacings.push_back(s);
    return internal::mean_of(spacings);
  }

  /// what the neighbors are
  const Neighborhood& neighborhood() const noexcept { return m_neighborhood; }

  /*!
    returns all points in an order in which neighbors are mostly close to each other, so that blocks of it, of whatever
    size, are compact: that of the leaves of the search tree. Points that are not finite come last.

    Complexity: linear in the number of points.
  */
  std::vector<Index> traversal_order(std::size_t /*patch_size*/ = 2000) const
  {
    std::vector<Index> order;
    order.reserve(size());
    for(const Entry& entry : m_tree.entries())
      order.push_back(entry.index);
    for(std::size_t i = 0; i < size(); ++i)
      if(!m_tree.contains(i))
        order.push_back(Index(i));
    return order;
  }

  /// blocks of `traversal_order()`, one after the other
  class Traversal
  {
  public:
    /// begins a traversal of `samples`
    Traversal(const Point_set_samples& samples, std::size_t patch_size)
      : m_order(samples.traversal_order()),
        m_patch_size(patch_size)
    {}

    /// replaces `patch` by the next `patch_size` points, or by what is left.
    void next(std::vector<Index>& patch)
    {
      const std::size_t end = (std::min)(m_begin + m_patch_size, m_order.size());
      patch.assign(m_order.begin() + std::ptrdiff_t(m_begin), m_order.begin() + std::ptrdiff_t(end));
      m_begin = end;
    }

  private:
    std::vector<Index> m_order;
    std::size_t m_patch_size, m_begin = 0;
  };

  /// @}

  /*!
    sets the normals.

    \param normals a normal per point, of any length. Those that are of unit length, up to rounding, keep their bits.
    \param failure what becomes of a sample whose normal is zero or not finite, if nothing else was wrong with it. It is
           nobody's neighbor any more.
  */
  void set_normals(std::vector<Eigen::Vector3d> normals,
                   Estimation_status failure = Estimation_status::NON_FINITE_INPUT)
  {
    m_normals = std::move(normals);
    internal::make_unit(m_normals, m_status, failure);
  }

  /// replaces point `i` in what `point()` returns; the search goes on with the point given at construction
  void set_point(std::size_t i, const Eigen::Vector3d& point)
  {
    m_points[i] = point;
    m_has_moved = true;
  }

private:
  using Entry = internal::Kd_tree::Entry;
  using Candidate = internal::Neighbor_order::Key;

  static constexpr std::size_t s_few = 64; // neighbors that are kept in order while they are found

  // for the candidates among which so many nearest points are looked for
  static std::size_t room_for(std::size_t wanted) { return wanted > s_few ? 2 * wanted : wanted; }

  static const Neighborhood& checked(const Neighborhood& neighborhood)
  {
    if(neighborhood.kind() == Neighborhood::Kind::RINGS)
      throw std::invalid_argument("Shape_characteristics: number_of_rings needs a mesh; on a point set give "
                                  "number_of_neighbors or neighbor_radius");
    return neighborhood;
  }

  template <typename PointRange, typename PointMap>
  static std::vector<Eigen::Vector3d> copy(const PointRange& points, const PointMap& point_map)
  {
    std::vector<Eigen::Vector3d> result;
    internal::reserve_large_pages(result, std::size_t(std::distance(std::begin(points), std::end(points))));
    for(const auto& item : points)
    {
      if(result.size() >= (std::numeric_limits<Index>::max)() - 1)
        throw std::length_error("Shape_characteristics: the point set has too many points");
      const auto& p = get(point_map, item);
      result.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    }
    return result;
  }

  template <typename Function>
  struct Ball_search
  {
    double radius; // squared
    const Function& function;

    double squared_radius() const { return radius; }
    void operator()(const Entry& entry, double squared_distance) const
    {
      if(squared_distance <= radius)
        function(entry);
    }
  };

  // The nearest points elsewhere, nearest first. Of equally far ones the order of coordinates (and normals) chooses: the tree
  // alone would leave it to the order of the input. Few are kept in order while they are found, many are only sorted in the end.
  struct Nearest_search
  {
    const Point_set_samples& samples;
    const Eigen::Vector3d& center;
    bool are_usable; // those that are sought
    Candidate* nearest;
    std::size_t wanted, room = room_for(wanted), size = 0;
    double radius =
        (std::numeric_limits<double>::max)(); // squared; what is out of the range of numbers is out of reach

    bool is_before(const Candidate& a, const Candidate& b) const
    {
      return internal::Neighbor_order::comes_before(samples, center, samples.m_rounded, a,
                                                    samples.m_tree.point(a.second), b,
                                                    samples.m_tree.point(b.second));
    }
    auto in_order() const
    {
      return [this](const Candidate& a, const Candidate& b) { return is_before(a, b); };
    }
    double squared_radius() const { return radius; }
    void operator()(const Entry& entry, double squared_distance)
    {
      // points that are so close that squares don't tell them apart are one
      if(squared_distance > radius || squared_distance < (std::numeric_limits<double>::min)() ||
         (are_usable && !samples.is_usable(entry.index)))
        return;
      const Candidate candidate(samples.m_rounded(squared_distance), entry.index);
      if(room > wanted)
      {
        nearest[size++] = candidate;
        if(size == room)
          drop_farthest();
        return;
      }
      if(size < wanted)
        ++size;
      else if(!is_before(candidate, nearest[wanted - 1]))
        return;
      std::size_t k = size - 1;
      for(; k > 0 && is_before(candidate, nearest[k - 1]); --k)
        nearest[k] = nearest[k - 1];
      nearest[k] = candidate;
      if(size == wanted)
        shrink();
    }
    void drop_farthest()
    {
      std::nth_element(nearest, nearest + wanted - 1, nearest + size, in_order());
      size = wanted;
      shrink();
    }
    void shrink() { radius = (std::min)(radius, samples.m_rounded.largest(nearest[wanted - 1].first)); }
    void finish()
    {
      if(room == wanted)
        return;
      std::sort(nearest, nearest + size, in_order());
      size = (std::min)(size, wanted);
    }
  };

  double spacing_between(std::size_t i, std::size_t j) const
  {
    return (m_tree.scale() * (m_points[i] - m_points[j])).norm() / m_tree.scale();
  }

  // returns how many there are, at most `count`; there is room for `room_for(count)`
  std::size_t collect_nearest(std::size_t i, bool are_usable, Candidate* nearest, std::size_t count) const
  {
    Nearest_search search{*this, m_tree.point(i), are_usable, nearest, count};
    m_tree.search(search.center, search);
    search.finish();
    return search.size;
  }

  Neighborhood m_neighborhood;
  std::vector<Eigen::Vector3d> m_points, m_normals;
  std::vector<Estimation_status> m_status;
  internal::Kd_tree m_tree; // of the points given at construction
  internal::Rounded_distance m_rounded;
  bool m_has_moved = false; // from them
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_POINT_SET_SAMPLES_H
