// SPDX-License-Identifier: BSD-3-Clause
// An interval volume with its inner boundary surface highlighted.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkIntervalVolume.h"
#include "vtkProperty.h"
#include "vtkTimeWeightedTetrahedraMapper.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkDataSet> orbital =
    gallery::AddGradient(interlume::ReadData("hydrogen_orbital.vti"), "probability_density");
  vtkNew<vtkIntervalVolume> interval;
  interval->SetInterval(0, 0.04, 0.25);
  interval->GenerateBoundariesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(interval, orbital);
  vtkSmartPointer<vtkUnstructuredGrid> inner =
    gallery::MakeBoundary(interval, vtkIntervalVolume::UPPER_SIDE);

  const vtkVector3d from(1.0, -1.0, 0.5);
  gallery::Panel& plain = stage.AddPanel("the interval", from);
  gallery::Panel& highlighted = stage.AddPanel("its inner boundary highlighted", from);
  const vtkColor3d blue = gallery::IntervalColor(0);
  plain.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { blue, 0.035 } }));
  // Thinner, so that the boundary behind it keeps its color.
  vtkSmartPointer<vtkVolume> volume =
    gallery::MakeVolumeOfIntervals(tetrahedra, { { blue, 0.018 } });
  gallery::SetBoundary(volume, inner, gallery::IntervalColor(2), 1.0);
  vtkProperty* property = gallery::GetMapper(volume)->GetBoundaryProperty();
  property->SetAmbient(0.35);
  property->SetDiffuse(0.6);
  property->SetSpecular(0.2);
  highlighted.Add(volume);
}

const gallery::SceneRegistration registration(
  { "interval-boundary", "3.7", "The inner boundary of an interval, highlighted",
    "Probability density of an electron in a hydrogen atom, from 0.04 to 0.25 of its maximum. The "
    "same pass extracts the interval and its inner boundary. The boundary, opaque, shaded and "
    "glossy behind the front part of the volume, shows where the values exceed the interval.",
    { "hydrogen_orbital.vti" }, &Build });
}
