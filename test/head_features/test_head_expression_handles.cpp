#include <boost/test/unit_test.hpp>

#include "handles_on_surfaces.h"
#include "raise_to.h"

#include <Shape_characteristics/head_features/deform_by_handles.h>
#include <Shape_characteristics/head_features/head_expression_handles.h>

#include <CGAL/Aff_transformation_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(head_expression_handles)

using namespace handles_on_surfaces;
using SC::Head_expression;
using Feature = SC::Head_feature;
using Features = SC::Head_features<Mesh, Kernel>;
using Motion = CGAL::Aff_transformation_3<Kernel>;

namespace {

// a ball with the proportions of a head, and its feature points; in the frame of heads but for `motion`
struct Ball_head
{
  Mesh mesh;
  Features features;

  explicit Ball_head(const Motion& motion = Motion(CGAL::IDENTITY))
  {
    mesh = test_support::build_mesh<Mesh>(test_support::ellipsoid(.38, .5, .42, 5));
    const std::vector<std::pair<Feature, std::pair<double, double> > > places = {
        {Feature::TOP, {0., .5}},        {Feature::NOSE_TIP, {0., -.07}},  {Feature::CHIN, {0., -.34}},
        {Feature::LEFT_E2, {-.07, .05}}, {Feature::RIGHT_E2, {.07, .05}},  {Feature::N1, {0., -.14}},
        {Feature::N2, {0., -.07}},       {Feature::N4, {0., .06}},         {Feature::M1, {-.09, -.23}},
        {Feature::M2, {.09, -.23}},      {Feature::M3, {0., -.2}},         {Feature::M4, {0., -.25}},
        {Feature::LEFT_R1, {-.35, .04}}, {Feature::LEFT_R3, {-.33, -.17}}, {Feature::RIGHT_R1, {.35, .04}},
        {Feature::RIGHT_R3, {.33, -.17}}};
    features.is_head = true;
    for(const auto& [feature, p] : places)
    {
      const double square = 1. - std::pow(p.first / .38, 2) - std::pow(p.second / .5, 2);
      const Vertex v = vertex_at(mesh, p.first, p.second, .42 * std::sqrt(std::max(square, 0.)));
      features[feature] = {true, motion.transform(mesh.point(v)), v, 1.};
    }
    for(const Vertex v : mesh.vertices())
      mesh.point(v) = motion.transform(mesh.point(v));
    features.transformation = motion.inverse();
  }

  Points deformed(Head_expression expression, double intensity = 1.) const
  {
    Mesh copy = mesh;
    SC::deform_by_handles(copy, SC::head_expression_handles(expression, features, intensity));
    return points_of(copy);
  }

