// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceLattice.h"

#include "Support/Meshes/ReferenceMesh.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

namespace reference
{

namespace
{

vtkSmartPointer<vtkRectilinearGrid> MakeRectilinear(vtkImageData* image)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  auto rectilinear = vtkSmartPointer<vtkRectilinearGrid>::New();
  rectilinear->SetDimensions(dimensions);
  vtkNew<vtkDoubleArray> coordinates[3];
  const vtkIdType strides[3] = { 1, dimensions[0],
    static_cast<vtkIdType>(dimensions[0]) * dimensions[1] };
  for (int a = 0; a < 3; ++a)
  {
    for (int i = 0; i < dimensions[a]; ++i)
    {
      coordinates[a]->InsertNextValue(image->GetPoint(i * strides[a])[a]);
    }
  }
  rectilinear->SetXCoordinates(coordinates[0]);
  rectilinear->SetYCoordinates(coordinates[1]);
  rectilinear->SetZCoordinates(coordinates[2]);
  return rectilinear;
}

}

vtkSmartPointer<vtkImageData> MakeImage(const std::array<int, 3>& cells)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
  image->SetOrigin(-1.3, 0.7, 2.1);
  image->SetSpacing(0.1, 0.3, 0.7);
  return image;
}

std::vector<DataSetVariant> FormsOf(vtkImageData* image)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(image->GetPoint(i));
  }

  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(dimensions);
  structured->SetPoints(points);

  std::vector<DataSetVariant> forms = { { "image", image }, { "structured", structured } };
  if (image->GetDirectionMatrix()->IsIdentity())
  {
    forms.push_back({ "rectilinear", MakeRectilinear(image) });
  }
  const std::array<int, 3> cells = { dimensions[0] - 1, dimensions[1] - 1, dimensions[2] - 1 };
  for (MeshKind kind : { MeshKind::Hexahedra, MeshKind::Voxels })
  {
    vtkSmartPointer<vtkUnstructuredGrid> mesh = MakeMesh(kind, cells);
    mesh->SetPoints(points);
    forms.push_back({ GetName(kind), mesh });
  }
  for (size_t i = 1; i < forms.size(); ++i)
  {
    forms[i].Data->GetPointData()->ShallowCopy(image->GetPointData());
    forms[i].Data->GetCellData()->ShallowCopy(image->GetCellData());
  }
  return forms;
}

}
