#ifndef SHAPE_CHARACTERISTICS_CURVATURE_HRBF_CURVATURES_H
#define SHAPE_CHARACTERISTICS_CURVATURE_HRBF_CURVATURES_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/internal/Large_array.h>
#include <Shape_characteristics/curvature/internal/shape_operator.h>
#include <Shape_characteristics/curvature/internal/write_curvatures.h>
#include <Shape_characteristics/internal/is_face_graph.h>
#include <Shape_characteristics/interpolation/fit_hermite_rbf.h>
#include <Shape_characteristics/normals/sampled_surface.h>
#include <Shape_characteristics/sampling/Neighborhood.h>

#include <cstddef>
#include <type_traits>

namespace Shape_characteristics {
namespace internal {

template <typename ConcurrencyTag, typename SampledSurface, typename NamedParameters>
Large_array<Curvature_estimate>
hrbf_estimates(SampledSurface& surface, std::size_t size, const NamedParameters& np)
{
  Large_array<Curvature_estimate> estimates(size, ConcurrencyTag());
  for_each_hermite_rbf_fit<ConcurrencyTag>(
      surface, size, {},
      {[&](const std::size_t i, const Local_implicit_surface& local)
       {
         estimates[i] =
             is_estimated(local.status)
                 ? Curvature_estimate(local.status, curvatures_of_implicit(local.gradient, local.hessian))
                 : Curvature_estimate(local.status);
       },
       [&](const std::size_t i, const Estimation_status status, const Shape_operator_eigen& curvatures)
       { estimates[i] = Curvature_estimate(status, curvatures); }},
      np);
  return estimates;
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the vertices of a mesh by Hermite radial basis functions: an implicit function is
  fitted to the points and normals around each vertex, and has the curvatures of its zero set there (thesis, chapter
  8; M. Prantl, L. Váša, Estimation of differential quantities using Hermite RBF interpolation, 2018).

  This is the accurate estimator: on smooth surfaces that are sampled well, and with exact normals, its error is a millionth
  to a ten-thousandth of the largest curvature, and a finer mesh makes it smaller still: where a polynomial of degree 4 over the
  tangent plane (of degree 3 with other normals) leaves little, the basis function is fitted to what it leaves. Normals that are
  estimated from the mesh, and noise on the points, are dealt with by default: they are weighed against each other by their
  evidence, see `noise_level`. A surface that bends by more than a radian from sample to sample looks a little noisy as well; where it
  is known to be clean, `noise_level(0)` is better. At sharp edges, the values are those of a rounded edge as wide as the neighborhood, and may swing
  beside it; `is_sharp()` finds the edges.

  Where triangles are much longer than wide, as CAD programs make them for cylinders, rings reach farther along them than across.
  There, what the rings hold is fitted after space was compressed along the tangent, until it is at most twice as long as wide (four
  times beside a border), or the normals lean by 45 degrees: a basis function takes all directions alike. Balls, and nearest points,
  don't know of triangles: where points are dense along lines that are far apart, as those of some scanners are, the nearest ones are on
  one line, and the status is `DEGENERATE`; take a radius that reaches over several lines, or as many neighbors.

  A function that was fitted at a vertex also serves vertices near it, where the surface bends little, and where normals that
  are said to be exact fit together: see `fits_are_shared`. Which vertices have a fit of their own follows from the order of
  the vertices and from the edges; so it changes with the order of the input. The mean error is up to some twice that of a
  fit for each vertex.

  With normals that are given, the results follow scaling by powers of two to the last bit. Other scalings and rigid motions they
  follow to 1e-9 of the largest curvature on regular meshes, to some 1e-8 at single vertices of irregular ones (1e-7 where all of the
  surface bends little from sample to sample), to some 1e-9 on point sets at the border, where all the neighbors lie on one
  side, and at tips, and to 1e-6 on fine meshes with normals that are said to be exact and aren't: the systems of equations magnify
  the rounding of the coordinates.

  \scConcurrencyTag
  \tparam FaceGraph a model of `FaceListGraph`; faces may have any number of vertices
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \scMeshOutputParameters
    \scMeshInputParameters
    \scCallbackParameter
    \cgalParamNBegin{normals_are_exact}
      \cgalParamDescription{whether the normals are those of the surface itself, and the points lie on it}
      \cgalParamType{`bool`}
      \cgalParamDefault{`false`}
      \cgalParamExtra{It is checked: where no smooth surface has these points and normals, because a file has rounded them, the
                      points lie beside the surface or normals of the faces are said to be exact, points, normals or both are
                      trusted less, as long as that makes the data much likelier. A surface that bends much between its samples
                      may be doubted, too; a `normal_noise_level` of 0 leaves out the check. Only with a positive definite
                      basis function.}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_rings}
      \cgalParamDescription{the size of the neighborhood, in edges}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`2`}
      \cgalParamExtra{Of \f$ r \f$ rings, the \f$ \max(6 r (r + 1), 48) \f$ nearest vertices take part, twice as many as a
                      regular mesh has; with exact normals \f$ \max(11 r (r + 1) / 3, 22) \f$, and farther ones have a part
                      where the nearest aren't spread over the surface, as at the poles of a sphere of longitudes. With a
                      basis function that isn't positive definite, all take part.}
      \cgalParamExtra{More rings are more accurate where the mesh is fine compared to the shape, and slower. Where there are
                      less than 5 neighbors, up to two rings are added. They are as well where a vertex of the border has less than
                      \f$ 3.9 r (r + 1) \f$ neighbors, with a positive definite basis function and inexact normals.}
    \cgalParamNEnd
    \scRadiusOfMeshParameter
    \cgalParamNBegin{fits_are_shared}
      \cgalParamDescription{whether the function that was fitted at a vertex may serve the vertices near it as well}
      \cgalParamType{`bool`}
      \cgalParamDefault{`true`}
      \cgalParamExtra{`false` takes two to four times as long, and gives each vertex what it would get if it was asked for
                      alone, whatever the order of the input. Only with a positive definite basis function.}
    \cgalParamNEnd
    \cgalParamNBegin{radial_basis_function}
      \cgalParamDescription{the basis function, which chooses the system of equations as well: see `Local_hermite_rbf`}
      \cgalParamType{a model of `RadialBasisFunction`}
      \cgalParamDefault{`Inverse_multiquadric` with exact normals, `Matern_9_2` otherwise}
      \cgalParamExtra{`Polyharmonic<3>()` and `Exponential_cubic()` give the thesis's method. A shape parameter that is set
                      is meant in units of 1/size of the neighborhood (its root mean square radius), that of
                      `Exponential_cubic` of 1/size³.}
    \cgalParamNEnd
    \cgalParamNBegin{noise_level}
      \cgalParamDescription{the standard deviation of the points from the surface, in units of the root mean square distance
                            of the 9 nearest neighbors}
      \cgalParamType{`double`}
      \cgalParamDefault{the likeliest level of the data around some 50 vertices, by their marginal likelihood. A surface
                        that bends much from vertex to vertex may be rougher there than the basis function would have it. Each of
                        several passes expects all of that level, or a part of it, down to a tenth, where trial
                        passes over some parts of the surface flatten its bends.}
      \cgalParamExtra{Only with a positive definite basis function and inexact normals.}
    \cgalParamNEnd
    \cgalParamNBegin{normal_noise_level}
      \cgalParamDescription{the standard deviation of the components of the unit normals from those of the surface}
      \cgalParamType{`double`}
      \cgalParamDefault{\f$ \sqrt{0.1} \f$: estimated normals are weak evidence beside good points}
      \cgalParamExtra{Small values are for normals that are more exact than the points, as those of a photometric
                      measurement. Only with a positive definite basis function and inexact normals, but for 0, which leaves out
                      the check of exact ones.}
    \cgalParamNEnd
    \cgalParamNBegin{number_of_passes}
      \cgalParamDescription{how often points and normals are fitted, from 1 to 1000; each pass hands on smoothed ones}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{1 if the noise level is below 0.0001, else 3}
      \cgalParamExtra{Only with a positive definite basis function and inexact normals.}
    \cgalParamNEnd
    \cgalParamNBegin{polynomial_degree}
      \cgalParamDescription{the degree of a polynomial, from -1 to 8, that is added to the basis functions, whose weights see no
                            polynomial of that degree then}
      \cgalParamType{an integer type}
      \cgalParamDefault{`-1`: none, as in the thesis}
      \cgalParamExtra{\f$ (t - 1)/2 \f$ makes the system of `Polyharmonic<t>` definite, \f$ t/2 \f$ that of
                      `Polyharmonic_logarithmic<t>`. Without it, those of \f$ t \geq 5 \f$ are nearly singular for some
                      neighborhoods, and the curvatures there far off. The degree is lower where there are less than twice as
                      many equations as monomials. Only with a basis function that isn't positive definite.}
    \cgalParamNEnd
    \cgalParamNBegin{sampling_distance}
      \cgalParamDescription{the minimal distance in the Poisson-disc pattern over which derivatives are averaged (8.1.3), in (0, 1]}
      \cgalParamType{`double`}
      \cgalParamDefault{`0.3`}
      \cgalParamExtra{Only with another basis function and inexact normals.}
    \cgalParamNEnd
    \cgalParamNBegin{random_seed}
      \cgalParamDescription{chooses that pattern}
      \cgalParamType{an integer type}
      \cgalParamDefault{`4`}
    \cgalParamNEnd
    \cgalParamNBegin{shape_parameter_box}
      \cgalParamDescription{the box that gives `Exponential_cubic` its shape parameter (8.1.1)}
      \cgalParamType{`Shape_parameter_box`}
      \cgalParamDefault{`Shape_parameter_box::AXIS_ALIGNED`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the number of vertices that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument if a parameter has a value without meaning (no rings, a radius that isn't positive, a
          basis function that isn't valid or has no second derivatives at the origin, a negative noise level, no passes)

  Complexity: linear in the number of vertices \f$ n \f$: \f$ O(n m^3) \f$ for neighborhoods of \f$ m \f$ vertices.

  \cgalExample{curvature/hrbf_curvatures.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_face_graph<FaceGraph> > >
std::size_t hrbf_curvatures(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
{
  Face_graph_samples surface = sampled_surface<ConcurrencyTag>(mesh, internal::mesh_neighborhood(np), np);
  auto estimates = internal::hrbf_estimates<ConcurrencyTag>(surface, surface.size(), np);
  return internal::write_to_mesh(mesh, surface, estimates, np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at one vertex of a mesh, as `hrbf_curvatures()` of the whole mesh does.

  \param v the vertex
  \param mesh the mesh
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": those of the whole mesh, with
         other outputs:

  \cgalNamedParamsBegin
    \scVertexOutputParameters
  \cgalNamedParamsEnd

  With exact normals the result has the bits of the whole mesh's with `fits_are_shared(false)`. With inexact ones, the
  noise level comes from the surroundings of the vertex alone; give `noise_level` for all vertices to be treated alike.
  The radius of the Poisson-disc pattern of the thesis's method comes from the surroundings as well.

  \return whether the curvatures were estimated, or why not

  \throws std::invalid_argument as for the whole mesh

  Complexity: that of the neighborhood, whatever the size of the mesh.
*/
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Estimation_status hrbf_curvatures(typename internal::Vertex_descriptor<FaceGraph>::type v,
                                  const FaceGraph& mesh,
                                  const NamedParameters& np = parameters::default_values())
{
  Face_graph_samples surface =
      sampled_surface(v, mesh, internal::mesh_neighborhood(np), internal::reach_of_hermite_rbf(np), np);
  const auto estimates = internal::hrbf_estimates<CGAL::Sequential_tag>(surface, 1, np);
  return internal::write_to_references(estimates[0], np);
}

/*!
  \ingroup PkgShapeCharacteristicsCurvature

  estimates the curvatures at the points of a point set with normals, as `hrbf_curvatures()` of a mesh does.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam PointRange a model of `ConstRange`
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param points the point set
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters": those of the mesh that describe the method,
         and:

  \cgalNamedParamsBegin
    \scPointSetOutputParameters
    \scPointSetInputParameters
    \cgalParamNBegin{number_of_neighbors}
      \cgalParamDescription{the size of the neighborhood: as many nearest points}
      \cgalParamType{`unsigned int`}
      \cgalParamDefault{`18`}
    \cgalParamNEnd
    \scRadiusOfPointSetParameter
    \scCallbackParameter
  \cgalNamedParamsEnd

  \return the number of points that could not be estimated. Their values are quiet NaN, their status says why.

  \throws std::invalid_argument as for meshes, and if there is no normal map

  Complexity: \f$ O(n (\log n + m^3)) \f$ for \f$ n \f$ points with neighborhoods of \f$ m \f$.

  \cgalExample{curvature/hrbf_point_set.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<internal::is_point_range<PointRange> >,
          typename = void>
std::size_t hrbf_curvatures(PointRange&& points, const NamedParameters& np = parameters::default_values())
{
  Point_set_samples surface = sampled_surface(points, internal::point_set_neighborhood(np), np);
  const auto estimates = internal::hrbf_estimates<ConcurrencyTag>(surface, surface.size(), np);
  return internal::write_to_points(points, estimates, np);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_CURVATURE_HRBF_CURVATURES_H
