#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_THESIS_HEAD_FEATURES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_THESIS_HEAD_FEATURES_H

#include <Shape_characteristics/head_features/Head_descriptor.h>
#include <Shape_characteristics/head_features/Head_feature.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Chapter 9 of the thesis, word by word, at the vertices of a head in a box of size 1, with its nose towards +z. What the text
// leaves open is said where it is decided. Its signs are the opposite of ours: what is concave is positive there.
class Thesis_head_features
{
public:
  static constexpr std::size_t none = std::size_t(-1);

  struct Options
  {
    std::size_t eye_vertices = 0, nose_vertices = 0, ear_vertices = 0;
    double detection_radius = 0.;
  };

  std::array<std::size_t, number_of_head_features> points; // vertices
  std::array<std::vector<std::size_t>, number_of_head_regions> regions;

  // points that are not finite, or without a descriptor, are nowhere
  Thesis_head_features(const std::vector<Eigen::Vector3d>& vertices,
                       const std::vector<Head_descriptor>& descriptors,
                       const Options& options)
    : m_vertices(vertices),
      m_descriptors(descriptors),
      m_options(options)
  {
    points.fill(none);
    for(std::size_t v = 0; v < vertices.size(); ++v)
      if(vertices[v].allFinite())
        m_all.push_back(v);
    find_anchors();
    if(at(Head_feature::NOSE_TIP) == none)
      return;
    find_eyes();
    find_nose();
    find_mouth();
    find_ears();
  }

private:
  using Vertices = std::vector<std::size_t>;
  static constexpr double s_infinity = std::numeric_limits<double>::infinity();

  std::size_t& at(Head_feature f) { return points[static_cast<std::size_t>(f)]; }
  Vertices& at(Head_region r) { return regions[static_cast<std::size_t>(r)]; }
  static Head_feature next(Head_feature f, int k)
  {
    return static_cast<Head_feature>(static_cast<int>(f) + k);
  }
  const Eigen::Vector3d& p(std::size_t v) const { return m_vertices[v]; }

  // The thesis's K_H and S, positive where concave. K_H is mapped to [0, 1], though (9.4) and (9.5) look at its sign; (9.3) multiplies it by a
  // distance, and (9.4) divides by one that may vanish. So it is printed.
  double mean_curvature(std::size_t v) const { return 1. - m_descriptors[v].mean_curvature; }
  double shape_index(std::size_t v) const { return -m_descriptors[v].shape_index; }

  // the vertex of those in a set with a property that has the greatest measure; NaN is smaller than everything
  template <typename Predicate, typename Measure>
  static std::size_t greatest(const Vertices& set, const Predicate& predicate, const Measure& measure)
  {
    std::size_t best = none;
    double value = -s_infinity;
    for(const std::size_t v : set)
    {
      if(!predicate(v))
        continue;
      const double m = measure(v);
      if(m > value || (best == none && m == value))
      {
        value = m;
        best = v;
      }
    }
    return best;
  }

  // The `n` vertices with the greatest measure, none nearer to another one than the detection radius.
  template <typename Measure>
  Vertices first(std::size_t n, const Vertices& set, const Measure& measure) const
  {
    std::vector<std::pair<double, std::size_t> > order;
    for(const std::size_t v : set)
    {
      const double m = measure(v);
      if(!std::isnan(m))
        order.emplace_back(m, v);
    }
    std::sort(order.begin(), order.end(),
              [](const auto& a, const auto& b)
              { return a.first != b.first ? a.first > b.first : a.second < b.second; });
    Vertices result;
    const double squared_radius = m_options.detection_radius * m_options.detection_radius;
    for(const auto& entry : order)
    {
      if(result.size() == n)
        break;
      const bool is_covered =
          squared_radius > 0. && std::any_of(result.begin(), result.end(),
                                             [&](const std::size_t w) {
                                               return (p(w) - p(entry.second)).squaredNorm() < squared_radius;
                                             });
      if(!is_covered)
        result.push_back(entry.second);
    }
    return result;
  }

  template <typename Predicate>
  Vertices where(const Predicate& predicate) const
  {
    Vertices result;
    std::copy_if(m_all.begin(), m_all.end(), std::back_inserter(result), predicate);
    return result;
  }

  static bool any(std::size_t) { return true; }

