#ifndef SHAPE_CHARACTERISTICS_DESCRIPTORS_COMPUTE_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_DESCRIPTORS_COMPUTE_DESCRIPTORS_H

#include <Shape_characteristics/Estimation_status.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/sampling/for_each_sample.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace Shape_characteristics {
namespace internal {

// whether a descriptor says in which order samples are best visited
template <typename Descriptor, typename = void>
struct Has_order : std::false_type
{};

template <typename Descriptor>
struct Has_order<Descriptor, std::void_t<decltype(std::declval<const Descriptor&>().order())> >
  : std::true_type
{};

// Row `r` is the descriptor of the sample `sample(r)`; the rows are computed in the order `row(0), row(1), ...`.
template <typename ConcurrencyTag, typename Descriptor, typename Row, typename Sample>
Descriptor_matrix compute_descriptor_rows(const Descriptor& descriptor,
                                          std::size_t rows,
                                          const Row& row,
                                          const Sample& sample,
                                          const std::function<bool(double)>& callback)
{
  using Workspace = typename Descriptor::Workspace;

  // as it remains where the callback stops the computation
  Descriptor_matrix result;
  result.values.setConstant(Eigen::Index(rows), Eigen::Index(descriptor.dimension()),
                            std::numeric_limits<float>::quiet_NaN());
  result.status.assign(rows, Estimation_status::CANCELLED);

  float* const values = result.values.data();
  const std::size_t dimension = descriptor.dimension();
  for_each_sample<ConcurrencyTag, Workspace>(
      rows,
      [&](const std::size_t k, Workspace& workspace)
      {
        const std::size_t r = row(k);
        result.status[r] = descriptor(sample(r), workspace, values + r * dimension);
      },
      callback);
  return result;
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the descriptors of the samples `0, ..., number_of_samples - 1`: row `i` of the matrix is that of sample `i`.

  \scConcurrencyTag
  \tparam Descriptor a model of the concept `Descriptor`

  \param descriptor the descriptor
  \param number_of_samples how many samples there are
  \param callback called with the advancement in `[0, 1]`, by one thread at a time and with increasing values; if it
         returns `false`, samples not yet reached get the status `CANCELLED`. May be empty.

  \return the descriptors, and the status of each; a row without a descriptor is quiet NaN

  Complexity: that of the descriptor, as many times as there are samples.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag, typename Descriptor>
Descriptor_matrix
compute_descriptors(const Descriptor& descriptor,
                    std::size_t number_of_samples,
                    const std::function<bool(double)>& callback = std::function<bool(double)>())
{
  const auto same = [](const std::size_t k) { return k; };
  if constexpr(internal::Has_order<Descriptor>::value)
    if(descriptor.order().size() == number_of_samples)
      return internal::compute_descriptor_rows<ConcurrencyTag>(
          descriptor, number_of_samples, [&](const std::size_t k) { return descriptor.order()[k]; }, same,
          callback);
  return internal::compute_descriptor_rows<ConcurrencyTag>(descriptor, number_of_samples, same, same,
                                                           callback);
}

/*!
  \ingroup PkgShapeCharacteristicsDescriptors

  computes the descriptors of some samples: row `k` of the matrix is that of sample `samples[k]`, and the same, bit for
  bit, as if those of all were computed.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default)
  \tparam Descriptor a model of the concept `Descriptor`

  \param descriptor the descriptor
  \param samples which samples, in any order; a sample may come twice
  \param callback as for all samples
  \pre each of `samples` is less than the number of samples that `descriptor` knows

  Complexity: that of the descriptor, as many times as `samples` has entries.
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag, typename Descriptor>
Descriptor_matrix
compute_descriptors(const Descriptor& descriptor,
                    const std::vector<std::size_t>& samples,
                    const std::function<bool(double)>& callback = std::function<bool(double)>())
{
  return internal::compute_descriptor_rows<ConcurrencyTag>(
      descriptor, samples.size(), [](const std::size_t k) { return k; },
      [&](const std::size_t k) { return samples[k]; }, callback);
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_DESCRIPTORS_COMPUTE_DESCRIPTORS_H
