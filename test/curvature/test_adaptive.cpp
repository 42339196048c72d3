#include <boost/test/unit_test.hpp>

#include "Numbered_points.h"
#include "estimator_checks.h"
#include "raise_to.h"

#include "../../benchmark/support/exact_curvature.h"
#include "../../benchmark/support/marching_cubes.h"

#include <Shape_characteristics/curvature/adaptive_curvatures.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/internal/Adaptive_estimator.h>
#include <Shape_characteristics/curvature/internal/Adaptive_statistics.h>
#include <Shape_characteristics/normals/vertex_normals.h>

#include <CGAL/property_map.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(adaptive)

using namespace estimator_checks;

namespace {

using Choice = SC::Adaptive_estimator_choice;
using Vertex = Surface_mesh::Vertex_index;
using Normal_map = Surface_mesh::Property_map<Vertex, Kernel::Vector_3>;

struct Adaptive
{
  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    return SC::adaptive_curvatures<Tag>(mesh, np);
  }
  template <typename V, typename Mesh, typename Np>
  SC::Estimation_status one(V v, const Mesh& mesh, const Np& np) const
  {
    return SC::adaptive_curvatures(v, mesh, np);
  }
};

enum class Given
{
  EXACT,      // exact normals
  ESTIMATED,  // of the faces
  MISLEADING, // with errors of some degrees
};

// What is given of a surface: points with noise (in mean edge lengths), and normals.
struct Data
{
  Data(const Analytic_surface& s, Given given, double noise) : surface(s)
  {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const double deviation = noise * s.mean_edge_length();
    Analytic_surface moved = s;
    if(noise > 0.)
      for(auto& p : moved.points)
        for(std::size_t i = 0; i < 3; ++i)
          p[i] += deviation * normal(random);
    mesh = surface_mesh_of(moved);
    normals = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:given_normal").first;
    if(given == Given::ESTIMATED)
      SC::vertex_normals(mesh, normals);
    else
      for(const Vertex v : vertices(mesh))
      {
        auto n = s.exact[v].normal;
        if(given == Given::MISLEADING)
          for(std::size_t i = 0; i < 3; ++i)
            n[i] += .08 * normal(random);
        normals[v] = Kernel::Vector_3(n[0], n[1], n[2]);
      }
  }

  const Analytic_surface& surface;
  Surface_mesh mesh;
  Normal_map normals;
};

struct Answer
{
  double error = 0.; // mean of |k_max error| + |k_min error|
  std::array<double, std::size_t(Choice::NONE) + 1> shares{};

  double share(std::initializer_list<Choice> choices) const
  {
    double sum = 0.;
    for(const Choice c : choices)
      sum += shares[std::size_t(c)];
    return sum;
  }
};

template <typename Run>
Answer answer(const Data& data, const Run& run)
{
  Surface_mesh mesh = data.mesh;
  auto curvatures = mesh.add_property_map<Vertex, Curvatures>("v:c").first;
  auto choices = mesh.add_property_map<Vertex, Choice>("v:e", Choice::NONE).first;
  auto normals = mesh.property_map<Vertex, Kernel::Vector_3>("v:given_normal");
#if CGAL_VERSION_NR >= 1060000000
  const Normal_map normal_map = *normals;
#else
  const Normal_map normal_map = normals.first;
#endif
  const auto np = SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures)
                      .vertex_normal_map(normal_map);
  BOOST_TEST(run(mesh, np, choices) == 0u);
  Answer result;
  const double n = double(mesh.number_of_vertices());
  for(const Vertex v : vertices(mesh))
  {
    const Exact_vertex& e = data.surface.exact[v];
    result.error +=
        (std::abs(curvatures[v].max_curvature - e.k_max) + std::abs(curvatures[v].min_curvature - e.k_min)) /
        n;
    result.shares[std::size_t(choices[v])] += 1. / n;
  }
  return result;
}

Answer adaptive(const Data& data)
{
  return answer(data, [](const auto& mesh, const auto& np, const auto& choices)
                { return SC::adaptive_curvatures(mesh, np.vertex_estimator_map(choices)); });
}

// Two tests look at the same data.
const Answer& adaptive_to(const Data& data, Given given, double noise)
{
  static std::map<std::tuple<std::string, Given, double>, Answer> answers;
  const auto [place, is_new] = answers.try_emplace({data.surface.name, given, noise});
  if(is_new)
    place->second = adaptive(data);
  return place->second;
}

double hrbf(const Data& data, bool normals_are_exact, unsigned int rings)
{
  return answer(data,
                [&](const auto& mesh, const auto& np, const auto&) {
                  return SC::hrbf_curvatures(mesh,
                                             np.normals_are_exact(normals_are_exact).number_of_rings(rings));
                })
      .error;
}

// told the noise (in mean edge lengths), all of which each of three passes expects
double hrbf_told(const Data& data, double noise)
{
  return answer(data,
                [&](const auto& mesh, const auto& np, const auto&) {
                  return SC::hrbf_curvatures(mesh,
                                             np.number_of_rings(3).noise_level(noise).number_of_passes(3u));
                })
      .error;
}

