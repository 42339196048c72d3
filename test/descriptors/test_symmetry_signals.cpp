#include <boost/test/unit_test.hpp>

#include "height_field.h"
#include "oriented_cloud.h"

#include <Shape_characteristics/descriptors/chiralities.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/descriptors/signed_volumes.h>
#include <Shape_characteristics/descriptors/symmetry_fluxes.h>
#include <Shape_characteristics/normals/sampled_surface.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>
#include <CGAL/property_map.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(symmetry_signals)

using namespace oriented_cloud;
using height_field_test::height_field;
using height_field_test::Kernel;
using height_field_test::Mesh;
using height_field_test::wave;
using SC::Estimation_status;
using SC::Flux_method;
using SC::Signal_scaling;
using SC::Signed_volume_method;
using test_support::Oriented_point;
using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

namespace {

// by the sample's number, some measure of no meaning
std::vector<double> some_values(std::size_t size, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::vector<double> values;
  for(std::size_t i = 0; i < size; ++i)
    values.push_back(double(generator()) / 4294967296. - .3);
  return values;
}

std::vector<double> negated(std::vector<double> values)
{
  for(double& x : values)
    x = -x;
  return values;
}

SC::Descriptor_matrix negated(SC::Descriptor_matrix m)
{
  m.values = -m.values;
  return m;
}

// what a function returns that runs in parallel by default: with another tag, it would be compiled a second time
template <typename Function>
SC::Descriptor_matrix on_one_thread(const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
#endif
  return function();
}

// equal numbers, 0 and -0 among them, and NaN at the same places
bool are_equal(const SC::Descriptor_matrix& a, const SC::Descriptor_matrix& b)
{
  return difference(a, b) == 0.;
}

template <typename Descriptor, typename Surface, typename... Arguments>
SC::Descriptor_matrix compute(const Surface& surface, const Arguments&... arguments)
{
  return SC::compute_descriptors<CGAL::Sequential_tag>(Descriptor(surface, arguments...), surface.size());
}

using Flux = SC::Symmetry_flux_descriptor<SC::Point_set_samples>;
using Volume = SC::Signed_volume_descriptor<SC::Point_set_samples>;
using Chirality = SC::Chirality_descriptor<SC::Point_set_samples>;

constexpr double radius = .3;
const SC::Neighborhood ball = SC::Neighborhood::ball(radius);

// all signals of a cloud with given mean and Gaussian curvatures
struct Signals
{
  std::vector<SC::Descriptor_matrix> matrices;
};

Signals signals_of(const Cloud& cloud,
                   const SC::Neighborhood& neighborhood,
                   const std::vector<double>& mean,
                   const std::vector<double>& Gaussian)
{
  const SC::Point_set_samples s = samples_of(cloud, neighborhood);
  return {{compute<Flux>(s), compute<Volume>(s, mean, Gaussian),
           compute<Volume>(s, mean, Gaussian, Signed_volume_method::BINS),
           compute<Chirality>(s, mean, Gaussian)}};
}

std::vector<std::size_t> neighbors_of(const Cloud& cloud, std::size_t i, double r)
{
  std::vector<std::size_t> result;
  for(std::size_t j = 0; j < cloud.points.size(); ++j)
    if(j != i && (cloud.points[j] - cloud.points[i]).norm() <= r)
      result.push_back(j);
  return result;
}

Vector3d plain_moment(const Cloud& cloud,
                      std::size_t i,
                      const std::vector<std::size_t>& near,
                      const std::vector<double>& f)
{
  const auto weight = [&](std::size_t j)
  {
    const double t = (cloud.points[j] - cloud.points[i]).squaredNorm() / (radius * radius);
    return (1. - t) * (1. - t);
  };
  double mean = f[i], weights = 1.;
  for(const std::size_t j : near)
  {
    mean += weight(j) * f[j];
    weights += weight(j);
  }
  mean /= weights;
  const Eigen::Matrix3d to_plane =
      Eigen::Matrix3d::Identity() - cloud.normals[i] * cloud.normals[i].transpose();
  Vector3d sum = Vector3d::Zero();
  for(const std::size_t j : near)
    sum += weight(j) * (f[j] - mean) * (to_plane * (cloud.points[j] - cloud.points[i]));
  return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(equal_plain_ones)
{
  const Cloud cloud = wavy_cloud(800, 1);
  const std::vector<double> mean = some_values(800, 2), Gaussian = some_values(800, 3);
  const SC::Point_set_samples s = samples_of(cloud, ball);
  const std::vector<double> areas(800, .01);
  const SC::Descriptor_matrix flux = compute<Flux>(s),
                              printed = compute<Flux>(s, Flux_method::POINTS, Signal_scaling::AS_PRINTED),
                              with_areas =
                                  compute<Flux>(s, Flux_method::POINTS, Signal_scaling::UNIT_FREE, areas),
                              printed_with_areas =
                                  compute<Flux>(s, Flux_method::POINTS, Signal_scaling::AS_PRINTED, areas),
                              volume = compute<Volume>(s, mean, Gaussian),
                              chirality = compute<Chirality>(s, mean, Gaussian);
  for(std::size_t i = 0; i < 800; ++i)
  {
    const Eigen::Index row = Eigen::Index(i);
    const Vector3d &p = cloud.points[i], &n = cloud.normals[i];
    const std::vector<std::size_t> near = neighbors_of(cloud, i, radius);
    long double sum = 0.L;
    std::size_t largest = i, smallest = i;
    for(const std::size_t j : near)
    {
      sum += .5L * (p - cloud.points[j]).cross(n).dot(cloud.normals[j]);
      largest = mean[j] > mean[largest] ? j : largest;
      smallest = mean[j] < mean[smallest] ? j : smallest;
    }
    const double pi = CGAL_PI, count = double(near.size()), f = double(sum);
    BOOST_TEST(std::abs(double(printed.values(row, 0)) - f) < 1e-6 * radius * count);
    BOOST_TEST(std::abs(double(flux.values(row, 0)) - 2. * pi / count / radius * f) < 1e-6);
    BOOST_TEST(std::abs(double(with_areas.values(row, 0)) - 2. * .01 * f / std::pow(radius, 3)) < 1e-5);
    BOOST_TEST(std::abs(double(printed_with_areas.values(row, 0)) - 2. * .01 * f) <
               1e-5 * std::pow(radius, 3));
    const double v = n.dot((cloud.points[largest] - p).cross(cloud.points[smallest] - p));
    BOOST_TEST(std::abs(double(volume.values(row, 0)) - v / (radius * radius)) < 1e-6);
    const Vector3d a = plain_moment(cloud, i, near, mean), b = plain_moment(cloud, i, near, Gaussian);
    BOOST_TEST(std::abs(double(chirality.values(row, 0)) - n.dot(a.cross(b)) / a.norm() / b.norm()) < 1e-5);
  }
}

// on a grid that its quarter turns map to itself, with measures whose moments are known
BOOST_AUTO_TEST_CASE(closed_forms)
{
  Cloud grid;
  std::vector<double> x, x_and_y, spots, more_spots;
  std::size_t middle = 0;
  for(int i = -5; i <= 5; ++i)
    for(int j = -5; j <= 5; ++j)
    {
      if(i == 0 && j == 0)
        middle = grid.points.size();
      grid.points.push_back({double(i), double(j), 0.});
      x.push_back(i);
      x_and_y.push_back(i + j);
      spots.push_back(i == 2 && j == 1 ? 1. : (i == -1 && j == 3 ? -1. : 0.));
      more_spots.push_back(i == 1 && j == 2 ? 1. : spots.back());
    }
  grid.normals.assign(grid.points.size(), {0., 0., 1.});
  const SC::Point_set_samples s = samples_of(grid, SC::Neighborhood::ball(4.));
  const Eigen::Index row = Eigen::Index(middle);
  BOOST_TEST(std::abs(compute<Chirality>(s, x, x_and_y).values(row, 0) - std::sqrt(.5f)) < 1e-6f);
  BOOST_TEST(std::abs(compute<Chirality>(s, x_and_y, x).values(row, 0) + std::sqrt(.5f)) < 1e-6f);
  BOOST_TEST(compute<Chirality>(s, x, x).values(row, 0) == 0.f);
  // (2, 1) x (-1, 3)
  const SC::Descriptor_matrix volume = compute<Volume>(s, spots, negated(spots));
  BOOST_TEST(volume.values(row, 0) == 7.f / 16.f);
  BOOST_TEST(volume.values(row, 1) == -7.f / 16.f);
  // two places with the largest: their mean, ((2, 1) + (1, 2)) / 2 x (-1, 3)
  BOOST_TEST(compute<Volume>(s, more_spots, spots).values(row, 0) == 6.f / 16.f);
  const SC::Descriptor_matrix printed =
      compute<Volume>(s, spots, spots, Signed_volume_method::EXTREMA, Signal_scaling::AS_PRINTED);
  BOOST_TEST(printed.values(row, 0) == 7.f);
  // with a unit, a volume may be too large to be told
  for(const auto& [scale, reach] : {std::pair<double, double>(1e20, 4e20), {1., 1e200}})
  {
    Cloud large = grid;
    for(auto& p : large.points)
      p = {scale * p[0], scale * p[1], scale * p[2]};
    const SC::Point_set_samples t = samples_of(large, SC::Neighborhood::ball(reach));
    const SC::Descriptor_matrix of_large =
        compute<Volume>(t, spots, spots, Signed_volume_method::EXTREMA, Signal_scaling::AS_PRINTED);
    BOOST_TEST((of_large.status[middle] == SC::Estimation_status::DEGENERATE));
    BOOST_TEST(std::isnan(of_large.values(row, 0)));
    BOOST_TEST(std::isnan(of_large.values(row, 1)));
  }
  BOOST_TEST((compute<Volume>(s, spots, spots, Signed_volume_method::BINS).values(row, 0) > .1f));

  // what doesn't vary has no handedness, but for rounding errors, which say nothing
  std::vector<double> noise = some_values(grid.points.size(), 4);
  for(double& f : noise)
    f *= 1e-17;
  for(const Signed_volume_method method : {Signed_volume_method::EXTREMA, Signed_volume_method::BINS})
    BOOST_TEST((compute<Volume>(s, noise, noise, method).values.array() == 0.f).all());
  BOOST_TEST((compute<Chirality>(s, noise, x).values.array() == 0.f).all());
  BOOST_TEST((compute<Flux>(s).values.array() == 0.f).all());
}

BOOST_AUTO_TEST_CASE(mirror_flip_and_order)
{
  const Cloud cloud = wavy_cloud(700, 5);
  const std::vector<double> mean = some_values(700, 6), Gaussian = some_values(700, 7);
  const Signals signals = signals_of(cloud, ball, mean, Gaussian);
  const Signals of_mirrored = signals_of(mirrored(cloud), ball, mean, Gaussian);
  const Signals of_flipped = signals_of(flipped(cloud), ball, negated(mean), Gaussian);
  for(std::size_t k = 0; k < signals.matrices.size(); ++k)
  {
    const SC::Descriptor_matrix& m = signals.matrices[k];
    BOOST_TEST(is_consistent(m));
    BOOST_TEST(number_of(Estimation_status::ESTIMATED, m) == 700u);
    BOOST_TEST((m.values.array() != 0.f).count() > m.values.size() / 2);
    BOOST_TEST(are_equal(of_mirrored.matrices[k], negated(m)));
    SC::Descriptor_matrix expected = m;
    if(m.values.cols() == 2)
      expected.values.col(1) = -expected.values.col(1);
    BOOST_TEST(are_equal(of_flipped.matrices[k], expected));
  }
  float result[2];
  const SC::Point_set_samples s = samples_of(cloud, ball);
  const float row[2] = {.5f, -.25f};
  Volume(s, mean, Gaussian).mirrored(row, result);
  BOOST_TEST((result[0] == -.5f && result[1] == .25f));
  Flux(s).mirrored(row, result);
  BOOST_TEST(result[0] == -.5f);
  Chirality(s, mean, Gaussian).mirrored(row, result);
  BOOST_TEST(result[0] == -.5f);

  std::vector<std::size_t> order;
  for(std::size_t i = 0; i < 700; ++i)
    order.push_back(i * 211 % 700);
  std::vector<double> permuted_mean, permuted_Gaussian;
  for(const std::size_t i : order)
  {
    permuted_mean.push_back(mean[i]);
    permuted_Gaussian.push_back(Gaussian[i]);
  }
  const Signals of_permuted = signals_of(permuted(cloud, order), ball, permuted_mean, permuted_Gaussian);
  bool same = true;
  for(std::size_t k = 0; k < signals.matrices.size(); ++k)
    for(std::size_t i = 0; i < 700; ++i)
      same = same && of_permuted.matrices[k].values.row(Eigen::Index(i)) ==
                         signals.matrices[k].values.row(Eigen::Index(order[i]));
  BOOST_TEST(same);
}

BOOST_AUTO_TEST_CASE(motion_and_scale)
{
  const Cloud cloud = wavy_cloud(500, 8);
  const std::vector<double> mean = some_values(500, 9), Gaussian = some_values(500, 10);
  const Signals signals = signals_of(cloud, ball, mean, Gaussian);
  for(const double scale : {1e-6, 1., 1e6})
  {
    std::vector<double> scaled_mean = mean, scaled_Gaussian = Gaussian;
    for(std::size_t i = 0; i < 500; ++i)
    {
      scaled_mean[i] /= scale;
      scaled_Gaussian[i] /= scale * scale;
    }
    const Cloud other = moved(cloud, scale, some_rotation(), scale * Vector3d(4., -5., 6.));
    const Signals of_other =
        signals_of(other, SC::Neighborhood::ball(scale * radius), scaled_mean, scaled_Gaussian);
    for(std::size_t k = 0; k < signals.matrices.size(); ++k)
      BOOST_TEST(difference(signals.matrices[k], of_other.matrices[k]) < 1e-5);
  }
}

// Each point of a torus is on a plane of symmetry.
BOOST_AUTO_TEST_CASE(mirror_symmetric_surface)
{
  const Cloud cloud = torus_cloud(24, 12);
  std::vector<double> mean, Gaussian;
  for(const Vector3d& p : cloud.points)
  {
    const double across = p.head<2>().norm(), k = (across - 1.) / (.4 * across);
    mean.push_back(.5 * (1. / .4 + k));
    Gaussian.push_back(k / .4);
  }
  for(const double r : {.4, .5})
  {
    const SC::Point_set_samples samples = samples_of(cloud, SC::Neighborhood::ball(r));
    BOOST_TEST(compute<Volume>(samples, mean, Gaussian).values.array().abs().maxCoeff<Eigen::PropagateNaN>() <
               1e-6f);
  }
}

BOOST_AUTO_TEST_CASE(functions_of_points)
{
  const Cloud cloud = wavy_cloud(400, 12);
  const std::vector<Oriented_point> items = pairs_of(cloud);
  const auto np = test_support::oriented_point_maps().neighbor_radius(radius);
  const SC::Point_set_samples s = samples_of(cloud, ball);
  BOOST_TEST(same_bits(SC::symmetry_fluxes(items, np), compute<Flux>(s)));
  BOOST_TEST(same_bits(SC::symmetry_fluxes(items, np.signal_scaling(Signal_scaling::AS_PRINTED)),
                       compute<Flux>(s, Flux_method::POINTS, Signal_scaling::AS_PRINTED)));
  BOOST_CHECK_THROW(SC::symmetry_fluxes(items, np.flux_method(Flux_method::BOUNDARY)), std::invalid_argument);
  BOOST_CHECK_THROW(compute<Flux>(s, Flux_method::POINTS, Signal_scaling::UNIT_FREE, std::vector<double>(3)),
                    std::invalid_argument);
  BOOST_CHECK_THROW(compute<Chirality>(s, std::vector<double>(), std::vector<double>()),
                    std::invalid_argument);
  BOOST_CHECK_THROW(compute<Volume>(s, std::vector<double>(400), std::vector<double>()),
                    std::invalid_argument);

  // estimated curvatures, on any number of threads
  const SC::Descriptor_matrix chirality = on_one_thread([&] { return SC::chiralities(items, np); }),
                              volume = on_one_thread([&] { return SC::signed_volumes(items, np); });
  BOOST_TEST(is_consistent(chirality));
  BOOST_TEST(is_consistent(volume));
  BOOST_TEST(number_of(Estimation_status::ESTIMATED, chirality) == 400u);
  BOOST_TEST(same_bits(SC::chiralities(items, np), chirality));
  BOOST_TEST(same_bits(SC::signed_volumes(items, np), volume));
  const std::vector<unsigned int> some = {7, 399};
  const SC::Descriptor_matrix part = SC::chiralities(items, np.descriptor_samples(some));
  BOOST_TEST(part.values.rows() == 2);
  BOOST_TEST(part.values(1, 0) == chirality.values(399, 0));
  const SC::Descriptor_matrix of_mirrored = SC::chiralities(pairs_of(mirrored(cloud)), np);
  BOOST_TEST(((of_mirrored.values + chirality.values).array().abs() < 1e-2f).count() > 390);

  // given ones
  std::vector<Curvatures> curvatures(400);
  std::vector<double> mean, Gaussian;
  for(std::size_t i = 0; i < 400; ++i)
  {
    curvatures[i].min_curvature = double(i % 7) - 3.;
    curvatures[i].max_curvature = curvatures[i].min_curvature + double(i % 5);
    mean.push_back(.5 * (curvatures[i].min_curvature + curvatures[i].max_curvature));
    Gaussian.push_back(curvatures[i].min_curvature * curvatures[i].max_curvature);
  }
  std::vector<std::size_t> numbers;
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Vector_3> normals;
  std::vector<double> areas;
  for(std::size_t i = 0; i < 400; ++i)
  {
    numbers.push_back(i);
    points.push_back(items[i].first);
    normals.push_back(items[i].second);
    areas.push_back(.01 + 1e-5 * double(i));
  }
  const auto by_number = SC::parameters::point_map(CGAL::make_property_map(points))
                             .normal_map(CGAL::make_property_map(normals))
                             .neighbor_radius(radius);
  BOOST_TEST(same_bits(SC::signed_volumes(numbers, by_number.principal_curvatures_and_directions_map(
                                                       CGAL::make_property_map(curvatures))),
                       compute<Volume>(s, mean, Gaussian)));
  BOOST_TEST(same_bits(SC::symmetry_fluxes(numbers, by_number.area_map(CGAL::make_property_map(areas))),
                       compute<Flux>(s, Flux_method::POINTS, Signal_scaling::UNIT_FREE, areas)));
}

BOOST_AUTO_TEST_CASE(functions_of_meshes)
{
  const auto np = SC::parameters::neighbor_radius(.4);
  Mesh mesh = height_field(1., 1., 20, wave), mirror = mesh;
  for(const auto v : mirror.vertices())
    mirror.point(v) = Kernel::Point_3(-mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  CGAL::Polygon_mesh_processing::reverse_face_orientations(mirror);

  const SC::Descriptor_matrix chirality = SC::chiralities(mesh, np), volume = SC::signed_volumes(mesh, np);
  BOOST_TEST(number_of(Estimation_status::BORDER, chirality) == 80u);
  BOOST_TEST(number_of(Estimation_status::ESTIMATED, volume) == 361u);
  BOOST_TEST(difference(SC::chiralities(mirror, np), negated(chirality)) < 1e-4);
  BOOST_TEST(((SC::signed_volumes(mirror, np).values + volume.values).array().abs() < 1e-5f).count() >
             2 * 430);
  BOOST_TEST(chirality.values.array().abs().mean() > .1f);

  auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvatures>("v:curvatures").first;
  SC::rusinkiewicz_curvatures(mesh,
                              SC::parameters::vertex_principal_curvatures_and_directions_map(curvatures));
  const auto given = np.vertex_principal_curvatures_and_directions_map(curvatures);
  BOOST_TEST(same_bits(SC::chiralities(mesh, given), chirality));
  BOOST_TEST(same_bits(SC::signed_volumes(mesh, given), volume));

  // other faces than triangles
  Mesh square;
  const auto a = square.add_vertex(Kernel::Point_3(0, 0, 0)), b = square.add_vertex(Kernel::Point_3(1, 0, 0)),
             c = square.add_vertex(Kernel::Point_3(1, 1, 0)), d = square.add_vertex(Kernel::Point_3(0, 1, 0));
  square.add_face(a, b, c, d);
  BOOST_CHECK_THROW(SC::chiralities(square), std::invalid_argument);
  BOOST_TEST(SC::chiralities(Mesh()).values.rows() == 0);
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3d up(0., 0., 1.);
  const auto all = [](const Cloud& cloud)
  {
    const std::vector<Oriented_point> items = pairs_of(cloud);
    const auto np = test_support::oriented_point_maps();
    return std::vector<SC::Descriptor_matrix>{SC::symmetry_fluxes(items, np), SC::signed_volumes(items, np),
                                              SC::chiralities(items, np)};
  };
  Cloud line, spot;
  for(int i = 0; i < 30; ++i)
  {
    line.points.push_back({.1 * i, .2 * i, 1e3 - .3 * i});
    spot.points.push_back({1., 2., 3.});
  }
  line.normals.assign(30, up);
  spot.normals.assign(30, up);
  Cloud bad = wavy_cloud(100, 13);
  bad.points[0] = {nan, 0., 0.};
  bad.normals[1] = {0., 0., 0.};
  bad.normals[2] = {nan, 0., 0.};
  bad.points[3] = bad.points[4];
  for(std::size_t n = 0; n <= 3; ++n)
    for(const SC::Descriptor_matrix& m : all(wavy_cloud(n, 14)))
      BOOST_TEST(number_of(Estimation_status::FEW_NEIGHBOURS, m) == n);
  // three neighbors are enough, and so are three curvatures
  const SC::Neighborhood all_others = SC::Neighborhood::ball(100.);
  const auto status_if = [](bool is_enough)
  { return is_enough ? Estimation_status::ESTIMATED : Estimation_status::FEW_NEIGHBOURS; };
  for(const std::size_t n : {3u, 4u})
    for(const SC::Descriptor_matrix& m :
        signals_of(wavy_cloud(n, 14), all_others, some_values(n, 1), some_values(n, 2)).matrices)
      BOOST_TEST(number_of(status_if(n == 4), m) == n);
  const Cloud four = wavy_cloud(4, 14);
  const SC::Point_set_samples s = samples_of(four, all_others);
  const std::vector<double> values = some_values(4, 2);
  std::vector<double> incomplete = some_values(4, 1);
  for(const std::size_t missing : {1u, 2u})
  {
    incomplete[missing] = nan;
    BOOST_TEST(number_of(status_if(missing == 1), compute<Volume>(s, incomplete, values)) == 4u);
    BOOST_TEST(number_of(status_if(missing == 1), compute<Chirality>(s, values, incomplete)) == 4u);
  }
  for(const SC::Descriptor_matrix& m : all(line))
    BOOST_TEST(number_of(Estimation_status::DEGENERATE, m) == 30u);
  for(const SC::Descriptor_matrix& m : all(spot))
    BOOST_TEST(number_of(Estimation_status::FEW_NEIGHBOURS, m) == 30u);
  for(const SC::Descriptor_matrix& m : all(bad))
  {
    BOOST_TEST(is_consistent(m));
    BOOST_TEST(number_of(Estimation_status::NON_FINITE_INPUT, m) == 3u);
    BOOST_TEST(number_of(Estimation_status::ESTIMATED, m) == 97u);
  }
  BOOST_CHECK_THROW(SC::chiralities(std::vector<Kernel::Point_3>()), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
