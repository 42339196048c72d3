#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/screen_space/OpenGL/G_buffer_renderer.h>
#include <Shape_characteristics/screen_space/OpenGL/Screen_space_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/Sphere_fit_mean_curvature_pass.h>
#include <Shape_characteristics/screen_space/OpenGL/read_g_buffer.h>
#include <Shape_characteristics/screen_space/OpenGL/read_screen_space_curvatures.h>
#include <Shape_characteristics/screen_space/screen_space_curvatures.h>
#include <Shape_characteristics/screen_space/sphere_fit_mean_curvatures.h>

#include "../../examples/support/Offscreen_context.h"
#include "analytic_scenes.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/number_type_config.h>
#include <CGAL/subdivision_method_3.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(screen_space_gpu)

namespace SC = Shape_characteristics;
using test_support::camera_at;
using test_support::Cylinder;
using test_support::map_of;
using test_support::Picture;
using test_support::Plane;
using test_support::quantile;
using test_support::Sphere;
using test_support::Torus;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Rule = SC::Depth_discontinuity_rule;
using Status = SC::Estimation_status;

namespace {

const float no_number = std::numeric_limits<float>::quiet_NaN();

support::Offscreen_context& context()
{
  static support::Offscreen_context c;
  c.make_current();
  return c;
}

// A picture on the GPU, with the depths in a float texture.
class Uploaded
{
public:
  explicit Uploaded(const SC::G_buffer& g)
  {
    context();
    glGenTextures(2, m_names);
    std::vector<float> depths(g.size()), normals;
    for(std::size_t i = 0; i < g.size(); ++i)
    {
      depths[i] = g.depth(i);
      const Eigen::Vector3f n = g.normal(i);
      normals.insert(normals.end(), {n.x(), n.y(), n.z()});
    }
    glBindTexture(GL_TEXTURE_2D, m_names[0]);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_R32F, g.width(), g.height());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, g.width(), g.height(), GL_RED, GL_FLOAT, depths.data());
    glBindTexture(GL_TEXTURE_2D, m_names[1]);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, g.width(), g.height());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, g.width(), g.height(), GL_RGB, GL_FLOAT, normals.data());
    glBindTexture(GL_TEXTURE_2D, 0);
  }
  ~Uploaded() { glDeleteTextures(2, m_names); }
  Uploaded(const Uploaded&) = delete;
  Uploaded& operator=(const Uploaded&) = delete;

  SC::G_buffer_textures textures(const SC::G_buffer& g) const
  {
    return {g.width(), g.height(), m_names[0], m_names[1], g.camera(), g.normal_space()};
  }

private:
  GLuint m_names[2];
};

struct Curvatures
{
  std::vector<float> low, high, shape_index;
  std::vector<Status> statuses;
  std::size_t failures = 0;

  explicit Curvatures(std::size_t n) : low(n, 7.f), high(n, 7.f), shape_index(n, 7.f), statuses(n) {}
  auto maps()
  {
    return SC::parameters::min_curvature_map(map_of(low))
        .max_curvature_map(map_of(high))
        .shape_index_map(map_of(shape_index))
        .status_map(map_of(statuses));
  }
};

// The stated bound: principal curvatures agree to 2^-18 of the sum of their own size and of 1 / (distance of neighboring pixels in
// the scene), and 999 of 1000 to 2^-20. Without the rule of tangent planes there are triangles that span surfaces, seen nearly from their
// sides, where rounding counts more.
void check_agreement(const SC::G_buffer& g,
                     const Curvatures& cpu,
                     const Curvatures& gpu,
                     const std::string& what,
                     bool surfaces_are_told_apart = true)
{
  BOOST_TEST_CONTEXT(what)
  {
    BOOST_TEST(cpu.failures == gpu.failures);
    std::vector<double> differences;
    std::size_t other_statuses = 0, nan_mismatches = 0, wrong_indices = 0;
    const auto& p = g.camera().projection();
    const double pixel = std::sqrt(4. / (double(g.width()) * g.height() * std::abs(p(0, 0) * p(1, 1))));
    for(std::size_t i = 0; i < g.size(); ++i)
    {
      other_statuses += cpu.statuses[i] != gpu.statuses[i];
      nan_mismatches += std::isnan(cpu.low[i]) != std::isnan(gpu.low[i]) ||
                        std::isnan(gpu.low[i]) == SC::is_estimated(gpu.statuses[i]);
      wrong_indices += std::isnan(cpu.shape_index[i]) != std::isnan(gpu.shape_index[i]);
      if(!SC::is_estimated(cpu.statuses[i]) || cpu.statuses[i] != gpu.statuses[i])
        continue;
      const double footprint =
          pixel * (g.camera().is_perspective() ? g.camera().distance(double(g.depth(i))) : 1.);
      const double size = 1. / footprint + (std::max)(std::abs(cpu.low[i]), std::abs(cpu.high[i]));
      differences.push_back(std::abs(double(cpu.low[i]) - gpu.low[i]) / size);
      differences.push_back(std::abs(double(cpu.high[i]) - gpu.high[i]) / size);
    }
    BOOST_TEST(other_statuses == 0u);
    BOOST_TEST(nan_mismatches == 0u);
    BOOST_TEST(wrong_indices == 0u);
    BOOST_TEST(!differences.empty());
    const double largest = quantile(differences, 1.), median = quantile(differences, .5);
    BOOST_TEST_MESSAGE(what << ": median " << median * std::ldexp(1., 24) << ", largest "
                            << largest * std::ldexp(1., 24) << " 2^-24");
    BOOST_TEST(quantile(differences, surfaces_are_told_apart ? .999 : .99) <= std::ldexp(1., -20));
    if(surfaces_are_told_apart)
      BOOST_TEST(largest <= std::ldexp(1., -18));
  }
}

