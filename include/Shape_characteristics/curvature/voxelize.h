#ifndef SHAPE_CHARACTERISTICS_CURVATURE_VOXELIZE_H
#define SHAPE_CHARACTERISTICS_CURVATURE_VOXELIZE_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/Voxel_octree.h>
#include <Shape_characteristics/curvature/Voxel_values.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/to_eigen.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Scan conversion along columns of the z axis, in units of a voxel: of some rows of columns at a time, so that what the columns cross
// doesn't take more memory than the voxels do.
class Voxel_columns
{
  using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point_2 = Predicates::Point_2;

public:
  using Triangle = std::array<Eigen::Vector3d, 3>; // in voxels, from the corner of the grid

  // `columns_per_voxel` along x and along y
  Voxel_columns(const std::array<std::size_t, 3>& size, std::size_t columns_per_voxel)
    : m_size(size),
      m_fineness(columns_per_voxel)
  {}

  // the shares of the voxels that are inside, x first; or whether their centers are
  std::vector<float> values(const std::vector<Triangle>& triangles, bool are_binary)
  {
    std::vector<float> shares(m_size[0] * m_size[1] * m_size[2], 0.f);
    const std::size_t columns = m_size[0] * m_fineness, rows = m_size[1] * m_fineness;
    const std::size_t rows_at_once =
        (std::max)(s_columns_at_once / (std::max)(columns, std::size_t(1)), std::size_t(1));
    for(std::size_t begin = 0; begin < rows; begin += rows_at_once)
    {
      m_crossings.clear();
      for(const Triangle& t : triangles)
        add_triangle(t, begin, (std::min)(begin + rows_at_once, rows));
      add_shares(are_binary, shares);
    }
    for(float& share : shares)
      share = share > 1.f - 1e-6f ? 1.f : share; // sums of rounded shares
    return shares;
  }

private:
  static constexpr std::size_t s_columns_at_once = std::size_t(1) << 20;

  struct Crossing
  {
    std::size_t column;
    double z;
    int side; // 1 into the solid, going up; -1 out of it
  };

  // the columns over the numbers from `low` to `high`
  std::pair<std::size_t, std::size_t>
  range(double low, double high, std::size_t first, std::size_t count) const
  {
    const double begin = std::floor(low * double(m_fineness) - .5),
                 end = std::ceil(high * double(m_fineness) - .5) + 1.;
    return {std::size_t((std::max)(begin, double(first))),
            std::size_t((std::min)((std::max)(end, 0.), double(count)))};
  }

  // where a triangle is to be found in the row at `y`: the smallest and the largest x, to within a column
  static std::pair<double, double> extent(const Triangle& p, double y)
  {
    constexpr double flat = 1e-6; // slope of an edge of which rounding could tell too little
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto extend = [&](const double x)
    {
      low = (std::min)(low, x);
      high = (std::max)(high, x);
    };
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d &a = p[k], &b = p[(k + 1) % 3];
      if(!((std::min)(a.y(), b.y()) <= y && y <= (std::max)(a.y(), b.y())))
        continue;
      const Eigen::Vector3d d = b - a;
      if(!(std::abs(d.y()) > flat * std::abs(d.x())))
      {
        extend(a.x());
        extend(b.x());
      }
      else
        extend(a.x() + (y - a.y()) / d.y() * d.x());
    }
    return {low, high};
  }

  void add_triangle(const Triangle& p, std::size_t first_row, std::size_t end_row)
  {
    const std::size_t columns = m_size[0] * m_fineness;
    const auto [y_low, y_high] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    const auto [y_begin, y_end] = range(y_low, y_high, first_row, end_row);
    const double low = (std::min)({p[0].z(), p[1].z(), p[2].z()}),
                 high = (std::max)({p[0].z(), p[1].z(), p[2].z()});
    std::array<Point_2, 3> q;
    for(std::size_t k = 0; k < 3; ++k)
      q[k] = Point_2(p[k].x(), p[k].y());
    const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
    for(std::size_t j = y_begin; j < y_end; ++j)
    {
      const double y = (double(j) + .5) / double(m_fineness);
      const auto [x_low, x_high] = extent(p, y);
      if(!(x_low <= x_high))
        continue;
      const double column_width = 1. / double(m_fineness);
      const auto [x_begin, x_end] = range(x_low - column_width, x_high + column_width, 0, columns);
      for(std::size_t i = x_begin; i < x_end; ++i)
      {
        const double x = (double(i) + .5) / double(m_fineness);
        const Point_2 column(x, y);
        const int side = turn(q[0], q[1], column);
        if(side != turn(q[1], q[2], column) || side != turn(q[2], q[0], column))
          continue;
        double z = p[0].z() - (normal.x() * (x - p[0].x()) + normal.y() * (y - p[0].y())) / normal.z();
        z = z > low ? (std::min)(z, high) : low; // also if the normal is horizontal
        m_crossings.push_back({i + columns * j, z, side});
      }
    }
  }

  // what the columns that were crossed say
  void add_shares(bool are_binary, std::vector<float>& shares)
  {
    std::sort(m_crossings.begin(), m_crossings.end(),
              [](const Crossing& a, const Crossing& b)
              { return std::tie(a.column, a.z, a.side) < std::tie(b.column, b.z, b.side); });
    const std::size_t columns = m_size[0] * m_fineness;
    const double weight = 1. / double(m_fineness * m_fineness);
    int winding = 0;
    for(std::size_t c = 0; c + 1 < m_crossings.size(); ++c)
    {
      const Crossing &a = m_crossings[c], &b = m_crossings[c + 1];
      winding = c > 0 && m_crossings[c - 1].column == a.column ? winding + a.side : a.side;
      if(winding == 0 || a.column != b.column)
        continue;
      const std::size_t i = a.column % columns / m_fineness, j = a.column / columns / m_fineness;
      const double begin = (std::max)(a.z, 0.), end = (std::min)(b.z, double(m_size[2]));
      for(auto k = std::size_t(begin); double(k) < end; ++k)
      {
        float& share = shares[i + m_size[0] * (j + m_size[1] * k)];
        const double z = double(k);
        if(are_binary)
          share = begin <= z + .5 && z + .5 < end ? 1.f : share;
        else
          share += float(weight * ((std::min)(end, z + 1.) - (std::max)(begin, z)));
      }
    }
  }

  // On which side of the line from a to b the point is: exactly, and as if the point was moved by a little to the right and
  // much less upward, so that each point of the plane is in one of the triangles that have an edge in common.
  static int turn(const Point_2& a, const Point_2& b, const Point_2& p)
  {
    const CGAL::Orientation o = CGAL::orientation(a, b, p);
    if(o != CGAL::COLLINEAR)
      return o == CGAL::LEFT_TURN ? -1 : 1;
    if(a.y() != b.y())
      return b.y() < a.y() ? -1 : 1;
    return b.x() > a.x() ? -1 : 1;
  }

  std::array<std::size_t, 3> m_size;
  std::size_t m_fineness;
  std::vector<Crossing> m_crossings;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  makes voxels of the solid that a closed mesh bounds.

  The mesh is cut by lines in parallel with the z axis; which triangles a line meets is decided exactly, and what is inside by
  how often the mesh winds around it: components may overlap, one inside of another one that is turned inside out is a
  cavity, and a mesh that is wholly inside out is taken as it is meant. The grid has two empty voxels more on each side than
  the mesh needs.

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh. It must be closed, and all its faces must be triangles.
  \param voxel_size the length of the sides of the voxels, in the unit of the points
  \param values whether values are shares or 0 and 1. Shares are measured along 4 times 4 lines through each voxel.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{the points of the vertices}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if the mesh is not closed, a face is not a triangle, a point is not finite, or `voxel_size` is
          not positive, or so small that there would be more than \f$ 2^{31} \f$ voxels, or \f$ 2^{20} \f$ along an axis, or so
          large that their coordinates would be out of the range of numbers

  Complexity: linear in the number of voxels, of lines through triangles, and of rows of lines at triangles; 4 bytes a voxel while it
  works, 72 bytes a triangle, and some 100 MB.

  \cgalExample{curvature/voxel_curvatures.cpp}
