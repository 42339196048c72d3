#include <boost/test/unit_test.hpp>

#include "height_field.h"
#include "oriented_cloud.h"

#include <Shape_characteristics/descriptors/Spin_image_descriptor.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/descriptors/spin_image_descriptors.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include "analytic_surfaces.h"
#include "build_mesh.h"
#include "raise_to.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(spin_images)

using namespace oriented_cloud;
using Real = long double;
using S = SC::Estimation_status;

namespace {

constexpr double pi = CGAL_PI, radius = .4;

SC::Descriptor_matrix spin_images(const Cloud& cloud,
                                  const SC::Neighborhood& neighborhood = SC::Neighborhood::ball(radius),
                                  unsigned int width = 8,
                                  double support_angle = pi / 2.)
{
  const SC::Point_set_samples samples = samples_of(cloud, neighborhood);
  return SC::compute_descriptors(
      SC::Spin_image_descriptor<SC::Point_set_samples>(samples, width, support_angle), samples.size());
}

// the weight of a node at `node`, in one direction, of something at `t`
Real hat(Real t, Real node)
{
  return (std::max)(Real(0), 1 - std::abs(t - node));
}

// Adds what is at (`alpha`, `beta`), in units of cells, to each value of the image.
void add(std::vector<Real>& image, unsigned int width, Real alpha, Real beta, Real weight)
{
  const int w = int(width);
  std::size_t k = 0;
  for(int i = 0; i <= w; ++i)
    for(int j = -w; j <= w; ++j)
      image[k++] += weight * hat(alpha, i) * hat(beta, j);
}

std::vector<Real> in_percent(std::vector<Real> image)
{
  Real sum = 0;
  for(const Real x : image)
    sum += x;
  for(Real& x : image)
    x *= 100 / sum;
  return image;
}

// by distances alone, over all points
std::vector<Real>
plain_spin_image(const Cloud& cloud, std::size_t i, double r, unsigned int width, double support_angle)
{
  using Vector = Eigen::Matrix<Real, 3, 1>;
  const Vector p = cloud.points[i].cast<Real>(), n = cloud.normals[i].cast<Real>();
  const Real cell = Real(r) / (std::sqrt(Real(2)) * width);
  std::vector<Real> image((width + 1) * (2 * width + 1));
  for(std::size_t j = 0; j < cloud.points.size(); ++j)
  {
    const Vector d = cloud.points[j].cast<Real>() - p;
    const Real angle = std::acos((std::min)(Real(1), n.dot(cloud.normals[j].cast<Real>())));
    if(j == i || d.norm() > r || angle > support_angle)
      continue;
    const Real beta = n.dot(d), alpha = std::sqrt((std::max)(Real(0), d.squaredNorm() - beta * beta));
    if(alpha <= width * cell && std::abs(beta) <= width * cell)
      add(image, width, alpha / cell, beta / cell, 1);
  }
  return in_percent(image);
}

double difference_of_row(const SC::Descriptor_matrix& m, std::size_t row, const std::vector<Real>& expected)
{
  Real largest = 0;
  for(std::size_t k = 0; k < expected.size(); ++k)
    test_support::raise_to(largest,
                           std::abs(Real(m.values(Eigen::Index(row), Eigen::Index(k))) - expected[k]));
  return double(largest);
}

// evenly spread
Cloud sphere(std::size_t count, double r)
{
  Cloud cloud;
  for(std::size_t i = 0; i < count; ++i)
  {
    const double z = 1. - (2. * double(i) + 1.) / double(count), a = pi * (3. - std::sqrt(5.)) * double(i);
    const double s = std::sqrt(1. - z * z);
    cloud.normals.emplace_back(s * std::cos(a), s * std::sin(a), z);
    cloud.points.push_back(r * cloud.normals.back());
  }
  return cloud;
}

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_plain_loops)
{
  const Cloud cloud = wavy_cloud(200, 5);
  for(const unsigned int width : {1u, 5u, 8u})
    for(const double support_angle : {.3, pi / 2., pi})
    {
      const SC::Descriptor_matrix m =
          spin_images(cloud, SC::Neighborhood::ball(radius), width, support_angle);
      BOOST_TEST(is_consistent(m));
      BOOST_TEST(m.values.cols() == Eigen::Index((width + 1) * (2 * width + 1)));
      BOOST_TEST(number_of(S::ESTIMATED, m) > 190u);
      double worst = 0.;
      for(std::size_t i = 0; i < cloud.points.size(); ++i)
        if(SC::is_estimated(m.status[i]))
          test_support::raise_to(
              worst, difference_of_row(m, i, plain_spin_image(cloud, i, radius, width, support_angle)));
      BOOST_TEST(worst < 1e-5);
    }
}

