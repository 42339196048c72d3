#ifndef SHAPE_CHARACTERISTICS_REGISTRATION_MATCH_DESCRIPTORS_H
#define SHAPE_CHARACTERISTICS_REGISTRATION_MATCH_DESCRIPTORS_H

#include <Shape_characteristics/Named_function_parameters.h>
#include <Shape_characteristics/descriptors/Descriptor_matrix.h>
#include <Shape_characteristics/internal/unwrapped.h>
#include <Shape_characteristics/registration/Correspondence.h>
#include <Shape_characteristics/registration/internal/Descriptor_matcher.h>
#include <Shape_characteristics/registration/internal/check_statuses.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace Shape_characteristics {
namespace internal {

inline void check_descriptors(const Descriptor_matrix& matrix, const Descriptor_matrix& target)
{
  check_statuses(matrix);
  if(matrix.values.rows() > 0 && target.values.rows() > 0 && matrix.values.cols() != target.values.cols())
    throw std::invalid_argument(
        "Shape_characteristics: descriptors of different dimensions can't be matched");
}

// the samples of the rows of a matrix: those given, or 0, 1, 2, ...
template <typename Parameter>
std::vector<std::uint32_t> samples_of_rows(const Parameter& given, const Descriptor_matrix& matrix)
{
  const std::size_t rows = std::size_t(matrix.values.rows());
  std::vector<std::uint32_t> result;
  if constexpr(std::is_same_v<Parameter, internal_np::Param_not_found>)
    for(std::size_t i = 0; i < rows; ++i)
      result.push_back(std::uint32_t(i));
  else
    for(const auto& sample : unwrapped(given))
    {
      bool is_negative = false;
      if constexpr(std::is_signed_v<std::decay_t<decltype(sample)> >)
        is_negative = sample < 0;
      const auto number = static_cast<std::uint32_t>(sample);
      if(is_negative || static_cast<std::uint64_t>(sample) != number)
        throw std::invalid_argument(
            "Shape_characteristics: source_samples and target_samples must be in [0, 2^32)");
      result.push_back(number);
    }
  if(result.size() != rows)
    throw std::invalid_argument(
        "Shape_characteristics: source_samples and target_samples must name a sample for each row");
  return result;
}

} // namespace internal

/*!
  \ingroup PkgShapeCharacteristicsRegistration

  finds pairs of descriptors of two surfaces that are each other's nearest neighbors.

  Nearest is what has the smallest Euclidean distance; of descriptors equally near, the one in the first row. The descriptors
  have to be of one kind, but it doesn't matter of which.

  \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag` (default).
          The results are the same for any number of threads.
  \tparam NamedParameters a sequence of \ref sc_namedparameters "Named Parameters"

  \param source the descriptors of the source
  \param target the descriptors of the target
  \param np an optional sequence of \ref sc_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{source_samples}
      \cgalParamDescription{the numbers of the samples that the rows of `source` belong to, where these are descriptors of a part
                            of the samples}
      \cgalParamType{a range of integers, with one for each row; by `std::cref()` it isn't copied}
      \cgalParamDefault{row `i` belongs to sample `i`}
    \cgalParamNEnd
    \cgalParamNBegin{target_samples}
      \cgalParamDescription{the same of `target`}
      \cgalParamType{a range of integers, with one for each row; by `std::cref()` it isn't copied}
      \cgalParamDefault{row `i` belongs to sample `i`}
    \cgalParamNEnd
    \cgalParamNBegin{mirrored_target_descriptors}
      \cgalParamDescription{for each row of `target` the descriptor that the sample would have on the mirrored surface. A pair is
                            dropped if the source's descriptor is nearer to it than to the target's: then it is the mirrored partner
                            that was found. Rows without a descriptor drop nothing.}
      \cgalParamType{a `Descriptor_matrix`, or one in `std::cref()`, which isn't copied}
      \cgalParamDefault{not used}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \return the pairs, in the order of the rows of `source`: no row comes twice. Rows without a descriptor, or with numbers that
          aren't finite, have no partner.

  \throws std::invalid_argument if the matrices have different numbers of columns, or their statuses or the samples are not one for
          each row, or a sample isn't in [0, 2^32)

  The result is exact: that of comparing all distances, in double precision.

  Complexity: \f$ O(n m d) \f$ for \f$ n \f$ and \f$ m \f$ descriptors of \f$ d \f$ components, with linear memory. All pairs are
  compared by a product of matrices, which for some thousand descriptors is faster than a search tree in so many dimensions; of large scans,
  match descriptors of a bounded number of samples (`descriptor_samples`), and say which by `source_samples` and
  `target_samples`.

  \cgalExample{registration/registration_steps.cpp}
*/
template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag,
          typename NamedParameters = parameters::Default_named_parameters>
std::vector<Correspondence> match_descriptors(const Descriptor_matrix& source,
                                              const Descriptor_matrix& target,
                                              const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter;
  internal::check_descriptors(source, target);
  internal::check_descriptors(target, target);
  const std::vector<std::uint32_t> source_samples =
      internal::samples_of_rows(get_parameter(np, internal_np::source_samples), source);
  const std::vector<std::uint32_t> target_samples =
      internal::samples_of_rows(get_parameter(np, internal_np::target_samples), target);

  internal::Descriptor_matcher matcher(source, target);
  matcher.run<ConcurrencyTag>();

  // by row of the target, the row of the source
  std::vector<std::uint32_t> back(target_samples.size(), 0);
  for(std::size_t j = 0; j < matcher.target_rows().size(); ++j)
    back[matcher.target_rows()[j]] = matcher.of_target()[j].row;

  const std::size_t dimension = std::size_t(source.values.cols());
  std::vector<Correspondence> result;
  const auto add_matches = [&](const auto& is_mirrored)
  {
    if(matcher.target_rows().empty())
      return;
    for(std::size_t i = 0; i < matcher.source_rows().size(); ++i)
    {
      const std::uint32_t row = matcher.source_rows()[i];
      const auto& nearest = matcher.of_source()[i];
      if(back[nearest.row] == row && !is_mirrored(row, nearest))
        result.push_back({source_samples[row], target_samples[nearest.row]});
    }
  };

  const auto mirrored_parameter = get_parameter(np, internal_np::mirrored_target_descriptors);
  if constexpr(std::is_same_v<std::remove_cv_t<decltype(mirrored_parameter)>, internal_np::Param_not_found>)
    add_matches([](std::uint32_t, const auto&) { return false; });
  else
  {
    const Descriptor_matrix& mirrored = internal::unwrapped(mirrored_parameter);
    internal::check_descriptors(mirrored, target);
    if(mirrored.values.rows() != target.values.rows())
      throw std::invalid_argument(
          "Shape_characteristics: mirrored_target_descriptors needs the target's rows");
    add_matches(
        [&](const std::uint32_t row, const auto& nearest)
        {
          return is_estimated(mirrored.status[nearest.row]) &&
                 internal::squared_distance(source.values.data() + std::size_t(row) * dimension,
                                            mirrored.values.data() + std::size_t(nearest.row) * dimension,
                                            dimension) < nearest.distance;
        });
  }
  return result;
}

} // namespace Shape_characteristics

#endif // SHAPE_CHARACTERISTICS_REGISTRATION_MATCH_DESCRIPTORS_H
