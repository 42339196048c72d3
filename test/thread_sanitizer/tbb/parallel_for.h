// The thread sanitizer doesn't see how threads wait for each other inside the TBB library, which isn't compiled with
// it, and reports every loop as a race. With this folder before TBB's in the include path, CGAL's parallel loops run
// on threads that it does see: the library's code between the threads' start and end is checked, and nothing else.
#ifndef SHAPE_CHARACTERISTICS_TEST_THREAD_SANITIZER_PARALLEL_FOR_H
#define SHAPE_CHARACTERISTICS_TEST_THREAD_SANITIZER_PARALLEL_FOR_H

#include <tbb/blocked_range.h>

#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace tbb {

// Four threads, the elements dealt to them like cards: neighbors in memory are written at the same time. As TBB does,
// throws in the caller's thread what a body throws.
template <typename Index, typename Body>
void parallel_for(const blocked_range<Index>& range, const Body& body)
{
  constexpr std::size_t number_of_threads = 4;
  std::vector<std::exception_ptr> thrown(number_of_threads);
  std::vector<std::thread> threads;
  for(std::size_t t = 0; t < number_of_threads; ++t)
    threads.emplace_back(
        [&, t]()
        {
          try
          {
            for(Index i = range.begin() + Index(t); i < range.end(); i += Index(number_of_threads))
              body(blocked_range<Index>(i, i + 1));
          }
          catch(...)
          {
            thrown[t] = std::current_exception();
          }
        });
  for(std::thread& thread : threads)
    thread.join();
  for(const std::exception_ptr& exception : thrown)
    if(exception)
      std::rethrow_exception(exception);
}

} // namespace tbb

#endif // SHAPE_CHARACTERISTICS_TEST_THREAD_SANITIZER_PARALLEL_FOR_H
