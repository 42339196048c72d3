#ifndef SHAPE_CHARACTERISTICS_TEST_BAD_INPUTS_ESTIMATOR_LIST_H
#define SHAPE_CHARACTERISTICS_TEST_BAD_INPUTS_ESTIMATOR_LIST_H

#include "estimators.h"

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/Principal_curvatures_and_directions.h>
#include <Shape_characteristics/curvature/adaptive_curvatures.h>
#include <Shape_characteristics/curvature/batagelo_wu_curvatures.h>
#include <Shape_characteristics/curvature/boschiroli_curvatures.h>
#include <Shape_characteristics/curvature/goldfeather_interrante_curvatures.h>
#include <Shape_characteristics/curvature/hildebrandt_polthier_curvatures.h>
#include <Shape_characteristics/curvature/hrbf_curvatures.h>
#include <Shape_characteristics/curvature/integral_invariant_curvatures.h>
#include <Shape_characteristics/curvature/jet_fitting_curvatures.h>
#include <Shape_characteristics/curvature/kalogerakis_curvatures.h>
#include <Shape_characteristics/curvature/kalogerakis_normals.h>
#include <Shape_characteristics/curvature/meyer_curvatures.h>
#include <Shape_characteristics/curvature/moving_least_squares_curvatures.h>
#include <Shape_characteristics/curvature/normal_cycle_curvatures.h>
#include <Shape_characteristics/curvature/razdan_bae_curvatures.h>
#include <Shape_characteristics/curvature/rusinkiewicz_curvatures.h>
#include <Shape_characteristics/curvature/tangent_space_curvatures.h>
#include <Shape_characteristics/curvature/taubin_curvatures.h>
#include <Shape_characteristics/curvature/theisel_curvatures.h>
#include <Shape_characteristics/curvature/zhihong_curvatures.h>
#include <Shape_characteristics/interpolation/Exponential_cubic.h>
#include <Shape_characteristics/interpolation/Polyharmonic.h>
#include <Shape_characteristics/normals/hrbf_normals.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace bad_inputs {

namespace internal {

// maps of vertices and of points to the places of an array
template <typename Input, typename T>
struct Slots;

template <typename T>
struct Slots<Mesh, T>
{
  using key_type = Mesh::Vertex_index;
  using value_type = T;
  using reference = T&;
  using category = boost::writable_property_map_tag;

  T* first;
  Slots(std::vector<T>& slots, const Mesh&) : first(slots.data()) {}
  friend void put(const Slots& map, key_type v, const T& value) { map.first[std::size_t(v)] = value; }
};

template <typename T>
struct Slots<Point_set, T>
{
  using key_type = Oriented_point;
  using value_type = T;
  using reference = T&;
  using category = boost::writable_property_map_tag;