// told that points have noise (in mean edge lengths) and normals don't
double hrbf_with_trusted_normals(const Data& data, double noise)
{
  return answer(data,
                [&](const auto& mesh, const auto& np, const auto&)
                {
                  return SC::hrbf_curvatures(
                      mesh,
                      np.number_of_rings(3).noise_level(noise).normal_noise_level(1e-3).number_of_passes(1u));
                })
      .error;
}

// the mean error if nothing was blended
double largest_weight(const Data& data)
{
  using Samples = SC::Face_graph_samples;
  SC::internal::Adaptive_statistics<CGAL::Sequential_tag, Samples> statistics(
      [&](const unsigned int rings)
      {
        return SC::sampled_surface(data.mesh, SC::Neighborhood::rings(rings),
                                   SC::parameters::vertex_normal_map(data.normals));
      },
      {}, false);
  const std::vector<Choice> choices =
      SC::internal::Adaptive_estimator<CGAL::Sequential_tag, Samples>(statistics, statistics.size())()
          .choices;
  double sum = 0.;
  for(std::size_t i = 0; i < choices.size(); ++i)
  {
    const auto alone = statistics.field(choices[i])[i].estimate().curvatures;
    const Exact_vertex& e = data.surface.exact[i];
    sum += std::abs(alone.max_curvature - e.k_max) + std::abs(alone.min_curvature - e.k_min);
  }
  return sum / double(choices.size());
}

// How many statistics of every seventh sample have other bits if they alone are asked for.
template <typename Samples, typename Make_surface>
std::size_t changes_by_restriction(const Make_surface& make_surface)
{
  using Statistics = SC::internal::Adaptive_statistics<CGAL::Parallel_if_available_tag, Samples>;
  Statistics all(make_surface, {}, false), some(make_surface, {}, false);
  std::vector<typename Statistics::Index> samples;
  for(std::size_t i = 0; i < all.size() / 3; i += 7)
    samples.push_back(typename Statistics::Index(i));
  some.restrict_to(samples);
  std::size_t changes = 0, computed = 0;
  for(std::size_t s = 0; s < SC::internal::number_of_adaptive_statistics; ++s)
  {
    const auto name = SC::internal::Adaptive_statistic(s);
    for(const auto i : samples)
      changes += all.statistic(name)[i] != some.statistic(name)[i];
  }
  for(std::size_t c = 0; c < SC::internal::number_of_adaptive_candidates; ++c)
    for(const SC::internal::Fitted_sample& fit : some.field(Choice(c)))
      computed += SC::is_estimated(fit.status);
  BOOST_TEST(computed < all.size() * SC::internal::number_of_adaptive_candidates / 2);
  return changes;
}

const std::vector<Analytic_surface>& surfaces()
{
  static const std::vector<Analytic_surface> list = {test_support::torus(1., .4, 36, 18, .2, 3),
                                                     test_support::waves(.1, 4., 1., 20, .2, 2)};
  return list;
}

constexpr std::initializer_list<Choice>
    exact = {Choice::EXACT_2_RINGS, Choice::EXACT_3_RINGS, Choice::CHECKED_2_RINGS, Choice::CHECKED_3_RINGS},
    positions = {Choice::POINTS_2_RINGS,         Choice::POINTS_3_RINGS,   Choice::POINTS_4_RINGS,
                 Choice::SMOOTHED_3_RINGS,       Choice::SMOOTHED_4_RINGS, Choice::GENTLY_SMOOTHED_4_RINGS,
                 Choice::BARELY_SMOOTHED_4_RINGS},
    noisy = {Choice::NORMALS_2_RINGS,  Choice::NORMALS_3_RINGS,         Choice::SMOOTHED_3_RINGS,
             Choice::SMOOTHED_4_RINGS, Choice::GENTLY_SMOOTHED_4_RINGS, Choice::BARELY_SMOOTHED_4_RINGS};

} // namespace

// What kind of data it is shows in the choices, without being told; and the error is never much larger than with what somebody
// would choose who knows it, and less where there is noise.
BOOST_AUTO_TEST_CASE(choices_and_errors)
{
  for(const Analytic_surface& s : surfaces())
    for(const Given given : {Given::EXACT, Given::ESTIMATED, Given::MISLEADING})
      for(const double noise : {0., .08})
        BOOST_TEST_CONTEXT(s.name << ", " << int(given) << ", noise " << noise)
        {
          const Data data(s, given, noise);
          const Answer& a = adaptive_to(data, given, noise);
          if(given == Given::EXACT && noise == 0.)
            BOOST_TEST(a.share({Choice::CHECKED_3_RINGS}) > .95);
          else if(given == Given::EXACT)
          {
            const double of_trusted_normals = hrbf_with_trusted_normals(data, noise);
            BOOST_TEST_MESSAGE("with trusted normals " << of_trusted_normals);
            BOOST_TEST(a.share({Choice::NORMALS_2_RINGS, Choice::NORMALS_3_RINGS}) > .5);
            BOOST_TEST(a.error < 1.1 * of_trusted_normals);
          }
          else
            BOOST_TEST(a.share(exact) < .02);
          if(given == Given::MISLEADING && noise == 0.)
            BOOST_TEST(a.share(positions) > .95);
          if(given != Given::EXACT && noise > 0.)
            BOOST_TEST(a.share(noisy) > .7);
          const double of_exact_fit = hrbf(data, true, 3),
                       of_others = (std::min)(hrbf(data, false, 2), hrbf(data, false, 3));
          BOOST_TEST_MESSAGE(s.name << ", " << int(given) << ", noise " << noise << ": mean error " << a.error
                                    << ", with exact normals " << of_exact_fit << ", else " << of_others);
          BOOST_TEST(a.error < 1.25 * of_exact_fit);
          BOOST_TEST(a.error < (noise > 0. ? 1. : 1.25) * of_others);
        }
}

