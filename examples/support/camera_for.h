#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_CAMERA_FOR_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_CAMERA_FOR_H

#include "Mesh_renderer.h"

#include <filesystem>
#include <string>

namespace support {

/// From where one of the meshes and point sets that come with CGAL shows its best side, by the file's name;
/// the default camera for others.
inline Camera camera_for(const std::string& file_name)
{
  const std::string name = std::filesystem::path(file_name).stem().string();
  const auto camera = [](const Vector& towards_eye, const Vector& up)
  {
    Camera c;
    c.towards_eye = towards_eye;
    c.up = up;
    return c;
  };
  const Vector y = {0, 1, 0}, z = {0, 0, 1};
  if(name == "elephant")
    return camera({0.45, 0.15, 1}, y);
  if(name == "lion-head")
    return camera({-0.55, 0.15, 1}, y);
  if(name == "mannequin-devil")
    return camera({0.5, -1, 0.15}, z);
  if(name == "armadillo")
    return camera({0.35, 0.2, -1}, y);
  if(name == "bunny00")
    return camera({-0.2, 0.25, 1}, y);
  if(name == "anchor_dense")
    return camera({0.7, 0.6, 1}, y);
  if(name == "fandisk")
    return camera({0.6, 0.5, 1}, y);
  if(name == "oni")
    return camera({0.3, 0.1, 1}, y);
  return Camera();
}

} // namespace support

#endif
