// SPDX-License-Identifier: BSD-3-Clause
// Colour by value within one interval of a curvilinear grid, from two sides.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Intervals/BluntFin.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataObject.h"
#include "vtkIntervalVolume.h"
#include "vtkPiecewiseFunction.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

namespace
{
void Build(gallery::Stage& stage)
{
  const double lower = 1.2;
  const double upper = 4.0;
  vtkSmartPointer<vtkStructuredGrid> flow = gallery::ReadBluntFin();
  vtkNew<vtkIntervalVolume> interval;
  interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Density");
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, lower, 5.0);
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, flow);

  vtkSmartPointer<vtkColorTransferFunction> colours =
    gallery::MakeColourMap(gallery::Map::Viridis, lower, upper);
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(lower, 0.4);
  extinction->AddPoint(2.0, 1.2);
  extinction->AddPoint(upper, 8.0);
  vtkSmartPointer<vtkVolume> air = gallery::MakeVolume(tetrahedra, "Density", colours, extinction);
  vtkSmartPointer<vtkActor> plate = gallery::MakeBluntFinPlate(flow);
  vtkSmartPointer<vtkActor> fin = gallery::MakeBluntFin(flow);

  gallery::Panel& front = stage.AddPanel("from upstream");
  gallery::Panel& back = stage.AddPanel("from above");
  for (gallery::Panel* panel : { &front, &back })
  {
    panel->Add(plate);
    panel->Add(fin);
    panel->Add(air);
  }
  front.LookFrom({ -1.0, 0.5, 0.5 }, { 0.0, 0.0, 1.0 });
  back.LookFrom({ -0.4, 0.5, 1.3 }, { 0.0, 0.0, 1.0 });
  stage.SetColourBar("density (free stream 1)", colours, lower, upper);
}

const gallery::SceneRegistration registration(
  { "interval-linear", "3.3", "One interval of a curvilinear grid, coloured by value",
    "A supersonic stream meets a blunt fin that stands on a plate. The cloud is the air "
    "denser than 1.2 times the free stream, between the shock and the fin; colour and "
    "opacity follow its density, so that the dense air at the edge of the fin shows through "
    "the thinner air around it. The data are one half of the flow; the other half is its "
    "mirror image.",
    { "bluntfin.vts" }, &Build });
}
