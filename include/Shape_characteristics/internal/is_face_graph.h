#ifndef SHAPE_CHARACTERISTICS_INTERNAL_IS_FACE_GRAPH_H
#define SHAPE_CHARACTERISTICS_INTERNAL_IS_FACE_GRAPH_H

#include <boost/graph/graph_traits.hpp>

#include <iterator>
#include <type_traits>
#include <utility>

namespace Shape_characteristics {
namespace internal {

// The overloads of an estimator are told apart by what its arguments are. `boost::graph_traits` can't be asked:
// it doesn't compile for what isn't a graph.

template <typename T, typename = void>
struct Is_face_graph : std::false_type
{};

template <typename T>
struct Is_face_graph< T,
                      std::void_t<decltype(num_faces(std::declval<const T&>())),
                                  decltype(num_vertices(std::declval<const T&>()))> > : std::true_type
{};

template <typename T>
inline constexpr bool is_face_graph = Is_face_graph<T>::value;

// has a type only for a graph
template <typename T, bool = is_face_graph<T> >
struct Vertex_descriptor
{};

template <typename T>
struct Vertex_descriptor<T, true>
{
  using type = typename boost::graph_traits<T>::vertex_descriptor;
};

template <typename T, typename = void>
struct Is_point_range : std::false_type
{};

template <typename T>
struct Is_point_range< T,
                       std::void_t<decltype(std::begin(std::declval<const T&>())),
                                   decltype(std::end(std::declval<const T&>()))> >
  : std::bool_constant<!is_face_graph<T> >
{};

template <typename T>
inline constexpr bool is_point_range = Is_point_range<std::remove_cv_t<std::remove_reference_t<T>>>::value;

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_IS_FACE_GRAPH_H
