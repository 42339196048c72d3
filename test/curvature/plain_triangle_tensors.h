#ifndef SHAPE_CHARACTERISTICS_TEST_CURVATURE_PLAIN_TRIANGLE_TENSORS_H
#define SHAPE_CHARACTERISTICS_TEST_CURVATURE_PLAIN_TRIANGLE_TENSORS_H

#include "estimator_checks.h"

#include "plain_algebra.h"

#include <CGAL/number_type_config.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <vector>

// Estimators from the shape operators of triangles as their papers write them, slow and plain: least squares by QR,
// tensors as matrices, rotations by Rodrigues's formula. They share nothing with the library.
namespace plain {

using estimator_checks::eigen;
using test_support::Analytic_surface;

// the symmetric matrix that takes edges to differences of the normals (thesis, 7.3 to 7.5), over the first
// `number_of_edges` edges, as a tensor of space
inline Eigen::Matrix3d triangle_tensor(const std::array<Eigen::Vector3d, 3>& p,
                                       const std::array<Eigen::Vector3d, 3>& n,
                                       int number_of_edges)
{
  const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
  const Eigen::Vector3d u = (p[1] - p[0]).normalized(), v = normal.cross(u);
  Eigen::MatrixXd a(2 * number_of_edges, 3);
  Eigen::VectorXd b(2 * number_of_edges);
  for(int k = 0; k < number_of_edges; ++k)
  {
    const Eigen::Vector3d e = p[std::size_t((k + 1) % 3)] - p[std::size_t(k)];
    const Eigen::Vector3d d = n[std::size_t((k + 1) % 3)] - n[std::size_t(k)];
    a.row(2 * k) << e.dot(u), e.dot(v), 0.;
    a.row(2 * k + 1) << 0., e.dot(u), e.dot(v);
    b.segment<2>(2 * k) << d.dot(u), d.dot(v);
  }
  const Eigen::Vector3d x = test_support::least_squares(a, b);
  return x[0] * u * u.transpose() + x[1] * (u * v.transpose() + v * u.transpose()) + x[2] * v * v.transpose();
}

// the eigenvalues in the plane orthogonal to `normal`, ascending
inline Eigen::Vector2d eigenvalues(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& normal)
{
  Eigen::Matrix<double, 3, 2> basis;
  basis.col(0) = normal.unitOrthogonal();
  basis.col(1) = normal.cross(basis.col(0));
  const Eigen::Matrix2d m = basis.transpose() * tensor * basis;
  return test_support::symmetric_eigenvalues(m);
}

struct Corner
{
  std::array<Eigen::Vector3d, 3> points, normals; // of the triangle, the vertex first
};

inline std::vector<Corner> corners_at(const Analytic_surface& s, std::size_t vertex)
{
  std::vector<Corner> corners;
  for(const auto& t : s.triangles)
    for(std::size_t k = 0; k < 3; ++k)
      if(t[k] == vertex)
      {
        Corner c;
        for(std::size_t j = 0; j < 3; ++j)
        {
          c.points[j] = eigen(s.points[t[(k + j) % 3]]);
          c.normals[j] = eigen(s.exact[t[(k + j) % 3]].normal);
        }
        corners.push_back(c);
      }
  return corners;
}

// M. Meyer et al. 2003, section 3.3, for the first vertex of a triangle
inline double mixed_area(const std::array<Eigen::Vector3d, 3>& p)
{
  const auto angle = [&](std::size_t k)
  {
    const Eigen::Vector3d a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
    return std::atan2(a.cross(b).norm(), a.dot(b));
  };
  const double area = .5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
  if(angle(0) > CGAL_PI / 2.)
    return area / 2.;
  if(angle(1) > CGAL_PI / 2. || angle(2) > CGAL_PI / 2.)
    return area / 4.;
  return ((p[2] - p[0]).squaredNorm() / std::tan(angle(1)) +
          (p[1] - p[0]).squaredNorm() / std::tan(angle(2))) /
         8.;
}

inline Eigen::Vector3d face_normal(const Corner& c)
{
  return (c.points[1] - c.points[0]).cross(c.points[2] - c.points[0]).normalized();
}

inline Eigen::Vector2d rusinkiewicz(const Analytic_surface& s, std::size_t vertex)
{
  const Eigen::Vector3d normal = eigen(s.exact[vertex].normal);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double weights = 0.;
  for(const Corner& c : corners_at(s, vertex))
  {
    const Eigen::Matrix3d rotation = test_support::shortest_rotation(face_normal(c), normal);
    const double weight = mixed_area(c.points);
    sum += weight * rotation * triangle_tensor(c.points, c.normals, 3) * rotation.transpose();
    weights += weight;
  }
  return eigenvalues(sum / weights, normal);
}

inline Eigen::Vector2d
tangent_space(const Analytic_surface& s, std::size_t vertex, int number_of_edges, bool by_area)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weights = 0.;
  for(Corner c : corners_at(s, vertex))
  {
    // two edges are those at the vertex after the lexicographically smallest one
    const auto is_before = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
    { return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3); };
    const auto first = std::min_element(c.points.begin(), c.points.end(), is_before) - c.points.begin();
    std::rotate(c.points.begin(), c.points.begin() + first, c.points.end());
    std::rotate(c.normals.begin(), c.normals.begin() + first, c.normals.end());
    const double weight = by_area ? (c.points[1] - c.points[0]).cross(c.points[2] - c.points[0]).norm() : 1.;
    sum += weight * eigenvalues(triangle_tensor(c.points, c.normals, number_of_edges), face_normal(c));
    weights += weight;
  }
  return sum / weights;
}

} // namespace plain

#endif // SHAPE_CHARACTERISTICS_TEST_CURVATURE_PLAIN_TRIANGLE_TENSORS_H
