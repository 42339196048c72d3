#include "Ticks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace support {

namespace {

const std::string minus = "\u2212";

std::string with_minus(std::string text)
{
  return !text.empty() && text[0] == '-' ? minus + text.substr(1) : text;
}

std::string fixed(double value, int decimals)
{
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", decimals, value == 0 ? 0. : value);
  return with_minus(text);
}

std::string power_of_ten(int exponent)
{
  return "10^{" + with_minus(std::to_string(exponent)) + "}";
}

} // namespace

Ticks linear_ticks(double low, double high, int wished)
{
  Ticks ticks;
  const double width = high - low;
  if(!(width > 0) || !std::isfinite(width) || wished < 1)
    return ticks;
  const double coarse = width / wished;
  int exponent = int(std::floor(std::log10(coarse)));
  double digit = coarse / std::pow(10., exponent);
  digit = digit <= 1.0001 ? 1 : digit <= 2.0001 ? 2 : digit <= 5.0001 ? 5 : 10;
  if(digit == 10)
  {
    digit = 1;
    ++exponent;
  }
  // value = k * step, computed so that the decimal values come out right
  const double unit = std::pow(10., std::abs(exponent));
  const auto value = [&](double k) { return exponent < 0 ? k * digit / unit : k * digit * unit; };
  const double step = value(1), slack = 1e-9 * width;
  for(double k = std::ceil((low - slack) / step); value(k) <= high + slack && ticks.values.size() < 100; ++k)
    ticks.values.push_back(k == 0 ? 0 : value(k));

  // Sizes far from 1 are written with a common power of ten.
  const double size = std::max(std::abs(low), std::abs(high));
  const int magnitude = int(std::floor(std::log10(size) + 1e-9));
  const int common = magnitude >= 5 || magnitude <= -4 ? magnitude : 0;
  if(common != 0)
    ticks.factor = "\u00d7" + power_of_ten(common);
  const int decimals = std::max(0, common - exponent);
  for(double v : ticks.values)
    ticks.labels.push_back(fixed(v / std::pow(10., common), std::min(decimals, 17)));
  return ticks;
}

Ticks logarithmic_ticks(double low, double high, int wished)
{
  Ticks ticks;
  if(!(low > 0 && high > low) || !std::isfinite(high) || wished < 1)
    return ticks;
  const int first = int(std::ceil(std::log10(low) - 1e-9)), last = int(std::floor(std::log10(high) + 1e-9));
  const auto label = [](int digit, int exponent)
  {
    if(exponent >= -3 && exponent <= 4)
      return fixed(digit * std::pow(10., exponent), std::max(0, -exponent));
    return (digit == 1 ? std::string() : std::to_string(digit) + "\u00b7") + power_of_ten(exponent);
  };
  if(last > first)
  {
    // all labels in one notation
    const bool plain = first >= -3 && last <= 4;
    const int stride = std::max(1, (last - first + wished) / wished);
    for(int e = first; e <= last; e += 1)
      if((e - first) % stride == 0)
      {
        ticks.values.push_back(std::pow(10., e));
        ticks.labels.push_back(plain ? label(1, e) : power_of_ten(e));
      }
    return ticks;
  }
  for(int e = first - 1; e <= last + 1; ++e)
    for(int digit : {1, 2, 5})
    {
      const double v = digit * std::pow(10., e);
      if(v >= low * (1 - 1e-9) && v <= high * (1 + 1e-9))
      {
        ticks.values.push_back(v);
        ticks.labels.push_back(label(digit, e));
      }
    }
  return ticks.values.size() >= 2 ? ticks : linear_ticks(low, high, wished);
}

} // namespace support