// Of a surface with a few samples to each bend and exact normals nobody can tell noise from shape but by the normals.
BOOST_AUTO_TEST_CASE(few_samples_to_each_bend)
{
  const Analytic_surface s = test_support::waves(.05, 25., 1., 36, .3, 5);
  for(const double noise : {.01, .03})
  {
    const Data data(s, Given::EXACT, noise);
    const Answer a = adaptive(data);
    const double best =
        (std::min)({hrbf(data, true, 2), hrbf(data, true, 3), hrbf(data, false, 2), hrbf(data, false, 3)});
    BOOST_TEST_MESSAGE("noise " << noise << ": mean error " << a.error << ", of the best one " << best
                                << ", checked "
                                << a.share({Choice::CHECKED_2_RINGS, Choice::CHECKED_3_RINGS}));
    BOOST_TEST(a.error < 1.2 * best);
    BOOST_TEST(a.share({Choice::CHECKED_2_RINGS}) == 0.); // three rings are better
  }
}

namespace {

using Point = benchmark_support::Vector;
using Truth = std::function<benchmark_support::Exact_curvature(const Point&)>;

// a level set, with the vertices where linear interpolation puts them
Analytic_surface
marching_cubes(const std::string& name, const std::function<double(const Point&)>& value, const Truth& truth)
{
  const benchmark_support::Triangle_arrays triangles = benchmark_support::marching_cubes(
      value, {-1., -1., -1.}, {1., 1., 1.}, 24, benchmark_support::Edge_crossing::LINEAR);
  Analytic_surface s;
  s.name = name;
  s.points = triangles.points;
  s.triangles = triangles.triangles;
  for(const Point& p : s.points)
  {
    s.exact.emplace_back();
    static_cast<benchmark_support::Exact_curvature&>(s.exact.back()) = truth(p);
  }
  return s;
}

} // namespace

// Where a surface bends little, normals of the faces that marching cubes interpolate linearly agree with the points as well as exact
// ones do, and aren't.
BOOST_AUTO_TEST_CASE(gentle_surface_of_marching_cubes)
{
  for(const double height : {.003, .01})
  {
    const auto value = [&](const Point& p)
    {
      return .36 * p.x - .48 * p.y + .8 * p.z +
             height * (std::sin(p.x - .6 * p.y + .3) + std::cos(.8 * p.y + .5 * p.z));
    };
    const auto truth = [&](const Point& p)
    {
      const double sine = height * std::sin(p.x - .6 * p.y + .3),
                   cosine = height * std::cos(p.x - .6 * p.y + .3),
                   second_sine = height * std::sin(.8 * p.y + .5 * p.z),
                   second_cosine = height * std::cos(.8 * p.y + .5 * p.z);
      return benchmark_support::exact_curvature(
          {.36 + cosine, -.48 - .6 * cosine - .8 * second_sine, .8 - .5 * second_sine},
          {Point{-sine, .6 * sine, 0.},
           Point{.6 * sine, -.36 * sine - .64 * second_cosine, -.4 * second_cosine},
           Point{0., -.4 * second_cosine, -.25 * second_cosine}});
    };
    const Analytic_surface s = marching_cubes("plane with waves", value, truth);
    const Data data(s, Given::ESTIMATED, 0.);
    const Answer a = adaptive(data);
    const double of_hrbf = hrbf(data, false, 3);
    BOOST_TEST_MESSAGE("height " << height << ": mean error " << a.error << ", of HRBF " << of_hrbf
                                 << ", taken for exact " << a.share(exact));
    BOOST_TEST(a.share(exact) < .2);
    BOOST_TEST(a.error < of_hrbf / 5.);
  }
}

