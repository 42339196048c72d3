#include "heads.h"

#include "Mesh.h"
#include "Random.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/normals/point_normals.h>
#include <Shape_characteristics/normals/vertex_normals.h>
#include <Shape_characteristics/sampling/Neighborhood.h>
#include <Shape_characteristics/sampling/Point_set_samples.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <queue>
#include <stdexcept>
#include <utility>

namespace registration {
namespace {

namespace SC = Shape_characteristics;
namespace SMS = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using benchmark_support::Random;

Eigen::Vector3d to_eigen(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

Point_3 to_cgal(const Eigen::Vector3d& p)
{
  return {p.x(), p.y(), p.z()};
}

Scan to_scan(const Mesh& mesh)
{
  Scan scan;
  std::vector<std::uint32_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for(const Mesh::Vertex_index v : mesh.vertices())
  {
    number[std::size_t(v)] = std::uint32_t(scan.points.size());
    scan.points.push_back(to_eigen(mesh.point(v)));
  }
  for(const Mesh::Face_index f : mesh.faces())
  {
    std::array<std::uint32_t, 3> t{};
    std::size_t k = 0;
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      t[k++ % 3] = number[std::size_t(v)];
    scan.triangles.push_back(t);
  }
  return scan;
}

Mesh read_skin(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.is_empty() || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("not a triangle mesh: " + file);
  CGAL::Polygon_mesh_processing::keep_largest_connected_components(mesh, 1); // without the eyeballs
  mesh.collect_garbage();
  double lowest[3], highest[3];
  std::fill(lowest, lowest + 3, HUGE_VAL);
  std::fill(highest, highest + 3, -HUGE_VAL);
  for(const auto v : mesh.vertices())
    for(int k = 0; k < 3; ++k)
    {
      lowest[k] = (std::min)(lowest[k], mesh.point(v)[k]);
      highest[k] = (std::max)(highest[k], mesh.point(v)[k]);
    }
  const double size = (std::max)({highest[0] - lowest[0], highest[1] - lowest[1], highest[2] - lowest[2]});
  for(const auto v : mesh.vertices()) // not centered: the plane of symmetry stays where it is
    mesh.point(v) = CGAL::ORIGIN + (mesh.point(v) - CGAL::ORIGIN) / size;
  return mesh;
}

Scan resampled(Mesh mesh, std::size_t faces, Random& random)
{
  double sum = 0.;
  for(const auto e : mesh.edges())
    sum += std::sqrt(CGAL::to_double(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)))));
  const double sigma = .05 * sum / double(mesh.number_of_edges());
  for(const auto v : mesh.vertices())
  {
    const double x = random.gaussian(), y = random.gaussian(), z = random.gaussian();
    mesh.point(v) = mesh.point(v) + Kernel::Vector_3(sigma * x, sigma * y, sigma * z);
  }
  using Policies = SMS::GarlandHeckbert_plane_policies<Mesh, Kernel>;
  const Policies policies(mesh);
  // each edge that is collapsed takes two faces, or one on the border
  const std::size_t edges = faces * 3 / 2;
  // CGAL's own predicate has other names in other versions
  const auto is_coarse = [edges](const auto& /*cost*/, const auto& /*edge*/, std::size_t /*at_first*/,
                                 std::size_t now) { return now < edges; };
  SMS::edge_collapse(mesh, is_coarse,
                     CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  mesh.collect_garbage();
  return to_scan(mesh);
}

template <typename T>
void write(std::ostream& out, const std::vector<T>& values)
{
  const std::uint64_t size = values.size();
  out.write(reinterpret_cast<const char*>(&size), sizeof(size));
  out.write(reinterpret_cast<const char*>(values.data()), std::streamsize(size * sizeof(T)));
}

template <typename T>
bool read(std::istream& in, std::vector<T>& values)
{
  std::uint64_t size = 0;
  if(!in.read(reinterpret_cast<char*>(&size), sizeof(size)) || size > (1u << 24))
    return false;
  values.resize(size);
  return bool(in.read(reinterpret_cast<char*>(values.data()), std::streamsize(size * sizeof(T))));
}

// the sums of twice the areas of the first triangles: of none, of one, of two ...
std::vector<double> summed_areas(const Scan& mesh)
{
  std::vector<double> areas(1, 0.);
  for(const auto& t : mesh.triangles)
  {
    const Eigen::Vector3d a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    areas.push_back(areas.back() + (b - a).cross(c - a).norm());
  }
  return areas;
}

bool read_from_cache(const std::string& file, Head& head)
{
  std::ifstream in(file, std::ios::binary);
  if(!in)
    return false;
  for(Scan* scan : {&head.first, &head.second, &head.fine})
    if(!read(in, scan->points) || !read(in, scan->triangles))
      return false;
  return true;
}

void write_to_cache(const std::string& file, const Head& head)
{
  // aside, then renamed: what was interrupted is never read
  const std::string aside = file + ".part";
  {
    std::ofstream out(aside, std::ios::binary);
    for(const Scan* scan : {&head.first, &head.second, &head.fine})
    {
      write(out, scan->points);
      write(out, scan->triangles);
    }
    if(!out)
      throw std::runtime_error("can't write " + aside);
  }
  std::filesystem::rename(aside, file);
}

} // namespace

