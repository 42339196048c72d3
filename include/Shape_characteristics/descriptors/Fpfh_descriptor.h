#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_FPFH_DESCRIPTOR_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_FPFH_DESCRIPTOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Fpfh_variant.h>
#include <Shape_characteristics/descriptors/internal/pair_features.h>
#include <Shape_characteristics/internal/scale_to_range.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  describes a sample by fast point feature histograms (FPFH) \cgalCite{rusu_fpfh}: 33 numbers, three histograms of 11 bins
  of how the normals around it are turned against each other.

  A sample and a neighbor, with the unit vector \f$ d \f$ between them, give three features. Of the two, the source is
  the one whose normal \f$ u \f$ makes the smaller angle with the line along \f$ d \f$, which leads from it to the other one, whose
  normal is \f$ n \f$. With \f$ v = d \times u / \lVert d \times u \rVert \f$ and \f$ w = u \times v \f$:

  | columns | feature | range | in the mirrored surface |
  |---------|---------|-------|-------------------------|
  | 0–10    | \f$ \theta = \arctan_2(w \cdot n,\, u \cdot n) \f$ | \f$ [-\pi, \pi] \f$ | the same |
  | 11–21   | \f$ \alpha = v \cdot n \f$ | \f$ [-1, 1] \f$ | the opposite |
  | 22–32   | \f$ \phi = u \cdot d \f$ | \f$ [-1, 1] \f$ | the same |

  The simple histograms of a sample are those of its pairs with its neighbors, in percent. The FPFH is a weighted mean of
  those of its neighbors (see `Fpfh_variant`), and so reaches twice as far as the neighborhood.

  All values are at least 0 and have no unit. They don't change when the surface is moved, turned or scaled, but for
  pairs at the very edge of a bin, which rounding may move over. Flipping all normals negates \f$ \theta \f$ and
  \f$ \phi \f$: it reverses the first and the third histogram.

  Pairs without features are left out: points that coincide, and those where \f$ d \f$ is parallel to \f$ u \f$. Samples whose points
  or normals are not finite are nobody's neighbors. The status of a sample is
  - `FEW_NEIGHBOURS` if it has less than 2 neighbors,
  - `DEGENERATE` if all its neighbors lie on one line through it, or no pair has features.

  Complexity: \f$ O(m) \f$ for each sample with \f$ m \f$ neighbors, beside the search for them. The memory is 168 bytes
  for a sample, and 4 for each of its neighbors.

  \tparam SampledSurface a model of the concept `SampledSurface`

  \cgalModels{Descriptor}
*/
template <typename SampledSurface>
class Fpfh_descriptor
{
  using Index = typename SampledSurface::Index;

public:
  /// nothing is needed
  struct Workspace
  {};

  /*!
    computes the simple histograms of all samples.

    \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
    \param surface the surface. It has to outlive the descriptor.
    \param variant how histograms are put together
    \param callback called with the advancement in `[0, 1]`, by one thread at a time; if it returns `false`, every sample
           gets the status `CANCELLED`. May be empty.
  */
  template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag>
  explicit Fpfh_descriptor(const SampledSurface& surface,
                           Fpfh_variant variant = Fpfh_variant::PCL,
                           ConcurrencyTag = ConcurrencyTag(),
                           const std::function<bool(double)>& callback = std::function<bool(double)>())
    : m_surface(surface),
      m_variant(variant)
  {
    prepare<ConcurrencyTag>(std::vector<char>(surface.size(), 1), callback);
  }

  /*!
    computes the simple histograms that the descriptors of some samples need: those of their neighbors.

    \tparam ConcurrencyTag as above
    \param surface the surface. It has to outlive the descriptor.
    \param samples the samples
    \param variant how histograms are put together
    \param callback as above
    \pre each of `samples` is less than `surface.size()`
  */
  template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag>
  Fpfh_descriptor(const SampledSurface& surface,
                  const std::vector<std::size_t>& samples,
                  Fpfh_variant variant = Fpfh_variant::PCL,
                  ConcurrencyTag = ConcurrencyTag(),
                  const std::function<bool(double)>& callback = std::function<bool(double)>())
    : m_surface(surface),
      m_variant(variant)
  {
    std::vector<char> is_described(surface.size(), 0);
    for(const std::size_t i : samples)
      is_described[i] = 1;
    prepare<ConcurrencyTag>(is_described, callback);
  }

  /// 33
  static constexpr std::size_t dimension() noexcept { return 3 * s_bins; }

