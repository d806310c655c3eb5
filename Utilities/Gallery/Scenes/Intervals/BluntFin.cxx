// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Intervals/BluntFin.h"

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"

#include <cstdlib>
#include <utility>
#include <vector>

namespace gallery
{
namespace
{
/// The lid between the upper edges of both sides of the fin.
vtkSmartPointer<vtkPolyData> MakeLid(vtkStructuredGrid* flow)
{
  int dimensions[3];
  flow->GetDimensions(dimensions);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (int i = 0; i <= dimensions[0] / 2; ++i)
  {
    for (const int side : { i, dimensions[0] - 1 - i })
    {
      int place[3] = { side, 0, dimensions[2] - 1 };
      points->InsertNextPoint(flow->GetPoint(vtkStructuredData::ComputePointId(dimensions, place)));
    }
    if (i > 0)
    {
      const vtkIdType last = 2 * static_cast<vtkIdType>(i);
      const vtkIdType corners[4] = { last - 2, last - 1, last + 1, last };
      quads->InsertNextCell(4, corners);
    }
  }
  vtkNew<vtkPolyData> lid;
  lid->SetPoints(points);
  lid->SetPolys(quads);
  return MakeSurface(lid);
}
}

vtkSmartPointer<vtkStructuredGrid> ReadBluntFin()
{
  vtkSmartPointer<vtkDataSet> data =
    AddMagnitude(interlume::ReadData("bluntfin.vts"), "Velocity", "Speed");
  vtkStructuredGrid* half = vtkStructuredGrid::SafeDownCast(data);
  int dimensions[3];
  half->GetDimensions(dimensions);
  int wholeDimensions[3] = { 2 * dimensions[0] - 1, dimensions[1], dimensions[2] };
  auto whole = vtkSmartPointer<vtkStructuredGrid>::New();
  whole->SetDimensions(wholeDimensions);
  vtkNew<vtkPoints> points;
  points->SetDataType(half->GetPoints()->GetDataType());
  points->SetNumberOfPoints(
    static_cast<vtkIdType>(wholeDimensions[0]) * wholeDimensions[1] * wholeDimensions[2]);
  whole->SetPoints(points);
  std::vector<std::pair<vtkDataArray*, vtkDataArray*>> arrays;
  for (int array = 0; array < half->GetPointData()->GetNumberOfArrays(); ++array)
  {
    vtkDataArray* from = half->GetPointData()->GetArray(array);
    if (from && from->GetNumberOfComponents() == 1)
    {
      auto to = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
      to->SetName(from->GetName());
      to->SetNumberOfTuples(points->GetNumberOfPoints());
      whole->GetPointData()->AddArray(to);
      arrays.emplace_back(from, to);
    }
  }
  for (int k = 0; k < dimensions[2]; ++k)
  {
    for (int j = 0; j < dimensions[1]; ++j)
    {
      for (int i = 0; i < wholeDimensions[0]; ++i)
      {
        const int offset = i - (dimensions[0] - 1);
        int place[3] = { std::abs(offset), j, k };
        int wholePlace[3] = { i, j, k };
        const vtkIdType from = vtkStructuredData::ComputePointId(dimensions, place);
        const vtkIdType to = vtkStructuredData::ComputePointId(wholeDimensions, wholePlace);
        double point[3];
        half->GetPoint(from, point);
        points->SetPoint(to, point[0], offset < 0 ? -point[1] : point[1], point[2]);
        for (const auto& array : arrays)
        {
          array.second->SetTuple(to, from, array.first);
        }
      }
    }
  }
  return whole;
}

vtkSmartPointer<vtkActor> MakeBluntFin(vtkStructuredGrid* flow)
{
  vtkNew<vtkAppendPolyData> fin;
  fin->AddInputData(MakeWall(flow, 1, 0));
  fin->AddInputData(MakeLid(flow));
  fin->Update();
  return MakeActor(fin->GetOutput(), Pencil());
}

vtkSmartPointer<vtkActor> MakeBluntFinPlate(vtkStructuredGrid* flow)
{
  return MakeActor(MakeWall(flow, 2, 0), Pencil());
}
}
