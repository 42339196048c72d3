#ifndef SHAPE_CHARACTERISTICS_TEST_SUPPORT_RAISE_TO_H
#define SHAPE_CHARACTERISTICS_TEST_SUPPORT_RAISE_TO_H

namespace test_support {

/// Raises `largest` to the largest of some values. If one of them is NaN, it is and stays NaN, and less than no bound:
/// `std::max(largest, value)` would be `largest`, and the error that is no number unseen.
template <typename T, typename... Values>
void raise_to(T& largest, const Values&... values)
{
  const auto raise = [&](const T& value)
  {
    if(!(value <= largest) && largest == largest)
      largest = value;
  };
  (raise(T(values)), ...);
}

} // namespace test_support

#endif // SHAPE_CHARACTERISTICS_TEST_SUPPORT_RAISE_TO_H
