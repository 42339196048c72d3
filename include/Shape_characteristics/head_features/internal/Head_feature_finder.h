#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_FEATURE_FINDER_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_FEATURE_FINDER_H

#include <Shape_characteristics/head_features/Head_feature.h>
#include <Shape_characteristics/head_features/internal/Ear_finder.h>
#include <Shape_characteristics/head_features/internal/Eye_finder.h>
#include <Shape_characteristics/head_features/internal/Face_view.h>
#include <Shape_characteristics/head_features/internal/Found_head_features.h>
#include <Shape_characteristics/head_features/internal/Head_surface.h>
#include <Shape_characteristics/head_features/internal/Mouth_finder.h>
#include <Shape_characteristics/head_features/internal/Scalar_image.h>
#include <Shape_characteristics/head_features/internal/Skin_view.h>
#include <Shape_characteristics/head_features/internal/Surface_patch.h>
#include <Shape_characteristics/internal/solve_positive_semidefinite.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Finds the feature points and regions of a head by the shape of its surface, seen from the front, from above and from the sides.
//
// All lengths are in heights of the head (from its top to the lower end of the chin). Where a feature is to be looked for, the
// proportions of heads say; where it is, the surface.
class Head_feature_finder
{
public:
  using Index = Head_surface::Index;

  // `surface`: nose towards +z, top towards +y; `nose_tip`: about the tip of the nose, `height`: about the head's height
  Head_feature_finder(const Head_surface& surface, const Eigen::Vector3d& nose_tip, double height)
    : m_original(surface),
      m_origin(nose_tip),
      m_unit(height)
  {}

  Found_head_features find()
  {
    find_components();
    if(!find_face())
      return Found_head_features();
    find_mouth();
    find_midline();
    find_sides_of_nose();
    find_top();
    find_ears();
    find_regions();
    to_original();
    return m_found;
  }

  // the height of the head as it was found to be, in the unit of the surface
  double height() const
  {
    const auto &top = m_found[Head_feature::TOP], &chin = m_found[Head_feature::CHIN];
    return top.is_found() && chin.is_found() ? (top.position().y() - chin.position().y()) / s_top_to_chin
                                             : m_unit;
  }

private:
  bool sees_eyes() const
  {
    return m_found[Head_feature::LEFT_E1].confidence > .5 && m_found[Head_feature::RIGHT_E1].confidence > .5;
  }

  // The height of a head that is flat or looks up is guessed badly: where no eyes are seen, others are tried. The first guess stays if
  // there are eyes with none. False: there is no surface where the tip of the nose should be.
  bool find_face()
  {
    const Eigen::Vector3d origin = m_origin;
    const double unit = m_unit;
    const bool is_found = find_tip_and_eyes();
    if(is_found && sees_eyes())
      return true;
    const Eigen::Vector3d first_origin = m_origin;
    const double first_unit = m_unit;
    const Found_head_features first_found = m_found;
    std::optional<Face_view> first_view = std::move(m_view);
    for(const double factor : {1.2, 1.45, .83})
    {
      m_origin = origin;
      m_unit = factor * unit;
      if(find_tip_and_eyes() && sees_eyes())
        return true;
    }
    m_origin = first_origin;
    m_unit = first_unit;
    normalize();
    m_found = first_found;
    if(is_found)
      m_view.emplace(std::move(*first_view));
    return is_found;
  }

  // false: there is no surface where the tip of the nose should be
  bool find_tip_and_eyes()
  {
    for(int attempt = 0; attempt < 3; ++attempt)
    {
      m_found = Found_head_features();
      normalize();
      Skin_view view(m_surface, m_components);
      const std::optional<Eigen::Vector3d> tip = nose_tip(view);
      if(!tip)
        return false;
      // what follows is seen from the tip
      if(tip->norm() > .01 && attempt < 2)
      {
        m_origin += m_unit * *tip;
        continue;
      }
      m_view.emplace(std::move(view));
      find_eyes();
      // the distance of the eyes is the best measure of a head: no jaw, hair or hat changes it
      const double scale = distance_of_eyes() / s_distance_of_eyes;
      if(std::abs(scale - 1.) > .06 && attempt < 2 && scale > .5 && scale < 2.)
      {
        m_unit *= scale;
        continue;
      }
      break;
    }
    return true;
  }

