// Colour by value within one interval of a curvilinear grid, from two sides.

#include "BluntFin.h"
#include "DataFiles.h"
#include "Look.h"
#include "Props.h"
#include "Scene.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkIntervalVolume.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

namespace
{
void Build(gallery::Stage& stage)
{
  const double lower = 1.2;
  const double upper = 4.0;
  vtkSmartPointer<vtkDataSet> flow = interlume::ReadData("bluntfin.vts");
  vtkNew<vtkIntervalVolume> interval;
  interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Density");
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, lower, 5.0);
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, flow);

  vtkSmartPointer<vtkColorTransferFunction> colours =
    gallery::MakeColourMap(gallery::Map::Viridis, lower, upper);
  vtkSmartPointer<vtkActor> solid = gallery::MakeColouredActor(
    gallery::AddMirrorImage(gallery::MakeSurface(tetrahedra)), "Density", colours);
  vtkStructuredGrid* grid = vtkStructuredGrid::SafeDownCast(flow);
  vtkSmartPointer<vtkActor> plate = gallery::MakeBluntFinPlate(grid);
  vtkSmartPointer<vtkActor> fin = gallery::MakeBluntFin(grid);

  gallery::Panel& front = stage.AddPanel("from upstream");
  gallery::Panel& back = stage.AddPanel("from above");
  for (gallery::Panel* panel : { &front, &back })
  {
    panel->Add(plate);
    panel->Add(fin);
    panel->Add(solid);
  }
  front.LookFrom({ -1.0, 0.5, 0.5 }, { 0.0, 0.0, 1.0 });
  back.LookFrom({ -0.4, 0.5, 1.3 }, { 0.0, 0.0, 1.0 });
  stage.SetColourBar("density (free stream 1)", colours, lower, upper);
}

const gallery::SceneRegistration registration({ "interval-linear", "3.3",
  "One interval of a curvilinear grid, coloured by value",
  "A supersonic stream meets a blunt fin that stands on a plate. The solid is the air denser than "
  "1.2 times the free stream, between the shock and the fin, coloured by its density; the grid "
  "ends "
  "at the top, where the inside shows. The data are one half of the flow; the other half is its "
  "mirror image.",
  { "bluntfin.vts" }, &Build });
}
