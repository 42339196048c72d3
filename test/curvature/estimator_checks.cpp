#include "estimator_checks.h"

#include "build_mesh.h"
#include "raise_to.h"

#include <CGAL/boost/graph/generators.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <utility>

namespace estimator_checks {

namespace {

Result run(const Run& estimator, const Analytic_surface& s, Normals normals)
{
  return estimator(surface_mesh_of(s), s, normals);
}

} // namespace

bool same_bits(double a, double b)
{
  return std::memcmp(&a, &b, sizeof(double)) == 0;
}

bool same_bits(const Curvatures& a, const Curvatures& b)
{
  bool same = same_bits(a.min_curvature, b.min_curvature) && same_bits(a.max_curvature, b.max_curvature);
  for(int i = 0; i < 3; ++i)
    same = same && same_bits(a.min_direction[i], b.min_direction[i]) &&
           same_bits(a.max_direction[i], b.max_direction[i]);
  return same;
}

bool same_bits(const Result& a, const Result& b)
{
  if(a.curvatures.size() != b.curvatures.size() || a.failures != b.failures || a.status != b.status)
    return false;
  for(std::size_t i = 0; i < a.curvatures.size(); ++i)
    if(!same_bits(a.curvatures[i], b.curvatures[i]) || !same_bits(a.mean[i], b.mean[i]) ||
       !same_bits(a.Gaussian[i], b.Gaussian[i]))
      return false;
  return true;
}

Surface_mesh surface_mesh_of(const Analytic_surface& s)
{
  return test_support::build_mesh<Surface_mesh>(s);
}

Polyhedron polyhedron_of(const Analytic_surface& s)
{
  return test_support::build_mesh<Polyhedron>(s);
}

Polyhedron_with_ids polyhedron_with_ids_of(const Analytic_surface& s)
{
  return test_support::build_mesh<Polyhedron_with_ids>(s);
}

std::vector<bool> far_from_singularities(const Analytic_surface& s, double edges)
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

double largest_curvature(const Analytic_surface& s)
{
  double largest = 0.;
  for(const Exact_vertex& e : s.exact)
    if(!e.singular)
      test_support::raise_to(largest, std::abs(e.k_min), std::abs(e.k_max));
  return largest > 0. ? largest : 1.;
}

Errors errors(const Analytic_surface& s, const Result& result, double edges)
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
    test_support::raise_to(errors.largest, unit * a, unit * b);
    ++count;
    const double sine = eigen(c.max_direction).cross(eigen(e.d_max)).norm();
    test_support::raise_to(errors.direction, unit * (e.k_max - e.k_min) * sine);
  }
  BOOST_TEST_REQUIRE(count > 0u);
  errors.mean /= double(count);
  return errors;
}

void check_consistency(const Result& r, bool products_agree)
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

void check_that_tips_alone_fail(const Analytic_surface& s, const Result& result)
{
  for(std::size_t i = 0; i < s.points.size(); ++i)
    if(!SC::is_estimated(result.status[i]))
      BOOST_TEST((s.exact[i].singular && result.status[i] == SC::Estimation_status::DEGENERATE),
                 s.name << ", vertex " << i << ": " << SC::to_string(result.status[i]));
}

void check_errors(const Run& estimator,
                  double jitter,
                  Normals normals,
                  double edges,
                  const Bounds& bounds,
                  bool products_agree)
{
  for(const Analytic_surface& s : test_support::all_analytic_surfaces(jitter, 2))
  {
    const Result result = run(estimator, s, normals);
    check_consistency(result, products_agree);
    check_that_tips_alone_fail(s, result);
    const Errors e = errors(s, result, edges);
    BOOST_TEST_MESSAGE("  " << s.name << (normals == Normals::EXACT ? ", exact" : ", estimated") << ": mean "
                            << e.mean << ", largest " << e.largest << ", direction " << e.direction);
    BOOST_TEST(e.largest < bounds.largest, s.name << " " << e.largest);
    BOOST_TEST(e.direction < bounds.direction, s.name << " " << e.direction);
  }
}