  static constexpr double s_top_to_chin = .931;
  static constexpr double s_distance_of_eyes = .397; // between the outer corners

  // where features are to be expected, from the tip of the nose
  static constexpr double s_eye_u = .14, s_eye_v = .139, s_base = .072;
  static constexpr double s_least_width_of_eye = .095;
  static constexpr double s_below_lip =
      .004; // the middle of the lower lip is a little below its foremost point

  void find_components()
  {
    std::vector<Index>& parent = m_components;
    parent.resize(m_original.points.size());
    std::iota(parent.begin(), parent.end(), Index(0));
    const auto root = [&](Index i)
    {
      while(parent[i] != i)
        i = parent[i] = parent[parent[i]];
      return i;
    };
    for(const auto& t : m_original.triangles)
      for(std::size_t k = 1; k < 3; ++k)
      {
        const Index a = root(t[0]), b = root(t[k]);
        parent[std::max(a, b)] = std::min(a, b);
      }
    for(Index i = 0; i < parent.size(); ++i)
      parent[i] = root(i);
  }

  void normalize()
  {
    m_surface = m_original;
    for(Eigen::Vector3d& p : m_surface.points)
      p = (p - m_origin) / m_unit;
  }

  void to_original()
  {
    for(Found_head_features::Point& p : m_found.points)
      p.place.position = m_origin + m_unit * p.place.position;
  }

  void set(Head_feature feature, const Surface_point& place, double confidence)
  {
    if(!place.is_valid())
      return;
    m_found[feature].place = place;
    m_found[feature].confidence = std::min(std::max(confidence, 0.), 1.);
  }

  // The tip is where the nose reaches farthest forward and a little upward: farthest forward alone is the lower side of noses
  // that point upwards.
  std::optional<Eigen::Vector3d> nose_tip(const Skin_view& view)
  {
    const Skin_view::Smooth_part z = view.smooth_part(-.06, .06, -.08, .08, .02);
    const auto reach = [&](int i, int j)
    {
      return view.is_skin(i, j) && !std::isnan(z(i, j)) ? z(i, j) + s_upward * view.v(j)
                                                        : -std::numeric_limits<double>::infinity();
    };
    const Skin_view::Extremum tip = view.maximum(-.06, .06, -.08, .08, reach);
    if(!std::isfinite(tip.value))
      return std::nullopt;
    const Surface_point place = view.skin_point(tip.u, tip.v);
    if(!place.is_valid())
      return std::nullopt;
    set(Head_feature::NOSE_TIP, place, tip.is_inside ? 1. : .5);
    set(Head_feature::N2, place, tip.is_inside ? 1. : .5);
    return place.position;
  }
  static constexpr double s_upward = .16;

  void find_eyes()
  {
    const auto find = [&](int side, double width)
    { return Eye_finder(*m_view, side, side * s_eye_u, s_eye_v, width).find(); };
    std::array<Eye_outline, 2> eyes = {find(-1, s_least_width_of_eye), find(1, s_least_width_of_eye)};
    // an eye much narrower than the other one is closed in part
    if(eyes[0].certainty > 0. && eyes[1].certainty > 0. && eyes[0].width < .88 * eyes[1].width)
      eyes[0] = find(-1, eyes[1].width);
    else if(eyes[0].certainty > 0. && eyes[1].certainty > 0. && eyes[1].width < .88 * eyes[0].width)
      eyes[1] = find(1, eyes[0].width);
    for(const int side : {-1, 1})
    {
      const Eye_outline& eye = eyes[side < 0 ? 0 : 1];
      if(!(eye.certainty > 0.))
        continue;
      const auto feature = [&](int k)
      {
        return static_cast<Head_feature>(
            static_cast<int>(side < 0 ? Head_feature::LEFT_E1 : Head_feature::RIGHT_E1) + k);
      };
      const double u = .5 * (eye.outer_corner.u + eye.inner_corner.u),
                   v = .5 * (eye.outer_corner.v + eye.inner_corner.v);
      const double confidence =
          eye.certainty * plausibility(std::hypot(u - side * s_eye_u, v - s_eye_v), .05);
      const auto place = [&](const Eye_outline::Place& p) { return m_view->skin_point(p.u, p.v); };
      set(feature(0), place(eye.outer_corner), confidence);
      set(feature(1), place(eye.inner_corner), confidence);
      set(feature(2), place(eye.upper[0]), confidence);
      set(feature(3), place(eye.upper[1]), confidence);
      set(feature(4), place(eye.lower[0]), confidence);
      set(feature(5), place(eye.lower[1]), confidence);
    }
  }

