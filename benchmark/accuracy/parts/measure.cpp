#include "measure.h"

#include <chrono>
#include <cmath>
#include <limits>

namespace accuracy {

namespace {

constexpr double not_estimated = std::numeric_limits<double>::quiet_NaN();

} // namespace

void Errors::add(const Errors& other)
{
  all.add(other.all);
  inner.add(other.inner);
  gaussian_all.add(other.gaussian_all);
  gaussian_inner.add(other.gaussian_inner);
  seconds += other.seconds;
}

Errors measure(const Estimator& estimator, Sample& sample, Normal_map normals, bool normals_are_exact)
{
  Curvature_map curvatures =
      sample.mesh.add_property_map<Vertex, SC::Principal_curvatures_and_directions<Kernel>>("v:curvatures")
          .first;
  Status_map statuses = sample.mesh.add_property_map<Vertex, SC::Estimation_status>("v:statuses").first;
  for(Vertex v :
      vertices(sample.mesh)) // what an estimator leaves alone must not count as the last one's result
  {
    curvatures[v].min_curvature = curvatures[v].max_curvature = not_estimated;
    statuses[v] = SC::Estimation_status::UNREFERENCED;
  }

  Errors errors;
  const auto start = std::chrono::steady_clock::now();
  estimator.run({sample.mesh, normals, normals_are_exact, curvatures, statuses});
  errors.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  for(Vertex v : vertices(sample.mesh))
  {
    const bool estimated = SC::is_estimated(statuses[v]);
    const double k_max = estimated ? curvatures[v].max_curvature : not_estimated;
    const double k_min = estimated ? curvatures[v].min_curvature : not_estimated;
    const double of_max = k_max - sample.exact[v].k_max, of_min = k_min - sample.exact[v].k_min;
    const double of_product = k_max * k_min - sample.exact[v].gaussian();
    errors.all.add(of_max, of_min);
    errors.gaussian_all.add(of_product, 0.);
    if(sample.inner[v])
    {
      errors.inner.add(of_max, of_min);
      errors.gaussian_inner.add(of_product, 0.);
    }
  }
  return errors;
}

Normal_map measure(const Normal_estimator& estimator, Sample& sample, Normal_errors& errors)
{
  Normal_map normals = sample.mesh.add_property_map<Vertex, Kernel::Vector_3>("v:estimated_normals").first;
  for(Vertex v : vertices(sample.mesh))
    normals[v] = Kernel::Vector_3(not_estimated, not_estimated, not_estimated);
  estimator.run(sample.mesh, normals);
  for(Vertex v : vertices(sample.mesh))
  {
    using benchmark_support::Vector;
    const Vector& n = sample.exact[v].normal;
    const Vector d = n - Vector{normals[v].x(), normals[v].y(), normals[v].z()};
    const double error = .5 * dot(d, d); // 1 - cosine of unit vectors, without cancellation
    ++errors.all;
    if(!std::isfinite(error))
    {
      ++errors.flagged;
      continue;
    }
    errors.sum_all += error;
    if(sample.inner[v])
    {
      ++errors.inner;
      errors.sum_inner += error;
    }
  }
  return normals;
}

} // namespace accuracy
