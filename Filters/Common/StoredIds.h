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
 * @brief   thread-safe read access to the 32-bit or 64-bit offsets or point ids of a cell array
 */
class StoredIds
{
public:
  /// Stores a reference to \a array, or a copy if it is implicit.
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

  /// Calls \a visit with a pointer to the first value, in the stored type.
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
