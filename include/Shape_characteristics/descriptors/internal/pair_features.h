#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_PAIR_FEATURES_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_PAIR_FEATURES_H

#include <Shape_characteristics/internal/scale_to_range.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Oriented points relative to a sample, coordinate by coordinate, in units of the distance of the farthest one: numbers of
// single precision then serve for any unit of length, and far from the origin.
class Relative_points
{
public:
  // as many pairs are looked at side by side: a number that the compiler knows, so that it takes the processor's vectors
  static constexpr std::size_t lanes = 16;

  // The neighbors of `center`, the nearest first. Those that follow the last one up to a multiple of `lanes` lie at the
  // center.
  template <typename SampledSurface, typename Index>
  void assign(const SampledSurface& surface, std::size_t center, const Index* first, const Index* last)
  {
    begin(std::size_t(last - first));
    add(surface, center, first, last);
  }

  // the center, then its neighbors
  template <typename SampledSurface, typename Index>
  void
  assign_with_center(const SampledSurface& surface, std::size_t center, const Index* first, const Index* last)
  {
    begin(std::size_t(last - first) + 1);
    put(Eigen::Vector3d::Zero(), surface.normal(center));
    add(surface, center, first, last);
  }

  std::size_t size() const noexcept { return m_size; }

  // coordinate `c` of the points, or of the normals for `c` from 3 to 5
  const float* coordinate(std::size_t c) const { return m_values.data() + c * m_capacity; }

  std::array<float, 6> operator[](std::size_t k) const
  {
    std::array<float, 6> result;
    for(std::size_t c = 0; c < 6; ++c)
      result[c] = m_values[c * m_capacity + k];
    return result;
  }

  // Whether all points lie on a line through the center: on a curve then, which is no piece of a surface. Digits that
  // single precision doesn't have don't tell.
  bool is_collinear() const
  {
    if(m_size == 0)
      return true;
    const float *const x = coordinate(0), *const y = coordinate(1), *const z = coordinate(2);
    const std::size_t last = m_size - 1;
    for(std::size_t k = last; k-- > 0;)
    {
      const float u = y[k] * z[last] - z[k] * y[last];
      const float v = z[k] * x[last] - x[k] * z[last];
      const float w = x[k] * y[last] - y[k] * x[last];
      if(u * u + v * v + w * w > 1e-10f * (x[k] * x[k] + y[k] * y[k] + z[k] * z[k]))
        return false;
    }
    return true;
  }

private:
  void begin(std::size_t size)
  {
    const std::size_t padded = (size + lanes - 1) / lanes * lanes;
    if(padded > m_capacity)
    {
      m_capacity = padded;
      m_values.resize(6 * m_capacity);
    }
    m_size = 0;
    for(std::size_t c = 0; c < 6; ++c)
      for(std::size_t k = size; k < padded; ++k)
        m_values[c * m_capacity + k] = 0.f;
  }

  template <typename SampledSurface, typename Index>
  void add(const SampledSurface& surface, std::size_t center, const Index* first, const Index* last)
  {
    if(first == last)
      return;
    const Eigen::Vector3d p = surface.point(center), farthest = surface.point(*(last - 1)) - p;
    const double in_range = scale_to_range(farthest.cwiseAbs().maxCoeff());
    const double size = (in_range * farthest).norm();
    const double scale = size > 0. ? 1. / size : 0.;
    for(; first != last; ++first)
      put(in_range * (surface.point(*first) - p) * scale, surface.normal(*first));
  }

  void put(const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
  {
    float* value = m_values.data() + m_size++;
    for(const double coordinate : {point.x(), point.y(), point.z(), normal.x(), normal.y(), normal.z()})
    {
      *value = float(coordinate);
      value += m_capacity;
    }
  }

  std::vector<float> m_values;
  std::size_t m_capacity = 0, m_size = 0;
};

/*
  The features of a pair of oriented points (Rusu, Blodow and Beetz, 2009, section III; there alpha, phi, theta): of the
  two, the source is the one whose normal `u` makes the smaller angle with the line to the other one; with the unit vector `d`
  to the other point, the other normal `n`, `v = d x u / |d x u|` and `w = u x v`
    theta = atan2(w . n, u . n),  alpha = v . n,  phi = u . d.
  Their ranges [-pi, pi], [-1, 1] and [-1, 1] are divided into `Bins` equal bins.

  No angle, no root, and no quotient is computed: a value is above the edge of a bin if its square, times the
  denominator's, is above. The bins lie symmetrically about 0: the middle one plus or minus the number of edges that the
  absolute value has passed.
*/
template <int Bins>
struct Pair_feature_bins
{
  static_assert(Bins % 2 == 1, "0 is in the middle of a bin");
  static constexpr std::size_t lanes = Relative_points::lanes;
  static constexpr int middle = Bins / 2;

  // by lane; all are `Bins` where there are no features: points that coincide, or a line along the normal of the source
  std::array<std::int32_t, lanes> theta, alpha, phi;

