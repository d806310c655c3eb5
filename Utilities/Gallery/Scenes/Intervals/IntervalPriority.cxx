// SPDX-License-Identifier: BSD-3-Clause
// Intervals drawn by priority, and in reverse order.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkDataSet.h"
#include "vtkIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"

#include <array>

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkDataSet> protein = interlume::ReadData("neghip.vti");
  const std::array<double, 5> bounds = { { 40.0, 50.0, 100.0, 160.0, 255.0 } };
  const std::array<const char*, 4> labels = { { "40 to 50", "50 to 100", "100 to 160",
    "160 to 255" } };
  const std::array<double, 4> extinctions = { { 0.3, 0.05, 0.12, 0.2 } };
  const int count = static_cast<int>(labels.size());
  vtkNew<vtkIntervalVolume> intervals;
  intervals->SetNumberOfIntervals(count);
  for (int i = 0; i < count; ++i)
  {
    intervals->SetInterval(i, bounds[i], bounds[i + 1]);
  }
  vtkSmartPointer<vtkUnstructuredGrid> mesh = stage.Extract(intervals, protein);

  const vtkVector3d from(-1.0, -0.7, 0.5);
  gallery::Panel& outside = stage.AddPanel("low values painted last", from);
  gallery::Panel& inside = stage.AddPanel("high values painted last", from);
  std::vector<gallery::IntervalLook> looks;
  std::vector<gallery::ColorEntry> key;
  for (int i = 0; i < count; ++i)
  {
    looks.push_back({ gallery::IntervalColor(i), extinctions[i] });
    key.emplace_back(gallery::IntervalColor(i), labels[i]);
  }
  for (gallery::Panel* panel : { &outside, &inside })
  {
    vtkSmartPointer<vtkVolume> volume = gallery::MakeVolumeOfIntervals(mesh, looks);
    vtkTimeWeightedTetrahedraMapper* mapper = gallery::GetMapper(volume);
    mapper->SetBlendModeToPriority();
    for (int i = 0; i < count; ++i)
    {
      mapper->SetLayerPriority(i, panel == &inside ? i : count - 1 - i);
    }
    panel->Add(volume);
  }
  stage.SetColorKey("", key);
}

const gallery::SceneRegistration registration(
  { "interval-priority", "3.6", "Intervals drawn by priority, and in reverse order",
    "Electron density of a protein in four intervals. Each interval is drawn over the previous "
    "ones regardless of depth, and no interval is sorted. If low values are last, the thin outer "
    "shell lies over the cores; if high values are last, the cores stand out.",
    { "neghip.vti" }, &Build });
}
