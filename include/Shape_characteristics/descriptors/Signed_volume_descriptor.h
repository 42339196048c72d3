#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNED_VOLUME_DESCRIPTOR_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNED_VOLUME_DESCRIPTOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Signal_scaling.h>
#include <Shape_characteristics/descriptors/Signed_volume_method.h>
#include <Shape_characteristics/descriptors/internal/curvature_moment.h>
#include <Shape_characteristics/descriptors/internal/neighborhood_extent.h>
#include <Shape_characteristics/descriptors/internal/status_of_row.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the signed volumes \f$ V_s \f$ of the samples of a surface, by mean and by Gaussian curvature (thesis, section 10.1.2):
  two numbers.

  Each is \f$ n \cdot (u \times v) \f$ (10.13), where \f$ n \f$ is the normal of the sample \f$ P \f$, and \f$ u \f$ and
  \f$ v \f$ lead from \f$ P \f$ to where, in the neighborhood, the curvature is largest and where it is smallest. That is a
  squared length; free of units, it is divided by \f$ r^2 \f$, and is in [-1, 1].

  With `Signed_volume_method::EXTREMA`, these are samples, \f$ P \f$ among them: where \f$ P \f$ itself is extremal, the volume is
  0. Where several have the same curvature, to six digits of how much it varies, it is their centroid; so the volume is 0 where
  the surface is its own mirror image. With `Signed_volume_method::BINS`, they are the centroids of the parts with
  extremal mean curvature, of the 16 in which the ball is divided: 8 by azimuth, 2 by radius. The thesis doesn't say
  how its bins lie in space; here the azimuth begins where the curvature grows, \f$ \sum w (X - P)_t (f - \bar f) \f$ (see
  `Chirality_descriptor`), so that the bins turn with the surface. Parts with less than a quarter of the samples that there
  would be on average don't take part.

  Mirroring the surface changes the signs, exactly. Flipping all normals changes the sign of the one by Gaussian curvature, and
  nothing in the one by mean curvature. Where the curvature doesn't vary, the volume is 0.

  The radius is that of the ball if the surface's neighbors are those in a ball, and the distance of the farthest
  neighbor otherwise. Extremal points are fickle: of two scans of a head, the sign is the same in 60 to 80 % of the
  points.

  The status of samples with less than 3 neighbors, or less than 3 samples around that have a value, is `FEW_NEIGHBOURS`. It is
  `DEGENERATE` with all of them in a line, and where a volume with a unit is too large for a `float`, or the square of the radius
  for a `double`.

  \tparam SampledSurface a model of the concept `SampledSurface`

  \cgalModels{Descriptor}
*/
template <typename SampledSurface>
class Signed_volume_descriptor
{
public:
  /// scratch memory of a thread
  class Workspace
  {
    friend class Signed_volume_descriptor;
    typename SampledSurface::Workspace m_neighbors;
  };

  /*!
    \param surface the surface, with normals. It is not copied, and has to live as long as the descriptor.
    \param mean_curvature the mean curvature of each sample, in 1/length. Samples without a finite one don't count.
    \param Gaussian_curvature the same, of the Gaussian curvature, in 1/squared length
    \param method what spans the volumes
    \param scaling the unit of the volumes
    \throws std::invalid_argument if there are not as many values as samples
  */
  Signed_volume_descriptor(const SampledSurface& surface,
                           std::vector<double> mean_curvature,
                           std::vector<double> Gaussian_curvature,
                           Signed_volume_method method = Signed_volume_method::EXTREMA,
                           Signal_scaling scaling = Signal_scaling::UNIT_FREE)
    : m_surface(surface),
      m_curvatures{std::move(mean_curvature), std::move(Gaussian_curvature)},
      m_method(method),
      m_scaling(scaling)
  {
    for(const std::vector<double>& f : m_curvatures)
      if(f.size() != surface.size())
        throw std::invalid_argument(
            "Shape_characteristics: there must be a mean and a Gaussian curvature for each sample");
  }

  /// 2
  std::size_t dimension() const noexcept { return 2; }

  /// writes the volumes of sample `i`, by mean and by Gaussian curvature, to `row`, or NaN if the status that is returned says
  /// that there are none.
  ///
  /// Complexity: linear in the number of neighbors.
  Estimation_status operator()(std::size_t i, Workspace& workspace, float* row) const
  {
    row[0] = row[1] = std::numeric_limits<float>::quiet_NaN();
    const Estimation_status status = m_surface.status(i);
    if(!is_estimated(status))
      return status;
    const auto& neighbors = m_surface.neighbors(i, s_minimum, workspace.m_neighbors);
    if(neighbors.size() < s_minimum)
      return Estimation_status::FEW_NEIGHBOURS;
    if(internal::is_collinear(m_surface, i, neighbors))
      return Estimation_status::DEGENERATE;
    for(const std::vector<double>& f : m_curvatures)
      if(internal::number_of_values(i, neighbors, f) < s_minimum)
        return Estimation_status::FEW_NEIGHBOURS;

    const double radius = internal::neighborhood_radius(m_surface, i, neighbors);
    const double unit = m_scaling == Signal_scaling::AS_PRINTED ? radius * radius : 1.;
    for(std::size_t k = 0; k < 2; ++k)
      row[k] = float(
          unit * volume(i, neighbors, radius, m_curvatures[k], k == 0 ? 1. / radius : 1. / radius / radius));
    return internal::status_of_row(row, dimension(), status);
  }

