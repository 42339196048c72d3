#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

BOOST_AUTO_TEST_SUITE(named_parameters)

namespace SC = Shape_characteristics;
namespace snp = SC::internal_np;
namespace sp = SC::parameters;
namespace cp = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

struct Basis
{
  int id = 0;
};

struct Non_copyable
{
  int value = 7;
  Non_copyable() = default;
  Non_copyable(const Non_copyable&) = delete;
};

// functions of the library's kind
template <typename NamedParameters = sp::Default_named_parameters>
int rings(const NamedParameters& np = sp::default_values())
{
  const int n = sp::choose_parameter(sp::get_parameter(np, snp::number_of_rings), 1);
  return n;
}

template <typename NamedParameters = sp::Default_named_parameters>
int basis(const NamedParameters& np = sp::default_values())
{
  const auto b = sp::choose_parameter(sp::get_parameter(np, snp::radial_basis_function), Basis{1});
  return b.id;
}

Mesh triangle()
{
  Mesh mesh;
  const auto a = mesh.add_vertex(Kernel::Point_3(0, 0, 0)), b = mesh.add_vertex(Kernel::Point_3(1, 0, 0)),
             c = mesh.add_vertex(Kernel::Point_3(0, 1, 0));
  mesh.add_face(a, b, c);
  return mesh;
}

} // namespace

BOOST_AUTO_TEST_CASE(defaults)
{
  BOOST_TEST(rings() == 1);
  BOOST_TEST(basis() == 1);
  BOOST_TEST(rings(sp::default_values()) == 1);
  BOOST_TEST(rings(cp::default_values()) == 1);
}

// Ours and CGAL's chain in both orders.
BOOST_AUTO_TEST_CASE(chains)
{
  const Mesh mesh = triangle();
  const auto points = mesh.points();

  BOOST_TEST(rings(sp::number_of_rings(2).vertex_point_map(points).radial_basis_function(Basis{3})) == 2);
  BOOST_TEST(basis(sp::number_of_rings(2).vertex_point_map(points).radial_basis_function(Basis{3})) == 3);
  BOOST_TEST(rings(sp::vertex_point_map(points).number_of_rings(4).geom_traits(Kernel())) == 4);
  BOOST_TEST(rings(cp::vertex_point_map(points)) == 1);
  BOOST_TEST(rings(sp::extend(cp::vertex_point_map(points)).number_of_rings(5)) == 5);
  BOOST_TEST(rings(sp::extend(cp::verbose(true).geom_traits(Kernel())).number_of_rings(5).random_seed(1u)) ==
             5);
  BOOST_TEST(rings(sp::number_of_rings(6).number_of_iterations(9)) == 6); // one that our list doesn't have
  BOOST_TEST(cp::get_parameter(sp::number_of_rings(6).number_of_iterations(9),
                               CGAL::internal_np::number_of_iterations) == 9);
  BOOST_TEST(rings(sp::number_of_rings(1).verbose(true).number_of_rings(8)) == 8); // the last one wins
  BOOST_TEST(cp::get_parameter(sp::number_of_rings(2).ball_radius(.5), snp::ball_radius) == .5);
}

BOOST_AUTO_TEST_CASE(traits_of_CGAL_see_our_packs)
{
  const Mesh mesh = triangle();
  const auto points = mesh.points();
  using Pack = decltype(sp::number_of_rings(2).vertex_point_map(points).radial_basis_function(Basis{3}));
  static_assert(!cp::is_default_parameter<Pack, snp::number_of_rings_t>::value);
  static_assert(!cp::is_default_parameter<Pack, CGAL::internal_np::vertex_point_t>::value);
  static_assert(cp::is_default_parameter<Pack, CGAL::internal_np::geom_traits_t>::value);
  static_assert(
      cp::is_default_parameter<decltype(cp::vertex_point_map(points)), snp::number_of_rings_t>::value);
  static_assert(std::is_same_v<CGAL::GetGeomTraits<Mesh, Pack>::type, Kernel>);
  static_assert(std::is_same_v<std::decay_t<CGAL::GetVertexPointMap<Mesh, Pack>::const_type>,
                               std::remove_const_t<decltype(points)>>);

  using Rings_and_points = decltype(sp::number_of_rings(2).vertex_point_map(points));
  static_assert(snp::uses_only<Rings_and_points, snp::number_of_rings_t, CGAL::internal_np::vertex_point_t>);
  static_assert(!snp::uses_only<Rings_and_points, CGAL::internal_np::vertex_point_t>);
  static_assert(snp::uses_only<sp::Default_named_parameters, snp::number_of_rings_t>);
  static_assert(snp::uses_only<decltype(sp::extend(cp::vertex_point_map(points)).number_of_rings(1)),
                               snp::number_of_rings_t, CGAL::internal_np::vertex_point_t>);
  BOOST_TEST(true);
}

