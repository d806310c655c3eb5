// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CrossingKey_h
#define interlume_CrossingKey_h

#include "vtkType.h"

#include <cstdint>

namespace interlume
{

/**
 * @class   CrossingKey
 * @brief   far end point and isovalue of an edge crossing, packed in one sortable integer
 *
 * Point ids must be below 2^48 and isovalue indices below 2^16.
 */
class CrossingKey
{
public:
  CrossingKey() = default;
  CrossingKey(vtkIdType far, int value)
    : Bits((static_cast<std::uint64_t>(far) << 16) | static_cast<std::uint64_t>(value))
  {
  }

  vtkIdType GetFar() const { return static_cast<vtkIdType>(this->Bits >> 16); }
  int GetValue() const { return static_cast<int>(this->Bits & 0xffff); }

  bool operator==(const CrossingKey& other) const { return this->Bits == other.Bits; }
  bool operator!=(const CrossingKey& other) const { return this->Bits != other.Bits; }
  bool operator<(const CrossingKey& other) const { return this->Bits < other.Bits; }

private:
  std::uint64_t Bits = 0;
};

}

#endif
