#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_SYMMETRY_FLUX_DESCRIPTOR_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_SYMMETRY_FLUX_DESCRIPTOR_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Flux_method.h>
#include <Shape_characteristics/descriptors/Signal_scaling.h>
#include <Shape_characteristics/descriptors/internal/Clipped_patch.h>
#include <Shape_characteristics/descriptors/internal/neighborhood_extent.h>
#include <Shape_characteristics/descriptors/internal/status_of_row.h>
#include <Shape_characteristics/internal/scale_to_range.h>
#include <Shape_characteristics/sampling/Face_graph_samples.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the symmetry-aware flux \f$ F_s \f$ of the samples of a surface (thesis, section 10.1.1): how much of the field
  \f$ v(X) = (P - X) \times n_P \f$, which turns around the normal \f$ n_P \f$ of the sample \f$ P \f$, goes through the surface
  around it. Mirroring the surface changes the sign of the flux, exactly; flipping all normals changes nothing.

  With `Flux_method::POINTS`, each neighbor \f$ P_j \f$ stands for a piece of surface with its normal (10.12). If the pieces are
  alike, \f$ F_s = \sum_j \frac{1}{2} (P - P_j) \times n_P \cdot n_j \f$ as printed, and, free of units,
  \f$ \frac{\pi}{m r} \sum_j (P - P_j) \times n_P \cdot n_j \f$ of \f$ m \f$ neighbors within \f$ r \f$. With areas \f$ a_j \f$, it is
  \f$ \sum_j a_j (P - P_j) \times n_P \cdot n_j \f$ as printed, and, free of units, that divided by \f$ r^3 \f$.

  With the other two, it is the flux through the triangles around a vertex of a mesh, as far as they are in the ball, and without
  parts that leave the ball and come back (10.3, 10.11); free of units, divided by \f$ r^3 \f$. The field is the curl of
  \f$ -|X - P|^2 n_P / 2 \f$, so the flux depends on the boundary of the patch alone, and <b>is zero, up to rounding errors,
  wherever the border of the mesh is outside the ball</b>: on the sphere, that function is constant. What is left where the
  border is inside, tells of the border. Sums over points differ from zero by as much as the points are spread unevenly, and
  tend to zero with their number; on noisy scans the sign of `POINTS` repeats in 51 to 65 % of the points.
  `Chirality_descriptor` is the signal that is made to repeat.

  The radius is that of the ball if the surface's neighbors are those in a ball, and the distance of the farthest
  neighbor otherwise.

  The status of samples with less than 3 neighbors is `FEW_NEIGHBOURS`; with all of them in a line, or where a flux with a unit is too
  large for a `float`, `DEGENERATE`.

  \tparam SampledSurface a model of the concept `SampledSurface`; for the methods of meshes, `Face_graph_samples`

  \cgalModels{Descriptor}
*/
template <typename SampledSurface>
class Symmetry_flux_descriptor
{
public:
  /// scratch memory of a thread
  class Workspace
  {
    friend class Symmetry_flux_descriptor;
    typename SampledSurface::Workspace m_neighbors;
    internal::Clipped_patch::Workspace m_patch;
  };

  /*!
    \param surface the surface, with normals. It is not copied, and has to live as long as the descriptor.
    \param method over what is summed
    \param scaling the unit of the flux
    \param areas with `Flux_method::POINTS`, the areas that the samples stand for, one for each; none if they are alike.
           Samples whose area is not a positive number don't count: where hardly any of the neighbors has one, the status is
           `FEW_NEIGHBOURS`.
    \throws std::invalid_argument if the number of areas is neither 0 nor that of the samples, or if the triangles of a mesh are
            asked for and the surface has none, has forgotten them, or has other faces
  */
  explicit Symmetry_flux_descriptor(const SampledSurface& surface,
                                    Flux_method method = Flux_method::POINTS,
                                    Signal_scaling scaling = Signal_scaling::UNIT_FREE,
                                    std::vector<double> areas = std::vector<double>())
    : m_surface(surface),
      m_method(method),
      m_scaling(scaling),
      m_areas(std::move(areas))
  {
    if(!m_areas.empty() && m_areas.size() != surface.size())
      throw std::invalid_argument("Shape_characteristics: there must be an area for each sample");
    if(method != Flux_method::POINTS && !has_triangles())
      throw std::invalid_argument(
          "Shape_characteristics: flux_method needs a mesh of triangles, or must be POINTS");
  }