// On the whole the blend is nearer to the truth than, at each vertex, the estimator with the largest weight alone.
BOOST_AUTO_TEST_CASE(blend)
{
  double of_largest_weight = 0., of_hrbf = 0., of_told = 0.; // sums of logarithms of quotients of errors
  int number = 0;
  for(const Analytic_surface& s : surfaces())
    for(const Given given : {Given::EXACT, Given::ESTIMATED, Given::MISLEADING})
    {
      constexpr double noise = .08;
      const Data data(s, given, noise);
      const double error = adaptive_to(data, given, noise).error,
                   error_of_largest_weight = largest_weight(data), error_of_hrbf = hrbf(data, false, 3),
                   error_of_told = hrbf_told(data, noise);
      BOOST_TEST_MESSAGE("mean error " << error << ", of the largest weight " << error_of_largest_weight
                                       << ", of HRBF " << error_of_hrbf << ", told the noise "
                                       << error_of_told);
      BOOST_TEST(error < (&s == &surfaces().front() ? .9 : .95) * error_of_hrbf);
      of_largest_weight += std::log(error / error_of_largest_weight);
      of_hrbf += std::log(error / error_of_hrbf);
      of_told += std::log(error / error_of_told);
      ++number;
    }
  BOOST_TEST_MESSAGE("quotients: " << std::exp(of_largest_weight / number) << ", "
                                   << std::exp(of_hrbf / number) << ", " << std::exp(of_told / number));
  BOOST_TEST(std::exp(of_largest_weight / number) < .99);
  BOOST_TEST(std::exp(of_hrbf / number) < .67);
  BOOST_TEST(std::exp(of_told / number) < .34);
}

namespace {

struct On_quadrics
{
  std::size_t number = 0; // of vertices by QUADRIC
  double error = 0.;      // the largest one of them, of a curvature
};

On_quadrics on_quadrics(const Data& data)
{
  Surface_mesh mesh = data.mesh;
  auto curvatures =
      mesh.add_property_map<Vertex, SC::Principal_curvatures_and_directions<Kernel>>("v:curvatures").first;
  auto choices = mesh.add_property_map<Vertex, Choice>("v:choice").first;
  SC::adaptive_curvatures(mesh, SC::parameters::vertex_normal_map(data.normals)
                                    .vertex_principal_curvatures_and_directions_map(curvatures)
                                    .vertex_estimator_map(choices));
  On_quadrics result;
  for(const Vertex v : vertices(mesh))
    if(choices[v] == Choice::QUADRIC)
    {
      const auto& exact = data.surface.exact[v];
      ++result.number;
      test_support::raise_to(result.error, std::abs(curvatures[v].min_curvature - exact.k_min),
                             std::abs(curvatures[v].max_curvature - exact.k_max));
    }
  return result;
}

// the ridge of a roof along the y axis
Analytic_surface roof()
{
  Analytic_surface s = test_support::plane(1., 12, .15, 3);
  s.name = "roof";
  const double pitch = .6;
  for(std::size_t i = 0; i < s.points.size(); ++i)
  {
    auto& p = s.points[i];
    if(std::abs(p.x) < .05)
      p.x = 0.;
    const double side = p.x < 0. ? 1. : p.x > 0. ? -1. : 0.;
    p.z = -pitch * std::abs(p.x);
    s.exact[i].normal = benchmark_support::normalized({-side * pitch, 0., 1.});
  }
  return s;
}

// The side of a cylinder in rows and columns, its circle stretched to an ellipse, which `wave` bends; or of the cone over that curve.
Analytic_surface moved_profile(double wave, bool is_cone)
{
  Analytic_surface s = test_support::cylinder(1., 2., 60, 12);
  constexpr double a = 1.3, b = 1.;
  for(std::size_t i = 0; i < s.points.size(); ++i)
  {
    auto& p = s.points[i];
    const double c = p.x, d = p.y, r = 1. + wave * (4. * c * c * c - 3. * c), height = 1. + p.z;
    const double scale = is_cone ? height : 1.;
    p = {scale * a * r * c, scale * b * r * d, height};
    s.exact[i].k_min = 0.;
    s.exact[i].k_max = a * b / std::pow(a * a * d * d + b * b * c * c, 1.5); // of the ellipse
  }
  return s;
}

} // namespace

// On quadrics the answer is exact, up to the border and whatever the normals are.
BOOST_AUTO_TEST_CASE(quadrics)
{
  for(const Analytic_surface& s :
      {test_support::sphere(1., 2), test_support::ellipsoid(1., .7, .5, 3, .15),
       test_support::ellipsoid_of_longitudes(1., .8, .6, 24), test_support::cylinder(1., 2., 24, 9),
       test_support::cylinder(1., 2., 24, 9, .15), test_support::cone(1., 1.5, 24, 9, .15),
       test_support::saddle(1., 12), test_support::paraboloid(.7, .3, 1., 12, .15)})
    for(const Given given : {Given::EXACT, Given::ESTIMATED, Given::MISLEADING})
      BOOST_TEST_CONTEXT(s.name << ", " << int(given))
      {
        const On_quadrics result = on_quadrics(Data(s, given, 0.));
        const auto is_singular = [](const auto& e) { return e.singular; };
        const auto singular = std::size_t(std::count_if(s.exact.begin(), s.exact.end(), is_singular));
        BOOST_TEST_MESSAGE(s.name << ": " << result.error);
        BOOST_TEST(result.number == s.points.size() - singular); // the tip of the cone is none
        BOOST_TEST(result.error < 2e-12);
      }
}

