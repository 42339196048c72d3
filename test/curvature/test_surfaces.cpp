#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/curvature/Fundamental_forms.h>
#include <Shape_characteristics/curvature/height_field_curvatures.h>
#include <Shape_characteristics/curvature/implicit_surface_Gaussian_curvature.h>
#include <Shape_characteristics/curvature/implicit_surface_curvatures.h>
#include <Shape_characteristics/curvature/implicit_surface_mean_curvature.h>
#include <Shape_characteristics/curvature/parametric_surface_curvatures.h>

#include <CGAL/Simple_cartesian.h>

#include <Eigen/Dense>
#include <unsupported/Eigen/AutoDiff>

#include <array>
#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(surfaces)

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Vector_3 = Kernel::Vector_3;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

namespace {

// Derivatives by automatic differentiation, twice nested: the surfaces below are given by their equations alone.
template <int n>
using First = Eigen::AutoDiffScalar<Eigen::Matrix<double, n, 1>>;
template <int n>
using Second = Eigen::AutoDiffScalar<Eigen::Matrix<First<n>, n, 1>>;

template <int n>
std::array<Second<n>, n> variables(const std::array<double, n>& x)
{
  std::array<Second<n>, n> result;
  for(int i = 0; i < n; ++i)
  {
    First<n> inner(x[i], n, i);
    result[i].value() = inner;
    for(int j = 0; j < n; ++j)
      result[i].derivatives()[j] = First<n>(i == j ? 1. : 0., Eigen::Matrix<double, n, 1>::Zero());
  }
  return result;
}

template <int n>
double derivative(const Second<n>& f, int i)
{
  return f.derivatives()[i].value();
}
template <int n>
double derivative(const Second<n>& f, int i, int j)
{
  return f.derivatives()[i].derivatives()[j];
}

struct Implicit
{
  Vector_3 gradient;
  Eigen::Matrix3d hessian;
};

template <typename F>
Implicit implicit_at(const F& f, double x, double y, double z)
{
  const auto v = variables<3>({x, y, z});
  const Second<3> value = f(v[0], v[1], v[2]);
  Implicit result;
  result.gradient = Vector_3(derivative(value, 0), derivative(value, 1), derivative(value, 2));
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      result.hessian(i, j) = derivative(value, i, j);
  return result;
}

struct Parametric
{
  Vector_3 u, v, uu, uv, vv;

