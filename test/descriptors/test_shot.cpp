#include <boost/test/unit_test.hpp>

#include "oriented_cloud.h"

#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/descriptors/shot_descriptors.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include "analytic_surfaces.h"
#include "build_mesh.h"
#include "plain_algebra.h"
#include "raise_to.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(shot)

using namespace oriented_cloud;
using SC::Estimation_status;
using Shot = SC::Shot_descriptor<SC::Point_set_samples>;
using Kernel = CGAL::Simple_cartesian<double>;

namespace {

SC::Descriptor_matrix
shot_of(const Cloud& cloud, const SC::Neighborhood& neighborhood, SC::Shot_variant variant)
{
  const SC::Point_set_samples samples = samples_of(cloud, neighborhood);
  return SC::compute_descriptors<CGAL::Sequential_tag>(Shot(samples, variant), samples.size());
}

// the frame by another solver, and signs by counting
Eigen::Matrix3d plain_frame(const std::vector<Vector3d>& offsets)
{
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for(const Vector3d& d : offsets)
    for(int r = 0; r < 3; ++r)
      for(int c = 0; c < 3; ++c)
        m(r, c) += (1. - d.norm()) * d[r] * d[c];
  const Eigen::Matrix3d axes = test_support::left_singular_vectors(m);
  Eigen::Matrix3d frame;
  for(const int k : {0, 2})
  {
    const Vector3d axis = axes.col(k);
    int sum = 0;
    for(const Vector3d& d : offsets)
      sum += axis.dot(d) > 0. ? 1 : -1;
    if(sum == 0)
      for(std::size_t i = offsets.size() / 2 - 2; i <= offsets.size() / 2 + 2; ++i)
        sum += axis.dot(offsets[i]) > 0. ? 1 : -1;
    frame.row(k) = sum > 0 ? axis : Vector3d(-axis);
  }
  frame.row(1) = Vector3d(frame.row(2)).cross(Vector3d(frame.row(0)));
  return frame;
}

// a point's share of a bin whose center is so many bins away
double hat(double distance)
{
  return std::max(0., 1. - std::abs(distance));
}

constexpr double degrees = 180. / CGAL_PI;

// how far a neighbor is from the center of each bin, in units of bins
struct Position
{
  double azimuth, radius, elevation, cosine;

  double to_azimuth(int a) const
  {
    const double d = std::abs(azimuth - (-180. + 45. * a + 22.5));
    return std::min(d, 360. - d) / 45.;
  }
  double to_shell(int r) const { return (radius - (r == 0 ? .25 : .75)) / .5; }
  double to_half(int e) const { return (elevation - (e == 1 ? 45. : 135.)) / 90.; }
  double to_cosine(int c) const { return (cosine - (-1. + .2 * c)) / .2; }
};

std::size_t bin(int a, int r, int e, int c)
{
  return std::size_t(11 * (4 * a + 2 * r + e) + c);
}

void plain_product(const Position& p, std::vector<double>& bins)
{
  for(int a = 0; a < 8; ++a)
    for(int r = 0; r < 2; ++r)
      for(int e = 0; e < 2; ++e)
        for(int c = 0; c < 11; ++c)
          bins[bin(a, r, e, c)] +=
              hat(p.to_azimuth(a)) * hat(p.to_shell(r)) * hat(p.to_half(e)) * hat(p.to_cosine(c));
}

void plain_sum(const Position& p, std::vector<double>& bins)
{
  const int a = std::min(7, int((p.azimuth + 180.) / 45.)), r = p.radius > .5 ? 1 : 0,
            e = p.elevation < 90. ? 1 : 0, c = int(std::floor((1. + p.cosine) * 5. + .5));
  bins[bin(a, r, e, c)] +=
      hat(p.to_azimuth(a)) + hat(p.to_shell(r)) + hat(p.to_half(e)) + hat(p.to_cosine(c));
  for(const int other : {(a + 1) % 8, (a + 7) % 8})
    bins[bin(other, r, e, c)] += hat(p.to_azimuth(other));
  bins[bin(a, 1 - r, e, c)] += hat(p.to_shell(1 - r));
  bins[bin(a, r, 1 - e, c)] += hat(p.to_half(1 - e));
  if(c > 0)
    bins[bin(a, r, e, c - 1)] += hat(p.to_cosine(c - 1));
  if(c < 10)
    bins[bin(a, r, e, c == 9 ? 0 : c + 1)] += hat(p.to_cosine(c + 1)); // see Shot_variant::PCL
}

std::vector<double> plain_shot(const Cloud& cloud, std::size_t i, double radius, SC::Shot_variant variant)
{
  std::vector<std::pair<double, std::size_t> > near;
  for(std::size_t j = 0; j < cloud.points.size(); ++j)
    if(const double d = (cloud.points[j] - cloud.points[i]).norm(); j != i && d <= radius)
      near.emplace_back(d, j);
  std::sort(near.begin(), near.end());
  std::vector<Vector3d> offsets;
  for(const auto& n : near)
    offsets.push_back((cloud.points[n.second] - cloud.points[i]) / radius);
  const Eigen::Matrix3d frame = plain_frame(offsets);
  std::vector<double> bins(352, 0.);
  for(std::size_t k = 0; k < near.size(); ++k)
  {
    const Vector3d d = frame * offsets[k];
    const Position p = {std::atan2(d.y(), d.x()) * degrees, d.norm(),
                        std::atan2(std::hypot(d.x(), d.y()), d.z()) * degrees,
                        Vector3d(frame.row(2)).dot(cloud.normals[near[k].second])};
    if(variant == SC::Shot_variant::PAPER)
      plain_product(p, bins);
    else
      plain_sum(p, bins);
  }
  const double norm = std::sqrt(std::inner_product(bins.begin(), bins.end(), bins.begin(), 0.));
  for(double& b : bins)
    b /= norm;
  return bins;
}

constexpr SC::Shot_variant variants[] = {SC::Shot_variant::PAPER, SC::Shot_variant::PCL};
const SC::Neighborhood ball = SC::Neighborhood::ball(.3);

} // namespace

