// A head gets another expression or shape, by its feature points.
//
//     deform_head head.ply --expression smile --out smiled.ply --picture before_after.png
//     deform_head head.ply --expression longer_chin --intensity 0.5 --rigid
//     deform_head head.ply                      all expressions in one picture
//
// Expressions: smile, sad, wide_mouth, longer_ear_lobe, longer_chin, bigger_nose. With --rigid, the surface stays as rigid as
// possible where it can; with --aligned, the nose points towards +z and the top towards +y.
//
// Without a file, a head that comes with CGAL is taken, whose feature points were set by hand. It has no ears.
#include "../support/Contact_sheet.h"
#include "../support/Drawable.h"
#include "../support/Mesh_renderer.h"
#include "../support/Ply_file.h"
#include "../support/data_file.h"
#include "../support/drawable_mesh.h"
#include "../support/read_triangle_mesh.h"

#include <Shape_characteristics/head_features/deform_as_rigid_as_possible.h>
#include <Shape_characteristics/head_features/deform_by_handles.h>
#include <Shape_characteristics/head_features/detect_head_features.h>
#include <Shape_characteristics/head_features/head_expression_handles.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Features = SC::Head_features<Mesh, Kernel>;

namespace {

struct Command_line
{
  std::string file, out = "deform_head.ply", picture = "deform_head.png";
  std::vector<SC::Head_expression> expressions; // all of them if empty
  double intensity = 1.;
  bool is_rigid = false, is_aligned = false;
};

SC::Head_expression parse(std::string name)
{
  for(char& c : name)
    c = char(std::toupper(static_cast<unsigned char>(c)));
  for(std::size_t i = 0; i < SC::number_of_head_expressions; ++i)
    if(name == SC::to_string(SC::Head_expression(i)))
      return SC::Head_expression(i);
  throw std::invalid_argument("there is no expression " + name);
}

// "smile", "longer ear lobe"
std::string caption(SC::Head_expression expression)
{
  std::string name = SC::to_string(expression);
  for(char& c : name)
    c = c == '_' ? ' ' : char(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

Command_line read(int argc, char* argv[])
{
  Command_line c;
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if((argument == "--out" || argument == "--picture") && i + 1 < argc)
      (argument == "--out" ? c.out : c.picture) = argv[++i];
    else if(argument == "--expression" && i + 1 < argc)
      c.expressions.push_back(parse(argv[++i]));
    else if(argument == "--intensity" && i + 1 < argc)
      c.intensity = std::stod(argv[++i]);
    else if(argument == "--rigid")
      c.is_rigid = true;
    else if(argument == "--aligned")
      c.is_aligned = true;
    else if(c.file.empty() && argument[0] != '-')
      c.file = argument;
    else
      throw std::invalid_argument("'" + argument +
                                  "' is not understood; see the first lines of deform_head.cpp");
  }
  return c;
}

// Feature points may be set by hand as well: these are vertices of CGAL's head.off.
Features set_by_hand(const Mesh& mesh)
{
  using F = SC::Head_feature;
  const std::vector<std::pair<F, std::uint32_t>> vertices = {
      {F::NOSE_TIP, 923}, {F::N1, 798}, {F::N2, 923},   {F::N4, 1089},     {F::M1, 590},      {F::M2, 691},
      {F::M3, 672},       {F::M4, 666}, {F::CHIN, 832}, {F::LEFT_E2, 411}, {F::RIGHT_E2, 499}};
  Features head;
  head.is_head = true;
  head.transformation = // the nose points towards -x, the top towards +y
      CGAL::Aff_transformation_3<Kernel>(0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0);
  for(const auto& [feature, number] : vertices)
  {
    const Mesh::Vertex_index v(number);
    head[feature] = {true, mesh.point(v), v, 1.};
  }
  return head;
}

void write_ply(const std::string& file_name, const Mesh& mesh)
{
  const support::Drawable shape = support::drawable_mesh(mesh);
  support::Ply_file file(shape.points);
  file.set_triangles(shape.triangles);
  file.write(file_name);
}

int run(int argc, char* argv[])
{
  Command_line c = read(argc, argv);
  const bool is_ours = c.file.empty();
  const Mesh mesh = support::read_triangle_mesh(is_ours ? support::data_file("meshes/head.off") : c.file);
  const Features head = is_ours
                            ? set_by_hand(mesh)
                            : SC::detect_head_features(mesh, SC::parameters::head_is_aligned(c.is_aligned));
  if(!head.is_head)
    throw std::runtime_error(c.file + " is not a head");
  const bool is_asked = !c.expressions.empty();
  for(std::size_t i = 0; !is_asked && i < SC::number_of_head_expressions; ++i)
    c.expressions.push_back(SC::Head_expression(i));

  // seen from the front and a little from the side, in the head's own frame
  support::Mesh_renderer renderer;
  support::Render_options options;
  options.width = 420;
  options.height = 520;
  const auto back = head.transformation.inverse();
  const Kernel::Vector_3 eye = back.transform(Kernel::Vector_3(.35, .05, 1)),
                         up = back.transform(Kernel::Vector_3(0, 1, 0));
  options.camera.towards_eye = {eye.x(), eye.y(), eye.z()};
  options.camera.up = {up.x(), up.y(), up.z()};
  support::Contact_sheet sheet;
  sheet.add(renderer.render(support::drawable_mesh(mesh), options), "before");

  bool is_written = false;
  for(const SC::Head_expression expression : c.expressions)
  {
    Mesh deformed = mesh;
    try
    {
      const auto handles = SC::head_expression_handles(expression, head, c.intensity);
      const std::size_t moved = c.is_rigid ? SC::deform_as_rigid_as_possible(deformed, handles)
                                           : SC::deform_by_handles(deformed, handles);
      std::cout << caption(expression) << ": " << moved << " vertices moved\n";
    }
    catch(const std::invalid_argument& e) // a feature point that is needed isn't there
    {
      if(is_asked)
        throw;
      std::cout << caption(expression) << ": " << e.what() << '\n';
      continue;
    }
    sheet.add(renderer.render(support::drawable_mesh(deformed), options), caption(expression));
    if(!is_written) // of several expressions, the first
      write_ply(c.out, deformed);
    is_written = true;
  }
  support::write_png(c.picture, sheet.image(c.expressions.size() > 2 ? 4 : 0));
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
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
