#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_SAYS_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_SAYS_H

#include <exception>
#include <string>

namespace test_support {

/// For `BOOST_CHECK_EXCEPTION`: whether the message of an exception has the given words.
inline auto says(const std::string& words)
{
  return [words](const std::exception& e) { return std::string(e.what()).find(words) != std::string::npos; };
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_SAYS_H