// Others are no quadrics, however finely they are sampled; nor are points with a little noise on any, but by the eighth digit.
BOOST_AUTO_TEST_CASE(no_quadrics)
{
  for(const Analytic_surface& s :
      {test_support::torus(), test_support::torus(1., .4, 160, 80, .15), test_support::waves(.1, 4., 1., 100),
       test_support::monkey_saddle(.5, 100, .15)})
    BOOST_TEST(on_quadrics(Data(s, Given::EXACT, 0.)).number == 0u, s.name);
  // on all cylinders over the conics through the corners of a square
  BOOST_TEST(on_quadrics(Data(test_support::cylinder(1., 4., 4, 12), Given::EXACT, 0.)).number == 0u);
  const Analytic_surface ellipsoid = test_support::ellipsoid(1., .7, .5, 2, .15);
  BOOST_TEST(on_quadrics(Data(ellipsoid, Given::ESTIMATED, 1e-7)).number == 0u);
  const On_quadrics nearly = on_quadrics(Data(ellipsoid, Given::ESTIMATED, 1e-10));
  BOOST_TEST(nearly.number == ellipsoid.points.size());
  BOOST_TEST(nearly.error < 1e-7);
}

// Where linear interpolation puts the vertices, exact normals tell the quadric: that of the level set through each of them. Through the
// points of one layer of the grid there is another one.
BOOST_AUTO_TEST_CASE(normals_of_quadrics)
{
  struct Form // a x^2 + b y^2 + c z^2 + d xy + e x + f y + g z + h
  {
    std::string name;
    double a, b, c, d, e, f, g, h;
  };
  for(const Form& q :
      {Form{"sphere", 1., 1., 1., 0., .1, 0., -.1, -.6}, Form{"ellipsoid", 1.3, 2., 4., .4, 0., .1, 0., -.8},
       Form{"cylinder", 1., 1., 0., 0., .1, .2, 0., -.5}, Form{"saddle", .4, -.3, 0., .2, 0., .1, 1., 0.},
       Form{"vault", .1, .3, .05, .2, .3, .2, .9, 0.}})
    BOOST_TEST_CONTEXT(q.name)
    {
      const auto value = [&](const Point& p)
      {
        return q.a * p.x * p.x + q.b * p.y * p.y + q.c * p.z * p.z + q.d * p.x * p.y + q.e * p.x + q.f * p.y +
               q.g * p.z + q.h;
      };
      const auto truth = [&](const Point& p)
      {
        return benchmark_support::exact_curvature(
            {2. * q.a * p.x + q.d * p.y + q.e, 2. * q.b * p.y + q.d * p.x + q.f, 2. * q.c * p.z + q.g},
            {Point{2. * q.a, q.d, 0.}, Point{q.d, 2. * q.b, 0.}, Point{0., 0., 2. * q.c}});
      };
      const Analytic_surface s = marching_cubes(q.name, value, truth);
      const On_quadrics exact = on_quadrics(Data(s, Given::EXACT, 0.));
      BOOST_TEST_MESSAGE(q.name << ": " << exact.number << " of " << s.points.size() << ", " << exact.error);
      BOOST_TEST(exact.number + 1 >= s.points.size()); // there is a corner with few neighbors
      BOOST_TEST(exact.error < 1e-9);
      // with other normals, those few through whose points there is one
      BOOST_TEST(on_quadrics(Data(s, Given::MISLEADING, 0.)).number < s.points.size() / 3);
    }
  // Normals of a sphere don't make one of points that are far from it.
  Analytic_surface waves = test_support::plane(1., 24, .15, 3);
  for(std::size_t i = 0; i < waves.points.size(); ++i)
  {
    auto& p = waves.points[i];
    p.z = .1 * std::sin(9. * p.x);
    waves.exact[i].normal = benchmark_support::normalized(p - Point{0., 0., -1.});
  }
  BOOST_TEST(on_quadrics(Data(waves, Given::EXACT, 0.)).number < waves.points.size() / 4);
}

// A conic goes through any five points, and rows hold no more of a profile within two rings.
BOOST_AUTO_TEST_CASE(moved_profiles)
{
  for(const bool is_cone : {false, true})
    for(const double wave : {1e-3, .1})
      BOOST_TEST(on_quadrics(Data(moved_profile(wave, is_cone), Given::ESTIMATED, 0.)).number == 0u);
  const Analytic_surface cylinder = moved_profile(0., false);
  const On_quadrics ellipses = on_quadrics(Data(cylinder, Given::ESTIMATED, 0.));
  BOOST_TEST(ellipses.number == cylinder.points.size());
  BOOST_TEST(ellipses.error < 1e-9);
  const Analytic_surface cone = moved_profile(0., true);
  BOOST_TEST(on_quadrics(Data(cone, Given::ESTIMATED, 0.)).number == cone.points.size());
}

// Nor do quadrics say anything that go through the circles of a torus, as they do through any three around an axis, or, as two planes, through
// two of them.
BOOST_AUTO_TEST_CASE(points_on_circles)
{
  for(const auto& [around, across] : {std::pair(100, 20), std::pair(200, 12)})
  {
    const Analytic_surface s = test_support::torus(1., .4, std::size_t(around), std::size_t(across));
    const Result result = test_support::Numbered_points(s).estimates(
        [](const auto& numbers, const auto& np)
        { return SC::adaptive_curvatures<CGAL::Sequential_tag>(numbers, np); });
    BOOST_TEST(result.failures == 0u);
    const double largest = errors(s, result, 0.).largest;
    BOOST_TEST_MESSAGE("torus of " << across << " circles: " << largest);
    BOOST_TEST(largest < .05);
  }
}

