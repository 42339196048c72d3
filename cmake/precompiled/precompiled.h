#ifndef SHAPE_CHARACTERISTICS_PRECOMPILED_H
#define SHAPE_CHARACTERISTICS_PRECOMPILED_H

// What most tests, examples and benchmarks include, compiled once, before them. Half of what a compiler makes of each of them is
// the same code of a few templates: those in templates/ are compiled once, too, into a library.

#include "kernel_and_mesh.h"
#include "other_libraries.h"

#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Matern_9_2.h>
#include <Shape_characteristics/interpolation/fit_hermite_rbf.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/normals/vertex_normals.h>

#include <CGAL/Eigen_svd.h>
#include <CGAL/Monge_via_jet_fitting.h>

#include <boost/array.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace precompiled {

using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
template <typename FaceGraph>
using Points_of = typename boost::property_map<FaceGraph, CGAL::vertex_point_t>::const_type;

} // namespace precompiled

// Each list of templates is included by all programs as it is here, and by one source file, which defines it.
#define SHAPE_CHARACTERISTICS_TEMPLATE extern template
#ifdef CGAL_LINKED_WITH_TBB
#define SHAPE_CHARACTERISTICS_FOR_EACH_TAG(TEMPLATES)                                                        \
  TEMPLATES(CGAL::Sequential_tag) TEMPLATES(CGAL::Parallel_tag)
#else
#define SHAPE_CHARACTERISTICS_FOR_EACH_TAG(TEMPLATES) TEMPLATES(CGAL::Sequential_tag)
#endif
#include "templates/hermite_rbf.h"
#include "templates/meshes.h"
#include "templates/other_libraries.h"
#include "templates/samples.h"
#undef SHAPE_CHARACTERISTICS_TEMPLATE

#endif // SHAPE_CHARACTERISTICS_PRECOMPILED_H
