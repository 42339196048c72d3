// The feature points and regions of a head.
//
//     head_features head.ply --out features.json --picture features.png --points features.ply
//     head_features head.ply --aligned          the nose points towards +z, the top towards +y
//     head_features head.ply --thesis 300 200 400   the thesis's method, with so many vertices of the eyes, the nose, an ear
//
// Without a file, the head of a mannequin that comes with CGAL is taken.
#include "../support/Contact_sheet.h"
#include "../support/Drawable.h"
#include "../support/Mesh_renderer.h"
#include "../support/Ply_file.h"
#include "../support/data_file.h"
#include "../support/read_triangle_mesh.h"

#include <Shape_characteristics/head_features/detect_head_features.h>
#include <Shape_characteristics/normals/vertex_normals.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Head = SC::Head_features<Mesh, Kernel>;

namespace {

struct Command_line
{
  std::string file, out = "head_features.json", picture = "head_features.png", points = "head_features.ply";
  bool is_aligned = false;
  std::vector<int> thesis; // numbers of vertices
};

Command_line read(int argc, char* argv[])
{
  Command_line c;
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if((argument == "--out" || argument == "--picture" || argument == "--points") && i + 1 < argc)
      (argument == "--out" ? c.out : argument == "--picture" ? c.picture : c.points) = argv[++i];
    else if(argument == "--aligned")
      c.is_aligned = true;
    else if(argument == "--thesis" && i + 3 < argc)
    {
      for(int k = 0; k < 3; ++k)
        c.thesis.push_back(std::stoi(argv[++i]));
    }
    else if(c.file.empty() && argument[0] != '-')
      c.file = argument;
    else
      throw std::invalid_argument("'" + argument +
                                  "' is not understood; see the first lines of head_features.cpp");
  }
  if(c.file.empty())
    c.file = support::data_file("meshes/mannequin-devil.off");
  return c;
}

Head detect(const Mesh& mesh, const Command_line& c)
{
  const auto np = SC::parameters::head_is_aligned(c.is_aligned);
  if(c.thesis.empty())
    return SC::detect_head_features(mesh, np);
  return SC::detect_head_features(mesh, np.head_feature_method(SC::Head_feature_method::THESIS)
                                            .number_of_eye_vertices(c.thesis[0])
                                            .number_of_nose_vertices(c.thesis[1])
                                            .number_of_ear_vertices(c.thesis[2]));
}

const char* name(SC::Head_obstacle obstacle)
{
  switch(obstacle)
  {
  case SC::Head_obstacle::NONE:
    return "";
  case SC::Head_obstacle::FEW_SAMPLES:
    return "there are too few points";
  case SC::Head_obstacle::CANCELLED:
    return "the search was stopped";
  case SC::Head_obstacle::INSIDE_OUT:
    return "its faces are oriented inward";
  case SC::Head_obstacle::NO_NOSE:
    return "there is no nose";
  case SC::Head_obstacle::SHAPE_DISAGREES:
    return "it isn't shaped like one";
  case SC::Head_obstacle::FACE_IS_INCOMPLETE:
    return "a large part of the face is missing";
  case SC::Head_obstacle::NO_SYMMETRY:
    return "its sides aren't alike";
  case SC::Head_obstacle::WRONG_WAY_UP:
    return "it is upside down";
  case SC::Head_obstacle::DUPLICATE:
    return "each face has its own copies of its vertices";
  }
  return "";
}

std::string verdict(const Head& head)
{
  const std::string why = name(head.obstacle);
  const char* const what = head.is_head                                  ? "a head"
                           : head.verdict == SC::Head_verdict::UNCERTAIN ? "perhaps a head"
                                                                         : "not a head";
  return what + (why.empty() ? "" : ": " + why);
}