  double distance_of_eyes() const
  {
    const auto &left = m_found[Head_feature::LEFT_E1], &right = m_found[Head_feature::RIGHT_E1];
    return left.is_found() && right.is_found() ? right.position().x() - left.position().x()
                                               : s_distance_of_eyes;
  }

  // x of the midline at the height v: through the tip of the nose, above it to the middle between the eyes, and below it at a right
  // angle to the line through the eyes (the mouth may be drawn to one side)
  double midline(double v) const
  {
    const Eigen::Vector3d& tip = m_found[Head_feature::NOSE_TIP].position();
    const auto &l1 = m_found[Head_feature::LEFT_E1], &l2 = m_found[Head_feature::LEFT_E2],
               &r1 = m_found[Head_feature::RIGHT_E1], &r2 = m_found[Head_feature::RIGHT_E2];
    if(!l1.is_found() || !l2.is_found() || !r1.is_found() || !r2.is_found())
      return tip.x();
    if(v > tip.y())
    {
      const Eigen::Vector3d middle = .5 * (l2.position() + r2.position());
      return middle.y() - tip.y() < .05
                 ? tip.x()
                 : tip.x() + (v - tip.y()) / (middle.y() - tip.y()) * (middle.x() - tip.x());
    }
    const Eigen::Vector3d across = r1.position() + r2.position() - l1.position() - l2.position();
    return tip.x() - (v - tip.y()) * across.y() / across.x();
  }

  double profile(double v) const { return m_view->depth(midline(v), v); }

  // how strongly a profile is bent at `v`: positive where it is concave
  template <typename Depth>
  static double concavity(const Depth& depth, double v, double h)
  {
    const double a = depth(v - h), b = depth(v), c = depth(v + h), slope = (c - a) / (2 * h);
    return (a - 2 * b + c) / (h * h) / std::pow(1 + slope * slope, 1.5);
  }

  // the place between two heights where a function is greatest; NaN if it has no value anywhere
  template <typename Function>
  static double greatest(double v_min, double v_max, const Function& function)
  {
    constexpr double step = .001;
    double best = std::numeric_limits<double>::quiet_NaN(), value = -std::numeric_limits<double>::infinity();
    for(double v = v_min; v <= v_max; v += step)
    {
      const double here = function(v);
      if(here > value)
      {
        value = here;
        best = v;
      }
    }
    if(std::isnan(best))
      return best;
    return best + step * Face_view::vertex_of_parabola(function(best - step), value, function(best + step));
  }

  void set_on_midline(Head_feature feature, double v, double confidence)
  {
    if(!std::isnan(v))
      set(feature, m_view->skin_point(midline(v), v), confidence);
  }

  void find_mouth()
  {
    const Mouth_outline mouth = Mouth_finder(*m_view, midline(-.15), -.235, -.105).find();
    if(!(mouth.certainty > 0.))
      return;
    for(const int side : {-1, 1})
    {
      const Mouth_outline::Place& corner = mouth.corners[side < 0 ? 0 : 1];
      set(left_or_right(Head_feature::M1, Head_feature::M2, side), m_view->skin_point(corner.u, corner.v),
          mouth.certainty * plausibility(std::abs(side * corner.u - .11), .04));
    }
    const double upper = greatest(mouth.upper_lip + .004, mouth.upper_lip + .05,
                                  [&](double v) { return profile(v); }),
                 lower = greatest(mouth.lower_lip - .06, mouth.lower_lip - .004,
                                  [&](double v) { return profile(v); });
    set_on_midline(Head_feature::M3, upper, mouth.certainty);
    set_on_midline(Head_feature::M4, lower - s_below_lip, mouth.certainty);
  }

