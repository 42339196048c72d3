#include "factorizations.h"

#include "Random.h"

#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch.h>
#include <Shape_characteristics/interpolation/internal/Hermite_batch_functions.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>

namespace speed {
namespace {

namespace SC = Shape_characteristics;
using SC::internal::Hermite_equations;

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

// of Cholesky's method, n^3 / 3 and what is below, and of the substitutions, of which the second is that of one right side; roots and
// quotients count as one
double operations_of_solution(std::size_t equations, std::size_t right_sides)
{
  const double n = double(equations);
  return n * (n + 1.) * (2. * n + 1.) / 6. + double(right_sides + 1) * n * n;
}

std::size_t times(double enough_operations, double operations)
{
  return std::size_t(std::ceil(enough_operations / operations));
}

// one system after the other: the plain path, and what the batches are to be compared with
Factorization eigen_cholesky(std::size_t equations, double enough_operations)
{
  struct Systems
  {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd data;
    std::vector<Eigen::MatrixXd> factors;
    std::vector<Eigen::VectorXd> solutions;
  };
  const auto systems = std::make_shared<Systems>();
  systems->matrix = positive_definite_matrix(equations);
  systems->data = Eigen::VectorXd::Ones(Eigen::Index(equations));
  const double operations = operations_of_solution(equations, 1);
  const std::size_t number = times(enough_operations, operations);
  return {"Eigen::LLT", equations, double(number) * operations,
          [systems, number]
          {
            systems->factors.assign(number, systems->matrix);
            systems->solutions.assign(number, systems->data);
          },
          [systems, number]
          {
            bool all = true;
            for(std::size_t k = 0; k < number; ++k)
            {
              Eigen::Ref<Eigen::MatrixXd> in_place(systems->factors[k]);
              const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>, Eigen::Lower> cholesky(in_place);
              cholesky.solveInPlace(systems->solutions[k]);
              all = all && cholesky.info() == Eigen::Success;
            }
            return all;
          }};
}

std::size_t number_of_equations(std::size_t centers, Hermite_equations kind)
{
  SC::internal::Hermite_batch batch;
  batch.clear(1, centers, kind);
  return batch.number_of_equations;
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
      set(batch.points, 3 * i, lane, Eigen::Vector3d(x, y, .5 * (x * x + y * y)));
      set(batch.normals, 3 * i, lane, normal);
    }
    set(batch.trend, 0, lane, Eigen::Vector3d::UnitZ());
    batch.set(batch.count, 0, lane, double(batch.centers()));
    batch.set(batch.unit, 0, lane, .2);
    const bool normals_are_exact = batch.equations() == Hermite_equations::TANGENTS;
    batch.set(batch.value_noise, 0, lane, normals_are_exact ? 1e-12 : 1e-4);
    batch.set(batch.derivative_noise, 0, lane, normals_are_exact ? 1e-12 : .1);
  }
}

// Several systems side by side, as the estimators solve them. What assembles them is timed, too, or isn't; its operations
// aren't counted.
Factorization batch(std::size_t lanes,
                    std::size_t centers,
                    Hermite_equations kind,
                    bool with_assembly,
                    double enough_operations)
{
  using Functions = SC::internal::Hermite_batch_functions<SC::Inverse_multiquadric>;
  const std::size_t equations = number_of_equations(centers, kind);
  const double operations =
      double(lanes) * operations_of_solution(equations, kind == Hermite_equations::TANGENTS ? 1 : 4);
  const std::size_t number = times(enough_operations, operations);
  const auto batches = std::make_shared<std::vector<SC::internal::Hermite_batch>>(number);
  for(SC::internal::Hermite_batch& b : *batches)
  {
    b.clear(lanes, centers, kind);
    fill(b);
  }
  const auto functions = Functions::best(lanes);
  const auto assemble = [functions](SC::internal::Hermite_batch& b)
  { functions.assemble(b, SC::Inverse_multiquadric(1.)); };
  return {std::to_string(lanes) + " systems side by side" + (with_assembly ? ", with their assembly" : ""),
          equations, double(number) * operations,
          [batches, assemble] { std::for_each(batches->begin(), batches->end(), assemble); },
          [batches, assemble, with_assembly, functions]
          {
            bool all = true;
            for(SC::internal::Hermite_batch& b : *batches)
            {
              if(with_assembly)
                assemble(b);
              functions.solve(b);
              const auto& solved = b.is_positive_definite;
              all = all && std::all_of(solved.begin(), solved.begin() + std::ptrdiff_t(b.lanes()),
                                       [](double x) { return x == 1.; });
            }
            return all;
          }};
}

} // namespace

std::vector<Factorization> factorizations(double enough_operations)
{
  std::vector<Factorization> list;
  const auto add = [&](const std::size_t centers, const Hermite_equations kind)
  {
    list.push_back(eigen_cholesky(number_of_equations(centers, kind), enough_operations));
    for(const std::size_t lanes : {2, 4, 8})
      if(SC::internal::Hermite_batch_functions<SC::Inverse_multiquadric>::best(lanes).lanes == lanes)
        for(const bool with_assembly : {true, false})
          list.push_back(batch(lanes, centers, kind, with_assembly, enough_operations));
  };
  for(const std::size_t centers : {7, 19, 37, 61})
    add(centers, Hermite_equations::TANGENTS);
  for(const std::size_t centers : {61, 121})
    add(centers, Hermite_equations::GRADIENTS);
  return list;
}

} // namespace speed
