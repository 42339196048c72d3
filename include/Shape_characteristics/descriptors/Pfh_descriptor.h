#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_PFH_DESCRIPTOR_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_PFH_DESCRIPTOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/internal/pair_features.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  describes a sample by its point feature histogram (PFH) \cgalCite{rusu_pfh}: 125 numbers that tell how the normals of all
  pairs around it are turned against each other.

  The features \f$ \theta, \alpha, \phi \f$ of a pair are those of `Fpfh_descriptor`. The range of each is divided into 5
  equal bins, and the pairs of the sample and its neighbors, each with each, are counted by all three together, in
  percent: column \f$ i + 5 j + 25 k \f$ is the share of the pairs with \f$ \theta \f$ in bin \f$ i \f$, \f$ \alpha \f$ in bin
  \f$ j \f$ and \f$ \phi \f$ in bin \f$ k \f$. The distance, a fourth feature of the paper, is left out, as the Point Cloud Library
  does.

  All values are at least 0, have the sum 100 and no unit. They don't change when the surface is moved, turned or scaled, but for
  pairs at the very edge of a bin, which rounding may move over.

  Pairs without features are left out: points that coincide (are closer than a millionth of the neighborhood's size),
  and those whose line is parallel to the normal of the source. Samples whose points or normals are not finite are nobody's
  neighbors. The status of a sample is
  - `FEW_NEIGHBOURS` if it has less than 2 neighbors,
  - `DEGENERATE` if all its neighbors lie on one line through it, or no pair has features.

  Complexity: \f$ O(m^2) \f$ for a sample with \f$ m \f$ neighbors. `Fpfh_descriptor`, made from it for speed, needs
  \f$ O(m) \f$.

  \tparam SampledSurface a model of the concept `SampledSurface`

  \cgalModels{Descriptor}
*/
template <typename SampledSurface>
class Pfh_descriptor
{
  using Index = typename SampledSurface::Index;

public:
  /// scratch memory, for one thread at a time
  class Workspace
  {
    friend class Pfh_descriptor;
    typename SampledSurface::Workspace m_neighbors;
    internal::Relative_points m_points;
  };

  /// \param surface the surface. It has to outlive the descriptor.
  explicit Pfh_descriptor(const SampledSurface& surface) : m_surface(surface) {}

  /// 125
  static constexpr std::size_t dimension() noexcept { return s_bins * s_bins * s_bins; }

  /// writes the PFH of sample `i`, or quiet NaN if the status says that there is none.
  Estimation_status operator()(std::size_t i, Workspace& workspace, float* row) const
  {
    const Estimation_status status = describe(i, workspace, row);
    if(!is_estimated(status))
      std::fill_n(row, dimension(), std::numeric_limits<float>::quiet_NaN());
    return status;
  }

  /// writes the PFH of the mirrored surface: that of `row` with the bins of \f$ \alpha \f$ reversed.
  static void mirrored(const float* row, float* result)
  {
    for(std::size_t phi = 0; phi < s_bins; ++phi)
      for(std::size_t alpha = 0; alpha < s_bins; ++alpha)
        for(std::size_t theta = 0; theta < s_bins; ++theta)
          *result++ = row[theta + s_bins * (s_bins - 1 - alpha) + s_bins * s_bins * phi];
  }

private:
  static constexpr std::size_t s_bins = 5;
  static constexpr std::size_t s_minimum = 2; // of neighbors
  // Squared, in units of the neighborhood's size. Of points closer than that, single precision doesn't know the direction.
  static constexpr float s_coincidence = 1e-12f;

  Estimation_status describe(std::size_t i, Workspace& workspace, float* row) const
  {
    using Bins = internal::Pair_feature_bins<int(s_bins)>;
    const Estimation_status status = m_surface.status(i);
    if(!is_estimated(status))
      return status;
    const std::vector<Index>& neighbors = m_surface.neighbors(i, s_minimum, workspace.m_neighbors);
    if(neighbors.size() < s_minimum)
      return Estimation_status::FEW_NEIGHBOURS;
    internal::Relative_points& points = workspace.m_points;
    points.assign_with_center(m_surface, i, neighbors.data(), neighbors.data() + neighbors.size());
    if(points.is_collinear())
      return Estimation_status::DEGENERATE;

    // Several histograms, as one pair after the other falls into the same bin, and would wait for the one before. Their
    // column after the last is for pairs without features.
    std::array<std::array<std::uint64_t, dimension() + 1>, s_histograms> histograms{};
    Bins bins;
    std::array<std::int32_t, Bins::lanes> column;
    for(std::size_t j = 1; j < points.size(); ++j)
    {
      const std::array<float, 6> point = points[j];
      for(std::size_t first = 0; first < j; first += Bins::lanes)
      {
        bins.compute(point, points, first, s_coincidence);
        for(std::size_t k = 0; k < Bins::lanes; ++k)
        {
          const std::int32_t of_three =
              bins.theta[k] + int(s_bins) * bins.alpha[k] + int(s_bins * s_bins) * bins.phi[k];
          column[k] = bins.theta[k] == int(s_bins) ? int(dimension()) : of_three;
        }
        const std::size_t last = (std::min)(j - first, Bins::lanes);
        for(std::size_t k = 0; k < last; ++k)
          ++histograms[k % s_histograms][std::size_t(column[k])];
      }
    }

    std::uint64_t pairs = 0;
    std::array<std::uint64_t, dimension()> histogram{};
    for(std::size_t k = 0; k < dimension(); ++k)
    {
      for(std::size_t h = 0; h < s_histograms; ++h)
        histogram[k] += histograms[h][k];
      pairs += histogram[k];
    }
    if(pairs == 0)
      return Estimation_status::DEGENERATE;
    for(std::size_t k = 0; k < dimension(); ++k)
      row[k] = float(100. * double(histogram[k]) / double(pairs));
    return status;
  }

  static constexpr std::size_t s_histograms = 4;

  const SampledSurface& m_surface;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_PFH_DESCRIPTOR_H
