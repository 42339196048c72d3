#include "fuzzed_points.h"
#include "oriented_point_maps.h"

#include <Shape_characteristics/interpolation/Exponential_cubic.h>
#include <Shape_characteristics/interpolation/Gaussian.h>
#include <Shape_characteristics/interpolation/Hermite_rbf_interpolant.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/Pn_triangle.h>
#include <Shape_characteristics/interpolation/Png1_triangle.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/Rbf_interpolant.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;

// A function that has been found is one at its centers; if there is none, it says so. What is beyond `largest`, or less than its
// inverse, may overflow when it is derived.
constexpr double largest = 1e150;

template <typename Interpolant>
void check(const char* name, const Interpolant& f, const std::vector<Point_3>& points, bool is_zero)
{
  double size = 0.;
  for(const Point_3& p : points)
    size = (std::max)({size, std::abs(p.x() - points[0].x()), std::abs(p.y() - points[0].y()),
                       std::abs(p.z() - points[0].z())});
  for(const Point_3& p : points)
  {
    const double value = f(p);
    if(!f.is_valid())
      fuzz::require(std::isnan(value) && std::isnan(f.gradient(p).x()) && f.hessian(p).array().isNaN().all(),
                    name, "a value of nothing");
    else if(size == 0. || (size > 1. / largest && size < largest))
    {
      fuzz::require(std::isfinite(value) && fuzz::is_finite(f.gradient(p)), name, "a value isn't finite");
      fuzz::require(!is_zero || std::abs(value) <= 1e-3 * size + 1e-300, name,
                    "a center isn't on the surface");
    }
  }
}

template <typename RadialBasisFunction>
void interpolate(FuzzedDataProvider& data, const RadialBasisFunction& phi)
{
  std::vector<Point_3> points;
  std::vector<Vector_3> normals;
  for(const auto& [p, n] : fuzz::points<test_support::Oriented_point>(data))
  {
    points.push_back(p);
    normals.push_back(n);
  }
  if(data.ConsumeBool())
    check("Hermite_rbf_interpolant",
          SC::Hermite_rbf_interpolant<Kernel, RadialBasisFunction>(points, normals, phi,
                                                                   data.ConsumeIntegralInRange<int>(-1, 4)),
          points, true);
  else if(data.ConsumeBool())
    check("Rbf_interpolant", SC::Rbf_interpolant<Kernel, RadialBasisFunction>(points, normals, phi), points,
          false);
  else
  {
    std::vector<double> values;
    for(std::size_t k = 0; k < points.size(); ++k)
      if(const double value = fuzz::number(data); !(std::abs(value) > largest))
        values.push_back(value);
    check("Rbf_interpolant", SC::Rbf_interpolant<Kernel, RadialBasisFunction>(points, values, phi), points,
          false);
  }
}

void bend_triangle(FuzzedDataProvider& data)
{
  const double factor = fuzz::scale(data);
  std::array<Point_3, 3> points;
  std::array<Vector_3, 3> normals;
  for(int k = 0; k < 3; ++k)
  {
    points[k] =
        Point_3(factor * fuzz::number(data), factor * fuzz::number(data), factor * fuzz::number(data));
    normals[k] = Vector_3(fuzz::number(data), fuzz::number(data), fuzz::number(data));
  }
  const double u = data.ConsumeProbability<double>(), v = (1. - u) * data.ConsumeProbability<double>();
  const std::array<double, 3> where = {1. - u - v, u, v};
  for(const Point_3& p : points)
    if((std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) >
       1e300) // control points may be beyond
      return;
  const SC::Pn_triangle<Kernel> patch(points, normals);
  fuzz::require(fuzz::is_finite(patch.point(where)), "Pn_triangle", "a point isn't finite");
  fuzz::require(!(std::abs(patch.normal(where).squared_length() - 1.) > 1e-9), "Pn_triangle",
                "a normal without a unit");
  fuzz::require(fuzz::is_finite(SC::Png1_triangle<Kernel>(points, normals).point(where)), "Png1_triangle",
                "a point isn't finite");
}

} // namespace

// Points and normals, or values, through interpolants, and triangles through curved ones.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  FuzzedDataProvider data(bytes, size);
  try
  {
    switch(data.ConsumeIntegralInRange<int>(0, 4))
    {
    case 0:
      interpolate(data, SC::Polyharmonic<3>());
      break;
    case 1:
      interpolate(data, SC::Exponential_cubic());
      break;
    case 2:
      interpolate(data, SC::Gaussian());
      break;
    case 3:
      interpolate(data, SC::Matern_9_2());
      break;
    default:
      bend_triangle(data);
    }
  }
  catch(const std::invalid_argument&)
  {}
  return 0;
}
