#ifndef SHAPE_CHARACTERISTICS_TEST_CURVATURE_ESTIMATOR_CHECKS_H
#define SHAPE_CHARACTERISTICS_TEST_CURVATURE_ESTIMATOR_CHECKS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/iterator.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include "analytic_surfaces.h"
#include "build_mesh.h"

#include <boost/test/tools/context.hpp>
#include <boost/test/unit_test.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What every estimator of curvature has to keep. An `Estimator` has
//   template <typename Tag, typename Mesh, typename Np> std::size_t all(const Mesh&, const Np&) const
//   template <typename Vertex, typename Mesh, typename Np> Estimation_status one(Vertex, const Mesh&, const Np&) const
namespace estimator_checks {

namespace SC = Shape_characteristics;
using test_support::Analytic_surface;
using test_support::Exact_vertex;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

struct Result
{
  std::vector<Curvatures> curvatures;
  std::vector<double> mean, Gaussian;
  std::vector<SC::Estimation_status> status;
  std::size_t failures = 0;
};

enum class Normals
{
  EXACT,
  ESTIMATED
};

inline Eigen::Vector3d eigen(const Kernel::Vector_3& v)
{
  return {v.x(), v.y(), v.z()};
}
inline Eigen::Vector3d eigen(const test_support::Vector& v)
{
  return {v[0], v[1], v[2]};
}

// the bits, so that NaN equals NaN and -0 differs from 0
inline bool same_bits(double a, double b)
{
  return std::memcmp(&a, &b, sizeof(double)) == 0;
}

inline bool same_bits(const Curvatures& a, const Curvatures& b)
{
  bool same = same_bits(a.min_curvature, b.min_curvature) && same_bits(a.max_curvature, b.max_curvature);
  for(int i = 0; i < 3; ++i)
    same = same && same_bits(a.min_direction[i], b.min_direction[i]) &&
           same_bits(a.max_direction[i], b.max_direction[i]);
  return same;
}

inline bool same_bits(const Result& a, const Result& b)
{
  if(a.curvatures.size() != b.curvatures.size() || a.failures != b.failures || a.status != b.status)
    return false;
  for(std::size_t i = 0; i < a.curvatures.size(); ++i)
    if(!same_bits(a.curvatures[i], b.curvatures[i]) || !same_bits(a.mean[i], b.mean[i]) ||
       !same_bits(a.Gaussian[i], b.Gaussian[i]))
      return false;
  return true;
}

// all vertices, of any type of mesh, with any type of property maps
template <typename Tag = CGAL::Sequential_tag, typename Estimator, typename Mesh>
Result run(const Estimator& estimator, const Mesh& mesh, const Analytic_surface& surface, Normals normals)
{
  const auto curvature_map = get(CGAL::dynamic_vertex_property_t<Curvatures>(), mesh);
  const auto mean_map = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  const auto Gaussian_map = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  const auto status_map = get(CGAL::dynamic_vertex_property_t<SC::Estimation_status>(), mesh);
  const auto normal_map = get(CGAL::dynamic_vertex_property_t<Kernel::Vector_3>(), mesh);
  const auto np = SC::parameters::vertex_principal_curvatures_and_directions_map(curvature_map)
                      .vertex_mean_curvature_map(mean_map)
                      .vertex_Gaussian_curvature_map(Gaussian_map)
                      .vertex_status_map(status_map);
  Result result;
  if(normals == Normals::EXACT)
  {
    std::size_t i = 0;
    for(const auto v : vertices(mesh))
    {
      const auto& n = surface.exact[i++].normal;
      put(normal_map, v, Kernel::Vector_3(n[0], n[1], n[2]));
    }
    result.failures = estimator.template all<Tag>(mesh, np.vertex_normal_map(normal_map));
  }
  else
    result.failures = estimator.template all<Tag>(mesh, np);
  for(const auto v : vertices(mesh))
  {
    result.curvatures.push_back(get(curvature_map, v));
    result.mean.push_back(get(mean_map, v));
    result.Gaussian.push_back(get(Gaussian_map, v));
    result.status.push_back(get(status_map, v));
  }
  return result;
}

template <typename Tag = CGAL::Sequential_tag, typename Estimator>
Result run(const Estimator& estimator, const Analytic_surface& surface, Normals normals)
{
  return run<Tag>(estimator, test_support::build_mesh<Surface_mesh>(surface), surface, normals);
}

// vertices whose distance to the apex of a cone, where the surface isn't smooth, or to the border is at least so
// many mean edges
inline std::vector<bool> far_from_singularities(const Analytic_surface& s, double edges)
{
  std::vector<bool> far(s.points.size(), true);
  const double limit = edges * s.mean_edge_length();
  for(std::size_t b = 0; b < s.points.size(); ++b)
    if(s.exact[b].border || s.exact[b].singular)
      for(std::size_t i = 0; i < s.points.size(); ++i)
        if((eigen(s.points[i]) - eigen(s.points[b])).norm() < limit)
          far[i] = false;
  return far;
}

struct Errors
{
  double mean = 0., largest = 0.; // of the curvatures, in units of the largest curvature of the surface
  double direction = 0.;          // the largest of sin(angle) * (k_max - k_min), in the same units
};

inline double largest_curvature(const Analytic_surface& s)
{
  double largest = 0.;
  for(const Exact_vertex& e : s.exact)
    if(!e.singular)
      largest = (std::max)({largest, std::abs(e.k_min), std::abs(e.k_max)});
  return largest > 0. ? largest : 1.;
}

// per vertex, of those farther than so many edges from the border and from singular vertices; checks statuses and
// directions of all of them
inline Errors errors(const Analytic_surface& s, const Result& result, double edges)
{
  const std::vector<bool> far = far_from_singularities(s, edges);
  const double unit = 1. / largest_curvature(s);
  Errors errors;
  std::size_t count = 0;
  for(std::size_t i = 0; i < s.points.size(); ++i)
  {
    const Exact_vertex& e = s.exact[i];
    const Curvatures& c = result.curvatures[i];
    if(!far[i])
      continue;
    BOOST_TEST_REQUIRE((result.status[i] == SC::Estimation_status::ESTIMATED));
    const double a = std::abs(c.min_curvature - e.k_min), b = std::abs(c.max_curvature - e.k_max);
    BOOST_TEST_REQUIRE((std::isfinite(a) && std::isfinite(b)));
    errors.mean += .5 * unit * (a + b);
    errors.largest = (std::max)({errors.largest, unit * a, unit * b});
    ++count;
    const double sine = eigen(c.max_direction).cross(eigen(e.d_max)).norm();
    errors.direction = (std::max)(errors.direction, unit * (e.k_max - e.k_min) * sine);
  }
  BOOST_TEST_REQUIRE(count > 0u);
  errors.mean /= double(count);
  return errors;
}

// what holds for any estimate: order, unit directions at right angles, mean and product (where they are not measured by
// themselves), NaN and count of those without one
inline void check_consistency(const Result& r, bool products_agree = true)
{
  std::size_t failures = 0;
  for(std::size_t i = 0; i < r.curvatures.size(); ++i)
  {
    const Curvatures& c = r.curvatures[i];
    if(!SC::is_estimated(r.status[i]))
    {
      ++failures;
      BOOST_TEST((std::isnan(c.min_curvature) && std::isnan(c.max_curvature) && std::isnan(r.mean[i]) &&
                  std::isnan(r.Gaussian[i]) && eigen(c.min_direction).hasNaN() &&
                  eigen(c.max_direction).hasNaN()));
      continue;
    }
    BOOST_TEST(c.min_curvature <= c.max_curvature);
    BOOST_TEST(std::abs(eigen(c.min_direction).norm() - 1.) < 1e-12);
    BOOST_TEST(std::abs(eigen(c.max_direction).norm() - 1.) < 1e-12);
    BOOST_TEST(std::abs(eigen(c.min_direction).dot(eigen(c.max_direction))) < 1e-12);
    if(products_agree)
    {
      BOOST_TEST(same_bits(r.mean[i], c.min_curvature / 2. + c.max_curvature / 2.));
      BOOST_TEST(same_bits(r.Gaussian[i], c.min_curvature * c.max_curvature));
    }
  }
  BOOST_TEST(failures == r.failures);
}

struct Bounds
{
  double largest, direction; // see Errors
};

// each vertex of each surface, but those nearer than so many edges to the border
template <typename Estimator>
void check_errors(const Estimator& estimator,
                  double jitter,
                  Normals normals,
                  double edges,
                  const Bounds& bounds,
                  bool products_agree = true)
{
  for(const Analytic_surface& s : test_support::all_analytic_surfaces(jitter, 2))
  {
    const Result result = run(estimator, s, normals);
    check_consistency(result, products_agree);
    BOOST_TEST(result.failures == 0u, s.name);
    const Errors e = errors(s, result, edges);
    BOOST_TEST_MESSAGE("  " << s.name << (normals == Normals::EXACT ? ", exact" : ", estimated") << ": mean "
                            << e.mean << ", largest " << e.largest << ", direction " << e.direction);
    BOOST_TEST(e.largest < bounds.largest, s.name << " " << e.largest);
    BOOST_TEST(e.direction < bounds.direction, s.name << " " << e.direction);
  }
}

// The power of the edge length with which the mean error of vertices farther than `distance` from the border falls,
// between `make(1)` and `make(4)`, which has edges a quarter as long.
template <typename Estimator>
double convergence_order(const Estimator& estimator,
                         const std::function<Analytic_surface(unsigned int)>& make,
                         Normals normals,
                         double distance = 0.)
{
  const auto mean_error = [&](const Analytic_surface& s)
  { return errors(s, run(estimator, s, normals), distance / s.mean_edge_length()).mean; };
  const Analytic_surface coarse = make(1), fine = make(4);
  const double coarse_error = mean_error(coarse), fine_error = mean_error(fine);
  const double order =
      std::log2(coarse_error / fine_error) / std::log2(coarse.mean_edge_length() / fine.mean_edge_length());
  BOOST_TEST_MESSAGE("  " << coarse.name << ": mean error " << coarse_error << " -> " << fine_error
                          << ", order " << order);
  return order;
}

inline Analytic_surface
transformed(Analytic_surface s, double scale, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& shift)
{
  const auto apply = [](test_support::Vector& v, const Eigen::Vector3d& w) { v = {w.x(), w.y(), w.z()}; };
  for(std::size_t i = 0; i < s.points.size(); ++i)
  {
    apply(s.points[i], rotation * (scale * eigen(s.points[i])) + shift);
    Exact_vertex& e = s.exact[i];
    apply(e.normal, rotation * eigen(e.normal));
    apply(e.d_min, rotation * eigen(e.d_min));
    apply(e.d_max, rotation * eigen(e.d_max));
    e.k_min /= scale;
    e.k_max /= scale;
  }
  return s;
}

// the largest difference of `b`, of a transformed surface, from `a`, in units of the largest curvature
inline double difference(const Analytic_surface& s,
                         const Result& a,
                         const Result& b,
                         double scale,
                         const Eigen::Matrix3d& rotation)
{
  const double unit = 1. / largest_curvature(s);
  double largest = 0.;
  BOOST_TEST_REQUIRE((a.status == b.status));
  for(std::size_t i = 0; i < a.curvatures.size(); ++i)
  {
    if(!SC::is_estimated(a.status[i]))
      continue;
    const Curvatures &c = a.curvatures[i], &d = b.curvatures[i];
    const double sine = (rotation * eigen(c.max_direction)).cross(eigen(d.max_direction)).norm();
    largest = (std::max)({largest, unit * std::abs(c.min_curvature - scale * d.min_curvature),
                          unit * std::abs(c.max_curvature - scale * d.max_curvature),
                          unit * std::abs(c.max_curvature - c.min_curvature) * sine});
  }
  return largest;
}

// closed, with a border, and of all types of points
inline std::vector<Analytic_surface> typical_surfaces()
{
  return {test_support::ellipsoid(1., .8, .6, 2, .2, 5), test_support::torus(1., .4, 24, 12, .2, 6),
          test_support::monkey_saddle(.5, 10, .2, 7), test_support::cylinder(1., 2., 16, 6, .1, 8)};
}

template <typename Estimator>
void check_motion_and_scale(const Estimator& estimator, double tolerance)
{
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1., 2., -1.5).normalized()).toRotationMatrix();
  for(const Analytic_surface& s : typical_surfaces())
    for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
    {
      const Result original = run(estimator, s, normals);
      const auto check =
          [&](const char* what, double scale, const Eigen::Matrix3d& r, const Eigen::Vector3d& shift)
      {
        BOOST_TEST_CONTEXT(s.name << ", " << what << ", "
                                  << (normals == Normals::EXACT ? "exact" : "estimated"))
        {
          const double largest =
              difference(s, original, run(estimator, transformed(s, scale, r, shift), normals), scale, r);
          BOOST_TEST(largest < tolerance);
        }
      };
      check("turned and moved", 1., rotation, {3., -5., 2.});
      for(const double scale : {1e-6, 1e6, 1e-100, 1e100})
        check("scaled", scale, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
    }
}

