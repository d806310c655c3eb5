// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StoredIds_h
#define interlume_StoredIds_h

#include "Common/GridCells.h"
#include "Common/Prefetch.h"

#include "vtkSmartPointer.h"

namespace interlume
{

/**
 * @class   StoredIds
 * @brief   reads offsets or point ids of a cell array, of 32 or 64 bits, by threads
 */
class StoredIds
{
public:
  /// Keeps \a array, or a copy where its values are not in memory.
  void Build(vtkDataArray* array)
  {
    if (GridCells::IsNarrow(array))
    {
      const auto ids = ArrayViews::Get<GridCells::NarrowIds>(array);
      this->Array = ids;
      this->Narrow = ids->GetPointer(0);
      this->Wide = nullptr;
    }
    else
    {
      const auto ids = ArrayViews::Get<GridCells::WideIds>(array);
      this->Array = ids;
      this->Narrow = nullptr;
      this->Wide = ids->GetPointer(0);
    }
  }

  vtkIdType Get(vtkIdType i) const
  {
    return this->Narrow ? static_cast<vtkIdType>(this->Narrow[i])
                        : static_cast<vtkIdType>(this->Wide[i]);
  }

  /// Calls \a visit with the first value, in the type they are stored in.
  template <typename Visitor>
  void Visit(Visitor&& visit) const
  {
    this->Narrow ? visit(this->Narrow) : visit(this->Wide);
  }

  void Prefetch(vtkIdType first, vtkIdType last) const
  {
    for (const vtkIdType i : { first, last })
    {
      this->Narrow ? interlume::Prefetch::Read(this->Narrow + i)
                   : interlume::Prefetch::Read(this->Wide + i);
    }
  }

private:
  const vtkTypeInt32* Narrow = nullptr;
  const vtkTypeInt64* Wide = nullptr;
  vtkSmartPointer<vtkDataArray> Array;
};

}

#endif
