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
/// Returns the type that holds interpolated values.
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

/// Returns whether an array stays out: ids and ghosts belong to the input's points and cells alone.
bool IsOfInputAlone(vtkDataSetAttributes* data, vtkAbstractArray* array)
{
  return array == data->GetGlobalIds() || array == data->GetPedigreeIds() ||
    (array->GetName() && array->GetName() == std::string(vtkDataSetAttributes::GhostArrayName()));
}

/// Keeps the attribute that an array is, such as the active scalars.
void AddArray(
  vtkDataSetAttributes* from, int index, vtkDataSetAttributes* to, vtkAbstractArray* made)
{
  const int attribute = from->IsArrayAnAttribute(index);
  const int added = to->AddArray(made);
  if (attribute >= 0)
  {
    to->SetActiveAttribute(added, attribute);
  }
}
}

bool MeshedArrays::InterpolatePointData(vtkDataSet* input, const Tetrahedra& mesh,
  const std::function<bool()>& isCancelled, vtkUnstructuredGrid* output)
{
  HarmonicExtension extension(mesh);
  extension.IsCancelled = isCancelled;
  vtkPointData* from = input->GetPointData();
  const auto number = static_cast<vtkIdType>(mesh.Origins.size());
  std::vector<double> values(mesh.Origins.size());
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = from->GetArray(a);
    if (!array || IsOfInputAlone(from, array))
    {
      continue;
    }
    vtkSmartPointer<vtkDataArray> made;
    made.TakeReference(vtkDataArray::CreateDataArray(InterpolatedType(array)));
    made->SetName(array->GetName());
    made->SetNumberOfComponents(array->GetNumberOfComponents());
    made->CopyComponentNames(array);
    made->SetNumberOfTuples(number);
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      for (vtkIdType p = 0; p < number; ++p)
      {
        const MeshedPoint& origin = mesh.Origins[p];
        values[p] = 0.0;
        for (int i = 0; i < origin.NumberOfSources; ++i)
        {
          // A value that is not finite counts only where it has a weight.
          values[p] += origin.Weights[i] == 0.0
            ? 0.0
            : origin.Weights[i] * array->GetComponent(origin.Sources[i], c);
        }
      }
      extension.Extend(values);
      if (isCancelled())
      {
        return false;
      }
      for (vtkIdType p = 0; p < number; ++p)
      {
        made->SetComponent(p, c, values[p]);
      }
    }
    AddArray(from, a, output->GetPointData(), made);
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
    if (IsOfInputAlone(from, array))
    {
      continue;
    }
    vtkSmartPointer<vtkAbstractArray> made;
    made.TakeReference(vtkAbstractArray::CreateArray(array->GetDataType()));
    made->SetName(array->GetName());
    made->SetNumberOfComponents(array->GetNumberOfComponents());
    made->CopyComponentNames(array);
    made->SetNumberOfTuples(number);
    for (vtkIdType t = 0; t < number; ++t)
    {
      made->SetTuple(t, mesh.Cells[t], array);
    }
    AddArray(from, a, output->GetCellData(), made);
  }
}

}