template <typename NamedParameters>
void compare(const SC::G_buffer& g,
             const SC::G_buffer_textures& textures,
             const NamedParameters& np,
             const std::string& what,
             bool surfaces_are_told_apart = true)
{
  Curvatures cpu(g.size());
  cpu.failures = SC::screen_space_curvatures(g, np.min_curvature_map(map_of(cpu.low))
                                                    .max_curvature_map(map_of(cpu.high))
                                                    .shape_index_map(map_of(cpu.shape_index))
                                                    .status_map(map_of(cpu.statuses)));
  for(const SC::Shader_stage stage : {SC::Shader_stage::FRAGMENT, SC::Shader_stage::COMPUTE})
  {
    SC::Screen_space_curvature_pass pass(stage);
    Curvatures gpu(g.size());
    gpu.failures = SC::read_screen_space_curvatures(pass(textures, np), g.width(), g.height(), gpu.maps());
    check_agreement(g, cpu, gpu, what + (stage == SC::Shader_stage::FRAGMENT ? ", fragments" : ", compute"),
                    surfaces_are_told_apart);
  }
}

// an uneven width and height, so that groups of pixels are cut
Picture scene(double distance, const std::string& name)
{
  Picture picture(173, 131, camera_at(distance, 1.5, 173. / 131.));
  if(name == "sphere")
    picture.add(Sphere());
  else if(name == "cylinder")
    picture.add(Cylinder());
  else
    picture.add(Plane{Eigen::Vector3d(.3, .2, 1.).normalized(), -.5}, 1)
        .add(Torus(), 2)
        .add(Sphere{{.6, .6, .6}, .3}, 3);
  return picture;
}

} // namespace

BOOST_AUTO_TEST_CASE(analytic_scenes)
{
  for(const std::string name : {"sphere", "cylinder", "torus and sphere on a plane"})
    for(const double distance : {3., 10., 100.})
    {
      const Picture picture = scene(distance, name);
      const SC::G_buffer g = picture.g_buffer();
      const Uploaded uploaded(g);
      const std::string what = name + " at " + std::to_string(int(distance));
      compare(g, uploaded.textures(g), SC::parameters::number_of_triangles(4), what);
      compare(g, uploaded.textures(g),
              SC::parameters::level_of_detail(SC::Level_of_detail::by_length(.05)).number_of_edges(3),
              what + ", by length");
    }
}

BOOST_AUTO_TEST_CASE(all_variants)
{
  const Picture picture = scene(4., "torus and sphere on a plane");
  const SC::G_buffer g = picture.g_buffer();
  const Uploaded uploaded(g);
  int variant = 0;
  for(const int triangles : {1, 2, 3, 4})
    for(const Rule rule : {Rule::NONE, Rule::FAR_PLANE, Rule::TANGENT_PLANES})
    {
      const int edges = variant % 2 ? 3 : 2, step = variant % 5 ? 6 : 1;
      ++variant;
      compare(g, uploaded.textures(g),
              SC::parameters::number_of_triangles(triangles)
                  .number_of_edges(edges)
                  .depth_discontinuity_rule(rule)
                  .level_of_detail(SC::Level_of_detail::by_pixels(step)),
              std::to_string(triangles) + " triangles, " + std::to_string(edges) + " edges, rule " +
                  std::to_string(int(rule)) + ", step " + std::to_string(step),
              rule == Rule::TANGENT_PLANES);
    }
}

