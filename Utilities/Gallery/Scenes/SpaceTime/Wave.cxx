// SPDX-License-Identifier: BSD-3-Clause
// A traveling wave over time: colored by time, and its bounding isosurfaces.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/TimeBoundary.h"
#include "Gallery/TimePanel.h"
#include "Gallery/Volumes.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolumeProperty.h"

#include <array>

namespace
{
using namespace gallery;

/// Returns the test function of the dissertation, a traveling wave, for times from 0 to 1 and x
/// from -\a reach to \a reach. It is linear in z and changes slowly along y, so it needs many
/// points only along x. With fewer, the diagonals of 4-simplices would cause sawtooth artifacts,
/// whose size is proportional to the spacing and to the change between time steps.
vtkSmartPointer<vtkAnalyticFieldSource> MakeWave(int steps, double reach)
{
  auto wave = vtkSmartPointer<vtkAnalyticFieldSource>::New();
  wave->SetFieldToWave();
  wave->SetDimensions(static_cast<int>(72.0 * reach), 20, 8);
  wave->SetBounds(-reach, reach, -1.0, 1.0, -1.0, 1.0);
  wave->SetTimeRange(0.0, 1.0);
  wave->SetNumberOfTimeSteps(steps);
  return wave;
}

void BuildWaveInTime(gallery::Stage& stage)
{
  gallery::Panel& panel = gallery::AddTimePanel(stage, MakeWave(5, 1.4), -0.15, 0.15, 1.1);
  panel.UseParallelProjection();
  panel.Frame(vtkBoundingBox(-1.05, 1.05, -0.1, 0.1, -0.5, 0.5));
  panel.LookFrom({ 0.25, -1.0, 0.05 }, { 0.0, 0.0, 1.0 });
}

const gallery::SceneRegistration waveInTime(
  { "wave-in-time", "3.20", "A wave over five time steps, colored by time",
    "A sheet between two isovalues that follows a wave, over all times from the first to the last "
    "of five steps, seen along its crests. Blue is its position at the first step, green midway, "
    "red at the last, and white is covered most of the time: the wave travels to the right. Colors "
    "of different times are added.",
    {}, &BuildWaveInTime });

void BuildTimeBoundaries(gallery::Stage& stage)
{
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInterval(0, -0.15, 0.15);
  const std::array<const char*, 4> captions = { { "lower surface at the first time",
    "upper surface at the first time", "lower surface at the last time",
    "upper surface at the last time" } };
  const int count = static_cast<int>(captions.size());
  for (int kind = 0; kind < count; ++kind)
  {
    interval->SetGenerateBoundary(kind, true);
  }
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, MakeWave(2, 2.0));

  stage.SetColumns(2);
  for (int kind = 0; kind < count; ++kind)
  {
    gallery::Panel& panel =
      stage.AddPanel(captions[static_cast<std::size_t>(kind)], { 0.25, -1.0, 0.55 });
    panel.SetAmbientOcclusion(0.0);
    panel.SetBackground({ 0.05, 0.055, 0.07 }, { 0.11, 0.12, 0.15 });
    vtkSmartPointer<vtkVolume> volume =
      gallery::MakeTimeColoredVolume(tetrahedra, { 0.0, 1.0 }, 2.0);
    panel.Add(volume);
    panel.Add(
      gallery::MakeActor(gallery::MakeSurface(gallery::MakeTimeBoundary(interval, { kind })),
        gallery::OutlineColor()));
    stage.SetColorBar("time", volume->GetProperty()->GetRGBTransferFunction(), 0.0, 1.0);
  }
}

const gallery::SceneRegistration timeBoundaries(
  { "time-boundaries", "3.27", "Four isosurfaces that bound a time-varying interval volume",
    "A sheet that follows a traveling wave, f from -0.15 to 0.15, at all times between two steps, "
    "green to red. Each panel highlights one of its boundaries: the lower or the upper isosurface "
    "at the first or the last time. The same pass extracts them and the volume.",
    {}, &BuildTimeBoundaries });
}
