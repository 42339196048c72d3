#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_CHECK_NAMES_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_CHECK_NAMES_H

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace test_support {

/// Checks that `to_string()` calls the values 0, 1, ... of an enumeration by `names`, and has none for what follows.
template <typename Enumeration>
void check_names(const std::vector<std::string>& names)
{
  for(std::size_t i = 0; i < names.size(); ++i)
    BOOST_TEST(to_string(static_cast<Enumeration>(i)) == names[i]);
  BOOST_TEST(to_string(static_cast<Enumeration>(names.size())) == std::string());
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_CHECK_NAMES_H