  void find_midline()
  {
    // the root of the nose is at the height of the eyes, where the profile is hollow
    const Eigen::Vector3d& tip = m_found[Head_feature::NOSE_TIP].position();
    const double chord_top = .32;
    const double hollow = greatest(.09, .22,
                                   [&](double v)
                                   {
                                     const double t = v / chord_top;
                                     return t * profile(chord_top) + (1 - t) * profile(0.) - profile(v);
                                   });
    double sum = 0.;
    int eyes = 0;
    for(const auto& [outer, inner] : {std::pair(Head_feature::LEFT_E1, Head_feature::LEFT_E2),
                                      std::pair(Head_feature::RIGHT_E1, Head_feature::RIGHT_E2)})
      if(m_found[outer].is_found() && m_found[inner].is_found())
      {
        sum += .5 * (m_found[outer].position().y() + m_found[inner].position().y());
        ++eyes;
      }
    const double root = eyes > 0 ? .75 * (sum / eyes + .015) + .25 * hollow : hollow;
    set_on_midline(Head_feature::N4, root, plausibility(root - hollow, .03));

    if(m_found[Head_feature::N4].is_found())
    {
      const Eigen::Vector3d predicted = .5 * (tip + m_found[Head_feature::N4].position());
      const double bridge =
          greatest(predicted.y() - .04, predicted.y() + .04,
                   [&](double v) { return -std::hypot(v - predicted.y(), profile(v) - predicted.z()); });
      set_on_midline(Head_feature::N3, bridge, m_found[Head_feature::N4].confidence);
    }

    find_base_of_nose();
    find_chin();
  }

  // The base of the nose is where the profile turns from the nose into the lip: farthest behind the chord from the tip to the
  // upper lip, and a little above that.
  void find_base_of_nose()
  {
    const auto& lip = m_found[Head_feature::M3];
    const Eigen::Vector3d& tip = m_found[Head_feature::NOSE_TIP].position();
    const double end = lip.is_found() ? lip.position().y() : tip.y() - .13, z_tip = profile(tip.y()),
                 z_end = profile(end);
    const double turn = greatest(end + .02, tip.y() - .02,
                                 [&](double v)
                                 {
                                   const double t = (v - tip.y()) / (end - tip.y());
                                   return (1 - t) * z_tip + t * z_end - profile(v);
                                 });
    set_on_midline(Head_feature::N1, turn + .0045, plausibility(turn - tip.y() + s_base, .03));
  }

  // The chin bulges between the fold below the lower lip and the lower end of the jaw, where a plane that leans against it from
  // below and in front touches it.
  void find_chin()
  {
    if(!m_found[Head_feature::M4].is_found())
      return;
    const double u = midline(-.3);
    const Face_view::Smooth_part z = m_view->smooth_part(u - .03, u + .03, -.6, -.15, .012);
    const auto depth = [&](double v)
    {
      const int i = m_view->column(midline(v));
      const double y = m_view->image().row(v);
      const int j = int(std::floor(y));
      return z(i, j) + (y - j) * (z(i, j + 1) - z(i, j));
    };
    const double lip = m_found[Head_feature::M4].position().y();
    const double fold = greatest(lip - .075, lip - .015, [&](double v) { return concavity(depth, v, .006); });
    if(std::isnan(fold))
      return;
    const double lower_end = greatest(fold - .2, fold - .04, [&](double v) { return depth(v) - 1.2 * v; });
    // what is below must be there, or the lower end may be where the surface was cut off
    if(std::isnan(lower_end) || std::isnan(depth(lower_end - .01)))
      return;
    const double chin = .65 * (.5 * (fold + lower_end) + .006) + .35 * (lip - .0865);
    set_on_midline(Head_feature::CHIN, chin, plausibility(fold - lower_end - .11, .03));
  }

