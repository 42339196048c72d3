#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_PITCH_OF_FEATURES_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_PITCH_OF_FEATURES_H

#include <Shape_characteristics/head_features/Head_feature.h>
#include <Shape_characteristics/head_features/internal/Found_head_features.h>
#include <Shape_characteristics/internal/solve_positive_semidefinite.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// A feature where faces have it in the mean.
struct Mean_feature
{
  Head_feature feature;
  Eigen::Vector3d position; // in the frame of `Head_pose`
  double moves_with_jaw;    // 1: as the chin does, 0: not at all
};

/*
  The mean of the true features of twelve heads with random coefficients of ICT-FaceKit (MIT licence, (c) 2020 USC Institute for
  Creative Technologies), in the frame of that model, made symmetric. The top is not among them: where it is depends on the pitch.
*/
inline std::vector<Mean_feature> mean_features()
{
  struct Row
  {
    Head_feature left, right; // the same feature where it is on the midline
    int x, y, z;              // of the right one; thousandths
    double moves_with_jaw;
  };
  using F = Head_feature;
  // clang-format off
  static constexpr std::array<Row, 20> rows = {{
    {F::NOSE_TIP, F::NOSE_TIP,   0,  -80, 440, 0.}, {F::CHIN, F::CHIN,     0, -342,  369, 1.},
    {F::N1,       F::N1,         0, -146, 386, 0.}, {F::N3,   F::N3,       0,  -12,  395, 0.},
    {F::N4,       F::N4,         0,   56, 350, 0.}, {F::M3,   F::M3,       0, -200,  398, 0.},
    {F::M4,       F::M4,         0, -262, 390, 1.}, {F::M1,   F::M2,     100, -236,  332, .5},
    {F::N5,       F::N7,        82,   -8, 307, 0.}, {F::N6,   F::N8,      56,   55,  301, 0.},
    {F::LEFT_E1,  F::RIGHT_E1, 180,   46, 264, 0.}, {F::LEFT_E2, F::RIGHT_E2,  73,   37,  288, 0.},
    {F::LEFT_E3,  F::RIGHT_E3, 156,   63, 295, 0.}, {F::LEFT_E4, F::RIGHT_E4, 111,   66,  303, 0.},
    {F::LEFT_E5,  F::RIGHT_E5, 156,   31, 290, 0.}, {F::LEFT_E6, F::RIGHT_E6, 109,   30,  297, 0.},
    {F::LEFT_R1,  F::RIGHT_R1, 341,   35, -50, 0.}, {F::LEFT_R2, F::RIGHT_R2, 361,   31, -123, 0.},
    {F::LEFT_R3,  F::RIGHT_R3, 317, -164, -35, 0.}, {F::LEFT_R4, F::RIGHT_R4, 341, -127, -100, 0.}}};
  // clang-format on
  std::vector<Mean_feature> result;
  for(const Row& r : rows)
  {
    const Eigen::Vector3d right = Eigen::Vector3d(r.x, r.y, r.z) / 1000.;
    result.push_back({r.right, right, r.moves_with_jaw});
    if(r.left != r.right)
      result.push_back({r.left, {-right.x(), right.y(), right.z()}, r.moves_with_jaw});
  }
  return result;
}

/*
  By how much the frame in which `found` are is turned about its x-axis, in radians, judged by where faces have their features: those
  of one that is turned by a positive angle are turned from y towards z.

  Features differ from the mean ones by a similarity in the plane of symmetry, which is what is sought, and by what distinguishes
  faces: a random field, equal parts of which are smooth and belong to a single feature (generalized least squares). An
  open mouth moves the jaw by about as much as it is open. The frame itself was right up to an error, too.
*/
inline double pitch_of_features(const Found_head_features& found)
{
  constexpr double width = .3, deviation = .01;          // of the random field, in the unit of the frame
  constexpr double error_of_frame = 2. * CGAL_PI / 180.; // standard deviation
  constexpr double gap_of_closed_mouth = .08;            // the largest distance of M3 and M4
  constexpr std::size_t few = 8;

  std::vector<Mean_feature> means;
  for(const Mean_feature& m : mean_features())
    if(found[m.feature].is_found())
      means.push_back(m);
  if(means.size() < few)
    return 0.;

  double opening = 0.;
  if(const auto& upper = found[Head_feature::M3], &lower = found[Head_feature::M4];
     upper.is_found() && lower.is_found())
    opening = (std::max)(0., (upper.position() - lower.position()).norm() - gap_of_closed_mouth);

  const auto n = Eigen::Index(means.size());
  Eigen::MatrixXd covariance(n, n);
  for(Eigen::Index i = 0; i < n; ++i)
    for(Eigen::Index j = 0; j < n; ++j)
    {
      const Mean_feature &a = means[std::size_t(i)], &b = means[std::size_t(j)];
      const double smooth = std::exp(-(a.position - b.position).squaredNorm() / (2. * width * width));
      covariance(i, j) = deviation * deviation * (smooth + (i == j)) +
                         opening * opening * a.moves_with_jaw * b.moves_with_jaw;
    }
  // y = scale * (cos * y_mean - sin * z_mean) + shift_y, z = scale * (sin * y_mean + cos * z_mean) + shift_z, for the unknowns
  // scale * sin, scale * cos, shift_y, shift_z
  Eigen::MatrixXd y_rows = Eigen::MatrixXd::Zero(n, 4), z_rows = y_rows;
  Eigen::VectorXd y(n), z(n);
  for(Eigen::Index i = 0; i < n; ++i)
  {
    const Eigen::Vector3d& m = means[std::size_t(i)].position;
    const Eigen::Vector3d& p = found[means[std::size_t(i)].feature].position();
    y_rows.row(i) << -m.z(), m.y(), 1., 0.;
    z_rows.row(i) << m.y(), m.z(), 0., 1.;
    y[i] = p.y();
    z[i] = p.z();
  }
  // of the types that solve_positive_semidefinite() has: compiled but once
  const Eigen::LDLT<Eigen::MatrixXd> factors(covariance);
  Eigen::MatrixXd matrix(4, 4);
  Eigen::VectorXd right(4);
  for(Eigen::Index k = 0; k < 4; ++k)
  {
    const Eigen::VectorXd y_row = y_rows.col(k), z_row = z_rows.col(k), y_weights = factors.solve(y_row),
                          z_weights = factors.solve(z_row);
    for(Eigen::Index l = 0; l < 4; ++l)
      matrix(k, l) = y_weights.dot(y_rows.col(l)) + z_weights.dot(z_rows.col(l));
    right[k] = y_weights.dot(y) + z_weights.dot(z);
  }
  matrix(0, 0) += 1. / (error_of_frame * error_of_frame);
  const Eigen::VectorXd unknowns = solve_positive_semidefinite(matrix, right);
  const double angle = std::atan2(unknowns[0], unknowns[1]);
  return std::isfinite(angle) ? angle : 0.;
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_INTERNAL_PITCH_OF_FEATURES_H
