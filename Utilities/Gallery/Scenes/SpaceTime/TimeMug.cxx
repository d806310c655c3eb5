// SPDX-License-Identifier: BSD-3-Clause
// A hot front that spreads in a mug, over many time steps.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/TimePanel.h"
#include "Gallery/Volumes.h"
#include "Support/Inputs/DataFiles.h"
#include "Support/Inputs/ExodusTimeSource.h"

#include "vtkDataObject.h"
#include "vtkFeatureEdges.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolumeProperty.h"

#include <vector>

namespace
{
/// Returns the sharp edges of the mug.
vtkSmartPointer<vtkActor> MakeEdges(vtkUnstructuredGrid* mug)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(gallery::MakeSurface(mug));
  // MakeSurface() duplicates points at sharp edges, so these are boundary edges.
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  vtkSmartPointer<vtkActor> actor = gallery::MakeActor(edges->GetOutput(), gallery::TextColor());
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(2.0);
  return actor;
}

void Build(gallery::Stage& stage)
{
  vtkNew<interlume::ExodusTimeSource> mug;
  mug->SetFileName(interlume::DataFile("mug.ex2"));
  const std::vector<double> times = gallery::GetTimeSteps(mug);
  for (const char* array : { "diffused", "convected" })
  {
    vtkNew<vtkTimeVaryingIntervalVolume> interval;
    interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
    interval->SetInterval(0, 0.3, 0.5);
    vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, mug);

    gallery::Panel& panel = stage.AddPanel(array);
    vtkSmartPointer<vtkVolume> volume = gallery::MakeTimeColoredVolume(tetrahedra, times, 16.0);
    panel.Add(volume);
    panel.Add(MakeEdges(mug->GetOutput()));
    panel.LookFrom({ 0.3, -1.0, 0.45 }, { 0.0, 0.0, 1.0 });
    stage.SetColorBar(
      "time", volume->GetProperty()->GetRGBTransferFunction(), times.front(), times.back());
  }
}
}

const gallery::SceneRegistration registration(
  { "time-mug", "3.25", "Heat that spreads in a mug over eleven time steps",
    "Simulation data: the region where two fields in the wall of a mug, heated at its bottom, are "
    "from 0.3 to 0.5, over all times between eleven steps, from blue (first) to red (last). Colors "
    "of overlapping times are mixed. The diffused quantity rises evenly. The convected quantity "
    "climbs almost to the rim at the left early and stays there at all times, whose mean is green.",
    { "mug.ex2" }, &Build });