  /// writes to `result` the volumes that the sample has on the mirrored surface, if `row` has those that it has here: the negative
  void mirrored(const float* row, float* result) const
  {
    result[0] = -row[0];
    result[1] = -row[1];
  }

private:
  static constexpr std::size_t s_minimum = 3; // of neighbors
  static constexpr std::size_t s_half_sectors = 4, s_shells = 2, s_bins = 2 * s_half_sectors * s_shells;

  static constexpr double s_tie = 1e-6; // of the range of the curvature

  // Of places with a curvature, in units of the radius, which `for_each_place` gives to a function as often as it is asked to:
  // n . (u x v), or 0 if curvatures differ by rounding errors alone.
  template <typename For_each_place>
  static double volume(const For_each_place& for_each_place, const Eigen::Vector3d& normal, double unit)
  {
    double largest = -std::numeric_limits<double>::infinity(), smallest = -largest;
    for_each_place(
        [&](const double f, const Eigen::Vector3d&)
        {
          largest = (std::max)(largest, f);
          smallest = (std::min)(smallest, f);
        });
    if(!(largest - smallest >
         internal::smallest_share * (std::max)({std::abs(largest), std::abs(smallest), unit})))
      return 0.;
    const double tie = s_tie * (largest - smallest);
    Eigen::Vector3d u = Eigen::Vector3d::Zero(), v = u;
    double number_of_largest = 0., number_of_smallest = 0.;
    for_each_place(
        [&](const double f, const Eigen::Vector3d& place)
        {
          if(f >= largest - tie)
          {
            u += place;
            number_of_largest += 1.;
          }
          else if(f <= smallest + tie)
          {
            v += place;
            number_of_smallest += 1.;
          }
        });
    return normal.dot(u.cross(v)) / (number_of_largest * number_of_smallest);
  }

  template <typename Index>
  double volume(std::size_t i,
                const std::vector<Index>& neighbors,
                double radius,
                const std::vector<double>& f,
                double unit) const
  {
    const Eigen::Vector3d &p = m_surface.point(i), &n = m_surface.normal(i);
    if(m_method == Signed_volume_method::EXTREMA)
      return volume(
          [&](const auto& visit)
          {
            if(std::isfinite(f[i]))
              visit(f[i], Eigen::Vector3d(Eigen::Vector3d::Zero()));
            for(const Index j : neighbors)
              if(std::isfinite(f[j]))
                visit(f[j], Eigen::Vector3d((m_surface.point(j) - p) / radius));
          },
          n, unit);

    const Eigen::Vector3d x = internal::tangential_moment(m_surface, i, neighbors, radius, f, unit);
    const Eigen::Vector3d y = n.cross(x);
    if(x.isZero(0.))
      return 0.;
    struct Bin
    {
      double sum = 0., count = 0.;
      Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    };
    std::array<Bin, s_bins> bins;
    double count = 0.;
    for(const Index j : neighbors)
      if(std::isfinite(f[j]))
      {
        const Eigen::Vector3d d = (m_surface.point(j) - p) / radius;
        Bin& bin = bins[bin_of(d.dot(x), d.dot(y), d.norm())];
        bin.sum += f[j];
        bin.offset += d;
        bin.count += 1.;
        count += 1.;
      }
    return volume(
        [&](const auto& visit)
        {
          for(const Bin& bin : bins)
            if(4. * double(s_bins) * bin.count >= count && bin.count > 0.)
              visit(bin.sum / bin.count, Eigen::Vector3d(bin.offset / bin.count));
        },
        n, unit);
  }

  // The bins on both sides of the x axis are mirror images of each other, and so are their numbers but for the last digit.
  static std::size_t bin_of(double x, double y, double distance)
  {
    const std::size_t sector =
        (std::min)(std::size_t(std::atan2(std::abs(y), x) / CGAL_PI * s_half_sectors), s_half_sectors - 1);
    const std::size_t shell = distance > .5 ? 1 : 0;
    return 2 * (shell * s_half_sectors + sector) + (y < 0. ? 1 : 0);
  }

  const SampledSurface& m_surface;
  std::array<std::vector<double>, 2> m_curvatures; // mean, Gaussian
  Signed_volume_method m_method;
  Signal_scaling m_scaling;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_SIGNED_VOLUME_DESCRIPTOR_H