  // The pairs of `p` with the points `first, ..., first + lanes - 1` of `q`. Where both make the same angle, `p` is the source.
  // Points whose squared distance is not larger than `coincidence` coincide.
  void compute(const std::array<float, 6>& p, const Relative_points& q, std::size_t first, float coincidence)
  {
    const float px = p[0], py = p[1], pz = p[2], pu = p[3], pv = p[4], pw = p[5];
    const float *const x = q.coordinate(0) + first, *const y = q.coordinate(1) + first,
                       *const z = q.coordinate(2) + first;
    const float *const u = q.coordinate(3) + first, *const v = q.coordinate(4) + first,
                       *const w = q.coordinate(5) + first;
    const Edges edges = s_edges;
    // In loops without branches, one after the other, which compilers turn into vector instructions.
    Lane squared_distance, squared_v, cosine, sine, volume, height;
    for(std::size_t k = 0; k < lanes; ++k)
    {
      const float dx = x[k] - px, dy = y[k] - py, dz = z[k] - pz;
      const float qu = u[k], qv = v[k], qw = w[k];
      squared_distance[k] = dx * dx + dy * dy + dz * dz;
      cosine[k] = pu * qu + pv * qv + pw * qw;
      volume[k] = dx * (pv * qw - pw * qv) + dy * (pw * qu - pu * qw) + dz * (pu * qv - pv * qu);
      const float p_height = pu * dx + pv * dy + pw * dz;
      const float q_height = qu * dx + qv * dy + qw * dz;
      const bool swaps = std::abs(q_height) > std::abs(p_height);
      height[k] = swaps ? -q_height : p_height;
      const float su = swaps ? qu : pu, sv = swaps ? qv : pv, sw = swaps ? qw : pw;
      const float tu = swaps ? pu : qu, tv = swaps ? pv : qv, tw = swaps ? pw : qw;
      const float sign = swaps ? -1.f : 1.f;
      // d x u, not of unit length, and its product with u
      const float vx = sign * (dy * sw - dz * sv), vy = sign * (dz * su - dx * sw),
                  vz = sign * (dx * sv - dy * su);
      squared_v[k] = vx * vx + vy * vy + vz * vz;
      sine[k] = (sv * vz - sw * vy) * tu + (sw * vx - su * vz) * tv + (su * vy - sv * vx) * tw;
    }
    for(std::size_t k = 0; k < lanes; ++k)
    {
      const float squared_sine = sine[k] * sine[k], squared_volume = volume[k] * volume[k];
      const float squared_height = height[k] * height[k];
      const float signed_square = cosine[k] * std::abs(cosine[k]) * squared_v[k];
      float of_theta = 0.f, of_alpha = 0.f, of_phi = 0.f; // how many edges are passed
      for(std::size_t e = 0; e < std::size_t(middle); ++e)
      {
        of_theta += edges.cosine[e] * squared_sine > edges.sine[e] * signed_square ? 1.f : 0.f;
        of_alpha += squared_volume > edges.value[e] * squared_v[k] ? 1.f : 0.f;
        of_phi += squared_height > edges.value[e] * squared_distance[k] ? 1.f : 0.f;
      }
      theta[k] = middle + std::int32_t(std::copysign(of_theta, sine[k]));
      alpha[k] = middle + std::int32_t(std::copysign(of_alpha, volume[k]));
      phi[k] = middle + std::int32_t(std::copysign(of_phi, height[k]));
    }
    for(std::size_t k = 0; k < lanes; ++k)
    {
      const float smallest = s_smallest_squared_sine * squared_distance[k];
      const std::int32_t is_defined =
          std::int32_t(squared_distance[k] > coincidence) & std::int32_t(squared_v[k] > smallest);
      theta[k] = is_defined ? theta[k] : Bins;
      alpha[k] = is_defined ? alpha[k] : Bins;
      phi[k] = is_defined ? phi[k] : Bins;
    }
  }

private:
  using Lane = std::array<float, lanes>;

  // A line closer to the normal than some units in the last place has no direction across it.
  static constexpr float s_smallest_squared_sine = 1e-12f;

  // the positive edges: those of alpha and phi squared; sines and cosines of those of theta, squared with their sign
  struct Edges
  {
    std::array<float, std::size_t(middle)> value, sine, cosine;
  };
  static Edges make_edges()
  {
    Edges edges;
    for(std::size_t e = 0; e < std::size_t(middle); ++e)
    {
      const double edge = (2. * double(e) + 1.) / double(Bins);
      const double sine = std::sin(CGAL_PI * edge), cosine = std::cos(CGAL_PI * edge);
      edges.value[e] = float(edge * edge);
      edges.sine[e] = float(sine * sine);
      edges.cosine[e] = float(cosine * std::abs(cosine));
    }
    return edges;
  }
  inline static const Edges s_edges = make_edges();
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_PAIR_FEATURES_H