// Two planes are a quadric: beside the edge between them, they are flat.
BOOST_AUTO_TEST_CASE(planes_that_meet)
{
  const Analytic_surface s = roof();
  const On_quadrics result = on_quadrics(Data(s, Given::EXACT, 0.));
  BOOST_TEST(result.number > 0u);
  BOOST_TEST(result.error < 1e-12);
}

// The likelihoods tell which data are noisy, and how much.
BOOST_AUTO_TEST_CASE(noise_evidence)
{
  using Name = SC::internal::Adaptive_statistic;
  struct Means
  {
    double exact_normals, exact_points, noise_of_points, noise_of_normals, neither;
  };
  const auto means = [](const Given given, const double noise)
  {
    const Data data(surfaces().front(), given, noise);
    SC::internal::Adaptive_statistics<CGAL::Sequential_tag, SC::Face_graph_samples> statistics(
        [&](const unsigned int rings)
        {
          return SC::sampled_surface(data.mesh, SC::Neighborhood::rings(rings),
                                     SC::parameters::vertex_normal_map(data.normals));
        },
        {}, false);
    const auto mean = [&](const Name name)
    {
      const std::vector<double>& all = statistics.statistic(name);
      return std::accumulate(all.begin(), all.end(), 0.) / double(all.size());
    };
    const Means result = {mean(Name::NORMALS_BY_1E_3), mean(Name::POINTS_BY_1E_6),
                          mean(Name::LIKELY_NOISE_OF_POINTS), mean(Name::LIKELY_NOISE_OF_NORMALS),
                          mean(Name::NEITHER_IS_NOISY)};
    BOOST_TEST_MESSAGE(int(given) << ", " << noise << ": " << result.exact_normals << " "
                                  << result.exact_points << " " << result.noise_of_points << " "
                                  << result.noise_of_normals << " " << result.neither);
    return result;
  };
  const Means exact = means(Given::EXACT, 0.), estimated = means(Given::ESTIMATED, 0.),
              noisy = means(Given::EXACT, .03), noisier = means(Given::EXACT, .1);
  BOOST_TEST(exact.exact_normals > 1.);
  BOOST_TEST(exact.neither > -1.);
  BOOST_TEST(estimated.neither < -2.);
  BOOST_TEST(estimated.exact_normals < -1.);
  BOOST_TEST(estimated.exact_points > 1.);
  BOOST_TEST(exact.noise_of_normals < estimated.noise_of_normals - .5);
  BOOST_TEST(noisy.noise_of_normals < estimated.noise_of_normals + .1);
  BOOST_TEST(noisy.exact_points < -1.);
  for(const auto& [found, noise] :
      {std::pair(noisy.noise_of_points, .03), std::pair(noisier.noise_of_points, .1)})
    BOOST_TEST(std::abs(found - std::log10(noise)) < .4);
}

// Where some samples need a closer look, the others are left alone; no bit shows it.
BOOST_AUTO_TEST_CASE(restriction)
{
  for(const double noise : {0., .08})
  {
    const Data data(surfaces().front(), Given::ESTIMATED, noise);
    const auto changes_of_mesh = changes_by_restriction<SC::Face_graph_samples>(
        [&](const unsigned int rings)
        {
          return SC::sampled_surface(data.mesh, SC::Neighborhood::rings(rings),
                                     SC::parameters::vertex_normal_map(data.normals));
        });
    BOOST_TEST(changes_of_mesh == 0u, "mesh, noise " << noise);
    const auto range = vertices(data.mesh);
    const std::vector<Vertex> points(range.begin(), range.end());
    const auto changes_of_points = changes_by_restriction<SC::Point_set_samples>(
        [&](const unsigned int rings)
        {
          return SC::sampled_surface(points, SC::Neighborhood::nearest(3 * rings * (rings + 1)),
                                     SC::parameters::point_map(data.mesh.points()).normal_map(data.normals));
        });
    BOOST_TEST(changes_of_points == 0u, "points, noise " << noise);
  }
}

BOOST_AUTO_TEST_CASE(threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Analytic_surface s = test_support::torus(1., .4, 32, 16, .2, 6); // 4 blocks of samples
  const Result expected = run(Adaptive(), s, Normals::ESTIMATED);
  for(const std::size_t threads : {1, 3})
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    BOOST_TEST(same_bits(expected, run<CGAL::Parallel_tag>(Adaptive(), s, Normals::ESTIMATED)),
               threads << " threads");
  }
#else
  BOOST_TEST_MESSAGE("  skipped: built without TBB");
#endif
}

