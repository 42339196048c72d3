#ifndef SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FIT_TO_NEIGHBORS_H
#define SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FIT_TO_NEIGHBORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/has_no_curvature.h>
#include <Shape_characteristics/internal/status_of_few_neighbors.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// The root mean square distance of the neighbors of sample `i`, whatever their unit. Zero or not finite where there is no
// neighborhood that could be scaled by it.
template <typename SampledSurface>
double size_of_neighborhood(const SampledSurface& surface,
                            std::size_t i,
                            const std::vector<typename SampledSurface::Index>& neighbors)
{
  const Eigen::Vector3d& p = surface.point(i);
  double largest = 0.;
  for(const auto j : neighbors)
    largest = (std::max)(largest, (surface.point(j) - p).cwiseAbs().maxCoeff());
  // Squares of lengths may be out of the range of numbers.
  double sum = 0.;
  for(const auto j : neighbors)
    sum += ((surface.point(j) - p) / largest).squaredNorm();
  return largest * std::sqrt(sum / double(neighbors.size()));
}

// The estimate `fit(neighbors)` at sample `i`, from at least `minimum` neighbors. Points on a few lines, as at the border of a
// regular grid, can be too few however many they are: where the fit is degenerate, the neighborhood is enlarged as far as
// it can be.
template <typename SampledSurface, typename Fit>
Curvature_estimate fit_to_neighbors(const SampledSurface& surface,
                                    std::size_t i,
                                    std::size_t minimum,
                                    typename SampledSurface::Workspace& workspace,
                                    const Fit& fit)
{
  const Estimation_status status = surface.status(i);
  if(!is_estimated(status))
    return Curvature_estimate(status);

  Curvature_estimate estimate(Estimation_status::FEW_NEIGHBOURS);
  for(;;)
  {
    const std::vector<typename SampledSurface::Index>& neighbors = surface.neighbors(i, minimum, workspace);
    if(neighbors.size() < minimum)
    {
      if(estimate.status == Estimation_status::FEW_NEIGHBOURS)
        estimate.status = status_of_few_neighbors(surface, i, neighbors.size());
      return estimate;
    }
    if(has_no_curvature(surface, i, neighbors))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    estimate = fit(neighbors);
    if(estimate.status != Estimation_status::DEGENERATE)
      return estimate;
    minimum = neighbors.size() + 1;
  }
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_INTERNAL_FIT_TO_NEIGHBORS_H
