#ifndef SHAPE_CHARACTERISTICS_SAMPLING_POINT_SET_SAMPLES_H
#define SHAPE_CHARACTERISTICS_SAMPLING_POINT_SET_SAMPLES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/length.h>
#include <Shape_characteristics/internal/lexicographically_smaller.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/internal/mean_of.h>
#include <Shape_characteristics/sampling/internal/neighbor_order.h>

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsSampling

  holds the points of a range as samples of a surface: points, normals, and the neighbors of each point: the
  nearest ones, or those within a ball. The search runs on \cgal's kd-tree.

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

    Complexity: \f$ O(n \log n) \f$.
  */
  template <typename PointRange, typename PointMap>
  Point_set_samples(const PointRange& points, const PointMap& point_map, const Neighborhood& neighborhood)
    : m_neighborhood(neighborhood)
  {
    if(neighborhood.kind() == Neighborhood::Kind::RINGS)
      throw std::invalid_argument("Shape_characteristics: number_of_rings needs a mesh; on a point set give "
                                  "number_of_neighbors or neighbor_radius");
    for(const auto& item : points)
    {
      if(m_points.size() >= (std::numeric_limits<Index>::max)() - 1)
        throw std::length_error("Shape_characteristics: the point set has too many points");
      const auto& p = get(point_map, item);
      m_points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    }
    m_status.assign(size(), Estimation_status::ESTIMATED);
    for(std::size_t i = 0; i < size(); ++i)
      if(!m_points[i].allFinite())
        m_status[i] = Estimation_status::NON_FINITE_INPUT;
    build_tree();
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
    returns the neighbors of point `i`, the nearest first; equally far ones in the lexicographic order of
    their coordinates. `i` itself, points with the same coordinates as `i`, and points whose coordinates or
    normals are not finite are left out.

    The reference is valid until the next call with the same workspace.

    Complexity: \f$ O(\log n) \f$ on average, plus the sorting of the neighbors.
  */
  const std::vector<Index>& neighbors(std::size_t i, std::size_t /*minimum*/, Workspace& workspace) const
  {
    std::vector<Index>& neighbors = workspace.m_neighbors;
    neighbors.clear();
    if(!m_tree || !m_points[i].allFinite())
      return neighbors;
    if(m_neighborhood.kind() == Neighborhood::Kind::BALL)
      m_tree->search(std::back_inserter(neighbors),
                     Fuzzy_sphere(Index(i), m_neighborhood.radius(), 0., m_tree->traits()));
    else
      collect_nearest(i, m_neighborhood.count(), neighbors);
    neighbors.erase(std::remove_if(neighbors.begin(), neighbors.end(),
                                   [&](const Index j)
                                   { return j == Index(i) || !is_usable(j) || m_points[j] == m_points[i]; }),
                    neighbors.end());
    workspace.m_order.sort(*this, i, neighbors);
    return neighbors;
  }

  /// whether other points have the same coordinates as point `i`
  bool has_coincident_points(std::size_t i) const
  {
    if(!m_tree || !m_points[i].allFinite() || m_tree->size() < 2)
      return false;
    const Point_3& p = (*m_tree_points)[i];
    const K_neighbor_search search(
        *m_tree, p, 2, 0., true,
        typename K_neighbor_search::Distance(CGAL::make_property_map(std::as_const(*m_tree_points))), false);
    return std::all_of(search.begin(), search.end(),
                       [&](const auto& found) { return (*m_tree_points)[found.first] == p; });
  }

  /// mean distance of point `i` to the (at most) 6 nearest points elsewhere (0 if there is none)
  double spacing(std::size_t i) const
  {
    constexpr std::size_t count = 6; // as many as a vertex of a triangle mesh has neighbors
    std::vector<Index> nearest;
    if(m_tree && m_points[i].allFinite())
      collect_nearest(i, count, nearest);
    std::vector<double> distances;
    for(const Index j : nearest)
      if(const double distance = (m_points[j] - m_points[i]).norm(); std::isfinite(distance))
        distances.push_back(distance);
    return internal::mean_of(distances);
  }

  /// mean of `spacing()` over (at most) 1000 points spread evenly over the range
  double mean_spacing() const
  {
    const std::size_t step = (std::max)(size() / 1000, std::size_t(1));
    std::vector<double> spacings;
    for(std::size_t i = 0; i < size(); i += step)
      if(const double s = spacing(i); s > 0.)
        spacings.push_back(s);
    return internal::mean_of(spacings);
  }

  /// what the neighbors are
  const Neighborhood& neighborhood() const noexcept { return m_neighborhood; }

  /// @}

  /*!
    sets the normals.

    \param normals a normal per point, of any length.
    \param failure what becomes of a sample whose normal is zero or not finite, if nothing else was wrong with it. It is
           nobody's neighbor any more.
  */
  void set_normals(std::vector<Eigen::Vector3d> normals,
                   Estimation_status failure = Estimation_status::NON_FINITE_INPUT)
  {
    m_normals = std::move(normals);
    for(std::size_t i = 0; i < size(); ++i)
    {
      const double length = internal::length(m_normals[i]);
      if(length > 0. && std::isfinite(length))
        m_normals[i] = (m_normals[i] / length).normalized();
      else if(is_estimated(m_status[i]))
        m_status[i] = failure;
    }
  }

  /// replaces point `i` in what `point()` returns; the search goes on with the point given at construction
  void set_point(std::size_t i, const Eigen::Vector3d& point) { m_points[i] = point; }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point_3 = Kernel::Point_3;
  using Tree_points = CGAL::Pointer_property_map<Point_3>::const_type;
  using Search_traits = CGAL::Search_traits_adapter<Index, Tree_points, CGAL::Search_traits_3<Kernel> >;
  using K_neighbor_search = CGAL::Orthogonal_k_neighbor_search<Search_traits>;
  using Tree = typename K_neighbor_search::Tree;
  using Fuzzy_sphere = CGAL::Fuzzy_sphere<Search_traits>;

  void build_tree()
  {
    std::vector<Index> finite;
    m_tree_points = std::make_unique<std::vector<Point_3> >();
    m_tree_points->reserve(size());
    for(std::size_t i = 0; i < size(); ++i)
    {
      m_tree_points->emplace_back(m_points[i].x(), m_points[i].y(), m_points[i].z());
      if(m_points[i].allFinite())
        finite.push_back(Index(i));
    }
    if(finite.empty())
      return;
    const Tree_points map = CGAL::make_property_map(std::as_const(*m_tree_points));
    m_tree =
        std::make_unique<Tree>(finite.begin(), finite.end(), typename Tree::Splitter(), Search_traits(map));
    m_tree->build(); // a const query must not build it
  }

  // The `count` points elsewhere that are nearest to point `i`, nearest first. Of equally far ones the order of coordinates
  // (and normals) chooses: the tree alone would leave it to the order of the input.
  void collect_nearest(std::size_t i, std::size_t count, std::vector<Index>& nearest) const
  {
    // Coincident points are not neighbors: where there are any, more points are asked for, and so are they where more
    // than `count` may be meant, up to a limit that keeps thousands of copies of a point affordable.
    std::vector<std::pair<double, Index> > elsewhere;
    const std::size_t available = m_tree->size();
    const std::size_t limit = 64 * (count / 64 < available ? count + 1 : available);
    for(std::size_t k = count < available ? (std::min)(count + 2, available) : available;;
        k = (std::min)(2 * k, available))
    {
      K_neighbor_search search(
          *m_tree, (*m_tree_points)[i], static_cast<unsigned int>(k), 0., true,
          typename K_neighbor_search::Distance(CGAL::make_property_map(std::as_const(*m_tree_points))),
          false);
      elsewhere.clear();
      for(const auto& found : search)
        if((*m_tree_points)[found.first] != (*m_tree_points)[i])
          elsewhere.emplace_back(found.second, found.first);
      std::sort(elsewhere.begin(), elsewhere.end(),
                [&](const auto& a, const auto& b)
                { return a.first != b.first ? a.first < b.first : comes_before(a.second, b.second); });
      if(k == available || k > limit ||
         (elsewhere.size() > count && elsewhere[count - 1].first < elsewhere.back().first))
        break;
    }
    elsewhere.resize((std::min)(elsewhere.size(), count));
    nearest.clear();
    for(const auto& found : elsewhere)
      nearest.push_back(found.second);
  }

  bool comes_before(const Index a, const Index b) const
  {
    const Point_3 &p = (*m_tree_points)[a], &q = (*m_tree_points)[b];
    if(p != q || !has_normals())
      return CGAL::lexicographically_xyz_smaller(p, q);
    return internal::lexicographically_smaller(m_normals[a], m_normals[b]);
  }

  Neighborhood m_neighborhood;
  std::vector<Eigen::Vector3d> m_points, m_normals;
  std::vector<Estimation_status> m_status;
  std::unique_ptr<std::vector<Point_3> > m_tree_points; // at a fixed place: the tree refers to it
  std::unique_ptr<Tree> m_tree;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_POINT_SET_SAMPLES_H
