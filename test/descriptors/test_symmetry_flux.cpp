#include <boost/test/unit_test.hpp>

#include "height_field.h"
#include "oriented_cloud.h"

#include <Shape_characteristics/descriptors/compute_descriptors.h>
#include <Shape_characteristics/descriptors/symmetry_fluxes.h>
#include <Shape_characteristics/normals/sampled_surface.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include "analytic_surfaces.h"
#include "build_mesh.h"

#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(symmetry_flux)

// The flux through the triangles of meshes; test_symmetry_signals.cpp has that of points.
using namespace oriented_cloud;
using height_field_test::height_field;
using height_field_test::Kernel;
using height_field_test::Mesh;
using height_field_test::wave;
using SC::Estimation_status;
using SC::Flux_method;
using SC::Signal_scaling;

namespace {

template <typename Descriptor, typename Surface, typename... Arguments>
SC::Descriptor_matrix compute(const Surface& surface, const Arguments&... arguments)
{
  return SC::compute_descriptors<CGAL::Sequential_tag>(Descriptor(surface, arguments...), surface.size());
}

} // namespace

// Rulings are the border of z = c x y over a rectangle, so that the flux is that of the smooth surface, however the inside is
// triangulated.
BOOST_AUTO_TEST_CASE(flux_through_a_ruled_patch)
{
  const double a = 1., b = .7, c = .4;
  const double expected = 4. * a * b * c * (b * b - a * a) / 3.;
  for(const double sign : {1., -1.}) // and its mirror image
  {
    Mesh mesh = height_field(a, b, 8, [&](double x, double y) { return sign * c * x * y; });
    std::mt19937 generator(11);
    for(int pass = 0; pass < 2; ++pass)
    {
      for(const Flux_method method : {Flux_method::CLIPPED_TRIANGLES, Flux_method::BOUNDARY})
      {
        SC::Face_graph_samples s(mesh, mesh.points(), SC::Neighborhood::ball(10.));
        s.set_normals(std::vector<Vector3d>(s.size(), Vector3d(0., 0., 1.)));
        const SC::Descriptor_matrix flux = compute<SC::Symmetry_flux_descriptor<SC::Face_graph_samples> >(
            s, method, Signal_scaling::AS_PRINTED);
        BOOST_TEST(std::abs(double(flux.values(40, 0)) - sign * expected) < 1e-7);
        const SC::Descriptor_matrix unit_free =
            compute<SC::Symmetry_flux_descriptor<SC::Face_graph_samples> >(s, method);
        BOOST_TEST(std::abs(1e3 * double(unit_free.values(40, 0)) - sign * expected) < 1e-7);
      }
      // noise inside, but for the middle
      for(const auto v : mesh.vertices())
        if(!mesh.is_border(v) && v.idx() != 40)
        {
          const auto noise = [&] { return .02 * double(generator()) / 4294967296.; };
          const double dx = noise(), dy = noise(), dz = noise();
          mesh.point(v) = mesh.point(v) + Kernel::Vector_3(dx, dy, dz);
        }
    }
  }
}

// where the border of the mesh is outside the ball, the flux is zero
BOOST_AUTO_TEST_CASE(flux_within_the_border_is_zero)
{
  using Mesh_flux = SC::Symmetry_flux_descriptor<SC::Face_graph_samples>;
  for(const test_support::Analytic_surface& surface :
      {test_support::ellipsoid(1., .8, .6, 3, .2, 5), test_support::torus(1., .4, 32, 16, .2, 6)})
  {
    const Mesh mesh = test_support::build_mesh<Mesh>(surface);
    for(const double r : {.2, .3, .5})
    {
      const SC::Face_graph_samples s = SC::sampled_surface<CGAL::Sequential_tag>(
          mesh, SC::Neighborhood::ball(r), SC::parameters::default_values(),
          SC::Face_graph_samples::Connectivity::NEIGHBORS_AND_FACES);
      for(const Flux_method method : {Flux_method::CLIPPED_TRIANGLES, Flux_method::BOUNDARY})
      {
        const SC::Descriptor_matrix flux = compute<Mesh_flux>(s, method);
        BOOST_TEST(number_of(Estimation_status::ESTIMATED, flux) > 0u);
        BOOST_TEST((flux.values.array().isNaN() || flux.values.array().abs() < 1e-15f).all());
      }
      // unlike the sum over points
      const SC::Descriptor_matrix sum = compute<Mesh_flux>(s);
      BOOST_TEST((sum.values.array().abs() > 1e-2f).any());
    }
  }
}

