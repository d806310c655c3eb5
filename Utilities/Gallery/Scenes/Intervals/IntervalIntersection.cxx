// SPDX-License-Identifier: BSD-3-Clause
// Two attributes: a range of the first, a range of the second, and their intersection.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"

#include <string>

namespace
{
struct Range
{
  const char* Array;
  double Lower;
  double Upper;
};

/// Extracts the tetrahedra inside \a range and, if it is not null, inside \a criterion. Sets their
/// `IntervalId` to \a id.
vtkSmartPointer<vtkUnstructuredGrid> MakeSolid(
  gallery::Stage& stage, vtkDataSet* disk, const Range& range, const Range* criterion, int id)
{
  vtkNew<vtkIntervalVolume> interval;
  interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, range.Array);
  interval->SetInterval(0, range.Lower, range.Upper);
  if (criterion)
  {
    interval->AddCriterion(criterion->Array, criterion->Lower, criterion->Upper);
  }
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, disk);
  tetrahedra->GetCellData()->GetArray("IntervalId")->Fill(id);
  return tetrahedra;
}

void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkDataSet> disk = interlume::ReadData("disk_out_ref.vtu");
  const Range temperature = { "Temp", 380.0, 560.0 };
  const Range arsine = { "AsH3", 0.1, 0.14 };
  const vtkColor3d amber = gallery::IntervalColor(2);
  const vtkColor3d blue = gallery::IntervalColor(0);
  vtkSmartPointer<vtkUnstructuredGrid> warm = MakeSolid(stage, disk, temperature, nullptr, 0);
  vtkSmartPointer<vtkUnstructuredGrid> rich = MakeSolid(stage, disk, arsine, nullptr, 1);
  vtkSmartPointer<vtkUnstructuredGrid> common = MakeSolid(stage, disk, temperature, &arsine, 2);
  vtkNew<vtkAppendFilter> overlapping;
  for (vtkUnstructuredGrid* part : { warm.Get(), rich.Get(), common.Get() })
  {
    overlapping->AddInputData(part);
  }
  overlapping->Update();

  gallery::Panel& first = stage.AddPanel("temperature 380 to 560 K");
  gallery::Panel& second = stage.AddPanel("arsine 10 to 14 %");
  gallery::Panel& both = stage.AddPanel("both");
  first.LookFrom({ -1.0, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  second.ShareCamera(first);
  both.ShareCamera(first);
  const gallery::IntervalLook none = { amber, 0.0 };
  first.Add(gallery::MakeVolumeOfIntervals(warm, { { amber, 0.25 } }));
  second.Add(gallery::MakeVolumeOfIntervals(rich, { none, { blue, 0.25 } }));
  vtkSmartPointer<vtkVolume> volume = gallery::MakeVolumeOfIntervals(overlapping->GetOutput(),
    { { amber, 0.05 }, { blue, 0.05 }, { gallery::IntervalColor(1), 0.4 } });
  // Overlapping tetrahedra have no visibility order. This blend mode does not need one.
  gallery::GetMapper(volume)->SetBlendModeToOpticalDepth();
  both.Add(volume);
}

const gallery::SceneRegistration registration(
  { "interval-intersection", "3.10", "A range of one attribute, of another, and both",
    "Gas around a hot spinning disk in a reactor. Left: a range of temperature. Center: a range of "
    "the arsine fraction. Right: the intersection of both (green) inside the two ranges. A second "
    "pass of the same algorithm extracts it from the tetrahedra of the first. The three "
    "overlapping meshes on the right are rendered together with an order-independent blend mode.",
    { "disk_out_ref.vtu" }, &Build });
}
