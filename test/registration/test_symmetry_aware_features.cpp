#include <boost/test/unit_test.hpp>

#include "../descriptors/oriented_cloud.h"

#include <Shape_characteristics/descriptors/Chirality_descriptor.h>
#include <Shape_characteristics/descriptors/Fpfh_descriptor.h>
#include <Shape_characteristics/descriptors/Shot_descriptor.h>
#include <Shape_characteristics/descriptors/Signed_volume_descriptor.h>
#include <Shape_characteristics/descriptors/Symmetry_flux_descriptor.h>
#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/registration/Appended_descriptor.h>
#include <Shape_characteristics/registration/Scaled_descriptor.h>
#include <Shape_characteristics/registration/append_descriptors.h>
#include <Shape_characteristics/registration/mirrored_descriptors.h>
#include <Shape_characteristics/registration/multiply_descriptors.h>
#include <Shape_characteristics/registration/signal_factors.h>
#include <Shape_characteristics/registration/symmetry_aware_features.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(symmetry_aware_features)

using namespace oriented_cloud;
using SC::Estimation_status;
using SC::Symmetry_aware_variant;
using Samples = SC::Point_set_samples;
using Fpfh = SC::Fpfh_descriptor<Samples>;
using Shot = SC::Shot_descriptor<Samples>;
using Flux = SC::Symmetry_flux_descriptor<Samples>;
using Volume = SC::Signed_volume_descriptor<Samples>;
using Chirality = SC::Chirality_descriptor<Samples>;

namespace {

const SC::Neighborhood ball = SC::Neighborhood::ball(.3);

template <typename Tag = CGAL::Sequential_tag, typename Descriptor>
SC::Descriptor_matrix all(const Descriptor& descriptor, std::size_t size)
{
  return SC::compute_descriptors<Tag>(descriptor, size);
}

std::vector<double> values(std::size_t size, std::size_t step)
{
  std::vector<double> result;
  for(std::size_t i = 0; i < size; ++i)
    result.push_back(double(i * step % 101) / 101. - .4);
  return result;
}

// some descriptors and all signals of a cloud, one sample of which has none
struct Described
{
  Samples samples;
  Fpfh fpfh;
  Shot shot;
  Flux flux;
  Volume volume;
  Chirality chirality;

  explicit Described(const Cloud& cloud)
    : samples(samples_of(cloud, ball)),
      fpfh(samples),
      shot(samples),
      flux(samples, SC::Flux_method::POINTS, SC::Signal_scaling::AS_PRINTED),
      volume(samples, values(samples.size(), 17), values(samples.size(), 29)),
      chirality(samples, values(samples.size(), 17), values(samples.size(), 29))
  {}
  Described(const Described&) = delete;
};

Cloud test_cloud()
{
  Cloud cloud = wavy_cloud(700, 3);
  cloud.normals[7] = Vector3d::Zero();
  return cloud;
}

SC::Descriptor_matrix matrix(std::initializer_list<std::initializer_list<float> > rows)
{
  SC::Descriptor_matrix m;
  m.values.resize(Eigen::Index(rows.size()), Eigen::Index(rows.begin()->size()));
  Eigen::Index i = 0;
  for(const auto& row : rows)
  {
    Eigen::Index k = 0;
    for(const float x : row)
      m.values(i, k++) = x;
    ++i;
  }
  m.status.assign(rows.size(), Estimation_status::ESTIMATED);
  return m;
}

} // namespace