// at the border, the two say the same, and what a fine subdivision says
BOOST_AUTO_TEST_CASE(flux_at_the_border)
{
  using Mesh_flux = SC::Symmetry_flux_descriptor<SC::Face_graph_samples>;
  const Mesh mesh = height_field(1., 1., 12, wave);
  for(const double r : {.3, .6})
  {
    const SC::Face_graph_samples s = SC::sampled_surface<CGAL::Sequential_tag>(
        mesh, SC::Neighborhood::ball(r), SC::parameters::default_values(),
        SC::Face_graph_samples::Connectivity::NEIGHBORS_AND_FACES);
    const SC::Descriptor_matrix through = compute<Mesh_flux>(s, Flux_method::CLIPPED_TRIANGLES),
                                along = compute<Mesh_flux>(s, Flux_method::BOUNDARY);
    BOOST_TEST(is_consistent(through));
    BOOST_TEST(number_of(Estimation_status::BORDER, through) == 48u);
    BOOST_TEST(difference(through, along) < 1e-7);
    BOOST_TEST(through.values.array().abs().maxCoeff() > .05f);
    for(const std::size_t i : {0u, 3u, 14u, 30u, 84u})
    {
      constexpr int parts = 60;
      double sum = 0.;
      for(std::size_t f = 0; f < s.number_of_faces(); ++f)
      {
        const Vector3d p = s.point(s.vertex(f, 0)), u = (s.point(s.vertex(f, 1)) - p) / parts,
                       v = (s.point(s.vertex(f, 2)) - p) / parts;
        for(int k = 0; k < parts; ++k)
          for(int l = 0; k + l < parts; ++l)
            for(int half = 0; half < (k + l + 1 < parts ? 2 : 1); ++half)
            {
              const double shift = half == 0 ? 1. / 3. : 2. / 3.;
              const Vector3d d = p + (k + shift) * u + (l + shift) * v - s.point(i);
              if(d.norm() <= r)
                sum -= .5 * d.cross(s.normal(i)).dot(u.cross(v));
            }
      }
      BOOST_TEST(std::abs(double(through.values(Eigen::Index(i), 0)) - sum / (r * r * r)) < 2e-3);
    }
  }
}

// a second sheet in the ball, of which the vertex knows nothing
BOOST_AUTO_TEST_CASE(flux_of_the_connected_part)
{
  Mesh mesh = height_field(1., 1., 8, wave);
  const std::size_t size = num_vertices(mesh);
  const auto np = SC::parameters::neighbor_radius(.5).flux_method(Flux_method::CLIPPED_TRIANGLES);
  const SC::Descriptor_matrix alone = SC::symmetry_fluxes(mesh, np);
  mesh += height_field(1., 1., 8, [](double x, double y) { return wave(x, y) + .01; });
  SC::Descriptor_matrix both = SC::symmetry_fluxes(mesh, np);
  both.values.conservativeResize(Eigen::Index(size), Eigen::NoChange);
  both.status.resize(size);
  BOOST_TEST(same_bits(both, alone));
}

