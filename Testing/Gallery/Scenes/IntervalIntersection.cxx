// Two attributes: a range of the first, a range of the second, and both at once.

#include "DataFiles.h"
#include "Look.h"
#include "Props.h"
#include "Scene.h"
#include "Stage.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkIntervalVolume.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace
{
struct Range
{
  const char* Array;
  double Lower;
  double Upper;
};

/// The surface of the tetrahedra where the range holds, and the criterion where one is given; a
/// quarter is cut out.
vtkSmartPointer<vtkPolyData> MakeSolid(
  gallery::Stage& stage, vtkDataSet* disk, const Range& range, const Range* criterion)
{
  vtkNew<vtkIntervalVolume> interval;
  interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, range.Array);
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, range.Lower, range.Upper);
  if (criterion)
  {
    interval->AddCriterion(criterion->Array, criterion->Lower, criterion->Upper);
  }
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, disk);
  return gallery::MakeSurface(
    gallery::CutOut(tetrahedra, { 0.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }, { 0.0, -1.0, 0.0 }));
}

vtkSmartPointer<vtkActor> MakeShell(vtkPolyData* surface, const vtkColor3d& colour)
{
  vtkSmartPointer<vtkActor> shell = gallery::MakeActor(surface, colour, 0.1);
  gallery::SetGlass(shell);
  return shell;
}

void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkDataSet> disk = interlume::ReadData("disk_out_ref.vtu");
  const Range temperature = { "Temp", 380.0, 560.0 };
  const Range arsine = { "AsH3", 0.1, 0.14 };
  const vtkColor3d amber = gallery::IntervalColour(2);
  const vtkColor3d blue = gallery::IntervalColour(0);
  vtkSmartPointer<vtkPolyData> warm = MakeSolid(stage, disk, temperature, nullptr);
  vtkSmartPointer<vtkPolyData> rich = MakeSolid(stage, disk, arsine, nullptr);
  vtkSmartPointer<vtkPolyData> common = MakeSolid(stage, disk, temperature, &arsine);

  gallery::Panel& first = stage.AddPanel("temperature 380 to 560 K");
  gallery::Panel& second = stage.AddPanel("arsine 10 to 14 %");
  gallery::Panel& both = stage.AddPanel("both");
  first.LookFrom({ -1.0, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  second.LookAs(first);
  both.LookAs(first);
  first.Add(gallery::MakeActor(warm, amber));
  second.Add(gallery::MakeActor(rich, blue));
  both.Add(gallery::MakeActor(common, gallery::IntervalColour(1)));
  both.Add(MakeShell(warm, amber));
  both.Add(MakeShell(rich, blue));
}

const gallery::SceneRegistration registration(
  { "interval-intersection", "3.10", "A range of one attribute, of another, and both",
    "Gas around a hot spinning disk in a reactor. Left: a range of temperature. Middle: a range of "
    "the "
    "share of arsine. Right: where both hold, within the "
    "outlines of the two; made by a second pass of the same algorithm over the "
    "tetrahedra of the first.",
    { "disk_out_ref.vtu" }, &Build });
}
