// SPDX-License-Identifier: BSD-3-Clause
// A time-varying interval volume with each of its four isosurfaces at the ends highlighted.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/SpaceTime/Wave.h"
#include "Gallery/Stage.h"
#include "Gallery/TimeBoundary.h"
#include "Gallery/Volumes.h"

#include "vtkActor.h"
#include "vtkAnalyticFieldSource.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>

namespace
{
void Build(gallery::Stage& stage)
{
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, -0.15, 0.15);
  const std::array<const char*, 4> captions = { { "a   t = 0, f = -0.15", "b   t = 0, f = 0.15",
    "c   t = 1, f = -0.15", "d   t = 1, f = 0.15" } };
  const int count = static_cast<int>(captions.size());
  for (int kind = 0; kind < count; ++kind)
  {
    interval->SetGenerateBoundary(kind, true);
  }
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, gallery::MakeWave());

  stage.SetColumns(2);
  gallery::Panel* first = nullptr;
  for (int kind = 0; kind < count; ++kind)
  {
    gallery::Panel& panel = stage.AddPanel(captions[static_cast<std::size_t>(kind)]);
    vtkSmartPointer<vtkVolume> volume = gallery::MakeVolumeInTime(tetrahedra, { 0.0, 1.0 }, 2.5);
    panel.Add(volume);
    panel.Add(
      gallery::MakeActor(gallery::MakeSurface(gallery::MakeTimeBoundary(interval, { kind })),
        gallery::IntervalColour(0)));
    if (first)
    {
      panel.LookAs(*first);
    }
    else
    {
      first = &panel;
      panel.LookFrom({ 0.25, -1.0, 0.55 }, { 0.0, 0.0, 1.0 });
      stage.SetColourBar("time", volume->GetProperty()->GetRGBTransferFunction(), 0.0, 1.0);
    }
  }
}

const gallery::SceneRegistration registration({ "time-boundaries", "3.27",
  "Four isosurfaces that bound a time-varying interval volume",
  "A sheet that follows a travelling wave, f from -0.15 to 0.15, at all times between two steps, "
  "green to red. Each panel highlights one of its boundaries: the lower or the upper isosurface at "
  "the first or the last time. They come with the volume in the same pass.",
  {}, &Build });
}