  // 9.1.2. The angle of the cone isn't given: 30 degrees from its axis here. With the sphere's radius of 0.6 the point found is
  // the tip of the nose.
  void find_anchors()
  {
    const std::size_t nose = greatest(m_all, any, [&](const std::size_t v) { return p(v).z(); });
    at(Head_feature::NOSE_TIP) = at(Head_feature::N2) = nose;
    at(Head_feature::TOP) = greatest(m_all, any, [&](const std::size_t v) { return p(v).y(); });
    if(nose == none)
      return;
    constexpr double cosine = .86602540378443864676, radius = .6;
    const std::size_t farthest = greatest(
        m_all, [&](const std::size_t v) { return p(nose).y() - p(v).y() > cosine * (p(v) - p(nose)).norm(); },
        [&](const std::size_t v) { return (p(v) - p(nose)).norm(); });
    if(farthest != none)
      at(Head_feature::CHIN) = greatest(
          m_all, [&](const std::size_t v) { return (p(v) - p(farthest)).norm() <= radius; },
          [&](const std::size_t v) { return p(v).z(); });
  }

  // 9.1.3, (9.1). "60 percent of the distance between nose and top" is taken for a distance from the tip of the nose. The
  // greatest measures are taken, as the text says after the formula.
  void find_eyes()
  {
    const Eigen::Vector3d &nose = p(at(Head_feature::NOSE_TIP)), &top = p(at(Head_feature::TOP));
    const double reach = .6 * (top - nose).norm();
    const Vertices candidates =
        where([&](const std::size_t v) { return p(v).y() > nose.y() && (p(v) - nose).norm() <= reach; });
    for(const std::size_t v :
        first(m_options.eye_vertices, candidates,
              [&](const std::size_t v) { return m_descriptors[v].Willmore_energy * (nose - p(v)).norm(); }))
      at(p(v).x() < nose.x() ? Head_region::LEFT_EYE : Head_region::RIGHT_EYE).push_back(v);

    for(const int side : {-1, 1})
    {
      const Vertices& eye = at(side < 0 ? Head_region::LEFT_EYE : Head_region::RIGHT_EYE);
      const Head_feature e1 = side < 0 ? Head_feature::LEFT_E1 : Head_feature::RIGHT_E1;
      const std::size_t outer = greatest(eye, any, [&](const std::size_t v) { return side * p(v).x(); }),
                        inner = greatest(eye, any, [&](const std::size_t v) { return -side * p(v).x(); });
      at(e1) = outer;
      at(next(e1, 1)) = inner;
      if(outer == none)
        continue;
      for(int k = 0; k < 2; ++k)
      {
        const Eigen::Vector3d a = p(outer) + (k + 1) / 3. * (p(inner) - p(outer));
        const auto nearness = [&](const std::size_t v) { return -std::abs(p(v).x() - a.x()); };
        at(next(e1, 2 + k)) = greatest(
            eye, [&](const std::size_t v) { return p(v).y() > a.y(); }, nearness);
        at(next(e1, 4 + k)) = greatest(
            eye, [&](const std::size_t v) { return p(v).y() < a.y(); }, nearness);
      }
    }
  }

  // 9.1.3, (9.2) to (9.5)
  void find_nose()
  {
    const std::size_t tip = at(Head_feature::N2);
    const auto ridge = [&](const std::size_t v) { return shape_index(v) * m_descriptors[v].curvedness; };
    Vertices& region = at(Head_region::NOSE);
    region = first(m_options.nose_vertices,
                   where([&](const std::size_t v)
                         { return p(v).y() > p(tip).y() && std::abs(p(v).x() - p(tip).x()) <= .05; }),
                   [&](const std::size_t v) { return -ridge(v); });

    const std::size_t left = at(Head_feature::LEFT_E2), right = at(Head_feature::RIGHT_E2);
    if(left != none && right != none)
    {
      const Eigen::Vector3d predicted = .5 * (p(left) + p(right));
      at(Head_feature::N4) =
          greatest(region, any, [&](const std::size_t v) { return -ridge(v) * (predicted - p(v)).norm(); });
    }
    if(at(Head_feature::N4) != none)
    {
      const Eigen::Vector3d predicted = .5 * (p(tip) + p(at(Head_feature::N4)));
      at(Head_feature::N3) =
          greatest(region, any, [&](const std::size_t v) { return -(predicted - p(v)).norm(); });
    }
    at(Head_feature::N1) = greatest(
        m_all,
        [&](const std::size_t v)
        { return v != tip && p(v).y() < p(tip).y() && std::abs(p(v).x() - p(tip).x()) <= .002; },
        [&](const std::size_t v) { return mean_curvature(v) / std::abs(p(v).z() - p(tip).z()); });

    const std::array<std::array<Head_feature, 3>, 2> sides = {
        {{Head_feature::N3, Head_feature::N5, Head_feature::N7},
         {Head_feature::N4, Head_feature::N6, Head_feature::N8}}};
    for(const auto& [center, left_side, right_side] : sides)
    {
      const std::size_t c = at(center);
      if(c == none)
        continue;
      const auto measure = [&](const std::size_t v) { return mean_curvature(v) / (p(v) - p(c)).norm(); };
      at(left_side) = greatest(
          m_all, [&](const std::size_t v) { return p(v).x() < p(c).x(); }, measure);
      at(right_side) = greatest(
          m_all, [&](const std::size_t v) { return p(v).x() > p(c).x(); }, measure);
    }
  }