  void find_sides_of_nose()
  {
    for(const int side : {-1, 1})
      for(const bool is_root : {false, true})
      {
        const auto& center = m_found[is_root ? Head_feature::N4 : Head_feature::N3];
        if(!center.is_found())
          continue;
        const double u = center.position().x() + side * (is_root ? .0625 : .0905),
                     v = center.position().y() + (is_root ? 0. : .005);
        set(is_root ? left_or_right(Head_feature::N6, Head_feature::N8, side)
                    : left_or_right(Head_feature::N5, Head_feature::N7, side),
            m_view->skin_point(u, v), center.confidence);
      }
  }

  // The highest point. Where vertices are noisy, it is that of a smoother surface; where they aren't, it is near one of them, as it
  // is on the surface itself.
  void find_top()
  {
    constexpr double pixel = .008, half = .5;
    constexpr double least_smoothing = .7, most_smoothing = 4.; // in pixels
    constexpr double smooth = .0003, rough = .0006; // edges of .03 are up to .0003 off a paraboloid
    const Depth_image above(m_surface, Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ(),
                            Eigen::Vector3d::UnitY(), -half, -.2, 2 * half, 1.2, pixel);
    Scalar_image height = above.depth().smoothed(most_smoothing);
    Pixel top = highest(height);
    const double roughness = roughness_about(above.depth(), top);
    if(roughness < rough)
    {
      const double part = (std::max)(0., (roughness - smooth) / (rough - smooth));
      height = above.depth().smoothed(least_smoothing + part * (most_smoothing - least_smoothing));
      top = highest(height);
    }
    // the surface must go on to all sides: a cut is no top
    for(const int reach : {1, 5})
      for(const auto& [a, b] :
          {std::pair(reach, 0), std::pair(-reach, 0), std::pair(0, reach), std::pair(0, -reach)})
        if(!height.has_value(top.i + a, top.j + b))
          return;
    const double best = height(top.i, top.j);
    if(best < .4)
      return;
    const double i = top.i +
                     Face_view::vertex_of_parabola(height(top.i - 1, top.j), best, height(top.i + 1, top.j)),
                 j = top.j +
                     Face_view::vertex_of_parabola(height(top.i, top.j - 1), best, height(top.i, top.j + 1));
    set(Head_feature::TOP, above.point(above.u(i), above.v(j)), plausibility(best - .641, .1));
  }

  struct Pixel
  {
    int i = -1, j = -1;
  };

  static Pixel highest(const Scalar_image& height)
  {
    Pixel result;
    double best = -std::numeric_limits<double>::infinity();
    for(int j = 0; j < height.height(); ++j)
      for(int i = 0; i < height.width(); ++i)
        if(height(i, j) > best)
        {
          best = height(i, j);
          result = {i, j};
        }
    return result;
  }