BOOST_AUTO_TEST_CASE(equals_a_plain_one)
{
  const Cloud cloud = wavy_cloud(1000, 1);
  for(const SC::Shot_variant variant : variants)
  {
    const SC::Descriptor_matrix shot = shot_of(cloud, ball, variant);
    BOOST_TEST(is_consistent(shot));
    BOOST_TEST(shot.values.cols() == 352);
    double largest = 0.;
    for(std::size_t i = 0; i < cloud.points.size(); i += 7)
    {
      BOOST_TEST_REQUIRE((shot.status[i] == Estimation_status::ESTIMATED));
      BOOST_TEST(std::abs(shot.values.row(Eigen::Index(i)).norm() - 1.f) < 1e-5f);
      const std::vector<double> plain = plain_shot(cloud, i, .3, variant);
      for(std::size_t k = 0; k < 352; ++k)
        test_support::raise_to(largest,
                               std::abs(plain[k] - double(shot.values(Eigen::Index(i), Eigen::Index(k)))));
    }
    BOOST_TEST(largest < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(local_reference_frame)
{
  const Cloud cloud = wavy_cloud(500, 2);
  const SC::Point_set_samples samples = samples_of(cloud, ball);
  const Shot shot(samples);
  Shot::Workspace workspace;
  Eigen::Matrix3d frame, turned_frame;
  const SC::Point_set_samples turned =
      samples_of(moved(cloud, 3., some_rotation(), {1., 2., 3.}), SC::Neighborhood::ball(.9));
  const Shot turned_shot(turned);
  Shot::Workspace turned_workspace;
  for(std::size_t i = 0; i < samples.size(); i += 11)
  {
    BOOST_TEST((shot.local_reference_frame(i, workspace, frame) == Estimation_status::ESTIMATED));
    BOOST_TEST((frame * frame.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    BOOST_TEST(std::abs(frame.determinant() - 1.) < 1e-14);
    turned_shot.local_reference_frame(i, turned_workspace, turned_frame);
    BOOST_TEST((turned_frame - frame * some_rotation().transpose()).norm() < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(motion_scale_and_order)
{
  const Cloud cloud = wavy_cloud(800, 3);
  std::vector<std::size_t> order(cloud.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  for(const SC::Shot_variant variant : variants)
  {
    const SC::Descriptor_matrix shot = shot_of(cloud, ball, variant);
    for(const double scale : {1e-6, 1., 1e6})
    {
      const Cloud other = moved(cloud, scale, some_rotation(), scale * Vector3d(4., -5., 6.));
      BOOST_TEST(difference(shot, shot_of(other, SC::Neighborhood::ball(.3 * scale), variant)) < 1e-5);
    }
    const SC::Descriptor_matrix other = shot_of(permuted(cloud, order), ball, variant);
    bool same = true;
    for(std::size_t i = 0; i < order.size(); ++i)
      same = same && other.values.row(Eigen::Index(i)) == shot.values.row(Eigen::Index(order[i]));
    BOOST_TEST(same);
  }
}

// Neither distances that are equal but for rounding decide, nor sides of planes of symmetry. (In the other variant, neighbors in
// the plane of symmetry are on the border of two bins.)
BOOST_AUTO_TEST_CASE(regular_points_of_other_sizes)
{
  for(const Cloud& cloud : {torus_cloud(24, 12), torus_cloud(48, 24)})
    for(const double r : {.3, .4})
    {
      const SC::Descriptor_matrix shot = shot_of(cloud, SC::Neighborhood::ball(r), SC::Shot_variant::PAPER);
      for(const double scale : {1e6, 3e5, 1e3, 1e-6})
      {
        const Cloud other = moved(cloud, scale, Eigen::Matrix3d::Identity(), Vector3d::Zero());
        BOOST_TEST(difference(shot, shot_of(other, SC::Neighborhood::ball(r * scale),
                                            SC::Shot_variant::PAPER)) < 1e-5);
      }
    }
}

// the reversed sectors are the descriptor of the mirrored surface
BOOST_AUTO_TEST_CASE(mirror_and_flip)
{
  const Cloud cloud = wavy_cloud(800, 4);
  const SC::Point_set_samples samples = samples_of(cloud, ball);
  for(const SC::Shot_variant variant : variants)
  {
    const SC::Descriptor_matrix shot = shot_of(cloud, ball, variant);
    SC::Descriptor_matrix expected = shot;
    for(Eigen::Index i = 0; i < shot.values.rows(); ++i)
      Shot(samples).mirrored(shot.values.row(i).data(), expected.values.row(i).data());
    BOOST_TEST(difference(shot_of(mirrored(cloud), ball, variant), expected) < 1e-6);
    BOOST_TEST(difference(shot, expected) > .1);
  }
  // cosines in reverse order
  const SC::Descriptor_matrix shot = shot_of(cloud, ball, SC::Shot_variant::PAPER);
  SC::Descriptor_matrix expected = shot;
  for(Eigen::Index k = 0; k < 352; ++k)
    expected.values.col(k) = shot.values.col(11 * (k / 11) + 10 - k % 11);
  BOOST_TEST(difference(shot_of(flipped(cloud), ball, SC::Shot_variant::PAPER), expected) < 1e-6);
}

BOOST_AUTO_TEST_CASE(functions_and_threads)
{
  // of points
  const Cloud cloud = wavy_cloud(600, 5);
  const std::vector<test_support::Oriented_point> points = pairs_of(cloud);
  const auto np = test_support::oriented_point_maps();
  for(const SC::Shot_variant variant : variants)
  {
    const SC::Descriptor_matrix expected = shot_of(cloud, ball, variant);
    const auto with_radius = np.neighbor_radius(.3).shot_variant(variant);
    BOOST_TEST(same_bits(SC::shot_descriptors<CGAL::Sequential_tag>(points, with_radius), expected));
    BOOST_TEST(
        same_bits(SC::shot_descriptors<CGAL::Parallel_if_available_tag>(points, with_radius), expected));
    const std::vector<int> some = {5, 3, 599};
    const SC::Descriptor_matrix part = SC::shot_descriptors(points, with_radius.descriptor_samples(some));
    BOOST_TEST(part.values.rows() == 3);
    for(Eigen::Index k = 0; k < 3; ++k)
      BOOST_TEST((part.values.row(k) == expected.values.row(some[std::size_t(k)])));
  }
  BOOST_TEST(same_bits(SC::shot_descriptors(points, np),
                       shot_of(cloud, SC::Neighborhood::nearest(18), SC::Shot_variant::PAPER)));
  const std::vector<int> too_large = {600};
  BOOST_CHECK_THROW(SC::shot_descriptors(points, np.descriptor_samples(too_large)), std::invalid_argument);
  BOOST_CHECK_THROW(SC::shot_descriptors(std::vector<Kernel::Point_3>()), std::invalid_argument);
  BOOST_TEST(SC::shot_descriptors(std::vector<test_support::Oriented_point>(), np).values.rows() == 0);

  // of meshes
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  const Mesh mesh = test_support::build_mesh<Mesh>(test_support::ellipsoid(1., .8, .6, 2, .2, 5));
  const SC::Face_graph_samples samples =
      SC::sampled_surface<CGAL::Sequential_tag>(mesh, SC::Neighborhood::rings(3));
  const SC::Descriptor_matrix expected = SC::compute_descriptors<CGAL::Sequential_tag>(
      SC::Shot_descriptor<SC::Face_graph_samples>(samples), samples.size());
  BOOST_TEST(number_of(Estimation_status::ESTIMATED, expected) == samples.size());
  BOOST_TEST(same_bits(SC::shot_descriptors(mesh, SC::parameters::number_of_rings(3)), expected));
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3d up(0., 0., 1.);
  const SC::Neighborhood nearest = SC::Neighborhood::nearest(20);
  for(const SC::Shot_variant variant : variants)
  {
    BOOST_TEST(shot_of(Cloud(), nearest, variant).values.rows() == 0);
    for(std::size_t n = 1; n <= 5; ++n)
    {
      Cloud few = wavy_cloud(n, 6);
      const SC::Descriptor_matrix shot = shot_of(few, nearest, variant);
      BOOST_TEST(is_consistent(shot));
      BOOST_TEST(number_of(Estimation_status::FEW_NEIGHBOURS, shot) == n);
    }
    Cloud line, spot, grid;
    for(int i = 0; i < 30; ++i)
    {
      line.points.push_back({.1 * i, .2 * i, 1e3 - .3 * i});
      spot.points.push_back({1., 2., 3.});
    }
    line.normals.assign(30, up);
    spot.normals.assign(30, up);
    for(int i = 0; i < 11; ++i)
      for(int j = 0; j < 11; ++j)
        grid.points.push_back({double(i), double(j), 5.});
    grid.normals.assign(grid.points.size(), up);
    BOOST_TEST(number_of(Estimation_status::DEGENERATE, shot_of(line, nearest, variant)) == 30u);
    BOOST_TEST(number_of(Estimation_status::FEW_NEIGHBOURS, shot_of(spot, nearest, variant)) == 30u);
    // neither x nor its sign
    const SC::Descriptor_matrix on_grid = shot_of(grid, SC::Neighborhood::ball(2.5), variant);
    BOOST_TEST(is_consistent(on_grid));
    BOOST_TEST((on_grid.status[5 * 11 + 5] == Estimation_status::DEGENERATE));

    // a plane: its normal gives z, wherever it lies
    Cloud plane = wavy_cloud(200, 7);
    for(std::size_t i = 0; i < plane.points.size(); ++i)
    {
      plane.points[i].z() = 0.;
      plane.normals[i] = up;
    }
    const SC::Descriptor_matrix flat = shot_of(plane, nearest, variant);
    BOOST_TEST(number_of(Estimation_status::ESTIMATED, flat) == 200u);
    // (of the two halves, in equal parts; the sums go to the one that rounding errors choose)
    const SC::Descriptor_matrix turned = shot_of(moved(plane, 1., some_rotation(), up), nearest, variant);
    BOOST_TEST(is_consistent(turned));
    if(variant == SC::Shot_variant::PAPER)
      BOOST_TEST(difference(flat, turned) < 1e-5);

    // what isn't finite is nobody's neighbor; copies don't divide by zero
    Cloud bad = wavy_cloud(300, 8);
    const SC::Descriptor_matrix before = shot_of(bad, ball, variant);
    bad.points.push_back({nan, 0., 0.});
    bad.points.push_back(bad.points[0] + Vector3d(.01, 0., 0.));
    bad.points.push_back(bad.points[0] + Vector3d(0., .01, 0.));
    bad.normals.push_back(up);
    bad.normals.push_back({nan, 0., 0.});
    bad.normals.push_back({0., 0., 0.});
    SC::Descriptor_matrix after = shot_of(bad, ball, variant);
    BOOST_TEST(is_consistent(after));
    BOOST_TEST(number_of(Estimation_status::NON_FINITE_INPUT, after) == 3u);
    after.values.conservativeResize(300, Eigen::NoChange);
    after.status.resize(300);
    BOOST_TEST(same_bits(after, before));
    bad.points.resize(300);
    bad.normals.resize(300);
    for(std::size_t k = 0; k < 3; ++k)
    {
      bad.points.push_back(bad.points[0]);
      bad.normals.push_back(bad.normals[0]);
    }
    const SC::Descriptor_matrix copied = shot_of(bad, ball, variant);
    BOOST_TEST(is_consistent(copied));
    BOOST_TEST((copied.values.row(0) == before.values.row(0)));
    BOOST_TEST((copied.values.row(301) == before.values.row(0)));
  }
}

BOOST_AUTO_TEST_SUITE_END()