// less accurate, but not by much; whatever the number of threads
BOOST_AUTO_TEST_CASE(shared_fits)
{
  const Analytic_surface s = test_support::torus(1., .4, 72, 36, .2, 4);
  for(const Given given : {Given::EXACT, Given::ESTIMATED})
  {
    const Data data(s, given, 0.);
    const auto error_with = [&](const auto tag)
    {
      return answer(data,
                    [](const auto& mesh, const auto& np, const auto& choices)
                    {
                      return SC::adaptive_curvatures<std::decay_t<decltype(tag)>>(
                          mesh, np.fits_are_shared(true).vertex_estimator_map(choices));
                    })
          .error;
    };
    const double error = error_with(CGAL::Sequential_tag()), alone = adaptive(data).error;
    BOOST_TEST_MESSAGE("mean error " << error << ", each for itself " << alone);
    BOOST_TEST(error != alone);
    BOOST_TEST(error < 2. * alone);
    BOOST_TEST(error_with(CGAL::Parallel_if_available_tag()) == error);
  }
}

BOOST_AUTO_TEST_CASE(flip_and_permutation)
{
  check_flip(Adaptive());
  check_permutation(Adaptive());
}

// powers of two: to the last bit
BOOST_AUTO_TEST_CASE(scale)
{
  for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
  {
    const Analytic_surface s = test_support::ellipsoid(1., .8, .6, 2, .2, 5);
    const Result original = run(Adaptive(), s, normals);
    for(const double factor : {0x1p-40, 0x1p40, 0x1p-100})
    {
      Analytic_surface scaled = s;
      for(auto& p : scaled.points)
        p = factor * p;
      const Result result = run(Adaptive(), scaled, normals);
      BOOST_TEST(result.failures == original.failures);
      bool same = true;
      for(std::size_t i = 0; i < s.points.size(); ++i)
        same = same && factor * result.curvatures[i].max_curvature == original.curvatures[i].max_curvature;
      BOOST_TEST(same);
    }
  }
}

BOOST_AUTO_TEST_CASE(one_vertex)
{
  const auto compare = [](const Analytic_surface& s, std::size_t i, const auto& check)
  {
    const Data data(s, Given::EXACT, 0.);
    const Result all = run(Adaptive(), s, Normals::EXACT);
    Curvatures c;
    double mean;
    BOOST_TEST(
        (SC::adaptive_curvatures(Vertex(static_cast<Vertex::size_type>(i)), data.mesh,
                                 SC::parameters::vertex_principal_curvatures_and_directions(std::ref(c))
                                     .vertex_mean_curvature(std::ref(mean))
                                     .vertex_normal_map(data.normals)) == SC::Estimation_status::ESTIMATED));
    check(c, mean, all.curvatures[i], all.mean[i]);
  };
  const auto check_bits = [](const Curvatures& c, double mean, const Curvatures& of_all, double mean_of_all)
  {
    BOOST_TEST(same_bits(c, of_all));
    BOOST_TEST(same_bits(mean, mean_of_all));
  };
  // normals that are exact beyond doubt
  compare(test_support::torus(1., .4, 20, 10, .2, 6), 77, check_bits);
  // points on a quadric
  compare(test_support::ellipsoid(1., .7, .5, 2, .15), 77, check_bits);
  // those of a surface that is sampled too coarsely to be sure: points farther away aren't smoothed
  const Analytic_surface s = test_support::torus(1., .4, 36, 18, .2, 6);
  compare(s, 333,
          [](const Curvatures& c, double mean, const Curvatures& of_all, double mean_of_all)
          {
            BOOST_TEST(std::abs(c.max_curvature - of_all.max_curvature) < 1e-7);
            BOOST_TEST(std::abs(mean - mean_of_all) < 1e-7);
          });
  // and else about the same
  const Data noisy(s, Given::ESTIMATED, .05);
  const Answer of_all = adaptive(noisy);
  double error = 0.;
  for(const std::size_t i : {100u, 300u, 500u})
  {
    Curvatures c;
    SC::adaptive_curvatures(Vertex(static_cast<Vertex::size_type>(i)), noisy.mesh,
                            SC::parameters::vertex_principal_curvatures_and_directions(std::ref(c))
                                .vertex_normal_map(noisy.normals));
    error +=
        (std::abs(c.max_curvature - s.exact[i].k_max) + std::abs(c.min_curvature - s.exact[i].k_min)) / 3.;
  }
  BOOST_TEST(error < 3. * of_all.error);
}

