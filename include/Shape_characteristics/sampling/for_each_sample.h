#ifndef SHAPE_CHARACTERISTICS_SAMPLING_FOR_EACH_SAMPLE_H
#define SHAPE_CHARACTERISTICS_SAMPLING_FOR_EACH_SAMPLE_H

#include <Shape_characteristics/sampling/No_workspace.h>

#include <CGAL/for_each.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// Scratch memory that outlives a block of samples: as many workspaces exist as threads were ever at work at once.
template <typename Workspace>
class Workspace_pool
{
public:
  std::unique_ptr<Workspace> acquire()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_free.empty())
      return std::make_unique<Workspace>();
    std::unique_ptr<Workspace> workspace = std::move(m_free.back());
    m_free.pop_back();
    return workspace;
  }

  void release(std::unique_ptr<Workspace> workspace)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_free.push_back(std::move(workspace));
  }

private:
  std::mutex m_mutex;
  std::vector<std::unique_ptr<Workspace> > m_free;
};

// `visit(begin, end)` for blocks of `[first, last)`, as the public function below visits samples.
template <typename ConcurrencyTag>
bool for_each_block(std::size_t first,
                    std::size_t last,
                    std::size_t block_size,
                    const std::function<void(std::size_t, std::size_t)>& visit,
                    const std::function<bool(double)>& callback)
{
  std::vector<std::size_t> blocks((last - first + block_size - 1) / block_size);
  for(std::size_t b = 0; b < blocks.size(); ++b)
    blocks[b] = first + b * block_size;

  std::mutex callback_mutex;
  std::size_t done = 0;
  std::atomic<bool> go_on{true};

  CGAL::for_each<ConcurrencyTag>(blocks,
                                 [&](const std::size_t begin)
                                 {
                                   if(!go_on.load(std::memory_order_relaxed))
                                     return false;
                                   const std::size_t end = (std::min)(begin + block_size, last);
                                   visit(begin, end);
                                   if(callback)
                                   {
                                     const std::lock_guard<std::mutex> lock(callback_mutex);
                                     done += end - begin;
                                     if(go_on && !callback(double(done) / double(last - first)))
                                       go_on = false;
                                   }
                                   return true;
                                 });
  return go_on;
}

// The same as the public function for `i` in `[first, last)`, with workspaces that outlive it.
template <typename ConcurrencyTag, typename Workspace, typename Function>
bool for_each_sample_between(Workspace_pool<Workspace>& pool,
                             std::size_t first,
                             std::size_t last,
                             const Function& function,
                             const std::function<bool(double)>& callback,
                             std::size_t block_size)
{
  return for_each_block<ConcurrencyTag>(
      first, last, block_size,
      [&](const std::size_t begin, const std::size_t end)
      {
        std::unique_ptr<Workspace> workspace = pool.acquire();
        for(std::size_t i = begin; i < end; ++i)
          function(i, *workspace);
        pool.release(std::move(workspace));
      },
      callback);
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsSampling

  calls `function(i, workspace)` for each `i` in `[0, size)`, in parallel if `ConcurrencyTag` says so.

  No two calls that run at the same time get the same workspace. `function` must write to places that belong
  to sample `i` alone; then the result doesn't depend on the number of threads.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag`
  \tparam Workspace a default constructible type: scratch memory reused from call to call, or `No_workspace`
  \tparam Function a function object with `void operator()(std::size_t, Workspace&) const`

  \param size the number of samples
  \param function what to do
  \param callback called with the advancement in `[0, 1]`, by one thread at a time and with increasing values;
         if it returns `false`, the samples not yet begun are left out. May be empty.
  \param block_size the number of samples that one thread visits in a row: small enough to share the work evenly and to
         report progress, large enough to make the bookkeeping free

  \return whether all samples were visited
*/
template <typename ConcurrencyTag, typename Workspace, typename Function>
bool for_each_sample(std::size_t size,
                     const Function& function,
                     const std::function<bool(double)>& callback = std::function<bool(double)>(),
                     std::size_t block_size = 128)
{
  internal::Workspace_pool<Workspace> pool;
  return internal::for_each_sample_between<ConcurrencyTag>(pool, 0, size, function, callback, block_size);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_SAMPLING_FOR_EACH_SAMPLE_H
