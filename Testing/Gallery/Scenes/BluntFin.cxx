#include "BluntFin.h"

#include "Look.h"
#include "Props.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"

namespace gallery
{
namespace
{
/// The lid between the upper edge of the fin's side and its mirror image.
vtkSmartPointer<vtkPolyData> MakeLid(vtkStructuredGrid* flow)
{
  int dimensions[3];
  flow->GetDimensions(dimensions);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (int i = 0; i < dimensions[0]; ++i)
  {
    int place[3] = { i, 0, dimensions[2] - 1 };
    double point[3];
    flow->GetPoint(vtkStructuredData::ComputePointId(dimensions, place), point);
    points->InsertNextPoint(point);
    points->InsertNextPoint(point[0], -point[1], point[2]);
    if (i > 0)
    {
      const vtkIdType last = 2 * static_cast<vtkIdType>(i);
      const vtkIdType corners[4] = { last - 2, last - 1, last + 1, last };
      quads->InsertNextCell(4, corners);
    }
  }
  auto lid = vtkSmartPointer<vtkPolyData>::New();
  lid->SetPoints(points);
  lid->SetPolys(quads);
  return MakeSurface(lid);
}
}

vtkSmartPointer<vtkActor> MakeBluntFin(vtkStructuredGrid* flow)
{
  vtkNew<vtkAppendPolyData> fin;
  fin->AddInputData(AddMirrorImage(MakeWall(flow, 1, 0)));
  fin->AddInputData(MakeLid(flow));
  fin->Update();
  return MakeActor(fin->GetOutput(), Pencil());
}

vtkSmartPointer<vtkActor> MakeBluntFinPlate(vtkStructuredGrid* flow)
{
  return MakeActor(AddMirrorImage(MakeWall(flow, 2, 0)), Pencil());
}
}
