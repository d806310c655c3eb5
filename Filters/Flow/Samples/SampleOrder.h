// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SampleOrder_h
#define interlume_SampleOrder_h

#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   SampleOrder
 * @brief   orders samples along a space-filling curve
 *
 * Consecutive streamlines then read the same region of the field, which improves cache use. The
 * bounds of the samples are divided into 2^k blocks along each axis, with about eight samples per
 * block. Blocks follow the order of their Morton codes (G. M. Morton, 1966); samples within a block
 * retain their order. A coordinate that is not finite counts as the lowest. The order depends only
 * on the positions, and is computed by a counting sort.
 */
class SampleOrder
{
public:
  /// Orders the samples \a ids, or all samples from \a first on.
  SampleOrder(vtkDataSet* samples, const std::vector<vtkIdType>& ids);
  SampleOrder(vtkDataSet* samples, vtkIdType first);

  vtkIdType GetNumber() const { return static_cast<vtkIdType>(this->Ids.size()); }

  /// Returns the id of the i-th sample, 0 <= i < GetNumber().
  vtkIdType operator[](vtkIdType i) const { return this->Ids[static_cast<std::size_t>(i)]; }

  /// Returns the Morton code of three numbers with at most ten bits: bit b of axis i is bit 3 * b +
  /// i.
  static unsigned int GetCode(const unsigned int index[3]);

private:
  std::vector<vtkIdType> Ids;
};

}

#endif
