#ifndef SHAPE_CHARACTERISTICS_SAMPLING_POISSON_DISC_PATTERN_H
#define SHAPE_CHARACTERISTICS_SAMPLING_POISSON_DISC_PATTERN_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {
namespace internal {

inline void check_sampling_distance(double distance)
{
  if(!(distance > 0. && distance <= 1.))
    throw std::invalid_argument("Shape_characteristics: sampling_distance must be in (0, 1]");
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsSampling

  returns points of the unit disc, none closer to another than `distance`, cut out of a square that is packed until
  no random candidate fits any more (R. Bridson, Fast Poisson Disk Sampling in Arbitrary Dimensions, 2007; thesis,
  section 8.1.3). `distance` 0.3 gives about 20 points.

  The same arguments give the same points on every platform.

  \param distance the minimal distance, in (0, 1]
  \param random_seed the seed of the random numbers. The default gives, with `distance` 0.3, a pattern as good as the
         thesis's: the estimates reproduce its tables.
  \throws std::invalid_argument if `distance` is not in (0, 1]
*/
inline std::vector<Eigen::Vector2d> poisson_disc_pattern(double distance = 0.3, std::uint64_t random_seed = 4)
{
  internal::check_sampling_distance(distance);

  // Packed in a square and then cut out: packed in the disc, points would gather along its rim.
  const double half = 1. + 2. * distance;
  constexpr int candidates = 30; // Bridson's k
  constexpr double two_pi = 6.283185307179586476925286766559;
  std::mt19937_64 engine(random_seed);
  const auto uniform = [&] { return double(engine() >> 11) * 0x1p-53; }; // the library's distributions differ
  const auto fits = [&](const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& candidate)
  {
    if(candidate.lpNorm<Eigen::Infinity>() > half)
      return false;
    for(const Eigen::Vector2d& p : points)
      if((p - candidate).squaredNorm() < distance * distance)
        return false;
    return true;
  };
  const auto in_square = [&]
  {
    const double x = uniform(), y = uniform();
    return Eigen::Vector2d(half * (2. * x - 1.), half * (2. * y - 1.));
  };

  std::vector<Eigen::Vector2d> points(1, in_square());
  std::vector<std::size_t> active(1, 0);
  while(!active.empty())
  {
    const std::size_t k = std::size_t(uniform() * double(active.size()));
    bool found = false;
    for(int attempt = 0; attempt < candidates && !found; ++attempt)
    {
      // uniform in the annulus between the distance and twice the distance
      const double radius = distance * std::sqrt(1. + 3. * uniform()), phi = two_pi * uniform();
      const Eigen::Vector2d candidate =
          points[active[k]] + radius * Eigen::Vector2d(std::cos(phi), std::sin(phi));
      found = fits(points, candidate);
      if(found)
      {
        active.push_back(points.size());
        points.push_back(candidate);
      }
    }
    if(!found)
    {
      active[k] = active.back();
      active.pop_back();
    }
  }

  // The fronts miss a hole now and then.
  constexpr int misses = 10000;
  for(int missed = 0; missed < misses; ++missed)
  {
    const Eigen::Vector2d candidate = in_square();
    if(fits(points, candidate))
    {
      points.push_back(candidate);
      missed = 0;
    }
  }

  points.erase(std::remove_if(points.begin(), points.end(),
                              [](const Eigen::Vector2d& p) { return p.squaredNorm() > 1.; }),
               points.end());
  return points;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_POISSON_DISC_PATTERN_H
