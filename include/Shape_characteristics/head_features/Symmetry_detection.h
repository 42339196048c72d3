#ifndef SHAPE_CHARACTERISTICS_HEAD_FEATURES_SYMMETRY_DETECTION_H
#define SHAPE_CHARACTERISTICS_HEAD_FEATURES_SYMMETRY_DETECTION_H

#include <vector>

namespace Shape_characteristics {

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// says whether a shape has a plane of symmetry
enum class Symmetry_verdict : unsigned char
{
  NONE,   ///< none that half of the surface agrees with, or several that are equally bad
  ONE,    ///< one, and no other nearly as good
  SEVERAL ///< several, almost equally good ones, as a cube, a sphere or a vase has them: which one is meant, the shape can't tell
};

/// \ingroup PkgShapeCharacteristicsHeadFeatures
/// returns the name of `verdict` as it is written in the program, for tables and messages.
constexpr const char* to_string(Symmetry_verdict verdict) noexcept
{
  switch(verdict)
  {
  case Symmetry_verdict::NONE:
    return "NONE";
  case Symmetry_verdict::ONE:
    return "ONE";
  case Symmetry_verdict::SEVERAL:
    return "SEVERAL";
  }
  return "";
}

/*!
  \ingroup PkgShapeCharacteristicsHeadFeatures

  holds what `detect_symmetry_plane()` found.

  \tparam Kernel a \cgal kernel
*/
template <typename Kernel>
struct Symmetry_detection
{
  /// a plane of symmetry, and how good it is
  struct Candidate
  {
    typename Kernel::Plane_3 plane =
        typename Kernel::Plane_3(1, 0, 0, 0); ///< the plane, in the coordinates of the shape
    double support = 0.;   ///< share of the surface whose mirror image lies on the surface, in [0, 1]
    double deviation = 0.; ///< median distance of these images from the surface, in the unit of the shape
  };

  /// whether there is a plane. Look at it before the plane: the best one that was tried is there in any case.
  Symmetry_verdict verdict = Symmetry_verdict::NONE;
  /// how sure it is that the shape has this plane of symmetry, and no other, in [0, 1]; 0 if the verdict is `NONE`
  double confidence = 0.;
  /// the best plane
  Candidate best;
  /// other planes, the best one first. If the verdict is `SEVERAL`, the first of them are as good as `best`; of a surface of revolution,
  /// which has infinitely many, they are some.
  std::vector<Candidate> alternatives;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_HEAD_FEATURES_SYMMETRY_DETECTION_H
