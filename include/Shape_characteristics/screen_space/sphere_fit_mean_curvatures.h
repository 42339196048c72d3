#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_SPHERE_FIT_MEAN_CURVATURES_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_SPHERE_FIT_MEAN_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/screen_space/G_buffer.h>
#include <Shape_characteristics/screen_space/Screen_space_curvature.h>
#include <Shape_characteristics/screen_space/internal/Screen_frame.h>
#include <Shape_characteristics/screen_space/internal/Screen_space_estimator.h>
#include <Shape_characteristics/screen_space/internal/for_each_pixel.h>
#include <Shape_characteristics/screen_space/internal/pixel_radius.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Shape_characteristics {
namespace internal {

// The curvature at one pixel. shaders/sphere_fit_mean_curvature.glsl is the same, line by line, and has to stay so.
template <typename GBuffer>
class Sphere_fit_estimator
{
public:
  Sphere_fit_estimator(const GBuffer& g_buffer, int radius)
    : m_g_buffer(g_buffer),
      m_frame(g_buffer.camera(), g_buffer.normal_space(), g_buffer.width(), g_buffer.height()),
      m_width(g_buffer.width()),
      m_height(g_buffer.height()),
      m_radius(radius)
  {}

  Screen_space_curvature operator()(int x, int y) const
  {
    Screen_space_curvature result;
    const std::size_t center = m_g_buffer.index(x, y);
    const float center_depth = m_g_buffer.depth(center);
    if(!m_frame.is_surface(center_depth))
    {
      result.status =
          std::isnan(center_depth) ? Estimation_status::NON_FINITE_INPUT : Estimation_status::UNREFERENCED;
      return result;
    }
    if(std::isnan(unit_view_normal(m_frame, m_g_buffer.normal(center)).x()))
    {
      result.status = Estimation_status::NON_FINITE_INPUT;
      return result;
    }

    // sums with weights: of 1, points, normals, p n, p p. Points are relative to the center, in units of the radius.
    const float radius = float(m_radius), unit = m_frame.footprint(center_depth) * radius;
    float sum = 0.f, sum_pn = 0.f, sum_pp = 0.f;
    Eigen::Vector3f sum_p = Eigen::Vector3f::Zero(), sum_n = Eigen::Vector3f::Zero();
    int count = 0;
    bool is_one_sided = false;
    for(int dy = 1 - m_radius; dy < m_radius; ++dy)
      for(int dx = 1 - m_radius; dx < m_radius; ++dx)
      {
        const int squared = dx * dx + dy * dy;
        if(squared >= m_radius * m_radius)
          continue;
        const int px = x + dx, py = y + dy;
        bool is_usable = px >= 0 && py >= 0 && px < m_width && py < m_height;
        if(is_usable)
        {
          const std::size_t pixel = m_g_buffer.index(px, py);
          const float depth = m_g_buffer.depth(pixel);
          is_usable = m_frame.is_surface(depth);
          if(is_usable)
          {
            const Eigen::Vector3f n = unit_view_normal(m_frame, m_g_buffer.normal(pixel));
            const Eigen::Vector3f p = m_frame.edge(center_depth, unit, depth, px, py, 0, 0) +
                                      Eigen::Vector3f(m_frame.pixel_edge[0] * float(dx) / radius,
                                                      m_frame.pixel_edge[1] * float(dy) / radius, 0.f);
            is_usable = std::abs(p.z()) <= 2.f && !std::isnan(n.x());
            if(is_usable)
            {
              const float t = (std::max)(1.f - p.dot(p), 0.f), weight = t * t;
              sum += weight;
              sum_p += weight * p;
              sum_n += weight * n;
              sum_pn += weight * p.dot(n);
              sum_pp += weight * p.dot(p);
              count += t > 0.f;
            }
          }
        }
        is_one_sided = is_one_sided || !is_usable;
      }
    if(count < 4)
    {
      result.status = Estimation_status::FEW_NEIGHBOURS;
      return result;
    }

    // the algebraic sphere c + l x + q x x whose gradient is nearest to the normals
    const float q = 0.5f * (sum_pn - sum_p.dot(sum_n) / sum) / (sum_pp - sum_p.dot(sum_p) / sum);
    const Eigen::Vector3f l = (sum_n - 2.f * q * sum_p) / sum;
    const float c = -(l.dot(sum_p) + q * sum_pp) / sum;
    const float curvature = 2.f * q / (std::sqrt(l.dot(l) - 4.f * c * q) * unit);
    if(!std::isfinite(curvature))
    {
      result.status = Estimation_status::DEGENERATE;
      return result;
    }
    result.min_curvature = result.max_curvature = curvature;
    result.status = is_one_sided ? Estimation_status::BORDER : Estimation_status::ESTIMATED;
    return result;
  }

private:
  const GBuffer& m_g_buffer;
  Screen_frame m_frame;
  int m_width, m_height, m_radius;
};

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  estimates the mean curvatures of what a picture shows, at each of its pixels, by the method of Mellado et al.
  \cgalCite{mellado_screen} \cgalCite{mellado} (thesis, section 5.4.1): the sphere that fits best to the points and normals in a
  ball around the pixel's. The radius is given in pixels; how large it is in the scene depends on the distance. Nearer points
  weigh more.

  A baseline for `screen_space_curvatures()`, which tells principal curvatures as well, at the cost of five pixels instead of some two
  hundred. It smooths: details smaller than the radius are lost, and near silhouettes and creases the sphere is fitted to both sides.

  `Sphere_fit_mean_curvature_pass` is the same on the GPU.

  \scConcurrencyTag
  \tparam GBuffer a model of the concept `GBuffer`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param g_buffer depths, normals and the camera. Without pixels nothing is done.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below.
         All maps are keyed by the pixel's index, a `std::size_t`.

  \cgalNamedParamsBegin
    \cgalParamNBegin{mean_curvature_map}
      \cgalParamDescription{a property map in which the mean curvatures are written: those of spheres, which
                            `min_curvature_map` and `max_curvature_map` get as well}
      \cgalParamType{a model of `WritablePropertyMap` with value type `float`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{status_map}
      \cgalParamDescription{a property map in which is written whether each pixel has a value and if not why. Background is `UNREFERENCED`; `BORDER`
                            says that there are pixels within the radius that show no surface, or one far behind or in front.}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Estimation_status`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{pixel_radius}
      \cgalParamDescription{the radius of the ball, in pixels, 2 to 64}
      \cgalParamType{`int`}
      \cgalParamDefault{`8`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of pixels that show a surface and could not be estimated. Their values, and those of the background, are quiet NaN.

  \throws std::invalid_argument if a parameter is out of its range

  Complexity: the number of pixels times the square of the radius.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename GBuffer,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t sphere_fit_mean_curvatures(const GBuffer& g_buffer,
                                       const NamedParameters& np = parameters::default_values())
{
  using parameters::is_default_parameter;
  static_assert(is_default_parameter<NamedParameters, internal_np::Gaussian_curvature_map_t>::value &&
                    is_default_parameter<NamedParameters, internal_np::shape_index_map_t>::value,
                "Shape_characteristics: sphere_fit_mean_curvatures() fits spheres, which tell neither "
                "Gaussian_curvature_map nor shape_index_map");
  const int radius = internal::pixel_radius(np);
  if(g_buffer.width() <= 0 || g_buffer.height() <= 0)
    return 0;
  return internal::for_each_pixel<ConcurrencyTag>(
      g_buffer, internal::Sphere_fit_estimator<GBuffer>(g_buffer, radius), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_SPHERE_FIT_MEAN_CURVATURES_H
