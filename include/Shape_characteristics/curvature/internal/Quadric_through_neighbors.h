#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_QUADRIC_THROUGH_NEIGHBORS_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_QUADRIC_THROUGH_NEIGHBORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/curvature/internal/Fitted_sample.h>
#include <Shape_characteristics/internal/Scaled_neighborhood.h>
#include <Shape_characteristics/internal/is_tip.h>
#include <Shape_characteristics/internal/leave_wide_gap.h>
#include <Shape_characteristics/internal/tangent_basis.h>
#include <Shape_characteristics/interpolation/Local_hermite_rbf.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

/*
  The quadric through a sample and its neighbors, if they lie on one, to eight digits of their distances: on a sphere, a
  cylinder, a cone, an ellipsoid, a paraboloid, a hyperboloid. (Other surfaces come as close to one only where thousands of
  samples make up a radius of curvature.) The quadric is the null vector of the matrix of its monomials, and must be the
  only one. Those of a plane, of which there are many, aren't looked for.

  Where normals are those of level sets of a quadratic function, to eight digits of their angles, it is the level set through the
  sample, though the neighbors are somewhat off it: on others, as they are where linear interpolation between the values of such a
  function put them. (Through those of one layer of a grid there is a quadric, too, but another one.)

  An object may be used again and again: it keeps its memory.
*/
template <typename SampledSurface>
class Quadric_through_neighbors
{
  using Vector = Eigen::Vector3d;
  static constexpr int s_monomials = 9; // all but the constant: the sample is the origin
  static constexpr int s_most_neighbors = 48;
  // two for the normal of each sample
  static constexpr int s_most_equations = 2 * (s_most_neighbors + 1);
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, s_monomials, Eigen::ColMajor, s_most_equations>;
  using Square_matrix = Eigen::Matrix<double, s_monomials, s_monomials>;
  using Coefficients = Eigen::Matrix<double, s_monomials, 1>;

public:
  // its status isn't that of an estimate if there is no quadric
  Fitted_sample operator()(const SampledSurface& surface, std::size_t i)
  {
    m_is_at_tip = false;
    const Fitted_sample of_points = fit(surface, i, Known::POINTS);
    if(m_is_at_tip || (is_estimated(of_points.status) && have_normals_of(m_quadric)))
      return of_points;
    const Fitted_sample of_normals = fit(surface, i, Known::NORMALS);
    return is_estimated(of_normals.status) ? of_normals : of_points;
  }

  // whether there is none for the last sample because it is the tip of a cone
  bool is_at_tip() const { return m_is_at_tip; }

private:
  enum class Known
  {
    POINTS,
    NORMALS
  };

  static constexpr std::size_t s_fewest_neighbors = 12; // a quadric through nine is no surprise
  static constexpr double s_distance = 1e-8;            // how far points may be off the surface
  static constexpr double s_angle = 1e-8;               // how far normals may be off those of the surface
  static constexpr double s_distance_of_others = .1; // how far points may be off it if it has their normals
  static constexpr double s_gap = 1e3;               // between the smallest singular value and the next
  static constexpr double s_least_slope = .01;       // of a quadric with coefficients of length 1
  static constexpr double s_least_cosine = .8;       // of the angle between the gradient and the normal
  static constexpr double s_zero = 1e-6;             // of coefficients, in units of the largest
  static constexpr std::size_t s_lines = 6;          // that determine a cylinder or a cone
  static constexpr std::size_t s_rows = 3;           // that determine nothing
  static constexpr double s_between_lines = 1e-4;    // least distance

  Fitted_sample fit(const SampledSurface& surface, std::size_t i, Known known)
  {
    Estimation_status status;
    std::size_t number_of_neighbors = s_fewest_neighbors - 1;
    do
    {
      const std::size_t fewer = number_of_neighbors;
      status = m_neighborhood.collect(surface, i, m_workspace, std::size_t(s_most_neighbors), fewer + 1);
      if(!is_estimated(status))
      {
        m_is_at_tip = status == Estimation_status::DEGENERATE &&
                      is_tip(surface, i, surface.neighbors(i, s_fewest_neighbors, m_workspace));
        return Fitted_sample();
      }
      number_of_neighbors = m_neighborhood.points.size() - 1;
      if(number_of_neighbors <= fewer || !find_quadric(known))
        return Fitted_sample();
    } while(!is_determined(m_quadric));
    Local_implicit_surface result;
    result.status = status;
    result.gradient = m_quadric.head<3>();
    result.hessian = hessian_of(m_quadric) / m_neighborhood.scale;
    result.displacement.setZero();
    return Fitted_sample(result);
  }

