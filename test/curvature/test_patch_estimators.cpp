#include <boost/test/unit_test.hpp>

#include "estimator_checks.h"
#include "plain_triangle_tensors.h"

#include <Shape_characteristics/curvature/boschiroli_curvatures.h>
#include <Shape_characteristics/curvature/parametric_surface_curvatures.h>
#include <Shape_characteristics/curvature/zhihong_curvatures.h>
#include <Shape_characteristics/interpolation/Pn_triangle.h>
#include <Shape_characteristics/interpolation/Png1_triangle.h>

#include <CGAL/boost/graph/helpers.h>

#include "plain_algebra.h"
#include "raise_to.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(patch_estimators)

// The estimators that put a curved patch over each triangle at a vertex: Zhihong's (PN triangles, in their middles or at
// the vertex) and Boschiroli's (PNG1 triangles).
using namespace estimator_checks;

namespace {

enum class Method
{
  ZHIHONG,
  ZHIHONG_AT_VERTEX,
  ZHIHONG_UNIFORM,
  BOSCHIROLI
};

// One type for all: what the checks instantiate is compiled once.
struct Patch_estimator
{
  Method method;

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    if(method == Method::BOSCHIROLI)
      return SC::boschiroli_curvatures<Tag>(mesh, np);
    return SC::zhihong_curvatures<Tag>(mesh, np.patch_evaluation(evaluation()).face_weighting(weighting()));
  }
  template <typename Vertex, typename Mesh, typename Np>
  SC::Estimation_status one(Vertex v, const Mesh& mesh, const Np& np) const
  {
    if(method == Method::BOSCHIROLI)
      return SC::boschiroli_curvatures(v, mesh, np);
    return SC::zhihong_curvatures(v, mesh, np.patch_evaluation(evaluation()).face_weighting(weighting()));
  }

  SC::Patch_evaluation evaluation() const
  {
    return method == Method::ZHIHONG_AT_VERTEX ? SC::Patch_evaluation::VERTEX : SC::Patch_evaluation::CENTER;
  }
  SC::Face_weighting weighting() const
  {
    return method == Method::ZHIHONG_UNIFORM ? SC::Face_weighting::UNIFORM : SC::Face_weighting::AREA;
  }
};

const Patch_estimator zhihong{Method::ZHIHONG}, zhihong_at_vertex{Method::ZHIHONG_AT_VERTEX},
    zhihong_uniform{Method::ZHIHONG_UNIFORM}, boschiroli{Method::BOSCHIROLI};
const std::array<Patch_estimator, 3> all_methods = {zhihong, zhihong_at_vertex, boschiroli};

Kernel::Point_3 point(const Eigen::Vector3d& p)
{
  return Kernel::Point_3(p.x(), p.y(), p.z());
}
Kernel::Vector_3 vector(const Eigen::Vector3d& v)
{
  return Kernel::Vector_3(v.x(), v.y(), v.z());
}

// the shape operators of the public patches as tensors, turned by the shortest rotation, and their weighted mean
Eigen::Vector2d plain_zhihong(const Analytic_surface& s, std::size_t vertex, const Patch_estimator& estimator)
{
  const Eigen::Vector3d n = eigen(s.exact[vertex].normal);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double weights = 0.;
  for(const plain::Corner& c : plain::corners_at(s, vertex))
  {
    const SC::Pn_triangle<Kernel> patch({point(c.points[0]), point(c.points[1]), point(c.points[2])},
                                        {vector(c.normals[0]), vector(c.normals[1]), vector(c.normals[2])});
    const bool at_vertex = estimator.evaluation() == SC::Patch_evaluation::VERTEX;
    const std::array<double, 3> center = {1. / 3., 1. / 3., 1. / 3.}, corner = {1., 0., 0.};
    const auto d = patch.derivatives(at_vertex ? corner : center);
    const auto k = SC::parametric_surface_curvatures(d.u, d.v, d.uu, d.uv, d.vv);
    const Eigen::Vector3d normal = eigen(d.u).cross(eigen(d.v)).normalized();
    const Eigen::Matrix3d turn = test_support::shortest_rotation(normal, n);
    const Eigen::Vector3d a = turn * eigen(k.min_direction), b = turn * eigen(k.max_direction);
    const Eigen::Vector3d a_b = c.points[1] - c.points[0], a_c = c.points[2] - c.points[0];
    const double longest = std::max({a_b.norm(), a_c.norm(), (a_b - a_c).norm()});
    const double shape = (std::min)(1., 3. * a_b.cross(a_c).norm() / (longest * longest));
    const double weight =
        std::pow(shape, 4) *
        (estimator.weighting() == SC::Face_weighting::AREA ? plain::mixed_area(c.points) : 1.);
    sum += weight * (k.min_curvature * a * a.transpose() + k.max_curvature * b * b.transpose());
    weights += weight;
  }
  return plain::eigenvalues(sum / weights, n);
}

