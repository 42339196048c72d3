#ifndef SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_ESTIMATORS_H
#define SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_ESTIMATORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/batagelo_wu_curvatures.h>
#include <Shape_characteristics/curvature/goldfeather_interrante_curvatures.h>
#include <Shape_characteristics/curvature/hildebrandt_polthier_curvatures.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>
#include <Shape_characteristics/curvature/kalogerakis_curvatures.h>
#include <Shape_characteristics/curvature/meyer_curvatures.h>
#include <Shape_characteristics/curvature/moving_least_squares_curvatures.h>
#include <Shape_characteristics/curvature/normal_cycle_curvatures.h>
#include <Shape_characteristics/curvature/razdan_bae_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/tangent_space_curvatures.h>
#include <Shape_characteristics/curvature/taubin_curvatures.h>
#include <Shape_characteristics/curvature/theisel_curvatures.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric.h>
#include <Shape_characteristics/interpolation/Inverse_multiquadric_cubic.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/interpolation/Polyharmonic_logarithmic.h>
#include <Shape_characteristics/normals/Normal_weighting.h>
#include <Shape_characteristics/normals/hrbf_normals.h>
#include <Shape_characteristics/normals/vertex_normals.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace accuracy {

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Normal_map = Mesh::Property_map<Vertex, Kernel::Vector_3>;
using Curvature_map = Mesh::Property_map<Vertex, SC::Principal_curvatures_and_directions<Kernel>>;
using Status_map = Mesh::Property_map<Vertex, SC::Estimation_status>;

/// What an estimator gets and where it writes.
struct Task
{
  const Mesh& mesh;
  Normal_map normals;
  bool normals_are_exact;
  Curvature_map curvatures;
  Status_map statuses;

  /// The named parameters that all estimators share.
  auto parameters() const
  {
    return SC::parameters::vertex_normal_map(normals)
        .vertex_principal_curvatures_and_directions_map(curvatures)
        .vertex_status_map(statuses);
  }
};

/// In which table an estimator takes part, and under which name the thesis prints it there (empty: it doesn't).
struct Appearance
{
  std::string table, column;
};

/// How long an estimator takes: the costly ones, minutes for all surfaces of a table, are run on the first seed only,
/// unless all seeds are asked for.
enum class Cost
{
  LOW,
  HIGH
};

struct Estimator
{
  std::string name, neighbourhood;
  std::vector<Appearance> appearances;
  std::function<void(const Task&)> run;
  Cost cost = Cost::LOW;

  std::string label() const { return name + ", " + neighbourhood; }
};

/// In all tables that compare estimators, under the same name.
inline std::vector<Appearance> everywhere(const std::string& column = "")
{
  return {{"8.3", column}, {"8.4", column}, {"8.5", column}, {"8.12", column}};
}

/// In the one with exact normals, and in Table 8.7 if it has a name there.
inline std::vector<Appearance> exact(const std::string& column, const std::string& basis = "")
{
  std::vector<Appearance> result = {{"8.3", column}};
  if(!basis.empty())
    result.push_back({"8.7", basis});
  return result;
}

/// In those with estimated normals, and in Table 8.7 if it has a name there.
inline std::vector<Appearance> estimated(const std::string& column, const std::string& basis = "")
{
  std::vector<Appearance> result = {{"8.4", column}, {"8.5", column}, {"8.12", column}};
  if(!basis.empty())
    result.push_back({"8.7", basis});
  return result;
}

/// In Table 8.7, of basis functions.
inline std::vector<Appearance> bases(const std::string& basis)
{
  return {{"8.7", basis}};
}

template <typename Basis>
std::function<void(const Task&)> hrbf(Basis basis, unsigned int rings)
{
  return [basis, rings](const Task& t)
  {
    SC::hrbf_curvatures(t.mesh,
                        t.parameters().number_of_rings(rings).radial_basis_function(basis).normals_are_exact(
                            t.normals_are_exact));
  };
}

inline std::function<void(const Task&)> hrbf_default(unsigned int rings)
{
  return [rings](const Task& t)
  {
    SC::hrbf_curvatures(t.mesh, t.parameters().number_of_rings(rings).normals_are_exact(t.normals_are_exact));
  };
}

