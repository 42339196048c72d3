#ifndef SHAPE_CHARACTERISTICS_SAMPLING_NEIGHBORHOOD_H
#define SHAPE_CHARACTERISTICS_SAMPLING_NEIGHBORHOOD_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/internal/whole_number.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace Shape_characteristics {

/*!
  \ingroup PkgShapeCharacteristicsSampling

  says which samples of a surface are the neighbors of a sample: those reached by at most so many edges of a
  mesh, those in a ball, or so many nearest ones (thesis, chapter 2).
*/
class Neighborhood
{
public:
  /// what limits the neighborhood
  enum class Kind : unsigned char
  {
    RINGS,  ///< the number of edges on the way (meshes)
    BALL,   ///< the Euclidean distance; on meshes, along a path of edges that doesn't leave the ball
    NEAREST ///< the number of neighbors (point sets)
  };

  /// the samples at 1 to `number_of_rings` edges
  /// \throws std::invalid_argument if `number_of_rings` is 0
  static Neighborhood rings(unsigned int number_of_rings)
  {
    if(number_of_rings == 0)
      throw std::invalid_argument("Shape_characteristics: number_of_rings must be positive");
    return Neighborhood(Kind::RINGS, number_of_rings, 0.);
  }

  /// the samples at a distance of at most `radius`, to six digits: of those that are as far but for rounding, all
  /// \throws std::invalid_argument if `radius` is not positive and finite
  static Neighborhood ball(double radius)
  {
    if(!(radius > 0.) || !std::isfinite(radius))
      throw std::invalid_argument("Shape_characteristics: neighbor_radius must be positive and finite");
    return Neighborhood(Kind::BALL, 0, radius);
  }

  /// the `number_of_neighbors` nearest samples
  /// \throws std::invalid_argument if `number_of_neighbors` is 0
  static Neighborhood nearest(std::size_t number_of_neighbors)
  {
    if(number_of_neighbors == 0)
      throw std::invalid_argument("Shape_characteristics: number_of_neighbors must be positive");
    return Neighborhood(Kind::NEAREST, number_of_neighbors, 0.);
  }

  Kind kind() const noexcept { return m_kind; }          ///< what limits the neighborhood
  std::size_t count() const noexcept { return m_count; } ///< number of rings, or of nearest neighbors
  double radius() const noexcept { return m_radius; }    ///< radius of the ball
  /// what isn't farther away counts as in the ball
  double reach() const noexcept { return (1. + 0x1p-20) * m_radius; }

private:
  Neighborhood(Kind kind, std::size_t count, double radius) : m_kind(kind), m_count(count), m_radius(radius)
  {}

  Kind m_kind;
  std::size_t m_count;
  double m_radius;
};

namespace internal {

template <typename NamedParameters>
inline constexpr int number_of_neighborhoods =
    !parameters::is_default_parameter<NamedParameters, internal_np::number_of_rings_t>::value +
    !parameters::is_default_parameter<NamedParameters, internal_np::neighbor_radius_t>::value +
    !parameters::is_default_parameter<NamedParameters, internal_np::number_of_neighbors_t>::value;

// the neighborhood that named parameters ask for on a mesh
template <typename NamedParameters>
Neighborhood mesh_neighborhood(const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  static_assert(is_default_parameter<NamedParameters, internal_np::number_of_neighbors_t>::value,
                "number_of_neighbors is for point sets; on a mesh give number_of_rings or neighbor_radius");
  static_assert(number_of_neighborhoods<NamedParameters> <= 1,
                "give one of number_of_rings and neighbor_radius, not both");
  if constexpr(!is_default_parameter<NamedParameters, internal_np::neighbor_radius_t>::value)
  {
    const double radius = CGAL::to_double(get_parameter(np, internal_np::neighbor_radius));
    return Neighborhood::ball(radius);
  }
  else
  {
    const std::int64_t rings =
        whole_number(np, internal_np::number_of_rings, std::int64_t(2), "number_of_rings");
    if(rings < 1 || rings > 1000000)
      throw std::invalid_argument("Shape_characteristics: number_of_rings must be between 1 and 1000000");
    return Neighborhood::rings(static_cast<unsigned int>(rings));
  }
}

// the neighborhood that named parameters ask for on a point set, or as many nearest points as usual
template <typename NamedParameters>
Neighborhood point_set_neighborhood(const NamedParameters& np, std::int64_t usual = 18)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;

  static_assert(is_default_parameter<NamedParameters, internal_np::number_of_rings_t>::value,
                "number_of_rings needs a mesh; on a point set give number_of_neighbors or neighbor_radius");
  static_assert(number_of_neighborhoods<NamedParameters> <= 1,
                "give one of number_of_neighbors and neighbor_radius, not both");
  if constexpr(!is_default_parameter<NamedParameters, internal_np::neighbor_radius_t>::value)
  {
    const double radius = CGAL::to_double(get_parameter(np, internal_np::neighbor_radius));
    return Neighborhood::ball(radius);
  }
  else
  {
    const std::int64_t k = whole_number(np, internal_np::number_of_neighbors, usual, "number_of_neighbors");
    if(k < 1)
      throw std::invalid_argument("Shape_characteristics: number_of_neighbors must be positive");
    return Neighborhood::nearest(static_cast<std::size_t>(k));
  }
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_NEIGHBORHOOD_H