// the normal curvatures of the public patches, very near to the vertex and in many directions, and the quadratic form that
// fits them by QR
Eigen::Vector2d plain_boschiroli(const Analytic_surface& s, std::size_t vertex)
{
  const Eigen::Vector3d n = eigen(s.exact[vertex].normal), t1 = n.unitOrthogonal(), t2 = n.cross(t1);
  // the third corner of the triangle to the left of an edge
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> third;
  for(const auto& t : s.triangles)
    for(std::size_t k = 0; k < 3; ++k)
      third[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
  const auto p = [&](std::size_t i) { return point(eigen(s.points[i])); };
  const auto normal = [&](std::size_t i) { return vector(eigen(s.exact[i].normal)); };

  std::vector<Eigen::Vector4d> rows; // coefficients and curvature, both times the root of the weight
  for(const auto& t : s.triangles)
    for(std::size_t corner = 0; corner < 3; ++corner)
    {
      if(t[corner] != vertex)
        continue;
      const std::array<std::size_t, 3> v = {vertex, t[(corner + 1) % 3], t[(corner + 2) % 3]};
      SC::Png1_triangle<Kernel> patch({p(v[0]), p(v[1]), p(v[2])},
                                      {normal(v[0]), normal(v[1]), normal(v[2])});
      for(unsigned int i = 0; i < 3; ++i)
      {
        const auto found = third.find({v[(i + 2) % 3], v[(i + 1) % 3]});
        if(found != third.end())
          patch.set_neighbor(i, p(found->second), normal(found->second));
      }
      const auto at_corner = patch.derivatives({1., 0., 0.});
      const Eigen::Vector3d u = eigen(at_corner.u), w = eigen(at_corner.v);
      const double angle = std::acos(u.normalized().dot(w.normalized()));
      const int steps = 1000;
      for(int k = 0; k < steps; ++k)
      {
        const double a = angle * (k + .5) / steps;
        const double x = std::sin(angle - a) / (u.norm() * std::sin(angle)),
                     y = std::sin(a) / (w.norm() * std::sin(angle)), r = 1e-7 / (x + y);
        const auto d = patch.derivatives({1. - r * x - r * y, r * x, r * y});
        const Eigen::Vector3d direction = x * u + y * w;
        const Eigen::Vector3d second = x * x * eigen(d.uu) + 2. * x * y * eigen(d.uv) + y * y * eigen(d.vv);
        const double c = direction.dot(t1), q = direction.dot(t2);
        const double weight = std::sqrt(angle * (std::min)(1., 1. + std::cos(angle))) / (x + y);
        rows.push_back(weight * Eigen::Vector4d(c * c, 2. * c * q, q * q, -second.dot(n)));
      }
    }
  Eigen::MatrixXd a(rows.size(), 3);
  Eigen::VectorXd b(rows.size());
  for(std::size_t k = 0; k < rows.size(); ++k)
  {
    a.row(Eigen::Index(k)) = rows[k].head<3>();
    b[Eigen::Index(k)] = rows[k][3];
  }
  const Eigen::Vector3d x = test_support::least_squares(a, b);
  Eigen::Matrix2d m;
  m << x[0], x[1], x[1], x[2];
  return test_support::symmetric_eigenvalues(m);
}

std::function<Analytic_surface(unsigned int)> waves(double jitter)
{
  return [jitter](unsigned int f) { return test_support::waves(.1, 4., 1., 20 * f, jitter, 5); };
}

} // namespace

BOOST_AUTO_TEST_CASE(equal_plain_implementations)
{
  for(const Analytic_surface& s : test_support::all_analytic_surfaces(.2, 11))
  {
    const double unit = 1. / largest_curvature(s);
    const auto largest_difference =
        [&](const Patch_estimator& estimator, const std::function<Eigen::Vector2d(std::size_t)>& plain)
    {
      const Result result = run(estimator, s, Normals::EXACT);
      check_that_tips_alone_fail(s, result);
      double largest = 0.;
      for(std::size_t i = 0; i < s.points.size(); i += 17)
      {
        if(s.exact[i].singular)
          continue;
        const Eigen::Vector2d k = plain(i);
        test_support::raise_to(largest, unit * std::abs(result.curvatures[i].min_curvature - k[0]),
                               unit * std::abs(result.curvatures[i].max_curvature - k[1]));
      }
      return largest;
    };
    for(const Patch_estimator& estimator : {zhihong, zhihong_at_vertex, zhihong_uniform})
      BOOST_TEST(largest_difference(estimator,
                                    [&](std::size_t i) { return plain_zhihong(s, i, estimator); }) < 1e-11,
                 s.name);
    // near the corner, and sums instead of integrals
    const double of_boschiroli =
        largest_difference(boschiroli, [&](std::size_t i) { return plain_boschiroli(s, i); });
    BOOST_TEST(of_boschiroli < 1e-4, s.name << " " << of_boschiroli);
  }
}