  // the quadric of all points or normals, its gradient at the sample of unit length; whether there is one
  bool find_quadric(Known known)
  {
    if(known == Known::POINTS)
      collect_monomials();
    else
      collect_slopes();
    if(!find_null_vector(m_quadric))
      return false;
    const double slope = m_quadric.head<3>().norm();
    if(!(slope > s_least_slope)) // as at the tip of a cone
      return false;
    m_quadric /= slope;
    if(m_quadric.head<3>().dot(m_neighborhood.normals[0]) < 0.)
      m_quadric = -m_quadric;
    if(!m_quadric.allFinite() || !(m_quadric.head<3>().dot(m_neighborhood.normals[0]) > s_least_cosine))
      return false;
    return known == Known::POINTS ? are_on(m_quadric, s_distance)
                                  : have_normals_of(m_quadric) && are_on(m_quadric, s_distance_of_others);
  }

  // the value at each neighbor of x, y, z, x^2 / 2, y^2 / 2, z^2 / 2, xy, xz, yz, in the order of `hessian_of`
  void collect_monomials()
  {
    const std::size_t n = m_neighborhood.points.size() - 1;
    m_matrix.resize(Eigen::Index(n), s_monomials);
    for(std::size_t k = 0; k < n; ++k)
    {
      const Vector& p = m_neighborhood.points[k + 1];
      m_matrix.row(Eigen::Index(k)) << p.x(), p.y(), p.z(), p.x() * p.x() / 2., p.y() * p.y() / 2.,
          p.z() * p.z() / 2., p.x() * p.y(), p.x() * p.z(), p.y() * p.z();
    }
  }

  // their slopes at each sample, along the two axes of its tangent plane
  void collect_slopes()
  {
    const std::size_t n = m_neighborhood.points.size();
    m_matrix.resize(Eigen::Index(2 * n), s_monomials);
    for(std::size_t k = 0; k < n; ++k)
    {
      std::array<Vector, 2> axes;
      tangent_basis(m_neighborhood.normals[k], axes[0], axes[1]);
      const Vector& p = m_neighborhood.points[k];
      for(std::size_t axis = 0; axis < 2; ++axis)
      {
        const Vector& t = axes[axis];
        m_matrix.row(Eigen::Index(2 * k + axis)) << t.x(), t.y(), t.z(), p.x() * t.x(), p.y() * t.y(),
            p.z() * t.z(), p.x() * t.y() + p.y() * t.x(), p.x() * t.z() + p.z() * t.x(),
            p.y() * t.z() + p.z() * t.y();
      }
    }
  }

  // the coefficients with which nothing is left of the columns of the matrix
  bool find_null_vector(Coefficients& result)
  {
    // Mostly there are none, as the last pivot tells.
    m_qr.compute(m_matrix);
    const double bound = std::sqrt(double(m_matrix.rows())) * s_distance, factor = 10.;
    if(!(std::abs(m_qr.matrixQR()(s_monomials - 1, s_monomials - 1)) < factor * bound))
      return false;
    const Square_matrix triangle =
        m_qr.matrixQR().template topRows<s_monomials>().template triangularView<Eigen::Upper>();
    const Eigen::JacobiSVD<Square_matrix> svd(triangle, Eigen::ComputeFullV);
    const auto& values = svd.singularValues();
    const double smallest = values[s_monomials - 1], rounding = 1e-15 * values[0];
    if(!(smallest < bound && values[s_monomials - 2] > s_gap * (std::max)(smallest, rounding)))
      return false;
    result = m_qr.colsPermutation() * svd.matrixV().col(s_monomials - 1);
    return true;
  }

  static Eigen::Matrix3d hessian_of(const Coefficients& c)
  {
    Eigen::Matrix3d result;
    result << c[3], c[6], c[7], c[6], c[4], c[8], c[7], c[8], c[5];
    return result;
  }

  // whether all points are on it, or off it by so much at most
  bool are_on(const Coefficients& quadric, double distance) const
  {
    const Vector gradient = quadric.head<3>();
    const Eigen::Matrix3d hessian = hessian_of(quadric);
    return std::all_of(m_neighborhood.points.begin(), m_neighborhood.points.end(),
                       [&](const Vector& p)
                       {
                         const Vector turn = hessian * p;
                         return std::abs(gradient.dot(p) + .5 * p.dot(turn)) <=
                                distance * (std::max)((gradient + turn).norm(), 1.);
                       });
  }

  // whether all samples have the normals of the level sets through them
  bool have_normals_of(const Coefficients& quadric) const
  {
    const Vector gradient = quadric.head<3>();
    const Eigen::Matrix3d hessian = hessian_of(quadric);
    for(std::size_t k = 0; k < m_neighborhood.points.size(); ++k)
    {
      const Vector there = gradient + hessian * m_neighborhood.points[k];
      if(!((there.normalized() - m_neighborhood.normals[k]).norm() <= s_angle))
        return false;
    }
    return true;
  }