// the same curvatures, with the signs and the order changed, bit for bit
template <typename Estimator>
void check_flip(const Estimator& estimator)
{
  for(const Analytic_surface& s : typical_surfaces())
  {
    const Result outward = run(estimator, s, Normals::EXACT);
    Analytic_surface flipped = s;
    for(Exact_vertex& e : flipped.exact)
      e.normal = {-e.normal[0], -e.normal[1], -e.normal[2]};
    const Result inward = run(estimator, flipped, Normals::EXACT);
    BOOST_TEST((inward.status == outward.status));
    bool same = true;
    for(std::size_t i = 0; i < s.points.size(); ++i)
    {
      const Curvatures &a = outward.curvatures[i], &b = inward.curvatures[i];
      if(SC::is_estimated(outward.status[i]))
        same = same && a.min_curvature == -b.max_curvature && a.max_curvature == -b.min_curvature &&
               outward.mean[i] == -inward.mean[i] && outward.Gaussian[i] == inward.Gaussian[i];
    }
    BOOST_TEST(same, s.name);
  }
}

// vertices and faces in another order, faces that begin with another vertex: the same bits
template <typename Estimator>
void check_permutation(const Estimator& estimator)
{
  std::mt19937 random(42);
  for(const Analytic_surface& s : typical_surfaces())
    for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
    {
      std::vector<std::size_t> order(s.points.size()); // place -> vertex
      std::iota(order.begin(), order.end(), std::size_t(0));
      std::shuffle(order.begin(), order.end(), random);
      Analytic_surface shuffled = s;
      std::vector<std::size_t> place(order.size());
      for(std::size_t k = 0; k < order.size(); ++k)
      {
        place[order[k]] = k;
        shuffled.points[k] = s.points[order[k]];
        shuffled.exact[k] = s.exact[order[k]];
      }
      for(auto& t : shuffled.triangles)
      {
        for(auto& v : t)
          v = place[v];
        std::rotate(t.begin(), t.begin() + std::ptrdiff_t(random() % 3), t.end());
      }
      std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);

      const Result a = run(estimator, s, normals), b = run(estimator, shuffled, normals);
      bool same = a.failures == b.failures;
      for(std::size_t k = 0; k < order.size(); ++k)
        same =
            same && a.status[order[k]] == b.status[k] && same_bits(a.curvatures[order[k]], b.curvatures[k]);
      BOOST_TEST(same, s.name);
    }
}

