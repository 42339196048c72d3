#ifndef SHAPE_CHARACTERISTICS_TEST_CURVATURE_HRBF_ESTIMATOR_H
#define SHAPE_CHARACTERISTICS_TEST_CURVATURE_HRBF_ESTIMATOR_H

#include <Shape_characteristics/curvature/hrbf_curvatures.h>

#include "estimator_checks.h"

// `hrbf_curvatures()` with some parameters, as `estimator_checks.h` wants it; `Extend` adds them to others.
template <typename Extend>
struct Hrbf
{
  Extend extend;

  template <typename Tag, typename Mesh, typename NamedParameters>
  std::size_t all(const Mesh& mesh, const NamedParameters& np) const
  {
    return Shape_characteristics::hrbf_curvatures<Tag>(mesh, extend(np));
  }

  template <typename Vertex, typename Mesh, typename NamedParameters>
  Shape_characteristics::Estimation_status one(Vertex v, const Mesh& mesh, const NamedParameters& np) const
  {
    return Shape_characteristics::hrbf_curvatures(v, mesh, extend(np));
  }
};

template <typename Extend>
Hrbf(Extend) -> Hrbf<Extend>;

#endif // SHAPE_CHARACTERISTICS_TEST_CURVATURE_HRBF_ESTIMATOR_H
