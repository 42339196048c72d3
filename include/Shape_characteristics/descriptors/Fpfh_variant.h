#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_FPFH_VARIANT_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_FPFH_VARIANT_H

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  says how the histograms of a sample and of its neighbors become its FPFH: the libraries that are used most differ from the
  paper \cgalCite{rusu_fpfh} and from each other.

  Let \f$ S_i \f$ be the simple histograms of sample \f$ i \f$, \f$ d_k \f$ the distances of its neighbors, and
  \f$ M_w = \sum_k w_k S_k / \sum_k w_k \f$ their weighted mean.
*/
enum class Fpfh_variant : unsigned char
{
  PAPER, ///< \f$ \frac{1}{2} (S_i + M_w) \f$ with \f$ w_k = 1/d_k \f$. Each of the three histograms has the sum 100. The paper divides by the
  ///< number of neighbors, not by the weights' sum: its second term then depends on the unit of length.
  PCL, ///< \f$ M_w \f$ with \f$ w_k = 1/d_k^2 \f$, as the Point Cloud Library does: without the sample's own histograms. Sums of 100.
  OPEN3D, ///< \f$ S_i + M_w \f$ with \f$ w_k = 1/d_k^2 \f$, as Open3D does. Sums of 200. Pairs without features count as if all three were 0.
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_FPFH_VARIANT_H
