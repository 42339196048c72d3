// In a file of its own: the estimators are compiled once.
#include "estimators.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/curvature/adaptive_curvatures.h>
#include <Shape_characteristics/curvature/batagelo_wu_curvatures.h>
#include <Shape_characteristics/curvature/boschiroli_curvatures.h>
#include <Shape_characteristics/curvature/goldfeather_interrante_curvatures.h>
#include <Shape_characteristics/curvature/hildebrandt_polthier_curvatures.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/integral_invariant_curvatures.h>
#include <Shape_characteristics/curvature/interpolated_corrected_curvatures.h>
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
#include <Shape_characteristics/curvature/zhihong_curvatures.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <stdexcept>

namespace speed {
namespace {

// Calls `run` with the tag of CGAL for so many threads.
template <typename Run>
void on_threads(unsigned int threads, const Run& run)
{
  if(threads < 2)
  {
    run(CGAL::Sequential_tag());
    return;
  }
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#endif
  run(CGAL::Parallel_if_available_tag());
}

// the named parameters that all estimators of meshes share
auto outputs(const Workload& w)
{
  return SC::parameters::vertex_principal_curvatures_and_directions_map(w.curvatures)
      .vertex_status_map(w.statuses);
}

auto outputs_and_normals(const Workload& w)
{
  return outputs(w).vertex_normal_map(w.normals);
}

std::string rings_text(unsigned int rings)
{
  return std::to_string(rings) + (rings == 1 ? " ring" : " rings");
}

// normals that are estimated in the same call
Estimator hrbf_estimated(unsigned int rings)
{
  return {"HRBF, estimated normals", rings_text(rings), false,
          [rings](Workload& w, unsigned int threads)
          {
            on_threads(threads, [&](auto tag)
                       { SC::hrbf_curvatures<decltype(tag)>(w.mesh, outputs(w).number_of_rings(rings)); });
          }};
}

// It isn't told what the normals are.
void adaptive(Workload& w, unsigned int threads)
{
  on_threads(threads,
             [&](auto tag) { SC::adaptive_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void adaptive_estimated(Workload& w, unsigned int threads)
{
  on_threads(threads, [&](auto tag) { SC::adaptive_curvatures<decltype(tag)>(w.mesh, outputs(w)); });
}

void rusinkiewicz(Workload& w, unsigned int threads)
{
  on_threads(threads,
             [&](auto tag) { SC::rusinkiewicz_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void tangent_space(Workload& w, unsigned int threads)
{
  on_threads(threads,
             [&](auto tag) { SC::tangent_space_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void theisel(Workload& w, unsigned int threads)
{
  on_threads(threads,
             [&](auto tag) { SC::theisel_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void zhihong(Workload& w, unsigned int threads)
{
  on_threads(threads,
             [&](auto tag) { SC::zhihong_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void boschiroli(Workload& w, unsigned int threads)
{
  on_threads(threads,
             [&](auto tag) { SC::boschiroli_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void meyer(Workload& w, unsigned int threads)
{
  on_threads(threads, [&](auto tag) { SC::meyer_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void taubin(Workload& w, unsigned int threads)
{
  on_threads(threads,
             [&](auto tag) { SC::taubin_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void normal_cycle(Workload& w, unsigned int threads)
{
  on_threads(threads,
             [&](auto tag) { SC::normal_cycle_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void hildebrandt_polthier(Workload& w, unsigned int threads)
{
  on_threads(threads, [&](auto tag)
             { SC::hildebrandt_polthier_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void integral_invariant(Workload& w, unsigned int threads)
{
  on_threads(threads, [&](auto tag)
             { SC::integral_invariant_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void batagelo_wu(Workload& w, unsigned int threads)
{
  on_threads(threads,
             [&](auto tag) { SC::batagelo_wu_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void moving_least_squares(Workload& w, unsigned int threads)
{
  on_threads(threads, [&](auto tag)
             { SC::moving_least_squares_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void razdan_bae(Workload& w, unsigned int threads)
{
  on_threads(threads,
             [&](auto tag) { SC::razdan_bae_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

void kalogerakis(Workload& w, unsigned int threads)
{
  on_threads(threads, [&](auto tag) { SC::kalogerakis_curvatures<decltype(tag)>(w.mesh, outputs(w)); });
}

void goldfeather_interrante(Workload& w, unsigned int threads)
{
  on_threads(threads, [&](auto tag)
             { SC::goldfeather_interrante_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}

#ifdef SHAPE_CHARACTERISTICS_HAS_INTERPOLATED_CORRECTED_CURVATURES
void interpolated_corrected(Workload& w, unsigned int threads)
{
  on_threads(threads, [&](auto tag)
             { SC::interpolated_corrected_curvatures<decltype(tag)>(w.mesh, outputs_and_normals(w)); });
}
#endif

} // namespace

Estimator hrbf_exact(unsigned int rings)
{
  return {"HRBF, exact normals", rings_text(rings), false,
          [rings](Workload& w, unsigned int threads)
          {
            on_threads(threads,
                       [&](auto tag)
                       {
                         SC::hrbf_curvatures<decltype(tag)>(
                             w.mesh, outputs_and_normals(w).number_of_rings(rings).normals_are_exact(true));
                       });
          }};
}

Estimator hrbf_exact_nearest(unsigned int neighbours)
{
  return {"HRBF of points, exact normals", std::to_string(neighbours) + " nearest", false,
          [neighbours](Workload& w, unsigned int threads)
          {
            on_threads(threads,
                       [&](auto tag)
                       {
                         SC::hrbf_curvatures<decltype(tag)>(
                             w.vertices, SC::parameters::point_map(w.mesh.points())
                                             .normal_map(w.normals)
                                             .principal_curvatures_and_directions_map(w.curvatures)
                                             .status_map(w.statuses)
                                             .number_of_neighbors(neighbours)
                                             .normals_are_exact(true));
                       });
          }};
}

Estimator thesis_path(unsigned int rings)
{
  return {"HRBF of the thesis, r^5", rings_text(rings), true,
          [rings](Workload& w, unsigned int threads)
          {
            on_threads(threads,
                       [&](auto tag)
                       {
                         SC::hrbf_curvatures<decltype(tag)>(w.mesh,
                                                            outputs_and_normals(w)
                                                                .number_of_rings(rings)
                                                                .radial_basis_function(SC::Polyharmonic<5>())
                                                                .normals_are_exact(true));
                       });
          }};
}

Estimator jet(unsigned int degree, unsigned int rings)
{
  return {"jet d=" + std::to_string(degree), rings_text(rings), true,
          [degree, rings](Workload& w, unsigned int threads)
          {
            on_threads(threads,
                       [&](auto tag)
                       {
                         SC::jet_fitting_curvatures<decltype(tag)>(
                             w.mesh, outputs_and_normals(w).degree_fitting(degree).number_of_rings(rings));
                       });
          }};
}

const std::vector<Estimator>& estimators()
{
  static const std::vector<Estimator> list = {
      hrbf_exact(1),
      hrbf_exact(2),
      hrbf_exact(3),
      hrbf_estimated(2),
      hrbf_exact_nearest(18),
      {"adaptive, exact normals", "2 to 4 rings", true, adaptive},
      {"adaptive, estimated normals", "2 to 4 rings", true, adaptive_estimated},
      thesis_path(2),
      {"Rusinkiewicz", "1 ring", false, rusinkiewicz},
      {"tangent space", "1 ring", false, tangent_space},
      {"Theisel", "1 ring", false, theisel},
      {"Zhihong", "1 ring", false, zhihong},
      {"Boschiroli", "1 ring", false, boschiroli},
      {"Meyer", "1 ring", false, meyer},
      {"Taubin", "1 ring", false, taubin},
      {"Batagelo-Wu", "1 ring", false, batagelo_wu},
      {"moving least squares", "3 rings", true, moving_least_squares},
      {"Razdan-Bae", "2 rings", false, razdan_bae},
      {"Kalogerakis", "2 rings", true, kalogerakis},
      {"normal cycle", "2 edges", true, normal_cycle},
      {"Hildebrandt-Polthier", "2 edges", true, hildebrandt_polthier},
      {"integral invariants", "2 edges", true, integral_invariant},
      {"Goldfeather-Interrante", "2 rings", false, goldfeather_interrante},
#ifdef SHAPE_CHARACTERISTICS_HAS_INTERPOLATED_CORRECTED_CURVATURES
      {"interpolated corrected", "1 ring", false, interpolated_corrected},
#endif

      jet(2, 2),
      jet(4, 2)};
  return list;
}

const Estimator& estimator(const std::string& label)
{
  for(const Estimator& e : estimators())
    if(e.label() == label)
      return e;
  throw std::out_of_range("no estimator " + label);
}

double mean_size_of_rings(const Workload& workload, unsigned int rings)
{
  const SC::Face_graph_samples samples(workload.mesh, workload.mesh.points(), SC::Neighborhood::rings(rings));
  SC::Face_graph_samples::Workspace workspace;
  double sum = 0.;
  for(std::size_t i = 0; i < samples.size(); ++i)
    sum += 1. + double(samples.neighbors(i, 0, workspace).size());
  return sum / double(samples.size());
}

} // namespace speed
