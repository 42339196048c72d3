#ifndef SHAPE_CHARACTERISTICS_TEST_HEAD_FEATURES_DRAWN_HEAD_H
#define SHAPE_CHARACTERISTICS_TEST_HEAD_FEATURES_DRAWN_HEAD_H

#include "analytic_surfaces.h"

#include <Shape_characteristics/head_features/Head_feature.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

// A head put together from formulas, so that all its features are known: an ellipsoid with a nose, lips, a chin, holes for eyes
// and rings for ears. The unit is its height, the origin about the tip of its nose.
namespace drawn_head {

namespace SC = Shape_characteristics;
using test_support::Triangle;
using test_support::Vector;

struct Options
{
  bool has_eyes = true, has_mouth = true, has_ears = true;
  std::function<bool(const Vector&)> is_kept = [](const Vector&)
  { return true; }; // of the faces, by their center
};

struct Arrays
{
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
};

constexpr double eye_u = .14, eye_v = .14, eye_half_width = .056, eye_half_height = .022;
constexpr double mouth_v = -.168, mouth_half_width = .108;

inline double bell(double x, double width)
{
  return std::exp(-.5 * x * x / (width * width));
}

// how far the face stands out from the ellipsoid
inline double relief(double x, double y, const Options& options)
{
  double z = 0.;
  // the nose rises from the root to the tip and falls to its base
  const double rise = y > 0. ? std::max(0., 1. - y / .2) : bell(y, .032);
  z += .13 * rise * bell(x, .028 + .02 * std::max(0., 1. - std::abs(y) / .1));
  // brows, lips, chin
  z += .03 * bell(y - .24, .04) * bell(x, .2);
  z += .02 * bell(y + .135, .016) * bell(x, .07) + .022 * bell(y + .203, .016) * bell(x, .07);
  z += .05 * bell(y + .3, .035) * bell(x, .08);
  if(options.has_mouth)
    z -= .022 * bell(y - mouth_v, .011) / (1. + std::exp((std::abs(x) - mouth_half_width) / .003));
  return z;
}

inline bool is_in_eye(const Vector& p)
{
  const double u = std::abs(p[0]) - eye_u, v = p[1] - eye_v;
  return p[2] > -.4 && std::abs(u) < eye_half_width &&
         std::abs(v) < eye_half_height * (1. - std::pow(u / eye_half_width, 2));
}

inline Arrays draw(const Options& options = Options(), unsigned int subdivisions = 6)
{
  Arrays head;
  std::vector<Vector> sphere;
  std::vector<Triangle> triangles;
  test_support::icosphere(subdivisions, sphere, triangles);
  std::vector<Vector> points;
  for(const Vector& d : sphere)
  {
    Vector p = {.33 * d[0], .141 + .5 * d[1], -.56 + .45 * d[2]};
    if(d[2] > 0.)
      p[2] += relief(p[0], p[1], options) * std::min(1., 4. * d[2]);
    points.push_back(p);
  }
  std::vector<std::size_t> index(points.size(), std::size_t(-1));
  for(const Triangle& t : triangles)
  {
    Vector center;
    for(std::size_t k = 0; k < 3; ++k)
      for(const std::size_t v : t)
        center[k] += points[v][k] / 3.;
    if((options.has_eyes && is_in_eye(center)) || !options.is_kept(center))
      continue;
    Triangle corners{};
    for(std::size_t k = 0; k < 3; ++k)
    {
      std::size_t& i = index[t[k]];
      if(i == std::size_t(-1))
      {
        i = head.points.size();
        head.points.push_back(points[t[k]]);
      }
      corners[k] = i;
    }
    head.triangles.push_back(corners);
  }

  // an ear is a ring that lies on the side of the head
  constexpr std::size_t around = 72, across = 12;
  for(const int side : {-1, 1})
  {
    if(!options.has_ears)
      break;
    const std::size_t first = head.points.size();
    for(std::size_t i = 0; i < around; ++i)
      for(std::size_t j = 0; j < across; ++j)
      {
        const double s = 2 * CGAL_PI * double(i) / around, t = 2 * CGAL_PI * double(j) / across, tube = .013;
        head.points.push_back({side * (.345 + tube * std::sin(t)),
                               .02 + (.115 + tube * std::cos(t)) * std::sin(s),
                               -.57 + (.055 + tube * std::cos(t)) * std::cos(s)});
      }
    for(std::size_t i = 0; i < around; ++i)
      for(std::size_t j = 0; j < across; ++j)
      {
        const std::size_t a = first + i * across + j, b = first + (i + 1) % around * across + j,
                          c = first + (i + 1) % around * across + (j + 1) % across,
                          d = first + i * across + (j + 1) % across;
        // outward: from a to d around the tube, from a to b along it
        if(side < 0)
        {
          head.triangles.push_back({a, b, c});
          head.triangles.push_back({a, c, d});
        }
        else
        {
          head.triangles.push_back({a, c, b});
          head.triangles.push_back({a, d, c});
        }
      }
  }
  return head;
}

// where it was drawn to be: x and y; how far off it may be
struct Truth
{
  double x, y, tolerance;
};

inline std::map<SC::Head_feature, Truth> truth()
{
  using F = SC::Head_feature;
  std::map<F, Truth> t;
  t[F::TOP] = {0., .641, .02};
  t[F::NOSE_TIP] = t[F::N2] = {0., .0, .025}; // it is pointed here, and found after a Gaussian of .02
  t[F::M1] = {-mouth_half_width, mouth_v, .015};
  t[F::M2] = {mouth_half_width, mouth_v, .015};
  t[F::M3] = {0., -.135, .015};
  t[F::M4] = {0., -.203, .015};
  t[F::CHIN] = {0., -.3, .035};
  for(const int side : {-1, 1})
  {
    const F e1 = side < 0 ? F::LEFT_E1 : F::RIGHT_E1;
    const auto next = [&](int k) { return F(int(e1) + k); };
    t[e1] = {side * (eye_u + eye_half_width), eye_v, .008};
    // of an eye without caruncle, the inner corner is found beyond the opening
    t[next(1)] = {side * (eye_u - eye_half_width), eye_v, .018};
    for(int k = 0; k < 4; ++k)
      t[next(2 + k)] = {side * (eye_u + (k % 2 == 0 ? .5 : -.3) * eye_half_width),
                        eye_v + (k < 2 ? 1 : -1) * eye_half_height * (k % 2 == 0 ? .75 : .91), .012};
  }
  return t;
}

} // namespace drawn_head

#endif // SHAPE_CHARACTERISTICS_TEST_HEAD_FEATURES_DRAWN_HEAD_H
