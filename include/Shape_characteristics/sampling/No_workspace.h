#ifndef SHAPE_CHARACTERISTICS_SAMPLING_NO_WORKSPACE_H
#define SHAPE_CHARACTERISTICS_SAMPLING_NO_WORKSPACE_H

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsSampling

  is the workspace of functions that need none: see `for_each_sample()`.
*/
struct No_workspace
{};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_NO_WORKSPACE_H