  // 9.1.3. The greatest Willmore energy is taken. Which points are "closest to the predicted position" isn't said: here those of a
  // strip of the width of 0.02 in x that are no farther away than a quarter of the mouth's width in y.
  void find_mouth()
  {
    const std::size_t tip = at(Head_feature::NOSE_TIP), chin = at(Head_feature::CHIN);
    if(chin == none)
      return;
    for(const int side : {-1, 1})
      at(side < 0 ? Head_feature::M1 : Head_feature::M2) = greatest(
          m_all,
          [&](const std::size_t v)
          { return p(v).y() < p(tip).y() && p(v).y() > p(chin).y() && side * (p(v).x() - p(tip).x()) > 0.; },
          [&](const std::size_t v) { return m_descriptors[v].Willmore_energy; });
    const std::size_t left = at(Head_feature::M1), right = at(Head_feature::M2);
    if(left == none || right == none)
      return;
    const Eigen::Vector3d predicted = .5 * (p(left) + p(right));
    const double reach = .25 * (p(right) - p(left)).norm();
    for(const int side : {1, -1})
      at(side > 0 ? Head_feature::M3 : Head_feature::M4) = greatest(
          m_all,
          [&](const std::size_t v)
          {
            const double above = side * (p(v).y() - predicted.y());
            return std::abs(p(v).x() - predicted.x()) <= .01 && above > 0. && above <= reach;
          },
          [&](const std::size_t v) { return p(v).z(); });

    Eigen::AlignedBox3d box;
    for(const Head_feature f : {Head_feature::M1, Head_feature::M2, Head_feature::M3, Head_feature::M4})
      if(at(f) != none)
        box.extend(p(at(f)));
    at(Head_region::MOUTH) = where([&](const std::size_t v) { return box.contains(p(v)); });
  }

  // 9.1.3, (9.6)
  void find_ears()
  {
    const std::size_t tip = at(Head_feature::NOSE_TIP);
    for(const int side : {-1, 1})
    {
      const std::size_t corner = at(side < 0 ? Head_feature::RIGHT_E2 : Head_feature::LEFT_E2);
      if(corner == none)
        continue;
      Vertices& ear = at(side < 0 ? Head_region::LEFT_EAR : Head_region::RIGHT_EAR);
      ear = first(m_options.ear_vertices,
                  where([&](const std::size_t v) { return side * (p(v).x() - p(tip).x()) > 0.; }),
                  [&](const std::size_t v)
                  { return m_descriptors[v].curvedness * std::abs(p(v).x() - p(corner).x()); });
      if(ear.empty())
        continue;
      Eigen::AlignedBox3d box;
      for(const std::size_t v : ear)
        box.extend(p(v));
      const double x = side < 0 ? box.min().x() : box.max().x();
      const std::array<Eigen::Vector3d, 4> corners = {
          Eigen::Vector3d(x, box.max().y(), box.max().z()), Eigen::Vector3d(x, box.max().y(), box.min().z()),
          Eigen::Vector3d(x, box.min().y(), box.max().z()), Eigen::Vector3d(x, box.min().y(), box.min().z())};
      const Head_feature r1 = side < 0 ? Head_feature::LEFT_R1 : Head_feature::RIGHT_R1;
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      const auto nearest = [&](const Eigen::Vector3d& q)
      { return greatest(ear, any, [&](const std::size_t v) { return -(p(v) - q).norm(); }); };
      for(int k = 0; k < 4; ++k)
      {
        at(next(r1, k)) = nearest(corners[std::size_t(k)]);
        mean += p(at(next(r1, k))) / 4.;
      }
      at(next(r1, 4)) = nearest(mean);
    }
  }

  const std::vector<Eigen::Vector3d>& m_vertices;
  const std::vector<Head_descriptor>& m_descriptors;
  Options m_options;
  Vertices m_all;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_THESIS_HEAD_FEATURES_H
