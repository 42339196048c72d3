#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_SCALAR_IMAGE_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_SCALAR_IMAGE_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Numbers on a grid of square pixels, NaN where there is none.
class Scalar_image
{
public:
  Scalar_image() = default;
  Scalar_image(int width, int height, double value = std::numeric_limits<double>::quiet_NaN())
    : m_width(width),
      m_height(height),
      m_values(std::size_t(width) * std::size_t(height), value)
  {}

  int width() const { return m_width; }
  int height() const { return m_height; }
  bool contains(int i, int j) const { return i >= 0 && j >= 0 && i < m_width && j < m_height; }
  double& operator()(int i, int j)
  {
    return m_values[std::size_t(j) * std::size_t(m_width) + std::size_t(i)];
  }
  double operator()(int i, int j) const
  {
    return m_values[std::size_t(j) * std::size_t(m_width) + std::size_t(i)];
  }
  bool has_value(int i, int j) const { return contains(i, j) && !std::isnan((*this)(i, j)); }

  // The columns and rows from `(i_begin, j_begin)` to `(i_end, j_end)`, inclusive, as far as they are there.
  Scalar_image part(int i_begin, int i_end, int j_begin, int j_end) const
  {
    i_begin = std::max(i_begin, 0);
    j_begin = std::max(j_begin, 0);
    i_end = std::min(i_end, m_width - 1);
    j_end = std::min(j_end, m_height - 1);
    Scalar_image result(std::max(i_end - i_begin + 1, 0), std::max(j_end - j_begin + 1, 0));
    for(int j = 0; j < result.height(); ++j)
      for(int i = 0; i < result.width(); ++i)
        result(i, j) = (*this)(i_begin + i, j_begin + j);
    return result;
  }

  // The image after a Gaussian of the standard deviation `sigma` (in pixels). Pixels without a value count for nothing and get
  // none.
  Scalar_image smoothed(double sigma) const
  {
    if(!(sigma > 0.) || m_values.empty())
      return *this;
    const int reach = std::max(1, int(std::ceil(3. * sigma)));
    std::vector<double> kernel(std::size_t(2 * reach) + 1);
    for(int k = -reach; k <= reach; ++k)
      kernel[std::size_t(k + reach)] = std::exp(-.5 * k * k / (sigma * sigma));

    // A column of these arrays is a row of the image. Some pixels at a time stay in registers: the last ones may be beyond its end.
    constexpr int lanes = 8;
    using Pixels = Eigen::Array<double, lanes, 1>;
    const int width = (m_width + lanes - 1) / lanes * lanes;
    const Eigen::Map<const Eigen::ArrayXXd> values(m_values.data(), m_width, m_height);
    Eigen::ArrayXXd sums(width, m_height), weights(width, m_height);
    Eigen::ArrayXd known = Eigen::ArrayXd::Zero(width + 2 * reach), is_known = known;
    for(int j = 0; j < m_height; ++j)
    {
      int first = m_width, last = -1; // that has a value
      for(int i = 0; i < m_width; ++i)
      {
        const bool is_there = !std::isnan(values(i, j));
        known[reach + i] = is_there ? values(i, j) : 0.;
        is_known[reach + i] = is_there ? 1. : 0.;
        if(is_there)
        {
          first = std::min(first, i);
          last = i;
        }
      }
      for(int i = 0; i < width; i += lanes)
      {
        Pixels sum = Pixels::Zero(), weight = sum;
        const bool is_near = i + lanes > first - reach && i <= last + reach;
        for(int k = 0; k <= 2 * reach && is_near; ++k)
        {
          sum += kernel[std::size_t(k)] * known.segment<lanes>(i + k);
          weight += kernel[std::size_t(k)] * is_known.segment<lanes>(i + k);
        }
        sums.col(j).segment<lanes>(i) = sum;
        weights.col(j).segment<lanes>(i) = weight;
      }
    }
    Scalar_image result(m_width, m_height);
    for(int j = 0; j < m_height; ++j)
      for(int i = 0; i < width; i += lanes)
      {
        bool has_values = false;
        for(int l = 0; l < lanes && i + l < m_width; ++l)
          has_values = has_values || !std::isnan(values(i + l, j));
        if(!has_values)
          continue;
        Pixels sum = Pixels::Zero(), weight = sum;
        for(int k = std::max(0, reach - j); k <= std::min(2 * reach, reach + m_height - 1 - j); ++k)
        {
          sum += kernel[std::size_t(k)] * sums.col(j + k - reach).segment<lanes>(i);
          weight += kernel[std::size_t(k)] * weights.col(j + k - reach).segment<lanes>(i);
        }
        for(int l = 0; l < lanes && i + l < m_width; ++l)
          if(!std::isnan(values(i + l, j)))
            result(i + l, j) = sum[l] / weight[l];
      }
    return result;
  }

private:
  int m_width = 0, m_height = 0;
  std::vector<double> m_values;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_SCALAR_IMAGE_H
