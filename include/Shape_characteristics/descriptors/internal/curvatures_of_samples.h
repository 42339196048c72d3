#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURES_OF_SAMPLES_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURES_OF_SAMPLES_H

#include <Shape_characteristics/characteristics/curvedness.h>
#include <Shape_characteristics/curvature/given_or_estimated_curvatures.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <vector>

namespace Shape_characteristics {
namespace internal {

// curvature measures of all samples of a surface, NaN where they could not be estimated
struct Sample_curvatures
{
  std::vector<double> mean, Gaussian, curvedness;

  explicit Sample_curvatures(const std::vector<Sample_principal_curvatures>& curvatures)
  {
    for(std::vector<double>* v : {&mean, &Gaussian, &curvedness})
      v->reserve(curvatures.size());
    for(const Sample_principal_curvatures& c : curvatures)
    {
      mean.push_back(c.min_curvature / 2. + c.max_curvature / 2.);
      Gaussian.push_back(c.min_curvature * c.max_curvature);
      curvedness.push_back(Shape_characteristics::curvedness(c));
    }
  }
};

// from the map of the named parameters, or estimated from the triangles
template <typename ConcurrencyTag, typename FaceGraph, typename NamedParameters>
Sample_curvatures
curvatures_of_samples(const FaceGraph& mesh, const Face_graph_samples& samples, const NamedParameters& np)
{
  return Sample_curvatures(given_or_estimated_curvatures<ConcurrencyTag>(mesh, samples, np));
}

// from the map of the named parameters, or estimated from the points, each by itself: the order of the points doesn't matter
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
Sample_curvatures
curvatures_of_samples(const PointRange& points, const Point_set_samples& samples, const NamedParameters& np)
{
  return Sample_curvatures(given_or_estimated_curvatures<ConcurrencyTag>(points, samples, np, false));
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_INTERNAL_CURVATURES_OF_SAMPLES_H