  /// 1
  std::size_t dimension() const noexcept { return 1; }

  /// writes the flux of sample `i` to `row`, or NaN if the status that is returned says that there is none.
  ///
  /// Complexity: linear in the number of neighbors.
  Estimation_status operator()(std::size_t i, Workspace& workspace, float* row) const
  {
    double value = std::numeric_limits<double>::quiet_NaN();
    Estimation_status status = m_surface.status(i);
    if(is_estimated(status))
    {
      const auto& neighbors = m_surface.neighbors(i, s_minimum, workspace.m_neighbors);
      if(neighbors.size() < s_minimum || !have_areas(neighbors))
        status = Estimation_status::FEW_NEIGHBOURS;
      else if(internal::is_collinear(m_surface, i, neighbors))
        status = Estimation_status::DEGENERATE;
      else
        value = flux(i, neighbors, workspace);
    }
    *row = float(value);
    return internal::status_of_row(row, dimension(), status);
  }

  /// writes to `result` the flux that the sample has on the mirrored surface, if `row` is the one that it has here: the negative
  void mirrored(const float* row, float* result) const { *result = -*row; }

private:
  static constexpr std::size_t s_minimum = 3; // of neighbors

  bool has_triangles() const
  {
    if constexpr(std::is_same_v<SampledSurface, Face_graph_samples>)
    {
      if(m_surface.number_of_faces() != 0)
        return m_surface.is_triangle_mesh();
      for(std::size_t i = 0; i < m_surface.size(); ++i)
        if(is_estimated(m_surface.status(i)))
          return false;
      return true; // without faces nobody asks for them
    }
    else
      return false;
  }

  static bool is_area(double area) { return area > 0. && std::isfinite(area); }

  // whether enough of the samples do, where areas matter
  template <typename Index>
  bool have_areas(const std::vector<Index>& samples) const
  {
    return m_areas.empty() || m_method != Flux_method::POINTS ||
           std::size_t(std::count_if(samples.begin(), samples.end(),
                                     [&](const Index j) { return is_area(m_areas[j]); })) >= s_minimum;
  }

  template <typename Index>
  double flux(std::size_t i, const std::vector<Index>& neighbors, Workspace& workspace) const
  {
    const double radius = internal::neighborhood_radius(m_surface, i, neighbors);
    const bool is_unit_free = m_scaling == Signal_scaling::UNIT_FREE;
    if constexpr(std::is_same_v<SampledSurface, Face_graph_samples>)
      if(m_method != Flux_method::POINTS)
      {
        const double scale = internal::scale_to_range(radius), scaled_radius = scale * radius;
        const internal::Clipped_patch patch(m_surface, i, radius, scale, workspace.m_patch);
        const double sum =
            m_method == Flux_method::BOUNDARY ? patch.flux_by_boundary() : patch.flux_through_triangles();
        return is_unit_free ? sum / scaled_radius / scaled_radius / scaled_radius
                            : sum / scale / scale / scale;
      }

    const Eigen::Vector3d &p = m_surface.point(i), &n = m_surface.normal(i);
    double sum = 0.;
    for(const Index j : neighbors)
    {
      const double term = ((p - m_surface.point(j)) / radius).cross(n).dot(m_surface.normal(j));
      if(m_areas.empty())
        sum += term;
      else if(is_area(m_areas[j]))
        sum += (is_unit_free ? m_areas[j] / radius / radius : m_areas[j]) * term;
    }
    if(m_areas.empty())
      return is_unit_free ? CGAL_PI / double(neighbors.size()) * sum : .5 * radius * sum;
    return is_unit_free ? sum : radius * sum;
  }

  const SampledSurface& m_surface;
  Flux_method m_method;
  Signal_scaling m_scaling;
  std::vector<double> m_areas;
};

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_SYMMETRY_FLUX_DESCRIPTOR_H