BOOST_AUTO_TEST_CASE(planes_are_flat)
{
  for(const double jitter : {0., .2})
    for(const Patch_estimator& estimator : all_methods)
      for(const Curvatures& c :
          run(estimator, test_support::plane(1., 12, jitter, 3), Normals::EXACT).curvatures)
        BOOST_TEST((std::abs(c.min_curvature) < 1e-12 && std::abs(c.max_curvature) < 1e-12));
}

BOOST_AUTO_TEST_CASE(errors_per_vertex)
{
  BOOST_TEST_MESSAGE("Zhihong");
  check_errors(zhihong, 0., Normals::EXACT, 3., {.06, .02});
  check_errors(zhihong, 0., Normals::ESTIMATED, 3., {.08, .02});
  check_errors(zhihong, .2, Normals::EXACT, 3., {.13, .09});
  check_errors(zhihong, .2, Normals::ESTIMATED, 3., {.3, .2});
  BOOST_TEST_MESSAGE("Zhihong, at the vertex");
  check_errors(zhihong_at_vertex, 0., Normals::EXACT, 3., {.06, .02});
  check_errors(zhihong_at_vertex, .2, Normals::EXACT, 3., {.13, .08});
  BOOST_TEST_MESSAGE("Boschiroli");
  check_errors(boschiroli, 0., Normals::EXACT, 3., {.07, .02});
  check_errors(boschiroli, 0., Normals::ESTIMATED, 3., {.1, .03});
  check_errors(boschiroli, .2, Normals::EXACT, 3., {.11, .05});
  check_errors(boschiroli, .2, Normals::ESTIMATED, 3., {.85, .55});
}

BOOST_AUTO_TEST_CASE(convergence)
{
  for(const Patch_estimator& estimator : all_methods)
  {
    BOOST_TEST(convergence_order(estimator, torus_refined(0.), Normals::EXACT) > 1.8);
    BOOST_TEST(convergence_order(estimator, torus_refined(.2), Normals::EXACT) > 1.5);
    BOOST_TEST(convergence_order(estimator, waves(.2), Normals::EXACT, .5) > .9);
  }
  BOOST_TEST(convergence_order(boschiroli, torus_refined(.2), Normals::EXACT) > 1.8);
}

BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  for(const Patch_estimator& estimator : all_methods)
    check_motion_and_scale(estimator, 1e-10);
}
BOOST_AUTO_TEST_CASE(flipped_normals)
{
  for(const Patch_estimator& estimator : all_methods)
    check_flip(estimator);
}
BOOST_AUTO_TEST_CASE(order_of_the_input)
{
  for(const Patch_estimator& estimator : all_methods)
    check_permutation(estimator);
}
BOOST_AUTO_TEST_CASE(mesh_types)
{
  for(const Patch_estimator& estimator : all_methods)
    check_mesh_types(estimator);
}
BOOST_AUTO_TEST_CASE(threads)
{
  for(const Patch_estimator& estimator : all_methods)
    check_threads(estimator);
}
BOOST_AUTO_TEST_CASE(one_vertex)
{
  for(const Patch_estimator& estimator : all_methods)
    check_one_vertex(estimator);
}
BOOST_AUTO_TEST_CASE(callback)
{
  for(const Patch_estimator& estimator : all_methods)
    check_callback(estimator);
}

BOOST_AUTO_TEST_CASE(need_triangles)
{
  for(const Patch_estimator& estimator : all_methods)
    check_needs_triangles(estimator, SC::parameters::normal_weighting(SC::Normal_weighting::MAX));
}

BOOST_AUTO_TEST_CASE(useless_triangles_count_for_nothing)
{
  for(const Patch_estimator& estimator : all_methods)
    check_useless_triangles(estimator);
}

// An ear has one triangle: its patch is a whole surface, with a border all around.
BOOST_AUTO_TEST_CASE(borders)
{
  const Analytic_surface s = test_support::paraboloid(1., .5, .5, 16, .2, 3);
  for(const Patch_estimator& estimator : all_methods)
  {
    const Result result = run(estimator, s, Normals::EXACT);
    BOOST_TEST(result.failures == 0u);
    for(std::size_t i = 0; i < s.points.size(); ++i)
    {
      BOOST_TEST((result.status[i] ==
                  (s.exact[i].border ? SC::Estimation_status::BORDER : SC::Estimation_status::ESTIMATED)));
      BOOST_TEST(std::abs(result.curvatures[i].min_curvature - s.exact[i].k_min) < .1);
      BOOST_TEST(std::abs(result.curvatures[i].max_curvature - s.exact[i].k_max) < .1);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
