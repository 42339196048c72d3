#ifndef SHAPE_CHARACTERISTICS_INTERNAL_SCALED_NEIGHBORHOOD_H
#define SHAPE_CHARACTERISTICS_INTERNAL_SCALED_NEIGHBORHOOD_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/internal/Axis_scaling.h>
#include <Shape_characteristics/internal/Rounded_distance.h>
#include <Shape_characteristics/internal/are_on_curve.h>
#include <Shape_characteristics/internal/has_no_curvature.h>
#include <Shape_characteristics/internal/status_of_few_neighbors.h>
#include <Shape_characteristics/internal/tangent_basis.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The neighborhood of a sample, moved to the sample and scaled to root mean square distance 1.
class Scaled_neighborhood
{
public:
  using Vector = Eigen::Vector3d;
  using Index = std::uint32_t;

  static constexpr std::size_t nearest =
      9; // neighbors that tell the level of noise: so few that a smooth surface
         // bends little between them

  static constexpr std::size_t desired = 5; // neighbors for which further rings are searched

  static constexpr std::size_t crowd = 48; // neighbors that aren't spread, of which all may have a part

  // Collects the neighborhood of sample `i`, of no more than `limit` neighbors, the nearest ones (if they are spread over the
  // surface, or needn't be); if there are less than `desired`, rings grow. All else is undefined if the status isn't one of an
  // estimate.
  template <typename SampledSurface>
  Estimation_status collect(const SampledSurface& surface,
                            std::size_t i,
                            typename SampledSurface::Workspace& workspace,
                            std::size_t limit = (std::numeric_limits<std::size_t>::max)(),
                            std::size_t desired = Scaled_neighborhood::desired,
                            bool should_spread = false)
  {
    const Estimation_status status = gather(surface, i, workspace, limit, desired, should_spread);
    return is_estimated(status) ? finish(status) : status;
  }

  /*
    The same, but where rings reach much farther along one axis of the tangent plane than across it, as those of triangles that are
    long and thin do, space is compressed along the axis, and `scaling` is not the identity: basis functions take all directions
    alike. The nearest neighbors are those in that space. The `seen` nearest ones (at least `limit`) tell how it is.

    Balls and nearest neighbors reach as far in all directions. Where theirs are on a line, as of a scanner, nothing evens them out;
    nor does it a crowd of which some, from near to far, were taken.
  */
  template <typename SampledSurface>
  Estimation_status collect_evenly(const SampledSurface& surface,
                                   std::size_t i,
                                   typename SampledSurface::Workspace& workspace,
                                   std::size_t limit,
                                   std::size_t desired = Scaled_neighborhood::desired,
                                   bool should_spread = false,
                                   std::size_t seen = 0)
  {
    using Kind = decltype(surface.neighborhood().kind());
    if(surface.neighborhood().kind() != Kind::RINGS)
      return collect(surface, i, workspace, limit, desired, should_spread);
    Estimation_status status = gather(surface, i, workspace, (std::max)(limit, seen), desired, should_spread);
    if(!is_estimated(status))
      return status;
    const std::size_t found = points.size() - 1;
    const bool are_spread = found <= (std::max)(limit, seen);
    const bool is_thinned_out = !are_spread && found >= (std::max)(2 * limit, crowd);
    const Axis_scaling scaling_of_found = is_thinned_out ? Axis_scaling() : find_scaling(surface);
    if(scaling_of_found.is_identity() || is_collinear())
    {
      if(limit < seen)
        status = gather(surface, i, workspace, limit, desired, should_spread);
    }
    else
    {
      scaling = scaling_of_found;
      if(found == (std::max)(limit, seen)) // there may be others that are nearer once space is compressed
      {
        gather(surface, i, workspace, (std::max)(limit, crowd), desired, false);
        scaling = find_scaling(surface);
      }
      even_out(are_spread ? limit : found);
    }
    return finish(status);
  }

  std::vector<Index> samples;  // the sample is the first
  std::vector<Vector> points;  // scaled
  std::vector<Vector> normals; // of unit length
  double scale = 0.;           // what the points were divided by
  double nearest_size = 1.;    // root mean square distance of the nearest neighbors, scaled
  double rounding_error = 0.;  // of coordinates before they were scaled, in the same unit
  Axis_scaling scaling;        // of space, before the points were scaled; of unit normals, its inverse

private:
  static constexpr std::size_t s_minimum = 3; // neighbors without which there is no answer
  // of the distance, from a quarter of the neighbors to all of them: twice on a surface, four times along a line
  static constexpr double s_least_growth = 1.3, s_largest_growth = 2.9;
  static constexpr double s_merged = 1e-3; // distance below which points are one
  // How much farther along an axis than across it points may be. Those beside a border, which are on one side of each other, or along
  // it, are uneven by themselves, most of all those of Delaunay triangulations of random points.
  static constexpr double s_uneven = 2., s_uneven_at_border = 4.;
  static constexpr double s_least_factor = 1e-3; // farther apart, points are as good as on a line

