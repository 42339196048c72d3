#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_SCREEN_SPACE_OPTIONS_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_SCREEN_SPACE_OPTIONS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/whole_number.h>
#include <Shape_characteristics/screen_space/Camera.h>
#include <Shape_characteristics/screen_space/Depth_discontinuity_rule.h>
#include <Shape_characteristics/screen_space/Level_of_detail.h>
#include <Shape_characteristics/screen_space/Normal_space.h>
#include <Shape_characteristics/screen_space/internal/Screen_frame.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

namespace Shape_characteristics {
namespace internal {

// The named parameters that the curvature of a screen has on all processors.
struct Screen_space_options
{
  template <typename NamedParameters>
  explicit Screen_space_options(const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    const std::int64_t edges =
        whole_number(np, internal_np::number_of_edges, std::int64_t(2), "number_of_edges");
    const std::int64_t triangles =
        whole_number(np, internal_np::number_of_triangles, std::int64_t(4), "number_of_triangles");
    level_of_detail =
        choose_parameter(get_parameter(np, internal_np::level_of_detail), Level_of_detail::none());
    rule = choose_parameter(get_parameter(np, internal_np::depth_discontinuity_rule),
                            Depth_discontinuity_rule::TANGENT_PLANES);
    if(edges != 2 && edges != 3)
      throw std::invalid_argument("Shape_characteristics: number_of_edges must be 2 or 3");
    if(triangles < 1 || triangles > 4)
      throw std::invalid_argument("Shape_characteristics: number_of_triangles must be in [1, 4]");
    number_of_edges = int(edges);
    number_of_triangles = int(triangles);
  }

  int number_of_edges, number_of_triangles;
  Level_of_detail level_of_detail = Level_of_detail::none();
  Depth_discontinuity_rule rule;
};

// What a pass over the pixels needs of all its parameters.
struct Screen_space_pass
{
  Screen_space_pass(const Screen_space_options& options,
                    const Camera& camera,
                    Normal_space normal_space,
                    int width,
                    int height)
    : frame(camera, normal_space, width, height),
      number_of_edges(options.number_of_edges),
      number_of_triangles(options.number_of_triangles),
      rule(options.rule)
  {
    largest_step = options.level_of_detail.fill_table(camera, frame.pixel_size, step_table);
    const double far = camera.far_plane();
    largest_distance_difference = far >= 100. ? 1.f : float(far / 100.); // (7.13) times f
  }

  // how many pixels away the neighbors are
  int step(float depth) const
  {
    int step = 1;
    while(step < largest_step && frame.depth_sign * depth <= frame.depth_sign * step_table[std::size_t(step)])
      ++step;
    return step;
  }

  Screen_frame frame;
  int number_of_edges, number_of_triangles;
  Depth_discontinuity_rule rule;
  float largest_distance_difference;
  int largest_step;
  std::array<float, Level_of_detail::maximum_step> step_table;
};

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_INTERNAL_SCREEN_SPACE_OPTIONS_H
