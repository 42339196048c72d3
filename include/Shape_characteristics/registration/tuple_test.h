#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_TUPLE_TEST_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_TUPLE_TEST_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/registration/Correspondence.h>
#include <Shape_characteristics/registration/Oriented_points.h>
#include <Shape_characteristics/registration/internal/check_oriented_points.h>
#include <Shape_characteristics/registration/internal/scan_scale.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// says of three correspondences whether there can be a rigid motion that agrees with all of them
class Tuple_test
{
public:
  struct Corner
  {
    Eigen::Vector3d point, normal;
  };
  using Triangle = std::array<const Corner*, 3>;

  // of lengths, and of the cosines of normals
  double similarity = 0.95, tolerance = 0.3;
  bool tests_orientation = true, tests_normals = true;

  bool operator()(const Triangle& p, const Triangle& q) const
  {
    // directions of the edges, from corner i to the next
    std::array<Eigen::Vector3d, 3> d, e;
    for(std::size_t i = 0; i < 3; ++i)
    {
      d[i] = p[(i + 1) % 3]->point - p[i]->point;
      e[i] = q[(i + 1) % 3]->point - q[i]->point;
      const double a = d[i].squaredNorm(), b = e[i].squaredNorm();
      // lengths of 0 are no edges
      if(!(a > similarity * similarity * b && b > similarity * similarity * a))
        return false;
    }
    if(!tests_orientation && !tests_normals)
      return true;
    for(std::size_t i = 0; i < 3; ++i)
    {
      d[i].normalize();
      e[i].normalize();
    }
    return (!tests_orientation || are_oriented_alike(p, d, q, e)) &&
           (!tests_normals || have_like_normals(p, d, q, e));
  }

private:
  using Edges = std::array<Eigen::Vector3d, 3>;

  // The volume that mean normal and edges span, in [-1, 1]: the mirrored triangle has the opposite one.
  static double orientation(const Triangle& t, const Edges& edges)
  {
    const Eigen::Vector3d normal = (t[0]->normal + t[1]->normal + t[2]->normal) / 3.;
    return -normal.dot(edges[0].cross(edges[2]));
  }

  static bool are_oriented_alike(const Triangle& p, const Edges& d, const Triangle& q, const Edges& e)
  {
    constexpr double flat = 0.05; // triangles seen edge-on, and slim ones, say nothing
    const double a = orientation(p, d), b = orientation(q, e);
    return (a > 0.) == (b > 0.) || (std::abs(a) < flat && std::abs(b) < flat);
  }

