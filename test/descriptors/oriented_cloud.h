#ifndef SHAPE_CHARACTERISTICS_TEST_DESCRIPTORS_ORIENTED_CLOUD_H
#define SHAPE_CHARACTERISTICS_TEST_DESCRIPTORS_ORIENTED_CLOUD_H

#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/number_type_config.h>
#include <CGAL/property_map.h>

#include "oriented_point_maps.h"
#include "raise_to.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <boost/test/test_tools.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

// Points with normals, and what is done to them to see whether descriptors keep their promises.
namespace oriented_cloud {

namespace SC = Shape_characteristics;
using Eigen::Vector3d;

struct Cloud
{
  std::vector<Vector3d> points, normals;
};

// `count` points at random of a height field that no symmetry maps to itself, over the square [-1, 1]^2
inline Cloud wavy_cloud(std::size_t count, unsigned int seed)
{
  std::mt19937 generator(seed);
  const auto uniform = [&] { return 2. * double(generator()) / 4294967296. - 1.; };
  Cloud cloud;
  for(std::size_t i = 0; i < count; ++i)
  {
    const double x = uniform(), y = uniform();
    const double z = .3 * std::sin(2. * x + 1.) * std::cos(3. * y) + .2 * x * y * y - .15 * x * x * y;
    const double z_x = .6 * std::cos(2. * x + 1.) * std::cos(3. * y) + .2 * y * y - .3 * x * y;
    const double z_y = -.9 * std::sin(2. * x + 1.) * std::sin(3. * y) + .4 * x * y - .15 * x * x;
    cloud.points.emplace_back(x, y, z);
    cloud.normals.push_back(Vector3d(-z_x, -z_y, 1.).normalized());
  }
  return cloud;
}

// normals that are not those of the surface: features of pairs then have all values
inline Cloud rough_cloud(std::size_t count, unsigned int seed, double roughness)
{
  Cloud cloud = wavy_cloud(count, seed);
  std::mt19937 generator(seed + 1);
  const auto uniform = [&] { return 2. * double(generator()) / 4294967296. - 1.; };
  for(Vector3d& n : cloud.normals)
    n = (n + roughness * Vector3d(uniform(), uniform(), uniform())).normalized();
  return cloud;
}

// a torus of radii 1 and .4, where much is equal but for rounding
inline Cloud torus_cloud(int around_ring, int around_tube)
{
  Cloud cloud;
  for(int i = 0; i < around_ring; ++i)
    for(int j = 0; j < around_tube; ++j)
    {
      const double a = 2. * CGAL_PI * i / around_ring, b = 2. * CGAL_PI * j / around_tube;
      const Vector3d outward(std::cos(a), std::sin(a), 0.);
      cloud.normals.push_back(std::cos(b) * outward + std::sin(b) * Vector3d::UnitZ());
      cloud.points.push_back(outward + .4 * cloud.normals.back());
    }
  return cloud;
}

// in the plane x = 0, which has exact results
inline Cloud mirrored(Cloud cloud)
{
  for(std::vector<Vector3d>* v : {&cloud.points, &cloud.normals})
    for(Vector3d& w : *v)
      w.x() = -w.x();
  return cloud;
}

inline Cloud flipped(Cloud cloud)
{
  for(Vector3d& n : cloud.normals)
    n = -n;
  return cloud;
}

inline Cloud moved(Cloud cloud, double scale, const Eigen::Matrix3d& rotation, const Vector3d& shift)
{
  for(Vector3d& p : cloud.points)
    p = scale * (rotation * p) + shift;
  for(Vector3d& n : cloud.normals)
    n = rotation * n;
  return cloud;
}

inline Eigen::Matrix3d some_rotation()
{
  return Eigen::AngleAxisd(1.1, Vector3d(.3, -.5, .8).normalized()).toRotationMatrix();
}

// in another order: point `i` of the result is point `order[i]`
inline Cloud permuted(const Cloud& cloud, const std::vector<std::size_t>& order)
{
  Cloud result;
  for(const std::size_t i : order)
  {
    result.points.push_back(cloud.points[i]);
    result.normals.push_back(cloud.normals[i]);
  }
  return result;
}

inline SC::Descriptor_matrix permuted(SC::Descriptor_matrix m, const std::vector<std::size_t>& order)
{
  const SC::Descriptor_matrix original = m;
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    m.values.row(Eigen::Index(i)) = original.values.row(Eigen::Index(order[i]));
    m.status[i] = original.status[order[i]];
  }
  return m;
}

