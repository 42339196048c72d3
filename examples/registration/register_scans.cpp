// Two scans of one object, meshes or point sets with normals, are brought together.
//
//     register_scans source.ply target.ply --out merged.ply --picture before_after.png
//
// Without files, two scans that come with CGAL are taken.
#include "../support/Contact_sheet.h"
#include "../support/Drawable.h"
#include "../support/Mesh_renderer.h"
#include "../support/Ply_file.h"
#include "../support/Progress_bar.h"
#include "../support/data_file.h"

#include <Shape_characteristics/registration/register_partial_scans.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
using Result = SC::Registration_result<Kernel>;

namespace {

// A file with faces is a mesh, one without a point set.
struct Scan
{
  Mesh mesh;
  Point_set points;
  bool is_mesh() const { return mesh.number_of_faces() > 0; }
};

Scan read(const std::string& file_name)
{
  Scan scan;
  std::ifstream mesh_file(file_name, std::ios::binary);
  if(CGAL::IO::read_PLY(mesh_file, scan.mesh) && scan.is_mesh())
    return scan;
  std::ifstream file(file_name, std::ios::binary);
  if(!CGAL::IO::read_PLY(file, scan.points))
    throw std::runtime_error(file_name + " is no PLY file");
  return scan;
}

// any combination of a mesh and a point set will do
Result registered(const Scan& source, const Scan& target)
{
  const auto np = SC::parameters::callback(support::Progress_bar("registration"));
  if(source.is_mesh())
    return target.is_mesh() ? SC::register_partial_scans(source.mesh, target.mesh, np)
                            : SC::register_partial_scans(source.mesh, target.points, np);
  return target.is_mesh() ? SC::register_partial_scans(source.points, target.mesh, np)
                          : SC::register_partial_scans(source.points, target.points, np);
}

// adds a scan to a picture, in a colour of its own
void add(const Scan& scan,
         const CGAL::Aff_transformation_3<Kernel>& motion,
         double color,
         support::Drawable& shape)
{
  const auto add_point = [&](const Kernel::Point_3& p)
  {
    const Kernel::Point_3 q = p.transform(motion);
    shape.points.push_back({q.x(), q.y(), q.z()});
    shape.scalars.push_back(color);
  };
  const std::size_t first = shape.points.size();
  for(const auto v : scan.mesh.vertices())
    add_point(scan.mesh.point(v));
  for(const auto f : scan.mesh.faces())
  {
    std::vector<std::size_t> corners;
    for(const auto v : scan.mesh.vertices_around_face(scan.mesh.halfedge(f)))
      corners.push_back(first + std::size_t(v));
    for(std::size_t k = 2; k < corners.size(); ++k)
      shape.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
  for(const auto& i : scan.points)
    add_point(scan.points.point(i));
}

support::Drawable
both(const Scan& source, const Scan& target, const CGAL::Aff_transformation_3<Kernel>& motion)
{
  support::Drawable shape;
  add(source, motion, .15, shape);
  add(target, CGAL::Aff_transformation_3<Kernel>(CGAL::IDENTITY), .85, shape);
  if(!source.is_mesh() || !target.is_mesh())
    shape.triangles.clear(); // all are drawn as points
  return shape;
}

// the verdict, and why it isn't `SUCCESS`
std::string verdict(const Result& result)
{
  const std::string name = SC::to_string(result.verdict);
  if(result.verdict == SC::Registration_verdict::SUCCESS)
    return name;
  return name + " (" + SC::to_string(result.obstacle) + ")";
}

int run(int argc, char* argv[])
{
  std::vector<std::string> files;
  std::string out = "merged.ply", picture = "register_scans.png";
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if((argument == "--out" || argument == "--picture") && i + 1 < argc)
      (argument == "--out" ? out : picture) = argv[++i];
    else
      files.push_back(argument);
  }
  if(files.empty())
    files = {support::data_file("points_3/hippo1.ply"), support::data_file("points_3/hippo2.ply")};
  if(files.size() != 2)
    throw std::runtime_error("two files are needed");
  const Scan source = read(files[0]), target = read(files[1]);

  const Result result = registered(source, target);
  std::cout << verdict(result) << ", confidence " << result.confidence << ": "
            << 100. * result.quality.overlap << " % of the points have the other scan near, and "
            << 100. * result.quality.agreement << " % of these meet it ("
            << 100. * result.quality.expected_agreement << " % would without any error)\n"
            << result.transformation << '\n';

  support::Mesh_renderer renderer;
  support::Render_options options;
  options.width = options.height = 600;
  support::Contact_sheet sheet;
  const support::Drawable before = both(source, target, CGAL::Aff_transformation_3<Kernel>(CGAL::IDENTITY)),
                          after = both(source, target, result.transformation);
  sheet.add(renderer.render(before, options), "before");
  sheet.add(renderer.render(after, options), "after: " + verdict(result));
  support::write_png(picture, sheet.image(2));

  support::Ply_file file(after.points);
  if(!after.triangles.empty())
    file.set_triangles(after.triangles);
  file.add_scalar("scan", after.scalars);
  file.write(out);
  return result.verdict == SC::Registration_verdict::SUCCESS ? EXIT_SUCCESS : EXIT_FAILURE;
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