std::vector<std::string> head_files(const std::string& folder, std::string& comment)
{
  const std::string tried = folder.empty() ? SHAPE_CHARACTERISTICS_HEADS_DIR : folder;
  std::vector<std::string> files;
  std::error_code ignored;
  for(const auto& entry : std::filesystem::directory_iterator(tried, ignored))
  {
    const std::string name = entry.path().filename().string();
    if(name.rfind("id", 0) == 0 && name.size() > 9 && name.substr(name.size() - 9) == "_crop.ply")
      files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  if(!files.empty())
  {
    comment = std::to_string(files.size()) + " heads";
    return files;
  }
  if(!folder.empty())
    throw std::invalid_argument("no heads (id*_crop.ply) in " + folder);
  const std::string bust = std::string(SHAPE_CHARACTERISTICS_DATA_DIR) + "/meshes/mannequin-devil.off";
  if(std::filesystem::is_regular_file(bust, ignored))
  {
    comment = "no folder of heads beside the checkout: a bust that comes with CGAL stands in";
    files.push_back(bust);
  }
  else
    comment = "skipped: neither heads beside the checkout nor the meshes that come with CGAL";
  return files;
}

Head read_head(const std::string& file,
               const std::size_t (&faces)[2],
               std::uint64_t seed,
               const std::string& cache)
{
  Head head;
  head.name = std::filesystem::path(file).stem().string();
  std::filesystem::create_directories(cache);
  const std::string kept =
      (std::filesystem::path(cache) / (head.name + "_" + std::to_string(faces[0]) + "_" +
                                       std::to_string(faces[1]) + "_" + std::to_string(seed) + ".scans"))
          .string();
  if(!read_from_cache(kept, head))
  {
    Mesh mesh = read_skin(file);
    // a coarse model is refined until there is something to simplify
    do
      CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
    while(mesh.number_of_faces() < 2 * faces[0]);
    head = Head{head.name, {}, {}, to_scan(mesh)};
    Random random(seed);
    head.first = resampled(mesh, faces[0], random);
    head.second = resampled(std::move(mesh), faces[1], random);
    write_to_cache(kept, head);
  }
  set_mesh_normals(head.fine);
  return head;
}

Scan random_points(const Scan& mesh, std::size_t number, std::uint64_t seed)
{
  Random random(seed);
  const std::vector<double> areas = summed_areas(mesh);
  Scan result;
  while(result.points.size() < number)
  {
    const auto chosen =
        std::upper_bound(areas.begin() + 1, areas.end() - 1, random.uniform(0., areas.back()));
    const auto& t = mesh.triangles[std::size_t(chosen - areas.begin()) - 1];
    double u = random.uniform(), v = random.uniform();
    if(u + v > 1.)
    {
      u = 1. - u;
      v = 1. - v;
    }
    const Eigen::Vector3d a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    result.points.push_back(a + u * (b - a) + v * (c - a));
    result.normals.push_back((b - a).cross(c - a).normalized());
  }
  return result;
}

Scan poisson_disc_points(const Scan& mesh, std::size_t number, std::uint64_t seed)
{
  const Scan points = random_points(mesh, 3 * number, seed);

  // The one with the most and nearest neighbors goes, again and again.
  const double radius = std::sqrt(summed_areas(mesh).back() / (std::sqrt(3.) * double(number)));
  const SC::Point_set_samples samples(points.points, CGAL::Identity_property_map<Eigen::Vector3d>(),
                                      SC::Neighborhood::ball(radius));
  SC::Point_set_samples::Workspace workspace;
  const auto weight_of = [&](const std::size_t i, const std::size_t j)
  { return std::pow(1. - (samples.point(i) - samples.point(j)).norm() / radius, 8); };
  std::vector<double> weight(samples.size(), 0.);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry> queue;
  for(std::size_t i = 0; i < samples.size(); ++i)
  {
    for(const auto j : samples.neighbors(i, 0, workspace))
      weight[i] += weight_of(i, j);
    queue.emplace(weight[i], i);
  }
  std::vector<bool> is_out(samples.size(), false);
  for(std::size_t left = samples.size(); left > number;)
  {
    const Entry e = queue.top();
    queue.pop();
    if(is_out[e.second])
      continue;
    if(e.first > weight[e.second]) // it has lost neighbors since
    {
      queue.emplace(weight[e.second], e.second);
      continue;
    }
    is_out[e.second] = true;
    --left;
    for(const auto j : samples.neighbors(e.second, 0, workspace))
      weight[j] -= weight_of(e.second, j);
  }
  Scan result;
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(!is_out[i])
    {
      result.points.push_back(points.points[i]);
      result.normals.push_back(points.normals[i]);
    }
  return result;
}

void set_mesh_normals(Scan& scan)
{
  Mesh mesh = to_mesh(scan);
  const auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("normals").first;
  SC::vertex_normals<CGAL::Sequential_tag>(mesh, normals);
  scan.normals.clear();
  for(const auto v : mesh.vertices())
    scan.normals.emplace_back(normals[v].x(), normals[v].y(), normals[v].z());
}

void estimate_point_normals(Scan& scan)
{
  using Point_and_normal = std::pair<Point_3, Kernel::Vector_3>;
  std::vector<Point_and_normal> points;
  for(const Eigen::Vector3d& p : scan.points)
    points.emplace_back(to_cgal(p), Kernel::Vector_3(0., 0., 0.));
  SC::point_normals<CGAL::Sequential_tag>(
      points, CGAL::Second_of_pair_property_map<Point_and_normal>(),
      SC::parameters::point_map(CGAL::First_of_pair_property_map<Point_and_normal>()));
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Kernel::Vector_3& n = points[i].second;
    const Eigen::Vector3d normal(n.x(), n.y(), n.z());
    scan.normals[i] = normal.dot(scan.normals[i]) < 0. ? Eigen::Vector3d(-normal) : normal;
  }
}

} // namespace registration