void write_json(const std::string& file_name, const std::string& source, const Head& head)
{
  std::ofstream out(file_name);
  out.precision(17);
  out << "{\n  \"file\": \"";
  for(const char c : source)
    out << (c == '"' || c == '\\' ? "\\" : "") << c;
  out << "\",\n  \"is_head\": " << (head.is_head ? "true" : "false") << ",\n  \"verdict\": \""
      << verdict(head) << "\",\n  \"head_height\": " << head.head_height << ",\n  \"transformation\": [";
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 4; ++j)
      out << (i + j > 0 ? ", " : "") << head.transformation.m(i, j);
  out << "],\n  \"points\": {";
  const char* separator = "";
  for(std::size_t k = 0; k < SC::number_of_head_features; ++k)
  {
    const auto& p = head.points[k];
    out << separator << "\n    \"" << SC::to_string(SC::Head_feature(k)) << "\": ";
    separator = ",";
    if(!p.is_found)
      out << "null";
    else
      out << "{ \"position\": [" << p.position.x() << ", " << p.position.y() << ", " << p.position.z()
          << "], \"vertex\": " << std::size_t(p.vertex) << ", \"confidence\": " << p.confidence << " }";
  }
  out << "\n  },\n  \"regions\": {";
  separator = "";
  for(std::size_t k = 0; k < SC::number_of_head_regions; ++k)
  {
    const auto& r = head.regions[k];
    out << separator << "\n    \"" << SC::to_string(SC::Head_region(k)) << "\": ";
    separator = ",";
    if(!r.is_found)
    {
      out << "null";
      continue;
    }
    out << "{ \"confidence\": " << r.confidence << ", \"vertices\": [";
    for(std::size_t i = 0; i < r.vertices.size(); ++i)
      out << (i > 0 ? ", " : "") << std::size_t(r.vertices[i]);
    out << "] }";
  }
  out << "\n  }\n}\n";
  if(!out.flush())
    throw std::runtime_error(file_name + " can't be written");
}

void write_points(const std::string& file_name, const Head& head)
{
  std::vector<support::Vector> points;
  std::vector<std::uint8_t> features;
  std::vector<double> confidences;
  for(std::size_t k = 0; k < SC::number_of_head_features; ++k)
    if(head.points[k].is_found)
    {
      const auto& p = head.points[k].position;
      points.push_back({p.x(), p.y(), p.z()});
      features.push_back(std::uint8_t(k));
      confidences.push_back(head.points[k].confidence);
    }
  support::Ply_file file(points);
  for(std::size_t k = 0; k < SC::number_of_head_features; ++k)
    file.add_comment("feature " + std::to_string(k) + " is " + SC::to_string(SC::Head_feature(k)));
  file.add_uchar("feature", features);
  file.add_scalar("confidence", confidences);
  file.write(file_name);
}

// what a triangle of the picture shows
enum Kind
{
  SKIN,
  EYE,
  NOSE,
  MOUTH,
  EAR,
  FEATURE,
  DOUBTFUL_FEATURE,
  number_of_kinds
};

support::Color_gradient colors()
{
  return support::Color_gradient({{.84, .82, .79},
                                  {.55, .72, .93},
                                  {.97, .80, .48},
                                  {.95, .62, .62},
                                  {.62, .84, .62},
                                  {.80, .05, .10},
                                  {.55, .10, .65}});
}

