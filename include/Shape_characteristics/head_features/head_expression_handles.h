#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_EXPRESSION_HANDLES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_EXPRESSION_HANDLES_H

#include <Shape_characteristics/head_features/Head_expression.h>
#include <Shape_characteristics/head_features/Head_feature.h>
#include <Shape_characteristics/head_features/Head_features.h>
#include <Shape_characteristics/head_features/Surface_handle.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// makes the handles of an expression, in lengths that the head gives
template <typename FaceGraph, typename GeomTraits>
class Deform_expression
{
public:
  using Features = Head_features<FaceGraph, GeomTraits>;
  using Handle = Surface_handle<FaceGraph, GeomTraits>;
  using FT = typename GeomTraits::FT;
  using Point_3 = typename GeomTraits::Point_3;
  using Vector_3 = typename GeomTraits::Vector_3;
  using Feature = Head_feature;

  Deform_expression(Head_expression expression, const Features& head, double intensity)
    : m_expression(expression),
      m_head(head),
      m_intensity(intensity)
  {
    // the axes of the head's frame, in the mesh's coordinates
    const auto back = head.transformation.inverse();
    m_right = unit(back.transform(Vector_3(1, 0, 0)));
    m_up = unit(back.transform(Vector_3(0, 1, 0)));
    m_front = unit(back.transform(Vector_3(0, 0, 1)));
  }

  std::vector<Handle> handles() const
  {
    switch(m_expression)
    {
    case Head_expression::SMILE:
      return mouth(.17, .19, -.11, .34);
    case Head_expression::SAD:
      return mouth(-.02, -.17, -.03, .30);
    case Head_expression::WIDE_MOUTH:
      return mouth(.22, 0., -.12, .34);
    case Head_expression::LONGER_EAR_LOBE:
      return ear_lobes();
    case Head_expression::LONGER_CHIN:
      return chin();
    case Head_expression::BIGGER_NOSE:
      return nose();
    }
    throw std::invalid_argument("Shape_characteristics: there is no such Head_expression");
  }

private:
  static double length(const Vector_3& v) { return std::sqrt(CGAL::to_double(v.squared_length())); }

  static Vector_3 unit(const Vector_3& v)
  {
    const double l = length(v);
    if(!(l > 0.) || !std::isfinite(l))
      throw std::invalid_argument("Shape_characteristics: the transformation of the head is not invertible");
    return v / FT(l);
  }

  bool has(Feature f) const { return m_head[f].is_found; }

  Point_3 at(Feature f) const
  {
    if(!has(f))
      throw std::invalid_argument(std::string("Shape_characteristics: ") + to_string(m_expression) +
                                  " needs " + to_string(f) + ", which was not found on this head");
    return m_head[f].position;
  }

  typename Handle::Surface_point on(Feature f) const
  {
    const Point_3 p = at(f);
    return {m_head[f].vertex, p};
  }

  double distance(Feature f, Feature g) const
  {
    const double d = length(at(g) - at(f));
    if(!(d > 0.) || !std::isfinite(d))
      throw std::invalid_argument(std::string("Shape_characteristics: ") + to_string(f) + " and " +
                                  to_string(g) + " of this head coincide, or are not finite");
    return d;
  }

  // to the right, up and to the front, as much as is asked for
  Vector_3 way(double right, double up, double front) const
  {
    return FT(m_intensity * right) * m_right + FT(m_intensity * up) * m_up +
           FT(m_intensity * front) * m_front;
  }

  // Both corners move alike, in units of the mouth's width, and the middles of the lips stay.
  std::vector<Handle> mouth(double outwards, double up, double front, double radius) const
  {
    const double width = distance(Feature::M1, Feature::M2);
    std::vector<Handle> result = {Handle::displacing({on(Feature::M1)}, radius * width,
                                                     way(-outwards * width, up * width, front * width)),
                                  Handle::displacing({on(Feature::M2)}, radius * width,
                                                     way(outwards * width, up * width, front * width))};
    for(const Feature lip : {Feature::M3, Feature::M4})
      if(has(lip))
        result.push_back(Handle::holding({on(lip)}, .9 * radius * width));
    return result;
  }

