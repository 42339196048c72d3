#include "factorizations.h"

#include "Random.h"

#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch_functions.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <memory>

namespace speed {
namespace {

namespace SC = Shape_characteristics;

// any positive definite matrix will do: what is counted depends on its size alone
Eigen::MatrixXd positive_definite_matrix(std::size_t equations)
{
  benchmark_support::Random random(equations);
  const auto n = Eigen::Index(equations);
  Eigen::MatrixXd a(n, n);
  for(Eigen::Index j = 0; j < n; ++j)
    for(Eigen::Index i = 0; i < n; ++i)
      a(i, j) = random.uniform(-1., 1.);
  Eigen::MatrixXd result = a * a.transpose();
  result.diagonal().array() += double(equations);
  return result;
}

// one system after the other: the plain path, and what the batches are to be compared with
Factorization eigen_cholesky(std::size_t equations)
{
  struct Systems
  {
    Eigen::MatrixXd matrix, factor;
  };
  const auto systems = std::make_shared<Systems>();
  systems->matrix = positive_definite_matrix(equations);
  return {"Eigen::LLT", equations, operations_of_cholesky(equations),
          [systems]
          {
            systems->factor = systems->matrix;
            Eigen::Ref<Eigen::MatrixXd> in_place(systems->factor);
            const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>, Eigen::Lower> cholesky(in_place);
            return cholesky.info() == Eigen::Success;
          }};
}

// points and normals of a paraboloid around the origin, as large as neighbourhoods are in units of the basis function
void fill(SC::internal::Hermite_batch& batch)
{
  benchmark_support::Random random(batch.centers());
  const auto set = [&](double* array, std::size_t first, std::size_t lane, const Eigen::Vector3d& v)
  {
    for(std::size_t c = 0; c < 3; ++c)
      batch.set(array, first + c, lane, v[Eigen::Index(c)]);
  };
  for(std::size_t lane = 0; lane < batch.lanes(); ++lane)
  {
    for(std::size_t i = 0; i < batch.centers(); ++i)
    {
      const double x = i == 0 ? 0. : random.uniform(-.4, .4), y = i == 0 ? 0. : random.uniform(-.4, .4);
      const Eigen::Vector3d normal = Eigen::Vector3d(-x, -y, 1.).normalized();
      const Eigen::Vector3d tangent = normal.cross(Eigen::Vector3d::UnitY()).normalized();
      set(batch.points, 3 * i, lane, Eigen::Vector3d(x, y, .5 * (x * x + y * y)));
      set(batch.directions, 6 * i, lane, tangent);
      set(batch.directions, 6 * i + 3, lane, normal.cross(tangent));
    }
    set(batch.trend, 0, lane, Eigen::Vector3d::UnitZ());
    batch.set(batch.count, 0, lane, double(batch.centers()));
    batch.set(batch.value_noise, 0, lane, 1e-12);
    batch.set(batch.derivative_noise, 0, lane, 1e-12);
  }
}

// Several systems side by side, as the estimators solve them. What assembles them is within the time, but its operations
// aren't counted: the factorization alone is a little faster than this.
Factorization batch(std::size_t lanes, std::size_t centers)
{
  using Functions = SC::internal::Hermite_batch_functions<SC::Inverse_multiquadric>;
  const auto systems = std::make_shared<SC::internal::Hermite_batch>();
  systems->clear(lanes, centers, SC::internal::Hermite_equations::TANGENTS);
  fill(*systems);
  const std::size_t equations = systems->number_of_equations;
  return {std::to_string(lanes) + " systems side by side, with their assembly", equations,
          double(lanes) * (operations_of_cholesky(equations) + 2. * double(equations) * double(equations)),
          [systems, functions = Functions::best(lanes)]
          {
            functions.solve(*systems, SC::Inverse_multiquadric(1.));
            const auto& solved = systems->is_positive_definite;
            return std::all_of(solved.begin(), solved.begin() + std::ptrdiff_t(systems->lanes()),
                               [](double x) { return x == 1.; });
          }};
}

} // namespace

double operations_of_cholesky(std::size_t equations)
{
  const double n = double(equations);
  return n * (n + 1.) * (2. * n + 1.) / 6.; // half of them multiplications; roots and quotients count as one
}

std::vector<Factorization> factorizations()
{
  std::vector<Factorization> list;
  for(const std::size_t centers : {7, 19, 37, 61})
  {
    list.push_back(eigen_cholesky(3 * centers + 1));
    for(const std::size_t lanes : {2, 4, 8})
      if(SC::internal::Hermite_batch_functions<SC::Inverse_multiquadric>::best(lanes).lanes == lanes)
        list.push_back(batch(lanes, centers));
  }
  return list;
}

} // namespace speed