  Curvatures curvatures() const { return SC::parametric_surface_curvatures(u, v, uu, uv, vv); }
  SC::Fundamental_forms<Kernel> forms() const { return {u, v, uu, uv, vv}; }
};

template <typename X>
Parametric parametric_at(const X& x, double u, double v)
{
  const auto w = variables<2>({u, v});
  const std::array<Second<2>, 3> p = x(w[0], w[1]);
  return {Vector_3(derivative(p[0], 0), derivative(p[1], 0), derivative(p[2], 0)),
          Vector_3(derivative(p[0], 1), derivative(p[1], 1), derivative(p[2], 1)),
          Vector_3(derivative(p[0], 0, 0), derivative(p[1], 0, 0), derivative(p[2], 0, 0)),
          Vector_3(derivative(p[0], 0, 1), derivative(p[1], 0, 1), derivative(p[2], 0, 1)),
          Vector_3(derivative(p[0], 1, 1), derivative(p[1], 1, 1), derivative(p[2], 1, 1))};
}

void check(const Curvatures& c, double k_min, double k_max, double tolerance = 1e-13)
{
  const double scale = 1 + std::max(std::abs(k_min), std::abs(k_max));
  BOOST_TEST(std::abs(c.min_curvature - k_min) < tolerance * scale, c.min_curvature << " is not " << k_min);
  BOOST_TEST(std::abs(c.max_curvature - k_max) < tolerance * scale, c.max_curvature << " is not " << k_max);
  BOOST_TEST(std::abs(c.min_direction.squared_length() - 1) < 1e-14);
  BOOST_TEST(std::abs(c.max_direction.squared_length() - 1) < 1e-14);
  BOOST_TEST(std::abs(c.min_direction * c.max_direction) < 1e-14);
}

// with mean and Gaussian curvature (4.10, 4.11)
void check(const Implicit& s, double k_min, double k_max)
{
  const Curvatures c = SC::implicit_surface_curvatures(s.gradient, s.hessian);
  check(c, k_min, k_max);
  const double length = std::sqrt(s.gradient.squared_length());
  BOOST_TEST(std::abs(c.min_direction * s.gradient) < 1e-14 * length);
  BOOST_TEST(std::abs(c.max_direction * s.gradient) < 1e-14 * length);
  const double largest = std::max(std::abs(k_min), std::abs(k_max)) + 1;
  BOOST_TEST(std::abs(SC::implicit_surface_mean_curvature(s.gradient, s.hessian) - (k_min + k_max) / 2) <
             1e-13 * largest);
  BOOST_TEST(std::abs(SC::implicit_surface_Gaussian_curvature(s.gradient, s.hessian) - k_min * k_max) <
             1e-12 * largest * largest);
}

void check_nan(const Curvatures& c)
{
  BOOST_TEST(std::isnan(c.min_curvature));
  BOOST_TEST(std::isnan(c.max_curvature));
  for(int i = 0; i < 3; ++i)
  {
    BOOST_TEST(std::isnan(c.min_direction[i]));
    BOOST_TEST(std::isnan(c.max_direction[i]));
  }
}

bool parallel(const Vector_3& a, const Vector_3& b)
{
  return CGAL::cross_product(a, b).squared_length() < 1e-24 * a.squared_length() * b.squared_length();
}

} // namespace

BOOST_AUTO_TEST_CASE(implicit_spheres_are_convex_positive)
{
  const auto sphere = [](const auto& x, const auto& y, const auto& z) { return x * x + y * y + z * z; };
  for(double radius : {0.01, 1., 300.})
    for(int i = 0; i < 20; ++i)
    {
      const double u = 0.3 * i, v = 0.1 + 0.15 * i;
      check(implicit_at(sphere, radius * std::cos(u) * std::sin(v), radius * std::sin(u) * std::sin(v),
                        radius * std::cos(v)),
            1 / radius, 1 / radius);
    }
  // seen from inside
  const auto hollow = [](const auto& x, const auto& y, const auto& z) { return -(x * x + y * y + z * z); };
  check(implicit_at(hollow, 0, 2, 0), -0.5, -0.5);
}

BOOST_AUTO_TEST_CASE(implicit_cylinder_cone_plane)
{
  const auto cylinder = [](const auto& x, const auto& y, const auto& z) { return x * x + y * y + 0. * z; };
  const auto cone = [](const auto& x, const auto& y, const auto& z) { return sqrt(x * x + y * y) - z; };
  const auto plane = [](const auto& x, const auto& y, const auto& z) { return 2. * x - 3. * y + 0.5 * z; };
  for(int i = 0; i < 20; ++i)
  {
    const double a = 0.3 * i, z = 0.2 + i;
    check(implicit_at(cylinder, 3 * std::cos(a), 3 * std::sin(a), z), 0, 1. / 3);
    const Implicit c = implicit_at(cylinder, 3 * std::cos(a), 3 * std::sin(a), z);
    BOOST_TEST(
        parallel(SC::implicit_surface_curvatures(c.gradient, c.hessian).min_direction, Vector_3(0, 0, 1)));
    // half the opening angle is 45 degrees: 1 / (z tan 45 / cos 45)
    check(implicit_at(cone, z * std::cos(a), z * std::sin(a), z), 0, std::sqrt(0.5) / z);
    check(implicit_at(plane, a, z, a * z), 0, 0);
  }
}