// Functions of CGAL take our packs, and chain more of their own to them.
BOOST_AUTO_TEST_CASE(functions_of_CGAL)
{
  Mesh mesh = triangle();
  const auto np = sp::number_of_rings(2).vertex_point_map(mesh.points()).geom_traits(Kernel());
  BOOST_TEST((CGAL::Polygon_mesh_processing::compute_face_normal(*mesh.faces().begin(), mesh, np) ==
              Kernel::Vector_3(0, 0, 1)));
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:n").first;
  CGAL::Polygon_mesh_processing::compute_vertex_normals(mesh, normals, np);
  for(const auto v : mesh.vertices())
    BOOST_TEST((normals[v] == Kernel::Vector_3(0, 0, 1)));
}

BOOST_AUTO_TEST_CASE(references)
{
  Non_copyable object;
  int n = 3;
  const auto np = sp::radial_basis_function(std::ref(object)).number_of_rings(std::ref(n));
  BOOST_TEST(&cp::get_parameter_reference(np, snp::radial_basis_function) == &object);
  cp::get_parameter_reference(np, snp::number_of_rings) = 10;
  BOOST_TEST(n == 10);
  BOOST_TEST(rings(np) == 10);
}

BOOST_AUTO_TEST_CASE(neighborhoods)
{
  using SC::internal::number_of_neighborhoods;
  static_assert(number_of_neighborhoods<sp::Default_named_parameters> == 0);
  static_assert(number_of_neighborhoods<decltype(sp::number_of_rings(1).verbose(true))> == 1);
  static_assert(number_of_neighborhoods<decltype(sp::number_of_rings(1).neighbor_radius(1.))> == 2);
  static_assert(number_of_neighborhoods<decltype(cp::neighbor_radius(1.))> == 1);
  BOOST_TEST(SC::internal::mesh_neighborhood(cp::neighbor_radius(.25)).radius() == .25);
  BOOST_TEST(SC::internal::point_set_neighborhood(cp::neighbor_radius(.25)).radius() == .25);
}

// Counts may be given as numbers of any type. Those that aren't whole, or aren't numbers, are refused by name.
BOOST_AUTO_TEST_CASE(whole_numbers)
{
  using SC::internal::whole_number;
  const auto message_of = [](const auto& call)
  {
    try
    {
      call();
    }
    catch(const std::invalid_argument& e)
    {
      return std::string(e.what());
    }
    return std::string();
  };
  const auto passes = [](const auto& np)
  { return whole_number(np, snp::number_of_passes, std::int64_t(5), "number_of_passes"); };
  BOOST_TEST(passes(sp::default_values()) == 5);
  BOOST_TEST(passes(sp::number_of_passes(2u)) == 2);
  BOOST_TEST(passes(sp::number_of_passes(-2)) == -2);
  BOOST_TEST(passes(sp::number_of_passes(2.)) == 2);
  BOOST_TEST(passes(sp::number_of_passes(-2.f)) == -2);
  BOOST_TEST(passes(sp::number_of_passes(-0x1p63)) == (std::numeric_limits<std::int64_t>::min)());
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double count : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1.5, -1e-300})
  {
    BOOST_TEST(message_of([&] { passes(sp::number_of_passes(count)); }) ==
               "Shape_characteristics: number_of_passes must be a whole number");
    BOOST_TEST(!message_of([&] { passes(sp::number_of_passes(static_cast<long double>(count))); }).empty());
  }
  for(const double count : {0x1p63, 1e300, -1e300})
    BOOST_TEST(message_of([&] { passes(sp::number_of_passes(count)); }) ==
               "Shape_characteristics: number_of_passes is out of range");

  const auto seed = [](const auto& np)
  { return whole_number(np, snp::random_seed, std::uint64_t(0), "random_seed"); };
  const std::uint64_t largest = (std::numeric_limits<std::uint64_t>::max)();
  BOOST_TEST(seed(sp::random_seed(largest)) == largest);
  BOOST_TEST(seed(sp::random_seed(-1)) == largest);
  BOOST_TEST(seed(sp::random_seed(0x1p63)) == std::uint64_t(1) << 63);
  for(const double count : {-1., 0x1p64})
    BOOST_CHECK_THROW(seed(sp::random_seed(count)), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
