// The pitch that the features of a face tell.
#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/head_features/internal/pitch_of_features.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(pitch_of_features)

namespace SC = Shape_characteristics;
using SC::Head_feature;
using SC::internal::Found_head_features;
using SC::internal::Mean_feature;

namespace {

constexpr double degree = CGAL_PI / 180.;

// all features of the mean face, moved
Found_head_features found_at(const Eigen::Affine3d& motion)
{
  Found_head_features found;
  for(const Mean_feature& m : SC::internal::mean_features())
  {
    found[m.feature].place.position = motion * m.position;
    found[m.feature].place.triangle = 0;
    found[m.feature].confidence = 1.;
  }
  return found;
}

Found_head_features turned(double angle)
{
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.translate(Eigen::Vector3d(0., .05, -.03)).rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()));
  motion.scale(1.1);
  return found_at(motion);
}

} // namespace

BOOST_AUTO_TEST_CASE(of_the_mean_face)
{
  BOOST_TEST(std::abs(SC::internal::pitch_of_features(turned(0.))) < 1e-3 * degree);
  for(const double angle : {-4., -1., 2., 5.})
  {
    // a quarter of it is taken for an error of the frame that isn't there: features decide
    const double found = SC::internal::pitch_of_features(turned(angle * degree)) / degree;
    BOOST_TEST_CONTEXT(angle << " degrees, found " << found)
    {
      BOOST_TEST(found / angle > .7);
      BOOST_TEST(found / angle < 1.);
    }
  }
  // places and sizes don't count
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.rotate(Eigen::AngleAxisd(2. * degree, Eigen::Vector3d::UnitX()));
  BOOST_TEST(std::abs(SC::internal::pitch_of_features(found_at(motion)) -
                      SC::internal::pitch_of_features(turned(2. * degree))) < .1 * degree);
}

// Faces of which each feature is elsewhere by 1 % of the frame: the pitch is right within a degree (root mean square).
BOOST_AUTO_TEST_CASE(of_other_faces)
{
  std::mt19937 random(1);
  std::normal_distribution<double> offset(0., .01);
  double squares = 0.;
  constexpr int faces = 100;
  for(int k = 0; k < faces; ++k)
  {
    Found_head_features found = turned(0.);
    for(auto& p : found.points)
      p.place.position += Eigen::Vector3d(offset(random), offset(random), offset(random));
    const double error = SC::internal::pitch_of_features(found) / degree;
    squares += error * error;
  }
  BOOST_TEST(std::sqrt(squares / faces) < 1.);
}

BOOST_AUTO_TEST_CASE(open_mouth)
{
  // as when the chin goes down by a tenth of the head
  Found_head_features found = turned(0.);
  for(const Mean_feature& m : SC::internal::mean_features())
    found[m.feature].place.position += m.moves_with_jaw * Eigen::Vector3d(0., -.1, -.03);
  BOOST_TEST(std::abs(SC::internal::pitch_of_features(found)) < .5 * degree);
  // were the mouth closed all the same, the face would be turned
  found[Head_feature::M4].place.triangle = SC::internal::Surface_point::no_triangle;
  BOOST_TEST(std::abs(SC::internal::pitch_of_features(found)) > degree);
}

BOOST_AUTO_TEST_CASE(few_features)
{
  Found_head_features found = turned(3. * degree);
  int left = 0;
  for(const Mean_feature& m : SC::internal::mean_features())
    if(++left > 7)
      found[m.feature].place.triangle = SC::internal::Surface_point::no_triangle;
  BOOST_TEST(SC::internal::pitch_of_features(found) == 0.);
  BOOST_TEST(SC::internal::pitch_of_features(Found_head_features()) == 0.);
  // all in one place
  Found_head_features same = turned(0.);
  for(auto& p : same.points)
    p.place.position = Eigen::Vector3d(0., 0., .4);
  BOOST_TEST(std::isfinite(SC::internal::pitch_of_features(same)));
}

BOOST_AUTO_TEST_SUITE_END()