BOOST_AUTO_TEST_CASE(kinds_of_depth_and_normals)
{
  const SC::Camera usual = camera_at(4., 1.5, 1.2);
  Eigen::Matrix4d reversed = .5 * usual.projection();
  reversed.row(2) = .5 * (usual.projection().row(3) - usual.projection().row(2));
  reversed.row(3) = usual.projection().row(3);
  reversed.topRows(2) = usual.projection().topRows(2);
  for(const SC::Camera& camera :
      {SC::Camera(usual.view(), reversed, SC::Depth_convention::WINDOW_DEPTH_ZERO_TO_ONE),
       SC::Camera(usual.view(), usual.projection(), SC::Depth_convention::EYE_DISTANCE),
       SC::Camera(usual.view(), SC::Camera::orthographic(3.2, 1.2, 1., 7.))})
  {
    Picture picture = Picture(120, 100, camera).add(Torus());
    const Eigen::Matrix3f to_world = camera.view().topLeftCorner<3, 3>().transpose().cast<float>();
    for(std::size_t i = 0; i < picture.size(); ++i)
      Eigen::Map<Eigen::Vector3f>(picture.normals.data() + 3 * i) = to_world * picture.g_buffer().normal(i);
    const SC::G_buffer g(120, 100, picture.depths.data(), picture.normals.data(), camera,
                         SC::Normal_space::WORLD);
    const Uploaded uploaded(g);
    compare(g, uploaded.textures(g), SC::parameters::level_of_detail(SC::Level_of_detail::by_length(.03)),
            "convention " + std::to_string(int(camera.depth_convention())));
  }
}

BOOST_AUTO_TEST_CASE(bad_pixels)
{
  Picture picture = scene(4., "sphere");
  for(std::size_t i = 0; i < picture.size(); i += 37)
    switch(i % 7)
    {
    case 0:
      picture.normals[3 * i + i % 3] = no_number;
      break;
    case 1:
      picture.normals[3 * i + i % 3] = -std::numeric_limits<float>::infinity();
      break;
    case 2:
      picture.normals[3 * i] = picture.normals[3 * i + 1] = picture.normals[3 * i + 2] = 0.f;
      break;
    case 3:
      picture.depths[i] = no_number;
      break;
    case 4:
      picture.depths[i] = std::numeric_limits<float>::infinity();
      break;
    case 5:
      picture.depths[i] = 1.f;
      break;
    default:
      picture.depths[i] = -2.f;
    }
  const SC::G_buffer g = picture.g_buffer();
  const Uploaded uploaded(g);
  compare(g, uploaded.textures(g), SC::parameters::number_of_triangles(4), "bad pixels");
  compare(g, uploaded.textures(g), SC::parameters::number_of_triangles(1), "bad pixels, one triangle");
}

BOOST_AUTO_TEST_CASE(sphere_fits)
{
  for(const std::string name : {"sphere", "cylinder", "torus and sphere on a plane"})
    for(const int radius : {2, 5, 8})
    {
      const Picture picture = scene(4., name);
      const SC::G_buffer g = picture.g_buffer();
      const Uploaded uploaded(g);
      Curvatures cpu(g.size());
      cpu.failures = SC::sphere_fit_mean_curvatures(g, SC::parameters::min_curvature_map(map_of(cpu.low))
                                                           .max_curvature_map(map_of(cpu.high))
                                                           .status_map(map_of(cpu.statuses))
                                                           .pixel_radius(radius));
      for(const SC::Shader_stage stage : {SC::Shader_stage::FRAGMENT, SC::Shader_stage::COMPUTE})
      {
        SC::Sphere_fit_mean_curvature_pass pass(stage);
        Curvatures gpu(g.size());
        gpu.failures =
            SC::read_screen_space_curvatures(pass(uploaded.textures(g), SC::parameters::pixel_radius(radius)),
                                             g.width(), g.height(), gpu.maps());
        cpu.shape_index = gpu.shape_index; // there is none
        check_agreement(g, cpu, gpu, "sphere fit of " + name + ", radius " + std::to_string(radius));
      }
    }
}

