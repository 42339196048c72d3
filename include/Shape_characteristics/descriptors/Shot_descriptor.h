#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_SHOT_DESCRIPTOR_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_SHOT_DESCRIPTOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Shot_variant.h>
#include <Shape_characteristics/descriptors/internal/Shot_histogram.h>
#include <Shape_characteristics/descriptors/internal/neighborhood_extent.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes SHOT, the signature of histograms of orientations \cgalCite{shot}, of the samples of a surface: 352 numbers.

  A local reference frame divides the ball around the sample into 32 parts: 8 by azimuth, 2 by elevation, 2 by radius. Each
  has a histogram, of 11 bins, of the cosines between the normals in it and the z axis of the frame. A neighbor is shared
  among the bins next to it (`Shot_variant` says how), so that the descriptor is continuous while the frame is; all is divided by
  its Euclidean norm. Bin `c` of the cosines, sector `a` of the azimuth, outer (`r = 1`) or inner shell, and upper (`e = 1`) or
  lower half are component `11 (4 a + 2 r + e) + c`, the order of the Point Cloud Library.

  <b>Frame.</b> Of the neighbors' covariance around the sample, with weights that fall linearly to zero at the radius, x is the
  eigenvector of the largest eigenvalue and z that of the smallest, each with the sign that most neighbors are on the positive
  side of; if they are as many on both, the five neighbors of median distance decide, and at last, for z, the given normal.
  \f$ y = z \times x \f$. Neighbors that are off the plane that divides them by no more than rounding errors don't count (the
  library named above, and the paper, count them as positive). Where the surface leaves a direction of the frame open, because two
  eigenvalues are equal (a sphere, a regular grid) or no neighbor tells its sign, the status is `DEGENERATE`: any frame would be
  chance.

  The normals are taken as given; all of them flipped reverse the order of the bins of cosines. The radius is that of the ball
  if the surface's neighbors are those in a ball, and the distance of the farthest neighbor otherwise. The descriptor has no
  unit, and doesn't change when the surface is moved or scaled.

  At least 5 neighbors are needed; with less the status is `FEW_NEIGHBOURS`.

  \tparam SampledSurface a model of the concept `SampledSurface`

  \cgalModels{Descriptor}
*/
template <typename SampledSurface>
class Shot_descriptor
{
public:
  /// scratch memory of a thread
  class Workspace
  {
    friend class Shot_descriptor;
    typename SampledSurface::Workspace m_neighbors;
    std::vector<Eigen::Vector3d> m_offsets; // of the neighbors from the sample, in units of the radius
    internal::Shot_histogram m_histogram;
  };

  /// \param surface the surface, with normals. It is not copied, and has to live as long as the descriptor.
  /// \param variant how neighbors are shared among bins
  explicit Shot_descriptor(const SampledSurface& surface, Shot_variant variant = Shot_variant::PAPER)
    : m_surface(surface),
      m_variant(variant)
  {}

  /// 352
  std::size_t dimension() const noexcept { return internal::Shot_histogram::size; }

  /// writes the descriptor of sample `i` to `row`, or NaN if the status that is returned says that there is none.
  ///
  /// Complexity: linear in the number of neighbors.
  Estimation_status operator()(std::size_t i, Workspace& workspace, float* row) const
  {
    std::fill_n(row, dimension(), std::numeric_limits<float>::quiet_NaN());
    const Estimation_status status = m_surface.status(i);
    if(!is_estimated(status))
      return status;
    const auto& neighbors = m_surface.neighbors(i, s_minimum, workspace.m_neighbors);
    Eigen::Matrix3d frame;
    if(const Estimation_status s = find_frame(i, neighbors, workspace, frame); !is_estimated(s))
      return s;
    internal::Shot_histogram& histogram = workspace.m_histogram;
    histogram.clear();
    for(std::size_t k = 0; k < neighbors.size(); ++k)
      histogram.add(frame * workspace.m_offsets[k], frame.row(2).dot(m_surface.normal(neighbors[k])),
                    m_variant);
    return histogram.write(row) ? status : Estimation_status::DEGENERATE;
  }

