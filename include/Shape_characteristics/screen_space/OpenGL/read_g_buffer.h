#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_READ_G_BUFFER_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_READ_G_BUFFER_H

#include <Shape_characteristics/screen_space/G_buffer.h>
#include <Shape_characteristics/screen_space/OpenGL/G_buffer_textures.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/read_texture.h>
#include <Shape_characteristics/screen_space/OpenGL/internal/require_opengl.h>

#include <epoxy/gl.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {
/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  copies a G-buffer from the GPU to memory.

  \param textures the G-buffer
  \param depths gets the depth of each pixel
  \param normals gets the normal of each pixel, three numbers each
  \return the G-buffer in the two arrays, which have to outlive it
  \throws std::runtime_error if no context is current, or if it has less than OpenGL 4.3
  \throws std::invalid_argument if the size is negative, or not that of the textures
*/
inline G_buffer
read_g_buffer(const G_buffer_textures& textures, std::vector<float>& depths, std::vector<float>& normals)
{
  internal::require_opengl("read_g_buffer");
  if(textures.width < 0 || textures.height < 0)
    throw std::invalid_argument("Shape_characteristics: the size of a G-buffer must not be negative");
  const std::size_t size = std::size_t(textures.width) * std::size_t(textures.height);
  depths.resize(size);
  normals.resize(3 * size);
  if(size > 0)
  {
    internal::read_texture("read_g_buffer", textures.depths, textures.width, textures.height,
                           GL_DEPTH_COMPONENT, depths.data());
    internal::read_texture("read_g_buffer", textures.normals, textures.width, textures.height, GL_RGB,
                           normals.data());
  }
  return G_buffer(textures.width, textures.height, depths.data(), normals.data(), textures.camera,
                  textures.normal_space);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_OPENGL_READ_G_BUFFER_H
