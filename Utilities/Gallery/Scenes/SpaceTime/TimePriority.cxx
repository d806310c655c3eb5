// SPDX-License-Identifier: BSD-3-Clause
// The interval volumes at two times in one view, each over the other once.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/SpaceTime/TaperedCylinder.h"
#include "Gallery/Stage.h"
#include "Gallery/TimeBoundary.h"
#include "Gallery/Volumes.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkTaperedCylinderSource.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkTaperedCylinderSource> wake = gallery::MakeCylinderWake();
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, 0.991, 0.995);
  interval->GenerateTetrahedraOff();
  const int start = vtkTimeVaryingIntervalVolume::VOLUME_AT_START;
  const int end = vtkTimeVaryingIntervalVolume::VOLUME_AT_END;
  interval->SetGenerateBoundary(start, true);
  interval->SetGenerateBoundary(end, true);
  stage.Extract(interval, wake);
  vtkSmartPointer<vtkUnstructuredGrid> both = gallery::MakeTimeBoundary(interval, { start, end });

  gallery::Panel& later = stage.AddPanel("time 0.6 over time 0");
  gallery::Panel& earlier = stage.AddPanel("time 0 over time 0.6");
  later.LookFrom({ 0.3, -1.0, 0.35 }, { 0.0, 0.0, 1.0 });
  earlier.LookAs(later);
  const vtkColor3d yellow = gallery::IntervalColour(2);
  const vtkColor3d red = gallery::IntervalColour(3);
  for (gallery::Panel* panel : { &later, &earlier })
  {
    vtkSmartPointer<vtkVolume> volume =
      gallery::MakeVolumeOfIntervals(both, { { yellow, 6.0 }, { red, 6.0 } });
    vtkTimeWeightedTetrahedraMapper* mapper = gallery::GetMapper(volume);
    mapper->SetBlendModeToPriority();
    mapper->SetLayerPriority(0, panel == &later ? 0.0 : 2.0);
    mapper->SetLayerPriority(1, 1.0);
    panel->Add(volume);
    panel->Add(gallery::MakeCylinder(wake, gallery::Pencil()));
  }
  stage.SetColourKey("", { { yellow, "time 0" }, { red, "time 0.6" } });
}

const gallery::SceneRegistration registration({ "time-priority", "3.30",
  "Interval volumes at two times, each over the other",
  "The vortices behind a tapered cylinder at two times in one view, yellow before red. One of the "
  "two is drawn over the other whatever their depth, by priority and not by distance; compare with "
  "the picture of all times between.",
  {}, &Build });
}
