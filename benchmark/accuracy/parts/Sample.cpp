#include "Sample.h"

#include "build_face_graph.h"
#include "tessellations.h"
#include "test_functions.h"

#include <Shape_characteristics/normals/vertex_normals.h>

#include <cmath>

namespace accuracy {

namespace {

using benchmark_support::Triangle_arrays;
using benchmark_support::Vector;

// noise must not repeat the random numbers that placed the points
constexpr std::uint64_t seed_of_noise = 1000;

Triangle_arrays tessellate(const benchmark_support::Explicit_function& f,
                           Tessellation tessellation,
                           std::uint64_t seed,
                           const Resolution& resolution)
{
  return tessellation == Tessellation::UNIFORM_GRID
             ? benchmark_support::grid_tessellation(f, std::size_t(std::sqrt(double(resolution.points))))
             : benchmark_support::random_tessellation(f, resolution.points, seed,
                                                      benchmark_support::Hull::OF_INCREMENTAL_TRIANGULATION);
}

Triangle_arrays tessellate(const benchmark_support::Implicit_function& f,
                           Tessellation tessellation,
                           const Resolution& resolution)
{
  using benchmark_support::Edge_crossing;
  if(tessellation == Tessellation::DUAL_CONTOURING)
    return benchmark_support::dual_contouring_tessellation(f, resolution.grid);
  return benchmark_support::marching_cubes_tessellation(
      f, resolution.grid,
      tessellation == Tessellation::MARCHING_CUBES_ORIGINAL ? Edge_crossing::LINEAR : Edge_crossing::EXACT);
}

} // namespace

Sample
make_sample(const Table& table, const std::string& surface, std::uint64_t seed, const Resolution& resolution)
{
  Sample sample;
  Triangle_arrays arrays;
  if(is_graph(surface))
  {
    const benchmark_support::Explicit_function& f = benchmark_support::explicit_function(surface);
    arrays = tessellate(f, table.of_graphs, seed, resolution);
    for(const Vector& p : arrays.points)
      sample.exact.push_back(f.exact(p.x, p.y));
  }
  else
  {
    const benchmark_support::Implicit_function& f = benchmark_support::implicit_function(surface);
    arrays = tessellate(f, table.of_level_sets, resolution);
    for(const Vector& p : arrays.points)
      sample.exact.push_back(f.exact(p));
  }
  if(table.displacement != Displacement::NONE)
    benchmark_support::add_noise(arrays,
                                 table.displacement == Displacement::GAUSSIAN_NOISE
                                     ? benchmark_support::Noise::GAUSSIAN
                                     : benchmark_support::Noise::UNIFORM,
                                 table.sigma, seed_of_noise + seed);
  sample.mesh = benchmark_support::build_face_graph<Mesh>(arrays.points, arrays.triangles);
  for(std::size_t rings : benchmark_support::rings_from_border(arrays))
    sample.inner.push_back(rings > 4);
  return sample;
}

bool depends_on_seed(const Table& table, const std::string& surface)
{
  return table.displacement != Displacement::NONE ||
         tessellation(table, surface) == Tessellation::RANDOM_POINTS;
}

Normal_map make_normals(Sample& sample, Normals normals)
{
  Normal_map map = sample.mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normals").first;
  if(normals == Normals::EXACT)
    for(Vertex v : vertices(sample.mesh))
    {
      const Vector& n = sample.exact[v].normal;
      map[v] = Kernel::Vector_3(n.x, n.y, n.z);
    }
  else
    SC::vertex_normals(sample.mesh, map,
                       SC::parameters::normal_weighting(normals == Normals::MAX
                                                            ? SC::Normal_weighting::MAX
                                                            : SC::Normal_weighting::AVERAGE));
  return map;
}

} // namespace accuracy
