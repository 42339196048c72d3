#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_READ_SCREEN_SPACE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_READ_SCREEN_SPACE_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/read_texture.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/require_opengl.h>
#include <Shape_characteristics/screen_space/Screen_space_curvature.h>
#include <Shape_characteristics/screen_space/internal/for_each_pixel.h>

#include <epoxy/gl.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  copies the results of `Screen_space_curvature_pass` or `Sphere_fit_mean_curvature_pass` to memory.

  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"
  \param texture what the pass returned
  \param width number of columns of the texture
  \param height number of rows of the texture
  \param np the maps that `screen_space_curvatures()` writes: `min_curvature_map`, `max_curvature_map`, `mean_curvature_map`, `Gaussian_curvature_map`,
         `shape_index_map`, `status_map`. The sphere that was fitted has one curvature: its square is the Gaussian one.
  \return the number of pixels that show a surface and could not be estimated
  \throws std::runtime_error if no context is current, or if it has less than OpenGL 4.3
  \throws std::invalid_argument if the size is negative, or not that of the texture, or the texture isn't what a pass returned
*/
template <typename NamedParameters = parameters::Default_named_parameters>
std::size_t read_screen_space_curvatures(unsigned texture,
                                         int width,
                                         int height,
                                         const NamedParameters& np = parameters::default_values())
{
  internal::require_opengl("read_screen_space_curvatures");
  if(width < 0 || height < 0)
    throw std::invalid_argument("Shape_characteristics: the size of a G-buffer must not be negative");
  const std::size_t size = std::size_t(width) * std::size_t(height);
  if(size == 0)
    return 0;
  std::vector<float> channels(4 * size);
  internal::read_texture("read_screen_space_curvatures", texture, width, height, GL_RGBA, channels.data());
  std::vector<Screen_space_curvature> results(size);
  for(std::size_t i = 0; i < size; ++i)
  {
    results[i].min_curvature = channels[4 * i];
    results[i].max_curvature = channels[4 * i + 1];
    const float status = channels[4 * i + 3];
    if(!(status >= 0.f && status <= float(Estimation_status::UNREFERENCED)))
      throw std::invalid_argument(
          "Shape_characteristics: read_screen_space_curvatures: the texture has no curvatures");
    results[i].status = Estimation_status(int(status));
  }
  return internal::write_pixels(np, results, 0, size);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_READ_SCREEN_SPACE_CURVATURES_H
