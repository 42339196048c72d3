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
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include "Curvature_estimates.h"
#include "analytic_surfaces.h"
#include "says.h"

#include <boost/test/test_tools.hpp>
#include <boost/test/tools/context.hpp>
#include <boost/test/unit_test_log.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

// What every estimator of curvature has to keep. An `Estimator` has
//   template <typename Tag, typename Mesh, typename Np> std::size_t all(const Mesh&, const Np&) const
//   template <typename Vertex, typename Mesh, typename Np> Estimation_status one(Vertex, const Mesh&, const Np&) const
// What the checks do with it is in a library, compiled once; the templates of this file make one type of all of them.
namespace estimator_checks {

namespace SC = Shape_characteristics;
using test_support::Analytic_surface;
using test_support::Exact_vertex;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;
using Result = test_support::Curvature_estimates;

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
bool same_bits(double a, double b);
bool same_bits(const Curvatures& a, const Curvatures& b);
bool same_bits(const Result& a, const Result& b);

Surface_mesh surface_mesh_of(const Analytic_surface& s);
Polyhedron polyhedron_of(const Analytic_surface& s);
Polyhedron_with_ids polyhedron_with_ids_of(const Analytic_surface& s);

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
  return run<Tag>(estimator, surface_mesh_of(surface), surface, normals);
}

// Any estimator as one type, run on a mesh and what it was made of. Keeps a reference.
class Run
{
public:
  template <typename Estimator, typename Tag = CGAL::Sequential_tag>
  Run(const Estimator& estimator, Tag = Tag())
    : m_function([&estimator](const Surface_mesh& mesh, const Analytic_surface& surface, Normals normals)
                 { return run<Tag>(estimator, mesh, surface, normals); })
  {}

  Result operator()(const Surface_mesh& mesh, const Analytic_surface& surface, Normals normals) const
  {
    return m_function(mesh, surface, normals);
  }

private:
  std::function<Result(const Surface_mesh&, const Analytic_surface&, Normals)> m_function;
};

// vertices whose distance to the apex of a cone, where the surface isn't smooth, or to the border is at least so
// many mean edges
std::vector<bool> far_from_singularities(const Analytic_surface& s, double edges);

struct Errors
{
  double mean = 0., largest = 0.; // of the curvatures, in units of the largest curvature of the surface
  double direction = 0.;          // the largest of sin(angle) * (k_max - k_min), in the same units
};

double largest_curvature(const Analytic_surface& s);

// per vertex, of those farther than so many edges from the border and from singular vertices; checks statuses and
// directions of all of them
Errors errors(const Analytic_surface& s, const Result& result, double edges);

// what holds for any estimate: order, unit directions at right angles, mean and product (where they are not measured by
// themselves), NaN and count of those without one
void check_consistency(const Result& r, bool products_agree = true);

struct Bounds
{
  double largest, direction; // see Errors
};

// Nothing but the tips of cones may be without an estimate.
void check_that_tips_alone_fail(const Analytic_surface& s, const Result& result);

// each vertex of each surface, but those nearer than so many edges to the border
void check_errors(const Run& estimator,
                  double jitter,
                  Normals normals,
                  double edges,
                  const Bounds& bounds,
                  bool products_agree = true);

// The power of the edge length with which the mean error of vertices farther than `distance` from the border falls,
// between `make(1)` and `make(4)`, which has edges a quarter as long.
double convergence_order(const Run& estimator,
                         const std::function<Analytic_surface(unsigned int)>& make,
                         Normals normals,
                         double distance = 0.);

// for convergence_order()
std::function<Analytic_surface(unsigned int)> torus_refined(double jitter);

Analytic_surface
transformed(Analytic_surface s, double scale, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& shift);

// the largest difference of `b`, of a transformed surface, from `a`, in units of the largest curvature
double difference(const Analytic_surface& s,
                  const Result& a,
                  const Result& b,
                  double scale,
                  const Eigen::Matrix3d& rotation);

// closed, with a border, and of all types of points
std::vector<Analytic_surface> typical_surfaces();

void check_motion_and_scale(const Run& estimator, double tolerance);

// the same curvatures, with the signs and the order changed, bit for bit
void check_flip(const Run& estimator);

// vertices and faces in another order, faces that begin with another vertex: the same bits
void check_permutation(const Run& estimator);

// one result, bit for bit, on CGAL's types of meshes
template <typename Estimator>
void check_mesh_types(const Estimator& estimator)
{
  for(const Analytic_surface& s : typical_surfaces())
    for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
    {
      const Result expected = run(estimator, s, normals);
      const bool same = same_bits(expected, run(estimator, polyhedron_of(s), s, normals));
      const bool same_with_ids = same_bits(expected, run(estimator, polyhedron_with_ids_of(s), s, normals));
      BOOST_TEST(same, s.name);
      BOOST_TEST(same_with_ids, s.name);
    }
}

// one result, bit for bit, with any number of threads
void check_threads(const Run& sequential, const Run& parallel, const Analytic_surface& s);

template <typename Estimator>
void check_threads(
    const Estimator& estimator,
    const Analytic_surface& s = test_support::torus(1., .4, 48, 24, .2, 6)) // 9 blocks of samples
{
#ifdef CGAL_LINKED_WITH_TBB
  check_threads(Run(estimator), Run(estimator, CGAL::Parallel_tag()), s);
#else
  (void)estimator;
  (void)s;
  BOOST_TEST_MESSAGE("  skipped: built without TBB");
#endif
}

// each vertex by itself: the bits of the whole mesh
template <typename Estimator>
void check_one_vertex(const Estimator& estimator)
{
  for(const Analytic_surface& s : typical_surfaces())
  {
    const Surface_mesh mesh = surface_mesh_of(s);
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
      const bool same = same_bits(all, one);
      BOOST_TEST(same, s.name);
    }
  }
}

using Status_map =
    boost::property_map<Surface_mesh, CGAL::dynamic_vertex_property_t<SC::Estimation_status>>::const_type;

using Run_with_callback =
    std::function<std::size_t(const Surface_mesh&, Status_map, const std::function<bool(double)>&)>;

// the advancement grows to 1; false stops before the rest, which is CANCELLED
void check_callback(const Run_with_callback& estimator);

template <typename Estimator>
void check_callback(const Estimator& estimator)
{
  check_callback(Run_with_callback(
      [&](const Surface_mesh& mesh, Status_map status_map, const std::function<bool(double)>& callback)
      {
        return estimator.template all<CGAL::Sequential_tag>(
            mesh, SC::parameters::vertex_status_map(status_map).callback(callback));
      }));
}

// [0, 1]^2 as one face
Surface_mesh quadrilateral();

// a face that is no triangle is refused, with a text that says so
template <typename Estimator, typename NamedParameters>
void check_needs_triangles(const Estimator& estimator, const NamedParameters& np)
{
  const Surface_mesh quad = quadrilateral();
  BOOST_CHECK_EXCEPTION(estimator.template all<CGAL::Sequential_tag>(quad, np), std::invalid_argument,
                        test_support::says("triangle"));
  BOOST_CHECK_THROW(estimator.one(*vertices(quad).begin(), quad, np), std::invalid_argument);
}

// A triangle without area, or with a point that is not finite, changes nothing for its neighbors' other triangles. Returns the
// statuses of the neighbors of the point that isn't.
std::vector<SC::Estimation_status> check_useless_triangles(const Run& estimator);

} // namespace estimator_checks

#endif // SHAPE_CHARACTERISTICS_TEST_CURVATURE_ESTIMATOR_CHECKS_H
