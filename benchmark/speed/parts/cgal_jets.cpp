#include "cgal_jets.h"

#include <Shape_characteristics/sampling/Face_graph_samples.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/Monge_via_jet_fitting.h>

namespace speed {
namespace {

constexpr std::size_t degree = 4, smallest_number_of_points = (degree + 1) * (degree + 2) / 2;

template <typename Iterator>
void fit(Workload& w, Vertex v, Iterator begin, Iterator end)
{
  if(std::size_t(end - begin) < smallest_number_of_points)
    return;
  CGAL::Monge_via_jet_fitting<Kernel> fitting;
  auto monge = fitting(begin, end, degree, 2);
  monge.comply_wrt_given_normal(w.normals[v]);
  // CGAL's curvatures are those of the height over the tangent plane: negative where convex
  w.curvatures[v].min_curvature = -monge.principal_curvatures(0);
  w.curvatures[v].max_curvature = -monge.principal_curvatures(1);
  w.curvatures[v].min_direction = monge.maximal_principal_direction();
  w.curvatures[v].max_direction = monge.minimal_principal_direction();
  w.statuses[v] = SC::Estimation_status::ESTIMATED;
}

// Appends the points of the neighbourhood of each vertex to `points`, and calls `use` after each.
template <typename Use>
void gather(const Workload& w, unsigned int rings, std::vector<Kernel::Point_3>& points, const Use& use)
{
  const SC::Face_graph_samples samples(w.mesh, w.mesh.points(), SC::Neighborhood::rings(rings));
  SC::Face_graph_samples::Workspace workspace;
  for(std::size_t i = 0; i < samples.size(); ++i)
  {
    points.push_back(w.mesh.point(w.vertices[i]));
    for(const auto j : samples.neighbors(i, smallest_number_of_points - 1, workspace))
      points.push_back(w.mesh.point(w.vertices[j]));
    use(i);
  }
}

} // namespace

Neighbourhoods gather_neighbourhoods(const Workload& w, unsigned int rings)
{
  Neighbourhoods result;
  result.begin.push_back(0);
  gather(w, rings, result.points, [&](std::size_t) { result.begin.push_back(result.points.size()); });
  return result;
}

void cgal_jets(Workload& w, const Neighbourhoods& neighbourhoods)
{
  for(std::size_t i = 0; i < w.size(); ++i)
    fit(w, w.vertices[i], neighbourhoods.points.begin() + std::ptrdiff_t(neighbourhoods.begin[i]),
        neighbourhoods.points.begin() + std::ptrdiff_t(neighbourhoods.begin[i + 1]));
}

void cgal_jets(Workload& w, unsigned int rings)
{
  std::vector<Kernel::Point_3> points;
  gather(w, rings, points,
         [&](std::size_t i)
         {
           fit(w, w.vertices[i], points.begin(), points.end());
           points.clear();
         });
}

} // namespace speed