// one result, bit for bit, on CGAL's types of meshes
template <typename Estimator>
void check_mesh_types(const Estimator& estimator)
{
  for(const Analytic_surface& s : typical_surfaces())
    for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
    {
      const Result expected = run(estimator, s, normals);
      BOOST_TEST(same_bits(expected, run(estimator, test_support::build_mesh<Polyhedron>(s), s, normals)),
                 s.name);
      BOOST_TEST(
          same_bits(expected, run(estimator, test_support::build_mesh<Polyhedron_with_ids>(s), s, normals)),
          s.name);
    }
}

// one result, bit for bit, with any number of threads
template <typename Estimator>
void check_threads(const Estimator& estimator)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Analytic_surface s = test_support::torus(1., .4, 48, 24, .2, 6); // 9 blocks of samples
  for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
  {
    const Result expected = run(estimator, s, normals);
    for(const std::size_t threads : {1, 2, 4})
    {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      BOOST_TEST(same_bits(expected, run<CGAL::Parallel_tag>(estimator, s, normals)), threads << " threads");
    }
  }
#else
  (void)estimator;
  BOOST_TEST_MESSAGE("  skipped: built without TBB");
#endif
}

// each vertex by itself: the bits of the whole mesh
template <typename Estimator>
void check_one_vertex(const Estimator& estimator)
{
  for(const Analytic_surface& s : typical_surfaces())
  {
    const Surface_mesh mesh = test_support::build_mesh<Surface_mesh>(s);
    for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
    {
      const Result all = run(estimator, mesh, s, normals);
      Result one;
      one.failures = all.failures;
      const auto normal_map = get(CGAL::dynamic_vertex_property_t<Kernel::Vector_3>(), mesh);
      for(const auto v : vertices(mesh))
      {
        const auto& n = s.exact[v.idx()].normal;
        put(normal_map, v, Kernel::Vector_3(n[0], n[1], n[2]));
      }
      for(const auto v : vertices(mesh))
      {
        Curvatures c;
        double mean, Gaussian;
        const auto np = SC::parameters::vertex_principal_curvatures_and_directions(std::ref(c))
                            .vertex_mean_curvature(std::ref(mean))
                            .vertex_Gaussian_curvature(std::ref(Gaussian));
        one.status.push_back(normals == Normals::EXACT
                                 ? estimator.one(v, mesh, np.vertex_normal_map(normal_map))
                                 : estimator.one(v, mesh, np));
        one.curvatures.push_back(c);
        one.mean.push_back(mean);
        one.Gaussian.push_back(Gaussian);
      }
      BOOST_TEST(same_bits(all, one), s.name);
    }
  }
}