  // The lower corners of an ear go down by a third of its height, those above and its inside stay.
  std::vector<Handle> ear_lobes() const
  {
    std::vector<Handle> result;
    const std::array<std::array<Feature, 5>, 2> ears = {
        {{Feature::LEFT_R1, Feature::LEFT_R2, Feature::LEFT_R3, Feature::LEFT_R4, Feature::LEFT_R5},
         {Feature::RIGHT_R1, Feature::RIGHT_R2, Feature::RIGHT_R3, Feature::RIGHT_R4, Feature::RIGHT_R5}}};
    for(const auto& ear : ears)
    {
      if(!has(ear[0]) || !has(ear[2]))
        continue;
      const double height = distance(ear[0], ear[2]);
      result.push_back(Handle::displacing({on(ear[2])}, .2 * height, way(0., -.3 * height, 0.)));
      for(const Feature f : {ear[0], ear[1], ear[4]})
        if(has(f))
          result.push_back(Handle::holding({on(f)}, .2 * height));
    }
    if(result.empty())
      throw std::invalid_argument("Shape_characteristics: LONGER_EAR_LOBE needs R1 and R3 of an ear, which "
                                  "were not found on this head");
    return result;
  }

  // in units of the distance from the lower lip to the chin, or, without it, of half that from the base of the nose
  std::vector<Handle> chin() const
  {
    const double height =
        has(Feature::M4) ? distance(Feature::M4, Feature::CHIN) : distance(Feature::N1, Feature::CHIN) / 2.;
    std::vector<Handle> result = {
        Handle::displacing({on(Feature::CHIN)}, height, way(0., -.6 * height, .12 * height))};
    for(const Feature f : {Feature::M1, Feature::M2, Feature::M4})
      if(has(f))
        result.push_back(Handle::holding({on(f)}, .7 * height));
    return result;
  }

  // The nose grows about a point behind its base; eyes and lips stay.
  std::vector<Handle> nose() const
  {
    const double height = distance(Feature::N1, Feature::N4);
    const Point_3 root = at(Feature::N4), base = at(Feature::N1);
    const Point_3 center = base + FT(.2) * (root - base) - FT(.15 * height) * m_front;
    std::vector<Handle> result = {
        Handle::scaling({on(Feature::N2)}, .36 * height, center, std::exp(.3 * m_intensity))};
    for(const Feature f : {Feature::M3, Feature::LEFT_E2, Feature::RIGHT_E2})
      if(has(f))
        result.push_back(Handle::holding({on(f)}, .15 * height));
    return result;
  }

  Head_expression m_expression;
  const Features& m_head;
  double m_intensity;
  Vector_3 m_right, m_up, m_front;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  makes the handles that give a head a ready expression or shape (thesis, Figures 9.9 to 9.11):

      deform_by_handles(mesh, head_expression_handles(Head_expression::SMILE, detect_head_features(mesh)));

  The lengths of the motions and of their neighborhoods follow from the distances between the feature points, their directions from
  the head's frame: neither unit nor pose matters. Feature points that would be dragged along hold against it, where they were found.

  \tparam FaceGraph a model of `FaceListGraph`
  \tparam GeomTraits a \cgal kernel

  \param expression the expression
  \param head the feature points, as `detect_head_features()` finds them or somebody else has set them
  \param intensity how much of it: 1 is all, 0 nothing, and the opposite if negative

  \return the handles, for `deform_by_handles()` or `deform_as_rigid_as_possible()`

  \throws std::invalid_argument if a feature point that the expression needs was not found, and names it: M1 and M2 for expressions of
          the mouth, R1 and R3 of one ear at least for its lobe, CHIN and M4 or N1 for the chin, and N1, N2 and N4 for the nose; if two
          of them coincide or one isn't finite; if the head's transformation can't be inverted; if `intensity` is not finite

  Complexity: constant.

  \cgalExample{head_features/deform_head.cpp}
*/
template <typename FaceGraph, typename GeomTraits>
std::vector<Surface_handle<FaceGraph, GeomTraits> >
head_expression_handles(Head_expression expression,
                        const Head_features<FaceGraph, GeomTraits>& head,
                        double intensity = 1.)
{
  if(!std::isfinite(intensity))
    throw std::invalid_argument("Shape_characteristics: the intensity of an expression must be finite");
  return internal::Deform_expression<FaceGraph, GeomTraits>(expression, head, intensity).handles();
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_HEAD_EXPRESSION_HANDLES_H
