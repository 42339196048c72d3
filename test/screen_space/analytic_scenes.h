#ifndef SHAPE_CHARACTERISTICS_TEST_ANALYTIC_SCENES_H
#define SHAPE_CHARACTERISTICS_TEST_ANALYTIC_SCENES_H

#include <Shape_characteristics/screen_space/G_buffer.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace test_support {

namespace SC = Shape_characteristics;

// What a ray meets, with the true curvatures there.
struct Hit
{
  double distance; // in units of the ray's direction
  Eigen::Vector3d normal;
  double mean_curvature, Gaussian_curvature;
};

struct Sphere
{
  Eigen::Vector3d center = Eigen::Vector3d(0., 0., 0.);
  double radius = 1.;

  std::optional<Hit> operator()(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) const
  {
    const Eigen::Vector3d o = eye - center;
    const double a = direction.squaredNorm(), b = o.dot(direction), c = o.squaredNorm() - radius * radius;
    const double d = b * b - a * c;
    if(d < 0. || -b - std::sqrt(d) <= 0.)
      return std::nullopt;
    const double t = (-b - std::sqrt(d)) / a;
    return Hit{t, (o + t * direction) / radius, 1. / radius, 1. / (radius * radius)};
  }
};

struct Cylinder
{
  Eigen::Vector3d axis = Eigen::Vector3d(1., 1., .3).normalized();
  double radius = .5;

  std::optional<Hit> operator()(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) const
  {
    const auto across = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v - axis.dot(v) * axis); };
    const Eigen::Vector3d o = across(eye), r = across(direction);
    const double a = r.squaredNorm(), b = o.dot(r), c = o.squaredNorm() - radius * radius;
    const double d = b * b - a * c;
    if(d < 0. || -b - std::sqrt(d) <= 0.)
      return std::nullopt;
    const double t = (-b - std::sqrt(d)) / a;
    return Hit{t, (o + t * r) / radius, .5 / radius, 0.};
  }
};

struct Plane // through the origin
{
  Eigen::Vector3d normal = Eigen::Vector3d(0., 0., 1.);
  double offset = 0.;

  std::optional<Hit> operator()(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) const
  {
    const double slope = direction.dot(normal), t = (offset - eye.dot(normal)) / slope;
    if(!(t > 0.) || slope >= 0.)
      return std::nullopt;
    return Hit{t, normal, 0., 0.};
  }
};

struct Torus // around `axis`
{
  Eigen::Vector3d axis = Eigen::Vector3d(.3, .5, 1.).normalized();
  double major = 1., minor = .4;

  double value(const Eigen::Vector3d& p) const // distance to the torus
  {
    const double z = axis.dot(p), rho = (p - z * axis).norm();
    return std::hypot(rho - major, z) - minor;
  }

  // marches along the ray by the distance, then refines by bisection
  std::optional<Hit> operator()(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) const
  {
    const double speed = direction.norm(), far = (eye.norm() + major + minor) / speed;
    double t = (std::max)(0., eye.norm() - major - minor) / speed, before = t;
    double distance = value(eye + t * direction);
    for(int i = 0; distance > 1e-5 * minor; ++i)
    {
      if(t > far || i > 400)
        return std::nullopt;
      before = t;
      t += (std::max)(distance, 1e-5 * minor) / speed;
      distance = value(eye + t * direction);
    }
    double low = before, high = t + 1e-3 * minor / speed;
    if(value(eye + high * direction) > 0.)
      return std::nullopt; // grazed
    for(int i = 0; i < 60; ++i)
    {
      const double middle = .5 * (low + high);
      (value(eye + middle * direction) > 0. ? low : high) = middle;
    }
    const Eigen::Vector3d p = eye + low * direction;
    const double z = axis.dot(p);
    const Eigen::Vector3d radial = (p - z * axis).normalized(), n = (p - major * radial) / minor;
    const double cosine = n.dot(radial), k1 = 1. / minor, k2 = cosine / (major + minor * cosine);
    return Hit{low, n.normalized(), .5 * (k1 + k2), k1 * k2};
  }
};