  Vector_3 way(const Points& after, Feature f) const
  {
    return after[features[f].vertex] - mesh.point(features[f].vertex);
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(expressions_move_what_they_say)
{
  const Ball_head head;
  const auto moved = [&](Head_expression e, Feature f) { return head.way(head.deformed(e), f); };
  // left is where x is negative
  const Vector_3 smile_left = moved(Head_expression::SMILE, Feature::M1),
                 smile_right = moved(Head_expression::SMILE, Feature::M2);
  BOOST_TEST(smile_left.x() < -.01);
  BOOST_TEST(smile_right.x() > .01);
  BOOST_TEST(smile_left.y() > .02);
  BOOST_TEST(std::abs(smile_left.y() - smile_right.y()) < 1e-3);
  // as in a mirror, and to the back along the teeth
  BOOST_TEST(std::abs(smile_left.x() + smile_right.x()) < 1e-3);
  BOOST_TEST(std::abs(smile_left.z() - smile_right.z()) < 1e-3);
  BOOST_TEST(smile_left.z() < -.01);
  BOOST_TEST(length(moved(Head_expression::SMILE, Feature::M3)) < 1e-12);
  BOOST_TEST(length(moved(Head_expression::SMILE, Feature::TOP)) < 1e-12);
  BOOST_TEST(moved(Head_expression::SAD, Feature::M1).y() < -.02);
  BOOST_TEST(moved(Head_expression::SAD, Feature::M2).y() < -.02);
  BOOST_TEST(moved(Head_expression::WIDE_MOUTH, Feature::M1).x() < -.03);
  BOOST_TEST(std::abs(moved(Head_expression::WIDE_MOUTH, Feature::M1).y()) < 1e-12);
  BOOST_TEST(moved(Head_expression::LONGER_EAR_LOBE, Feature::LEFT_R3).y() < -.05);
  BOOST_TEST(moved(Head_expression::LONGER_EAR_LOBE, Feature::RIGHT_R3).y() < -.05);
  BOOST_TEST(length(moved(Head_expression::LONGER_EAR_LOBE, Feature::LEFT_R1)) < 1e-12);
  BOOST_TEST(moved(Head_expression::LONGER_CHIN, Feature::CHIN).y() < -.04);
  BOOST_TEST(length(moved(Head_expression::LONGER_CHIN, Feature::M4)) < 1e-12);
  BOOST_TEST(moved(Head_expression::BIGGER_NOSE, Feature::N2).z() > .005);
  BOOST_TEST(length(moved(Head_expression::BIGGER_NOSE, Feature::LEFT_E2)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(units_and_poses_do_not_matter)
{
  const Ball_head head;
  const double c = .6, s = .8;
  for(const double scale : {1e-4, 250.})
  {
    const Motion motion(scale * c, 0, scale * s, 3 * scale, 0, scale, 0, -2 * scale, -scale * s, 0, scale * c,
                        scale);
    const Ball_head other(motion);
    for(std::size_t i = 0; i < SC::number_of_head_expressions; ++i)
    {
      const Points expected = head.deformed(Head_expression(i)), found = other.deformed(Head_expression(i));
      double largest = 0.;
      for(std::size_t v = 0; v < expected.size(); ++v)
        test_support::raise_to(largest, length(found[v] - motion.transform(expected[v])) / scale);
      BOOST_TEST(largest < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(intensity)
{
  const Ball_head head;
  for(std::size_t i = 0; i < SC::number_of_head_expressions; ++i)
  {
    const auto e = Head_expression(i);
    BOOST_TEST_CONTEXT(SC::to_string(e))
    {
      BOOST_TEST(largest_difference(head.deformed(e, 0.), points_of(head.mesh)) == 0.);
      const double half = largest_difference(head.deformed(e, .5), points_of(head.mesh)),
                   whole = largest_difference(head.deformed(e), points_of(head.mesh));
      BOOST_TEST(half > .4 * whole);
      BOOST_TEST(half < .6 * whole);
    }
  }
  BOOST_TEST(head.way(head.deformed(Head_expression::SMILE, -1.), Feature::M1).y() < 0.);
  for(const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    BOOST_CHECK_THROW(SC::head_expression_handles(Head_expression::SMILE, head.features, bad),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(what_is_missing_is_named)
{
  const auto message = [](const Features& features, Head_expression e) -> std::string
  {
    try
    {
      SC::head_expression_handles(e, features);
    }
    catch(const std::invalid_argument& error)
    {
      return error.what();
    }
    return "";
  };
  const auto without = [](std::vector<Feature> missing)
  {
    Features features = Ball_head().features;
    for(const Feature f : missing)
      features[f].is_found = false;
    return features;
  };
  BOOST_TEST(message(without({Feature::M2}), Head_expression::SMILE) ==
             "Shape_characteristics: SMILE needs M2, which was not found on this head");
  BOOST_TEST(message(without({Feature::N1}), Head_expression::BIGGER_NOSE) ==
             "Shape_characteristics: BIGGER_NOSE needs N1, which was not found on this head");
  BOOST_TEST(message(without({Feature::CHIN}), Head_expression::LONGER_CHIN) ==
             "Shape_characteristics: LONGER_CHIN needs CHIN, which was not found on this head");
  // what only holds may be missing, and one ear is enough
  BOOST_TEST(message(without({Feature::M3, Feature::M4}), Head_expression::SMILE) == "");
  BOOST_TEST(message(without({Feature::M4}), Head_expression::LONGER_CHIN) == "");
  const Features one_ear = without({Feature::LEFT_R3});
  BOOST_TEST(message(one_ear, Head_expression::LONGER_EAR_LOBE) == "");
  Ball_head head;
  head.features = one_ear;
  const Points after = head.deformed(Head_expression::LONGER_EAR_LOBE);
  BOOST_TEST(length(head.way(after, Feature::LEFT_R3)) == 0.);
  BOOST_TEST(length(head.way(after, Feature::RIGHT_R3)) > .05);
  BOOST_TEST(
      message(without({Feature::LEFT_R3, Feature::RIGHT_R1}), Head_expression::LONGER_EAR_LOBE) ==
      "Shape_characteristics: LONGER_EAR_LOBE needs R1 and R3 of an ear, which were not found on this head");
  // points that can't be
  Features coincident = without({});
  coincident[Feature::M2] = coincident[Feature::M1];
  BOOST_TEST(message(coincident, Head_expression::SMILE) != "");
  Features flat = without({});
  flat.transformation = Motion(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  BOOST_TEST(message(flat, Head_expression::SMILE) != "");
  // nothing was found at all
  for(std::size_t i = 0; i < SC::number_of_head_expressions; ++i)
    BOOST_TEST(message(Features(), Head_expression(i)) != "");
}

BOOST_AUTO_TEST_SUITE_END()
