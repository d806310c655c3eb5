// SPDX-License-Identifier: BSD-3-Clause
// Adjacent intervals of one field, shown in turn.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkExtractVOI.h"
#include "vtkIntervalVolume.h"

#include <array>

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkDataSet> bonsai = interlume::ReadData("bonsai.vti");
  vtkNew<vtkExtractVOI> crown;
  crown->SetInputData(bonsai);
  crown->SetVOI(20, 235, 96, 255, 0, 255);
  crown->Update();
  vtkSmartPointer<vtkImageData> half = gallery::Reduce(crown->GetOutput(), 2);

  const std::array<double, 5> bounds = { { 26.0, 42.0, 60.0, 85.0, 255.0 } };
  const std::array<const char*, 4> captions = { { "leaves, 26 to 42", "twigs, 42 to 60",
    "branches, 60 to 85", "core of the wood, 85 to 255" } };
  const std::array<double, 4> extinctions = { { 0.12, 0.18, 0.18, 0.18 } };
  vtkNew<vtkIntervalVolume> interval;
  stage.SetColumns(2);
  for (int i = 0; i < static_cast<int>(captions.size()); ++i)
  {
    interval->SetInterval(0, bounds[i], bounds[i + 1]);
    vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, half);
    gallery::Panel& panel = stage.AddPanel(captions[i], { 0.4, 0.35, -1.0 }, { 0.0, 1.0, 0.0 });
    panel.Add(gallery::MakeVolumeOfIntervals(
      tetrahedra, { { gallery::IntervalColor(i), extinctions[i] } }));
  }
}

const gallery::SceneRegistration registration(
  { "interval-cycle", "3.5", "Adjacent intervals shown in turn",
    "A CT scan of the crown of a bonsai. Four adjacent intervals from low to high values: leaves, "
    "twigs, branches, and the core of the wood. Each has one color, so the drawing order does not "
    "matter, and nothing is sorted.",
    { "bonsai.vti" }, &Build });
}