inline std::function<void(const Task&)> jet(unsigned int degree, unsigned int rings)
{
  return [degree, rings](const Task& t)
  { SC::jet_fitting_curvatures(t.mesh, t.parameters().degree_fitting(degree).number_of_rings(rings)); };
}

inline void rusinkiewicz(const Task& t)
{
  SC::rusinkiewicz_curvatures(t.mesh, t.parameters());
}

inline void tangent_space(const Task& t)
{
  SC::tangent_space_curvatures(t.mesh, t.parameters());
}

inline void theisel(const Task& t)
{
  SC::theisel_curvatures(t.mesh, t.parameters());
}

inline void meyer(const Task& t)
{
  SC::meyer_curvatures(t.mesh, t.parameters());
}

inline void taubin(const Task& t)
{
  SC::taubin_curvatures(t.mesh, t.parameters());
}

inline std::function<void(const Task&)> goldfeather_interrante(unsigned int rings)
{
  return [rings](const Task& t)
  { SC::goldfeather_interrante_curvatures(t.mesh, t.parameters().number_of_rings(rings)); };
}

inline std::function<void(const Task&)> normal_cycle(unsigned int rings)
{
  return [rings](const Task& t)
  { SC::normal_cycle_curvatures(t.mesh, t.parameters().number_of_rings(rings)); };
}

inline std::function<void(const Task&)> hildebrandt_polthier(unsigned int rings)
{
  return [rings](const Task& t)
  { SC::hildebrandt_polthier_curvatures(t.mesh, t.parameters().number_of_rings(rings)); };
}

inline void batagelo_wu(const Task& t)
{
  SC::batagelo_wu_curvatures(t.mesh, t.parameters());
}

inline std::function<void(const Task&)> moving_least_squares(unsigned int rings)
{
  return [rings](const Task& t)
  { SC::moving_least_squares_curvatures(t.mesh, t.parameters().number_of_rings(rings)); };
}

inline void razdan_bae(const Task& t)
{
  SC::razdan_bae_curvatures(t.mesh, t.parameters());
}

/// It begins with normals of the mesh's own.
inline std::function<void(const Task&)> kalogerakis(unsigned int rings)
{
  return [rings](const Task& t)
  {
    SC::kalogerakis_curvatures(t.mesh,
                               SC::parameters::vertex_principal_curvatures_and_directions_map(t.curvatures)
                                   .vertex_status_map(t.statuses)
                                   .number_of_rings(rings));
  };
}

