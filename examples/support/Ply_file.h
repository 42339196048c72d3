#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_PLY_FILE_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_PLY_FILE_H

#include "Drawable.h"
#include "Image.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace support {

enum class Ply_format
{
  BINARY_LITTLE_ENDIAN,
  ASCII
};

/// A mesh or a point set with any number of vertex properties, to be written as PLY.
///
///     Ply_file file(points);
///     file.set_triangles(triangles);
///     file.add_scalar("mean_curvature", mean);
///     file.add_vector("max_direction", directions); // max_direction_x, _y, _z
///     file.add_uchar("status", status);
///     file.write("elephant_hrbf.ply");
///
/// Every function throws `std::invalid_argument` for an array that is not as long as the points, and for a
/// name that is taken or not made of letters, digits and underscores.
class Ply_file
{
public:
  explicit Ply_file(std::vector<Vector> points);

  void set_triangles(std::vector<std::array<std::size_t, 3>> triangles);

  /// Faces of any degree. Throws for an index out of range or a face of less than 3 vertices.
  void set_faces(std::vector<std::vector<std::size_t>> faces);

  void add_scalar(const std::string& name, std::vector<double> values);

  /// Written as three scalars `name_x`, `name_y` and `name_z`.
  void add_vector(const std::string& name, const std::vector<Vector>& values);

  void add_uchar(const std::string& name, std::vector<std::uint8_t> values);

  /// Normals under the names that every reader knows: `nx`, `ny`, `nz`.
  void add_normals(const std::vector<Vector>& normals);

  /// Colours under the names that every reader knows: `red`, `green`, `blue`.
  void add_colors(const std::vector<Rgba>& colors);

  /// One line of comment in the file's head.
  void add_comment(const std::string& text);

  /// Real numbers are written with 64 bits, in ASCII with as many digits as bring them back exactly.
  /// Missing values are NaN, `nan` in ASCII: not every reader accepts that there. Throws
  /// `std::runtime_error` if the file cannot be written.
  void write(const std::string& file_name, Ply_format format = Ply_format::BINARY_LITTLE_ENDIAN) const;

private:
  struct Property
  {
    std::string name;
    std::vector<double> doubles;      // of a real property, or
    std::vector<std::uint8_t> uchars; // of one of small integers
  };
  void add(Property property);

  std::vector<Vector> points_;
  bool has_faces_ = false;
  std::vector<std::vector<std::size_t>> faces_;
  std::vector<Property> properties_;
  std::vector<std::string> comments_;
};

} // namespace support

#endif
