#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_DEPTH_CONVENTION_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_DEPTH_CONVENTION_H

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  says what the numbers in a depth buffer mean.

  Whether window depth grows or falls with the distance (reversed depth) follows from the projection.
*/
enum class Depth_convention : unsigned char
{
  /// window depth in [0, 1], as OpenGL makes it by default: clip space reaches from -1 to 1. A pixel with the depth of the
  /// far plane is background.
  WINDOW_DEPTH,
  /// window depth in [0, 1] of a projection to a clip space that reaches from 0 to 1: Vulkan, Direct3D, Metal, and OpenGL with
  /// `glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE)`. A pixel with the depth of the far plane is background.
  WINDOW_DEPTH_ZERO_TO_ONE,
  /// the distance from the eye along the direction of view, in the unit of the scene. A pixel whose distance is infinite, or
  /// not positive, is background.
  EYE_DISTANCE
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_DEPTH_CONVENTION_H