BOOST_AUTO_TEST_CASE(functions)
{
  const auto np = SC::parameters::neighbor_radius(.4);
  Mesh mesh = height_field(1., 1., 20, wave), mirror = mesh;
  for(const auto v : mirror.vertices())
    mirror.point(v) = Kernel::Point_3(-mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  CGAL::Polygon_mesh_processing::reverse_face_orientations(mirror);
  for(const Flux_method method : {Flux_method::POINTS, Flux_method::CLIPPED_TRIANGLES, Flux_method::BOUNDARY})
  {
    const SC::Descriptor_matrix flux =
        SC::symmetry_fluxes<CGAL::Sequential_tag>(mesh, np.flux_method(method));
    BOOST_TEST(
        same_bits(SC::symmetry_fluxes<CGAL::Parallel_if_available_tag>(mesh, np.flux_method(method)), flux));
    SC::Descriptor_matrix negative = flux;
    negative.values = -negative.values;
    BOOST_TEST(difference(SC::symmetry_fluxes(mirror, np.flux_method(method)), negative) < 1e-6);
  }

  // other faces than triangles
  Mesh square;
  const auto a = square.add_vertex(Kernel::Point_3(0, 0, 0)), b = square.add_vertex(Kernel::Point_3(1, 0, 0)),
             c = square.add_vertex(Kernel::Point_3(1, 1, 0)), d = square.add_vertex(Kernel::Point_3(0, 1, 0));
  square.add_face(a, b, c, d);
  BOOST_TEST(is_consistent(SC::symmetry_fluxes(square)));
  BOOST_CHECK_THROW(SC::symmetry_fluxes(square, SC::parameters::flux_method(Flux_method::BOUNDARY)),
                    std::invalid_argument);
  // faces that were forgotten
  const SC::Face_graph_samples forgotten =
      SC::sampled_surface<CGAL::Sequential_tag>(mesh, SC::Neighborhood::ball(.4));
  BOOST_CHECK_THROW(
      SC::Symmetry_flux_descriptor<SC::Face_graph_samples>(forgotten, Flux_method::CLIPPED_TRIANGLES),
      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(bad_inputs)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for(const Flux_method method : {Flux_method::POINTS, Flux_method::CLIPPED_TRIANGLES})
    BOOST_TEST(SC::symmetry_fluxes(Mesh(), SC::parameters::flux_method(method)).values.rows() == 0);

  // a mesh with a vertex that isn't finite and one without faces
  Mesh mesh = height_field(1., 1., 8, wave);
  mesh.point(Mesh::Vertex_index(40)) = Kernel::Point_3(nan, 0., 0.);
  mesh.add_vertex(Kernel::Point_3(0., 0., 0.));
  for(const Flux_method method : {Flux_method::POINTS, Flux_method::CLIPPED_TRIANGLES, Flux_method::BOUNDARY})
  {
    const SC::Descriptor_matrix m =
        SC::symmetry_fluxes(mesh, SC::parameters::neighbor_radius(.5).flux_method(method));
    BOOST_TEST(is_consistent(m));
    BOOST_TEST((m.status[40] == Estimation_status::NON_FINITE_INPUT));
    BOOST_TEST((m.status[81] == Estimation_status::UNREFERENCED));
    BOOST_TEST(number_of(Estimation_status::ESTIMATED, m) + number_of(Estimation_status::BORDER, m) == 80u);
  }

  // areas that are none say nothing of symmetry
  const Mesh whole = height_field(1., 1., 8, wave);
  const SC::Face_graph_samples s =
      SC::sampled_surface<CGAL::Sequential_tag>(whole, SC::Neighborhood::ball(.5));
  for(const double area : {0., -1., nan})
  {
    const SC::Descriptor_matrix m = compute<SC::Symmetry_flux_descriptor<SC::Face_graph_samples> >(
        s, Flux_method::POINTS, Signal_scaling::UNIT_FREE, std::vector<double>(s.size(), area));
    BOOST_TEST(is_consistent(m));
    BOOST_TEST(number_of(Estimation_status::FEW_NEIGHBOURS, m) == s.size());
  }
}

BOOST_AUTO_TEST_SUITE_END()
