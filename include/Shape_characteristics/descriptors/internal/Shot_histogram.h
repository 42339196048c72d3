#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_SHOT_HISTOGRAM_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_SHOT_HISTOGRAM_H

#include <Shape_characteristics/descriptors/Shot_variant.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// the 352 bins of SHOT while they are filled
class Shot_histogram
{
public:
  static constexpr std::size_t sectors = 8, shells = 2, halves = 2, cosines = 11;
  static constexpr std::size_t size = sectors * shells * halves * cosines;

  void clear() { m_bins.fill(0.); }

  // a neighbor at `d` in the local reference frame, in units of the radius, and the cosine between its normal and the z axis
  void add(const Eigen::Vector3d& d, double cosine, Shot_variant variant)
  {
    const double distance = d.norm();
    if(!(distance > 0.))
      return;
    // In each direction, bins are at 0, 1, 2 ...
    const double azimuth = (std::atan2(d.y(), d.x()) / CGAL_PI + 1.) * (sectors / 2.) - .5; // from -.5 to 7.5
    const double inclination = std::acos((std::min)((std::max)(d.z() / distance, -1.), 1.)) / CGAL_PI;
    const std::array<Share, 4> shares = {
        Share(azimuth, sectors, true), Share(2. * distance - .5, shells, false),
        Share(1.5 - 2. * inclination, halves, false), // the upper half is 1
        Share((1. + (std::min)((std::max)(cosine, -1.), 1.)) * ((cosines - 1) / 2.), cosines, false)};
    if(variant == Shot_variant::PAPER)
      add_products(shares);
    else
      add_sums(shares, d.x() != 0. || d.y() != 0.);
  }

  // divided by their norm; false if there is nothing to be divided
  bool write(float* row) const
  {
    double sum = 0.;
    for(const double bin : m_bins)
      sum += bin * bin;
    const double norm = std::sqrt(sum);
    if(!(norm > 0.))
      return false;
    for(std::size_t k = 0; k < size; ++k)
      row[k] = float(m_bins[k] / norm);
    return true;
  }

private:
  static constexpr std::array<std::size_t, 4> s_strides = {shells * halves * cosines, halves* cosines,
                                                           cosines, 1};

  // the two bins next to a position, and how much they get: the less the farther, nothing from one bin's width on
  struct Share
  {
    std::array<std::size_t, 2> bins{};
    std::array<double, 2> weights{};

    Share(double position, std::size_t number, bool is_cyclic)
    {
      const double floor = std::floor(position);
      const double above = position - floor;
      const auto n = static_cast<std::ptrdiff_t>(number);
      for(std::ptrdiff_t k = 0; k < 2; ++k)
      {
        std::ptrdiff_t bin = static_cast<std::ptrdiff_t>(floor) + k;
        if(is_cyclic)
          bin = (bin + n) % n;
        const bool exists = bin >= 0 && bin < n; // nothing is beyond the ends
        bins[std::size_t(k)] = exists ? std::size_t(bin) : std::size_t(0);
        weights[std::size_t(k)] = exists ? (k == 0 ? 1. - above : above) : 0.;
      }
    }

    std::size_t own() const { return weights[1] > weights[0] ? 1 : 0; } // of both, the one with the position
  };

  void add_products(const std::array<Share, 4>& s)
  {
    for(std::size_t a = 0; a < 2; ++a)
      for(std::size_t r = 0; r < 2; ++r)
        for(std::size_t e = 0; e < 2; ++e)
        {
          const double weight = s[0].weights[a] * s[1].weights[r] * s[2].weights[e];
          double* const bins = m_bins.data() + s[0].bins[a] * s_strides[0] + s[1].bins[r] * s_strides[1] +
                               s[2].bins[e] * s_strides[2];
          for(std::size_t c = 0; c < 2; ++c)
            bins[s[3].bins[c]] += weight * s[3].weights[c];
        }
  }

  void add_sums(const std::array<Share, 4>& s, bool has_azimuth)
  {
    std::size_t own_bin = 0;
    for(std::size_t k = 0; k < 4; ++k)
      own_bin += s[k].bins[s[k].own()] * s_strides[k];
    for(std::size_t k = has_azimuth ? 0 : 1; k < 4; ++k)
    {
      const std::size_t own = s[k].own(), other = 1 - own;
      std::size_t bin = s[k].bins[other];
      if(k == 3 && other == 1 && bin == cosines - 1)
        bin = 0; // what a neighbor would give to the last bin from below
      m_bins[own_bin] += s[k].weights[own];
      m_bins[own_bin - s[k].bins[own] * s_strides[k] + bin * s_strides[k]] += s[k].weights[other];
    }
  }

  std::array<double, size> m_bins;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_SHOT_HISTOGRAM_H
