#ifndef SHAPE_CHARACTERISTICS_TEST_DESCRIPTORS_PLAIN_PAIR_FEATURES_H
#define SHAPE_CHARACTERISTICS_TEST_DESCRIPTORS_PLAIN_PAIR_FEATURES_H

#include "oriented_cloud.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Point feature histograms as the papers define them: loops over all points, angles by the arc tangent, in extended
// precision.
namespace plain_pair_features {

using oriented_cloud::Cloud;
using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

// Values closer to the edge of a bin than that, pairs whose points are that close to being exchanged, and lines that close to
// a normal may be taken either way by who computes in single precision.
constexpr Real doubt = 3e-6L;

struct Pair
{
  bool is_defined = false;
  bool is_certain = false;
  std::array<int, 3> bin{}; // theta, alpha, phi
};

inline int bin_of(Real value, Real largest, int bins, bool& is_certain)
{
  const Real place = bins * (value + largest) / (2 * largest);
  const Real nearest = std::round(place);
  // not the ends of the range: nothing is beyond
  if(std::abs(place - nearest) < bins * doubt && nearest > 0 && nearest < bins)
    is_certain = false;
  const int bin = int(std::floor(place));
  return bin < 0 ? 0 : bin >= bins ? bins - 1 : bin;
}

// `p` is the source where nothing else decides
inline Pair features(const Vector& p, const Vector& n_p, const Vector& q, const Vector& n_q, int bins)
{
  Pair pair;
  Vector d = q - p;
  if(d.isZero(0))
    return pair.is_certain = true, pair;
  d.normalize();
  const Real a = n_p.dot(d), b = n_q.dot(d);
  pair.is_certain = std::abs(std::abs(a) - std::abs(b)) > doubt || std::abs(a + b) < doubt;
  const bool swaps = std::acos(std::min(Real(1), std::abs(a))) > std::acos(std::min(Real(1), std::abs(b)));
  if(swaps)
    d = -d;
  const Vector &u = swaps ? n_q : n_p, &n = swaps ? n_p : n_q;
  const Vector cross = d.cross(u);
  if(cross.norm() < 1e-3L && !cross.isZero(0))
    pair.is_certain = false;
  if(cross.norm() < 1e-6L)
    return pair;
  const Vector v = cross.normalized(), w = u.cross(v);
  const Real pi = std::acos(Real(-1));
  pair.is_defined = true;
  pair.bin = {bin_of(std::atan2(w.dot(n), u.dot(n)), pi, bins, pair.is_certain),
              bin_of(v.dot(n), 1, bins, pair.is_certain), bin_of(u.dot(d), 1, bins, pair.is_certain)};
  return pair;
}

inline Vector point(const Cloud& cloud, std::size_t i)
{
  return cloud.points[i].cast<Real>();
}

inline Vector normal(const Cloud& cloud, std::size_t i)
{
  return cloud.normals[i].cast<Real>().normalized();
}

// the points within `radius`, but not at the same place
inline std::vector<std::size_t> ball(const Cloud& cloud, std::size_t i, double radius)
{
  std::vector<std::size_t> result;
  for(std::size_t j = 0; j < cloud.points.size(); ++j)
    if(cloud.points[j] != cloud.points[i] && (cloud.points[j] - cloud.points[i]).norm() <= radius)
      result.push_back(j);
  return result;
}

// a histogram, and by how much each of its columns can differ because of pairs in doubt
struct Histogram
{
  std::vector<Real> values;
  Real uncertainty = 0;
};

} // namespace plain_pair_features

#endif // SHAPE_CHARACTERISTICS_TEST_DESCRIPTORS_PLAIN_PAIR_FEATURES_H
