#include "estimate.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/batagelo_wu_curvatures.h>
#include <Shape_characteristics/curvature/goldfeather_interrante_curvatures.h>
#include <Shape_characteristics/curvature/hildebrandt_polthier_curvatures.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>
#include <Shape_characteristics/curvature/kalogerakis_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>

namespace adaptive {

namespace SC = Shape_characteristics;

namespace {

// what all of them are told
auto parameters_of(const Estimates& e, Normal_map normals)
{
  return SC::parameters::vertex_normal_map(normals)
      .vertex_principal_curvatures_and_directions_map(e.curvatures)
      .vertex_status_map(e.statuses);
}

template <unsigned int rings>
Estimates hrbf_exact(Mesh& mesh, Normal_map normals)
{
  Estimates e = make_estimates(mesh);
  SC::hrbf_curvatures(mesh, parameters_of(e, normals).normals_are_exact(true).number_of_rings(rings));
  return e;
}

template <unsigned int rings>
Estimates hrbf_inexact(Mesh& mesh, Normal_map normals)
{
  Estimates e = make_estimates(mesh);
  SC::hrbf_curvatures(mesh, parameters_of(e, normals).number_of_rings(rings));
  return e;
}

template <unsigned int degree, unsigned int rings>
Estimates jet(Mesh& mesh, Normal_map normals)
{
  Estimates e = make_estimates(mesh);
  SC::jet_fitting_curvatures(mesh, parameters_of(e, normals).degree_fitting(degree).number_of_rings(rings));
  return e;
}

Estimates goldfeather_interrante(Mesh& mesh, Normal_map normals)
{
  Estimates e = make_estimates(mesh);
  SC::goldfeather_interrante_curvatures(mesh, parameters_of(e, normals).number_of_rings(2));
  return e;
}

Estimates hildebrandt_polthier(Mesh& mesh, Normal_map normals)
{
  Estimates e = make_estimates(mesh);
  SC::hildebrandt_polthier_curvatures(mesh, parameters_of(e, normals).number_of_rings(2));
  return e;
}

Estimates rusinkiewicz(Mesh& mesh, Normal_map normals)
{
  Estimates e = make_estimates(mesh);
  SC::rusinkiewicz_curvatures(mesh, parameters_of(e, normals));
  return e;
}

Estimates batagelo_wu(Mesh& mesh, Normal_map normals)
{
  Estimates e = make_estimates(mesh);
  SC::batagelo_wu_curvatures(mesh, parameters_of(e, normals));
  return e;
}

Estimates kalogerakis(Mesh& mesh, Normal_map)
{
  Estimates e = make_estimates(mesh);
  SC::kalogerakis_curvatures(mesh,
                             SC::parameters::vertex_principal_curvatures_and_directions_map(e.curvatures)
                                 .vertex_status_map(e.statuses)
                                 .number_of_rings(2));
  return e;
}

} // namespace

const std::vector<Other_estimator>& other_estimators()
{
  static const std::vector<Other_estimator> list = {
      {"HRBF exact, 2 rings", hrbf_exact<2>},
      {"HRBF exact, 3 rings", hrbf_exact<3>},
      {"HRBF, 2 rings", hrbf_inexact<2>},
      {"HRBF, 3 rings", hrbf_inexact<3>},
      {"jet d=2, 4 rings", jet<2, 4>},
      {"jet d=4, 4 rings", jet<4, 4>},
      {"Goldfeather-Interrante, 2 rings", goldfeather_interrante},
      {"Rusinkiewicz", rusinkiewicz},
      {"Batagelo-Wu", batagelo_wu},
      {"Kalogerakis, 2 rings", kalogerakis},
      {"Hildebrandt-Polthier, 2 edges", hildebrandt_polthier}};
  return list;
}

} // namespace adaptive
