// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TransferMath_h
#define interlume_TransferMath_h

#include "Volume/TransferNodes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace interlume
{

/**
 * Arithmetic with transfer function values.
 */
namespace TransferMath
{

inline TransferNodes::Value Mix(
  const TransferNodes::Value& a, const TransferNodes::Value& b, double fraction)
{
  TransferNodes::Value mixed;
  for (std::size_t i = 0; i < mixed.size(); ++i)
  {
    mixed[i] = a[i] + fraction * (b[i] - a[i]);
  }
  return mixed;
}

/// Returns the largest absolute difference over all channels.
inline double GetDistance(const TransferNodes::Value& a, const TransferNodes::Value& b)
{
  return std::max({ std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2]) });
}

}

}

#endif