BOOST_AUTO_TEST_CASE(rendered_meshes)
{
  context();
  SC::G_buffer_renderer renderer;
  const SC::Camera camera = camera_at(4., 1.5);
  const auto ball = [](auto& mesh, int subdivisions, const Kernel::Vector_3& center)
  {
    using M = std::decay_t<decltype(mesh)>;
    CGAL::make_icosahedron<M, Kernel::Point_3>(mesh);
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(subdivisions));
    const auto points = get(CGAL::vertex_point, mesh);
    for(const auto v : vertices(mesh))
    {
      const Kernel::Vector_3 p = get(points, v) - CGAL::ORIGIN;
      put(points, v, CGAL::ORIGIN + center + p / std::sqrt(p.squared_length()));
    }
  };

  // a fine mesh: the curvature of the ball, from two types of meshes and from any place
  Mesh fine;
  ball(fine, 5, Kernel::Vector_3(0., 0., 0.));
  CGAL::Polyhedron_3<Kernel> polyhedron;
  ball(polyhedron, 5, Kernel::Vector_3(0., 0., 0.));
  Mesh distant;
  ball(distant, 5, Kernel::Vector_3(1e7, 2e7, -1e7));
  Eigen::Matrix4d distant_view = camera.view();
  distant_view.block<3, 1>(0, 3) -= camera.view().topLeftCorner<3, 3>() * Eigen::Vector3d(1e7, 2e7, -1e7);

  std::vector<float> depths, normals, first;
  for(int i = 0; i < 3; ++i)
  {
    if(i == 0)
      renderer.set_mesh(fine);
    else if(i == 1)
      renderer.set_mesh(polyhedron);
    else
      renderer.set_mesh(distant);
    const SC::Camera& c = i < 2 ? camera : SC::Camera(distant_view, camera.projection());
    const SC::G_buffer_textures textures = renderer.draw(c, 211, 187);
    const SC::G_buffer g = SC::read_g_buffer(textures, depths, normals);
    compare(g, textures, SC::parameters::number_of_triangles(4), "rendered ball");
    Curvatures r(g.size());
    r.failures = SC::screen_space_curvatures(g, r.maps().level_of_detail(SC::Level_of_detail::by_pixels(4)));
    BOOST_TEST(r.failures == 0u);
    std::vector<double> errors;
    for(std::size_t p = 0; p < g.size(); ++p)
      if(r.statuses[p] == Status::ESTIMATED && g.view_normal(p).z() > .5)
        errors.push_back(std::abs(.5 * (r.low[p] + r.high[p]) - 1.));
    BOOST_TEST(errors.size() > 4000u);
    BOOST_TEST(quantile(errors, .5) < .02);
    if(i == 0)
      first = r.low;
    else if(i == 1)
      BOOST_TEST((std::memcmp(first.data(), r.low.data(), first.size() * sizeof(float)) == 0));
  }

  // nothing, and what can't be drawn
  renderer.set_mesh(Mesh());
  const SC::G_buffer empty = SC::read_g_buffer(renderer.draw(camera, 20, 10), depths, normals);
  for(std::size_t i = 0; i < empty.size(); ++i)
    BOOST_TEST(!empty.is_valid(i));
  Mesh broken;
  ball(broken, 2, Kernel::Vector_3(0., 0., 0.));
  broken.point(*broken.vertices().begin()) = Kernel::Point_3(double(no_number), 0., 0.);
  renderer.set_mesh(broken);
  SC::read_g_buffer(renderer.draw(camera, 50, 50), depths, normals);
  BOOST_TEST(std::count_if(depths.begin(), depths.end(), [](float d) { return d < 1.f; }) > 500);
}