// A picture with the truth.
struct Picture
{
  int width, height;
  SC::Camera camera;
  std::vector<float> depths, normals; // normals in view space
  std::vector<double> mean_curvatures, Gaussian_curvatures,
      facing;               // cosine of view and normal; 0: background
  std::vector<int> objects; // number of what is seen, -1: nothing

  Picture(int width, int height, const SC::Camera& camera)
    : width(width),
      height(height),
      camera(camera),
      depths(size(), background()),
      normals(3 * size(), 0.f),
      mean_curvatures(size()),
      Gaussian_curvatures(size()),
      facing(size(), 0.),
      objects(size(), -1)
  {}

  std::size_t size() const { return std::size_t(width) * std::size_t(height); }
  float background() const
  {
    return camera.depth_convention() == SC::Depth_convention::EYE_DISTANCE
               ? std::numeric_limits<float>::infinity()
           : camera.depth_grows() ? 1.f
                                  : 0.f;
  }
  SC::G_buffer g_buffer() const { return SC::G_buffer(width, height, depths.data(), normals.data(), camera); }

  // draws what is nearer than what is there
  template <typename Surface>
  Picture& add(const Surface& surface, int object = 0)
  {
    const Eigen::Matrix3d turn = camera.view().topLeftCorner<3, 3>();
    const auto& p = camera.projection();
    for(int y = 0; y < height; ++y)
      for(int x = 0; x < width; ++x)
      {
        const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
        const double u = 2. * (x + .5) / width - 1., v = 2. * (y + .5) / height - 1.;
        Eigen::Vector3d eye(0., 0., 0.), ray((u + p(0, 2)) / p(0, 0), (v + p(1, 2)) / p(1, 1), -1.);
        if(!camera.is_perspective())
        {
          eye = Eigen::Vector3d((u - p(0, 3)) / p(0, 0), (v - p(1, 3)) / p(1, 1), 0.);
          ray = Eigen::Vector3d(0., 0., -1.);
        }
        const Eigen::Vector3d direction = turn.transpose() * ray;
        const auto hit = surface(camera.world_point(eye), direction);
        if(!hit || (facing[i] != 0. && !(hit->distance < camera.distance(double(depths[i])))))
          continue;
        depths[i] = float(camera.depth(hit->distance)); // the ray's z is 1
        const Eigen::Vector3d n = turn * hit->normal;
        for(std::size_t k = 0; k < 3; ++k)
          normals[3 * i + k] = float(n[Eigen::Index(k)]);
        mean_curvatures[i] = hit->mean_curvature;
        Gaussian_curvatures[i] = hit->Gaussian_curvature;
        facing[i] = -n.dot(ray.normalized());
        objects[i] = object;
      }
    return *this;
  }
};

// An eye at `distance` from the origin that sees a ball of radius `extent` around it just fill the picture.
inline SC::Camera camera_at(double distance, double extent, double aspect_ratio = 1.)
{
  const double slope = extent / std::sqrt(distance * distance - extent * extent);
  return SC::Camera(SC::Camera::look_at(distance * Eigen::Vector3d(.2, -.1, 1.).normalized(),
                                        Eigen::Vector3d(0., 0., 0.), Eigen::Vector3d(.1, 1., 0.)),
                    SC::Camera::perspective(2. * std::atan(slope), aspect_ratio, .9 * (distance - extent),
                                            1.1 * (distance + extent)));
}

template <typename T>
auto map_of(std::vector<T>& values)
{
  return boost::make_iterator_property_map(values.begin(), boost::typed_identity_property_map<std::size_t>());
}

inline double quantile(std::vector<double> values, double q)
{
  if(values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto i = values.begin() + std::ptrdiff_t(q * double(values.size() - 1));
  std::nth_element(values.begin(), i, values.end());
  return *i;
}

} // namespace test_support

#endif
