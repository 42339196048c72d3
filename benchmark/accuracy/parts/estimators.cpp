#include "estimators.h"

#include <Shape_characteristics/curvature/adaptive_curvatures.h>
#include <Shape_characteristics/curvature/batagelo_wu_curvatures.h>
#include <Shape_characteristics/curvature/boschiroli_curvatures.h>
#include <Shape_characteristics/curvature/goldfeather_interrante_curvatures.h>
#include <Shape_characteristics/curvature/hildebrandt_polthier_curvatures.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/integral_invariant_curvatures.h>
#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>
#include <Shape_characteristics/curvature/kalogerakis_curvatures.h>
#include <Shape_characteristics/curvature/kalogerakis_normals.h>
#include <Shape_characteristics/curvature/meyer_curvatures.h>
#include <Shape_characteristics/curvature/moving_least_squares_curvatures.h>
#include <Shape_characteristics/curvature/normal_cycle_curvatures.h>
#include <Shape_characteristics/curvature/razdan_bae_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/tangent_space_curvatures.h>
#include <Shape_characteristics/curvature/taubin_curvatures.h>
#include <Shape_characteristics/curvature/theisel_curvatures.h>
#include <Shape_characteristics/curvature/voxel_curvatures.h>
#include <Shape_characteristics/curvature/voxelize.h>
#include <Shape_characteristics/curvature/zhihong_curvatures.h>
#include <Shape_characteristics/interpolation/Exponential_cubic.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric_cubic.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/Polyharmonic_logarithmic.h>
#include <Shape_characteristics/normals/Normal_weighting.h>
#include <Shape_characteristics/normals/hrbf_normals.h>
#include <Shape_characteristics/normals/vertex_normals.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <functional>
#include <string>
#include <vector>