// The head in its frame, each triangle in the colour of its region, with balls at the feature points.
support::Drawable drawable(const Mesh& mesh, const Head& head)
{
  std::vector<Kind> kinds(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), SKIN);
  for(const auto& [region, kind] :
      {std::pair(SC::Head_region::LEFT_EYE, EYE), std::pair(SC::Head_region::RIGHT_EYE, EYE),
       std::pair(SC::Head_region::NOSE, NOSE), std::pair(SC::Head_region::MOUTH, MOUTH),
       std::pair(SC::Head_region::LEFT_EAR, EAR), std::pair(SC::Head_region::RIGHT_EAR, EAR)})
    for(const auto v : head[region].vertices)
      kinds[std::size_t(v)] = kind;

  support::Drawable shape;
  const auto add_corner = [&](const Kernel::Point_3& p, const Kernel::Vector_3& n, Kind kind)
  {
    shape.points.push_back({p.x(), p.y(), p.z()});
    shape.normals.push_back({n.x(), n.y(), n.z()});
    shape.scalars.push_back(double(kind));
  };
  const auto add_triangle = [&]
  {
    const std::size_t n = shape.points.size();
    shape.triangles.push_back({n - 3, n - 2, n - 1});
  };
  const auto normals = get(CGAL::dynamic_vertex_property_t<Kernel::Vector_3>(), mesh);
  SC::vertex_normals(mesh, normals);
  for(const auto f : mesh.faces())
  {
    std::array<Mesh::Vertex_index, 3> corners;
    std::size_t k = 0;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners[k++] = v;
    const bool is_of_one_kind = kinds[std::size_t(corners[0])] == kinds[std::size_t(corners[1])] &&
                                kinds[std::size_t(corners[0])] == kinds[std::size_t(corners[2])];
    for(const auto v : corners)
      add_corner(mesh.point(v).transform(head.transformation), get(normals, v).transform(head.transformation),
                 is_of_one_kind ? kinds[std::size_t(v)] : SKIN);
    add_triangle();
  }

  constexpr int steps = 8;
  const auto on_ball = [](int i, int j)
  {
    const double t = CGAL_PI * i / steps, s = CGAL_PI * j / steps;
    return Kernel::Vector_3(std::sin(t) * std::cos(s), std::cos(t), -std::sin(t) * std::sin(s));
  };
  const double size = std::cbrt(
      std::abs(head.transformation.m(0, 0) * (head.transformation.m(1, 1) * head.transformation.m(2, 2) -
                                              head.transformation.m(1, 2) * head.transformation.m(2, 1)) -
               head.transformation.m(0, 1) * (head.transformation.m(1, 0) * head.transformation.m(2, 2) -
                                              head.transformation.m(1, 2) * head.transformation.m(2, 0)) +
               head.transformation.m(0, 2) * (head.transformation.m(1, 0) * head.transformation.m(2, 1) -
                                              head.transformation.m(1, 1) * head.transformation.m(2, 0))));
  for(const auto& p : head.points)
  {
    if(!p.is_found)
      continue;
    const Kernel::Point_3 center = p.position.transform(head.transformation);
    const Kind kind = p.confidence < .5 ? DOUBTFUL_FEATURE : FEATURE;
    for(int i = 0; i < steps; ++i)
      for(int j = 0; j < 2 * steps; ++j)
        for(const auto& t : {std::array{std::pair(i, j), std::pair(i + 1, j), std::pair(i + 1, j + 1)},
                             std::array{std::pair(i, j), std::pair(i + 1, j + 1), std::pair(i, j + 1)}})
        {
          for(const auto& [a, b] : t)
            add_corner(center + .0085 * size * head.head_height * on_ball(a, b), on_ball(a, b), kind);
          add_triangle();
        }
  }
  return shape;
}

support::Image picture(const Mesh& mesh, const Head& head, const std::string& title)
{
  support::Mesh_renderer renderer;
  const support::Drawable shape = drawable(mesh, head);
  support::Contact_sheet sheet(title);
  const auto add = [&](const support::Vector& towards_eye, const std::string& caption)
  {
    support::Render_options options;
    options.width = options.height = 640;
    options.camera.towards_eye = towards_eye;
    options.camera.field_of_view = 12;
    options.gradient = colors();
    options.range.low = 0;
    options.range.high = number_of_kinds - 1;
    sheet.add(renderer.render(shape, options), caption);
  };
  if(!head.is_head)
  {
    add({.4, .3, 1}, "as it is in the file\n" + verdict(head));
    return sheet.image(1);
  }
  add({-1, 0, 0}, "left (x < 0)");
  add({0, 0, 1}, "front");
  add({1, 0, 0}, "right (x > 0)");
  return sheet.image(3);
}

int run(int argc, char* argv[])
{
  const Command_line c = read(argc, argv);
  const Mesh mesh = support::read_triangle_mesh(c.file);

  const Head head = detect(mesh, c);
  std::cout << c.file << " is " << verdict(head) << '\n';
  for(std::size_t k = 0; k < SC::number_of_head_features && head.is_head; ++k)
  {
    const auto& p = head.points[k];
    std::cout << SC::to_string(SC::Head_feature(k)) << ": ";
    if(p.is_found)
      std::cout << p.position << ", confidence " << p.confidence << '\n';
    else
      std::cout << "not found\n";
  }
  for(std::size_t k = 0; k < SC::number_of_head_regions && head.is_head; ++k)
    std::cout << SC::to_string(SC::Head_region(k)) << ": " << head.regions[k].vertices.size()
              << " vertices\n";

  write_json(c.out, c.file, head);
  write_points(c.points, head);
  support::write_png(c.picture, picture(mesh, head, c.file.substr(c.file.find_last_of("/\\") + 1)));
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    return run(argc, argv);
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
