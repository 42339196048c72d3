#include <boost/test/unit_test.hpp>

#include "hrbf_estimator.h"

#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(hrbf_threads)

namespace SC = Shape_characteristics;
using namespace estimator_checks;

BOOST_AUTO_TEST_CASE(results_do_not_depend_on_threads)
{
  check_threads(Hrbf{[](const auto& np) { return np.normals_are_exact(true); }});
  check_threads(Hrbf{[](const auto& np) { return np.number_of_rings(2u); }});
  check_threads(Hrbf{[](const auto& np) { return np.noise_level(1e-3).number_of_passes(2u); }});
}

// the level, and what part of it each pass expects, are those of the data
BOOST_AUTO_TEST_CASE(results_over_noise_do_not_depend_on_threads)
{
  check_threads(Hrbf{[](const auto& np) { return np.number_of_rings(2u); }},
                test_support::with_noise(test_support::torus(1., .4, 64, 32, .2, 6), .03));
}

// one call at a time: its variables need no lock
BOOST_AUTO_TEST_CASE(callback)
{
  const Analytic_surface s = test_support::torus(1., .4, 128, 64, .2, 6);
  std::vector<double> advancements;
  const Hrbf watched{[&](const auto& np)
                     {
                       return np.noise_level(1e-3).number_of_passes(2u).callback(
                           [&](double t)
                           {
                             advancements.push_back(t);
                             return true;
                           });
                     }};
  const Result result = run<CGAL::Parallel_if_available_tag>(watched, s, Normals::ESTIMATED);
  BOOST_TEST(result.failures == 0u);
  BOOST_TEST(advancements.size() == 16u); // 8 patches of vertices, two passes
  BOOST_TEST(std::is_sorted(advancements.begin(), advancements.end()));
  BOOST_TEST(std::abs(advancements.back() - 1.) < 1e-12);

  int calls = 0;
  const Hrbf stopped{[&](const auto& np) { return np.callback([&](double) { return calls++ < 1; }); }};
  const Result incomplete = run<CGAL::Parallel_if_available_tag>(stopped, s, Normals::EXACT);
  check_consistency(incomplete);
  BOOST_TEST(calls == 2);
  BOOST_TEST(incomplete.failures > 0u);
  BOOST_TEST(incomplete.failures < s.points.size());
  for(const auto status : incomplete.status)
    BOOST_TEST((status == SC::Estimation_status::ESTIMATED || status == SC::Estimation_status::CANCELLED));
}

BOOST_AUTO_TEST_SUITE_END()
