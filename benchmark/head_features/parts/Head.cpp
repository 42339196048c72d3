#include "Head.h"

#include <Shape_characteristics/head_features/Head_feature.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

namespace head_features {
namespace {

using boost::property_tree::ptree;
using SC::Head_feature;
using SC::Head_region;

// the names of the data
const std::vector<std::pair<Head_feature, const char*>> point_names = {
    {Head_feature::TOP, "P_top"},
    {Head_feature::NOSE_TIP, "P_nose"},
    {Head_feature::CHIN, "P_chin"},
    {Head_feature::LEFT_E1, "E_left_outer"},
    {Head_feature::LEFT_E2, "E_left_inner"},
    {Head_feature::LEFT_E3, "E_left_upper_outer"},
    {Head_feature::LEFT_E4, "E_left_upper_inner"},
    {Head_feature::LEFT_E5, "E_left_lower_outer"},
    {Head_feature::LEFT_E6, "E_left_lower_inner"},
    {Head_feature::RIGHT_E1, "E_right_outer"},
    {Head_feature::RIGHT_E2, "E_right_inner"},
    {Head_feature::RIGHT_E3, "E_right_upper_outer"},
    {Head_feature::RIGHT_E4, "E_right_upper_inner"},
    {Head_feature::RIGHT_E5, "E_right_lower_outer"},
    {Head_feature::RIGHT_E6, "E_right_lower_inner"},
    {Head_feature::N1, "N1"},
    {Head_feature::N2, "N2"},
    {Head_feature::N3, "N3"},
    {Head_feature::N4, "N4"},
    {Head_feature::N5, "N5_side_N3_left"},
    {Head_feature::N6, "N6_side_N4_left"},
    {Head_feature::N7, "N7_side_N3_right"},
    {Head_feature::N8, "N8_side_N4_right"},
    {Head_feature::M1, "M1_left"},
    {Head_feature::M2, "M2_right"},
    {Head_feature::M3, "M3_upper"},
    {Head_feature::M4, "M4_lower"},
    {Head_feature::LEFT_R1, "R1_left"},
    {Head_feature::LEFT_R2, "R2_left"},
    {Head_feature::LEFT_R3, "R3_left"},
    {Head_feature::LEFT_R4, "R4_left"},
    {Head_feature::LEFT_R5, "R5_left"},
    {Head_feature::RIGHT_R1, "R1_right"},
    {Head_feature::RIGHT_R2, "R2_right"},
    {Head_feature::RIGHT_R3, "R3_right"},
    {Head_feature::RIGHT_R4, "R4_right"},
    {Head_feature::RIGHT_R5, "R5_right"}};

const std::vector<std::pair<Head_region, const char*>> region_names = {
    {Head_region::LEFT_EYE, "eye_left"}, {Head_region::RIGHT_EYE, "eye_right"},
    {Head_region::NOSE, "nose"},         {Head_region::MOUTH, "mouth"},
    {Head_region::LEFT_EAR, "ear_left"}, {Head_region::RIGHT_EAR, "ear_right"}};

std::vector<double> numbers(const ptree& list)
{
  std::vector<double> result;
  for(const auto& element : list)
    result.push_back(element.second.get_value<double>());
  return result;
}

ptree read_json(const std::string& file)
{
  ptree tree;
  boost::property_tree::read_json(file, tree); // its errors name the file and the line
  return tree;
}

// one file for all heads of a folder
const ptree& regions_beside(const std::string& file)
{
  static std::map<std::string, ptree> read;
  const auto path = std::filesystem::path(file).parent_path() / "regions.json";
  const auto found = read.find(path.string());
  if(found != read.end())
    return found->second;
  return read[path.string()] = std::filesystem::is_regular_file(path) ? read_json(path.string()) : ptree();
}

Point_3 to_point(const ptree& place, const std::string& file)
{
  const std::vector<double> p = numbers(place);
  if(p.size() != 3 || !std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    throw std::runtime_error(file + ": a place is no point");
  return {p[0], p[1], p[2]};
}

} // namespace

std::vector<Head_file>
head_files(const std::string& folder, const std::vector<std::string>& variants, std::string& comment)
{
  std::string place = folder;
#ifdef SHAPE_CHARACTERISTICS_HEADS_DIR
  if(place.empty())
    place = SHAPE_CHARACTERISTICS_HEADS_DIR;
#endif
  std::vector<Head_file> files;
  std::error_code ignored;
  if(std::filesystem::is_directory(place, ignored))
    for(const std::string& variant : variants)
    {
      const std::size_t first = files.size();
      for(const auto& entry : std::filesystem::directory_iterator(place))
      {
        const std::string stem = entry.path().stem().string(), ending = "_" + variant;
        auto truth = entry.path();
        truth.replace_extension(".json");
        if(entry.path().extension() == ".ply" && stem.size() > ending.size() &&
           stem.compare(stem.size() - ending.size(), ending.size(), ending) == 0 &&
           std::filesystem::is_regular_file(truth, ignored))
          files.push_back(
              {stem.substr(0, stem.size() - ending.size()), variant, entry.path().string(), truth.string()});
      }
      std::sort(files.begin() + std::ptrdiff_t(first), files.end(),
                [](const Head_file& a, const Head_file& b) { return a.name < b.name; });
    }
  comment = files.empty() ? "Skipped: there are no heads in " + place
                          : std::to_string(files.size()) + " meshes of heads in " + place;
  return files;
}

Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.is_empty() || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("not a triangle mesh: " + file);
  return mesh;
}

Head read_head(const Head_file& file)
{
  Head head;
  head.name = file.name;
  head.variant = file.variant;
  head.mesh = read_mesh(file.mesh);
  const ptree tree = read_json(file.truth);
  const ptree& places = tree.get_child("thesis");
  Features& truth = head.truth;
  truth.is_head = true;
  for(const auto& [feature, name] : point_names)
    if(const auto place = places.get_child_optional(name))
    {
      auto& point = truth[feature];
      point.is_found = true;
      point.position = to_point(place->get_child("pos"), file.truth);
      point.confidence = 1.;
      point.vertex = *head.mesh.vertices().begin();
      for(const Mesh::Vertex_index v : head.mesh.vertices())
        if(CGAL::squared_distance(head.mesh.point(v), point.position) <
           CGAL::squared_distance(head.mesh.point(point.vertex), point.position))
          point.vertex = v;
    }
  const auto menton = places.get_child_optional("chin_menton");
  if(!menton || !truth[Head_feature::TOP].is_found)
    throw std::runtime_error(file.truth + ": there is no height without chin_menton and P_top");
  if(const auto pose = tree.get_child_optional("pose"))
  {
    std::vector<double> m;
    for(const auto& row : *pose)
      for(const double x : numbers(row.second))
        m.push_back(x);
    if(m.size() != 16)
      throw std::runtime_error(file.truth + ": the pose is no matrix of 4 x 4");
    truth.transformation = CGAL::Aff_transformation_3<Kernel>(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7],
                                                              m[8], m[9], m[10], m[11])
                               .inverse();
  }
  const Point_3 top = truth.transformation.transform(truth[Head_feature::TOP].position),
                bottom = truth.transformation.transform(to_point(menton->get_child("pos"), file.truth));
  truth.head_height = top.y() - bottom.y(); // a pose is rigid
  if(!(truth.head_height > 0.))
    throw std::runtime_error(file.truth + ": the top is not above the chin");
  head.is_known.assign(head.mesh.number_of_vertices(), true);
  if(const auto regions = regions_beside(file.truth).get_child_optional(file.variant))
  {
    const auto vertices_of = [&](const char* name)
    {
      std::vector<Mesh::Vertex_index> result;
      if(const auto list = regions->get_child_optional(name))
        for(const auto& element : *list)
        {
          const auto i = element.second.get_value<std::uint32_t>();
          if(i >= head.mesh.number_of_vertices())
            throw std::runtime_error(file.truth + ": a region has a vertex that isn't there");
          result.push_back(Mesh::Vertex_index(i));
        }
      return result;
    };
    for(const auto& [region, name] : region_names)
    {
      truth[region].vertices = vertices_of(name);
      truth[region].is_found = !truth[region].vertices.empty();
      truth[region].confidence = 1.;
    }
    for(const char* name : {"eyeballs", "iris_hidden"})
      for(const Mesh::Vertex_index v : vertices_of(name))
        head.is_known[v] = false;
    // subdivision keeps the vertices of the surface that it divides, and puts its own behind them
    const auto divided = std::filesystem::path(file.mesh).parent_path() / (file.name + "_skin.ply");
    if(file.variant == "loop1" && std::filesystem::is_regular_file(divided))
    {
      const std::size_t before = read_mesh(divided.string()).number_of_vertices();
      for(std::size_t i = before; i < head.is_known.size(); ++i)
        head.is_known[i] = false;
    }
  }
  return head;
}

} // namespace head_features
