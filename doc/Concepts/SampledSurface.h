/*!
  \ingroup PkgShapeCharacteristicsConcepts
  \cgalConcept

  The concept `SampledSurface` describes a surface that is known at samples: points, normals, and for each sample the
  samples around it. Methods that fit something to a neighborhood ask for nothing else, and so run on meshes and on
  point sets alike.

  Its functions may be called by several threads at a time, each with a workspace of its own.

  \cgalHasModelsBegin
  \cgalHasModels{Shape_characteristics::Face_graph_samples}
  \cgalHasModels{Shape_characteristics::Point_set_samples}
  \cgalHasModelsEnd
*/
class SampledSurface
{
public:
  /// \name Types
  /// @{

  /// unsigned integer type, the number of a sample
  typedef unspecified_type Index;

  /// default constructible scratch memory of `neighbors()`, to be used again from call to call
  typedef unspecified_type Workspace;

  /// gives the blocks of `traversal_order()` one after the other. It is constructed from the surface, which must outlive it, and
  /// `patch_size`; its function `void next(std::vector<Index>& patch)` replaces `patch` by the next block.
  typedef unspecified_type Traversal;

  /// @}
  /// \name Operations
  /// @{

  /// returns the number of samples.
  std::size_t size() const;

  /// returns the point of sample `i`.
  const Eigen::Vector3d& point(std::size_t i) const;

  /// returns the unit normal of sample `i`, which is outward.
  const Eigen::Vector3d& normal(std::size_t i) const;

  /// returns `ESTIMATED` or `BORDER`, or why nothing can be estimated at sample `i`.
  Estimation_status status(std::size_t i) const;

  /// returns the neighbors of sample `i` without `i`, all with finite points and normals: the nearest first, in an
  /// order that the surface alone determines. Where there are less than `minimum`, the neighborhood may be enlarged.
  /// The reference is valid until the next call with the same workspace.
  const std::vector<Index>& neighbors(std::size_t i, std::size_t minimum, Workspace& workspace) const;

  /// returns what the neighbors are: rings of edges, those in a ball, or the nearest ones.
  const Neighborhood& neighborhood() const;

  /// returns the mean distance of sample `i` to the samples next to it; 0 if there is none.
  double spacing(std::size_t i) const;

  /// returns the mean distance of neighboring samples all over the surface; 0 if there are none.
  double mean_spacing() const;

  /// returns all samples in an order in which those that are close to each other on the surface are mostly close to each
  /// other: each block of `patch_size` in a row is a compact patch. The same surface gives the same order.
  std::vector<Index> traversal_order(std::size_t patch_size = 2000) const;

  /// replaces the point of sample `i`. Neighborhoods stay as they are, but for balls on meshes, which are measured anew.
  void set_point(std::size_t i, const Eigen::Vector3d& point);

  /// replaces the normals of all samples.
  void set_normals(std::vector<Eigen::Vector3d> normals);

  /// @}
};