namespace accuracy {

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

std::vector<Appearance> in(const std::vector<std::string>& tables, const std::string& column)
{
  std::vector<Appearance> result;
  for(const std::string& table : tables)
    result.push_back({table, column});
  return result;
}

const std::vector<std::string>& level_set_tables()
{
  static const std::vector<std::string> list = {"8.8", "8.9", "8.10", "8.11", "8.12", "8.13"};
  return list;
}

// In all tables that compare estimators, under the same name.
std::vector<Appearance> everywhere(const std::string& column = "")
{
  std::vector<std::string> tables = {"8.3", "8.4", "8.5", "8.6"};
  tables.insert(tables.end(), level_set_tables().begin(), level_set_tables().end());
  return in(tables, column);
}

// In those of level sets, of which some are closed; the thesis has no figure.
std::vector<Appearance> on_level_sets()
{
  return in(level_set_tables(), "");
}

// The thesis's basis functions, under the same name: odd powers where normals are exact, the exponential of the cubed distance on
// marching cubes, the cubed distance everywhere else; and in Table 8.7 under the basis function's name.
std::vector<Appearance> odd_power(const std::string& column)
{
  return in({"8.3"}, column);
}
std::vector<Appearance> exponential(const std::string& column)
{
  return in({"8.8", "8.9", "8.10", "8.11"}, column);
}
std::vector<Appearance> exact_level_sets(const std::string& column)
{
  return in({"8.8", "8.11"}, column);
}
std::vector<Appearance> cubic(const std::string& column)
{
  return in({"8.4", "8.5", "8.6", "8.12", "8.13"}, column);
}
std::vector<Appearance> and_basis(std::vector<Appearance> appearances, const std::string& basis)
{
  appearances.push_back({"8.7", basis});
  return appearances;
}
std::vector<Appearance> basis(const std::string& name)
{
  return {{"8.7", name}};
}

template <typename Basis>
std::function<void(const Task&)> hrbf(Basis basis_function, unsigned int rings, int polynomial_degree = -1)
{
  return [=](const Task& t)
  {
    SC::hrbf_curvatures(t.mesh, t.parameters()
                                    .number_of_rings(rings)
                                    .radial_basis_function(basis_function)
                                    .polynomial_degree(polynomial_degree)
                                    .normals_are_exact(t.normals_are_exact));
  };
}

std::function<void(const Task&)> hrbf_default(unsigned int rings)
{
  return [rings](const Task& t)
  {
    SC::hrbf_curvatures(t.mesh, t.parameters().number_of_rings(rings).normals_are_exact(t.normals_are_exact));
  };
}

// Normals of level sets may be exact where points aren't: "normals_are_exact" would say it of both.
std::function<void(const Task&)> untold(const std::function<void(const Task&)>& run)
{
  return [run](Task t)
  {
    t.normals_are_exact = false;
    run(t);
  };
}

std::function<void(const Task&)> jet(unsigned int degree, unsigned int rings)
{
  return [degree, rings](const Task& t)
  { SC::jet_fitting_curvatures(t.mesh, t.parameters().degree_fitting(degree).number_of_rings(rings)); };
}

void adaptive(const Task& t)
{
  SC::adaptive_curvatures(t.mesh, t.parameters());
}

void rusinkiewicz(const Task& t)
{
  SC::rusinkiewicz_curvatures(t.mesh, t.parameters());
}

void tangent_space(const Task& t)
{
  SC::tangent_space_curvatures(t.mesh, t.parameters());
}

void theisel(const Task& t)
{
  SC::theisel_curvatures(t.mesh, t.parameters());
}

void zhihong(const Task& t)
{
  SC::zhihong_curvatures(t.mesh, t.parameters());
}

void boschiroli(const Task& t)
{
  SC::boschiroli_curvatures(t.mesh, t.parameters());
}

void meyer(const Task& t)
{
  SC::meyer_curvatures(t.mesh, t.parameters());
}

void taubin(const Task& t)
{
  SC::taubin_curvatures(t.mesh, t.parameters());
}

std::function<void(const Task&)> goldfeather_interrante(unsigned int rings)
{
  return [rings](const Task& t)
  { SC::goldfeather_interrante_curvatures(t.mesh, t.parameters().number_of_rings(rings)); };
}

std::function<void(const Task&)> normal_cycle(unsigned int rings)
{
  return [rings](const Task& t)
  { SC::normal_cycle_curvatures(t.mesh, t.parameters().number_of_rings(rings)); };
}

std::function<void(const Task&)> hildebrandt_polthier(unsigned int rings)
{
  return [rings](const Task& t)
  { SC::hildebrandt_polthier_curvatures(t.mesh, t.parameters().number_of_rings(rings)); };
}

double mean_edge_length(const Mesh& mesh)
{
  double sum = 0.;
  for(const auto e : mesh.edges())
    sum += PMP::edge_length(e, mesh);
  return sum / double(mesh.number_of_edges());
}

// The radius in mean edge lengths of the whole mesh: triangles of marching cubes differ much from vertex to vertex.
std::function<void(const Task&)> hildebrandt_polthier_of_one_radius(double edges)
{
  return [edges](const Task& t)
  {
    SC::hildebrandt_polthier_curvatures(t.mesh,
                                        t.parameters().neighbor_radius(edges * mean_edge_length(t.mesh)));
  };
}

// From voxels as large as the edges are long; only of closed surfaces.
std::function<void(const Task&)> voxels(double edges)
{
  return [edges](const Task& t)
  {
    if(!CGAL::is_closed(t.mesh))
      return;
    const double size = mean_edge_length(t.mesh);
    SC::voxel_curvatures(SC::voxelize(t.mesh, size), vertices(t.mesh),
                         SC::parameters::point_map(t.mesh.points())
                             .normal_map(t.normals)
                             .principal_curvatures_and_directions_map(t.curvatures)
                             .status_map(t.statuses)
                             .neighbor_radius(edges * size));
  };
}

std::function<void(const Task&)> integral_invariant(unsigned int rings)
{
  return [rings](const Task& t)
  { SC::integral_invariant_curvatures(t.mesh, t.parameters().number_of_rings(rings)); };
}

void batagelo_wu(const Task& t)
{
  SC::batagelo_wu_curvatures(t.mesh, t.parameters());
}

std::function<void(const Task&)> moving_least_squares(unsigned int rings)
{
  return [rings](const Task& t)
  { SC::moving_least_squares_curvatures(t.mesh, t.parameters().number_of_rings(rings)); };
}

void razdan_bae(const Task& t)
{
  SC::razdan_bae_curvatures(t.mesh, t.parameters());
}

// It begins with normals of the mesh's own.
std::function<void(const Task&)> kalogerakis(unsigned int rings, unsigned int passes)
{
  return [rings, passes](const Task& t)
  {
    SC::kalogerakis_curvatures(t.mesh,
                               SC::parameters::vertex_principal_curvatures_and_directions_map(t.curvatures)
                                   .vertex_status_map(t.statuses)
                                   .number_of_rings(rings)
                                   .number_of_passes(passes));
  };
}

std::function<void(const Mesh&, Normal_map)> weighted(SC::Normal_weighting weighting)
{
  return [weighting](const Mesh& mesh, Normal_map normals)
  { SC::vertex_normals(mesh, normals, SC::parameters::normal_weighting(weighting)); };
}

template <typename Basis>
std::function<void(const Mesh&, Normal_map)> refitted(Basis basis_function, unsigned int rings)
{
  return [basis_function, rings](const Mesh& mesh, Normal_map normals)
  {
    SC::hrbf_normals(mesh, normals,
                     SC::parameters::number_of_rings(rings).radial_basis_function(basis_function));
  };
}

std::function<void(const Mesh&, Normal_map)> robust(unsigned int rings)
{
  return [rings](const Mesh& mesh, Normal_map normals)
  { SC::kalogerakis_normals(mesh, normals, SC::parameters::number_of_rings(rings)); };
}

void refitted_by_default(const Mesh& mesh, Normal_map normals)
{
  SC::hrbf_normals(mesh, normals, SC::parameters::number_of_rings(2));
}

} // namespace