  // of the two normals at an edge: the angles between them and with the edge, and the sense in which they are twisted
  bool have_like_normals(const Triangle& p, const Edges& d, const Triangle& q, const Edges& e) const
  {
    const auto are_alike = [&](double a, double b) { return std::abs(a - b) <= tolerance; };
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3;
      const Eigen::Vector3d &m = p[i]->normal, &n = p[j]->normal, &s = q[i]->normal, &t = q[j]->normal;
      if(!are_alike(m.dot(n), s.dot(t)) || !are_alike(m.dot(d[i]), s.dot(e[i])) ||
         !are_alike(n.dot(d[i]), t.dot(e[i])) || !are_alike(d[i].dot(m.cross(n)), e[i].dot(s.cross(t))))
        return false;
    }
    return true;
  }
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  draws triples of correspondences at random and returns those of the triples that a rigid motion can explain.

  Most correspondences between two scans are wrong; it is unlikely that three wrong ones are congruent. A triple is kept if

  - corresponding edges of the two triangles have lengths alike, as in fast global registration \cgalCite{fgr},
  - and the triangles, seen from outside of the surface, go around in the same sense: the lengths of a triangle and of its
    mirror image are the same, so that they don't tell the left side of a face from its right one,
  - and for each edge, the cosines between the two normals and the edge are alike, and so is the signed volume that the
    three span.

  On symmetric objects, the second and third test decide whether a registration succeeds: a point has a mirrored partner on
  the other scan more often than a true one.

  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param source the source
  \param target the target
  \param correspondences between points of `source` and `target`, as from `match_descriptors()`
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{edge_length_similarity}
      \cgalParamDescription{the smallest ratio of the lengths of corresponding edges, the shorter one by the longer one, in
                            [0, 1)}
      \cgalParamType{`double`}
      \cgalParamDefault{`0.95`}
    \cgalParamNEnd
    \cgalParamNBegin{orientation_is_tested}
      \cgalParamDescription{whether the triangles have to be oriented alike. Triangles that are slim, or seen edge-on, pass.}
      \cgalParamType{`bool`}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{normals_are_tested}
      \cgalParamDescription{whether the normals have to be alike}
      \cgalParamType{`bool`}
      \cgalParamDefault{`true`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_tolerance}
      \cgalParamDescription{how much the cosines, and the volume of unit vectors, may differ; not negative}
      \cgalParamType{`double`}
      \cgalParamDefault{`0.3`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_tuples}
      \cgalParamDescription{how many triples are enough; not negative}
      \cgalParamType{an integer type}
      \cgalParamDefault{`1000`}
    \cgalParamNEnd
    \cgalParamNBegin{tries_per_correspondence}
      \cgalParamDescription{how many triples are drawn at most, per correspondence; not negative}
      \cgalParamType{an integer type}
      \cgalParamDefault{`100`}
    \cgalParamNEnd
    \cgalParamNBegin{random_seed}
      \cgalParamDescription{the seed of the draws: the same seed draws the same triples on every machine}
      \cgalParamType{an integer type}
      \cgalParamDefault{`0`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the three correspondences of each triple that was kept, one triple after the other: a correspondence in several
          triples comes several times, and so weighs more in what is estimated from them. Correspondences of points that
          aren't usable are left out.

  \throws std::invalid_argument if there are more or less normals than points or one is neither 0 nor of unit length, a correspondence
          names a point that isn't there, or a parameter is out of its range

  The result depends neither on the unit of length nor on the position of the surfaces, up to rounding.

  Complexity: linear in the number of draws, whatever the size of the surfaces.

  \cgalExample{registration/registration_steps.cpp}
*/
template <typename NamedParameters = parameters::Default_named_parameters>
std::vector<Correspondence> tuple_test(const Oriented_points& source,
                                       const Oriented_points& target,
                                       const std::vector<Correspondence>& correspondences,
                                       const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  internal::Tuple_test test;
  test.similarity = choose_parameter(get_parameter(np, internal_np::edge_length_similarity), 0.95);
  test.tolerance = choose_parameter(get_parameter(np, internal_np::normal_tolerance), 0.3);
  test.tests_orientation = choose_parameter(get_parameter(np, internal_np::orientation_is_tested), true);
  test.tests_normals = choose_parameter(get_parameter(np, internal_np::normals_are_tested), true);
  const std::int64_t tuples =
      internal::whole_number(np, internal_np::number_of_tuples, std::int64_t(1000), "number_of_tuples");
  const std::int64_t tries = internal::whole_number(np, internal_np::tries_per_correspondence,
                                                    std::int64_t(100), "tries_per_correspondence");
  const std::uint64_t seed =
      internal::whole_number(np, internal_np::random_seed, std::uint64_t(0), "random_seed");
  if(!(test.similarity >= 0. && test.similarity < 1.))
    throw std::invalid_argument("Shape_characteristics: edge_length_similarity must be in [0, 1)");
  if(!(test.tolerance >= 0.))
    throw std::invalid_argument("Shape_characteristics: normal_tolerance must not be negative");
  if(tuples < 0 || tries < 0)
    throw std::invalid_argument(
        "Shape_characteristics: number_of_tuples and tries_per_correspondence must not be negative");
  internal::check_normals(source, target);
  internal::check_correspondences(source, target, correspondences);

  // in a row in memory
  using Corner = internal::Tuple_test::Corner;
  const double unit = internal::scan_scale(source, target);
  std::vector<std::array<Corner, 2>> corners;
  std::vector<Correspondence> usable;
  for(const Correspondence& c : correspondences)
    if(source.is_usable(c.source) && target.is_usable(c.target))
    {
      corners.push_back({Corner{unit * source.points[c.source], source.normals[c.source]},
                         Corner{unit * target.points[c.target], target.normals[c.target]}});
      usable.push_back(c);
    }

  std::vector<Correspondence> result;
  const std::uint64_t number = usable.size();
  if(number < 3)
    return result;
  // the distributions of the standard library differ from one to the next
  std::mt19937_64 generator(seed);
  const auto draw = [&] { return std::size_t(((generator() >> 32) * number) >> 32); };
  const std::size_t enough = 3 * static_cast<std::size_t>(tuples);
  for(std::uint64_t t = static_cast<std::uint64_t>(tries) * number; t > 0 && result.size() < enough; --t)
  {
    const std::size_t i = draw(), j = draw(), k = draw();
    if(test({&corners[i][0], &corners[j][0], &corners[k][0]},
            {&corners[i][1], &corners[j][1], &corners[k][1]}))
      result.insert(result.end(), {usable[i], usable[j], usable[k]});
  }
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_TUPLE_TEST_H
