#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_SPIN_IMAGE_DESCRIPTOR_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_SPIN_IMAGE_DESCRIPTOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/internal/neighborhood_extent.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the spin image of the samples of a surface \cgalCite{spin_images}: a picture of the neighborhood, as if it were spun
  around the normal and left a trace on a half plane that ends at the normal's line.

  A neighbor \f$ x \f$ of the sample \f$ p \f$ with unit normal \f$ n \f$ is at \f$ \alpha = \lVert n \times (x - p) \rVert \f$, the
  distance from the line of the normal, and \f$ \beta = n \cdot (x - p) \f$, the height above the tangent plane. The picture has
  `image_width` \f$ = w \f$ cells along \f$ \alpha \f$ and \f$ 2 w \f$ along \f$ \beta \f$; a neighbor is shared among the four
  corners of its cell by bilinear weights, so that it changes continuously as points move. Component \f$ (2 w + 1) i + w + j \f$ belongs
  to the corner \f$ \alpha = i c, \beta = j c \f$, for \f$ i = 0, \dots, w \f$ and \f$ j = -w, \dots, w \f$, where \f$ c \f$ is the size of
  a cell: the order of the Point Cloud Library.

  The picture shows the cylinder that is inscribed in the ball of the neighborhood, whose radius is \f$ r \f$:
  \f$ c = r / (\sqrt 2 w) \f$. If the surface's neighbors aren't those in a ball, \f$ r \f$ is the distance of the farthest one.
  Neighbors in the rest of the ball don't count, neither do those whose normals are turned away from the sample's by more than
  `support_angle`, but for rounding: a right angle is none too much for \f$ \pi / 2 \f$. That leaves out the other side of a thin
  object.

  All values are at least 0, have the sum 100, and no unit. They don't change when the surface is moved, turned, scaled or
  mirrored; all normals flipped reverse the order of \f$ \beta \f$. Every neighbor counts alike, so that surfaces which are sampled more
  densely here than there have other spin images than evenly sampled ones.

  Samples whose points or normals are not finite are nobody's neighbors. The status of a sample is
  - `FEW_NEIGHBOURS` if it has less than 2 neighbors,
  - `DEGENERATE` if all its neighbors lie on one line through it, or none of them counts.

  Complexity: \f$ O(m + w^2) \f$ for a sample with \f$ m \f$ neighbors.

  \tparam SampledSurface a model of the concept `SampledSurface`

  \cgalModels{Descriptor}
*/
template <typename SampledSurface>
class Spin_image_descriptor
{
public:
  /// scratch memory, for one thread at a time
  class Workspace
  {
    friend class Spin_image_descriptor;
    typename SampledSurface::Workspace m_neighbors;
    std::vector<double> m_image;
  };

  /*!
    \param surface the surface, with normals. It has to outlive the descriptor.
    \param image_width how many cells the picture has along \f$ \alpha \f$: from 1 to 1000
    \param support_angle by how much a neighbor's normal may be turned away from the sample's, in radians: more than 0, and
           \f$ \pi \f$ at most

    \throws std::invalid_argument if one of the last two is out of its range
  */
  explicit Spin_image_descriptor(const SampledSurface& surface,
                                 unsigned int image_width = 8,
                                 double support_angle = CGAL_PI / 2.)
    : m_surface(surface),
      m_width(image_width),
      m_smallest_cosine(std::cos(support_angle) - s_rounding)
  {
    if(image_width < 1 || image_width > 1000)
      throw std::invalid_argument("Shape_characteristics: image_width must be from 1 to 1000");
    if(!(support_angle > 0. && support_angle <= CGAL_PI))
      throw std::invalid_argument("Shape_characteristics: support_angle must be more than 0 and at most pi");
  }

  /// \f$ (w + 1) (2 w + 1) \f$ for an `image_width` of \f$ w \f$: 153 by default
  std::size_t dimension() const noexcept { return (m_width + 1) * (2 * m_width + 1); }

  /// writes the spin image of sample `i`, or quiet NaN if the status says that there is none.
  Estimation_status operator()(std::size_t i, Workspace& workspace, float* row) const
  {
    const Estimation_status status = describe(i, workspace, row);
    if(!is_estimated(status))
      std::fill_n(row, dimension(), std::numeric_limits<float>::quiet_NaN());
    return status;
  }

  /// writes the spin image of the mirrored surface: `row`.
  void mirrored(const float* row, float* result) const { std::copy_n(row, dimension(), result); }

private:
  static constexpr std::size_t s_minimum = 2; // of neighbors
  static constexpr double s_rounding = 1e-9;  // relative: what is on an edge but for that is inside

  Estimation_status describe(std::size_t i, Workspace& workspace, float* row) const
  {
    const Estimation_status status = m_surface.status(i);
    if(!is_estimated(status))
      return status;
    const auto& neighbors = m_surface.neighbors(i, s_minimum, workspace.m_neighbors);
    if(neighbors.size() < s_minimum)
      return Estimation_status::FEW_NEIGHBOURS;
    if(internal::is_collinear(m_surface, i, neighbors))
      return Estimation_status::DEGENERATE;

    const Eigen::Vector3d &p = m_surface.point(i), &n = m_surface.normal(i);
    const double cell =
        internal::neighborhood_radius(m_surface, i, neighbors) / (std::sqrt(2.) * double(m_width));
    const std::size_t row_length = 2 * m_width + 1;
    std::vector<double>& image = workspace.m_image;
    image.assign(dimension(), 0.);
    std::size_t count = 0;
    for(const auto j : neighbors)
    {
      if(n.dot(m_surface.normal(j)) < m_smallest_cosine)
        continue;
      const Eigen::Vector3d d = (m_surface.point(j) - p) / cell;
      const double height = n.dot(d);
      const Place alpha = place(n.cross(d).norm()), beta = place(std::abs(height));
      if(!(alpha.is_inside && beta.is_inside))
        continue;
      ++count;
      const auto at = [&](std::size_t a, std::size_t b) -> double&
      { return image[a * row_length + (height > 0. ? m_width + b : m_width - b)]; };
      const std::size_t a = alpha.cell, b = beta.cell;
      at(a, b) += (1. - alpha.rest) * (1. - beta.rest);
      at(a, b + 1) += (1. - alpha.rest) * beta.rest;
      at(a + 1, b) += alpha.rest * (1. - beta.rest);
      at(a + 1, b + 1) += alpha.rest * beta.rest;
    }
    if(count == 0)
      return Estimation_status::DEGENERATE;
    for(std::size_t k = 0; k < image.size(); ++k)
      row[k] = float(100. * image[k] / double(count));
    return status;
  }

  // where a coordinate, at least 0 and in units of cells, is: in which cell, and how far from its beginning
  struct Place
  {
    std::size_t cell;
    double rest;
    bool is_inside;
  };

  Place place(double t) const
  {
    const double width = double(m_width);
    if(!(t <= width * (1. + s_rounding)))
      return {0, 0., false};
    const std::size_t cell = (std::min)(std::size_t(t), m_width - 1);
    return {cell, (std::min)(t - double(cell), 1.), true};
  }

  const SampledSurface& m_surface;
  std::size_t m_width;
  double m_smallest_cosine;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_SPIN_IMAGE_DESCRIPTOR_H
