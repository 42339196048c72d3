#define BOOST_TEST_MODULE screen_space_gpu
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
#include <CGAL/subdivision_method_3.h>

#include <epoxy/gl.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

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
// the scene), and 999 of 1000 to 2^-20.
void check_agreement(const SC::G_buffer& g,
                     const Curvatures& cpu,
                     const Curvatures& gpu,
                     const std::string& what)
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
    BOOST_TEST(quantile(differences, .999) <= std::ldexp(1., -20));
    BOOST_TEST(largest <= std::ldexp(1., -18));
  }
}

template <typename NamedParameters>
void compare(const SC::G_buffer& g,
             const SC::G_buffer_textures& textures,
             const NamedParameters& np,
             const std::string& what)
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
    check_agreement(g, cpu, gpu, what + (stage == SC::Shader_stage::FRAGMENT ? ", fragments" : ", compute"));
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
