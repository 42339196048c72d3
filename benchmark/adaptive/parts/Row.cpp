#include "Row.h"

#include "Random.h"
#include "build_face_graph.h"
#include "estimate.h"
#include "tessellations.h"

#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/normals/vertex_normals.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace adaptive {

namespace SC = Shape_characteristics;
using benchmark_support::Exact_curvature;
using benchmark_support::Triangle_arrays;
using benchmark_support::Vector;

double mean_error(const std::vector<Vertex_record>& vertices, std::size_t candidate)
{
  double sum = 0.;
  std::size_t number = 0;
  for(const Vertex_record& v : vertices)
    if(std::isfinite(v.errors[candidate].k_max))
    {
      sum += v.errors[candidate].sum();
      ++number;
    }
  return sum / double(number);
}

std::string Conditions::name() const
{
  std::ostringstream out;
  out << normals << " normals";
  if(normal_noise > 0.)
    out << " (" << normal_noise << ")";
  if(point_noise > 0.)
    out << ", noise " << point_noise;
  return out.str();
}

namespace {

// those in which a surface is tried
std::vector<Conditions> conditions(const Surface& surface, Purpose purpose)
{
  std::vector<Conditions> list = {{"exact", 0., 0.}, {"Max", 0., 0.}, {"average", 0., 0.}};
  if(!surface.is_noise_added)
    return list;
  list.push_back({"noisy", 0., .03});
  list.push_back({"noisy", 0., .1});
  for(const double noise : {.01, .03, .1})
    for(const char* normals : {"exact", "Max"})
      list.push_back({normals, noise, 0.});
  if(purpose == Purpose::CALIBRATION)
  {
    list.push_back({"noisy", 0., .003});
    list.push_back({"noisy", .03, .03});
    list.push_back({"Max", .001, 0.});
    list.push_back({"average", .003, 0.});
    list.push_back({"average", .05, 0.});
    list.push_back({"exact", .003, 0.});
    list.push_back({"Max", .2, 0.});
  }
  return list;
}

Normal_map make_normals(Mesh& mesh, const std::vector<Exact_curvature>& exact, const Conditions& c)
{
  Normal_map map = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normals").first;
  if(c.normals == "Max" || c.normals == "average")
  {
    SC::vertex_normals(mesh, map,
                       SC::parameters::normal_weighting(c.normals == "Max" ? SC::Normal_weighting::MAX
                                                                           : SC::Normal_weighting::AVERAGE));
    return map;
  }
  benchmark_support::Random random(11);
  for(const auto v : vertices(mesh))
  {
    Vector n = exact[v].normal;
    if(c.normal_noise > 0.)
    {
      for(std::size_t i = 0; i < 3; ++i)
        n[i] += c.normal_noise * random.gaussian();
      n = normalized(n);
    }
    map[v] = Kernel::Vector_3(n.x, n.y, n.z);
  }
  return map;
}

Vertex_record::Error error(const SC::internal::Curvature_estimate& e, const Exact_curvature& exact)
{
  constexpr float none = std::numeric_limits<float>::infinity();
  if(!SC::is_estimated(e.status))
    return {none, none};
  return {float(e.curvatures.max_curvature - exact.k_max), float(e.curvatures.min_curvature - exact.k_min)};
}

void add_records(const Mesh& mesh, Normal_map normals, const std::vector<Exact_curvature>& exact, Row& row)
{
  using Statistics =
      SC::internal::Adaptive_statistics<CGAL::Parallel_if_available_tag, SC::Face_graph_samples>;
  Statistics statistics(
      [&](unsigned int rings)
      {
        return SC::sampled_surface(mesh, SC::Neighborhood::rings(rings),
                                   SC::parameters::vertex_normal_map(normals));
      },
      {}, false);
  row.vertices.resize(exact.size());
  for(std::size_t s = 0; s < number_of_statistics; ++s)
  {
    const std::vector<double>& of_vertices = statistics.statistic(SC::internal::Adaptive_statistic(s));
    for(std::size_t i = 0; i < exact.size(); ++i)
      row.vertices[i].statistics[s] = float(of_vertices[i]);
  }
  for(std::size_t c = 0; c < number_of_candidates; ++c)
  {
    const SC::internal::Fitted_field& field = statistics.field(SC::Adaptive_estimator_choice(c));
    for(std::size_t i = 0; i < exact.size(); ++i)
      row.vertices[i].errors[c] = error(field[i].estimate(), exact[i]);
    row.mean_errors.push_back(mean_error(row.vertices, c));
  }
}

double mean_error(const Mesh& mesh, const Estimates& estimates, const std::vector<Exact_curvature>& exact)
{
  double sum = 0.;
  std::size_t number = 0;
  for(const auto v : vertices(mesh))
    if(SC::is_estimated(estimates.statuses[v]))
    {
      sum += std::abs(estimates.curvatures[v].max_curvature - exact[v].k_max) +
             std::abs(estimates.curvatures[v].min_curvature - exact[v].k_min);
      ++number;
    }
  return sum / double(number);
}

} // namespace

