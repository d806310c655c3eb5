// SPDX-License-Identifier: BSD-3-Clause
// Extracted by one array, coloured by another.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Intervals/BluntFin.h"
#include "Gallery/Stage.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataObject.h"
#include "vtkIntervalVolume.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

namespace
{
void Build(gallery::Stage& stage)
{
  const double slow = 1.75;
  vtkSmartPointer<vtkStructuredGrid> flow = gallery::ReadBluntFin();
  vtkNew<vtkIntervalVolume> interval;
  interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Speed");
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, 0.0, slow);
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, flow);

  const double lower = 0.4;
  const double upper = 1.6;
  vtkSmartPointer<vtkColorTransferFunction> colours =
    gallery::MakeColourMap(gallery::Map::Viridis, lower, upper);
  gallery::Panel& panel = stage.AddPanel("");
  panel.Add(gallery::MakeColouredActor(gallery::MakeSurface(tetrahedra), "Pressure", colours));
  panel.Add(gallery::MakeBluntFin(flow));
  panel.LookFrom({ -1.0, 0.8, 0.8 }, { 0.0, 0.0, 1.0 });
  stage.SetColourBar(
    "pressure where the speed is below 1.75 (above 1.6 drawn as 1.6)", colours, lower, upper);
}

const gallery::SceneRegistration registration(
  { "interval-two-attributes", "3.9", "Extracted by speed, coloured by pressure",
    "A supersonic stream meets a blunt fin that stands on a plate. The solid is the slow air: the "
    "boundary layers of plate and fin, and the horseshoe vortex that wraps around the foot of the "
    "fin. Its colour is another attribute, the pressure, carried through the extraction. The data "
    "are "
    "one half of the flow; the other half is its mirror image.",
    { "bluntfin.vts" }, &Build });
}
