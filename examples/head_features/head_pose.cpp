// Finds out whether a mesh is a head and in which pose, and writes the head in the frame of the thesis: nose towards +z, top
// towards +y, the plane of symmetry at x = 0.
//
//     head_pose head.ply --out aligned.ply --picture head_pose.png
//
// In the picture (before; from the front; from the side), the sides of the plane of symmetry and the tip of the nose have
// colours.
#include "../support/Contact_sheet.h"
#include "../support/Drawable.h"
#include "../support/Mesh_renderer.h"
#include "../support/Ply_file.h"
#include "../support/Progress_bar.h"
#include "../support/data_file.h"

#include <Shape_characteristics/head_features/estimate_head_pose.h>
#include <Shape_characteristics/head_features/nose_tip_candidates.h>

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
using Pose = SC::Head_pose<Kernel>;

namespace {

// the verdict, and why it isn't `HEAD`
std::string verdict(const Pose& pose)
{
  const std::string name = SC::to_string(pose.verdict);
  if(pose.verdict == SC::Head_verdict::HEAD)
    return name;
  return name + " (" + SC::to_string(pose.obstacle) + ")";
}

support::Drawable
drawing(const Mesh& mesh, const Pose& pose, const CGAL::Aff_transformation_3<Kernel>& transformation)
{
  support::Drawable shape;
  for(const auto v : mesh.vertices())
  {
    const Kernel::Point_3 p = mesh.point(v).transform(transformation);
    shape.points.push_back({p.x(), p.y(), p.z()});
    const bool is_tip = CGAL::squared_distance(mesh.point(v), pose.nose_tip) < .0004 * pose.size * pose.size;
    shape.scalars.push_back(is_tip ? 1. : pose.symmetry_plane.has_on_positive_side(mesh.point(v)) ? .6 : .3);
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
  std::string file, out = "aligned.ply", picture = "head_pose.png";
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if((argument == "--out" || argument == "--picture") && i + 1 < argc)
      (argument == "--out" ? out : picture) = argv[++i];
    else
      file = argument;
  }
  if(file.empty())
    file = support::data_file("meshes/mannequin-devil.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("not a mesh: " + file);

  const Pose pose = SC::estimate_head_pose(mesh, SC::parameters::callback(support::Progress_bar("pose")));
  std::cout << verdict(pose) << ", confidence " << pose.confidence << '\n'
            << "to the frame of the head:\n"
            << pose.transformation << '\n'
            << "tip of the nose: " << pose.nose_tip << '\n';
  // the thesis's way to tell the nose from ears, chin and the like
  std::size_t on_plane = 0;
  const auto candidates = SC::nose_tip_candidates(mesh);
  for(const auto& candidate : candidates)
    on_plane += candidate.asymmetry < .08;
  std::cout << candidates.size() << " places stand out like the tip of a nose, " << on_plane
            << " of them on the plane of symmetry\n";

  const CGAL::Aff_transformation_3<Kernel> as_it_is(CGAL::IDENTITY),
      to_the_side(0., 0., -1., 0., 0., 1., 0., 0., 1., 0., 0., 0.);
  const support::Drawable aligned = drawing(mesh, pose, pose.transformation);
  support::Mesh_renderer renderer;
  support::Render_options options;
  options.width = options.height = 500;
  options.camera.towards_eye = {0., 0., 1.};
  options.range = {0., 1.};
  support::Contact_sheet sheet;
  sheet.add(renderer.render(drawing(mesh, pose, as_it_is), options), "as it is");
  sheet.add(renderer.render(aligned, options), verdict(pose));
  sheet.add(renderer.render(drawing(mesh, pose, to_the_side * pose.transformation), options),
            "from the side");
  support::write_png(picture, sheet.image(3));

  support::Ply_file ply(aligned.points);
  ply.set_triangles(aligned.triangles);
  ply.write(out);
  return pose.verdict == SC::Head_verdict::NOT_A_HEAD ? EXIT_FAILURE : EXIT_SUCCESS;
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
