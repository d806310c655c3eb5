// An interval volume with its inner boundary surface highlighted.

#include "DataFiles.h"
#include "Look.h"
#include "Props.h"
#include "Scene.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkIntervalVolume.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkDataSet> orbital =
    gallery::AddGradient(interlume::ReadData("hydrogen_orbital.vti"));
  vtkNew<vtkIntervalVolume> interval;
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, 0.04, 0.25);
  interval->GenerateBoundariesOn();
  stage.Extract(interval, orbital);
  vtkUnstructuredGrid* boundaries =
    vtkUnstructuredGrid::SafeDownCast(interval->GetOutputDataObject(1));
  vtkSmartPointer<vtkPolyData> outer =
    gallery::MakeSurface(gallery::SelectSide(boundaries, vtkIntervalVolume::LOWER_SIDE));
  vtkSmartPointer<vtkPolyData> inner =
    gallery::MakeSurface(gallery::SelectSide(boundaries, vtkIntervalVolume::UPPER_SIDE));
  gallery::SetGradientNormals(outer, vtkIntervalVolume::LOWER_SIDE);
  gallery::SetGradientNormals(inner, vtkIntervalVolume::UPPER_SIDE);

  gallery::Panel& plain = stage.AddPanel("the interval");
  gallery::Panel& highlighted = stage.AddPanel("its inner boundary highlighted");
  plain.LookFrom({ 1.0, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  highlighted.LookAs(plain);
  const vtkColor3d blue = gallery::IntervalColour(0);
  vtkSmartPointer<vtkActor> shell = gallery::MakeActor(outer, blue, 0.2);
  gallery::SetGlass(shell);
  vtkSmartPointer<vtkActor> faint = gallery::MakeActor(inner, blue, 0.2);
  gallery::SetGlass(faint);
  plain.Add(shell);
  plain.Add(faint);

  vtkSmartPointer<vtkActor> bright = gallery::MakeActor(inner, gallery::IntervalColour(2));
  gallery::SetGlossy(bright);
  highlighted.Add(shell);
  highlighted.Add(bright);
}

const gallery::SceneRegistration registration(
  { "interval-boundary", "3.7", "The inner boundary of an interval, highlighted",
    "Probability density of an electron in a hydrogen atom, from 0.04 to 0.25 of its maximum. The "
    "inner "
    "boundary comes with the interval in the same pass; drawn opaque, shaded and glossy, it shows "
    "where the values leave the interval upwards.",
    { "hydrogen_orbital.vti" }, &Build });
}