  T* first;
  const Oriented_point* begin;
  Slots(std::vector<T>& slots, const Point_set& points) : first(slots.data()), begin(points.data()) {}
  friend void put(const Slots& map, const Oriented_point& p, const T& value)
  {
    map.first[&p - map.begin] = value;
  }
};

struct Points_of
{
  using key_type = Oriented_point;
  using value_type = Point_3;
  using reference = const Point_3&;
  using category = boost::readable_property_map_tag;
  friend const Point_3& get(Points_of, const Oriented_point& p) { return p.point; }
};

struct Normals_of
{
  using key_type = Oriented_point;
  using value_type = Vector_3;
  using reference = const Vector_3&;
  using category = boost::readable_property_map_tag;
  friend const Vector_3& get(Normals_of, const Oriented_point& p) { return p.normal; }
};

using Curvatures = SC::Principal_curvatures_and_directions<Kernel>;

inline std::vector<double> values_of(const Curvatures& c, double mean, double Gaussian)
{
  return {c.min_curvature,
          c.max_curvature,
          mean,
          Gaussian,
          c.min_direction.x(),
          c.min_direction.y(),
          c.min_direction.z(),
          c.max_direction.x(),
          c.max_direction.y(),
          c.max_direction.z()};
}

inline Curvatures unwritten_curvatures()
{
  const Vector_3 v(unwritten, unwritten, unwritten);
  return Curvatures(unwritten, unwritten, v, v);
}

inline std::size_t number_of_slots(const Mesh& mesh)
{
  return mesh.number_of_vertices() + mesh.number_of_removed_vertices();
}
inline std::size_t number_of_slots(const Point_set& points)
{
  return points.size();
}

inline auto input_parameters(const Mesh& mesh)
{
  return SC::parameters::vertex_point_map(mesh.points());
}
inline auto input_parameters(const Point_set&)
{
  return SC::parameters::point_map(Points_of()).normal_map(Normals_of());
}

template <typename Input, typename Function, typename Parameters>
Results all_curvatures(const Input& input, const Function& function, const Parameters& parameters)
{
  const std::size_t n = number_of_slots(input);
  std::vector<Estimation_status> status(n, Estimation_status::CANCELLED);
  std::vector<Curvatures> curvatures(n, unwritten_curvatures());
  std::vector<double> mean(n, unwritten), Gaussian(n, unwritten);
  const Slots<Input, Curvatures> curvature_map(curvatures, input);
  const Slots<Input, double> mean_map(mean, input), Gaussian_map(Gaussian, input);
  const Slots<Input, Estimation_status> status_map(status, input);

  Results results;
  const auto np = parameters(input_parameters(input), input);
  if constexpr(std::is_same_v<Input, Mesh>)
    results.failures = function(input, np.vertex_principal_curvatures_and_directions_map(curvature_map)
                                           .vertex_mean_curvature_map(mean_map)
                                           .vertex_Gaussian_curvature_map(Gaussian_map)
                                           .vertex_status_map(status_map));
  else
    results.failures = function(input, np.principal_curvatures_and_directions_map(curvature_map)
                                           .mean_curvature_map(mean_map)
                                           .Gaussian_curvature_map(Gaussian_map)
                                           .status_map(status_map));
  for(std::size_t i = 0; i < n; ++i)
    results.samples.push_back({status[i], values_of(curvatures[i], mean[i], Gaussian[i])});
  return results;
}

template <typename Function, typename Parameters>
Estimate
one_curvature(Mesh::Vertex_index v, const Mesh& mesh, const Function& function, const Parameters& parameters)
{
  Curvatures curvatures = unwritten_curvatures();
  double mean = unwritten, Gaussian = unwritten;
  const auto np = parameters(input_parameters(mesh), mesh);
  const Estimation_status status =
      function(v, mesh,
               np.vertex_principal_curvatures_and_directions(std::ref(curvatures))
                   .vertex_mean_curvature(std::ref(mean))
                   .vertex_Gaussian_curvature(std::ref(Gaussian)));
  return {status, values_of(curvatures, mean, Gaussian)};
}

template <typename Input, typename Function, typename Parameters>
Results all_normals(const Input& input, const Function& function, const Parameters& parameters)
{
  const std::size_t n = number_of_slots(input);
  std::vector<Estimation_status> status(n, Estimation_status::CANCELLED);
  std::vector<Vector_3> normals(n, Vector_3(unwritten, unwritten, unwritten));
  const Slots<Input, Vector_3> normal_map(normals, input);
  const Slots<Input, Estimation_status> status_map(status, input);

  Results results;
  const auto np = parameters(input_parameters(input), input);
  if constexpr(std::is_same_v<Input, Mesh>)
    results.failures = function(input, normal_map, np.vertex_status_map(status_map));
  else
    results.failures = function(input, normal_map, np.status_map(status_map));
  for(std::size_t i = 0; i < n; ++i)
    results.samples.push_back({status[i], {normals[i].x(), normals[i].y(), normals[i].z()}});
  return results;
}

template <typename Input>
class List
{
public:
  // `parameters(np, input)` adds the estimator's own to the parameters that describe the input.
  template <typename Function, typename Parameters>
  Estimator<Input>&
  add_curvatures(const std::string& name, const Function& function, const Parameters& parameters)
  {
    Estimator<Input> estimator;
    estimator.name = name;
    estimator.all = [=](const Input& input) { return all_curvatures(input, function, parameters); };
    if constexpr(std::is_same_v<Input, Mesh>)
      estimator.one = [=](const Mesh::Vertex_index v, const Mesh& mesh)
      { return one_curvature(v, mesh, function, parameters); };
    m_estimators.push_back(estimator);
    return m_estimators.back();
  }

  template <typename Function, typename Parameters>
  Estimator<Input>&
  add_normals(const std::string& name, const Function& function, const Parameters& parameters)
  {
    Estimator<Input> estimator;
    estimator.name = name;
    estimator.gives_curvatures = false;
    estimator.all = [=](const Input& input) { return all_normals(input, function, parameters); };
    m_estimators.push_back(estimator);
    return m_estimators.back();
  }

  const std::vector<Estimator<Input>>& estimators() const { return m_estimators; }

private:
  std::vector<Estimator<Input>> m_estimators;
};

// of an estimator that measures the Gaussian curvature by itself
inline void announce_measured_Gaussian(Estimator<Mesh>& estimator)
{
  estimator.all = [all = estimator.all](const Mesh& mesh)
  {
    Results results = all(mesh);
    for(Estimate& e : results.samples)
      e.products_agree = false;
    return results;
  };
  estimator.one = [one = estimator.one](const Mesh::Vertex_index v, const Mesh& mesh)
  {
    Estimate e = one(v, mesh);
    e.products_agree = false;
    return e;
  };
}

} // namespace internal

