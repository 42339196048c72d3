#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_SEARCH_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_SEARCH_H

#include <Shape_characteristics/head_features/internal/pose_mean_head.h>
#include <Shape_characteristics/head_features/internal/pose_mirror.h>
#include <Shape_characteristics/head_features/internal/pose_surface.h>
#include <Shape_characteristics/internal/solve_positive_semidefinite.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// from the frame of the head to the coordinates of a `Pose_surface`: x = scale * rotation * m + translation
struct Head_placement
{
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double scale = 1.;
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator()(const Eigen::Vector3d& m) const { return scale * (rotation * m) + translation; }
  Eigen::Vector3d inverse(const Eigen::Vector3d& x) const
  {
    return rotation.transpose() * (x - translation) / scale;
  }
  Mirror mirror() const { return {rotation.col(0), rotation.col(0).dot(translation)}; }
};

// a sample that may be the tip of a nose
struct Nose_candidate
{
  std::size_t sample = 0;
  double prominence = 0.; // how far it stands out of its surroundings, by their radius
};

// how well the mean head fits in a placement
struct Placement_fit
{
  Head_placement placement;
  double score = -1.; // of all, in [0, 1]; negative if there was nothing to try
  double left = 0.,
         right = 0.;   // agreement of the points of each side of the face with the surface, in [0, 1]
  double cranium = 0.; // likewise of the rest
  double nose = 0.;    // and of the nose
};

class Pose_search
{
public:
  Pose_search(const Pose_surface& surface, const Mean_head& head) : m_surface(surface), m_head(head) {}