  // how far `height` is from a paraboloid around `center` (root mean square)
  static double roughness_about(const Scalar_image& height, const Pixel& center)
  {
    constexpr int reach = 8;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6, 6);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(6), terms(6);
    double squares = 0.;
    int pixels = 0;
    for(int b = -reach; b <= reach; ++b)
      for(int a = -reach; a <= reach; ++a)
        if(height.has_value(center.i + a, center.j + b))
        {
          const double x = double(a) / reach, y = double(b) / reach,
                       z = height(center.i + a, center.j + b) - height(center.i, center.j);
          terms << 1., x, y, x * x, x * y, y * y;
          matrix += terms * terms.transpose();
          right += z * terms;
          squares += z * z;
          ++pixels;
        }
    if(pixels < 6)
      return 0.;
    return std::sqrt((std::max)(0., squares - right.dot(solve_positive_semidefinite(matrix, right))) /
                     pixels);
  }

  // An ear is the surface behind its outline. What belongs to it at the back, next to the head, is hidden by it.
  void find_ears()
  {
    for(const int side : {-1, 1})
    {
      const Ear_outline outline = Ear_finder(m_surface, side).find();
      if(!(outline.certainty() > 0.))
        continue;
      Found_head_features::Region& region =
          m_found[side < 0 ? Head_region::LEFT_EAR : Head_region::RIGHT_EAR];
      for(Index v = 0; v < m_surface.points.size(); ++v)
        if(side * m_surface.points[v].x() > s_least_ear_x &&
           outside_of_ear(outline, m_surface.points[v]) <= 0.)
          region.vertices.push_back(v);
      if(region.vertices.empty())
        continue;
      const Ear_box& box = outline.box();
      region.confidence = outline.certainty() * plausibility(.5 * (box.bottom + box.top) - .02, .08);
      find_points_of_ear(side, outline, region.confidence);
    }
    // the ears of a head are at the same place
    const auto &left = m_found[Head_feature::LEFT_R5], &right = m_found[Head_feature::RIGHT_R5];
    if(left.is_found() && right.is_found())
    {
      const double agreement = plausibility((left.position() - right.position()).tail<2>().norm(), .06);
      for(Found_head_features::Region* r :
          {&m_found[Head_region::LEFT_EAR], &m_found[Head_region::RIGHT_EAR]})
        r->confidence *= agreement;
      for(std::size_t k = 0; k < 5; ++k)
        for(const Head_feature f : {Head_feature::LEFT_R1, Head_feature::RIGHT_R1})
          m_found.points[static_cast<std::size_t>(f) + k].confidence *= agreement;
    }
  }
  static constexpr double s_behind_ear = .02, s_least_ear_x = .15;

  // how far a point is outside of an ear as it is seen from the side, and of what it hides at its back
  static double outside_of_ear(const Ear_outline& outline, const Eigen::Vector3d& p)
  {
    return outline.distance(p.z(), p.y()) - (p.z() > outline.z_middle() ? 0. : s_behind_ear);
  }

  // R1 to R4 are near the corners of the outer side of the ear's box, R5 near the mean of these. Where exactly, the area about the
  // nearest place of the ear says: rims are sharper or rounder as the mesh is. Beyond the outline, area counts less and less.
  void find_points_of_ear(int side, const Ear_outline& outline, double confidence)
  {
    constexpr double width = .003, width_of_middle = .006, spacing = .004, fade = .015;
    const Ear_box& box = outline.box();
    std::vector<std::size_t> triangles;
    for(std::size_t t = 0; t < m_surface.triangles.size(); ++t)
    {
      const auto& [a, b, c] = m_surface.triangles[t];
      const Eigen::Vector3d center = (m_surface.points[a] + m_surface.points[b] + m_surface.points[c]) / 3.;
      if(side * center.x() > s_least_ear_x && center.y() > box.bottom && center.y() < box.top &&
         center.z() > box.back && center.z() < box.front)
        triangles.push_back(t);
    }
    const auto weight = [&](const Eigen::Vector3d& p)
    { return std::min(std::max(1. - outside_of_ear(outline, p) / fade, 0.), 1.); };
    const Surface_patch ear(m_surface, std::move(triangles), spacing, weight);
    if(ear.is_empty())
      return;
    const std::array<Eigen::Vector3d, 4> corners = {
        Eigen::Vector3d(side * box.outside, box.top, box.front),
        Eigen::Vector3d(side * box.outside, box.top, box.back),
        Eigen::Vector3d(side * box.outside, box.bottom, box.front),
        Eigen::Vector3d(side * box.outside, box.bottom, box.back)};
    const auto feature = [&](std::size_t k)
    {
      return static_cast<Head_feature>(
          static_cast<std::size_t>(side < 0 ? Head_feature::LEFT_R1 : Head_feature::RIGHT_R1) + k);
    };
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for(std::size_t k = 0; k < 4; ++k)
    {
      const Eigen::Vector3d near_corner = ear.mean_near(corners[k], width);
      set(feature(k), ear.nearest_point(near_corner), confidence);
      mean += near_corner / 4.;
    }
    set(feature(4), ear.nearest_point(ear.mean_near(mean, width_of_middle)), confidence);
  }

  // The regions in front are what lies within curves through their points, and not far behind what is seen there.
  void find_regions()
  {
    for(const int side : {-1, 1})
    {
      const auto &outer = m_found[side < 0 ? Head_feature::LEFT_E1 : Head_feature::RIGHT_E1],
                 &inner = m_found[side < 0 ? Head_feature::LEFT_E2 : Head_feature::RIGHT_E2];
      if(!outer.is_found() || !inner.is_found())
        continue;
      const Eigen::Vector3d center = .5 * (outer.position() + inner.position());
      const double width = std::abs(outer.position().x() - inner.position().x());
      fill_region(side < 0 ? Head_region::LEFT_EYE : Head_region::RIGHT_EYE, center.z(),
                  [&](double u, double v)
                  {
                    return std::hypot((u - center.x()) / (.68 * width),
                                      (v - center.y() - .06 * width) / (.45 * width)) < 1.;
                  });
      m_found[side < 0 ? Head_region::LEFT_EYE : Head_region::RIGHT_EYE].confidence =
          std::min(outer.confidence, inner.confidence);
    }

    const auto &base = m_found[Head_feature::N1], &bridge = m_found[Head_feature::N3],
               &root = m_found[Head_feature::N4];
    if(base.is_found() && bridge.is_found() && root.is_found())
    {
      // half its width, by height
      const std::array<std::pair<double, double>, 5> widths = {
          std::pair(base.position().y(), .085), std::pair(-.03, .1), std::pair(.03, .095),
          std::pair(bridge.position().y(), .08), std::pair(root.position().y(), .055)};
      fill_region(Head_region::NOSE, std::min(base.position().z(), root.position().z()),
                  [&](double u, double v)
                  {
                    for(std::size_t k = 0; k + 1 < widths.size(); ++k)
                    {
                      const auto& [v0, w0] = widths[k];
                      const auto& [v1, w1] = widths[k + 1];
                      if(v >= v0 && v <= v1 && v1 > v0)
                        return std::abs(u - midline(v)) < w0 + (v - v0) / (v1 - v0) * (w1 - w0);
                    }
                    return false;
                  });
      m_found[Head_region::NOSE].confidence = std::min({base.confidence, bridge.confidence, root.confidence});
    }

    const auto &left = m_found[Head_feature::M1], &right = m_found[Head_feature::M2],
               &upper = m_found[Head_feature::M3], &lower = m_found[Head_feature::M4];
    if(left.is_found() && right.is_found() && upper.is_found() && lower.is_found())
    {
      const Eigen::Vector3d center = .5 * (left.position() + right.position());
      const double half_width = .5 * (right.position() - left.position()).norm() + .02,
                   above = std::max(upper.position().y() - center.y(), 0.) + .025,
                   below = std::max(center.y() - lower.position().y(), 0.) + .025;
      fill_region(Head_region::MOUTH, center.z(),
                  [&](double u, double v)
                  {
                    return std::hypot((u - center.x()) / half_width,
                                      (v - center.y()) / (v > center.y() ? above : below)) < 1.;
                  });
      m_found[Head_region::MOUTH].confidence =
          std::min({left.confidence, right.confidence, upper.confidence, lower.confidence});
    }
  }

  // `z_min`: of the points of the region
  template <typename Predicate>
  void fill_region(Head_region region, double z_min, const Predicate& is_inside)
  {
    constexpr double thickness = .1;
    for(Index v = 0; v < m_surface.points.size(); ++v)
    {
      const Eigen::Vector3d& p = m_surface.points[v];
      if(!is_inside(p.x(), p.y()))
        continue;
      const double front = m_view->depth(p.x(), p.y());
      if(p.z() > (std::isnan(front) ? z_min : std::max(z_min, front)) - thickness)
        m_found[region].vertices.push_back(v);
    }
  }

  const Head_surface& m_original;
  Eigen::Vector3d m_origin;
  double m_unit;
  Head_surface m_surface; // seen from the tip of the nose, in heights of the head
  std::vector<Index> m_components;
  std::optional<Face_view> m_view;
  Found_head_features m_found;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_HEAD_FEATURE_FINDER_H
