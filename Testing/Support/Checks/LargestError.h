// SPDX-License-Identifier: BSD-3-Clause
#ifndef reference_LargestError_h
#define reference_LargestError_h

#include <cmath>
#include <limits>
#include <type_traits>

namespace reference
{

/// Sets \a largest to \a value if \a value is larger, and to infinity if \a value is NaN, so that a
/// check of the result fails. std::max(largest, NaN) would return \a largest.
template <typename Number>
void KeepLargest(Number& largest, std::common_type_t<Number> value)
{
  if (!(value <= largest))
  {
    largest = std::isnan(value) ? std::numeric_limits<Number>::infinity() : value;
  }
}

}

#endif
