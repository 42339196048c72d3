#include <boost/test/unit_test.hpp>

#ifdef CGAL_USE_OPENMESH
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
// after OpenMesh's own
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#endif

#include "build_openmesh.h"
#include "estimator_checks.h"

#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/integral_invariant_curvatures.h>
#include <Shape_characteristics/curvature/meyer_curvatures.h>
#include <Shape_characteristics/curvature/normal_cycle_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/tangent_space_curvatures.h>

#include <cstddef>

BOOST_AUTO_TEST_SUITE(openmesh)

using namespace estimator_checks;

// A mesh that isn't CGAL's: one estimator of each way to look at a mesh. (One test for all: OpenMesh takes the compiler
// longer than an estimator does.)
namespace {

enum class Method
{
  HRBF,                // neighbors
  INTEGRAL_INVARIANTS, // a ball's surface
  MEYER,               // one ring
  NORMAL_CYCLE,        // triangles within a ball
  RUSINKIEWICZ,        // triangles, then vertices
  TANGENT_SPACE        // edges
};

struct Estimator
{
  Method method;

  template <typename Tag, typename Mesh, typename Np>
  std::size_t all(const Mesh& mesh, const Np& np) const
  {
    switch(method)
    {
    case Method::HRBF:
      return SC::hrbf_curvatures<Tag>(mesh, np);
    case Method::INTEGRAL_INVARIANTS:
      return SC::integral_invariant_curvatures<Tag>(mesh, np);
    case Method::MEYER:
      return SC::meyer_curvatures<Tag>(mesh, np);
    case Method::NORMAL_CYCLE:
      return SC::normal_cycle_curvatures<Tag>(mesh, np);
    case Method::RUSINKIEWICZ:
      return SC::rusinkiewicz_curvatures<Tag>(mesh, np);
    default:
      return SC::tangent_space_curvatures<Tag>(mesh, np);
    }
  }
};

#ifdef CGAL_USE_OPENMESH
struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using OpenMesh_mesh = OpenMesh::PolyMesh_ArrayKernelT<Double_traits>;
#endif

} // namespace

BOOST_AUTO_TEST_CASE(equals_a_surface_mesh_to_the_last_bit)
{
#ifdef CGAL_USE_OPENMESH
  for(const Analytic_surface& s : typical_surfaces())
    for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
      for(const Method method : {Method::HRBF, Method::INTEGRAL_INVARIANTS, Method::MEYER,
                                 Method::NORMAL_CYCLE, Method::RUSINKIEWICZ, Method::TANGENT_SPACE})
        BOOST_TEST_CONTEXT(s.name << ", method " << int(method))
        {
          const Result expected = run(Estimator{method}, s, normals),
                       result =
                           run(Estimator{method}, test_support::build_openmesh<OpenMesh_mesh>(s), s, normals);
          BOOST_TEST(expected.failures < s.points.size());
          BOOST_TEST(same_bits(expected, result));
        }
#else
  BOOST_TEST_MESSAGE("  skipped: built without OpenMesh");
#endif
}

BOOST_AUTO_TEST_SUITE_END()