std::vector<Experiment> experiments(Purpose purpose, double scale, const std::string& only)
{
  std::vector<Experiment> list;
  const auto is_asked_for = [&](const Surface& surface)
  { return surface.name().find(only) != std::string::npos; };
  if(purpose != Purpose::CALIBRATION)
  {
    for(const Surface& surface : surfaces(purpose, scale))
      if(is_asked_for(surface))
        for(const Conditions& c : conditions(surface, purpose))
          list.push_back({surface, c});
    return list;
  }
  // There are many surfaces: half of the noisy conditions on each are enough, and the others on coarser samples of it, which look
  // otherwise.
  const auto is_clean = [](const Conditions& c) { return c.point_noise == 0. && c.normal_noise == 0.; };
  for(const bool is_coarse : {false, true})
  {
    std::size_t number = 0; // of the surface and conditions, in all
    benchmark_support::Random random(1);
    for(const Surface& surface : surfaces(purpose, (is_coarse ? .3 : 1.) * scale))
    {
      ++number;
      for(const Conditions& c : conditions(surface, purpose))
      {
        ++number;
        const bool is_tried = random.uniform() < surface.share;
        if(is_asked_for(surface) && is_tried && ((number % 2 == 0) == is_coarse || is_clean(c)))
          list.push_back({surface, c});
      }
    }
  }
  return list;
}

Row measure(const Experiment& experiment, std::uint64_t seed, const Measurements& measurements)
{
  const Conditions& given = experiment.conditions;
  Triangle_arrays arrays = experiment.surface.mesh(seed);
  std::vector<Exact_curvature> exact;
  for(const Vector& p : arrays.points)
    exact.push_back(experiment.surface.exact(p));
  if(given.point_noise > 0.)
    add_noise(arrays, benchmark_support::Noise::GAUSSIAN, given.point_noise, seed + 6);
  Mesh mesh = benchmark_support::build_face_graph<Mesh>(arrays.points, arrays.triangles);
  const Normal_map normals = make_normals(mesh, exact, given);
  Row row;
  row.surface = experiment.surface.name();
  row.shape = experiment.surface.shape;
  row.conditions = given;
  if(measurements.records)
    add_records(mesh, normals, exact, row);
  const auto estimate = [&](const bool fits_are_shared, double& mae, double& seconds)
  {
    const auto start = std::chrono::steady_clock::now();
    const Estimates estimates = estimate_adaptively(mesh, normals, fits_are_shared);
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    mae = mean_error(mesh, estimates, exact);
  };
  if(measurements.adaptive)
    estimate(false, row.adaptive_error, row.adaptive_seconds);
  if(measurements.shared)
    estimate(true, row.shared_error, row.shared_seconds);
  if(measurements.others)
    for(const Other_estimator& other : other_estimators())
      row.others.emplace_back(other.name, mean_error(mesh, other.run(mesh, normals), exact));
  return row;
}

} // namespace adaptive
