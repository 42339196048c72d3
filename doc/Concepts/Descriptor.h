/*!
  \ingroup PkgShapeCharacteristicsConcepts
  \cgalConcept

  The concept `Descriptor` describes a vector of fixed length that tells what a surface looks like around a sample, so
  that places which look alike have vectors which are close to each other. `Shape_characteristics::compute_descriptors()`
  fills a matrix with those of all or of some samples; what matches them doesn't know which descriptor it serves.

  The constructor of a model takes a `SampledSurface`, which has to outlive the descriptor, and does what the
  descriptors of all samples share. (`Shape_characteristics::Appended_descriptor` and `Shape_characteristics::Scaled_descriptor`
  take other descriptors.)

  \cgalHasModelsBegin
  \cgalHasModels{Shape_characteristics::Appended_descriptor}
  \cgalHasModels{Shape_characteristics::Chirality_descriptor}
  \cgalHasModels{Shape_characteristics::Fpfh_descriptor}
  \cgalHasModels{Shape_characteristics::Pfh_descriptor}
  \cgalHasModels{Shape_characteristics::Scaled_descriptor}
  \cgalHasModels{Shape_characteristics::Shot_descriptor}
  \cgalHasModels{Shape_characteristics::Signed_volume_descriptor}
  \cgalHasModels{Shape_characteristics::Spin_image_descriptor}
  \cgalHasModels{Shape_characteristics::Symmetry_flux_descriptor}
  \cgalHasModelsEnd
*/
class Descriptor
{
public:
  /// \name Types
  /// @{

  /// default constructible scratch memory, to be used again from call to call
  typedef unspecified_type Workspace;

  /// @}
  /// \name Operations
  /// @{

  /// returns the number of components.
  std::size_t dimension() const;

  /// writes the descriptor of sample `i` to `row[0], ..., row[dimension() - 1]` and returns `ESTIMATED` or `BORDER`; or
  /// quiet NaN and why there is none. May be called by several threads at a time, each with a workspace of its own.
  Estimation_status operator()(std::size_t i, Workspace& workspace, float* row) const;

  /// returns all samples in an order in which they are best visited, a range of unsigned integers with subscripts and
  /// `size()`. Not every model has it; samples are then visited in the order of their numbers.
  unspecified_type order() const;

  /// writes to `result` what would be the descriptor of the mirrored surface at the sample whose descriptor is `row`. Not
  /// every model has it.
  void mirrored(const float* row, float* result) const;

  /// @}
};
