// SPDX-License-Identifier: BSD-3-Clause
// Four intervals of one field, each of one color, in one mesh.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"

#include <array>

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> tooth =
    gallery::Reduce(vtkImageData::SafeDownCast(interlume::ReadData("tooth.vti")), 2);
  const std::array<double, 5> bounds = { { 115.0, 150.0, 172.0, 205.0, 255.0 } };
  const std::array<const char*, 4> labels = { { "115 to 150", "150 to 172", "172 to 205",
    "205 to 255" } };
  const std::array<double, 4> extinctions = { { 0.035, 0.035, 0.12, 0.2 } };
  const int count = static_cast<int>(labels.size());
  vtkNew<vtkIntervalVolume> intervals;
  intervals->SetNumberOfIntervals(count);
  intervals->GenerateBoundariesOn();
  std::vector<gallery::IntervalLook> looks;
  std::vector<gallery::ColorEntry> key;
  for (int i = 0; i < count; ++i)
  {
    intervals->SetInterval(i, bounds[i], bounds[i + 1]);
    looks.push_back({ gallery::IntervalColor(i), extinctions[i] });
    key.emplace_back(gallery::IntervalColor(i), labels[i]);
  }

  const vtkVector3d from(-0.8, -1.0, 0.35);
  gallery::Panel& whole = stage.AddPanel("the whole mesh", from);
  gallery::Panel& open = stage.AddPanel("a quarter of the cells hidden", from);
  const auto draw = [&stage, &intervals, &looks](gallery::Panel& panel, vtkImageData* image)
  {
    vtkSmartPointer<vtkUnstructuredGrid> mesh =
      stage.Extract(intervals, gallery::AddGradient(image, "density"));
    vtkSmartPointer<vtkVolume> volume = gallery::MakeVolumeOfIntervals(mesh, looks);
    gallery::GetMapper(volume)->SetBlendModeToComposite();
    gallery::GetMapper(volume)->SetSortMode(vtkTimeWeightedTetrahedraMapper::MPVONC_SORT);
    gallery::SetBoundary(volume, gallery::MakeBoundary(intervals, vtkIntervalVolume::LOWER_SIDE),
      { 1.0, 1.0, 1.0 }, 0.06);
    panel.Add(volume);
  };
  draw(whole, tooth);
  draw(open, gallery::HideQuarter(tooth, 52.0, 46.0));
  stage.SetColorKey("", key);
}

const gallery::SceneRegistration registration(
  { "interval-constant", "3.4", "Four intervals in one mesh, one color each",
    "A CT scan of a tooth, divided by value into four intervals in one pass and rendered as one "
    "mesh in visibility order. Each interval has one color and one opacity: dentin (green) is "
    "translucent and shows the pulp chamber and the root canals, enamel (red) is a cap on top. A "
    "faint shaded boundary below each interval emphasizes its shape.",
    { "tooth.vti" }, &Build });
}