BOOST_AUTO_TEST_CASE(level_of_detail_on_a_coarse_mesh)
{
  // A torus of few faces, with normals that are interpolated: without level of detail, the faces show (Figure 7.2). The far plane is where
  // the thesis has it.
  context();
  constexpr int around = 48, across = 20;
  const double major = 1., minor = .4, pi = CGAL_PI;
  Mesh mesh;
  auto exact = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:exact").first;
  for(int i = 0; i < around; ++i)
    for(int j = 0; j < across; ++j)
    {
      // not a regular one: its normals would be exact, wherever they are from
      const double u = 2. * pi * (i + .3 * std::sin(7. * i + 13. * j)) / around,
                   v = 2. * pi * (j + .3 * std::sin(11. * i + 5. * j)) / across;
      const Kernel::Vector_3 n(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
      const Kernel::Vector_3 circle(std::cos(u), std::sin(u), 0.);
      exact[mesh.add_vertex(CGAL::ORIGIN + major * circle + minor * n)] = n;
    }
  const auto vertex = [&](int i, int j)
  { return Mesh::Vertex_index(std::uint32_t(i % around * across + j % across)); };
  for(int i = 0; i < around; ++i)
    for(int j = 0; j < across; ++j)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  SC::G_buffer_renderer renderer;
  for(const bool are_exact : {true, false})
  {
    if(are_exact)
      renderer.set_mesh(mesh, SC::parameters::vertex_normal_map(exact));
    else
      renderer.set_mesh(mesh);
    for(const double distance : {2.2, 4., 8.})
    {
      const Eigen::Vector3d eye = distance * Eigen::Vector3d(.4, -.2, 1.).normalized();
      const SC::Camera c(SC::Camera::look_at(eye, {0., 0., 0.}, {0., 1., 0.}),
                         SC::Camera::perspective(.7, 1., .9 * (distance - 1.4), 100.));
      std::vector<float> depths, normals;
      const SC::G_buffer g = SC::read_g_buffer(renderer.draw(c, 600, 600), depths, normals);
      const auto mean_error = [&](const SC::Level_of_detail& level)
      {
        Curvatures r(g.size());
        SC::screen_space_curvatures(g, r.maps().level_of_detail(level));
        double sum = 0.;
        std::size_t n = 0;
        for(std::size_t i = 0; i < g.size(); ++i)
          if(g.is_valid(i) && SC::is_estimated(r.statuses[i]) && g.view_normal(i).z() > .5)
          {
            const Eigen::Vector3d p = c.world_point(g.view_point(i));
            const double rho = std::hypot(p.x(), p.y());
            const double cosine = (rho - major) / std::hypot(rho - major, p.z());
            const double truth = .5 / minor + .5 * cosine / (major + minor * cosine);
            sum += std::abs(.5 * (r.low[i] + r.high[i]) - truth) / truth;
            ++n;
          }
        return sum / double(n);
      };
      const double off = mean_error(SC::Level_of_detail::none()),
                   printed = mean_error(SC::Level_of_detail::by_depth(16.)),
                   length = mean_error(SC::Level_of_detail::by_length(.12));
      BOOST_TEST_MESSAGE("coarse torus at "
                         << distance << (are_exact ? ", exact normals" : ", normals from faces")
                         << ": mean relative error of H " << off << " without level of detail, " << printed
                         << " by depth, " << length << " by length");
      BOOST_TEST(printed < off);
      BOOST_TEST(length < .7 * off);
    }
  }
}

BOOST_AUTO_TEST_CASE(normal_mapped_plane)
{
  // A square with the normals of a ball in a texture: the curvature is the ball's.
  context();
  const double radius = 1.6;
  for(const bool mirrored : {false, true}) // texture coordinates may be
  {
    Mesh square;
    auto coordinates = square.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:texture").first;
    std::vector<Mesh::Vertex_index> corners;
    for(const auto& p : {std::pair<double, double>{-1., -1.}, {1., -1.}, {1., 1.}, {-1., 1.}})
    {
      corners.push_back(square.add_vertex(Kernel::Point_3(p.first, p.second, 0.)));
      const double u = .5 * (p.first + 1.);
      coordinates[corners.back()] = Kernel::Point_2(mirrored ? 1. - u : u, .5 * (p.second + 1.));
    }
    square.add_face(corners);
    constexpr int size = 512;
    std::vector<float> texels;
    for(int y = 0; y < size; ++y)
      for(int x = 0; x < size; ++x)
      {
        const double u = (2. * (x + .5) / size - 1.) / radius, v = (2. * (y + .5) / size - 1.) / radius;
        texels.insert(texels.end(), {float(u), float(v), float(std::sqrt(1. - u * u - v * v))});
      }
    SC::G_buffer_renderer renderer;
    renderer.set_mesh(square, SC::parameters::vertex_texture_coordinates_map(coordinates));
    const SC::Camera camera(SC::Camera::look_at({0., 0., 3.}, {0., 0., 0.}, {.2, 1., 0.}),
                            SC::Camera::orthographic(1.2, 1., 1., 5.));
    const auto median_mean = [&]
    {
      std::vector<float> depths, normals;
      const SC::G_buffer_textures textures = renderer.draw(camera, 150, 150);
      const SC::G_buffer g = SC::read_g_buffer(textures, depths, normals);
      compare(g, textures, SC::parameters::number_of_triangles(4), "normal map");
      Curvatures r(g.size());
      r.failures = SC::screen_space_curvatures(g, r.maps());
      BOOST_TEST(r.failures == 0u);
      std::vector<double> mean;
      for(std::size_t i = 0; i < g.size(); ++i)
        mean.push_back(.5 * (r.low[i] + r.high[i]));
      return quantile(mean, .5);
    };
    BOOST_TEST(std::abs(median_mean()) < 1e-6);
    renderer.set_normal_map(size, size, texels.data());
    BOOST_TEST(std::abs(median_mean() * radius - 1.) < .01);
    renderer.remove_normal_map();
    BOOST_TEST(std::abs(median_mean()) < 1e-6);
    BOOST_CHECK_THROW(renderer.set_normal_map(0, 1, texels.data()), std::invalid_argument);
    BOOST_CHECK_THROW(renderer.set_normal_map(1, 1, nullptr), std::invalid_argument);
  }
}

BOOST_AUTO_TEST_CASE(sizes_and_targets)
{
  context();
  const Picture picture = scene(4., "sphere");
  const SC::G_buffer g = picture.g_buffer();
  const Uploaded uploaded(g);
  SC::G_buffer_textures textures = uploaded.textures(g);
  for(const SC::Shader_stage stage : {SC::Shader_stage::FRAGMENT, SC::Shader_stage::COMPUTE})
  {
    SC::Screen_space_curvature_pass pass(stage);
    SC::Sphere_fit_mean_curvature_pass fit(stage);
    // the texture of the pass stays the same as long as the size does
    const unsigned first = pass(textures);
    BOOST_TEST(first != 0u);
    BOOST_TEST(pass(textures, SC::parameters::number_of_triangles(1)) == first);

    // a texture of the caller
    GLuint target;
    glGenTextures(1, &target);
    glBindTexture(GL_TEXTURE_2D, target);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, g.width(), g.height());
    glBindTexture(GL_TEXTURE_2D, 0);
    pass(textures);
    pass.draw_into(target, textures);
    Curvatures a(g.size()), b(g.size());
    SC::read_screen_space_curvatures(first, g.width(), g.height(), a.maps());
    SC::read_screen_space_curvatures(target, g.width(), g.height(), b.maps());
    BOOST_TEST((std::memcmp(a.low.data(), b.low.data(), a.low.size() * sizeof(float)) == 0));
    BOOST_TEST((a.statuses == b.statuses));
    glDeleteTextures(1, &target);

    // no pixels
    SC::G_buffer_textures none = textures;
    none.width = 0;
    BOOST_TEST(pass(none) == 0u);
    BOOST_TEST(fit(none) == 0u);
    pass.draw_into(0, none);
    none.height = -1;
    BOOST_CHECK_THROW(pass(none), std::invalid_argument);
    BOOST_CHECK_THROW(fit(none), std::invalid_argument);
    BOOST_CHECK_THROW(pass(textures, SC::parameters::number_of_triangles(0)), std::invalid_argument);
    BOOST_CHECK_THROW(fit(textures, SC::parameters::pixel_radius(0)), std::invalid_argument);

    // textures that there are not, or that have no room: the pass's own result stays
    GLuint others[3];
    glGenTextures(3, others); // too small, of another format, of another kind
    glBindTexture(GL_TEXTURE_2D, others[0]);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, g.width() - 1, g.height());
    glBindTexture(GL_TEXTURE_2D, others[1]);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA16F, g.width(), g.height());
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, others[2]);
    glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, GL_RGBA32F, g.width(), g.height(), 2);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    for(const GLuint name : {0u, 4711u, others[0], others[2]})
      BOOST_CHECK_THROW(pass.draw_into(name, textures, SC::parameters::number_of_triangles(1)),
                        std::invalid_argument);
    if(stage == SC::Shader_stage::COMPUTE)
      BOOST_CHECK_THROW(pass.draw_into(others[1], textures), std::invalid_argument);
    else
      pass.draw_into(others[1], textures);
    SC::read_screen_space_curvatures(first, g.width(), g.height(), b.maps());
    BOOST_TEST((std::memcmp(a.low.data(), b.low.data(), a.low.size() * sizeof(float)) == 0));
    BOOST_TEST(pass(textures) == first);

    // and what isn't there can't be read
    for(const GLuint name : {0u, 4711u, others[0], others[2]})
      BOOST_CHECK_THROW(SC::read_screen_space_curvatures(name, g.width(), g.height(), b.maps()),
                        std::invalid_argument);
    BOOST_CHECK_THROW(SC::read_screen_space_curvatures(first, g.width() + 1, g.height(), b.maps()),
                      std::invalid_argument);
    BOOST_CHECK_THROW(SC::read_screen_space_curvatures(first, g.width() - 1, g.height(), b.maps()),
                      std::invalid_argument);
    std::vector<float> read_depths, read_normals;
    none = textures;
    none.depths = others[0];
    BOOST_CHECK_THROW(SC::read_g_buffer(none, read_depths, read_normals), std::invalid_argument);
    glDeleteTextures(3, others);

    // depths in a format of colors are read as well as those in one of depths
    SC::read_g_buffer(textures, read_depths, read_normals);
    for(std::size_t i = 0; i < g.size(); i += 7)
      BOOST_TEST(read_depths[i] == g.depth(i));

    // the application shows the result while the next picture has another size: it shows nothing then
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, first);
    textures.width -= 1;
    pass(textures);
    textures.width += 1;
    GLint shown = -1;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &shown);
    BOOST_TEST(shown == 0);
    BOOST_TEST(glGetError() == GLenum(GL_NO_ERROR));
  }
  BOOST_TEST(SC::read_screen_space_curvatures(0, 0, 5) == 0u);
  BOOST_CHECK_THROW(SC::read_screen_space_curvatures(0, -1, 5), std::invalid_argument);

  SC::G_buffer_renderer renderer;
  const SC::Camera camera = camera_at(4., 1.5);
  std::vector<float> depths, normals;
  BOOST_TEST(SC::read_g_buffer(renderer.draw(camera, 0, 10), depths, normals).size() == 0u);
  BOOST_CHECK_THROW(renderer.draw(camera, -1, 10), std::invalid_argument);
  BOOST_CHECK_THROW(renderer.draw(camera, 1 << 30, 10), std::invalid_argument);
  BOOST_CHECK_THROW(
      renderer.draw(SC::Camera(camera.view(), camera.projection(), SC::Depth_convention::EYE_DISTANCE), 10,
                    10),
      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(state_is_given_back)
{
  context();
  const Picture picture = scene(4., "sphere");
  const SC::G_buffer g = picture.g_buffer();
  const Uploaded uploaded(g);
  const SC::G_buffer_textures textures = uploaded.textures(g);
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Kernel::Point_3>(mesh);
  SC::G_buffer_renderer renderer;
  SC::Screen_space_curvature_pass fragments, compute(SC::Shader_stage::COMPUTE);
  SC::Sphere_fit_mean_curvature_pass fit;

  // a frame of someone else, with everything switched to what hurts
  GLuint vertex_array, framebuffer, texture, sampler, buffers[3];
  glGenVertexArrays(1, &vertex_array);
  glBindVertexArray(vertex_array);
  glGenBuffers(3, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffers[1]);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffers[2]);
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, 4, 4);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, texture);
  glGenSamplers(1, &sampler);
  glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glBindSampler(0, sampler);
  glBindSampler(1, sampler);
  glActiveTexture(GL_TEXTURE3);
  glBindImageTexture(0, texture, 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glViewport(1, 2, 3, 4);
  glScissor(0, 0, 1, 1);
  for(const GLenum s :
      {GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD})
    glEnable(s);
  glDepthFunc(GL_NEVER);
  glDepthMask(GL_FALSE);
  glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  glDepthRange(.25, .75);
  glClearColor(.1f, .2f, .3f, .4f);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glPixelStorei(GL_PACK_ROW_LENGTH, 1000);
  glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
  for(const GLenum s : {GL_POLYGON_OFFSET_FILL, GL_PRIMITIVE_RESTART})
    glEnable(s);
  glPolygonOffset(-100.f, -100.f);
  glPrimitiveRestartIndex(0);
  glDisablei(GL_BLEND, 1);
  glDisablei(GL_SCISSOR_TEST, 3);
  glViewportIndexedf(1, 2.f, 3.f, 5.f, 7.5f);
  glDepthRangeIndexed(2, .125, .5);
  const bool has_clip_control = epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
  if(has_clip_control)
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);

  const auto state = [=]
  {
    std::vector<double> values;
    for(const GLenum name :
        {GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING, GL_DRAW_FRAMEBUFFER_BINDING,
         GL_PIXEL_PACK_BUFFER_BINDING, GL_PIXEL_UNPACK_BUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING,
         GL_ACTIVE_TEXTURE, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK, GL_PACK_ROW_LENGTH, GL_PACK_ALIGNMENT,
         GL_UNPACK_ALIGNMENT, GL_UNPACK_SWAP_BYTES})
    {
      GLint value = 0;
      glGetIntegerv(name, &value);
      values.push_back(value);
    }
    if(has_clip_control)
      for(const GLenum name : {GL_CLIP_ORIGIN, GL_CLIP_DEPTH_MODE})
      {
        GLint value = 0;
        glGetIntegerv(name, &value);
        values.push_back(value);
      }
    for(GLuint i = 0; i < 4; ++i)
    {
      GLdouble several[4] = {};
      glGetDoublei_v(GL_VIEWPORT, i, several);
      values.insert(values.end(), several, several + 4);
      glGetDoublei_v(GL_DEPTH_RANGE, i, several);
      values.insert(values.end(), several, several + 2);
      values.push_back(glIsEnabledi(GL_BLEND, i));
      values.push_back(glIsEnabledi(GL_SCISSOR_TEST, i));
    }
    for(const GLenum name :
        {GL_VIEWPORT, GL_COLOR_CLEAR_VALUE, GL_DEPTH_RANGE, GL_COLOR_WRITEMASK, GL_POLYGON_MODE})
    {
      GLdouble several[4] = {};
      glGetDoublev(name, several);
      values.insert(values.end(), several, several + 4);
    }
    for(const GLenum s :
        {GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD,
         GL_COLOR_LOGIC_OP, GL_POLYGON_OFFSET_FILL, GL_PRIMITIVE_RESTART})
      values.push_back(glIsEnabled(s));
    GLint active;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for(const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1})
    {
      glActiveTexture(unit);
      for(const GLenum name : {GL_TEXTURE_BINDING_2D, GL_SAMPLER_BINDING})
      {
        GLint value = 0;
        glGetIntegerv(name, &value);
        values.push_back(value);
      }
    }
    glActiveTexture(GLenum(active));
    for(const GLenum name : {GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_ACCESS, GL_IMAGE_BINDING_FORMAT})
    {
      GLint value = 0;
      glGetIntegeri_v(name, 0, &value);
      values.push_back(value);
    }
    return values;
  };
  const std::vector<double> before = state();
  renderer.set_mesh(mesh);
  std::vector<float> depths, normals;
  const SC::G_buffer drawn = SC::read_g_buffer(renderer.draw(camera_at(4., 1.5), 50, 50), depths, normals);
  Curvatures a(g.size()), b(g.size()), c(g.size());
  SC::read_screen_space_curvatures(fragments(textures), g.width(), g.height(), a.maps());
  SC::read_screen_space_curvatures(compute(textures), g.width(), g.height(), b.maps());
  SC::read_screen_space_curvatures(fit(textures), g.width(), g.height(), c.maps());
  BOOST_TEST(before == state(), boost::test_tools::per_element());
  BOOST_TEST(glGetError() == GLenum(GL_NO_ERROR));

  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_FALSE);
  for(const GLenum s : {GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_STENCIL_TEST,
                        GL_RASTERIZER_DISCARD, GL_POLYGON_OFFSET_FILL, GL_PRIMITIVE_RESTART})
    glDisable(s);
  glDepthRangeIndexed(2, 0., 1.);
  if(has_clip_control)
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glBindSampler(0, 0);
  glBindSampler(1, 0);
  glDepthRange(0., 1.);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);

  // and none of it did any harm
  std::size_t seen = 0;
  for(std::size_t i = 0; i < drawn.size(); ++i)
    seen += drawn.is_valid(i);
  BOOST_TEST(seen > 500u);
  const std::vector<float> depths_in_another_frame = depths, normals_in_another_frame = normals;
  SC::read_g_buffer(renderer.draw(camera_at(4., 1.5), 50, 50), depths, normals);
  BOOST_TEST((depths == depths_in_another_frame));
  BOOST_TEST((normals == normals_in_another_frame));
  Curvatures cpu(g.size());
  cpu.failures = SC::screen_space_curvatures(g, cpu.maps());
  check_agreement(g, cpu, a, "fragments in another's frame");
  check_agreement(g, cpu, b, "compute in another's frame");
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(1, &texture);
  glDeleteSamplers(1, &sampler);
  glDeleteBuffers(3, buffers);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &vertex_array);
}