  /// writes the FPFH of sample `i`, or quiet NaN if the status says that there is none.
  /// \pre `i` is among the samples that the constructor was given
  Estimation_status operator()(std::size_t i, Workspace&, float* row) const
  {
    Estimation_status status = m_status[i];
    if(is_estimated(status) && !put_together(i, row))
      status = Estimation_status::DEGENERATE;
    if(!is_estimated(status))
      std::fill_n(row, dimension(), std::numeric_limits<float>::quiet_NaN());
    return status;
  }

  /// the samples in an order in which they have much in common with those before
  const std::vector<Index>& order() const noexcept { return m_order; }

  /// writes the FPFH of the mirrored surface: that of `row` with the histogram of \f$ \alpha \f$ reversed.
  static void mirrored(const float* row, float* result)
  {
    for(std::size_t k = 0; k < dimension(); ++k)
      result[k] = row[k / s_bins == 1 ? 3 * s_bins - 1 - k : k];
  }

private:
  static constexpr std::size_t s_bins = 11;
  static constexpr std::size_t s_present =
      3 * s_bins;                             // a column that tells whether there are histograms: 1 or 0
  static constexpr std::size_t s_stride = 40; // of the processor's vectors
  static constexpr std::size_t s_minimum = 2; // of neighbors
  static constexpr std::size_t s_block = 128; // of samples that one thread takes

  // the neighbors of some samples in a row, one list after the other
  struct Lists
  {
    std::vector<Index> neighbors;
    std::array<std::uint32_t, s_block + 1> begin;
  };

  struct Preparation
  {
    typename SampledSurface::Workspace neighbors;
    internal::Relative_points points;
  };

  template <typename ConcurrencyTag>
  void prepare(const std::vector<char>& is_described, const std::function<bool(double)>& callback)
  {
    std::function<bool(double)> first_half, second_half;
    if(callback)
    {
      first_half = [&](const double advancement) { return callback(0.5 * advancement); };
      second_half = [&](const double advancement) { return callback(0.5 + 0.5 * advancement); };
    }

    const std::size_t size = m_surface.size();
    m_status.assign(size, Estimation_status::CANCELLED);
    // Samples that are close to each other one after the other: what one has read is at hand for the next.
    m_order = m_surface.traversal_order();
    m_places.resize(size);
    for(std::size_t k = 0; k < size; ++k)
      m_places[m_order[k]] = Index(k);
    m_lists.resize((size + s_block - 1) / s_block);
    bool go_on = for_each_sample<ConcurrencyTag, typename SampledSurface::Workspace>(
        m_lists.size(),
        [&](const std::size_t b, typename SampledSurface::Workspace& workspace)
        { find_neighbors(b, is_described, workspace); },
        first_half, 1);
    if(!go_on)
      return;

    std::vector<char> is_needed = is_described;
    if(std::find(is_described.begin(), is_described.end(), 0) != is_described.end())
      for(const Lists& lists : m_lists)
        for(const Index j : lists.neighbors)
          is_needed[j] = 1;
    m_histograms.resize(size * s_stride);
    go_on = for_each_sample<ConcurrencyTag, Preparation>(
        size,
        [&](const std::size_t k, Preparation& preparation)
        {
          const std::size_t i = m_order[k];
          if(is_needed[i])
            m_status[i] = count_pairs(i, is_described[i], preparation);
        },
        second_half, s_block);
    if(!go_on)
      m_status.assign(size, Estimation_status::CANCELLED);
  }

  void find_neighbors(std::size_t block,
                      const std::vector<char>& is_described,
                      typename SampledSurface::Workspace& workspace)
  {
    Lists& lists = m_lists[block];
    const std::size_t first = block * s_block, last = (std::min)(first + s_block, m_surface.size());
    lists.begin.fill(0);
    for(std::size_t k = first; k < last; ++k)
    {
      const std::size_t i = m_order[k];
      if(is_described[i] && is_estimated(m_surface.status(i)))
      {
        const std::vector<Index>& neighbors = m_surface.neighbors(i, s_minimum, workspace);
        lists.neighbors.insert(lists.neighbors.end(), neighbors.begin(), neighbors.end());
      }
      lists.begin[k - first + 1] = std::uint32_t(lists.neighbors.size());
    }
    lists.neighbors.shrink_to_fit();
  }

  // the neighbors of a sample that is described
  std::pair<const Index*, const Index*> neighbors(std::size_t i) const
  {
    const std::size_t place = m_places[i], k = place % s_block;
    const Lists& lists = m_lists[place / s_block];
    const Index* const list = lists.neighbors.data();
    return {list + lists.begin[k], list + lists.begin[k + 1]};
  }

