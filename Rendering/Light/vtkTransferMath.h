#ifndef vtkTransferMath_h
#define vtkTransferMath_h

#include "vtkTransferNodes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

/**
 * Arithmetic of a transfer function's values.
 */
namespace vtkTransferMath
{

inline vtkTransferNodes::Value Mix(
  const vtkTransferNodes::Value& a, const vtkTransferNodes::Value& b, double share)
{
  vtkTransferNodes::Value mixed;
  for (std::size_t i = 0; i < mixed.size(); ++i)
  {
    mixed[i] = a[i] + share * (b[i] - a[i]);
  }
  return mixed;
}

/// The largest difference of a channel.
inline double GetDistance(const vtkTransferNodes::Value& a, const vtkTransferNodes::Value& b)
{
  return std::max({ std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2]) });
}

}

#endif
