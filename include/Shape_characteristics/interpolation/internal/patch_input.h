#ifndef SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_PATCH_INPUT_H
#define SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_PATCH_INPUT_H

#include <Shape_characteristics/internal/Cubic_triangle.h>
#include <Shape_characteristics/internal/to_eigen.h>
#include <Shape_characteristics/interpolation/Surface_derivatives.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace Shape_characteristics {
namespace internal {

// Where a patch is computed: its first corner is the origin, and the unit of length a power of two, so that neither a
// far position nor the size loses anything.
class Patch_frame
{
public:
  Patch_frame() = default;

  // of corners that are finite
  Patch_frame(const char* who, const std::array<Eigen::Vector3d, 3>& corners) : m_origin(corners[0])
  {
    double size = 0.;
    for(const Eigen::Vector3d& p : corners)
      size = (std::max)(size, (p - m_origin).lpNorm<Eigen::Infinity>());
    if(!std::isfinite(size))
      throw std::invalid_argument(std::string("Shape_characteristics: ") + who +
                                  ": the edges are longer than the largest number");
    if(size == 0.)
      return;
    int exponent;
    std::frexp(size, &exponent);
    m_scale = std::ldexp(1., -(std::max)(exponent, std::numeric_limits<double>::min_exponent));
  }

  Eigen::Vector3d apply(const Eigen::Vector3d& p) const { return (p - m_origin) * m_scale; }

  template <typename GeomTraits>
  typename GeomTraits::Point_3 point(const Eigen::Vector3d& p) const
  {
    using FT = typename GeomTraits::FT;
    const Eigen::Vector3d q = m_origin + p / m_scale;
    return typename GeomTraits::Point_3(FT(q.x()), FT(q.y()), FT(q.z()));
  }

  template <typename GeomTraits>
  typename GeomTraits::Vector_3 vector(const Eigen::Vector3d& d) const
  {
    using FT = typename GeomTraits::FT;
    const Eigen::Vector3d q = d / m_scale;
    return typename GeomTraits::Vector_3(FT(q.x()), FT(q.y()), FT(q.z()));
  }

  template <typename GeomTraits>
  Surface_derivatives<GeomTraits> derivatives(const Patch_jet<double>& jet) const
  {
    return {point<GeomTraits>(jet.point), vector<GeomTraits>(jet.u),  vector<GeomTraits>(jet.v),
            vector<GeomTraits>(jet.uu),   vector<GeomTraits>(jet.uv), vector<GeomTraits>(jet.vv)};
  }

private:
  Eigen::Vector3d m_origin = Eigen::Vector3d::Zero();
  double m_scale = 1.;
};

template <typename Point_3>
Eigen::Vector3d finite_point(const char* who, const Point_3& p)
{
  const Eigen::Vector3d q = to_eigen(p);
  if(!q.allFinite())
    throw std::invalid_argument(std::string("Shape_characteristics: ") + who +
                                ": a coordinate of a point is not finite");
  return q;
}

template <typename Vector_3>
Eigen::Vector3d unit_normal(const char* who, const Vector_3& n)
{
  const Eigen::Vector3d d = to_eigen(n);
  const double largest = d.lpNorm<Eigen::Infinity>();
  if(!d.allFinite() || !(largest > 0.))
    throw std::invalid_argument(std::string("Shape_characteristics: ") + who +
                                ": a normal is zero or not finite");
  return (d / largest).normalized();
}

template <typename FT>
std::array<double, 3> barycentric(const std::array<FT, 3>& c)
{
  return {CGAL::to_double(c[0]), CGAL::to_double(c[1]), CGAL::to_double(c[2])};
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERPOLATION_INTERNAL_PATCH_INPUT_H