BOOST_AUTO_TEST_CASE(shader_files_stand_alone)
{
  context();
  const std::filesystem::path folder = std::filesystem::path(__FILE__).parent_path() /
                                       "../../include/Shape_characteristics/screen_space/OpenGL/shaders";
  for(const std::string name : {"screen_space_curvature.glsl", "sphere_fit_mean_curvature.glsl"})
  {
    std::ifstream file(folder / name);
    BOOST_TEST_REQUIRE(bool(file));
    std::stringstream text;
    text << file.rdbuf();
    const std::string function =
        name == "screen_space_curvature.glsl" ? "sc_curvature" : "sc_sphere_curvature";
    const std::string own_main =
        "out vec4 color;\nvoid main() { color = " + function + "(ivec2(gl_FragCoord.xy)) * 0.5; }\n";
    for(const auto& [stage, source] :
        {std::pair<GLenum, std::string>{GL_FRAGMENT_SHADER, "#version 430 core\n" + text.str()},
         {GL_COMPUTE_SHADER, "#version 430 core\n#define SC_COMPUTE\n" + text.str()},
         {GL_FRAGMENT_SHADER, "#version 450 core\n#define SC_LIBRARY\n" + text.str() + own_main}})
    {
      const GLuint shader = glCreateShader(stage);
      const char* s = source.c_str();
      glShaderSource(shader, 1, &s, nullptr);
      glCompileShader(shader);
      GLint is_compiled = 0;
      glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
      char log[1000] = "";
      glGetShaderInfoLog(shader, sizeof log, nullptr, log);
      BOOST_TEST(is_compiled, name << ": " << log);
      glDeleteShader(shader);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
