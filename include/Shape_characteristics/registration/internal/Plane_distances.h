#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_PLANE_DISTANCES_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_PLANE_DISTANCES_H

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The least-squares problem of the small motion that brings points to planes.
class Plane_distances
{
public:
  struct Term
  {
    Eigen::Vector3d point, normal; // of the moving point, and of the plane
    double distance = 0.;          // of the point above the plane
    double weight = 0.;            // 0: there is no such term
  };

  explicit Plane_distances(const std::vector<Term>& terms)
  {
    double sum = 0.;
    for(const Term& t : terms)
    {
      sum += t.weight;
      m_center += t.weight * t.point;
    }
    m_center /= sum;
    double squares = 0.;
    for(const Term& t : terms)
      squares += t.weight * (t.point - m_center).squaredNorm();
    m_size = std::sqrt(squares / sum);
    if(!(m_size > 0.))
      return;

    // rotation about the center by radians, then translation in units of the size
    Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
    for(const Term& t : terms)
    {
      Eigen::Matrix<double, 6, 1> row;
      row << ((t.point - m_center) / m_size).cross(t.normal), t.normal;
      matrix.noalias() += (t.weight * row) * row.transpose();
      m_right -= (t.weight * (t.distance / m_size)) * row;
    }
    m_solver.compute(matrix);
  }

  // whether the points are not all one
  bool is_valid() const { return m_size > 0.; }

  double conditioning() const
  {
    const auto& values = m_solver.eigenvalues();
    return (std::max)(values[0], 0.) / values[5];
  }

  // the motion; in directions in which the planes say nothing, none
  Eigen::Isometry3d solve() const
  {
    constexpr double rounding = 1e-12; // of eigenvalues
    const auto& values = m_solver.eigenvalues();
    Eigen::Matrix<double, 6, 1> x = Eigen::Matrix<double, 6, 1>::Zero();
    for(int i = 0; i < 6; ++i)
      if(values[i] > rounding * values[5])
        x += (m_solver.eigenvectors().col(i).dot(m_right) / values[i]) * m_solver.eigenvectors().col(i);
    const Eigen::Vector3d axis = x.head<3>();
    const double angle = axis.norm();
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    if(angle > 0.)
      motion.linear() = Eigen::AngleAxisd(angle, axis / angle).toRotationMatrix();
    motion.translation() = m_center + m_size * x.tail<3>() - motion.linear() * m_center;
    return motion;
  }

private:
  Eigen::Vector3d m_center = Eigen::Vector3d::Zero();
  double m_size = 0.;
  Eigen::Matrix<double, 6, 1> m_right = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6> > m_solver;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_INTERNAL_PLANE_DISTANCES_H
