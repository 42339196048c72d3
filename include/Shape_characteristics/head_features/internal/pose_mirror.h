#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_MIRROR_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_MIRROR_H

#include <Shape_characteristics/head_features/internal/pose_surface.h>
#include <Shape_characteristics/internal/median.h>
#include <Shape_characteristics/internal/solve_positive_semidefinite.h>
#include <Shape_characteristics/sampling/Nearest_point_search.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// a plane of symmetry, in the coordinates of a `Pose_surface`: the points p with normal.p = offset
struct Mirror
{
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
  double offset = 0.;

  double height(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
  Eigen::Vector3d image(const Eigen::Vector3d& p) const { return p - 2. * height(p) * normal; }
  Eigen::Vector3d image_of_vector(const Eigen::Vector3d& v) const { return v - 2. * normal.dot(v) * normal; }
};

// how well a surface is its own image
struct Mirror_fit
{
  Mirror mirror;
  double support = 0.;   // share of the samples whose image lies on the surface
  double deviation = 0.; // median distance of these from it
  double evidence =
      0.; // support, less what any plane has for no better reason than that the surface is round
};

/*
  Looks for the planes of symmetry of a surface, after I. Sipiran, R. Gregor, T. Schreck, Approximate symmetry detection in
  partial 3D meshes, 2014: samples with much Gaussian curvature are paired with those that are curved alike, and each pair votes
  for the plane between them. Those with many votes are tried on the whole surface, and refined there.
*/
class Mirror_search
{
public:
  // how far from the surface the image of a point may be, and the angle between normals, by its cosine
  static constexpr double tolerance = .04, cosine = .8;
  // planes that differ by less are the same: of their normals' distance, and of their offsets
  static constexpr double alike = .12;

  explicit Mirror_search(const Pose_surface& surface) : m_surface(surface)
  {
    if(!surface.is_valid())
      return;
    m_few = evenly_spread(surface.points(), 600);
    for(std::size_t i = 0; i < surface.points().size(); ++i)
      m_every.push_back(i);
  }

  // all planes that have some support, the best one first
  std::vector<Mirror_fit> run() const
  {
    std::vector<Mirror_fit> found;
    if(!m_surface.is_valid())
      return found;
    for(const Mirror& m : candidates())
      found.push_back(assess(m, m_few, 2. * tolerance));
    keep_best(found, 16, .5 * alike);
    for(Mirror_fit& f : found)
      f = assess(refine(f.mirror, m_few, 3. * tolerance, tolerance, 12), m_few, tolerance);
    keep_best(found, 8, alike);
    for(Mirror_fit& f : found)
      f = assess(refine(f.mirror, m_every, tolerance, .5 * tolerance, 6), m_every, tolerance);
    keep_best(found, 8, alike);
    return found;
  }

  // the support of a plane among some of the samples
  Mirror_fit
  assess(const Mirror& mirror, const std::vector<std::size_t>& samples, const double tolerance) const
  {
    Mirror_fit fit;
    fit.mirror = mirror;
    std::vector<double> distances;
    for(const std::size_t i : samples)
    {
      const Eigen::Vector3d image = mirror.image(m_surface.points()[i]);
      const auto j = m_surface.nearest(image, tolerance + m_surface.spacing());
      if(j == Nearest_point_search::none)
        continue;
      const Eigen::Vector3d normal = mirror.image_of_vector(m_surface.normals()[i]);
      const double d = std::abs(m_surface.all().normals[j].dot(image - m_surface.all().points[j]));
      if(normal.dot(m_surface.smooth_normal(j)) >= cosine && d <= tolerance)
        distances.push_back(d);
    }
    if(samples.empty() || distances.empty())
      return fit;
    fit.support = double(distances.size()) / double(samples.size());
    fit.deviation = median(distances);
    fit.evidence = fit.support * (1. - .5 * fit.deviation / tolerance);
    return fit;
  }

