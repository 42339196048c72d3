/*!
  \ingroup PkgShapeCharacteristicsConcepts
  \cgalConcept

  The concept `GBuffer` describes what a picture of a scene knows of the surfaces that it shows: for each pixel a depth and a normal,
  and the camera. Renderers keep it to compute lights afterwards.

  Pixels are numbered row by row, the lowest row first. Its functions may be called by several threads at a time.

  \cgalHasModelsBegin
  \cgalHasModels{Shape_characteristics::G_buffer}
  \cgalHasModelsEnd
*/
class GBuffer
{
public:
  /// \name Operations
  /// @{

  /// returns the number of columns.
  int width() const;

  /// returns the number of rows.
  int height() const;

  /// returns the number of pixels.
  std::size_t size() const;

  /// returns the index of the pixel in column `x` and row `y`: `y * width() + x`.
  std::size_t index(int x, int y) const;

  /// returns the camera, which tells what depths mean.
  const Shape_characteristics::Camera& camera() const;

  /// returns in which coordinates normals are.
  Shape_characteristics::Normal_space normal_space() const;

  /// returns the depth of a pixel. NaN makes the pixel unusable.
  float depth(std::size_t pixel) const;

  /// returns the outward normal of a pixel, of any length. One that is zero or not finite makes the pixel unusable.
  Eigen::Vector3f normal(std::size_t pixel) const;

  /// returns whether a pixel shows a surface, with a depth and a normal that can be used.
  bool is_valid(std::size_t pixel) const;

  /// returns the point in view space that is seen at the center of a valid pixel.
  Eigen::Vector3d view_point(std::size_t pixel) const;

  /// returns the unit normal of a valid pixel in view space.
  Eigen::Vector3d view_normal(std::size_t pixel) const;

  /// @}
};
