/*!
  \ingroup PkgShapeCharacteristicsConcepts
  \cgalConcept

  The concept `AmbientOcclusionMapping` describes a function that guesses from the principal curvatures of a surface at a point how much of
  the ambient light arrives there: light that comes from all directions alike, as far as nothing is in its way.

  It is safe to be called concurrently.

  \cgalHasModelsBegin
  \cgalHasModels{Shape_characteristics::Two_part_ambient_occlusion}
  \cgalHasModels{Shape_characteristics::Hattori_ambient_occlusion}
  \cgalHasModels{Shape_characteristics::Griffin_ambient_occlusion}
  \cgalHasModelsEnd
*/
class AmbientOcclusionMapping
{
public:
  /// returns the share of the ambient light that arrives, in [0, 1]: 1 where nothing occludes, 0 in the dark. NaN if a curvature is NaN.
  /// \tparam PrincipalCurvatures a type with the members `min_curvature` and `max_curvature`, in 1/length and positive where the surface is
  /// convex
  template <typename PrincipalCurvatures>
  double operator()(const PrincipalCurvatures& curvatures) const;
};
