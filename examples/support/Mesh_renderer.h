#ifndef SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_MESH_RENDERER_H
#define SHAPE_CHARACTERISTICS_EXAMPLES_SUPPORT_MESH_RENDERER_H

#include "Color_gradient.h"
#include "Drawable.h"
#include "Image.h"
#include "Offscreen_context.h"
#include "Value_range.h"

namespace support {

/// From where a shape is looked at. The distance is chosen so that the shape just fills the picture.
struct Camera
{
  Vector towards_eye = {0.4, 0.3, 1}; ///< from the shape to the eye; any length
  Vector up = {0, 1, 0};              ///< upwards in the picture; need not be orthogonal to `towards_eye`
  double field_of_view = 25;          ///< of the picture's longer side, in degrees, in (0,150)
};

struct Render_options
{
  int width = 900, height = 900; ///< in pixels
  Camera camera;
  Color_gradient gradient = Color_gradient::blue_green_red();
  Value_range range;                       ///< of the scalars; see percentile_range()
  Rgba background = {255, 255, 255, 255};  ///< its opacity is ignored
  Rgba plain_color = {214, 210, 202, 255}; ///< of shapes without scalars
  double margin = 0.03;                    ///< free space at each side, as a fraction of the shorter side
  double crease_angle = 60;                ///< computed normals are not averaged over edges sharper than this
  double splat_size = 1; ///< the discs of a point set, relative to the size that closes gaps
};

/// Renders meshes and point sets off-screen with OpenGL. The colour is looked up per pixel from the
/// interpolated scalar; lights are fixed to the camera; the edges are smooth. Where the scalar is missing
/// the surface is hatched in grey. The discs of a point set blend into each other; those
/// whose normal points away from the eye are not drawn, so that what lies behind does not show through gaps.
///
/// Points that are not finite, triangles that use one and triangles with indices out of range are left
/// out. The result does not depend on the shape's unit or position.
class Mesh_renderer
{
public:
  /// Throws `std::runtime_error` where there is no OpenGL.
  Mesh_renderer();
  ~Mesh_renderer();
  Mesh_renderer(const Mesh_renderer&) = delete;
  Mesh_renderer& operator=(const Mesh_renderer&) = delete;

  /// Throws `std::invalid_argument` for options out of range or arrays of unequal lengths. Nothing to
  /// draw gives the background.
  Image render(const Drawable& shape, const Render_options& options = {});

  /// The renderer's name and version.
  std::string description() const { return context_.description(); }

private:
  Offscreen_context context_;
  unsigned mesh_program_ = 0, splat_program_ = 0, splat_picture_program_ = 0;
};

} // namespace support

#endif
