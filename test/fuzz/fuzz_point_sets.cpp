#include "estimators.h"
#include "fuzzed_points.h"

// Point sets through one of the estimators.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static const auto estimators = bad_inputs::estimators<bad_inputs::Point_set>();

  FuzzedDataProvider data(bytes, size);
  const auto& estimator = estimators[data.ConsumeIntegralInRange<std::size_t>(0, estimators.size() - 1)];
  const bad_inputs::Point_set points = fuzz::points<bad_inputs::Oriented_point>(data);
  fuzz::require(estimator.name, bad_inputs::complaint(estimator.all(points), points));
  return 0;
}