  // the plane that minimizes the distances of images to the tangent planes of the surface, from a plane nearby
  Mirror refine(Mirror mirror,
                const std::vector<std::size_t>& samples,
                const double first,
                const double last,
                const int steps) const
  {
    const double shrinkage = steps > 1 ? std::pow(last / first, 1. / (steps - 1)) : 1.;
    double limit = first;
    for(int step = 0; step < steps; ++step, limit *= shrinkage)
    {
      // the normal turns by a u + b v, the offset grows by c
      const Eigen::Vector3d u = mirror.normal.unitOrthogonal(), v = mirror.normal.cross(u);
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3, 3);
      Eigen::VectorXd right = Eigen::VectorXd::Zero(3);
      for(const std::size_t i : samples)
      {
        const Eigen::Vector3d &p = m_surface.points()[i], image = mirror.image(p);
        const auto j = m_surface.nearest(image, limit + m_surface.spacing());
        if(j == Nearest_point_search::none)
          continue;
        const Eigen::Vector3d& n = m_surface.smooth_normal(j);
        if(mirror.image_of_vector(m_surface.normals()[i]).dot(n) < .7)
          continue;
        const double d = n.dot(image - m_surface.all().points[j]), x = d / limit;
        if(std::abs(x) >= 1.)
          continue;
        const double w = (1. - x * x) * (1. - x * x), h = mirror.height(p), m = n.dot(mirror.normal);
        const Eigen::Vector3d row(-2. * (u.dot(p) * m + h * n.dot(u)), -2. * (v.dot(p) * m + h * n.dot(v)),
                                  2. * m);
        matrix += w * row * row.transpose();
        right -= w * d * row;
      }
      const double trace = matrix.trace();
      if(!(trace > 0.))
        break;
      matrix += 1e-9 * trace *
                Eigen::MatrixXd::Identity(3, 3); // a surface of revolution is content with many planes
      const Eigen::Vector3d move = solve_positive_semidefinite(matrix, right);
      if(!move.allFinite())
        break;
      mirror.normal = (mirror.normal + move[0] * u + move[1] * v).normalized();
      mirror.offset += move[2];
    }
    return mirror;
  }

  static bool are_alike(const Mirror& a, const Mirror& b, const double difference)
  {
    const double sign = a.normal.dot(b.normal) < 0. ? -1. : 1.;
    return (a.normal - sign * b.normal).norm() < difference &&
           std::abs(a.offset - sign * b.offset) < difference;
  }

  const std::vector<std::size_t>& few() const noexcept { return m_few; }
  const std::vector<std::size_t>& every() const noexcept { return m_every; }

private:
  struct Vote
  {
    Mirror mirror;
    double weight;
  };

