#ifndef SHAPE_CHARACTERISTICS_PRECOMPILED_OTHER_LIBRARIES_H
#define SHAPE_CHARACTERISTICS_PRECOMPILED_OTHER_LIBRARIES_H

// Headers of other libraries that most tests, examples and benchmarks include, and what of them is compiled once.

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/for_each.h>
#include <CGAL/property_map.h>

#include <Eigen/Dense>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/scalable_allocator.h>
#endif

#include <functional>
#include <mutex>
#include <string>
#include <unordered_map>

#include "expressions.h"

#define SHAPE_CHARACTERISTICS_TEMPLATE extern template
#include "templates/decompositions.h"
#undef SHAPE_CHARACTERISTICS_TEMPLATE

#endif // SHAPE_CHARACTERISTICS_PRECOMPILED_OTHER_LIBRARIES_H