  /*
    Samples that stand out of their surroundings like the tip of a nose, after L. Yang et al. and C. Xu et al., the most prominent
    first: all neighbors lie below the tangent plane, and far.
  */
  std::vector<Nose_candidate> noses() const
  {
    const auto& points = m_surface.points();
    const auto& normals = m_surface.normals();
    std::vector<Nose_candidate> result;
    for(const double radius : {.13, .22})
    {
      Pose_grid grid(points, radius);
      for(std::size_t i = 0; i < points.size(); ++i)
        grid.insert(i);
      std::vector<double> prominence(points.size(), 0.);
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        double sum = 0., below = 0., count = 0.;
        grid.for_each_within(points[i], radius,
                             [&](const std::size_t j, double)
                             {
                               const double h = normals[i].dot(points[i] - points[j]);
                               sum += h;
                               below += h > -.02 * radius;
                               count += 1.;
                               return true;
                             });
        if(count > 5. && below > .95 * count)
          prominence[i] = sum / (count * radius);
      }
      for(std::size_t i = 0; i < points.size(); ++i)
        if(prominence[i] > .15 && grid.for_each_within(points[i], .7 * radius,
                                                       [&](const std::size_t j, double) {
                                                         return prominence[j] < prominence[i] ||
                                                                (prominence[j] == prominence[i] && j >= i);
                                                       }))
          result.push_back({i, prominence[i]});
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Nose_candidate& a, const Nose_candidate& b)
                     { return a.prominence > b.prominence; });
    return result;
  }

  // how well a placement fits, by the first `count` points of the mean head
  double quick_score(const Head_placement& place, const std::size_t count, const double limit) const
  {
    double sum = 0.;
    for(std::size_t i = 0; i < count; ++i)
    {
      const Eigen::Vector3d x = place(m_head.point(i));
      const auto j = m_surface.nearest(x, limit * place.scale);
      if(j == Nearest_point_search::none)
        continue;
      const double d = (x - m_surface.all().points[j]).norm() / (limit * place.scale),
                   cosine = (place.rotation * m_head.normal(i)).dot(m_surface.smooth_normal(j));
      if(cosine > .5)
        sum += 1. - d * d;
    }
    return sum / double(count);
  }

  // the placement that minimizes the distances of the mean head's points to the tangent planes of the surface. With `fixed`, the
  // plane of symmetry stays what it is.
  Head_placement refine(Head_placement place,
                        const std::size_t count,
                        const double first,
                        const double last,
                        const int steps,
                        const bool fixed) const
  {
    const double shrinkage = steps > 1 ? std::pow(last / first, 1. / (steps - 1)) : 1.;
    double limit = first;
    for(int step = 0; step < steps; ++step, limit *= shrinkage)
    {
      // rotation about the axes of the head, scaling, translation along the axes of the head
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(7, 7);
      Eigen::VectorXd right = Eigen::VectorXd::Zero(7), row(7);
      for(std::size_t i = 0; i < count; ++i)
      {
        const Eigen::Vector3d x = place(m_head.point(i));
        const auto j = m_surface.nearest(x, 1.5 * limit * place.scale);
        if(j == Nearest_point_search::none)
          continue;
        const Eigen::Vector3d n = place.rotation.transpose() * m_surface.smooth_normal(j),
                              &m = m_head.point(i);
        const double cosine = m_head.normal(i).dot(n);
        if(cosine < .5)
          continue;
        const Eigen::Vector3d to = place.rotation.transpose() * (x - m_surface.all().points[j]) / place.scale;
        const double d = n.dot(to), r = d / limit;
        if(std::abs(r) >= 1.)
          continue;
        const double w = (1. - r * r) * (1. - r * r) * cosine;
        row << m.cross(n), n.dot(m), n;
        matrix += w * row * row.transpose();
        right -= w * d * row;
      }
      if(fixed)
        for(const int k : {1, 2, 4}) // turns about y and z, moves along x
        {
          matrix.row(k).setZero();
          matrix.col(k).setZero();
          right[k] = 0.;
          matrix(k, k) = 1.;
        }
      const double trace = matrix.trace();
      if(!(trace > 0.))
        break;
      matrix += 1e-6 * trace * Eigen::MatrixXd::Identity(7, 7);
      const Eigen::VectorXd move = solve_positive_semidefinite(matrix, right);
      if(!move.allFinite())
        break;
      const Eigen::Vector3d turn = move.head<3>();
      const double angle = turn.norm();
      const Eigen::Vector3d shift = move.tail<3>();
      place.translation += place.scale * (place.rotation * shift);
      if(angle > 0.)
        place.rotation = place.rotation * Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
      place.rotation = Eigen::Quaterniond(place.rotation).normalized().toRotationMatrix();
      place.scale *= std::exp((std::max)((std::min)(move[3], .1), -.1));
    }
    return place;
  }

  /*
    The mean head, its points being at `rest`, bent onto the surface: displacements that are a smooth random field (of standard
    deviation `size` and correlation length `width`, in the unit of the frame), as likely as the distances to the surface allow. Only
    with this, it is known which points of the surface and of the mean head belong together; where they are merely near, a long face
    tilts the head.
  */
  std::vector<Eigen::Vector3d> bend(const Head_placement& place,
                                    const std::vector<Eigen::Vector3d>& rest) const
  {
    constexpr double width = .5, size = .03, noise = .01;
    const auto controls = Eigen::Index((std::min)(std::size_t(60), m_head.size())),
               points = Eigen::Index(m_head.size());
    Eigen::MatrixXd basis(points, controls);
    for(Eigen::Index i = 0; i < points; ++i)
      for(Eigen::Index j = 0; j < controls; ++j)
        basis(i, j) = size * size *
                      std::exp(-(m_head.point(std::size_t(i)) - m_head.point(std::size_t(j))).squaredNorm() /
                               (2. * width * width));
    Eigen::MatrixXd prior = Eigen::MatrixXd::Zero(3 * controls, 3 * controls);
    for(Eigen::Index i = 0; i < controls; ++i)
      for(Eigen::Index j = 0; j < controls; ++j)
        for(Eigen::Index c = 0; c < 3; ++c)
          prior(3 * i + c, 3 * j + c) = basis(i, j);
    std::vector<Eigen::Vector3d> bent = rest;
    Eigen::VectorXd row(3 * controls);
    double limit = .1;
    for(int step = 0; step < 10; ++step, limit = (std::max)(.04, limit * .8))
    {
      Eigen::MatrixXd matrix = prior;
      Eigen::VectorXd right = Eigen::VectorXd::Zero(3 * controls);
      for(std::size_t i = 0; i < m_head.size(); ++i)
      {
        const auto j = m_surface.nearest(place(bent[i]), 1.5 * limit * place.scale);
        if(j == Nearest_point_search::none)
          continue;
        const Eigen::Vector3d n = place.rotation.transpose() * m_surface.smooth_normal(j),
                              q = place.inverse(m_surface.all().points[j]);
        const double cosine = m_head.normal(i).dot(n), r = n.dot(q - bent[i]) / limit;
        if(cosine < .5 || std::abs(r) >= 1.)
          continue;
        const double w = (1. - r * r) * (1. - r * r) * cosine / (noise * noise);
        for(Eigen::Index k = 0; k < controls; ++k)
          row.segment<3>(3 * k) = basis(Eigen::Index(i), k) * n;
        matrix.selfadjointView<Eigen::Lower>().rankUpdate(row, w);
        right += w * n.dot(q - rest[i]) * row;
      }
      matrix.diagonal().array() += 1e-9 * matrix.trace() / double(3 * controls);
      const Eigen::VectorXd weights = solve_positive_semidefinite(matrix, right);
      for(std::size_t i = 0; i < m_head.size(); ++i)
      {
        bent[i] = rest[i];
        for(Eigen::Index k = 0; k < controls; ++k)
          bent[i] += basis(Eigen::Index(i), k) * weights.segment<3>(3 * k);
      }
    }
    return bent;
  }

  // the placement, turned about its x-axis, scaled and moved along its plane of symmetry to where the mean head is nearest to the bent
  // one. The upper face counts most, where the model has most detail; what is below the nose moves with the jaw.
  Head_placement rectify(const Head_placement& place, const std::vector<Eigen::Vector3d>& bent) const
  {
    const auto weight = [&](const std::size_t i) {
      return m_head.weight(i) * (!m_head.is_face(i) ? .1 : m_head.is_above_mouth(i) ? 1. : .25);
    };
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = from;
    double weights = 0.;
    for(std::size_t i = 0; i < m_head.size(); ++i)
    {
      from += weight(i) * m_head.point(i);
      to += weight(i) * bent[i];
      weights += weight(i);
    }
    from /= weights;
    to /= weights;
    double sine = 0., cosine = 0., across = 0., squares = 0.;
    for(std::size_t i = 0; i < m_head.size(); ++i)
    {
      const Eigen::Vector3d a = m_head.point(i) - from, b = bent[i] - to;
      sine += weight(i) * (a.y() * b.z() - a.z() * b.y());
      cosine += weight(i) * (a.y() * b.y() + a.z() * b.z());
      across += weight(i) * a.x() * b.x();
      squares += weight(i) * a.squaredNorm();
    }
    const double scale = (std::hypot(sine, cosine) + across) / squares;
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(std::atan2(sine, cosine), Eigen::Vector3d::UnitX()).toRotationMatrix();
    Eigen::Vector3d shift = to - scale * (turn * from);
    shift.x() = 0.;
    Head_placement result;
    result.rotation = place.rotation * turn;
    result.scale = place.scale * scale;
    result.translation = place(shift);
    return result;
  }

  // the samples of the face
  std::vector<std::size_t> samples_of_face(const Head_placement& place) const
  {
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < m_surface.points().size(); ++i)
    {
      const Eigen::Vector3d m = place.inverse(m_surface.points()[i]);
      if(m.y() > -.42 && m.y() < .2 && m.z() > .1 && m.z() < .6 && std::abs(m.x()) < .5)
        result.push_back(i);
    }
    return result;
  }

  // the placement with the plane of symmetry of the face instead of its own, which the mean head gave it
  Head_placement with_mirror_of_face(Head_placement place, const Mirror_search& mirrors) const
  {
    const Mirror mirror =
        mirrors.refine(place.mirror(), samples_of_face(place), .06 * place.scale, .015 * place.scale, 10);
    const Eigen::Vector3d middle = place(Eigen::Vector3d(0., 0., .3));
    // a face of which a side is missing may have a plane elsewhere
    if(mirror.normal.dot(place.rotation.col(0)) < .99 || std::abs(mirror.height(middle)) > .05 * place.scale)
      return place;
    // not Quaterniond::FromTwoVectors(): it takes a compiler longer than all the rest of this header
    const Eigen::Vector3d axis = place.rotation.col(0).cross(mirror.normal);
    if(const double sine = axis.norm(); sine > 0.)
      place.rotation =
          Eigen::AngleAxisd(std::asin((std::min)(sine, 1.)), axis / sine).toRotationMatrix() * place.rotation;
    place.translation -= mirror.height(place.translation) * mirror.normal;
    return place;
  }

  // how well the mean head, or a bent one, fits
  Placement_fit assess(const Head_placement& place, const std::vector<Eigen::Vector3d>& points) const
  {
    constexpr double limit = .06, tolerance = .04;
    double sums[3] = {0., 0., 0.}, counts[3] = {0., 0., 0.}; // left, right, the rest
    double nose = 0., noses = 0.;
    for(std::size_t i = 0; i < m_head.size(); ++i)
    {
      const Eigen::Vector3d x = place(points[i]);
      const auto j = m_surface.nearest(x, limit * place.scale);
      double agreement = 0.;
      if(j != Nearest_point_search::none)
      {
        const Eigen::Vector3d& n = m_surface.smooth_normal(j);
        const double d = n.dot(x - m_surface.all().points[j]) / (tolerance * place.scale),
                     cosine = n.dot(place.rotation * m_head.normal(i));
        agreement = (std::max)(0., 1. - d * d) * (std::max)(0., (cosine - .6) / .4);
      }
      if(m_head.is_nose(i))
      {
        nose += agreement;
        noses += 1.;
      }
      const double side = m_head.point(i).x();
      for(int k = 0; k < 3; ++k)
        if(m_head.is_face(i) ? (k == 0 && side <= 0.) || (k == 1 && side >= 0.) : k == 2)
        {
          sums[k] += agreement;
          counts[k] += 1.;
        }
    }
    Placement_fit fit;
    fit.placement = place;
    fit.left = sums[0] / counts[0];
    fit.right = sums[1] / counts[1];
    fit.cranium = sums[2] / counts[2];
    fit.nose = nose / noses;
    fit.score = .25 * (fit.left + fit.right) + .3 * (std::min)(fit.left, fit.right) + .2 * fit.cranium;
    return fit;
  }

  Placement_fit assess(const Head_placement& place) const { return assess(place, m_head.points()); }

  // the best placement: the plane of symmetry is one of `mirrors`, and the tip of the nose is on it
  Placement_fit run(const Mirror_search& search, const std::vector<Mirror_fit>& mirrors) const
  {
    std::vector<Placement_fit> hypotheses;
    const std::vector<Nose_candidate> all = noses();
    const std::size_t coarse = (std::min)(std::size_t(90), m_head.size());
    for(std::size_t k = 0; k < mirrors.size() && k < 5; ++k)
    {
      int used = 0;
      for(const Nose_candidate& nose : all)
      {
        const Mirror& mirror = mirrors[k].mirror;
        const Eigen::Vector3d& tip = m_surface.points()[nose.sample];
        if(std::abs(mirror.height(tip)) > .08)
          continue;
        if(++used > 10)
          break;
        Eigen::Vector3d front = m_surface.normals()[nose.sample];
        front -= front.dot(mirror.normal) * mirror.normal;
        if(!(front.norm() > .5))
          continue;
        front.normalize();
        for(const double sign : {1., -1.})
        {
          const Eigen::Vector3d x = sign * mirror.normal;
          for(const double pitch : {-60., -40., -20., 0., 20., 40.})
          {
            const Eigen::Vector3d z = Eigen::AngleAxisd(pitch * double(EIGEN_PI) / 180., x) * front;
            Placement_fit h;
            h.placement.rotation.col(0) = x;
            h.placement.rotation.col(1) = z.cross(x);
            h.placement.rotation.col(2) = z;
            for(const double scale : {2.3, 1.95, 1.65, 1.4, 1.2, 1., .85})
            {
              h.placement.scale = scale;
              h.placement.translation = tip - mirror.height(tip) * mirror.normal -
                                        scale * (h.placement.rotation * m_head.nose_tip());
              h.score = quick_score(h.placement, coarse, .15);
              hypotheses.push_back(h);
            }
          }
        }
      }
    }
    if(hypotheses.empty())
      return {};
    const auto better = [](const Placement_fit& a, const Placement_fit& b) { return a.score > b.score; };
    std::stable_sort(hypotheses.begin(), hypotheses.end(), better);
    if(hypotheses.size() > 24)
      hypotheses.resize(24);
    for(Placement_fit& h : hypotheses)
      h = assess(refine(h.placement, 2 * coarse, .2, .08, 10, false));
    std::stable_sort(hypotheses.begin(), hypotheses.end(), better);
    if(hypotheses.size() > 4)
      hypotheses.resize(4);
    for(Placement_fit& h : hypotheses)
      h = assess(refine(h.placement, m_head.size(), .1, .05, 12, false));
    std::stable_sort(hypotheses.begin(), hypotheses.end(), better);

    // the plane of symmetry, the pitch and the size as exactly as they can be had
    Head_placement place = with_mirror_of_face(hypotheses.front().placement, search);
    place = refine(place, m_head.size(), .06, .05, 6, true);
    place = rectify(place, bend(place, m_head.points()));
    Placement_fit best;
    for(const double opening : {0., 8., 16.}) // degrees; a smooth bend can't open a mouth
    {
      if(.5 * (best.left + best.right) > .8)
        break; // so it is closed
      const std::vector<Eigen::Vector3d> rest = m_head.with_open_mouth(opening * double(EIGEN_PI) / 180.);
      const Placement_fit plain = assess(place, rest);
      Placement_fit fit = assess(place, bend(place, rest));
      // how well the head fits as it is counts as well: what has to be bent a lot is rather something else
      fit.left = .5 * (fit.left + plain.left);
      fit.right = .5 * (fit.right + plain.right);
      fit.nose = .5 * (fit.nose + plain.nose);
      if(best.score < 0. || fit.left + fit.right > best.left + best.right)
        best = fit;
    }
    return best;
  }

private:
  const Pose_surface& m_surface;
  const Mean_head& m_head;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_SEARCH_H