  // Planes with many votes, and those through the axes of inertia: surfaces of which nothing is curved much have no votes.
  std::vector<Mirror> candidates() const
  {
    std::vector<Mirror> result = from_votes(votes());
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    for(const Eigen::Vector3d& p : m_surface.points())
      inertia += p * p.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia);
    for(int k = 0; k < 3; ++k)
      result.push_back({axes.eigenvectors().col(k), 0.});
    return result;
  }

  std::vector<Vote> votes() const
  {
    const auto& points = m_surface.points();
    const auto& normals = m_surface.normals();
    const auto& strength = m_surface.Gaussian_curvatures(0);
    std::vector<std::size_t> order(points.size());
    for(std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](const std::size_t a, const std::size_t b)
                     { return std::abs(strength[a]) > std::abs(strength[b]); });
    order.resize((std::min)(order.size(), (std::max)(std::size_t(150), order.size() / 6)));
    // principal curvatures at two scales, by the radius over which they are averaged, and squashed: very large ones are
    // estimated badly
    std::vector<std::array<double, 4> > signatures;
    for(const std::size_t i : order)
    {
      std::array<double, 4> s{};
      for(int scale = 0; scale < 2; ++scale)
      {
        const double mean = m_surface.mean_curvatures(scale)[i],
                     root = std::sqrt((std::max)(mean * mean - m_surface.Gaussian_curvatures(scale)[i], 0.));
        s[2 * scale] = std::atan((mean - root) * Pose_surface::radii[scale]);
        s[2 * scale + 1] = std::atan((mean + root) * Pose_surface::radii[scale]);
      }
      signatures.push_back(s);
    }
    std::vector<Vote> votes;
    for(std::size_t a = 0; a < order.size(); ++a)
      for(std::size_t b = a + 1; b < order.size(); ++b)
      {
        double difference = 0.;
        for(std::size_t k = 0; k < 4; ++k)
          difference = (std::max)(difference, std::abs(signatures[a][k] - signatures[b][k]));
        if(difference > .15)
          continue;
        const Eigen::Vector3d &p = points[order[a]], &q = points[order[b]], d = p - q;
        const double length = d.norm();
        if(length < .15)
          continue;
        Vote vote;
        vote.mirror.normal = d / length;
        vote.mirror.offset = vote.mirror.normal.dot(p + q) / 2.;
        const double agreement = vote.mirror.image_of_vector(normals[order[a]]).dot(normals[order[b]]);
        if(agreement < .9)
          continue;
        vote.weight = (1. - difference / .15) * (agreement - .9) / .1;
        votes.push_back(vote);
      }
    return votes;
  }

  // The votes gather in cells of planes (normal and offset); the fullest ones, after some steps to the mean of the votes nearby.
  static std::vector<Mirror> from_votes(const std::vector<Vote>& votes)
  {
    constexpr double width = .12;
    using Cell = std::array<int, 4>;
    std::map<Cell, std::vector<std::pair<std::size_t, double> > >
        cells; // votes with the sign of their normal
    const auto cell_of = [](const Eigen::Vector3d& n, const double c)
    {
      return Cell{int(std::floor(n[0] / width)), int(std::floor(n[1] / width)), int(std::floor(n[2] / width)),
                  int(std::floor(c / width))};
    };
    for(std::size_t i = 0; i < votes.size(); ++i)
      for(const double sign : {1., -1.})
        cells[cell_of(sign * votes[i].mirror.normal, sign * votes[i].mirror.offset)].push_back({i, sign});

    // the mean of the votes near a plane, and their weight
    const auto mean_near = [&](const Mirror& m)
    {
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      double offset = 0., weight = 0.;
      const Cell middle = cell_of(m.normal, m.offset);
      Cell c;
      for(c[0] = middle[0] - 1; c[0] <= middle[0] + 1; ++c[0])
        for(c[1] = middle[1] - 1; c[1] <= middle[1] + 1; ++c[1])
          for(c[2] = middle[2] - 1; c[2] <= middle[2] + 1; ++c[2])
            for(c[3] = middle[3] - 1; c[3] <= middle[3] + 1; ++c[3])
              if(const auto found = cells.find(c); found != cells.end())
                for(const auto& [i, sign] : found->second)
                {
                  const Mirror& v = votes[i].mirror;
                  const double d = (sign * v.normal - m.normal).squaredNorm() +
                                   (sign * v.offset - m.offset) * (sign * v.offset - m.offset);
                  if(d >= width * width)
                    continue;
                  const double w = votes[i].weight * (1. - d / (width * width));
                  normal += w * sign * v.normal;
                  offset += w * sign * v.offset;
                  weight += w;
                }
      return Vote{weight > 0. ? Mirror{normal.normalized(), offset / weight} : m, weight};
    };

    // the fullest cells begin; half of them are the other side of another one
    std::vector<std::pair<double, Cell> > full;
    for(const auto& [cell, members] : cells)
    {
      double weight = 0.;
      for(const auto& [i, sign] : members)
        weight += votes[i].weight;
      full.push_back({weight, cell});
    }
    std::stable_sort(full.begin(), full.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    if(full.size() > 200)
      full.resize(200);
    std::vector<Vote> peaks;
    for(const auto& f : full)
    {
      const auto& [i, sign] = cells[f.second].front();
      Vote v{{sign * votes[i].mirror.normal, sign * votes[i].mirror.offset}, 0.};
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      double offset = 0., weight = 0.;
      for(const auto& [k, s] : cells[f.second])
      {
        normal += s * votes[k].weight * votes[k].mirror.normal;
        offset += s * votes[k].weight * votes[k].mirror.offset;
        weight += votes[k].weight;
      }
      if(weight > 0. && normal.norm() > 0.)
        v.mirror = {normal.normalized(), offset / weight};
      for(int step = 0; step < 4; ++step)
        v = mean_near(v.mirror);
      peaks.push_back(v);
    }
    std::stable_sort(peaks.begin(), peaks.end(),
                     [](const Vote& a, const Vote& b) { return a.weight > b.weight; });
    std::vector<Mirror> result;
    for(const Vote& v : peaks)
    {
      if(result.size() >= 40)
        break;
      if(std::none_of(result.begin(), result.end(),
                      [&](const Mirror& m) { return are_alike(m, v.mirror, .5 * alike); }))
        result.push_back(v.mirror);
    }
    return result;
  }

  // the best `count`, no two of them alike
  static void keep_best(std::vector<Mirror_fit>& fits, const std::size_t count, const double difference)
  {
    std::stable_sort(fits.begin(), fits.end(),
                     [](const Mirror_fit& a, const Mirror_fit& b) { return a.evidence > b.evidence; });
    std::vector<Mirror_fit> kept;
    for(const Mirror_fit& f : fits)
      if(kept.size() < count &&
         std::none_of(kept.begin(), kept.end(),
                      [&](const Mirror_fit& k) { return are_alike(k.mirror, f.mirror, difference); }))
        kept.push_back(f);
    fits = std::move(kept);
  }

  const Pose_surface& m_surface;
  std::vector<std::size_t> m_few, m_every;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_POSE_MIRROR_H
