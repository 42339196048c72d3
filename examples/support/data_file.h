#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_DATA_FILE_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_DATA_FILE_H

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace support {

/// The path of one of the meshes and point sets that come with CGAL, for example
/// `data_file("meshes/elephant.off")` or `data_file("points_3/oni.pwn")`.
///
/// It is looked for in the folder that the environment variable `SHAPE_CHARACTERISTICS_DATA` names, then in
/// the one that the build unpacked them to. Throws `std::runtime_error` if it is in neither.
inline std::string data_file(const std::string& name)
{
  std::string tried;
  const auto found = [&](const char* folder, std::string& path)
  {
    if(!folder || !*folder)
      return false;
    path = (std::filesystem::path(folder) / name).string();
    std::error_code ignored;
    if(std::filesystem::is_regular_file(path, ignored))
      return true;
    tried += "\n  " + path;
    return false;
  };
  std::string path;
  if(found(std::getenv("SHAPE_CHARACTERISTICS_DATA"), path))
    return path;
#ifdef SHAPE_CHARACTERISTICS_DATA_DIR
  if(found(SHAPE_CHARACTERISTICS_DATA_DIR, path))
    return path;
#endif
  throw std::runtime_error(
      "data_file: there is no '" + name + "'. The meshes come with Debian's package " +
      "libcgal-demo and are unpacked when the project is configured; another folder can be " +
      "named in the environment variable SHAPE_CHARACTERISTICS_DATA." +
      (tried.empty() ? "" : " Tried:" + tried));
}

} // namespace support

#endif