BOOST_AUTO_TEST_CASE(by_hand)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  SC::Descriptor_matrix features = matrix({{1, 2}, {3, 4}, {nan, nan}, {5, 6}}),
                        signals = matrix({{10, -1}, {20, 2}, {30, 3}, {nan, nan}});
  features.status[2] = Estimation_status::DEGENERATE;
  signals.status[3] = Estimation_status::FEW_NEIGHBOURS;
  signals.status[1] = Estimation_status::BORDER;
  const std::vector<Estimation_status> status = {Estimation_status::ESTIMATED, Estimation_status::BORDER,
                                                 Estimation_status::DEGENERATE,
                                                 Estimation_status::FEW_NEIGHBOURS};
  SC::Descriptor_matrix expected =
      matrix({{1, 2, 20, -3}, {3, 4, 40, 6}, {nan, nan, nan, nan}, {nan, nan, nan, nan}});
  expected.status = status;
  BOOST_TEST(difference(SC::append_descriptors(features, signals, {2., 3.}), expected) == 0.);
  expected = matrix({{-1, -2}, {6, 8}, {nan, nan}, {nan, nan}});
  expected.status = status;
  BOOST_TEST(difference(SC::multiply_descriptors(features, signals, 1), expected) == 0.);

  // over the rows with a value, of all matrices
  const std::vector<double> factors = SC::signal_factors(6., signals, matrix({{0, 3}}));
  BOOST_TEST(factors.size() == 2u);
  BOOST_TEST(std::abs(factors[0] - 6. / std::sqrt((100. + 400. + 900.) / 4.)) < 1e-12);
  BOOST_TEST(std::abs(factors[1] - 6. / std::sqrt((1. + 4. + 9. + 9.) / 4.)) < 1e-12);
  BOOST_TEST(SC::signal_factors(6., matrix({{0}, {0}}))[0] == 0.);
  BOOST_TEST(SC::signal_factors(6., matrix({{1e-30f}}))[0] > 5.9e30);

  // the four of the thesis
  features = matrix({{1, 2}});
  const SC::Descriptor_matrix flux = matrix({{-3}}), volumes = matrix({{5, 7}});
  const auto variant = [&](int number)
  { return SC::symmetry_aware_features(Symmetry_aware_variant(number), features, flux, volumes); };
  BOOST_TEST(difference(variant(1), matrix({{-3, -6, -3}})) == 0.);
  BOOST_TEST(difference(variant(2), matrix({{-3, -6, 5}})) == 0.);
  BOOST_TEST(difference(variant(3), matrix({{-3, -6, -3, 5, 7}})) == 0.);
  BOOST_TEST(difference(variant(4), matrix({{-3, -6, 5, 7}})) == 0.);
  BOOST_CHECK_THROW(variant(5), std::invalid_argument);

  // out of the range of numbers
  const SC::Descriptor_matrix huge = SC::multiply_descriptors(matrix({{1e30f}}), matrix({{1e30f}}));
  BOOST_TEST((huge.status[0] == Estimation_status::DEGENERATE));
  BOOST_TEST(std::isnan(huge.values(0, 0)));

  BOOST_CHECK_THROW(SC::append_descriptors(features, signals), std::invalid_argument);
  BOOST_CHECK_THROW(SC::append_descriptors(features, volumes, {1.}), std::invalid_argument);
  BOOST_CHECK_THROW(SC::append_descriptors(features, flux, {std::nan("")}), std::invalid_argument);
  BOOST_CHECK_THROW(SC::multiply_descriptors(features, flux, 1), std::invalid_argument);
  BOOST_CHECK_THROW(SC::signal_factors(1., flux, volumes), std::invalid_argument);
  BOOST_CHECK_THROW(SC::signal_factors(1., SC::Descriptor_matrix(), volumes), std::invalid_argument);
  BOOST_CHECK_THROW(SC::signal_factors(std::nan(""), flux), std::invalid_argument);
  SC::Descriptor_matrix short_of_rows = flux;
  short_of_rows.status.push_back(Estimation_status::ESTIMATED);
  BOOST_CHECK_THROW(SC::signal_factors(1., short_of_rows), std::invalid_argument);
  BOOST_CHECK_THROW(SC::symmetry_aware_features(Symmetry_aware_variant::FLUX, features, volumes, volumes),
                    std::invalid_argument);
  BOOST_TEST(SC::append_descriptors(SC::Descriptor_matrix(), SC::Descriptor_matrix()).values.rows() == 0);
}

