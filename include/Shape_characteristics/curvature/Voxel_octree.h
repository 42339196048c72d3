#ifndef SHAPE_CHARACTERISTICS_CURVATURE_VOXEL_OCTREE_H
#define SHAPE_CHARACTERISTICS_CURVATURE_VOXEL_OCTREE_H

#include <Shape_characteristics/curvature/internal/Ball_section.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  holds a solid that is given by the values of a grid of voxels, as an octree whose nodes know the volume, the first and the
  second moments of what is in them (thesis, section 5.3.3).

  The value of a voxel is the share of it that is inside: 0 or 1 for binary data, anything between where the data are grey,
  which is more exact. Regions of one value are one node. What lies outside of the grid is empty.

  Integrals over balls are exact, but for rounding: those of nodes in the ball are known; what the sphere passes through is
  divided as far as it isn't of one value; and boxes of one value are clipped by the ball in closed form.
*/
class Voxel_octree
{
public:
  using Voxel = std::array<std::size_t, 3>; ///< numbers of a voxel along the axes, or of voxels

  /*!
    reads the voxels.

    \tparam Point_3 a type with members `x()`, `y()` and `z()`
    \tparam Value a function of three numbers of type `std::size_t` that returns a number or a `bool`
    \param size the numbers of voxels along the axes, at most \f$ 2^{20} \f$
    \param origin the corner of the first voxel at which all coordinates are smallest
    \param spacing the lengths of the sides of a voxel
    \param value the share of the voxel `(i, j, k)` that is inside, in \f$ [0, 1] \f$. It is called once for each
           voxel, in an order that is not specified.
    \throws std::invalid_argument if `size`, `origin` or `spacing` is out of its range, or a value is
    \throws std::length_error if the octree gets \f$ 2^{32} - 1 \f$ nodes that have parts

    Complexity: linear in the number of voxels. The memory is proportional to the number of voxels at the surface.
  */
  template <typename Point_3, typename Value>
  Voxel_octree(const Voxel& size,
               const Point_3& origin,
               const std::array<double, 3>& spacing,
               const Value& value)
    : m_size(size),
      m_origin(CGAL::to_double(origin.x()), CGAL::to_double(origin.y()), CGAL::to_double(origin.z())),
      m_spacing(spacing[0], spacing[1], spacing[2])
  {
    if(!m_origin.allFinite())
      throw std::invalid_argument("Shape_characteristics: the origin of the voxels must be finite");
    if(!m_spacing.allFinite() || !(m_spacing.minCoeff() > 0.))
      throw std::invalid_argument("Shape_characteristics: the spacing of the voxels must be positive");
    const std::size_t largest = *std::max_element(size.begin(), size.end());
    if(largest > (std::size_t(1) << s_most_levels))
      throw std::invalid_argument("Shape_characteristics: there are too many voxels along an axis");
    while((std::size_t(1) << m_levels) < largest)
      ++m_levels;
    m_root = read({0, 0, 0}, m_levels, value).node;
  }

  /// the numbers of voxels along the axes
  const Voxel& size() const noexcept { return m_size; }
  /// the lengths of the sides of a voxel
  std::array<double, 3> spacing() const { return {m_spacing[0], m_spacing[1], m_spacing[2]}; }
  /// how many nodes the octree has
  std::size_t number_of_nodes() const noexcept { return m_blocks.size() * 8 + 1; }

  /// the value of a voxel; 0 outside of the grid
  double value(std::size_t i, std::size_t j, std::size_t k) const
  {
    if(i >= m_size[0] || j >= m_size[1] || k >= m_size[2])
      return 0.;
    Node node = m_root;
    for(unsigned int level = m_levels; node.block != s_uniform;)
    {
      --level;
      node = m_blocks[node.block]
                 .children[((i >> level) & 1) | (((j >> level) & 1) << 1) | (((k >> level) & 1) << 2)];
    }
    return node.value;
  }

  /*!
    returns the volume of the part of the solid that lies in a ball.

    \param center the center of the ball
    \param radius its radius
    \throws std::invalid_argument if the radius is not positive, or anything is not finite
  */
  template <typename Point_3>
  double volume_in_ball(const Point_3& center, double radius) const
  {
    const Eigen::Vector3d c(CGAL::to_double(center.x()), CGAL::to_double(center.y()),
                            CGAL::to_double(center.z()));
    if(!(radius > 0. && std::isfinite(radius)) || !c.allFinite())
      throw std::invalid_argument("Shape_characteristics: the ball must be finite, and its radius positive");
    // a larger ball than one that holds the grid holds no more, but the share of it that is filled becomes 0
    const Eigen::Vector3d extent =
        m_spacing.cwiseProduct(Eigen::Vector3d(double(m_size[0]), double(m_size[1]), double(m_size[2])));
    const double r = (std::min)(radius, 2. * ((c - m_origin).cwiseAbs() + extent).stableNorm());
    if(!(r > 0.))
      return 0.; // there is no voxel
    return moments_in_ball(c, r).volume * r * r * r;
  }

