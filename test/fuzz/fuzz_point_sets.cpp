#include "fuzzed_geometry.h"

// Points and normals, some of them copies of others, through one of the estimators.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static const auto estimators = bad_inputs::estimators<bad_inputs::Point_set>();

  FuzzedDataProvider data(bytes, size);
  const auto& estimator = estimators[data.ConsumeIntegralInRange<std::size_t>(0, estimators.size() - 1)];
  const double scale = fuzz::scale(data);
  const std::size_t n = data.ConsumeIntegralInRange<std::size_t>(0, 24);
  bad_inputs::Point_set points;
  while(points.size() < n)
  {
    const int kind = data.ConsumeIntegralInRange<int>(0, 9);
    if(kind == 0 && !points.empty())
      points.push_back(points[data.ConsumeIntegralInRange<std::size_t>(0, points.size() - 1)]);
    else
    {
      const double x = scale * fuzz::number(data), y = scale * fuzz::number(data);
      const double z = kind < 4 ? scale * fuzz::number(data) : (x * x - y * y) / 4.;
      bad_inputs::Vector_3 normal(-x / 2., y / 2., 1.);
      if(kind < 3)
        normal = bad_inputs::Vector_3(fuzz::number(data), fuzz::number(data), fuzz::number(data));
      points.push_back({bad_inputs::Point_3(x, y, z), normal});
    }
  }
  fuzz::require(estimator.name, bad_inputs::complaint(estimator.all(points), points));
  return 0;
}