// the classes give what the functions of matrices give
BOOST_AUTO_TEST_CASE(classes)
{
  const Described d(test_cloud());
  const std::size_t n = d.samples.size();
  const SC::Descriptor_matrix fpfh = all(d.fpfh, n), flux = all(d.flux, n), volume = all(d.volume, n);
  const std::vector<double> factors = SC::signal_factors(60., volume);

  const SC::Appended_descriptor<Fpfh, Volume> appended(d.fpfh, d.volume, factors);
  BOOST_TEST(appended.dimension() == 35u);
  const SC::Descriptor_matrix m = all(appended, n);
  BOOST_TEST(is_consistent(m));
  BOOST_TEST((m.status[7] == Estimation_status::NON_FINITE_INPUT));
  BOOST_TEST(number_of(Estimation_status::ESTIMATED, m) == n - 1);
  BOOST_TEST(difference(m, SC::append_descriptors(fpfh, volume, factors)) == 0.);
  BOOST_TEST(same_bits(all<CGAL::Parallel_if_available_tag>(appended, n), m));
  double squares = 0.;
  for(std::size_t i = 0; i < n; ++i)
    squares += i == 7 ? 0. : std::pow(double(m.values(Eigen::Index(i), 33)), 2);
  BOOST_TEST(std::abs(std::sqrt(squares / double(n - 1)) - 60.) < 1e-4);

  // the thesis's fourth, by classes
  using Product = SC::Scaled_descriptor<Fpfh, Flux>;
  const Product product(d.fpfh, d.flux);
  const SC::Appended_descriptor<Product, Volume> fourth(product, d.volume);
  BOOST_TEST(difference(all(fourth, n), SC::symmetry_aware_features(Symmetry_aware_variant::VOLUMES, fpfh,
                                                                    flux, volume)) == 0.);
  const SC::Scaled_descriptor<Fpfh, Volume> by_second(d.fpfh, d.volume, 1);
  BOOST_TEST(difference(all(by_second, n), SC::multiply_descriptors(fpfh, volume, 1)) == 0.);
  BOOST_CHECK_THROW((SC::Scaled_descriptor<Fpfh, Volume>(d.fpfh, d.volume, 2)), std::invalid_argument);
  BOOST_CHECK_THROW((SC::Appended_descriptor<Fpfh, Volume>(d.fpfh, d.volume, {1.})), std::invalid_argument);
}

// `mirrored()` gives what the mirrored surface has, whatever was combined
BOOST_AUTO_TEST_CASE(mirror)
{
  const Described here(test_cloud()), there(mirrored(test_cloud()));
  const std::size_t n = here.samples.size();
  const auto check = [&](const auto& descriptor, const auto& of_mirrored, double tolerance)
  {
    const SC::Descriptor_matrix m = all(descriptor, n), expected = all(of_mirrored, n);
    BOOST_TEST(difference(SC::mirrored_descriptors(descriptor, m), expected) < tolerance);
    BOOST_TEST(difference(m, expected) > 100. * tolerance);
  };
  const auto appended = [](const Described& d)
  { return SC::Appended_descriptor<Fpfh, Chirality>(d.fpfh, d.chirality, {40.}); };
  check(appended(here), appended(there), 2e-3);
  const auto shot = [](const Described& d) {
    return SC::Appended_descriptor<Shot, Volume>(d.shot, d.volume, {.1, .2});
  };
  check(shot(here), shot(there), 1e-5);
  const auto scaled = [](const Described& d) { return SC::Scaled_descriptor<Shot, Flux>(d.shot, d.flux); };
  check(scaled(here), scaled(there), 1e-5);
  BOOST_CHECK_THROW(SC::mirrored_descriptors(here.fpfh, all(here.shot, 10)), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
