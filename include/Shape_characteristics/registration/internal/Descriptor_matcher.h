#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_DESCRIPTOR_MATCHER_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_DESCRIPTOR_MATCHER_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/registration/internal/Descriptor_block.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <Eigen/Core>

#include <boost/align/aligned_allocator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// the squared distance of two descriptors, in double: the same bits wherever it is computed
inline double squared_distance(const float* a, const float* b, std::size_t dimension)
{
  double sum = 0.;
  for(std::size_t k = 0; k < dimension; ++k)
  {
    const double d = double(a[k]) - double(b[k]);
    sum += d * d;
  }
  return sum;
}

/*
  Nearest neighbors in both directions. Bounds of all distances come from a product of matrices in float, a block at a time;
  a distance that its bound doesn't rule out is computed again in double. The answer is that of the plain search, whatever the
  processor's vectors and the order in which the blocks are done.
*/
class Descriptor_matcher
{
public:
  struct Neighbor
  {
    double distance = std::numeric_limits<double>::infinity(); // squared
    std::uint32_t row = (std::numeric_limits<std::uint32_t>::max)();

    // of equally near ones the first
    bool is_before(const Neighbor& other) const
    {
      return distance != other.distance ? distance < other.distance : row < other.row;
    }
  };

  Descriptor_matcher(const Descriptor_matrix& source,
                     const Descriptor_matrix& target,
                     std::size_t max_panel = Descriptor_block::largest_panel)
    : m_dimension(std::size_t(source.values.cols())),
      m_implementation(Descriptor_block::best(max_panel)),
      m_source(source),
      m_target(target)
  {
    collect_rows(source, m_source_rows);
    collect_rows(target, m_target_rows);
    normalize();
  }

  // the rows that have a descriptor
  const std::vector<std::uint32_t>& source_rows() const noexcept { return m_source_rows; }
  // for each of those the nearest row of the target, and for each row of the target that has a descriptor the other way around
  const std::vector<Neighbor>& of_source() const noexcept { return m_of_source; }
  const std::vector<Neighbor>& of_target() const noexcept { return m_of_target; }
  const std::vector<std::uint32_t>& target_rows() const noexcept { return m_target_rows; }

  template <typename ConcurrencyTag>
  void run()
  {
    m_of_source.assign(m_source_rows.size(), Neighbor());
    m_of_target.assign(m_target_rows.size(), Neighbor());
    if(m_source_rows.empty() || m_target_rows.empty())
      return;
    const std::size_t blocks = (m_source_rows.size() + s_block_size - 1) / s_block_size;
    for_each_sample<ConcurrencyTag, Workspace>(
        blocks, [&](const std::size_t b, Workspace& workspace) { match_block(b, workspace); }, {}, 1);
  }

private:
  static constexpr std::size_t s_block_size = 256; // rows whose numbers stay in the cache
  static_assert(s_block_size % Descriptor_block::rows == 0, "blocks begin with a group of rows");

  using Aligned_floats =
      std::vector<float, boost::alignment::aligned_allocator<float, Descriptor_block::alignment>>;

  struct Workspace
  {
    std::vector<Neighbor> of_target;
    Aligned_floats limits;
    std::vector<float> row_limits;
    alignas(Descriptor_block::alignment) float distances[Descriptor_block::rows *
                                                         Descriptor_block::largest_panel];
  };

  static void collect_rows(const Descriptor_matrix& matrix, std::vector<std::uint32_t>& rows)
  {
    for(Eigen::Index i = 0; i < matrix.values.rows(); ++i)
      if(is_estimated(matrix.status[std::size_t(i)]) && matrix.values.row(i).allFinite())
        rows.push_back(std::uint32_t(i));
  }

  // The copies to multiply: relative to the mean of the target, as rounding grows with the norms; and of numbers up to 1, so that
  // no square is out of range.
  void normalize()
  {
    const std::size_t padded_source = padded(m_source_rows.size(), Descriptor_block::rows),
                      padded_target = padded(m_target_rows.size(), m_implementation.panel_size);
    m_a.assign(padded_source * m_dimension, 0.f);
    m_b.assign(padded_target * m_dimension, 0.f);
    // what is added to fill the last group and panel is near to nothing
    m_a_norms.assign(padded_source, std::numeric_limits<float>::infinity());
    m_b_norms.assign(padded_target, std::numeric_limits<float>::infinity());

    std::vector<double> mean(m_dimension, 0.);
    for(const std::uint32_t i : m_target_rows)
      for(std::size_t k = 0; k < m_dimension; ++k)
        mean[k] += double(row(m_target, i)[k]) / double(m_target_rows.size());
    double largest = 0.;
    const auto measure = [&](const Descriptor_matrix& matrix, const std::vector<std::uint32_t>& rows)
    {
      for(const std::uint32_t i : rows)
        for(std::size_t k = 0; k < m_dimension; ++k)
          largest = (std::max)(largest, std::abs(double(row(matrix, i)[k]) - mean[k]));
    };
    measure(m_source, m_source_rows);
    measure(m_target, m_target_rows);
    if(largest > 0.)
      m_scale = 1. / largest;

    // Bounds the error of a distance by that of the coordinates (2 roundings each), of the product (one per component), and of
    // the sums, all relative to the two squared norms; twice what it takes.
    const double exact_part = 1. - double(m_dimension + 16) * double(std::numeric_limits<float>::epsilon());
    std::vector<float> copy(m_dimension);
    const auto copy_row = [&](const Descriptor_matrix& matrix, std::uint32_t i)
    {
      double norm = 0.;
      for(std::size_t k = 0; k < m_dimension; ++k)
      {
        copy[k] = float(m_scale * (double(row(matrix, i)[k]) - mean[k]));
        norm += double(copy[k]) * double(copy[k]);
      }
      return float(exact_part * norm);
    };
    for(std::size_t i = 0; i < m_source_rows.size(); ++i)
    {
      m_a_norms[i] = copy_row(m_source, m_source_rows[i]);
      std::copy(copy.begin(), copy.end(), m_a.begin() + std::ptrdiff_t(i * m_dimension));
    }
    const std::size_t panel = m_implementation.panel_size;
    for(std::size_t j = 0; j < m_target_rows.size(); ++j)
    {
      m_b_norms[j] = copy_row(m_target, m_target_rows[j]);
      const std::size_t column = j / panel * panel * m_dimension + j % panel;
      for(std::size_t k = 0; k < m_dimension; ++k)
        m_b[column + k * panel] = copy[k];
    }
  }

