#include <boost/test/unit_test.hpp>

#ifdef CGAL_USE_OPENMESH
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
// after OpenMesh's own
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#endif

#include "build_mesh.h"
#include "build_openmesh.h"
#include "estimator_checks.h"

#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/integral_invariant_curvatures.h>
#include <Shape_characteristics/curvature/meyer_curvatures.h>
#include <Shape_characteristics/curvature/normal_cycle_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/tangent_space_curvatures.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include <algorithm>
#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(other_meshes)

using namespace estimator_checks;

// Meshes of further types, by one estimator of each way to look at a mesh. (One source for all: such types take the compiler longer
// than an estimator does.)
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

using Linear_cell_complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2,
    3,
    CGAL::Linear_cell_complex_traits<3, Kernel> >::type;
using Exact_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;
using Float_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>;

// whether `mesh`, with the vertices of `s` in the same order, has the curvatures of a `Surface_mesh`, to the last bit
template <typename Mesh>
void check_same_bits(const Mesh& mesh, const Analytic_surface& s)
{
  for(const Normals normals : {Normals::EXACT, Normals::ESTIMATED})
    for(const Method method : {Method::HRBF, Method::INTEGRAL_INVARIANTS, Method::MEYER, Method::NORMAL_CYCLE,
                               Method::RUSINKIEWICZ, Method::TANGENT_SPACE})
      BOOST_TEST_CONTEXT(s.name << ", method " << int(method))
      {
        const Result expected = run(Estimator{method}, s, normals),
                     result = run(Estimator{method}, mesh, s, normals);
        BOOST_TEST(expected.failures < s.points.size());
        BOOST_TEST(same_bits(expected, result));
      }
}

bool is_in_left_part(const test_support::Triangle& t, const Analytic_surface& s)
{
  const auto is_left = [&](const std::size_t i) { return s.points[i].x < .3; };
  return std::all_of(t.begin(), t.end(), is_left);
}

// the triangles in the left part, and their corners
Analytic_surface left_part(const Analytic_surface& s)
{
  Analytic_surface part;
  part.name = s.name;
  constexpr std::size_t none = std::size_t(-1);
  std::vector<std::size_t> numbers(s.points.size(), none);
  for(const auto& t : s.triangles)
    if(is_in_left_part(t, s))
    {
      part.triangles.push_back(t);
      for(const std::size_t i : t)
        numbers[i] = 0;
    }
  for(std::size_t i = 0; i < s.points.size(); ++i)
    if(numbers[i] != none)
    {
      numbers[i] = part.points.size();
      part.points.push_back(s.points[i]);
      part.exact.push_back(s.exact[i]);
    }
  for(auto& t : part.triangles)
    for(std::size_t& i : t)
      i = numbers[i];
  return part;
}

} // namespace

BOOST_AUTO_TEST_CASE(openmesh)
{
#ifdef CGAL_USE_OPENMESH
  for(const Analytic_surface& s : typical_surfaces())
    check_same_bits(test_support::build_openmesh<OpenMesh_mesh>(s), s);
#else
  BOOST_TEST_MESSAGE("  skipped: built without OpenMesh");
#endif
}

BOOST_AUTO_TEST_CASE(linear_cell_complex)
{
  for(const Analytic_surface& s : typical_surfaces())
    check_same_bits(test_support::build_mesh<Linear_cell_complex>(s), s);
}

BOOST_AUTO_TEST_CASE(exact_kernel)
{
  for(const Analytic_surface& s : typical_surfaces())
    check_same_bits(test_support::build_mesh<Exact_mesh>(s), s);
}

// coordinates in single precision: nothing is computed in it
BOOST_AUTO_TEST_CASE(float_kernel)
{
  for(Analytic_surface s : typical_surfaces())
  {
    for(auto& p : s.points)
      p = {double(float(p.x)), double(float(p.y)), double(float(p.z))};
    check_same_bits(test_support::build_mesh<Float_mesh>(s), s);
  }
}

// the border of the part is one to the estimators
BOOST_AUTO_TEST_CASE(part_of_a_mesh)
{
  for(const Analytic_surface& s : typical_surfaces())
  {
    Surface_mesh mesh = surface_mesh_of(s);
    const auto is_in = mesh.add_property_map<Surface_mesh::Face_index, int>("f:is_in", 0).first;
    for(const auto f : mesh.faces())
      is_in[f] = is_in_left_part(s.triangles[f], s);
    const Analytic_surface part = left_part(s);
    BOOST_TEST(part.points.size() < s.points.size());
    check_same_bits(CGAL::Face_filtered_graph<Surface_mesh>(mesh, 1, is_in), part);
  }
}

BOOST_AUTO_TEST_SUITE_END()
