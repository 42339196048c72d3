#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_CHECK_NAMES_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_CHECK_NAMES_H

#include <boost/test/unit_test.hpp>

#include <set>
#include <string>

namespace test_support {

/// Checks that `to_string()` has a name of its own for each value of an enumeration up to `last`, and none for the one behind.
template <typename Enumeration>
void check_names(Enumeration last)
{
  const int number = static_cast<int>(last) + 1;
  std::set<std::string> names;
  for(int i = 0; i < number; ++i)
    names.insert(to_string(static_cast<Enumeration>(i)));
  BOOST_TEST(static_cast<int>(names.size()) == number);
  BOOST_TEST(names.count("") == 0u);
  BOOST_TEST(to_string(static_cast<Enumeration>(number)) == std::string());
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_CHECK_NAMES_H
