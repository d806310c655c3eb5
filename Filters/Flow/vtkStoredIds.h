#ifndef vtkStoredIds_h
#define vtkStoredIds_h

#include "vtkGridCells.h"
#include "vtkPrefetch.h"
#include "vtkSmartPointer.h"

/**
 * @class   vtkStoredIds
 * @brief   reads offsets or point ids of a cell array, of 32 or 64 bits, by threads
 */
class vtkStoredIds
{
public:
  /// Keeps \a array, or a copy where its values are not in memory.
  void Build(vtkDataArray* array)
  {
    if (vtkGridCells::IsNarrow(array))
    {
      const auto ids = vtkGridCells::MakeTyped<vtkGridCells::NarrowIds>(array);
      this->Array = ids;
      this->Narrow = ids->GetPointer(0);
      this->Wide = nullptr;
    }
    else
    {
      const auto ids = vtkGridCells::MakeTyped<vtkGridCells::WideIds>(array);
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

  void Prefetch(vtkIdType first, vtkIdType last) const
  {
    for (const vtkIdType i : { first, last })
    {
      this->Narrow ? vtkPrefetch::Read(this->Narrow + i) : vtkPrefetch::Read(this->Wide + i);
    }
  }

private:
  const vtkTypeInt32* Narrow = nullptr;
  const vtkTypeInt64* Wide = nullptr;
  vtkSmartPointer<vtkDataArray> Array;
};

#endif
