// Finds the plane of symmetry of a shape, says how much of the surface agrees with it, and writes a picture: the sides of the
// plane have colours of their own.
//
//     symmetry_plane shape.off --picture symmetry_plane.png
#include "../support/Contact_sheet.h"
#include "../support/Drawable.h"
#include "../support/Mesh_renderer.h"
#include "../support/data_file.h"

#include <Shape_characteristics/head_features/detect_symmetry_plane.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

const char* name(SC::Symmetry_verdict verdict)
{
  switch(verdict)
  {
  case SC::Symmetry_verdict::ONE:
    return "one plane";
  case SC::Symmetry_verdict::SEVERAL:
    return "several planes";
  default:
    return "no plane";
  }
}

support::Drawable drawing(const Mesh& mesh, const Kernel::Plane_3& plane)
{
  support::Drawable shape;
  for(const auto v : mesh.vertices())
  {
    const Kernel::Point_3& p = mesh.point(v);
    shape.points.push_back({p.x(), p.y(), p.z()});
    shape.scalars.push_back(plane.has_on_positive_side(p) ? .8 : .2);
  }
  for(const auto f : mesh.faces())
  {
    std::vector<std::size_t> corners;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(std::size_t(v));
    for(std::size_t k = 2; k < corners.size(); ++k)
      shape.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
  return shape;
}

int run(int argc, char* argv[])
{
  std::string file, picture = "symmetry_plane.png";
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if(argument == "--picture" && i + 1 < argc)
      picture = argv[++i];
    else
      file = argument;
  }
  if(file.empty())
    file = support::data_file("meshes/mannequin-devil.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("not a mesh: " + file);

  const auto symmetry = SC::detect_symmetry_plane(mesh);
  std::cout << name(symmetry.verdict) << ", confidence " << symmetry.confidence << '\n';
  const auto print = [](const auto& candidate)
  {
    std::cout << candidate.plane << ": " << 100. * candidate.support
              << " % of the surface has its image within " << candidate.deviation
              << " of the surface (median)\n";
  };
  print(symmetry.best);
  for(const auto& candidate : symmetry.alternatives)
    print(candidate);

  support::Mesh_renderer renderer;
  support::Render_options options;
  options.width = options.height = 600;
  options.range = {0., 1.};
  support::Contact_sheet sheet;
  sheet.add(renderer.render(drawing(mesh, symmetry.best.plane), options), name(symmetry.verdict));
  support::write_png(picture, sheet.image(1));
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