// the advancement grows to 1; false stops before the rest, which is CANCELLED
template <typename Estimator>
void check_callback(const Estimator& estimator)
{
  const Analytic_surface s = test_support::torus(1., .4, 48, 24, .2, 6);
  Surface_mesh mesh = test_support::build_mesh<Surface_mesh>(s);
  const auto status_map = get(CGAL::dynamic_vertex_property_t<SC::Estimation_status>(), mesh);
  std::vector<double> advancements;
  const auto parameters = SC::parameters::vertex_status_map(status_map);
  BOOST_TEST(estimator.template all<CGAL::Sequential_tag>(mesh, parameters.callback(
                                                                    [&](double t)
                                                                    {
                                                                      advancements.push_back(t);
                                                                      return true;
                                                                    })) == 0u);
  BOOST_TEST_REQUIRE(!advancements.empty());
  BOOST_TEST(std::is_sorted(advancements.begin(), advancements.end()));
  BOOST_TEST(advancements.back() == 1.);
  const std::size_t failures =
      estimator.template all<CGAL::Sequential_tag>(mesh, parameters.callback([](double) { return false; }));
  std::size_t cancelled = 0;
  for(const auto v : vertices(mesh))
    cancelled += get(status_map, v) == SC::Estimation_status::CANCELLED;
  BOOST_TEST(cancelled > 0u);
  BOOST_TEST(cancelled < s.points.size());
  BOOST_TEST(cancelled == failures);
}