BOOST_AUTO_TEST_CASE(point_sets)
{
  const Analytic_surface s = test_support::torus(1., .4, 40, 20, .2, 3);
  test_support::Numbered_points points(s);
  points.points[5] = Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0., 0.);
  points.normals[600] = Kernel::Vector_3(0., 0., 0.);
  std::vector<Choice> choices(points.size());
  const Result result = points.estimates(
      [&](const auto& numbers, const auto& np)
      { return SC::adaptive_curvatures(numbers, np.estimator_map(CGAL::make_property_map(choices))); });
  check_consistency(result);
  double error = 0.;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const bool is_good = i != 5 && i != 600;
    BOOST_TEST((result.status[i] ==
                (is_good ? SC::Estimation_status::ESTIMATED : SC::Estimation_status::NON_FINITE_INPUT)));
    BOOST_TEST((choices[i] == Choice::NONE) == !is_good);
    if(is_good)
      error += std::abs(result.curvatures[i].max_curvature - s.exact[i].k_max) +
               std::abs(result.curvatures[i].min_curvature - s.exact[i].k_min);
  }
  BOOST_TEST_MESSAGE("  points: sum of the mean errors " << error / double(points.size()));
  BOOST_TEST(error / double(points.size()) < 2e-5);
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  Surface_mesh empty;
  BOOST_TEST(SC::adaptive_curvatures(empty) == 0u);

  // a triangle, and a vertex by itself
  Surface_mesh mesh;
  const Vertex a = mesh.add_vertex(Kernel::Point_3(0, 0, 0)), b = mesh.add_vertex(Kernel::Point_3(1, 0, 0)),
               c = mesh.add_vertex(Kernel::Point_3(0, 1, 0)), d = mesh.add_vertex(Kernel::Point_3(5, 5, 5));
  mesh.add_face(a, b, c);
  auto statuses = mesh.add_property_map<Vertex, SC::Estimation_status>("v:s").first;
  auto choices = mesh.add_property_map<Vertex, Choice>("v:e", Choice::EXACT_2_RINGS).first;
  BOOST_TEST(SC::adaptive_curvatures(
                 mesh, SC::parameters::vertex_status_map(statuses).vertex_estimator_map(choices)) == 4u);
  BOOST_TEST((statuses[a] == SC::Estimation_status::FEW_NEIGHBOURS));
  BOOST_TEST((statuses[d] == SC::Estimation_status::UNREFERENCED));
  BOOST_TEST((choices[a] == Choice::NONE));
  BOOST_TEST((choices[d] == Choice::NONE));

  // a plane: no curvature at all
  const Result plane = run(Adaptive(), test_support::plane(1., 12, .2), Normals::ESTIMATED);
  BOOST_TEST(plane.failures == 0u);
  for(const Curvatures& k : plane.curvatures)
    BOOST_TEST((std::abs(k.min_curvature) < 1e-10 && std::abs(k.max_curvature) < 1e-10));

  // a mesh with a point that isn't finite: its neighbors do without
  Analytic_surface s = test_support::torus(1., .4, 36, 18, .2, 6);
  s.points[100][1] = std::numeric_limits<double>::quiet_NaN();
  const Result broken = run(Adaptive(), s, Normals::EXACT);
  BOOST_TEST(broken.failures == 1u);
  BOOST_TEST((broken.status[100] == SC::Estimation_status::NON_FINITE_INPUT));

  const std::vector<Kernel::Point_3> points(3);
  BOOST_CHECK_THROW(SC::adaptive_curvatures(points), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(callback)
{
  const Surface_mesh mesh = surface_mesh_of(test_support::torus(1., .4, 36, 18, .2, 6));
  std::vector<double> advancements;
  BOOST_TEST(SC::adaptive_curvatures<CGAL::Sequential_tag>(mesh, SC::parameters::callback(
                                                                     [&](const double t)
                                                                     {
                                                                       advancements.push_back(t);
                                                                       return true;
                                                                     })) == 0u);
  BOOST_TEST_REQUIRE(!advancements.empty());
  BOOST_TEST(std::is_sorted(advancements.begin(), advancements.end()));
  BOOST_TEST(advancements.back() == 1.);

  int calls = 0;
  BOOST_TEST(SC::adaptive_curvatures<CGAL::Sequential_tag>(
                 mesh, SC::parameters::callback([&](double) { return ++calls < 3; })) ==
             mesh.number_of_vertices());
  BOOST_TEST(calls == 3);
}

// Each fit takes a quarter of what is left of the progress: it tells how many there were.
BOOST_AUTO_TEST_CASE(exact_normals_need_three_fits)
{
  const auto progress_before_the_end = [](const Data& data)
  {
    double progress = 0.;
    SC::adaptive_curvatures(data.mesh, SC::parameters::vertex_normal_map(data.normals)
                                           .callback(
                                               [&](const double p)
                                               {
                                                 if(p < 1.)
                                                   progress = (std::max)(progress, p);
                                                 return true;
                                               }));
    return progress;
  };
  const Analytic_surface fine = test_support::torus(1., .4, 120, 60, .2, 4),
                         coarse = test_support::torus(1., .4, 24, 12, .2, 4);
  const double of_three_fits = 1. - .75 * .75 * .75;
  BOOST_TEST(progress_before_the_end(Data(fine, Given::EXACT, 0.)) == of_three_fits);
  BOOST_TEST(progress_before_the_end(Data(coarse, Given::ESTIMATED, 0.)) > of_three_fits);
}

// hrbf_curvatures(): normals that are more exact than the points
BOOST_AUTO_TEST_CASE(normal_noise_level)
{
  const Data data(surfaces()[0], Given::EXACT, .05);
  const double trusted =
      answer(data, [](const auto& mesh, const auto& np, const auto&)
             { return SC::hrbf_curvatures(mesh, np.number_of_rings(3u).normal_noise_level(1e-3)); })
          .error;
  BOOST_TEST(trusted < .5 * hrbf(data, false, 3));
  for(const double wrong : {-1., std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(SC::hrbf_curvatures(data.mesh, SC::parameters::normal_noise_level(wrong)),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
