#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/registration/iterative_closest_point.h>
#include <Shape_characteristics/registration/match_descriptors.h>

#include "bumpy_ball.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

BOOST_AUTO_TEST_SUITE(threads_of_registration_steps)

namespace SC = Shape_characteristics;
using test_support::bumpy_ball;
using test_support::Random;

BOOST_AUTO_TEST_CASE(matches)
{
  Random random(1);
  for(const bool with_ties : {false, true})
  {
    SC::Descriptor_matrix source, target;
    for(auto* m : {&source, &target})
    {
      m->values.resize(1500, 6);
      for(Eigen::Index i = 0; i < m->values.size(); ++i)
        m->values.data()[i] = float(with_ties ? std::floor(4. * random.uniform()) : random.uniform());
      m->status.assign(1500, SC::Estimation_status::ESTIMATED);
    }
    const auto expected = SC::match_descriptors<CGAL::Sequential_tag>(source, target);
    for(int repetition = 0; repetition < 5; ++repetition)
      BOOST_TEST((SC::match_descriptors<CGAL::Parallel_if_available_tag>(source, target) == expected));
  }
}

BOOST_AUTO_TEST_CASE(closest_points)
{
  const SC::Oriented_points source = bumpy_ball(2000), target = bumpy_ball(1900, false, 1.);
  Eigen::Isometry3d start(Eigen::AngleAxisd(.05, Eigen::Vector3d(.6, 0., .8)));
  start.translation() << .01, .02, -.01;
  const auto expected = SC::iterative_closest_point<CGAL::Sequential_tag>(source, target, start);
  for(int repetition = 0; repetition < 3; ++repetition)
  {
    const auto result = SC::iterative_closest_point<CGAL::Parallel_if_available_tag>(source, target, start);
    BOOST_TEST((result.transformation.matrix() == expected.transformation.matrix())); // bit for bit
    BOOST_TEST((result.inliers == expected.inliers));
    BOOST_TEST(result.residual == expected.residual);
    BOOST_TEST(result.conditioning == expected.conditioning);
  }
}

BOOST_AUTO_TEST_SUITE_END()
