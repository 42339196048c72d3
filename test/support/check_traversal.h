#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_CHECK_TRAVERSAL_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_CHECK_TRAVERSAL_H

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace test_support {

/// Checks that `Samples::Traversal` gives the order of all samples, in blocks of `patch_size` and a smaller last one.
template <typename Samples>
void check_traversal(const Samples& samples, std::size_t patch_size)
{
  using Indices = std::vector<typename Samples::Index>;

  Indices order, patch = {7};
  typename Samples::Traversal traversal(samples, patch_size);
  while(order.size() < samples.size())
  {
    traversal.next(patch);
    BOOST_REQUIRE(patch.size() == std::min(patch_size, samples.size() - order.size()));
    order.insert(order.end(), patch.begin(), patch.end());
  }
  BOOST_TEST((order == samples.traversal_order(patch_size)));
  traversal.next(patch);
  BOOST_TEST(patch.empty());
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_CHECK_TRAVERSAL_H
