// Adjacent intervals of one field, shown in turn.

#include "DataFiles.h"
#include "Look.h"
#include "Props.h"
#include "Scene.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkExtractVOI.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <array>

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkDataSet> bonsai = interlume::ReadData("bonsai.vti");
  vtkNew<vtkExtractVOI> withoutTable;
  withoutTable->SetInputData(bonsai);
  withoutTable->SetVOI(20, 235, 20, 235, 0, 255);
  withoutTable->Update();
  vtkSmartPointer<vtkImageData> half = gallery::Reduce(withoutTable->GetOutput(), 2);

  const std::array<double, 4> bounds = { { 34.0, 75.0, 140.0, 255.0 } };
  const std::array<const char*, 3> captions = { { "34 to 75", "75 to 140", "140 to 255" } };
  const std::array<int, 3> colours = { { 1, 2, 3 } };
  vtkNew<vtkIntervalVolume> interval;
  interval->SetNumberOfIntervals(1);
  gallery::Panel* first = nullptr;
  for (int i = 0; i < static_cast<int>(captions.size()); ++i)
  {
    interval->SetInterval(0, bounds[i], bounds[i + 1]);
    vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, half);
    gallery::Panel& panel = stage.AddPanel(captions[i]);
    panel.Add(gallery::MakeActor(
      gallery::MakeSurface(tetrahedra, 80.0), gallery::IntervalColour(colours[i])));
    if (first)
    {
      panel.LookAs(*first);
    }
    else
    {
      panel.LookFrom({ 0.4, 0.35, -1.0 }, { 0.0, 1.0, 0.0 });
      first = &panel;
    }
  }
}

const gallery::SceneRegistration registration({ "interval-cycle", "3.5",
  "Adjacent intervals shown in turn",
  "CT of a bonsai. Three adjacent intervals, one after the other from low to high values: leaves, "
  "wood, and the pot with its gravel. Each is of one colour, so no order of drawing matters.",
  { "bonsai.vti" }, &Build });
}