  Estimation_status finish(Estimation_status status)
  {
    merge();
    return points.size() <= s_minimum || is_collinear() ? Estimation_status::DEGENERATE : status;
  }

  // what is left to finish, and to even out
  template <typename SampledSurface>
  Estimation_status gather(const SampledSurface& surface,
                           std::size_t i,
                           typename SampledSurface::Workspace& workspace,
                           std::size_t limit,
                           std::size_t desired,
                           bool should_spread)
  {
    const Estimation_status status = surface.status(i);
    if(!is_estimated(status))
      return status;
    const auto& neighbors = surface.neighbors(i, desired, workspace);
    if(neighbors.size() < s_minimum)
      return status_of_few_neighbors(surface, i, neighbors.size());
    using Kind = decltype(surface.neighborhood().kind());
    if(has_no_curvature(surface, i, neighbors) ||
       (surface.neighborhood().kind() != Kind::RINGS && are_on_curve(surface, i, neighbors)))
      return Estimation_status::DEGENERATE;

    // the nearest ones, or some from near to far
    std::size_t number_of_neighbors = (std::min)(neighbors.size(), limit);
    const bool are_nearest =
        number_of_neighbors == neighbors.size() || !should_spread || are_spread(surface, i, neighbors, limit);
    if(!are_nearest)
      number_of_neighbors = (std::min)(neighbors.size(), (std::max)(2 * limit, crowd));
    const Vector& center = surface.point(i);
    samples.resize(number_of_neighbors + 1);
    points.resize(number_of_neighbors + 1);
    normals.resize(number_of_neighbors + 1);
    samples[0] = Index(i);
    points[0].setZero();
    normals[0] = surface.normal(i);
    double largest = 0.;
    for(std::size_t k = 0; k < number_of_neighbors; ++k)
    {
      const Index j = neighbors[are_nearest ? k : k * neighbors.size() / number_of_neighbors];
      samples[k + 1] = j;
      points[k + 1] = surface.point(j) - center;
      normals[k + 1] = surface.normal(j);
      largest = (std::max)(largest, points[k + 1].template lpNorm<Eigen::Infinity>());
    }
    if(!(largest > 0.) || !std::isfinite(largest))
      return Estimation_status::DEGENERATE;
    const double inverse = 1. / largest;
    const bool is_usual = largest > 1e-300; // else the inverse may be infinite
    double sum = 0., sum_of_nearest = 0.;
    for(std::size_t k = 1; k <= number_of_neighbors; ++k)
    {
      sum += (is_usual ? Vector(points[k] * inverse) : Vector(points[k] / largest)).squaredNorm();
      if(k == (std::min)(nearest, number_of_neighbors))
        sum_of_nearest = sum / double(k);
    }
    sum /= double(number_of_neighbors);
    scale = largest * std::sqrt(sum);
    if(!(scale >= (std::numeric_limits<double>::min)()))
      return Estimation_status::DEGENERATE;
    nearest_size = std::sqrt(sum_of_nearest / sum);
    rounding_error =
        std::numeric_limits<double>::epsilon() * (center.template lpNorm<Eigen::Infinity>() / scale);
    for(Vector& p : points)
      p *= 1. / scale;
    scaling = Axis_scaling();
    return status;
  }

  // Whether the first of the neighbors are spread over a surface, and not along a line. Those of the pole of a sphere of
  // longitudes and latitudes are all as far; those of a vertex beside it are on one circle. (Along a border, the line is the
  // border: there is nothing beyond it.)
  template <typename SampledSurface, typename Neighbors>
  static bool
  are_spread(const SampledSurface& surface, std::size_t i, const Neighbors& neighbors, std::size_t first)
  {
    if(std::any_of(neighbors.begin(), neighbors.end(),
                   [&](const Index j) { return surface.status(j) == Estimation_status::BORDER; }))
      return true;
    const Vector far = surface.point(neighbors[first - 1]) - surface.point(i);
    const Vector near = surface.point(neighbors[first / 4 - 1]) - surface.point(i);
    const double unit = far.template lpNorm<Eigen::Infinity>();
    if(!(unit > 0.) || !std::isfinite(unit))
      return true;
    const double square = (far / unit).squaredNorm() / (near / unit).squaredNorm();
    return square > s_least_growth * s_least_growth && square < s_largest_growth * s_largest_growth;
  }

  template <typename SampledSurface>
  bool has_border(const SampledSurface& surface) const
  {
    return std::any_of(samples.begin(), samples.end(),
                       [&](const Index j) { return surface.status(j) == Estimation_status::BORDER; });
  }

