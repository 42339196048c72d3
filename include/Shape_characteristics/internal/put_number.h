#ifndef SHAPE_CHARACTERISTICS_INTERNAL_PUT_NUMBER_H
#define SHAPE_CHARACTERISTICS_INTERNAL_PUT_NUMBER_H

#include <Shape_characteristics/internal/to_number.h>

#include <boost/property_map/property_map.hpp>

namespace Shape_characteristics {
namespace internal {

template <typename Map, typename Key>
void put_number(const Map& map, Key& key, double value)
{
  put(map, key, to_number<typename boost::property_traits<Map>::value_type>(value));
}

} // namespace internal
} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_INTERNAL_PUT_NUMBER_H