  /*!
    returns points of the surface: on each segment between the centers of two voxels that have a face in common, of which one is
    inside (1/2 or more) and the other one is not, the point where the value is 1/2 if it is linear in between. On binary
    data they are the centers of the faces at which the solid ends.

    The points are ordered by axis, then by voxel.

    \tparam GeomTraits a geometric traits class with the type `%Point_3`

    Complexity: \f$ O(n \log n) \f$ for the \f$ n \f$ voxels of the grid.
  */
  template <typename GeomTraits = CGAL::Simple_cartesian<double> >
  std::vector<typename GeomTraits::Point_3> surface_points() const
  {
    using Point_3 = typename GeomTraits::Point_3;
    using FT = typename GeomTraits::FT;
    std::vector<Point_3> points;
    for(std::size_t axis = 0; axis < 3; ++axis)
      for(std::size_t k = 0; k < m_size[2]; ++k)
        for(std::size_t j = 0; j < m_size[1]; ++j)
          for(std::size_t i = 0; i < m_size[0]; ++i)
          {
            const double a = value(i, j, k);
            const double b = value(i + (axis == 0), j + (axis == 1), k + (axis == 2));
            const auto add = [&](double first, double second, double from)
            {
              if((first >= .5) == (second >= .5))
                return;
              Eigen::Vector3d p(double(i) + .5, double(j) + .5, double(k) + .5);
              p[Eigen::Index(axis)] += from + (.5 - first) / (second - first);
              const Eigen::Vector3d q = m_origin + m_spacing.cwiseProduct(p);
              points.emplace_back(FT(q.x()), FT(q.y()), FT(q.z()));
            };
            if((axis == 0 ? i : axis == 1 ? j : k) == 0)
              add(0., a, -1.); // before the first one
            add(a, b, 0.);
          }
    return points;
  }

  /// \cond INTERNAL

  // the moments of the part in a ball, in units of its radius, with respect to its center
  internal::Volume_moments moments_in_ball(const Eigen::Vector3d& center, double radius) const
  {
    const Eigen::Vector3d unit = m_spacing / radius;
    internal::Volume_moments sum;
    add(m_root, m_levels, {0, 0, 0}, ((center - m_origin).array() / m_spacing.array()).matrix(), unit, sum);
    return sum;
  }

  // whether a ball leaves the grid where the solid does, or may: it isn't known what is there
  bool is_cut_off(const Eigen::Vector3d& center, double radius) const
  {
    for(int axis = 0; axis < 3; ++axis)
    {
      const double x = center[axis] - m_origin[axis];
      if((m_is_cut_off[std::size_t(2 * axis)] && x - radius < 0.) ||
         (m_is_cut_off[std::size_t(2 * axis + 1)] &&
          x + radius > double(m_size[std::size_t(axis)]) * m_spacing[axis]))
        return true;
    }
    return false;
  }

  /// \endcond

private:
  static constexpr unsigned int s_most_levels = 20;
  static constexpr std::uint32_t s_uniform = (std::numeric_limits<std::uint32_t>::max)();

  struct Node
  {
    double value = 0.;               // if it is uniform
    std::uint32_t block = s_uniform; // that of its children
  };

  // the children of a node, and the moments of all of them, in voxels and with respect to the center of the node
  struct Block
  {
    std::array<Node, 8> children;
    internal::Volume_moments moments;
  };

  struct Part
  {
    Node node;
    internal::Volume_moments moments; // as above
  };

  static internal::Volume_moments moments_of_cube(double side, double value)
  {
    internal::Volume_moments m;
    m.volume = value * side * side * side;
    m.second = m.volume * side * side / 12. * Eigen::Matrix3d::Identity();
    return m;
  }

  // with respect to a point from which the one before is seen at `shift`
  static internal::Volume_moments moved(internal::Volume_moments m, const Eigen::Vector3d& shift)
  {
    m.second +=
        shift * m.first.transpose() + m.first * shift.transpose() + m.volume * shift * shift.transpose();
    m.first += m.volume * shift;
    return m;
  }

  static void add_to(internal::Volume_moments& sum, const internal::Volume_moments& m)
  {
    sum.volume += m.volume;
    sum.first += m.first;
    sum.second += m.second;
  }