// The area of a sphere within the distance s of a point of it is pi s^2, whatever its radius: half of the neighbors are farther
// away than the root of a half.
BOOST_AUTO_TEST_CASE(of_a_sphere)
{
  constexpr double r = 1.3, ball = .8;
  constexpr unsigned int width = 8;
  const double cell = ball / (std::sqrt(2.) * width);
  std::vector<Real> image((width + 1) * (2 * width + 1));
  constexpr int steps = 20000;
  for(int k = 0; k < steps; ++k)
  {
    const double s = ball * std::sqrt((k + .5) / steps), beta = -s * s / (2. * r),
                 alpha = std::sqrt(s * s - beta * beta);
    if(alpha <= width * cell)
      add(image, width, alpha / cell, beta / cell, 1);
  }
  const std::vector<Real> expected = in_percent(image);
  std::vector<double> errors;
  for(const std::size_t count : {2000, 32000})
  {
    const SC::Point_set_samples samples = samples_of(sphere(count, r), SC::Neighborhood::ball(ball));
    std::vector<std::size_t> some;
    for(std::size_t i = 0; i < count; i += count / 200)
      some.push_back(i);
    const SC::Descriptor_matrix m =
        SC::compute_descriptors(SC::Spin_image_descriptor<SC::Point_set_samples>(samples), some);
    double worst = 0.;
    for(std::size_t k = 0; k < some.size(); ++k)
      test_support::raise_to(worst, difference_of_row(m, k, expected));
    errors.push_back(worst);
  }
  BOOST_TEST(errors[0] < 3.); // of a hundred, with some 190 neighbors
  BOOST_TEST(errors[1] < .2 * errors[0]);
}

BOOST_AUTO_TEST_CASE(moved_scaled_mirrored_flipped_and_permuted)
{
  const Cloud cloud = wavy_cloud(400, 7);
  const SC::Descriptor_matrix m = spin_images(cloud);
  for(const double scale : {1e-6, 1., 1e6})
    BOOST_TEST(difference(spin_images(moved(cloud, scale, some_rotation(), scale * Vector3d(30., -10., 20.)),
                                      SC::Neighborhood::ball(scale * radius)),
                          m) < 1e-4);
  BOOST_TEST(
      same_bits(spin_images(moved(cloud, std::ldexp(1., 40), Eigen::Matrix3d::Identity(), Vector3d::Zero()),
                            SC::Neighborhood::ball(std::ldexp(radius, 40))),
                m));
  BOOST_TEST(same_bits(spin_images(mirrored(cloud)), m));

  SC::Descriptor_matrix expected = m;
  for(Eigen::Index i = 0; i < m.values.rows(); ++i)
    for(Eigen::Index a = 0; a < 9; ++a)
      for(Eigen::Index b = 0; b < 17; ++b)
        expected.values(i, 17 * a + b) = m.values(i, 17 * a + 16 - b);
  BOOST_TEST(difference(spin_images(flipped(cloud)), expected) == 0.);
  BOOST_TEST(difference(m, expected) > 1.);

  std::vector<std::size_t> order;
  for(std::size_t i = 400; i-- > 0;)
    order.push_back(i);
  BOOST_TEST(same_bits(spin_images(permuted(cloud, order)), permuted(m, order)));
}

// much is on the edge of a cell, of the cylinder and of the support angle, but for rounding: none of it is cut off
BOOST_AUTO_TEST_CASE(regular_points)
{
  Cloud corner; // a floor and a wall
  for(int i = -6; i <= 6; ++i)
    for(int j = 0; j <= 12; ++j)
    {
      corner.points.emplace_back(.1 * i, .1 * j, 0.);
      corner.normals.emplace_back(0., 0., 1.);
    }
  const std::size_t center = 6 * 13 + 6;
  for(int i = -6; i <= 6; ++i)
    for(int j = 1; j <= 6; ++j)
    {
      corner.points.emplace_back(.1 * i, 0., .1 * j);
      corner.normals.emplace_back(0., 1., 0.);
    }
  const double reach = .4 * std::sqrt(2.); // the cylinder ends where points are
  const SC::Descriptor_matrix m = spin_images(corner, SC::Neighborhood::ball(reach), 4);
  // of 48 points in the circle, four are on it, and twice eight in the last cell
  const double at_end = 4. + 8. * (std::sqrt(10.) - 3.) + 8. * (std::sqrt(13.) - 3.);
  BOOST_TEST(std::abs(double(m.values(Eigen::Index(center), 9 * 4 + 4)) - 100. * at_end / 48.) < 1e-4);
  // at right angles, the wall is seen from the floor
  double above = 0.;
  for(Eigen::Index a = 0; a <= 4; ++a)
    above += double(m.values.row(13 * 6 + 1).segment(9 * a + 5, 4).sum());
  BOOST_TEST(above > 10.);
  for(const double scale : {1e-3, 3e5})
    for(const Eigen::Matrix3d& rotation : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), some_rotation()})
      BOOST_TEST(difference(spin_images(moved(corner, scale, rotation, Vector3d::Zero()),
                                        SC::Neighborhood::ball(scale * reach), 4),
                            m) < 1e-4);

  const SC::Descriptor_matrix torus = spin_images(torus_cloud(48, 24));
  for(std::size_t i = 0; i < 48 * 24; i += 24) // around the outer equator, all are alike
    BOOST_TEST(
        (torus.values.row(Eigen::Index(i)) - torus.values.row(0)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <
        1e-4f);
}

