#ifndef SHAPE_CHARACTERISTICS_PRECOMPILED_EXPRESSIONS_H
#define SHAPE_CHARACTERISTICS_PRECOMPILED_EXPRESSIONS_H

// Expressions of Eigen that inline functions of many headers have: a compiler makes classes of them by the hundred wherever such a
// header is read, whether the function is called or not. What is precompiled has them already. Nothing calls what is here.

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace precompiled {

inline double expressions(Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, double s)
{
  using Eigen::Vector3d;
  a = b + c;
  a = b - c;
  a = s * b;
  a = b * s;
  a = b / s;
  a = -b;
  a = Vector3d::Zero();
  a = Vector3d::Constant(s);
  a = Vector3d::Unit(1);
  a = Vector3d::UnitX();
  a = b.cross(c);
  a = b.normalized();
  a = b.cwiseMin(c);
  a = b.cwiseMax(c);
  a = b.cwiseAbs();
  a = b + s * c;
  a = b - s * c;
  a = (b - c) / s;
  a = s * (b - c);
  a = (b - c).cross(c - b);
  a = (b - c).normalized();
  a = b.cross(c).normalized();
  a = b - b.dot(c) * c;
  a = .5 * (b + c);
  a = s * b + s * c;
  a = b + s * c + s * a;
  a = b / s / s;
  a += b;
  a -= b;
  a *= s;
  a /= s;
  a += s * b;
  a -= s * b;
  a.setZero();
  a.normalize();
  std::vector<Vector3d> list(3, a);
  list.push_back(b);
  const bool all = b == c && b != a && b.allFinite() && b.isZero();
  return (all ? 1. : 0.) + b.dot(c) + b.norm() + b.squaredNorm() + (b - c).norm() + (b - c).squaredNorm() +
         b.maxCoeff() + b.minCoeff() + b.sum() + b.cwiseAbs().maxCoeff() + (b - c).dot(a) +
         b.cross(c).norm() + b.cross(c).dot(a) + b.stableNorm() + b.lpNorm<Eigen::Infinity>() +
         b.cross(c).squaredNorm() + (b - c).dot(b - c) + (b / s / s).dot(b / s / s) + (s * b + s * c).norm() +
         (s * b + s * c)[0] + (b / s).squaredNorm() + (b / s).norm() + list.front().x();
}

inline double expressions(Eigen::Matrix3d& m, const Eigen::Matrix3d& n, Eigen::Vector3d& a, double s)
{
  const Eigen::Vector3d b = a;
  m = n * m;
  m = n.transpose();
  m = n.transpose() * n;
  m = n * n.transpose();
  m = b * b.transpose();
  m += b * b.transpose();
  m += s * b * b.transpose();
  m = s * n;
  m += n;
  m.setZero();
  m = Eigen::Matrix3d::Zero();
  m = Eigen::Matrix3d::Identity();
  m.col(0) = b;
  m.row(0) = b.transpose();
  a = n * b;
  a = n.transpose() * b;
  a = n.col(1);
  a = n.row(1).transpose();
  return m.determinant() + n.trace() + b.dot(n * b) + n(0, 1) + n.norm();
}

inline double expressions(Eigen::MatrixXd& m, Eigen::VectorXd& v, double s)
{
  m = Eigen::MatrixXd::Zero(3, 3);
  v = Eigen::VectorXd::Zero(3);
  const Eigen::VectorXd w = m * v;
  v += s * w;
  v -= w;
  v *= s;
  return v.dot(w) + v.norm() + v.squaredNorm() + m(1, 2) + v[0];
}

inline double expressions(Eigen::Vector2d& a,
                          const Eigen::Vector2d& b,
                          Eigen::Matrix4d& m,
                          Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>& f)
{
  a = b - a;
  m = m * m;
  m.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity();
  f.resize(2, 3);
  return (b - a).squaredNorm() + b.dot(a) + m(0, 1) + double(f(0, 1));
}

} // namespace precompiled

#endif // SHAPE_CHARACTERISTICS_PRECOMPILED_EXPRESSIONS_H
