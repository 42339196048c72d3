// SHOT descriptors find the vertices of a mesh again on a copy of it that was moved.
#include <Shape_characteristics/descriptors/shot_descriptors.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace SC = Shape_characteristics;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// the row of `descriptors` that is nearest to `row`
std::size_t nearest(const SC::Descriptor_matrix& descriptors, const Eigen::RowVectorXf& row)
{
  std::size_t best = 0;
  float smallest = 4; // of unit vectors, no squared distance is larger
  for(std::size_t i = 0; i < descriptors.status.size(); ++i)
    if(SC::is_estimated(descriptors.status[i]))
    {
      const float distance = (descriptors.values.row(Eigen::Index(i)) - row).squaredNorm();
      if(distance < smallest)
      {
        smallest = distance;
        best = i;
      }
    }
  return best;
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << '\n';
    return EXIT_FAILURE;
  }
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double size = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());

  // a quarter turn, three times as large
  Mesh moved = mesh;
  PMP::transform(Kernel::Aff_transformation_3(0, -3, 0, 1, 3, 0, 0, 2, 0, 0, 3, 4), moved);

  // some vertices of the one, all of the other
  std::vector<std::size_t> some;
  for(std::size_t i = 0; i < num_vertices(mesh); i += 10)
    some.push_back(i);
  const auto np = SC::parameters::neighbor_radius(0.08 * size);
  const SC::Descriptor_matrix here = SC::shot_descriptors(mesh, np.descriptor_samples(some));
  const SC::Descriptor_matrix there =
      SC::shot_descriptors(moved, SC::parameters::neighbor_radius(3 * 0.08 * size));

  std::size_t described = 0, found = 0;
  for(std::size_t k = 0; k < some.size(); ++k)
    if(SC::is_estimated(here.status[k]))
    {
      ++described;
      found += nearest(there, here.values.row(Eigen::Index(k))) == some[k];
    }
  std::cout << found << " of " << described << " vertices found again\n";
  return described > 0 && found > 95 * described / 100 ? EXIT_SUCCESS : EXIT_FAILURE;
}
