#include <boost/test/unit_test.hpp>

#include <Shape_characteristics/sampling/for_each_sample.h>

#include <atomic>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(threads_of_for_each_sample)

namespace SC = Shape_characteristics;

namespace {

// a workspace that notices when two calls have it at the same time
struct Workspace
{
  std::atomic<int> users{0};
  std::size_t calls = 0;
};

template <typename Tag>
void check()
{
  for(const std::size_t size : {0u, 1u, 127u, 128u, 129u, 10007u})
  {
    std::vector<int> visits(size, 0);
    std::atomic<int> shared{0};
    std::atomic<int> callbacks_at_once{0}, overlaps{0};
    std::vector<double> advancements;
    const bool all = SC::for_each_sample<Tag, Workspace>(
        size,
        [&](const std::size_t i, Workspace& workspace)
        {
          if(workspace.users.fetch_add(1) != 0)
            ++shared;
          ++workspace.calls;
          ++visits[i];
          workspace.users.fetch_sub(1);
        },
        [&](const double advancement)
        {
          if(callbacks_at_once.fetch_add(1) != 0)
            ++overlaps;
          advancements.push_back(advancement);
          callbacks_at_once.fetch_sub(1);
          return true;
        });
    BOOST_TEST(all);
    BOOST_TEST(shared == 0);
    BOOST_TEST(overlaps == 0);
    BOOST_TEST((visits == std::vector<int>(size, 1)));
    BOOST_TEST(advancements.empty() == (size == 0));
    for(std::size_t k = 0; k < advancements.size(); ++k)
    {
      BOOST_TEST(advancements[k] > (k == 0 ? 0. : advancements[k - 1]));
      BOOST_TEST(advancements[k] <= 1.);
    }
    if(size > 0)
      BOOST_TEST(advancements.back() == 1.);
  }
}

template <typename Tag>
void check_cancellation()
{
  const std::size_t size = 100000;
  std::vector<int> visits(size, 0);
  std::atomic<int> calls{0};
  const bool all = SC::for_each_sample<Tag, Workspace>(
      size, [&](const std::size_t i, Workspace&) { ++visits[i]; },
      [&](const double)
      {
        ++calls;
        return calls < 3;
      });
  BOOST_TEST(!all);
  BOOST_TEST(calls == 3); // nobody is asked again
  std::size_t visited = 0;
  for(const int n : visits)
  {
    BOOST_TEST_REQUIRE(n <= 1);
    visited += std::size_t(n);
  }
  BOOST_TEST(visited > 0u);
  BOOST_TEST(visited < size);
}

template <typename Tag>
void check_exception()
{
  BOOST_CHECK_THROW((SC::for_each_sample<Tag, Workspace>(1000,
                                                         [](const std::size_t i, Workspace&)
                                                         {
                                                           if(i == 500)
                                                             throw std::runtime_error("in a sample");
                                                         })),
                    std::runtime_error);
}

} // namespace

BOOST_AUTO_TEST_CASE(sequential)
{
  check<CGAL::Sequential_tag>();
  check_cancellation<CGAL::Sequential_tag>();
  check_exception<CGAL::Sequential_tag>();
}

BOOST_AUTO_TEST_CASE(parallel_if_available)
{
  check<CGAL::Parallel_if_available_tag>();
  check_cancellation<CGAL::Parallel_if_available_tag>();
}

BOOST_AUTO_TEST_CASE(sequential_order)
{
  std::vector<std::size_t> order;
  SC::for_each_sample<CGAL::Sequential_tag, Workspace>(1000, [&](const std::size_t i, Workspace&)
                                                       { order.push_back(i); });
  for(std::size_t i = 0; i < 1000; ++i)
    BOOST_TEST_REQUIRE(order[i] == i);
}

BOOST_AUTO_TEST_SUITE_END()