/// The estimators that are compared: a new one is a new line here.
///
/// The inverse multiquadric of Table 8.7 is fitted as a positive-definite basis, with a shape parameter that follows the
/// neighborhood's size, not as the thesis did. For the one of the cubed distance the thesis tells no shape
/// parameter; 0.3 (in units of the neighborhood's size) comes near to its figures.
inline const std::vector<Estimator>& estimators()
{
  using IMQ3 = SC::Inverse_multiquadric_cubic;
  static const std::vector<Estimator> list = {
      {"HRBF r^3", "2 rings", estimated("HRBF 2"), hrbf(SC::Polyharmonic<3>(), 2)},
      {"HRBF r^3", "4 rings", estimated("HRBF 4", "r^3"), hrbf(SC::Polyharmonic<3>(), 4), Cost::HIGH},
      {"HRBF r^5", "2 rings", exact("HRBF 2"), hrbf(SC::Polyharmonic<5>(), 2)},
      {"HRBF r^5", "4 rings", bases("r^5"), hrbf(SC::Polyharmonic<5>(), 4), Cost::HIGH},
      {"HRBF r^7", "4 rings", bases("r^7"), hrbf(SC::Polyharmonic<7>(), 4), Cost::HIGH},
      {"HRBF r^9", "4 rings", exact("HRBF 4", "r^9"), hrbf(SC::Polyharmonic<9>(), 4), Cost::HIGH},
      {"HRBF r^4 ln r", "4 rings", bases("r^4 ln r"), hrbf(SC::Polyharmonic_logarithmic<4>(), 4), Cost::HIGH},
      {"HRBF imq(r)", "4 rings", bases("1/sqrt(1+(er)^2)"), hrbf(SC::Inverse_multiquadric(), 4)},
      {"HRBF imq(r^1.5)", "4 rings", bases("1/sqrt(1+(er)^3)"), hrbf(IMQ3(.3), 4), Cost::HIGH},
      {"HRBF default", "2 rings", everywhere(), hrbf_default(2)},
      {"HRBF default", "3 rings", everywhere(), hrbf_default(3)},
      {"Rusinkiewicz", "1 ring", everywhere("Rus"), rusinkiewicz},
      {"tangent space", "1 ring", everywhere(), tangent_space},
      {"Theisel", "1 ring", everywhere(), theisel},
      {"Meyer", "1 ring", everywhere(), meyer},
      {"Taubin", "1 ring", everywhere(), taubin},
      {"Goldfeather-Interrante", "1 ring", everywhere("GI"), goldfeather_interrante(1)},
      {"Goldfeather-Interrante", "2 rings", everywhere("GI"), goldfeather_interrante(2)},
      {"Kalogerakis", "1 ring", everywhere("Kal"), kalogerakis(1)},
      {"Kalogerakis", "2 rings", everywhere("Kal"), kalogerakis(2)},
      {"normal cycle", "2 edges", everywhere(), normal_cycle(2)},
      {"normal cycle", "4 edges", everywhere(), normal_cycle(4), Cost::HIGH},
      {"Batagelo-Wu", "1 ring", everywhere(), batagelo_wu},
      {"moving least squares", "3 rings", everywhere(), moving_least_squares(3)},
      {"Razdan-Bae", "2 rings", everywhere(), razdan_bae},
      {"Hildebrandt-Polthier", "1 edge", everywhere("HP"), hildebrandt_polthier(1)},
      {"Hildebrandt-Polthier", "2 edges", everywhere("HP"), hildebrandt_polthier(2)},
      {"Hildebrandt-Polthier", "3 edges", everywhere("HP"), hildebrandt_polthier(3), Cost::HIGH},
      {"Hildebrandt-Polthier", "4 edges", everywhere("HP"), hildebrandt_polthier(4), Cost::HIGH},
      {"jet d=2", "2 rings", everywhere(), jet(2, 2)},
      {"jet d=2", "4 rings", everywhere(), jet(2, 4)},
      {"jet d=4", "2 rings", everywhere(), jet(4, 2)},
      {"jet d=4", "4 rings", everywhere(), jet(4, 4)}};
  return list;
}

/// An estimator of normals from a mesh alone.
struct Normal_estimator
{
  std::string name, neighbourhood, column;
  std::function<void(const Mesh&, Normal_map)> run;
  Cost cost = Cost::LOW;

  std::string label() const { return name + ", " + neighbourhood; }
};

inline std::function<void(const Mesh&, Normal_map)> weighted(SC::Normal_weighting weighting)
{
  return [weighting](const Mesh& mesh, Normal_map normals)
  { SC::vertex_normals(mesh, normals, SC::parameters::normal_weighting(weighting)); };
}

template <typename Basis>
std::function<void(const Mesh&, Normal_map)> refitted(Basis basis, unsigned int rings)
{
  return [basis, rings](const Mesh& mesh, Normal_map normals)
  { SC::hrbf_normals(mesh, normals, SC::parameters::number_of_rings(rings).radial_basis_function(basis)); };
}

inline void refitted_by_default(const Mesh& mesh, Normal_map normals)
{
  SC::hrbf_normals(mesh, normals, SC::parameters::number_of_rings(2));
}

/// The estimators of normals that are compared in Table 8.14: a new one is a new line here.
inline const std::vector<Normal_estimator>& normal_estimators()
{
  static const std::vector<Normal_estimator> list = {
      {"HRBF r^3", "2 rings", "HRBF 2", refitted(SC::Polyharmonic<3>(), 2)},
      {"HRBF r^3", "4 rings", "HRBF 4", refitted(SC::Polyharmonic<3>(), 4), Cost::HIGH},
      {"HRBF default", "2 rings", "", refitted_by_default},
      {"average", "1 ring", "Avg", weighted(SC::Normal_weighting::AVERAGE)},
      {"area", "1 ring", "", weighted(SC::Normal_weighting::AREA)},
      {"angle", "1 ring", "", weighted(SC::Normal_weighting::ANGLE)},
      {"Max", "1 ring", "Max", weighted(SC::Normal_weighting::MAX)}};
  return list;
}

} // namespace accuracy

#endif // SHAPE_CHARACTERISTICS_BENCHMARK_ACCURACY_ESTIMATORS_H
