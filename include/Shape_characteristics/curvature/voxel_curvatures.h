#ifndef SHAPE_CHARACTERISTICS_CURVATURE_VOXEL_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_VOXEL_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/Voxel_octree.h>
#include <Shape_characteristics/curvature/internal/Ball_section.h>
#include <Shape_characteristics/curvature/internal/Triangle_shape_operator.h>
#include <Shape_characteristics/curvature/internal/estimate_curvatures.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/internal/point_set_parameters.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

class Voxel_estimator
{
  using Vector = Eigen::Vector3d;

public:
  struct Workspace
  {};

  // no normals: those of the voxels
  Voxel_estimator(const Voxel_octree& octree,
                  std::vector<Vector> points,
                  std::vector<Vector> normals,
                  double radius)
    : m_octree(octree),
      m_points(std::move(points)),
      m_normals(std::move(normals)),
      m_radius(radius)
  {}

  std::size_t size() const { return m_points.size(); }

  Curvature_estimate operator()(std::size_t i, Workspace&) const
  {
    const Vector& p = m_points[i];
    if(!p.allFinite())
      return Curvature_estimate(Estimation_status::NON_FINITE_INPUT);
    Vector normal = Vector::Zero();
    if(!m_normals.empty())
    {
      const double length = safe_norm(m_normals[i]);
      if(!(length > 0. && std::isfinite(length)))
        return Curvature_estimate(Estimation_status::NON_FINITE_INPUT);
      normal = (m_normals[i] / length).normalized();
    }
    const Volume_moments m = m_octree.moments_in_ball(p, m_radius);
    // towards the solid; of half of a ball it is pi / 4
    const double length = m.first.norm();
    if(!(length > s_smallest_moment))
      return Curvature_estimate(Estimation_status::DEGENERATE);
    if(m_normals.empty())
      normal = -m.first / length;
    const double cosine = -normal.dot(m.first) / length;
    if(!(std::abs(cosine) > s_smallest_cosine))
      return Curvature_estimate(Estimation_status::DEGENERATE);

    const Tangent_frame frame(normal);
    const auto [s, height] = surface_of_moments(m, frame.t1, frame.t2);
    const double of_disk = 1. - height * height;
    if(std::abs(height) > s_largest_height ||
       length < s_smallest_share * (CGAL_PI / 4.) * of_disk * of_disk) // what it is below a plane
      return Curvature_estimate(Estimation_status::DEGENERATE);
    const double factor = (cosine < 0. ? -1. : 1.) / m_radius;
    return Curvature_estimate(m_octree.is_cut_off(p, m_radius) ? Estimation_status::BORDER
                                                               : Estimation_status::ESTIMATED,
                              eigen_of_shape_operator(frame.normal, factor * s[0], factor * s[1],
                                                      factor * s[2], frame.t1, frame.t2));
  }

private:
  // Of what is inside, or of what is not, there is next to nothing in the ball: it doesn't meet a surface.
  static constexpr double s_smallest_moment = 1e-3;
  // Farther from the surface, in radii, curvatures can't be told from heights.
  static constexpr double s_largest_height = 0.6;
  // With less, another surface cuts off what should be there: of a plate, one thinner than .4 radii.
  static constexpr double s_smallest_share = 0.3;
  // A normal that is nearly tangential tells no side.
  static constexpr double s_smallest_cosine = 0.1;

  const Voxel_octree& m_octree;
  std::vector<Vector> m_points, m_normals;
  double m_radius;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures of the surface of a voxelized solid, by integral invariants \cgalCite{pottmann_invariants} (thesis,
  section 5.3.3; of digital data: D. Coeurjolly, J.-O. Lachaud, J. Levallois, Multigrid convergent principal curvature
  estimators in digital geometry, 2014).

  The method is that of `integral_invariant_curvatures()`: the second moments of the solid in a ball around each point. They are
  those of the voxels, exactly. In contrast to meshes, all that is in the ball counts: a solid that is thinner than the radius
  has two surfaces in it, and curvatures that are wrong.