*/
template <typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
Voxel_octree voxelize(const FaceGraph& mesh,
                      double voxel_size,
                      Voxel_values values = Voxel_values::SHARES,
                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  constexpr std::size_t columns_per_voxel = 4, margin = 2;
  constexpr double most_voxels = 2147483648.;

  if(!(voxel_size > 0. && std::isfinite(voxel_size)))
    throw std::invalid_argument("Shape_characteristics: voxelize: voxel_size must be positive");
  if(!CGAL::is_triangle_mesh(mesh))
    throw std::invalid_argument("Shape_characteristics: voxelize: all faces must be triangles");
  if(!CGAL::is_closed(mesh))
    throw std::invalid_argument("Shape_characteristics: voxelize: the mesh must be closed");
  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  std::vector<std::array<Eigen::Vector3d, 3> > triangles;
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
  for(const auto f : faces(mesh))
  {
    std::array<Eigen::Vector3d, 3> t;
    std::size_t k = 0;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
    {
      t[k] = internal::to_eigen(get(vpm, v));
      if(!t[k].allFinite())
        throw std::invalid_argument("Shape_characteristics: voxelize: a point of the mesh is not finite");
      if(triangles.empty() && k == 0)
        low = high = t[0];
      low = low.cwiseMin(t[k]);
      high = high.cwiseMax(t[k]);
      ++k;
    }
    triangles.push_back(t);
  }
  const Eigen::Vector3d origin = low.array() - double(margin) * voxel_size;
  std::array<std::size_t, 3> size = {0, 0, 0};
  if(!triangles.empty())
  {
    const Eigen::Vector3d counts = ((high - low) / voxel_size).array().ceil() + 2. * double(margin);
    if(!(counts.prod() < most_voxels) || !(counts.maxCoeff() <= 1048576.))
      throw std::invalid_argument("Shape_characteristics: voxelize: voxel_size is too small for the mesh");
    if(!origin.allFinite() || !(origin + voxel_size * counts).allFinite())
      throw std::invalid_argument(
          "Shape_characteristics: voxelize: the voxels are out of the range of numbers");
    for(int k = 0; k < 3; ++k)
      size[std::size_t(k)] = std::size_t(counts[k]);
  }
  const bool are_binary = values == Voxel_values::BINARY;
  internal::Voxel_columns columns(size, are_binary ? 1 : columns_per_voxel);
  for(std::array<Eigen::Vector3d, 3>& t : triangles)
    for(Eigen::Vector3d& p : t)
      p = (p - origin) / voxel_size;
  const std::vector<float> shares = columns.values(triangles, are_binary);
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  return Voxel_octree(size, Point_3(origin.x(), origin.y(), origin.z()), {voxel_size, voxel_size, voxel_size},
                      [&](std::size_t i, std::size_t j, std::size_t k)
                      { return shares[i + size[0] * (j + size[1] * k)]; });
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_VOXELIZE_H