  void match_block(std::size_t number, Workspace& workspace)
  {
    const std::size_t first = number * s_block_size,
                      last = (std::min)(first + s_block_size, m_source_rows.size()),
                      panel = m_implementation.panel_size;
    {
      // What other blocks have found so far rules out the more; it is no matter how much that is.
      const std::lock_guard<std::mutex> lock(m_mutex);
      workspace.of_target = m_of_target;
    }
    workspace.limits.assign(m_b_norms.size(), 0.f);
    for(std::size_t j = 0; j < m_target_rows.size(); ++j)
      // a row of this block that is as near goes before one of a later block
      workspace.limits[j] = limit(workspace.of_target[j], workspace.of_target[j].row > m_source_rows[first]);
    workspace.row_limits.assign(padded(last - first, Descriptor_block::rows), 0.f);
    for(std::size_t i = first; i < last; ++i)
      workspace.row_limits[i - first] = limit(m_of_source[i], false);

    Descriptor_block block;
    block.dimension = m_dimension;
    block.distances = workspace.distances;
    for(std::size_t j = 0; j < m_target_rows.size(); j += panel)
    {
      block.b = m_b.data() + j * m_dimension;
      block.b_norms = m_b_norms.data() + j;
      block.b_limits = workspace.limits.data() + j;
      for(std::size_t i = first; i < last; i += Descriptor_block::rows)
      {
        block.a = m_a.data() + i * m_dimension;
        block.a_norms = m_a_norms.data() + i;
        block.a_limits = workspace.row_limits.data() + (i - first);
        if(m_implementation.are_any_below(block))
          compare(i, j, first, workspace);
      }
    }

    const std::lock_guard<std::mutex> lock(m_mutex);
    for(std::size_t j = 0; j < m_target_rows.size(); ++j)
      if(workspace.of_target[j].is_before(m_of_target[j]))
        m_of_target[j] = workspace.of_target[j];
  }

  // the pairs of a group of rows and a panel that are not ruled out
  void compare(std::size_t first_i, std::size_t first_j, std::size_t first, Workspace& workspace)
  {
    const std::size_t panel = m_implementation.panel_size;
    for(std::size_t r = 0; r < Descriptor_block::rows; ++r)
    {
      float& row_limit = workspace.row_limits[first_i + r - first];
      const float* distances = workspace.distances + r * panel;
      for(std::size_t c = 0; c < panel; ++c)
      {
        float& column_limit = workspace.limits[first_j + c];
        if(!(distances[c] < (std::max)(row_limit, column_limit)))
          continue;
        const std::size_t i = first_i + r, j = first_j + c;
        const double d =
            squared_distance(row(m_source, m_source_rows[i]), row(m_target, m_target_rows[j]), m_dimension);
        if(const Neighbor n{d, m_target_rows[j]}; n.is_before(m_of_source[i]))
        {
          m_of_source[i] = n;
          row_limit = limit(n, false);
        }
        if(const Neighbor n{d, m_source_rows[i]}; n.is_before(workspace.of_target[j]))
        {
          workspace.of_target[j] = n;
          column_limit = limit(n, false);
        }
      }
    }
  }

  // What a bound has to be below for the distance to be less, or, if asked for, as much: rows and columns come in ascending
  // order, and one after the other that is as near is not before it.
  float limit(const Neighbor& neighbor, bool is_inclusive) const
  {
    if(!(neighbor.distance < std::numeric_limits<double>::infinity()))
      return (std::numeric_limits<float>::max)();
    if(neighbor.distance == 0. && !is_inclusive)
      return 0.f;
    // rounded up, by more than what squares of tiny numbers lose
    const float rounded = float(neighbor.distance * m_scale * m_scale) + (std::numeric_limits<float>::min)();
    return std::nextafter(rounded, (std::numeric_limits<float>::max)());
  }

  static std::size_t padded(std::size_t size, std::size_t multiple)
  {
    return (size + multiple - 1) / multiple * multiple;
  }
  static const float* row(const Descriptor_matrix& matrix, std::uint32_t i)
  {
    return matrix.values.data() + std::size_t(i) * std::size_t(matrix.values.cols());
  }

  std::size_t m_dimension;
  Descriptor_block::Implementation m_implementation;
  const Descriptor_matrix &m_source, &m_target;
  std::vector<std::uint32_t> m_source_rows, m_target_rows;
  std::vector<float> m_a, m_a_norms;
  Aligned_floats m_b, m_b_norms;
  double m_scale = 1.; // of the copies
  std::vector<Neighbor> m_of_source, m_of_target;
  std::mutex m_mutex;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_DESCRIPTOR_MATCHER_H