double convergence_order(const Run& estimator,
                         const std::function<Analytic_surface(unsigned int)>& make,
                         Normals normals,
                         double distance)
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

std::function<Analytic_surface(unsigned int)> torus_refined(double jitter)
{
  return [jitter](unsigned int f) { return test_support::torus(1., .4, 24 * f, 12 * f, jitter, 4); };
}

Analytic_surface
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

double difference(const Analytic_surface& s,
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
    test_support::raise_to(largest, unit * std::abs(c.min_curvature - scale * d.min_curvature),
                           unit * std::abs(c.max_curvature - scale * d.max_curvature),
                           unit * std::abs(c.max_curvature - c.min_curvature) * sine);
  }
  return largest;
}

std::vector<Analytic_surface> typical_surfaces()
{
  return {test_support::ellipsoid(1., .8, .6, 2, .2, 5), test_support::torus(1., .4, 24, 12, .2, 6),
          test_support::monkey_saddle(.5, 10, .2, 7), test_support::cylinder(1., 2., 16, 6, .1, 8)};
}

void check_motion_and_scale(const Run& estimator, double tolerance)
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

void check_flip(const Run& estimator)
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

void check_permutation(const Run& estimator)
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

void check_threads(const Run& sequential, const Run& parallel, const Analytic_surface& s)
{
  for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
  {
    const Result expected = run(sequential, s, normals);
    for(const std::size_t threads : {1, 2, 4})
    {
#ifdef CGAL_LINKED_WITH_TBB
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#endif
      BOOST_TEST(same_bits(expected, run(parallel, s, normals)), threads << " threads");
    }
  }
}

void check_callback(const Run_with_callback& estimator)
{
  const Analytic_surface s = test_support::torus(1., .4, 48, 24, .2, 6);
  const Surface_mesh mesh = surface_mesh_of(s);
  const Status_map status_map = get(CGAL::dynamic_vertex_property_t<SC::Estimation_status>(), mesh);
  std::vector<double> advancements;
  BOOST_TEST(estimator(mesh, status_map,
                       [&](double t)
                       {
                         advancements.push_back(t);
                         return true;
                       }) == 0u);
  BOOST_TEST_REQUIRE(!advancements.empty());
  BOOST_TEST(std::is_sorted(advancements.begin(), advancements.end()));
  BOOST_TEST(advancements.back() == 1.);
  const std::size_t failures = estimator(mesh, status_map, [](double) { return false; });
  std::size_t cancelled = 0;
  for(const auto v : vertices(mesh))
    cancelled += get(status_map, v) == SC::Estimation_status::CANCELLED;
  BOOST_TEST(cancelled > 0u);
  BOOST_TEST(cancelled < s.points.size());
  BOOST_TEST(cancelled == failures);
}

Surface_mesh quadrilateral()
{
  Surface_mesh quad;
  CGAL::make_quad(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                  Kernel::Point_3(0, 1, 0), quad);
  return quad;
}

std::vector<SC::Estimation_status> check_useless_triangles(const Run& estimator)
{
  const Analytic_surface s = test_support::sphere(1., 2, .2, 9);
  Surface_mesh mesh = surface_mesh_of(s);
  const Surface_mesh::Vertex_index v(0);
  std::vector<std::size_t> at_v;
  for(const auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
    at_v.push_back(mesh.source(h));
  mesh.point(v) = mesh.point(mesh.source(mesh.halfedge(v)));
  const Result collapsed = estimator(mesh, s, Normals::EXACT);
  for(std::size_t i = 0; i < s.points.size(); ++i)
    BOOST_TEST(
        (std::isfinite(collapsed.curvatures[i].min_curvature) && SC::is_estimated(collapsed.status[i])));

  mesh.point(v) = Kernel::Point_3(std::nan(""), 0., 0.);
  const Result broken = estimator(mesh, s, Normals::EXACT);
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
