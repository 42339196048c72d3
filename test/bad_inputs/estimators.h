#ifndef SHAPE_CHARACTERISTICS_TEST_BAD_INPUTS_ESTIMATORS_H
#define SHAPE_CHARACTERISTICS_TEST_BAD_INPUTS_ESTIMATORS_H

#include "raise_to.h"

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/characteristics/is_sharp.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

// All estimators as functions of one type, so that tests and fuzzers run through a list. An estimator is one line of
// estimator_list.h, for meshes and point sets at once; what makes of it a list is compiled once.
namespace bad_inputs {

namespace SC = Shape_characteristics;
using SC::Estimation_status;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

struct Oriented_point
{
  Point_3 point;
  Vector_3 normal;
};
using Point_set = std::vector<Oriented_point>;

// What an estimator says of a sample. Values of curvatures: k_min, k_max, mean, Gaussian, and both directions; of
// normals: x, y, z.
struct Estimate
{
  Estimation_status status = Estimation_status::CANCELLED;
  std::vector<double> values;
  bool products_agree = true; // false: the Gaussian curvature is measured by itself

  double k_min() const { return values[0]; }
  double k_max() const { return values[1]; }
  double mean() const { return values[2]; }
  double Gaussian() const { return values[3]; }
};

struct Results
{
  std::vector<Estimate> samples; // of a mesh: by index of the vertex
  std::size_t failures = 0;      // what was returned
};

template <typename Input>
struct Estimator
{
  std::string name;
  bool gives_curvatures = true; // or normals
  // The overload for one vertex knows all that has a say: neither a level of noise nor a mean edge length of the whole.
  bool is_local = true;
  // How much it matters, in units of the largest curvature (or of the normal), which samples have a fit of their own and
  // which are served by that of another: other input far away may change it. 0: it is always the same.
  double difference_of_fits = 0.;
  // A vertex farther than so many edges from a change doesn't see it: two rings, two more where those have too few vertices,
  // and one for the normals.
  std::size_t sight = 5;
  // It averages over a pattern, whose radius is the mean edge length of the whole, and which doesn't turn with the input.
  bool has_pattern = false;
  // It smooths as an average over a ball does whose radius is so many mean edges; 1: it doesn't.
  double resolution = 1.;
  // What it says of a vertex is a mean over an area, which has one at the tip of a cone as well.
  bool measures_areas = false;
  // There is a bound on curvature times size of the neighborhood, for every input.
  bool is_bounded = true;
  bool needs_triangles = false;
  // At an edge of the surface it may find nothing.
  bool needs_smoothness = false;
  // Flipped normals negate the curvatures to the last bit.
  bool flips_exactly = true;
  // It looks at the axes of coordinates.
  bool has_box = false;
  // largest error on the unit cylinder and sphere sampled at 0.15, irregularly, with normals of faces
  double accuracy = .01;
  // relative to the largest curvature: what last bits of coordinates become
  double reproducibility = 1e-9;
  std::function<Results(const Input&)> all;
  std::function<Estimate(typename Mesh::Vertex_index, const Mesh&)> one; // empty for point sets
};

// The list; `Input` is `Mesh` or `Point_set`.
template <typename Input>
std::vector<Estimator<Input>> estimators();

namespace internal {

// what no estimator may leave behind
constexpr double unwritten = 8.765432e300;

} // namespace internal

// Bits ----------------------------------------------------------------------------------------------------

// all NaN alike, and both zeros
inline bool same(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

inline bool same(const Estimate& a, const Estimate& b)
{
  if(a.status != b.status || a.values.size() != b.values.size())
    return false;
  for(std::size_t i = 0; i < a.values.size(); ++i)
    if(!same(a.values[i], b.values[i]))
      return false;
  return true;
}

// the same to the last bit, or to what other fits make of it
template <typename Input>
bool same_but_for_fits(const Estimator<Input>& estimator, const Estimate& a, const Estimate& b)
{
  if(estimator.difference_of_fits == 0. || !SC::is_estimated(a.status) || a.values.size() != b.values.size())
    return same(a, b);
  if(a.status != b.status)
    return false;
  const std::size_t numbers = estimator.gives_curvatures ? 2 : 3;
  const double unit = estimator.gives_curvatures ? std::max(std::abs(a.k_min()), std::abs(a.k_max())) : 0.;
  for(std::size_t i = 0; i < numbers; ++i)
    if(!(std::abs(a.values[i] - b.values[i]) <= estimator.difference_of_fits * std::max(unit, 1.)))
      return false;
  return true;
}

// Sizes ---------------------------------------------------------------------------------------------------

inline double largest(const Estimate& e)
{
  return std::max(std::abs(e.k_min()), std::abs(e.k_max()));
}

// of those that were estimated
inline double largest(const Results& results)
{
  double size = 0.;
  for(const Estimate& e : results.samples)
    size = std::max(size, SC::is_estimated(e.status) ? largest(e) : 0.);
  return size;
}

// whether an estimate says that the surface is sharp for samples that are `spacing` apart
template <typename Input>
bool is_sharp(const Estimator<Input>& estimator, const Estimate& e, double spacing)
{
  SC::Principal_curvatures_and_directions<Kernel> curvatures;
  curvatures.min_curvature = e.k_min();
  curvatures.max_curvature = e.k_max();
  return SC::is_sharp(curvatures, estimator.resolution * spacing);
}

// What holds for every input -------------------------------------------------------------------------------

// returns what is wrong with an answer; empty if nothing is
inline std::string complaint(const Estimate& e)
{
  if(e.status == Estimation_status::CANCELLED)
    return "there is no status";
  for(std::size_t i = 0; i < e.values.size(); ++i)
  {
    const double value = e.values[i];
    const bool overflows = i == 3 && std::isinf(e.k_min() * e.k_max()) && std::isfinite(e.k_min()) &&
                           std::isfinite(e.k_max()); // a product of curvatures beyond 1e154
    if(value == internal::unwritten)
      return "a value wasn't written";
    if(SC::is_estimated(e.status) && !std::isfinite(value) && !overflows)
      return std::string("a value isn't finite, but the status is ") + SC::to_string(e.status);
    if(!SC::is_estimated(e.status) && !std::isnan(value))
      return std::string("a value isn't NaN, but the status is ") + SC::to_string(e.status);
  }
  if(!SC::is_estimated(e.status))
    return "";

  const auto dot = [&](const std::size_t i, const std::size_t j) {
    return e.values[i] * e.values[j] + e.values[i + 1] * e.values[j + 1] + e.values[i + 2] * e.values[j + 2];
  };
  if(e.values.size() == 3)
    return std::abs(dot(0, 0) - 1.) < 1e-12 ? "" : "the normal isn't of unit length";
  if(!(e.k_min() <= e.k_max()))
    return "the curvatures aren't ordered";
  if(!same(e.mean(), e.k_min() / 2. + e.k_max() / 2.) ||
     (e.products_agree && !same(e.Gaussian(), e.k_min() * e.k_max())))
    return "the mean or the Gaussian curvature isn't that of the principal ones";
  if(std::abs(dot(4, 4) - 1.) > 1e-12 || std::abs(dot(7, 7) - 1.) > 1e-12)
    return "a direction isn't of unit length";
  if(std::abs(dot(4, 7)) > 1e-12)
    return "the directions aren't orthogonal";
  return "";
}

template <typename Input>
std::string complaint(const Results& results, const Input& input)
{
  std::size_t failures = 0;
  const auto check = [&](const std::size_t i)
  {
    failures += !SC::is_estimated(results.samples[i].status);
    const std::string what = complaint(results.samples[i]);
    return what.empty() ? what : "sample " + std::to_string(i) + ": " + what;
  };
  if constexpr(std::is_same_v<Input, Mesh>)
  {
    for(const auto v : input.vertices())
      if(const std::string what = check(std::size_t(v)); !what.empty())
        return what;
  }
  else
    for(std::size_t i = 0; i < input.size(); ++i)
      if(const std::string what = check(i); !what.empty())
        return what;
  return failures == results.failures ? ""
                                      : std::to_string(results.failures) + " failures were returned, but " +
                                            std::to_string(failures) + " were announced";
}

// what is wrong with the curvatures of the input times `scale`: they must be those of the input, divided by it
template <typename Input>
std::string complaint_of_scaled(const Estimator<Input>& estimator,
                                const Results& original,
                                const Results& scaled,
                                double scale)
{
  const double size = largest(original), tolerance = estimator.reproducibility * size;
  for(std::size_t i = 0; i < original.samples.size(); ++i)
  {
    const Estimate &a = original.samples[i], &b = scaled.samples[i];
    const std::string sample = "sample " + std::to_string(i) + ": ";
    if(a.status != b.status)
      return sample + "another status";
    if(!SC::is_estimated(a.status))
      continue;
    if(!(std::abs(b.k_min() * scale - a.k_min()) <= tolerance) ||
       !(std::abs(b.k_max() * scale - a.k_max()) <= tolerance))
      return sample + "another curvature";
    if(!(std::abs(b.Gaussian() * scale * scale - a.Gaussian()) <= 4. * tolerance * size))
      return sample + "another Gaussian curvature";
  }
  return "";
}

// what else than dividing the curvatures scaling does, relative to the largest of them
inline double change_by_scaling(const Results& original, const Results& scaled, double scale)
{
  double change = 0.;
  for(std::size_t i = 0; i < original.samples.size(); ++i)
  {
    const Estimate &a = original.samples[i], &b = scaled.samples[i];
    if(SC::is_estimated(a.status) && SC::is_estimated(b.status))
      test_support::raise_to(change, std::abs(b.k_min() * scale - a.k_min()),
                             std::abs(b.k_max() * scale - a.k_max()));
  }
  return change / largest(original);
}

} // namespace bad_inputs

#endif // SHAPE_CHARACTERISTICS_TEST_BAD_INPUTS_ESTIMATORS_H