BOOST_AUTO_TEST_CASE(implicit_torus)
{
  const double R = 3, r = 1;
  const auto quartic = [=](const Second<3>& x, const Second<3>& y, const Second<3>& z) -> Second<3>
  {
    const Second<3> s = x * x + y * y + z * z + (R * R - r * r);
    return s * s - 4 * R * R * (x * x + y * y);
  };
  for(int i = 0; i < 60; ++i)
  {
    const double u = 0.7 * i, v = 0.1 * i, d = R + r * std::cos(v);
    check(implicit_at(quartic, d * std::cos(u), d * std::sin(u), r * std::sin(v)), std::cos(v) / d, 1 / r);
  }
}

BOOST_AUTO_TEST_CASE(implicit_ellipsoid)
{
  const double a = 3, b = 2, c = 0.5;
  const auto ellipsoid = [=](const Second<3>& x, const Second<3>& y, const Second<3>& z) -> Second<3>
  { return x * x / (a * a) + y * y / (b * b) + z * z / (c * c); };
  for(int i = 0; i < 60; ++i)
  {
    const double u = 0.7 * i, v = 0.05 * (i + 0.5);
    const double x = a * std::cos(u) * std::sin(v), y = b * std::sin(u) * std::sin(v), z = c * std::cos(v);
    // textbook: K = 1 / (a b c h^2)^2, H = |x^2 + y^2 + z^2 - a^2 - b^2 - c^2| / (2 (a b c)^2 h^3)
    const double h2 = x * x / std::pow(a, 4) + y * y / std::pow(b, 4) + z * z / std::pow(c, 4);
    const double K = 1 / std::pow(a * b * c * h2, 2);
    const double H = std::abs(x * x + y * y + z * z - a * a - b * b - c * c) /
                     (2 * std::pow(a * b * c, 2) * std::pow(h2, 1.5));
    const Implicit s = implicit_at(ellipsoid, x, y, z);
    const Curvatures k = SC::implicit_surface_curvatures(s.gradient, s.hessian);
    BOOST_TEST(std::abs(k.min_curvature * k.max_curvature - K) < 1e-13 * K);
    BOOST_TEST(std::abs(k.min_curvature + k.max_curvature - 2 * H) < 1e-13 * H);
    BOOST_TEST(std::abs(SC::implicit_surface_Gaussian_curvature(s.gradient, s.hessian) - K) < 1e-12 * K);
    BOOST_TEST(std::abs(SC::implicit_surface_mean_curvature(s.gradient, s.hessian) - H) < 1e-12 * H);
  }
}

// the zero set decides, not the function
BOOST_AUTO_TEST_CASE(implicit_function_may_be_any)
{
  const double a = 3, b = 2, c = 1;
  const double x = a * 0.48, y = b * 0.6, z = c * 0.64;
  const auto f = [=](const Second<3>& x, const Second<3>& y, const Second<3>& z) -> Second<3>
  { return x * x / (a * a) + y * y / (b * b) + z * z / (c * c) - 1.; };
  const auto g = [=](const Second<3>& x, const Second<3>& y, const Second<3>& z) -> Second<3>
  {
    const Second<3> value = f(x, y, z);
    return exp(x + 0.3 * y) * (5. * value + 2. * value * value + value * value * value);
  };
  const Implicit s = implicit_at(f, x, y, z), t = implicit_at(g, x, y, z);
  const Curvatures k = SC::implicit_surface_curvatures(s.gradient, s.hessian);
  check(t, k.min_curvature, k.max_curvature);
  const Curvatures l = SC::implicit_surface_curvatures(t.gradient, t.hessian);
  BOOST_TEST(parallel(k.min_direction, l.min_direction));
  for(double scale : {1e-150, 1e150})
    check(Implicit{scale * s.gradient, scale * s.hessian}, k.min_curvature, k.max_curvature);
}

