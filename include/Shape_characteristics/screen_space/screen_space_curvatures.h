#ifndef SHAPE_CHARACTERISTICS_SCREEN_SPACE_SCREEN_SPACE_CURVATURES_H
#define SHAPE_CHARACTERISTICS_SCREEN_SPACE_SCREEN_SPACE_CURVATURES_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/screen_space/G_buffer.h>
#include <Shape_characteristics/screen_space/internal/Screen_space_estimator.h>
#include <Shape_characteristics/screen_space/internal/Screen_space_options.h>
#include <Shape_characteristics/screen_space/internal/for_each_pixel.h>

#include <CGAL/tags.h>

#include <cstddef>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsScreenSpace

  estimates the curvatures of what a picture shows, at each of its pixels, from depths and normals alone (thesis, chapter 7).

  The points and normals of a pixel and of its neighbors to the right, above, to the left and below make a fan of up to four triangles. The shape operator is
  the one that, by least squares, best explains how normals differ along the triangles' edges, in the plane of the fan (7.3 - 7.11; the inverse
  in (7.7) is divided by the determinant, and has \f$ r(p + r) - q^2 \f$ and \f$ p(p + r) - q^2 \f$ at its corners; (7.11) has
  \f$ u_2 b_3 + v_2 b_5 \f$); the principal curvatures are its eigenvalues. With one triangle this is the thesis's method; with two or four, opposite triangles cancel each
  other's first-order error. (The thesis averages the curvatures of triangles. One system for all of them is as accurate and does not suffer from
  triangles that are seen almost from their side.)

  Neighbors are one pixel away, or as many as `level_of_detail` says; `depth_discontinuity_rule` tells whether they are on the same surface. Triangles with
  neighbors that aren't, that are background, or without a usable normal, are left out, and those of the other sides take their
  place.

  `Screen_space_curvature_pass` is the same on the GPU.

  \scConcurrencyTag
  \tparam GBuffer a model of the concept `GBuffer`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param g_buffer depths, normals and the camera. Without pixels nothing is done.
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below.
         All maps are keyed by the pixel's index, a `std::size_t`; `CGAL::make_property_map()` makes one of an array.

  \cgalNamedParamsBegin
    \cgalParamNBegin{min_curvature_map}
      \cgalParamDescription{a property map in which the smaller principal curvatures are written}
      \cgalParamType{a model of `WritablePropertyMap` with value type `float`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{max_curvature_map}
      \cgalParamDescription{a property map in which the larger principal curvatures are written}
      \cgalParamType{a model of `WritablePropertyMap` with value type `float`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{mean_curvature_map}
      \cgalParamDescription{a property map in which the mean curvatures are written}
      \cgalParamType{a model of `WritablePropertyMap` with value type `float`}
      \cgalParamDefault{not computed}
    \cgalParamNEnd
    \cgalParamNBegin{Gaussian_curvature_map}
      \cgalParamDescription{a property map in which the %Gaussian curvatures are written}
      \cgalParamType{a model of `WritablePropertyMap` with value type `float`}
      \cgalParamDefault{not computed}
    \cgalParamNEnd
    \cgalParamNBegin{shape_index_map}
      \cgalParamDescription{a property map in which the shape indices are written; NaN where both curvatures are 0}
      \cgalParamType{a model of `WritablePropertyMap` with value type `float`}
      \cgalParamDefault{not computed}
    \cgalParamNEnd
    \cgalParamNBegin{status_map}
      \cgalParamDescription{a property map in which is written whether each pixel has values and if not why. Background is `UNREFERENCED`.}
      \cgalParamType{a model of `WritablePropertyMap` with value type `Estimation_status`}
      \cgalParamDefault{not written}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_triangles}
      \cgalParamDescription{how many triangles are taken, 1 to 4}
      \cgalParamType{`int`}
      \cgalParamDefault{`4`}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_edges}
      \cgalParamDescription{from how many edges the shape operator of a triangle is fitted, 2 (7.11) or 3 (7.10)}
      \cgalParamType{`int`}
      \cgalParamDefault{`2`}
    \cgalParamNEnd
    \cgalParamNBegin{level_of_detail}
      \cgalParamDescription{how many pixels away the neighbors are}
      \cgalParamType{`Level_of_detail`}
      \cgalParamDefault{`Level_of_detail::none()`: one pixel}
    \cgalParamNEnd
    \cgalParamNBegin{depth_discontinuity_rule}
      \cgalParamDescription{how neighbors on other surfaces are told apart}
      \cgalParamType{`Depth_discontinuity_rule`}
      \cgalParamDefault{`Depth_discontinuity_rule::TANGENT_PLANES`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of pixels that show a surface and could not be estimated. Their values, and those of the background, are quiet NaN.

  \throws std::invalid_argument if a parameter is out of its range

  Complexity: linear in the number of pixels; constant memory beside the maps.

  \cgalExample{screen_space/screen_space_curvature.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename GBuffer,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t screen_space_curvatures(const GBuffer& g_buffer,
                                    const NamedParameters& np = parameters::default_values())
{
  const internal::Screen_space_options options(np);
  if(g_buffer.width() <= 0 || g_buffer.height() <= 0)
    return 0;
  const internal::Screen_space_pass pass(options, g_buffer.camera(), g_buffer.normal_space(),
                                         g_buffer.width(), g_buffer.height());
  return internal::for_each_pixel<ConcurrencyTag>(
      g_buffer, internal::Screen_space_estimator<GBuffer>(g_buffer, pass), np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SCREEN_SPACE_SCREEN_SPACE_CURVATURES_H
