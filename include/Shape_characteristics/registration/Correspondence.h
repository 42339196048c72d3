#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_CORRESPONDENCE_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_CORRESPONDENCE_H

#include <cstdint>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  says that a point of one surface, the source, and a point of another, the target, may be the same point of the
  scanned object.
*/
struct Correspondence
{
  std::uint32_t source; ///< number of the point of the source
  std::uint32_t target; ///< number of the point of the target

  /// whether both are the same
  friend constexpr bool operator==(const Correspondence& a, const Correspondence& b) noexcept
  {
    return a.source == b.source && a.target == b.target;
  }
  /// whether they differ
  friend constexpr bool operator!=(const Correspondence& a, const Correspondence& b) noexcept
  {
    return !(a == b);
  }
  /// order by source, then by target
  friend constexpr bool operator<(const Correspondence& a, const Correspondence& b) noexcept
  {
    return a.source != b.source ? a.source < b.source : a.target < b.target;
  }
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_CORRESPONDENCE_H
