#include "plain_thesis.h"

#include <Shape_characteristics/curvature/implicit_surface_curvatures.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cstddef>
#include <vector>

namespace speed {
namespace {

// phi(r) = r^5, and phi'/r, (phi'/r)'/r and so on
struct Radial_derivatives
{
  explicit Radial_derivatives(double r)
    : phi(r * r * r * r * r),
      A(5. * r * r * r),
      B(15. * r),
      C(r > 0. ? 15. / r : 0.)
  {}
  double phi, A, B, C;
};

Curvatures curvatures_at(const Eigen::Vector3d& x,
                         const std::vector<Eigen::Vector3d>& points,
                         const std::vector<Eigen::Vector3d>& normals)
{
  const Eigen::Index m = Eigen::Index(points.size());
  Eigen::MatrixXd matrix(4 * m, 4 * m);
  Eigen::VectorXd data(4 * m);
  for(Eigen::Index i = 0; i < m; ++i)
  {
    for(Eigen::Index j = 0; j < m; ++j)
    {
      const Eigen::Vector3d d = points[std::size_t(i)] - points[std::size_t(j)];
      const Radial_derivatives of(d.norm());
      matrix(4 * i, 4 * j) = of.phi;
      matrix.block<1, 3>(4 * i, 4 * j + 1) = -of.A * d.transpose();
      matrix.block<3, 1>(4 * i + 1, 4 * j) = of.A * d;
      matrix.block<3, 3>(4 * i + 1, 4 * j + 1) =
          -of.A * Eigen::Matrix3d::Identity() - of.B * d * d.transpose();
    }
    data[4 * i] = 0.;
    data.segment<3>(4 * i + 1) = normals[std::size_t(i)];
  }
  const Eigen::VectorXd weights = matrix.partialPivLu().solve(data);

  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  for(Eigen::Index j = 0; j < m; ++j)
  {
    const Eigen::Vector3d d = x - points[std::size_t(j)];
    const Radial_derivatives of(d.norm());
    const double alpha = weights[4 * j];
    const Eigen::Vector3d beta = weights.segment<3>(4 * j + 1);
    const double s = beta.dot(d);
    gradient += alpha * of.A * d - of.B * s * d - of.A * beta;
    hessian += (alpha * of.A - of.B * s) * Eigen::Matrix3d::Identity() +
               (alpha * of.B - of.C * s) * d * d.transpose() -
               of.B * (d * beta.transpose() + beta * d.transpose());
  }
  return SC::implicit_surface_curvatures(Kernel::Vector_3(gradient.x(), gradient.y(), gradient.z()), hessian);
}

} // namespace

void plain_thesis(Workload& w, unsigned int rings)
{
  const SC::Face_graph_samples samples(w.mesh, w.mesh.points(), SC::Neighborhood::rings(rings));
  SC::Face_graph_samples::Workspace workspace;
  const auto to_eigen = [](const auto& v) { return Eigen::Vector3d(v.x(), v.y(), v.z()); };
  for(std::size_t i = 0; i < samples.size(); ++i)
  {
    std::vector<Eigen::Vector3d> points{samples.point(i)}, normals{to_eigen(w.normals[w.vertices[i]])};
    for(const auto j : samples.neighbors(i, 0, workspace))
    {
      points.push_back(samples.point(j));
      normals.push_back(to_eigen(w.normals[w.vertices[j]]));
    }
    w.curvatures[w.vertices[i]] = curvatures_at(samples.point(i), points, normals);
    w.statuses[w.vertices[i]] = SC::Estimation_status::ESTIMATED;
  }
}

} // namespace speed