  // the simple histograms of sample `i`
  Estimation_status count_pairs(std::size_t i, bool is_described, Preparation& preparation)
  {
    using Bins = internal::Pair_feature_bins<int(s_bins)>;
    const Estimation_status status = m_surface.status(i);
    if(!is_estimated(status))
      return status;

    std::pair<const Index*, const Index*> list;
    if(is_described)
      list = neighbors(i);
    else
    {
      const std::vector<Index>& found = m_surface.neighbors(i, s_minimum, preparation.neighbors);
      list = {found.data(), found.data() + found.size()};
    }
    internal::Relative_points& points = preparation.points;
    points.assign(m_surface, i, list.first, list.second);

    // the last of each for pairs without features
    std::array<std::uint32_t, s_bins + 1> theta{}, alpha{}, phi{};
    const Eigen::Vector3f normal = m_surface.normal(i).template cast<float>();
    const std::array<float, 6> center = {0.f, 0.f, 0.f, normal.x(), normal.y(), normal.z()};
    Bins bins;
    for(std::size_t first = 0; first < points.size(); first += Bins::lanes)
    {
      bins.compute(center, points, first, (std::numeric_limits<float>::min)());
      const std::size_t last = (std::min)(points.size() - first, Bins::lanes);
      for(std::size_t k = 0; k < last; ++k)
      {
        ++theta[std::size_t(bins.theta[k])];
        ++alpha[std::size_t(bins.alpha[k])];
        ++phi[std::size_t(bins.phi[k])];
      }
    }
    std::uint32_t pairs = std::uint32_t(points.size()) - theta[s_bins];
    if(m_variant == Fpfh_variant::OPEN3D)
    {
      pairs = std::uint32_t(points.size());
      for(auto* const histogram : {&theta, &alpha, &phi})
        (*histogram)[s_bins / 2] += (*histogram)[s_bins];
    }
    float* const row = m_histograms.data() + i * s_stride;
    if(pairs > 0)
    {
      const float percent = 100.f / float(pairs);
      for(std::size_t k = 0; k < s_bins; ++k)
      {
        row[k] = percent * float(theta[k]);
        row[s_bins + k] = percent * float(alpha[k]);
        row[2 * s_bins + k] = percent * float(phi[k]);
      }
      row[s_present] = 1.f;
    }
    if(points.size() < s_minimum)
      return Estimation_status::FEW_NEIGHBOURS;
    return pairs == 0 || points.is_collinear() ? Estimation_status::DEGENERATE : status;
  }

  // returns false where no neighbor elsewhere has histograms
  bool put_together(std::size_t i, float* result) const
  {
    const std::pair<const Index*, const Index*> list = neighbors(i);
    const Eigen::Vector3d p = m_surface.point(i);
    const auto histograms = [&](const Index j) { return m_histograms.data() + j * s_stride; };
    double nearest = std::numeric_limits<double>::infinity();
    for(const Index* j = list.first; j != list.second; ++j)
      if(histograms(*j)[s_present] > 0.f)
        if(const double distance = (m_surface.point(*j) - p).cwiseAbs().maxCoeff(); distance > 0.)
          nearest = (std::min)(nearest, distance);
    if(!std::isfinite(nearest))
      return false;
    // In a unit in which the nearest one has a weight of about 1, numbers of single precision are enough.
    const double in_range = internal::scale_to_range(nearest);
    const double unit = in_range * nearest * in_range * nearest;
    std::array<float, s_stride> sum{};
    for(const Index* j = list.first; j != list.second; ++j)
    {
      const float* const row = histograms(*j);
      const double squared_distance = (in_range * (m_surface.point(*j) - p)).squaredNorm();
      if(!(row[s_present] > 0.f && squared_distance > 0.))
        continue;
      const double square = unit / squared_distance;
      const float weight = float(m_variant == Fpfh_variant::PAPER ? std::sqrt(square) : square);
      for(std::size_t k = 0; k < s_stride; ++k)
        sum[k] += weight * row[k];
    }
    const float share = m_variant == Fpfh_variant::PAPER ? 0.5f : 1.f;
    const float own_share = m_variant == Fpfh_variant::PCL ? 0.f : share;
    const float scale = share / sum[s_present];
    const float* const own = m_histograms.data() + i * s_stride;
    for(std::size_t k = 0; k < dimension(); ++k)
      result[k] = scale * sum[k] + own_share * own[k];
    return true;
  }

  const SampledSurface& m_surface;
  Fpfh_variant m_variant;
  std::vector<Estimation_status> m_status;
  std::vector<Index> m_order;      // the samples, those that are close to each other one after the other
  std::vector<Index> m_places;     // of the samples in that order
  std::vector<Lists> m_lists;      // of the samples that are described, by block of the order
  std::vector<float> m_histograms; // simple ones, by sample: `s_stride` each
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_FPFH_DESCRIPTOR_H
