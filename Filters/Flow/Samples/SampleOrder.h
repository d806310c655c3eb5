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
 * @brief   samples along a curve that fills their space, for streamlines that follow each other to
 * read the same part of the field
 *
 * The bounds of the samples are cut into 2^k blocks along each axis, so that a block holds about
 * eight samples; blocks come in the order of their Morton codes (G. M. Morton, 1966), samples of a
 * block in the order given. Positions that are not finite come first. The order depends on the
 * positions alone. It is made in one pass of counting and one of placing.
 */
class SampleOrder
{
public:
  /// Orders the samples with these ids, or those from \a first to the last.
  SampleOrder(vtkDataSet* samples, const std::vector<vtkIdType>& ids);
  SampleOrder(vtkDataSet* samples, vtkIdType first);

  vtkIdType GetNumber() const { return static_cast<vtkIdType>(this->Ids.size()); }

  /// Returns the id of the i-th sample, 0 <= i < the number of samples from first on.
  vtkIdType operator[](vtkIdType i) const { return this->Ids[static_cast<std::size_t>(i)]; }

  /// Returns the Morton code of three numbers of at most ten bits: bit b of axis i is bit 3 b + i.
  static unsigned int GetCode(const unsigned int index[3]);

private:
  std::vector<vtkIdType> Ids;
};

}

#endif