  // the identity if points are about as far along any axis of the tangent plane as across it
  template <typename SampledSurface>
  Axis_scaling find_scaling(const SampledSurface& surface) const
  {
    Vector t1, t2;
    tangent_basis(normals[0], t1, t2);
    double xx = 0., xy = 0., yy = 0.;
    for(const Vector& p : points)
    {
      const double x = t1.dot(p), y = t2.dot(p);
      xx += x * x;
      xy += x * y;
      yy += y * y;
    }
    const double half_sum = 0.5 * (xx + yy), half_difference = 0.5 * (xx - yy);
    const double root = std::sqrt(half_difference * half_difference + xy * xy);
    const double longest = half_sum + root, shortest = (std::max)(half_sum - root, 0.);
    double uneven = s_uneven;
    const auto is_even = [&] { return !(longest > uneven * uneven * shortest); };
    if(is_even())
      return Axis_scaling();
    if(has_border(surface))
      uneven = s_uneven_at_border;
    if(is_even())
      return Axis_scaling();
    // of two vectors along the axis, the one that isn't a difference
    const Vector axis = (half_difference > 0. ? Vector((half_difference + root) * t1 + xy * t2)
                                              : Vector(xy * t1 + (root - half_difference) * t2))
                            .normalized();
    // Where space is compressed, slopes grow; where the surface bends away along the axis, they would be steep.
    double slope = 0.;
    for(const Vector& n : normals)
    {
      const double along = axis.dot(n);
      slope += along * along;
    }
    slope = std::sqrt(slope / double(normals.size()));
    return {axis,
            (std::min)((std::max)({uneven * std::sqrt(shortest / longest), slope, s_least_factor}), 1.)};
  }

  // Compresses space as `scaling` says, and keeps the sample and the `limit` neighbors that are nearest then.
  void even_out(std::size_t limit)
  {
    const Axis_scaling inverse = scaling.inverse();
    m_places.clear();
    for(std::size_t k = 0; k < points.size(); ++k)
    {
      points[k] = scaling(points[k]);
      normals[k] = inverse(normals[k]).normalized();
      m_places.emplace_back(Rounded_distance(1.)(points[k].squaredNorm()), Index(k));
    }
    std::sort(m_places.begin() + 1, m_places.end());
    if(limit < m_places.size())
      m_places.resize(limit + 1);
    in_order(samples, m_samples);
    in_order(points, m_vectors);
    in_order(normals, m_vectors);
    double sum = 0.;
    for(const Vector& p : points)
      sum += p.squaredNorm();
    const double size = std::sqrt(sum / double(points.size() - 1));
    for(Vector& p : points)
      p /= size;
    scale *= size;
    nearest_size /= size;
    rounding_error /= size;
  }

  // those of `m_places`
  template <typename T>
  void in_order(std::vector<T>& values, std::vector<T>& scratch) const
  {
    scratch.resize(m_places.size());
    for(std::size_t k = 0; k < m_places.size(); ++k)
      scratch[k] = values[m_places[k].second];
    values.swap(scratch);
  }

  // Points closer to each other than any sampling means them to be, with different normals, would make the surface
  // between them explode. The one nearest to the sample stays. (The points come in the order of their distance to the
  // sample: only those that are about as far can be close to each other.)
  void merge()
  {
    std::size_t kept = 1;
    for(std::size_t k = 1; k < points.size(); ++k)
    {
      const double square = points[k].squaredNorm();
      const double as_far = square - 4. * s_merged * (std::max)(square, 1.);
      bool is_far = square > s_merged * s_merged;
      for(std::size_t l = kept; is_far && --l > 0 && points[l].squaredNorm() >= as_far;)
        is_far = (points[l] - points[k]).squaredNorm() > s_merged * s_merged;
      if(!is_far)
        continue;
      if(kept != k)
      {
        samples[kept] = samples[k];
        points[kept] = points[k];
        normals[kept] = normals[k];
      }
      ++kept;
    }
    samples.resize(kept);
    points.resize(kept);
    normals.resize(kept);
  }

  // whether the points (one of them the origin) lie on a line, as far as curvature is concerned
  bool is_collinear() const
  {
    const Vector& axis = points.back(); // the farthest
    const double far = 1e-12 * axis.squaredNorm() * axis.squaredNorm();
    return std::all_of(points.begin(), points.end(),
                       [&](const Vector& p) { return !(p.cross(axis).squaredNorm() > far); });
  }

  // scratch memory
  std::vector<std::pair<double, Index> > m_places; // rounded squared distances, and where they belong
  std::vector<Index> m_samples;
  std::vector<Vector> m_vectors;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_SCALED_NEIGHBORHOOD_H