BOOST_AUTO_TEST_CASE(implicit_without_gradient)
{
  const double quiet_nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  for(const Vector_3& g : {Vector_3(0, 0, 0), Vector_3(quiet_nan, 0, 1)})
  {
    check_nan(SC::implicit_surface_curvatures(g, identity));
    BOOST_TEST(std::isnan(SC::implicit_surface_mean_curvature(g, identity)));
    BOOST_TEST(std::isnan(SC::implicit_surface_Gaussian_curvature(g, identity)));
  }
  Eigen::Matrix3d h = identity;
  h(1, 2) = std::numeric_limits<double>::infinity();
  check_nan(SC::implicit_surface_curvatures(Vector_3(1, 1, 1), h));
  BOOST_TEST(std::isnan(SC::implicit_surface_mean_curvature(Vector_3(1, 1, 1), h)));
  BOOST_TEST(std::isnan(SC::implicit_surface_Gaussian_curvature(Vector_3(1, 1, 1), h)));
}

BOOST_AUTO_TEST_CASE(parametric_torus)
{
  const double R = 3, r = 1;
  const auto torus = [=](const Second<2>& u, const Second<2>& v) -> std::array<Second<2>, 3> {
    return {(R + r * cos(v)) * cos(u), (R + r * cos(v)) * sin(u), r * sin(v)};
  };
  for(int i = 0; i < 60; ++i)
  {
    const double u = 0.7 * i, v = 0.1 * i, d = R + r * std::cos(v);
    const Parametric p = parametric_at(torus, u, v);
    check(p.curvatures(), std::cos(v) / d, 1 / r);
    BOOST_TEST(parallel(p.curvatures().max_direction, p.v));
    const auto forms = p.forms();
    BOOST_TEST(std::abs(forms.E() - d * d) < 1e-12);
    BOOST_TEST(std::abs(forms.F()) < 1e-12);
    BOOST_TEST(std::abs(forms.G() - r * r) < 1e-12);
    BOOST_TEST(std::abs(forms.L() + d * std::cos(v)) < 1e-12);
    BOOST_TEST(std::abs(forms.M()) < 1e-12);
    BOOST_TEST(std::abs(forms.N() + r) < 1e-12);
    const Vector_3 outward(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
    BOOST_TEST((forms.normal() - outward).squared_length() < 1e-26);
    BOOST_TEST(std::abs(forms.mean_curvature() - (std::cos(v) / d + 1 / r) / 2) < 1e-13);
    BOOST_TEST(std::abs(forms.Gaussian_curvature() - std::cos(v) / d / r) < 1e-13);
    // the other side
    check(SC::parametric_surface_curvatures(p.v, p.u, p.vv, p.uv, p.uu), -1 / r, -std::cos(v) / d);
  }
}

// E ... N are no orthonormal basis here: against the textbook formulas of H and K
BOOST_AUTO_TEST_CASE(parametric_surface_with_oblique_coordinates)
{
  const auto surface = [](const Second<2>& u, const Second<2>& v) -> std::array<Second<2>, 3> {
    return {u + 0.5 * v + 0.1 * u * v, v * v * 0.2 + v - 0.3 * u, sin(u * 2.) * cos(v) + 0.5 * v * v};
  };
  for(int i = 0; i < 100; ++i)
  {
    const Parametric p = parametric_at(surface, std::sin(1. * i), std::cos(3. * i));
    const auto f = p.forms();
    const double det = f.E() * f.G() - f.F() * f.F();
    const double H = -(f.E() * f.N() - 2 * f.F() * f.M() + f.G() * f.L()) / (2 * det);
    const double K = (f.L() * f.N() - f.M() * f.M()) / det;
    const double scale = 1 + H * H + std::abs(K);
    const Curvatures c = p.curvatures();
    BOOST_TEST(std::abs((c.min_curvature + c.max_curvature) / 2 - H) < 1e-12 * scale);
    BOOST_TEST(std::abs(c.min_curvature * c.max_curvature - K) < 1e-12 * scale * scale);
    BOOST_TEST(std::abs(f.mean_curvature() - H) < 1e-12 * scale);
    BOOST_TEST(std::abs(f.Gaussian_curvature() - K) < 1e-12 * scale * scale);
    // the curvature along the direction, from the second form
    const double a = c.max_direction * p.u, b = c.max_direction * p.v;
    const double du = (f.G() * a - f.F() * b) / det, dv = (f.E() * b - f.F() * a) / det;
    const double k = -(f.L() * du * du + 2 * f.M() * du * dv + f.N() * dv * dv);
    BOOST_TEST(std::abs(k - c.max_curvature) < 1e-11 * scale);
  }
}

BOOST_AUTO_TEST_CASE(minimal_surfaces)
{
  const auto catenoid = [](const Second<2>& u, const Second<2>& v) -> std::array<Second<2>, 3>
  {
    const Second<2> e = exp(v), c = (e + 1. / e) * 0.5;
    return {c * cos(u), c * sin(u), v};
  };
  const auto helicoid = [](const Second<2>& u, const Second<2>& v) -> std::array<Second<2>, 3> {
    return {v * cos(u), v * sin(u), 1. * u};
  };
  for(int i = 0; i < 30; ++i)
  {
    const double u = 0.4 * i, v = -1.5 + 0.1 * i;
    const double k = 1 / std::pow(std::cosh(v), 2);
    check(parametric_at(catenoid, u, v).curvatures(), -k, k);
    const double l = 1 / (1 + v * v);
    check(parametric_at(helicoid, u, v).curvatures(), -l, l);
  }
}

BOOST_AUTO_TEST_CASE(parametric_surface_without_tangent_plane)
{
  const Vector_3 a(1, 2, 3), b(0, 1, 0);
  check_nan(SC::parametric_surface_curvatures(a, 2 * a, b, b, b));
  check_nan(SC::parametric_surface_curvatures(a, Vector_3(0, 0, 0), b, b, b));
  // parallel up to rounding errors
  for(int i = 1; i < 50; ++i)
  {
    const Vector_3 c(0.1, 0.7, -std::sqrt(0.3));
    check_nan(SC::parametric_surface_curvatures(c, std::sin(1. * i) * c, b, b, b));
    BOOST_TEST(std::isnan(SC::Fundamental_forms<Kernel>(c, std::sin(1. * i) * c, b, b, b).normal().x()));
  }
  check_nan(SC::parametric_surface_curvatures(a, b, Vector_3(0, 0, std::nan("")), b, b));
  const SC::Fundamental_forms<Kernel> pole(a, Vector_3(0, 0, 0), b, b, b);
  BOOST_TEST(std::isnan(pole.normal().x()));
  BOOST_TEST(std::isnan(pole.L()));
  BOOST_TEST(std::isnan(pole.mean_curvature()));
  BOOST_TEST(pole.E() == 14);
}

BOOST_AUTO_TEST_CASE(parametric_surface_in_any_unit)
{
  const Vector_3 u(1, 0.2, 0), v(0.1, 1, 0.3), uu(0, 0, 1), uv(0.2, 0, 0.1), vv(0, 0, -2);
  const Curvatures k = SC::parametric_surface_curvatures(u, v, uu, uv, vv);
  for(double s : {1e-140, 1e-10, 1e10, 1e140})
  {
    // lengths times s, and the coordinate u running 1e7 times as fast
    const double t = 1e7;
    const Curvatures l =
        SC::parametric_surface_curvatures(s * t * u, s * v, s * t * t * uu, s * t * uv, s * vv);
    BOOST_TEST(std::abs(l.min_curvature * s - k.min_curvature) < 1e-13);
    BOOST_TEST(std::abs(l.max_curvature * s - k.max_curvature) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(height_fields)
{
  const auto height = [](const Second<2>& u, const Second<2>& v) -> Second<2>
  {
    return u * u * u - 3. * u * v * v + 0.4 * sin(3. * u) * v; // monkey saddle and more
  };
  for(int i = 0; i < 100; ++i)
  {
    const double u = std::sin(2. * i), v = std::cos(5. * i);
    const auto w = variables<2>({u, v});
    const Second<2> h = height(w[0], w[1]);
    const double hu = derivative(h, 0), hv = derivative(h, 1), huu = derivative(h, 0, 0),
                 huv = derivative(h, 0, 1), hvv = derivative(h, 1, 1);
    const auto up =
        SC::height_field_curvatures<Kernel>(hu, hv, huu, huv, hvv, SC::Height_field_normal::UPWARD);
    // 4.17 and 4.18 with their right-hand sides exchanged; convex positive seen from above negates the mean curvature
    const double g = 1 + hu * hu + hv * hv;
    const double K = (huu * hvv - huv * huv) / (g * g);
    const double H =
        -((1 + hv * hv) * huu - 2 * hu * hv * huv + (1 + hu * hu) * hvv) / (2 * std::pow(g, 1.5));
    BOOST_TEST(std::abs(up.min_curvature * up.max_curvature - K) < 1e-13 * (1 + std::abs(K)));
    BOOST_TEST(std::abs(up.min_curvature + up.max_curvature - 2 * H) < 1e-13 * (1 + std::abs(H)));
    BOOST_TEST(std::abs(up.min_direction * Vector_3(-hu, -hv, 1)) < 1e-14 * std::sqrt(g));

    const auto down =
        SC::height_field_curvatures<Kernel>(hu, hv, huu, huv, hvv, SC::Height_field_normal::DOWNWARD);
    BOOST_TEST(down.min_curvature == -up.max_curvature);
    BOOST_TEST(down.max_curvature == -up.min_curvature);

    const auto same =
        SC::parametric_surface_curvatures(Vector_3(1, 0, hu), Vector_3(0, 1, hv), Vector_3(0, 0, huu),
                                          Vector_3(0, 0, huv), Vector_3(0, 0, hvv));
    check(up, same.min_curvature, same.max_curvature, 1e-12);
  }
  // a dome is convex from above, the monkey saddle is flat in its middle
  check(SC::height_field_curvatures<Kernel>(0, 0, -1, 0, -2, SC::Height_field_normal::UPWARD), 1, 2);
  check(SC::height_field_curvatures<Kernel>(0, 0, 0, 0, 0, SC::Height_field_normal::UPWARD), 0, 0);
  check_nan(SC::height_field_curvatures<Kernel>(0, std::nan(""), 0, 0, 0, SC::Height_field_normal::UPWARD));
}

// where the tangents in both coordinates are almost parallel, a cylinder keeps its curvature
BOOST_AUTO_TEST_CASE(height_fields_on_steep_slopes)
{
  // the cylinder x^2 + z^2 = 1 near its side: h = sqrt(1 - x^2), in coordinates turned by 45 degrees about z
  for(double slope : {1., 1e3, 1e6})
  {
    const double x = slope / std::sqrt(1 + slope * slope), z = 1 / std::sqrt(1 + slope * slope);
    const double hx = -x / z, hxx = -1 / (z * z * z);
    const auto c = SC::height_field_curvatures<Kernel>(hx * std::sqrt(0.5), hx * std::sqrt(0.5), hxx / 2,
                                                       hxx / 2, hxx / 2, SC::Height_field_normal::UPWARD);
    // the second derivatives grow as slope^3, and with them the error that they bring in
    BOOST_TEST(std::abs(c.max_curvature - 1) < 1e-15 * slope * slope + 1e-14);
    BOOST_TEST(std::abs(c.min_curvature) < 1e-15 * slope * slope + 1e-14);
  }
}

BOOST_AUTO_TEST_SUITE_END()
