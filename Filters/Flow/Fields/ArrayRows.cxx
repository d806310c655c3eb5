// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/ArrayRows.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkSMPTools.h"

namespace interlume
{

namespace
{

// GetTuple with a buffer is safe for several threads, for arrays of any layout.
template <typename T>
vtkSmartPointer<vtkDataArray> MakeCopy(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  auto copy = vtkSmartPointer<vtkAOSDataArrayTemplate<T>>::New();
  copy->SetNumberOfComponents(components);
  copy->SetNumberOfTuples(array->GetNumberOfTuples());
  T* to = copy->GetPointer(0);
  vtkSMPTools::For(0, array->GetNumberOfTuples(),
    [=](vtkIdType first, vtkIdType last)
    {
      std::vector<double> tuple(components);
      for (vtkIdType i = first; i < last; ++i)
      {
        array->GetTuple(i, tuple.data());
        for (int c = 0; c < components; ++c)
        {
          to[components * i + c] = static_cast<T>(tuple[c]);
        }
      }
    });
  return copy;
}

}

void ArrayRows::Refer(vtkDataArray* array)
{
  this->Array = array;
  auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(array);
  auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array);
  this->Floats = floats ? floats->GetPointer(0) : nullptr;
  this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
}

void ArrayRows::Build(vtkDataArray* array)
{
  this->Refer(array);
  if (!this->Floats && !this->Doubles)
  {
    const bool isSmall = array->GetDataTypeSize() <= 2 || array->GetDataType() == VTK_FLOAT;
    this->Refer(isSmall ? MakeCopy<float>(array) : MakeCopy<double>(array));
  }
}

}
