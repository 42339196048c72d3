// Signals that change their sign when a surface is mirrored: the two halves of a symmetric object differ by them.
#include <Shape_characteristics/descriptors/chiralities.h>
#include <Shape_characteristics/descriptors/signed_volumes.h>
#include <Shape_characteristics/descriptors/symmetry_fluxes.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SC = Shape_characteristics;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// A height field over [-1, 1]^2 that the plane x = 0 maps to itself; vertex (i, j) has the mirror image (n - i, j).
constexpr int n = 60;

std::size_t number(int i, int j)
{
  return std::size_t(i * (n + 1) + j);
}

Mesh symmetric_mesh()
{
  Mesh mesh;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
    {
      const double x = 2. * i / n - 1., y = 2. * j / n - 1., side = std::abs(x) - .5;
      const double bump =
          std::exp(-20. * (side * side + y * y)); // an ear on each side, which a ramp makes uneven
      mesh.add_vertex(Kernel::Point_3(x, y, .2 * bump * (1. + 3. * y) + .3 * std::cos(x) * y * y));
    }
  const auto vertex = [](int i, int j) { return Mesh::Vertex_index(std::uint32_t(number(i, j))); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      if(i < n / 2) // diagonals are mirrored as well
      {
        mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
      else
      {
        mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        mesh.add_face(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
  return mesh;
}

// whether the signal has opposite signs, and the same size, at mirror images of each other
bool is_odd(const std::string& name, const SC::Descriptor_matrix& signal)
{
  const float tolerance = 1e-3f * signal.values.array().abs().maxCoeff();
  std::size_t opposite = 0, all = 0;
  float mean = 0;
  for(int i = 10; i < n / 2; ++i)
    for(int j = 10; j <= n - 10; ++j)
    {
      const float a = signal.values(Eigen::Index(number(i, j)), 0);
      const float b = signal.values(Eigen::Index(number(n - i, j)), 0);
      opposite += std::abs(a + b) <= tolerance;
      ++all;
      mean += std::abs(a);
    }
  std::cout << name << ": opposite at " << opposite << " of " << all
            << " pairs of mirror images, mean absolute value " << mean / float(all) << '\n';
  return opposite > 9 * all / 10;
}

int main()
{
  const Mesh mesh = symmetric_mesh();
  const auto np = SC::parameters::neighbor_radius(.3);

  bool is_right = is_odd("flux", SC::symmetry_fluxes(mesh, np));
  is_right &= is_odd("flux through triangles",
                     SC::symmetry_fluxes(mesh, np.flux_method(SC::Flux_method::CLIPPED_TRIANGLES)));
  is_right &= is_odd("signed volume by mean curvature", SC::signed_volumes(mesh, np));
  is_right &= is_odd("signed volume by bins",
                     SC::signed_volumes(mesh, np.signed_volume_method(SC::Signed_volume_method::BINS)));
  is_right &= is_odd("chirality", SC::chiralities(mesh, np));
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