  // Through any five lines that are parallel or meet in a point there is a cylinder or a cone. So it tells nothing that there is one
  // through those of a profile that was moved, or scaled, with samples in rows; unless it is circular, or there are more lines.
  bool is_determined(const Coefficients& quadric) const
  {
    const Eigen::Matrix3d hessian = hessian_of(quadric);
    Eigen::Matrix4d form = Eigen::Matrix4d::Zero(); // over homogeneous coordinates
    form.topLeftCorner<3, 3>() = hessian;
    form.topRightCorner<3, 1>() = quadric.head<3>();
    form.bottomLeftCorner<1, 3>() = quadric.head<3>().transpose();
    const Eigen::JacobiSVD<Eigen::Matrix4d> svd(form, Eigen::ComputeFullV);
    const auto& sizes = svd.singularValues();
    if(!(sizes[2] > s_zero * sizes[0]))
      return is_in_face(quadric.head<3>());
    if(are_in_few_rows())
      return false;
    if(!(sizes[3] < s_zero * sizes[2])) // neither of both
      return true;
    const Eigen::Vector3d values =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(hessian, Eigen::EigenvaluesOnly).eigenvalues();
    const double largest = values.lpNorm<Eigen::Infinity>();
    if(std::abs(values[1]) > s_gap * s_zero * largest &&
       (std::min)(values[1] - values[0], values[2] - values[1]) < s_zero * largest)
      return true;
    const Eigen::Vector4d tip = svd.matrixV().col(3); // infinitely far that of a cylinder
    const auto are_on_a_line = [&](const Vector& p, const Vector& q)
    { return (q - p).cross((tip.head<3>() - tip[3] * p).normalized()).norm() < s_between_lines; };
    std::array<Vector, s_lines> lines; // a point of each
    std::size_t number_of_lines = 0;
    for(const Vector& p : m_neighborhood.points)
      if(std::none_of(lines.begin(), lines.begin() + std::ptrdiff_t(number_of_lines),
                      [&](const Vector& q) { return are_on_a_line(p, q); }))
      {
        lines[number_of_lines++] = p;
        if(number_of_lines == s_lines)
          return true;
      }
    return false;
  }

  // Whether all are in few planes beside one another, as samples in rows are that are farther apart than their samples: through any
  // three circles around an axis there is a quadric, and so there is through the ends of few rows.
  bool are_in_few_rows() const
  {
    const Vector& a = m_neighborhood.points[1];
    const auto b = std::find_if(m_neighborhood.points.begin() + 2, m_neighborhood.points.end(),
                                [&](const Vector& p)
                                { return a.cross(p).norm() > s_between_lines * a.norm() * p.norm(); });
    if(b == m_neighborhood.points.end())
      return true;
    const Vector across = a.cross(*b).normalized();
    std::array<double, s_rows> rows{}; // that of the sample is the first
    std::size_t number_of_rows = 1;
    for(const Vector& p : m_neighborhood.points)
    {
      const double place = across.dot(p);
      if(std::any_of(rows.begin(), rows.begin() + std::ptrdiff_t(number_of_rows),
                     [&](const double row) { return std::abs(place - row) < s_between_lines; }))
        continue;
      if(number_of_rows == s_rows)
        return false;
      rows[number_of_rows++] = place;
    }
    return true;
  }

  // Any two rows of samples in planes lie on these: two planes tell of a face of a part if there are neighbors all around in that of
  // the sample, with the normal `normal`.
  bool is_in_face(const Vector& normal) const
  {
    Vector t1, t2;
    tangent_basis(normal, t1, t2);
    std::vector<double> angles;
    for(std::size_t k = 1; k < m_neighborhood.points.size(); ++k)
      if(const Vector& p = m_neighborhood.points[k]; std::abs(normal.dot(p)) <= s_distance)
        angles.push_back(std::atan2(t2.dot(p), t1.dot(p)));
    std::sort(angles.begin(), angles.end());
    return !angles.empty() && !leave_wide_gap(angles.size(), [&](const std::size_t k) { return angles[k]; });
  }

  typename SampledSurface::Workspace m_workspace;
  Scaled_neighborhood m_neighborhood;
  bool m_is_at_tip = false;
  Coefficients m_quadric; // the last one that was found
  Matrix m_matrix;
  Eigen::ColPivHouseholderQR<Matrix> m_qr;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_QUADRIC_THROUGH_NEIGHBORS_H