inline SC::Point_set_samples samples_of(const Cloud& cloud, const SC::Neighborhood& neighborhood)
{
  SC::Point_set_samples samples(cloud.points, CGAL::Identity_property_map<Vector3d>(), neighborhood);
  samples.set_normals(cloud.normals);
  return samples;
}

// for `test_support::oriented_point_maps()`
inline std::vector<test_support::Oriented_point> pairs_of(const Cloud& cloud)
{
  std::vector<test_support::Oriented_point> pairs;
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    const Vector3d &p = cloud.points[i], &n = cloud.normals[i];
    pairs.push_back({{p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()}});
  }
  return pairs;
}

// the largest difference of two matrices, which must have the same statuses and have values at the same places
inline double difference(const SC::Descriptor_matrix& a, const SC::Descriptor_matrix& b)
{
  if(a.status != b.status || a.values.rows() != b.values.rows() || a.values.cols() != b.values.cols())
    return std::numeric_limits<double>::infinity();
  double largest = 0.;
  for(Eigen::Index i = 0; i < a.values.size(); ++i)
  {
    const float x = a.values.data()[i], y = b.values.data()[i];
    if(std::isnan(x) != std::isnan(y))
      return std::numeric_limits<double>::infinity();
    if(!std::isnan(x))
      test_support::raise_to(largest, std::abs(double(x) - double(y)));
  }
  return largest;
}

inline bool same_bits(const SC::Descriptor_matrix& a, const SC::Descriptor_matrix& b)
{
  return a.status == b.status && a.values.rows() == b.values.rows() && a.values.cols() == b.values.cols() &&
         std::memcmp(a.values.data(), b.values.data(), sizeof(float) * std::size_t(a.values.size())) == 0;
}

// rows with a value have finite ones, the others are NaN
inline bool is_consistent(const SC::Descriptor_matrix& m)
{
  if(std::size_t(m.values.rows()) != m.status.size())
    return false;
  for(std::size_t i = 0; i < m.status.size(); ++i)
    for(const float x : m.values.row(Eigen::Index(i)))
      if(SC::is_estimated(m.status[i]) ? !std::isfinite(x) : !std::isnan(x))
        return false;
  return true;
}

inline std::size_t number_of(SC::Estimation_status status, const SC::Descriptor_matrix& m)
{
  return std::size_t(std::count(m.status.begin(), m.status.end(), status));
}

// Few points, or points on a line or at one place, have no descriptor: checks that `describe(cloud)` says so.
template <typename Describe>
void check_points_on_a_line(const Describe& describe)
{
  using S = SC::Estimation_status;
  for(const std::size_t count : {1, 2, 8})
    for(const Vector3d& direction : {Vector3d(.1, .2, .3), Vector3d(0., 0., 0.)})
    {
      Cloud line;
      for(std::size_t i = 0; i < count; ++i)
      {
        line.points.push_back(double(i * i + 1) * direction);
        line.normals.emplace_back(0., 0., 1.);
      }
      const SC::Descriptor_matrix m = describe(line);
      BOOST_TEST(is_consistent(m));
      BOOST_TEST(number_of(count < 3 || direction.isZero() ? S::FEW_NEIGHBOURS : S::DEGENERATE, m) == count);
    }
}

// Samples that aren't finite have no descriptor, and nothing to do with those of the others: checks that `describe(cloud)` says so.
template <typename Describe>
void check_samples_that_are_not_finite(const Cloud& good, const Describe& describe)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SC::Descriptor_matrix m = describe(good);
  Cloud cloud = good;
  cloud.points.insert(cloud.points.end(),
                      {Vector3d(nan, 0., 0.), Vector3d(.1, .1, .2), Vector3d(.1, .1, .2)});
  cloud.normals.insert(cloud.normals.end(),
                       {Vector3d(0., 0., 1.), Vector3d(0., 0., 0.), Vector3d(0., nan, 1.)});
  const SC::Descriptor_matrix with_bad = describe(cloud);
  BOOST_TEST(is_consistent(with_bad));
  BOOST_TEST(number_of(SC::Estimation_status::NON_FINITE_INPUT, with_bad) == 3u);
  for(std::size_t i = 0; i < good.points.size(); ++i)
    if(SC::is_estimated(m.status[i]))
      BOOST_TEST((with_bad.values.row(Eigen::Index(i)) == m.values.row(Eigen::Index(i))));
}

} // namespace oriented_cloud

#endif // SHAPE_CHARACTERISTICS_TEST_DESCRIPTORS_ORIENTED_CLOUD_H