// two sheets, close to each other, whose outer sides are away from each other
BOOST_AUTO_TEST_CASE(other_side_of_a_thin_object)
{
  Cloud sheet = wavy_cloud(400, 9), both = sheet;
  for(std::size_t i = 0; i < 400; ++i)
  {
    both.points.push_back(sheet.points[i] - Vector3d(0., 0., .05));
    both.normals.push_back(-sheet.normals[i]);
  }
  SC::Descriptor_matrix upper = spin_images(both);
  upper.values.conservativeResize(400, Eigen::NoChange);
  upper.status.resize(400);
  BOOST_TEST(difference(upper, spin_images(sheet)) < 1e-5);
  SC::Descriptor_matrix of_both = spin_images(both, SC::Neighborhood::ball(radius), 8, pi);
  of_both.values.conservativeResize(400, Eigen::NoChange);
  of_both.status.resize(400);
  BOOST_TEST(difference(of_both, upper) > 10.);
}

BOOST_AUTO_TEST_CASE(bad_point_sets)
{
  for(const SC::Neighborhood& neighborhood : {SC::Neighborhood::ball(1e3), SC::Neighborhood::nearest(10)})
  {
    BOOST_TEST(spin_images(Cloud(), neighborhood).values.cols() == 153);
    check_points_on_a_line([&](const Cloud& line) { return spin_images(line, neighborhood); });
  }
  // all neighbors are turned away
  Cloud hedgehog;
  for(int i = 0; i < 3; ++i)
  {
    const double a = 2. * pi * i / 3.;
    hedgehog.points.emplace_back(std::cos(a), std::sin(a), 0.);
    hedgehog.normals.push_back(hedgehog.points.back());
  }
  BOOST_TEST(number_of(S::DEGENERATE, spin_images(hedgehog, SC::Neighborhood::ball(2.))) == 3u);

  check_samples_that_are_not_finite(wavy_cloud(250, 12),
                                    [](const Cloud& cloud) { return spin_images(cloud); });
}

BOOST_AUTO_TEST_CASE(functions_for_meshes_and_point_sets)
{
  using height_field_test::Kernel;
  using height_field_test::Mesh;
  namespace np = SC::parameters;

  const Cloud cloud = wavy_cloud(500, 3);
  const std::vector<test_support::Oriented_point> points = pairs_of(cloud);
  const auto maps = test_support::oriented_point_maps();
  const SC::Descriptor_matrix m =
      SC::spin_image_descriptors<CGAL::Sequential_tag>(points, maps.neighbor_radius(radius));
  BOOST_TEST(same_bits(m, spin_images(cloud))); // which runs in parallel
  BOOST_TEST(same_bits(
      SC::spin_image_descriptors(points, maps.number_of_neighbors(30).image_width(5).support_angle(1.)),
      spin_images(cloud, SC::Neighborhood::nearest(30), 5, 1.)));
  const SC::Descriptor_matrix row = SC::spin_image_descriptors(
      points, maps.neighbor_radius(radius).descriptor_samples(std::vector<unsigned int>{42u}));
  BOOST_TEST(row.values.rows() == 1);
  BOOST_TEST((row.values.row(0) == m.values.row(42)));
  for(const double width : {-1., 0., 1001., 1e12, 2.5, std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(SC::spin_image_descriptors(points, maps.image_width(width)), std::invalid_argument);
  for(const double angle : {-1., 0., 3.2, std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(SC::spin_image_descriptors(points, maps.support_angle(angle)), std::invalid_argument);
  BOOST_CHECK_THROW(
      SC::spin_image_descriptors(points, maps.descriptor_samples(std::vector<unsigned int>{500u})),
      std::invalid_argument);
  const SC::Descriptor_matrix cancelled =
      SC::spin_image_descriptors<CGAL::Sequential_tag>(points, maps.callback([](double) { return false; }));
  BOOST_TEST(is_consistent(cancelled));
  BOOST_TEST(number_of(S::ESTIMATED, cancelled) == 128u);
  BOOST_TEST(number_of(S::CANCELLED, cancelled) == 372u);

  Mesh mesh = height_field_test::height_field(1., 1., 12, height_field_test::wave);
  mesh.add_vertex(Kernel::Point_3(5., 5., 5.));
  const SC::Descriptor_matrix of_mesh = SC::spin_image_descriptors(mesh, np::neighbor_radius(radius));
  BOOST_TEST(is_consistent(of_mesh));
  BOOST_TEST(number_of(S::ESTIMATED, of_mesh) == 11u * 11u);
  BOOST_TEST(number_of(S::BORDER, of_mesh) == 48u);
  BOOST_TEST((of_mesh.status.back() == S::UNREFERENCED));

  const test_support::Analytic_surface torus = test_support::torus(1., .4, 32, 16, .2, 6);
  BOOST_TEST(
      same_bits(SC::spin_image_descriptors(test_support::build_mesh<CGAL::Polyhedron_3<Kernel> >(torus)),
                SC::spin_image_descriptors(test_support::build_mesh<Mesh>(torus))));
}

BOOST_AUTO_TEST_SUITE_END()