// A new estimator is a new line here.
//
// "Polynomials" are of the degree that makes the system of the basis function definite.
//
// The inverse multiquadric of Table 8.7 is fitted as a positive-definite basis, with a shape parameter that follows the
// neighborhood's size, not as the thesis did. For the one of the cubed distance the thesis tells no shape
// parameter; 0.3 (in units of the neighborhood's size) comes near to its figures. That of the exponential is a length over a
// cubed length, so that the unit of length decides: with the thesis's unit it is some 1e-3 in that of the neighborhood's size,
// and all that are as small give the same.
const std::vector<Estimator>& estimators()
{
  using IMQ3 = SC::Inverse_multiquadric_cubic;
  constexpr double small = 1e-3;
  static const std::vector<Estimator> list = {
      {"HRBF r^3", "2 rings", cubic("HRBF 2"), hrbf(SC::Polyharmonic<3>(), 2)},
      {"HRBF r^3", "4 rings", and_basis(cubic("HRBF 4"), "r^3"), hrbf(SC::Polyharmonic<3>(), 4), Cost::HIGH},
      {"HRBF r^5", "2 rings", odd_power("HRBF 2"), hrbf(SC::Polyharmonic<5>(), 2)},
      {"HRBF r^5", "4 rings", basis("r^5"), hrbf(SC::Polyharmonic<5>(), 4), Cost::HIGH},
      {"HRBF r^7", "4 rings", basis("r^7"), hrbf(SC::Polyharmonic<7>(), 4), Cost::HIGH},
      {"HRBF r^9", "4 rings", and_basis(odd_power("HRBF 4"), "r^9"), hrbf(SC::Polyharmonic<9>(), 4),
       Cost::HIGH},
      {"HRBF r^5, polynomials", "2 rings", odd_power("HRBF 2"), hrbf(SC::Polyharmonic<5>(), 2, 2)},
      {"HRBF r^5, polynomials", "4 rings", basis("r^5"), hrbf(SC::Polyharmonic<5>(), 4, 2), Cost::HIGH},
      {"HRBF r^7, polynomials", "4 rings", basis("r^7"), hrbf(SC::Polyharmonic<7>(), 4, 3), Cost::HIGH},
      {"HRBF r^9, polynomials", "4 rings", and_basis(odd_power("HRBF 4"), "r^9"),
       hrbf(SC::Polyharmonic<9>(), 4, 4), Cost::HIGH},
      {"HRBF exp(-r^3)", "2 rings", exponential("HRBF 2"), hrbf(SC::Exponential_cubic(small), 2)},
      {"HRBF exp(-r^3)", "4 rings", exponential("HRBF 4"), hrbf(SC::Exponential_cubic(small), 4), Cost::HIGH},
      {"HRBF exp(-r^3), averaged", "2 rings", exact_level_sets("HRBF 2"),
       untold(hrbf(SC::Exponential_cubic(small), 2))},
      {"HRBF exp(-r^3), averaged", "4 rings", exact_level_sets("HRBF 4"),
       untold(hrbf(SC::Exponential_cubic(small), 4)), Cost::HIGH},
      {"HRBF r^4 ln r", "4 rings", basis("r^4 ln r"), hrbf(SC::Polyharmonic_logarithmic<4>(), 4), Cost::HIGH},
      {"HRBF imq(r)", "4 rings", basis("1/sqrt(1+(er)^2)"), hrbf(SC::Inverse_multiquadric(), 4)},
      {"HRBF imq(r^1.5)", "4 rings", basis("1/sqrt(1+(er)^3)"), hrbf(IMQ3(.3), 4), Cost::HIGH},
      {"HRBF default", "2 rings", everywhere(), hrbf_default(2)},
      {"HRBF default", "3 rings", everywhere(), hrbf_default(3)},
      {"HRBF default, exactness untold", "2 rings", exact_level_sets(""), untold(hrbf_default(2))},
      {"HRBF default, exactness untold", "3 rings", exact_level_sets(""), untold(hrbf_default(3))},
      {"adaptive", "2 to 4 rings", everywhere(), adaptive, Cost::HIGH},
      {"Rusinkiewicz", "1 ring", everywhere("Rus"), rusinkiewicz},
      {"tangent space", "1 ring", everywhere(), tangent_space},
      {"Theisel", "1 ring", everywhere(), theisel},
      {"Zhihong", "1 ring", everywhere(), zhihong},
      {"Boschiroli", "1 ring", everywhere(), boschiroli},
      {"Meyer", "1 ring", everywhere(), meyer},
      {"Taubin", "1 ring", everywhere(), taubin},
      {"Goldfeather-Interrante", "1 ring", everywhere("GI"), goldfeather_interrante(1)},
      {"Goldfeather-Interrante", "2 rings", everywhere("GI"), goldfeather_interrante(2)},
      {"Kalogerakis, no pass", "1 ring", everywhere("Kal"), kalogerakis(1, 0)},
      {"Kalogerakis, no pass", "2 rings", everywhere("Kal"), kalogerakis(2, 0)},
      {"Kalogerakis, one pass", "1 ring", everywhere("Kal"), kalogerakis(1, 1)},
      {"Kalogerakis, one pass", "2 rings", everywhere("Kal"), kalogerakis(2, 1)},
      {"Kalogerakis", "1 ring", everywhere("Kal"), kalogerakis(1, 2)},
      {"Kalogerakis", "2 rings", everywhere("Kal"), kalogerakis(2, 2)},
      {"normal cycle", "2 edges", everywhere(), normal_cycle(2)},
      {"normal cycle", "4 edges", everywhere(), normal_cycle(4), Cost::HIGH},
      {"Batagelo-Wu", "1 ring", everywhere(), batagelo_wu},
      {"moving least squares", "3 rings", everywhere(), moving_least_squares(3)},
      {"Razdan-Bae", "2 rings", everywhere(), razdan_bae},
      {"Hildebrandt-Polthier", "1 edge", everywhere("HP"), hildebrandt_polthier(1)},
      {"Hildebrandt-Polthier", "2 edges", everywhere("HP"), hildebrandt_polthier(2)},
      {"Hildebrandt-Polthier", "3 edges", everywhere("HP"), hildebrandt_polthier(3)},
      {"Hildebrandt-Polthier", "4 edges", everywhere("HP"), hildebrandt_polthier(4), Cost::HIGH},
      {"Hildebrandt-Polthier, one radius", "2 edges", everywhere("HP"),
       hildebrandt_polthier_of_one_radius(2.)},
      {"Hildebrandt-Polthier, one radius", "2.5 edges", everywhere("HP"),
       hildebrandt_polthier_of_one_radius(2.5)},
      {"integral invariants", "2 edges", everywhere(), integral_invariant(2)},
      {"integral invariants", "4 edges", everywhere(), integral_invariant(4), Cost::HIGH},
      {"integral invariants of voxels", "3 edges", on_level_sets(), voxels(3.)},
      {"integral invariants of voxels", "4 edges", on_level_sets(), voxels(4.)},
      {"jet d=2", "2 rings", everywhere(), jet(2, 2)},
      {"jet d=2", "4 rings", everywhere(), jet(2, 4)},
      {"jet d=4", "2 rings", everywhere(), jet(4, 2)},
      {"jet d=4", "4 rings", everywhere(), jet(4, 4)}};
  return list;
}

const std::vector<Normal_estimator>& normal_estimators()
{
  static const std::vector<Normal_estimator> list = {
      {"HRBF r^3", "2 rings", "HRBF 2", refitted(SC::Polyharmonic<3>(), 2)},
      {"HRBF r^3", "4 rings", "HRBF 4", refitted(SC::Polyharmonic<3>(), 4), Cost::HIGH},
      {"HRBF default", "2 rings", "", refitted_by_default},
      {"Kalogerakis", "1 ring", "Kal", robust(1)},
      {"Kalogerakis", "2 rings", "Kal", robust(2)},
      {"average", "1 ring", "Avg", weighted(SC::Normal_weighting::AVERAGE)},
      {"area", "1 ring", "", weighted(SC::Normal_weighting::AREA)},
      {"angle", "1 ring", "", weighted(SC::Normal_weighting::ANGLE)},
      {"Max", "1 ring", "Max", weighted(SC::Normal_weighting::MAX)}};
  return list;
}

} // namespace accuracy