  /*!
    finds the local reference frame of sample `i`: the rows of `frame` become the axes x, y and z, which are orthogonal, of unit
    length and right-handed. They are NaN if the status that is returned says that there is none.
  */
  Estimation_status local_reference_frame(std::size_t i, Workspace& workspace, Eigen::Matrix3d& frame) const
  {
    frame.setConstant(std::numeric_limits<double>::quiet_NaN());
    const Estimation_status status = m_surface.status(i);
    if(!is_estimated(status))
      return status;
    const auto& neighbors = m_surface.neighbors(i, s_minimum, workspace.m_neighbors);
    return find_frame(i, neighbors, workspace, frame);
  }

  /// writes to `result` the descriptor that the sample has on the mirrored surface, if `row` is the one that it has here: the sectors
  /// of the azimuth in reverse order
  void mirrored(const float* row, float* result) const
  {
    constexpr std::size_t sectors = internal::Shot_histogram::sectors;
    constexpr std::size_t size = internal::Shot_histogram::size / sectors;
    for(std::size_t a = 0; a < sectors; ++a)
      std::copy_n(row + a * size, size, result + (sectors - 1 - a) * size);
  }

private:
  static constexpr std::size_t s_minimum = 5; // of neighbors
  static constexpr std::size_t s_median = 5;  // of those that decide if all together don't

  // the frame, and the neighbors' offsets
  template <typename Index>
  Estimation_status find_frame(std::size_t i,
                               const std::vector<Index>& neighbors,
                               Workspace& workspace,
                               Eigen::Matrix3d& frame) const
  {
    if(neighbors.size() < s_minimum)
      return Estimation_status::FEW_NEIGHBOURS;
    const Eigen::Vector3d& p = m_surface.point(i);
    const double radius = internal::neighborhood_radius(m_surface, i, neighbors);
    std::vector<Eigen::Vector3d>& offsets = workspace.m_offsets;
    offsets.clear();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for(const auto j : neighbors)
    {
      const Eigen::Vector3d d = (m_surface.point(j) - p) / radius;
      covariance += (std::max)(1. - d.norm(), 0.) * d * d.transpose();
      offsets.push_back(d);
    }
    if(!covariance.allFinite())
      return Estimation_status::DEGENERATE;

    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    const Eigen::Vector3d& values = solver.eigenvalues();
    const double error = internal::rounding_error(p, radius) / radius;
    // how far the axes may be turned, because the eigenvalues are near to each other
    const double x_error = 4. * error * values[2] / (values[2] - values[1]),
                 z_error = 4. * error * values[2] / (values[1] - values[0]);
    if(!(x_error < 1. && z_error < 1.))
      return Estimation_status::DEGENERATE;
    const Eigen::Vector3d x_line = solver.eigenvectors().col(2), z_line = solver.eigenvectors().col(0);
    const double x_sign = majority(offsets, x_line, x_error);
    double z_sign = majority(offsets, z_line, z_error);
    if(z_sign == 0.)
      z_sign = m_surface.normal(i).dot(z_line);
    if(x_sign == 0. || z_sign == 0.)
      return Estimation_status::DEGENERATE;
    frame.row(0) = std::copysign(1., x_sign) * x_line;
    frame.row(2) = std::copysign(1., z_sign) * z_line;
    frame.row(1) = frame.row(2).cross(frame.row(0));
    return m_surface.status(i);
  }

  // positive if more points are on the positive side than on the negative, 0 if the neighbors don't say
  static double
  majority(const std::vector<Eigen::Vector3d>& offsets, const Eigen::Vector3d& axis, double error)
  {
    const auto sum_of_signs = [&](std::size_t first, std::size_t last)
    {
      double sum = 0.;
      for(; first < last; ++first)
        if(const double t = axis.dot(offsets[first]); std::abs(t) > error)
          sum += t > 0. ? 1. : -1.;
      return sum;
    };
    const double sum = sum_of_signs(0, offsets.size());
    if(sum != 0.)
      return sum;
    const std::size_t first = offsets.size() / 2 - s_median / 2; // the nearest come first
    return sum_of_signs(first, first + s_median);
  }

  const SampledSurface& m_surface;
  Shot_variant m_variant;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_SHOT_DESCRIPTOR_H