  template <typename Value>
  Part read(const Voxel& at, unsigned int level, const Value& value)
  {
    Part part;
    for(std::size_t axis = 0; axis < 3; ++axis)
      if(at[axis] >= m_size[axis])
        return part;
    if(level == 0)
    {
      const double v = double(value(at[0], at[1], at[2]));
      if(!(v >= 0. && v <= 1.))
        throw std::invalid_argument("Shape_characteristics: the value of a voxel must be from 0 to 1");
      if(v > 0.)
        for(std::size_t axis = 0; axis < 3; ++axis)
        {
          m_is_cut_off[2 * axis] = m_is_cut_off[2 * axis] || at[axis] == 0;
          m_is_cut_off[2 * axis + 1] = m_is_cut_off[2 * axis + 1] || at[axis] + 1 == m_size[axis];
        }
      part.node.value = v;
      part.moments = moments_of_cube(1., v);
      return part;
    }
    const std::size_t half = std::size_t(1) << (level - 1);
    Block block;
    bool is_uniform = true;
    for(std::size_t c = 0; c < 8; ++c)
    {
      const Voxel child = {at[0] + (c & 1) * half, at[1] + ((c >> 1) & 1) * half,
                           at[2] + ((c >> 2) & 1) * half};
      const Part p = read(child, level - 1, value);
      block.children[c] = p.node;
      add_to(block.moments, moved(p.moments, double(half) * direction(c)));
      is_uniform = is_uniform && p.node.block == s_uniform && p.node.value == block.children[0].value;
    }
    if(is_uniform)
    {
      part.node = block.children[0];
      part.moments = moments_of_cube(double(2 * half), part.node.value);
      return part;
    }
    if(m_blocks.size() >= s_uniform)
      throw std::length_error("Shape_characteristics: the octree has too many nodes");
    part.node.block = std::uint32_t(m_blocks.size());
    part.moments = block.moments;
    m_blocks.push_back(block);
    return part;
  }

  // from the center of a node to that of a child, in sides of the child
  static Eigen::Vector3d direction(std::size_t child)
  {
    return {double(child & 1) - .5, double((child >> 1) & 1) - .5, double((child >> 2) & 1) - .5};
  }

  // what of a node is in the ball; `center` is in voxels, `unit` is a voxel in radii
  void add(const Node& node,
           unsigned int level,
           const Voxel& at,
           const Eigen::Vector3d& center,
           const Eigen::Vector3d& unit,
           internal::Volume_moments& sum) const
  {
    if(node.block == s_uniform && node.value == 0.)
      return;
    const double side = double(std::size_t(1) << level);
    const Eigen::Vector3d low_in_voxels =
        Eigen::Vector3d(double(at[0]), double(at[1]), double(at[2])) - center;
    const Eigen::Vector3d low = unit.cwiseProduct(low_in_voxels);
    const Eigen::Vector3d high = unit.cwiseProduct((low_in_voxels.array() + side).matrix());
    if(low.cwiseMax(-high).cwiseMax(0.).squaredNorm() >= 1.)
      return;
    if(low.cwiseAbs().cwiseMax(high.cwiseAbs()).squaredNorm() <= 1.)
    {
      internal::Volume_moments m =
          node.block == s_uniform ? moments_of_cube(side, node.value) : m_blocks[node.block].moments;
      m = moved(m, (low_in_voxels.array() + .5 * side).matrix());
      const double scale = unit.prod();
      sum.volume += scale * m.volume;
      sum.first += scale * unit.cwiseProduct(m.first);
      sum.second += scale * (unit.asDiagonal() * m.second * unit.asDiagonal());
      return;
    }
    if(node.block == s_uniform)
    {
      const internal::Volume_moments m = internal::box_in_ball(low, high);
      sum.volume += node.value * m.volume;
      sum.first += node.value * m.first;
      sum.second += node.value * m.second;
      return;
    }
    const std::size_t half = std::size_t(1) << (level - 1);
    const Block& block = m_blocks[node.block];
    for(std::size_t c = 0; c < 8; ++c)
      add(block.children[c], level - 1,
          {at[0] + (c & 1) * half, at[1] + ((c >> 1) & 1) * half, at[2] + ((c >> 2) & 1) * half}, center,
          unit, sum);
  }

  Voxel m_size;
  Eigen::Vector3d m_origin, m_spacing;
  unsigned int m_levels = 0;
  std::array<bool, 6> m_is_cut_off = {}; // whether the solid reaches the sides of the grid
  std::vector<Block> m_blocks;
  Node m_root;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_VOXEL_OCTREE_H