// a face that is no triangle is refused, with a text that says so
template <typename Estimator, typename NamedParameters>
void check_needs_triangles(const Estimator& estimator, const NamedParameters& np)
{
  Surface_mesh quad;
  CGAL::make_quad(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                  Kernel::Point_3(0, 1, 0), quad);
  BOOST_CHECK_EXCEPTION(estimator.template all<CGAL::Sequential_tag>(quad, np), std::invalid_argument,
                        [](const std::invalid_argument& e)
                        { return std::string(e.what()).find("triangle") != std::string::npos; });
  BOOST_CHECK_THROW(estimator.one(*vertices(quad).begin(), quad, np), std::invalid_argument);
}

// A triangle without area, or with a point that is not finite, changes nothing for its neighbors' other triangles. Returns the
// statuses of the neighbors of the point that isn't.
template <typename Estimator>
std::vector<SC::Estimation_status> check_useless_triangles(const Estimator& estimator)
{
  const Analytic_surface s = test_support::sphere(1., 2, .2, 9);
  Surface_mesh mesh = test_support::build_mesh<Surface_mesh>(s);
  const Surface_mesh::Vertex_index v(0);
  std::vector<std::size_t> at_v;
  for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
    at_v.push_back(mesh.source(h));
  mesh.point(v) = mesh.point(mesh.source(mesh.halfedge(v)));
  const Result collapsed = run(estimator, mesh, s, Normals::EXACT);
  for(std::size_t i = 0; i < s.points.size(); ++i)
    BOOST_TEST(
        (std::isfinite(collapsed.curvatures[i].min_curvature) && SC::is_estimated(collapsed.status[i])));

  mesh.point(v) = Kernel::Point_3(std::nan(""), 0., 0.);
  const Result broken = run(estimator, mesh, s, Normals::EXACT);
  BOOST_TEST((broken.status[0] == SC::Estimation_status::NON_FINITE_INPUT));
  BOOST_TEST(broken.failures == 1u);
  std::vector<SC::Estimation_status> of_neighbors;
  for(const std::size_t i : at_v)
  {
    BOOST_TEST(std::abs(broken.mean[i] - 1.) < .3);
    of_neighbors.push_back(broken.status[i]);
  }
  return of_neighbors;
}

} // namespace estimator_checks

#endif // SHAPE_CHARACTERISTICS_TEST_CURVATURE_ESTIMATOR_CHECKS_H
