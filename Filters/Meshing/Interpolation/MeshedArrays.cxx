// SPDX-License-Identifier: BSD-3-Clause
#include "Interpolation/MeshedArrays.h"

#include "Interpolation/HarmonicExtension.h"
#include "Mesh/Tetrahedra.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

namespace interlume
{

namespace
{
/// Returns the data type for values that are interpolated from \a array.
int InterpolatedType(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
      return VTK_FLOAT;
    default:
      return VTK_DOUBLE;
  }
}

/// Returns whether an array must not be copied: ids and ghost types are valid only for the input.
bool IsExcluded(vtkDataSetAttributes* data, vtkAbstractArray* array)
{
  return array == data->GetGlobalIds() || array == data->GetPedigreeIds() ||
    (array->GetName() && array->GetName() == std::string(vtkDataSetAttributes::GhostArrayName()));
}

/// Adds array \a result, which was computed from the array with the given index. If that array is
/// an active attribute, such as the scalars, \a result becomes the same attribute.
void AddArray(
  vtkDataSetAttributes* from, int index, vtkDataSetAttributes* to, vtkAbstractArray* result)
{
  const int attribute = from->IsArrayAnAttribute(index);
  const int added = to->AddArray(result);
  if (attribute >= 0)
  {
    to->SetActiveAttribute(added, attribute);
  }
}
}

bool MeshedArrays::InterpolatePointData(vtkDataSet* input, const Tetrahedra& mesh,
  const std::function<bool()>& isCanceled, vtkUnstructuredGrid* output)
{
  HarmonicExtension extension(mesh);
  extension.IsCanceled = isCanceled;
  vtkPointData* from = input->GetPointData();
  const auto number = static_cast<vtkIdType>(mesh.Origins.size());
  std::vector<double> values(mesh.Origins.size());
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = from->GetArray(a);
    if (!array || IsExcluded(from, array))
    {
      continue;
    }
    vtkSmartPointer<vtkDataArray> result;
    result.TakeReference(vtkDataArray::CreateDataArray(InterpolatedType(array)));
    result->SetName(array->GetName());
    result->SetNumberOfComponents(array->GetNumberOfComponents());
    result->CopyComponentNames(array);
    result->SetNumberOfTuples(number);
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      for (vtkIdType p = 0; p < number; ++p)
      {
        const PointSources& origin = mesh.Origins[p];
        values[p] = 0.0;
        for (int i = 0; i < origin.NumberOfSources; ++i)
        {
          // Ignore values of zero weight, since 0 times NaN or infinity is NaN.
          values[p] += origin.Weights[i] == 0.0
            ? 0.0
            : origin.Weights[i] * array->GetComponent(origin.Sources[i], c);
        }
      }
      extension.Extend(values);
      if (isCanceled())
      {
        return false;
      }
      for (vtkIdType p = 0; p < number; ++p)
      {
        result->SetComponent(p, c, values[p]);
      }
    }
    AddArray(from, a, output->GetPointData(), result);
  }
  return true;
}

void MeshedArrays::CopyCellData(
  vtkDataSet* input, const Tetrahedra& mesh, vtkUnstructuredGrid* output)
{
  vtkCellData* from = input->GetCellData();
  const auto number = static_cast<vtkIdType>(mesh.Cells.size());
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (IsExcluded(from, array))
    {
      continue;
    }
    vtkSmartPointer<vtkAbstractArray> result;
    result.TakeReference(vtkAbstractArray::CreateArray(array->GetDataType()));
    result->SetName(array->GetName());
    result->SetNumberOfComponents(array->GetNumberOfComponents());
    result->CopyComponentNames(array);
    result->SetNumberOfTuples(number);
    for (vtkIdType t = 0; t < number; ++t)
    {
      result->SetTuple(t, mesh.Cells[t], array);
    }
    AddArray(from, a, output->GetCellData(), result);
  }
}

}
