// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/ExtractionArrays.h"

#include "Common/ParallelFor.h"
#include "Output/OutputAllocation.h"
#include "Output/ThreadGrain.h"

#include "vtkAlgorithm.h"
#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <cstring>

namespace interlume
{

int ExtractionArrays::ChoosePointType(vtkDataSet* input, int precision)
{
  if (precision == vtkAlgorithm::DEFAULT_PRECISION)
  {
    if (vtkPointSet* pointSet = vtkPointSet::SafeDownCast(input))
    {
      return pointSet->GetPoints()->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE;
    }
    vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(input);
    return grid && grid->GetXCoordinates()->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT;
  }
  return precision == vtkAlgorithm::DOUBLE_PRECISION ? VTK_DOUBLE : VTK_FLOAT;
}

bool ExtractionArrays::IsCarried(vtkDataSetAttributes* attributes, vtkAbstractArray* array)
{
  return array != attributes->GetAbstractAttribute(vtkDataSetAttributes::GLOBALIDS) &&
    array != attributes->GetAbstractAttribute(vtkDataSetAttributes::PEDIGREEIDS) &&
    !(array->GetName() &&
      std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) == 0);
}

void ExtractionArrays::AddArrayLike(vtkDataSetAttributes* input, vtkAbstractArray* in,
  vtkDataSetAttributes* output, vtkAbstractArray* out)
{
  out->SetName(in->GetName());
  out->CopyComponentNames(in);
  const int index = output->AddArray(out);
  for (int role = 0; role < vtkDataSetAttributes::NUM_ATTRIBUTES; ++role)
  {
    if (input->GetAbstractAttribute(role) == in)
    {
      output->SetActiveAttribute(index, role);
    }
  }
}

namespace
{
struct CopyWorker
{
  const vtkIdType* Cells;
  vtkIdType Number;

  template <typename Array>
  void operator()(Array* in, vtkDataArray* base) const
  {
    Array* out = Array::FastDownCast(base);
    // With a number of components known at compile time, the compiler unrolls the loop over them.
    in->GetNumberOfComponents() == 1 ? this->Run<1>(in, out) : this->Run<0>(in, out);
  }

private:
  template <int Known, typename Array>
  void Run(Array* in, Array* out) const
  {
    const auto from = vtk::DataArrayValueRange(in);
    auto to = vtk::DataArrayValueRange(out);
    const vtkIdType components = Known ? Known : in->GetNumberOfComponents();
    ParallelFor(0, this->Number, ThreadGrain,
      [&](vtkIdType i)
      {
        for (vtkIdType c = 0; c < (Known ? Known : components); ++c)
        {
          to[i * components + c] = from[this->Cells[i] * components + c];
        }
      });
  }
};
}

bool ExtractionArrays::AreCompatible(vtkAbstractArray* a, vtkAbstractArray* b)
{
  return a && b && a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    a->IsA("vtkDataArray") == b->IsA("vtkDataArray") &&
    (a->IsA("vtkDataArray") || a->GetDataType() == b->GetDataType());
}

namespace
{
// Returns the size in bytes of the output arrays per tuple. \a getType returns the type of the
// output array for the type of an input array.
std::size_t GetBytesPerTuple(vtkDataSetAttributes* arrays, int (*getType)(int))
{
  std::size_t bytes = 0;
  for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = arrays->GetArray(a);
    if (array && ExtractionArrays::IsCarried(arrays, array))
    {
      bytes += static_cast<std::size_t>(array->GetNumberOfComponents()) *
        vtkDataArray::GetDataTypeSize(getType(array->GetDataType()));
    }
  }
  return bytes;
}
}

std::size_t ExtractionArrays::GetBytesPerPoint(vtkDataSet* input, int precision)
{
  return 3 * vtkDataArray::GetDataTypeSize(ChoosePointType(input, precision)) +
    GetBytesPerTuple(input->GetPointData(), GetInterpolatedType);
}

std::size_t ExtractionArrays::GetBytesPerCell(vtkDataSet* input)
{
  return GetBytesPerTuple(input->GetCellData(), [](int type) { return type; });
}

bool ExtractionArrays::GetRowDimensions(vtkDataSet* input, int dimensions[3])
{
  if (vtkImageData* image = vtkImageData::SafeDownCast(input))
  {
    image->GetDimensions(dimensions);
  }
  else if (vtkRectilinearGrid* rectilinear = vtkRectilinearGrid::SafeDownCast(input))
  {
    rectilinear->GetDimensions(dimensions);
  }
  else if (vtkStructuredGrid* structured = vtkStructuredGrid::SafeDownCast(input))
  {
    structured->GetDimensions(dimensions);
  }
  else
  {
    return false;
  }
  return true;
}

int ExtractionArrays::GetInterpolatedType(int dataType)
{
  switch (dataType)
  {
    case VTK_BIT:
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
    case VTK_FLOAT:
      return VTK_FLOAT;
    default:
      return VTK_DOUBLE;
  }
}

vtkSmartPointer<vtkAbstractArray> ExtractionArrays::NewInterpolatedArray(vtkAbstractArray* in)
{
  const auto out = vtk::TakeSmartPointer(in->IsA("vtkDataArray")
      ? vtkDataArray::CreateDataArray(GetInterpolatedType(in->GetDataType()))
      : in->NewInstance());
  out->SetNumberOfComponents(in->GetNumberOfComponents());
  return out;
}

int ExtractionArrays::CopyCellData(
  vtkCellData* input, const vtkIdType* cells, vtkIdType number, vtkCellData* output)
{
  int arrays = 0;
  const CopyWorker worker{ cells, number };
  for (int a = 0; a < input->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* in = input->GetAbstractArray(a);
    if (!IsCarried(input, in))
    {
      continue;
    }
    vtkSmartPointer<vtkAbstractArray> out;
    out.TakeReference(in->NewInstance());
    out->SetNumberOfComponents(in->GetNumberOfComponents());
    vtkDataArray* numbers = vtkDataArray::SafeDownCast(in);
    if (numbers)
    {
      OutputAllocation::SetNumberOfTuples(vtkDataArray::SafeDownCast(out), number);
    }
    else
    {
      out->SetNumberOfTuples(number);
    }
    if (!numbers ||
      !vtkArrayDispatch::Dispatch::Execute(numbers, worker, vtkDataArray::SafeDownCast(out)))
    {
      for (vtkIdType i = 0; i < number; ++i)
      {
        out->SetTuple(i, cells[i], in);
      }
    }
    AddArrayLike(input, in, output, out);
    ++arrays;
  }
  return arrays;
}

void ExtractionArrays::ActivateScalars(const char* name, vtkPointData* output)
{
  if (name && *name && output->GetArray(name))
  {
    output->SetActiveScalars(name);
  }
}

}