  The points need to be near the surface only: `Voxel_octree::surface_points()`, the vertices of a mesh from which the voxels
  were made, or points that anybody measured. An offset of the order of a voxel changes little, since the height of the surface
  over the point cancels.

  The error has two parts: the one of the ball grows with the square of the radius \f$ r \f$, and the one of the voxels falls
  with it. With voxels of side \f$ h \f$, radii in proportion to \f$ h^{1/3} \f$ (to \f$ h^{1/2} \f$ if values are grey) make
  both fall.

  \scConcurrencyTag
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param octree the solid
  \param points the points at which the curvatures are estimated
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scPointSetOutputParameters
    \cgalParamNBegin{point_map}
      \cgalParamDescription{the points of the elements of the range}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Point_3`}
      \cgalParamDefault{`CGAL::Identity_property_map`, or the map of a `CGAL::Point_set_3`}
    \cgalParamNEnd
    \cgalParamNBegin{normal_map}
      \cgalParamDescription{the normals of the elements of the range, of any length. They give the tangent plane; where one
                            points into the solid, the curvatures are negated.}
      \cgalParamType{a model of `ReadablePropertyMap` with value type `%Vector_3`}
      \cgalParamDefault{the map of a `CGAL::Point_set_3`; else, of each ball, the direction away from the center of mass of
                        the solid in it}
    \cgalParamNEnd
    \cgalParamNBegin{neighbor_radius}
      \cgalParamDescription{the radius of the ball, in the unit of the points}
      \cgalParamType{`FT`}
      \cgalParamDefault{6 times the longest side of a voxel}
    \cgalParamNEnd
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of points that could not be estimated. Their values are quiet NaN, their status says why:
          `NON_FINITE_INPUT`, or `DEGENERATE` where the ball meets no surface, or one farther away than .6 radii, or another one
          within .4 radii behind it, or a given normal is within some 6° of the tangent plane. The status is `BORDER` where the ball leaves the grid on a side on which the solid reaches the end of
          the grid.

  \throws std::invalid_argument if `neighbor_radius` is not positive, or not finite

  Complexity: \f$ O(n m \log m) \f$ for \f$ n \f$ points with a radius of \f$ m \f$ voxels, as long as the surface passes
  through a ball once: of the voxels, only those where it meets the sphere are looked at.

  \cgalExample{curvature/voxel_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t voxel_curvatures(const Voxel_octree& octree,
                             PointRange&& points,
                             const NamedParameters& np = parameters::default_values())
{
  using Range = std::remove_cv_t<std::remove_reference_t<PointRange> >;
  using Helper = internal::Point_set_helper<Range, NamedParameters>;
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const std::array<double, 3> spacing = octree.spacing();
  const double radius =
      CGAL::to_double(choose_parameter(get_parameter(np, internal_np::neighbor_radius),
                                       6. * *std::max_element(spacing.begin(), spacing.end())));
  const Neighborhood ball = Neighborhood::ball(radius); // checks it
  const auto point_map = Helper::get_const_point_map(points, np);
  std::vector<Eigen::Vector3d> positions, normals;
  for(const auto& item : points)
    positions.push_back(internal::to_eigen(get(point_map, item)));
  if constexpr(internal::may_have_normal_map<Range, NamedParameters>)
  {
    bool has_normals = !parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value;
    if constexpr(internal::Has_own_normal_map<Range>::value)
      has_normals = has_normals || points.has_normal_map();
    if(has_normals)
    {
      const auto normal_map = Helper::get_normal_map(points, np);
      for(const auto& item : points)
        normals.push_back(internal::to_eigen(get(normal_map, item)));
    }
  }
  const internal::Voxel_estimator estimator(octree, std::move(positions), std::move(normals), ball.radius());
  return internal::estimate_points<ConcurrencyTag>(points, estimator.size(), estimator, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_VOXEL_CURVATURES_H