template <typename Input>
std::vector<Estimator<Input>> estimators()
{
  const auto hrbf = [](auto&&... a) { return SC::hrbf_curvatures(std::forward<decltype(a)>(a)...); };
  const auto adaptive = [](auto&&... a) { return SC::adaptive_curvatures(std::forward<decltype(a)>(a)...); };
  const auto jet_fitting = [](auto&&... a)
  { return SC::jet_fitting_curvatures(std::forward<decltype(a)>(a)...); };
  const auto goldfeather_interrante = [](auto&&... a)
  { return SC::goldfeather_interrante_curvatures(std::forward<decltype(a)>(a)...); };
  const auto normals = [](auto&&... a) { return SC::hrbf_normals(std::forward<decltype(a)>(a)...); };
  const auto defaults = [](const auto& np, const auto&) { return np; };

  internal::List<Input> list;
  for(const bool shared : {true, false})
  {
    Estimator<Input>& e =
        shared ? list.add_curvatures("hrbf", hrbf, defaults)
               : list.add_curvatures("hrbf, a fit each", hrbf,
                                     [](const auto& np, const auto&) { return np.fits_are_shared(false); });
    e.is_local = false;                       // the level of noise is that of the whole
    e.difference_of_fits = shared ? .35 : 0.; // the surfaces are coarse
    e.accuracy = shared ? .004 : .002;
  }
  for(const bool shared : {true, false})
  {
    Estimator<Input>& e =
        shared ? list.add_curvatures("hrbf, exact normals", hrbf,
                                     [](const auto& np, const auto&) { return np.normals_are_exact(true); })
               : list.add_curvatures("hrbf, exact normals, a fit each", hrbf,
                                     [](const auto& np, const auto&)
                                     { return np.normals_are_exact(true).fits_are_shared(false); });
    e.is_local = !shared;
    e.difference_of_fits =
        shared ? std::numeric_limits<double>::infinity() : 0.; // normals of faces aren't exact
    e.accuracy = shared ? .35 : .15;
  }
  {
    Estimator<Input>& e =
        list.add_curvatures("hrbf, Polyharmonic<3>, exact normals", hrbf,
                            [](const auto& np, const auto&) {
                              return np.radial_basis_function(SC::Polyharmonic<3>()).normals_are_exact(true);
                            });
    e.accuracy = .15;
  }
  {
    Estimator<Input>& e = list.add_curvatures("hrbf, Polyharmonic<3>", hrbf,
                                              [](const auto& np, const auto&)
                                              { return np.radial_basis_function(SC::Polyharmonic<3>()); });
    e.is_local = false;
    e.has_pattern = true;
    e.accuracy = .1;
  }
  {
    Estimator<Input>& e = list.add_curvatures(
        "hrbf, Exponential_cubic, exact normals", hrbf,
        [](const auto& np, const auto&)
        { return np.radial_basis_function(SC::Exponential_cubic()).normals_are_exact(true); });
    e.has_box = true;
    e.accuracy = 4.; // its matrix is indefinite: some neighborhoods give nonsense
  }
  {
    Estimator<Input>& e = list.add_curvatures("adaptive", adaptive, defaults);
    e.is_local = false;                                             // nor is its level of noise
    e.difference_of_fits = std::numeric_limits<double>::infinity(); // it may choose another fit
    e.accuracy = .01;
    e.reproducibility = 1e-7; // its scores magnify what differs between fits
  }
  list.add_curvatures("jet_fitting", jet_fitting, defaults).accuracy = .005;
  list.add_curvatures("goldfeather_interrante", goldfeather_interrante, defaults).accuracy = .05;
  const auto batagelo_wu = [](auto&&... a)
  { return SC::batagelo_wu_curvatures(std::forward<decltype(a)>(a)...); };
  const auto moving_least_squares = [](auto&&... a)
  { return SC::moving_least_squares_curvatures(std::forward<decltype(a)>(a)...); };
  const auto razdan_bae = [](auto&&... a)
  { return SC::razdan_bae_curvatures(std::forward<decltype(a)>(a)...); };
  const auto kalogerakis = [](auto&&... a)
  { return SC::kalogerakis_curvatures(std::forward<decltype(a)>(a)...); };
  list.add_curvatures("batagelo_wu", batagelo_wu, defaults).accuracy = .05;
  {
    Estimator<Input>& e = list.add_curvatures("moving_least_squares", moving_least_squares, defaults);
    e.sight = 6; // three rings
    e.needs_smoothness = true;
    e.accuracy = .5; // it sees how the points are spread
  }
  {
    Estimator<Input>& e = list.add_curvatures("razdan_bae", razdan_bae, defaults);
    e.accuracy = .05;
  }
  {
    Estimator<Input>& e = list.add_curvatures("kalogerakis", kalogerakis, defaults);
    e.resolution = 2.;
    e.sight = 8; // neighbors of neighbors of neighbors
    e.accuracy = .1;
  }
  if constexpr(std::is_same_v<Input, Mesh>)
  {
    const auto rusinkiewicz = [](auto&&... a)
    { return SC::rusinkiewicz_curvatures(std::forward<decltype(a)>(a)...); };
    const auto tangent_space = [](auto&&... a)
    { return SC::tangent_space_curvatures(std::forward<decltype(a)>(a)...); };
    for(const bool averages : {true, false})
    {
      Estimator<Input>& e = averages ? list.add_curvatures("rusinkiewicz", rusinkiewicz, defaults)
                                     : list.add_curvatures("tangent_space", tangent_space, defaults);
      e.needs_triangles = true;
      e.flips_exactly = false; // a flipped triangle starts with another edge
      e.accuracy = .05;
    }
    const auto theisel = [](auto&&... a) { return SC::theisel_curvatures(std::forward<decltype(a)>(a)...); };
    const auto meyer = [](auto&&... a) { return SC::meyer_curvatures(std::forward<decltype(a)>(a)...); };
    const auto taubin = [](auto&&... a) { return SC::taubin_curvatures(std::forward<decltype(a)>(a)...); };
    {
      Estimator<Input>& e = list.add_curvatures("theisel", theisel, defaults);
      e.needs_triangles = true;
      e.accuracy = .05;
    }
    {
      Estimator<Input>& e = list.add_curvatures("meyer", meyer, defaults);
      e.measures_areas = true;
      internal::announce_measured_Gaussian(e);
      e.needs_triangles = true;
      e.accuracy = .45; // it doesn't converge on irregular meshes
    }
    {
      Estimator<Input>& e = list.add_curvatures("taubin", taubin, defaults);
      e.needs_triangles = true;
      e.accuracy = .5; // nor does this
    }
    const auto zhihong = [](auto&&... a) { return SC::zhihong_curvatures(std::forward<decltype(a)>(a)...); };
    const auto boschiroli = [](auto&&... a)
    { return SC::boschiroli_curvatures(std::forward<decltype(a)>(a)...); };
    {
      Estimator<Input>& e = list.add_curvatures("zhihong", zhihong, defaults);
      e.needs_triangles = true;
      e.accuracy = .1;
    }
    {
      Estimator<Input>& e = list.add_curvatures("boschiroli", boschiroli, defaults);
      e.needs_triangles = true;
      e.accuracy = .2; // it averages little
    }
    const auto normal_cycle = [](auto&&... a)
    { return SC::normal_cycle_curvatures(std::forward<decltype(a)>(a)...); };
    const auto hildebrandt_polthier = [](auto&&... a)
    { return SC::hildebrandt_polthier_curvatures(std::forward<decltype(a)>(a)...); };
    {
      Estimator<Input>& e = list.add_curvatures("normal_cycle", normal_cycle, defaults);
      e.measures_areas = true;
      e.resolution = 2.;
      e.needs_triangles = true;
      e.accuracy = .2; // a mean over a ball of two edges
    }
    {
      Estimator<Input>& e = list.add_curvatures("hildebrandt_polthier", hildebrandt_polthier, defaults);
      e.measures_areas = true;
      e.resolution = 2.;
      e.needs_triangles = true;
      e.accuracy = .1; // and so is this
    }
    const auto integral_invariant = [](auto&&... a)
    { return SC::integral_invariant_curvatures(std::forward<decltype(a)>(a)...); };
    {
      Estimator<Input>& e = list.add_curvatures("integral_invariant", integral_invariant, defaults);
      e.measures_areas = true;
      e.resolution = 2.;
      e.needs_triangles = true;
      e.flips_exactly = false; // the solid on the other side has other roundings
      e.accuracy = .1;
    }
  }
  {
    Estimator<Input>& e = list.add_normals("hrbf_normals", normals, defaults);
    e.is_local = false;
    e.difference_of_fits = .05;
  }
  const auto robust_normals = [](auto&&... a)
  { return SC::kalogerakis_normals(std::forward<decltype(a)>(a)...); };
  list.add_normals("kalogerakis_normals", robust_normals, defaults);
  return list.estimators();
}

} // namespace bad_inputs

#endif // SHAPE_CHARACTERISTICS_TEST_BAD_INPUTS_ESTIMATOR_LIST_H
