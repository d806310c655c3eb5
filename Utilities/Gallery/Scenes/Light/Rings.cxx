// SPDX-License-Identifier: BSD-3-Clause
// Seven tori, with shadows on each other and on a plate.

#include "Gallery/Scenes/Light/Rings.h"

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModelSource.h"

namespace
{
vtkSmartPointer<vtkSpatialObject> MakeRings()
{
  return gallery::Place(
    gallery::SoftenEdges(vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::RINGS)),
    { 0.0, 0.0, 0.42 }, 8.0);
}
}

vtkSmartPointer<vtkImageData> gallery::SampleRings()
{
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite(
    { MakeRings(), gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 1.25, 0.06, gallery::PlasterColor()) });
  return gallery::Sample(all, vtkBoundingBox(-1.3, 1.3, -1.3, 1.3, -0.1, 0.8), 220);
}

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::SampleRings();
  gallery::Panel& panel = gallery::AddShadowPanel(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -2.2, -1.2, 3.6 }, 0.85));
  panel.SetBackground({ 0.80, 0.82, 0.84 }, { 0.46, 0.54, 0.64 });
  panel.LookFrom({ 0.1, -1.0, 0.8 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.4, 1.4, -0.1, 0.1, -1.18, 0.98));
}

void BuildSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(gallery::Unite({ MakeRings(), gallery::MakeFloor({ 0.88, 0.84, 0.78 }) }),
      vtkBoundingBox(-1.7, 1.7, -1.7, 1.7, -0.06, 0.8), 260);
  gallery::SoftShadowPair pair =
    gallery::AddSoftShadowPair(stage, image, gallery::MakeSolidMedium(image),
      gallery::MakeStudioLights({ -1.1, -0.8, 4.4 }, 0.85), 1.2, 0.0, 512);
  pair.SetBackground({ 0.84, 0.86, 0.88 }, { 0.50, 0.58, 0.66 });
  pair.Look({ 0.1, -1.0, 1.3 }, vtkBoundingBox(-0.94, 1.2, -0.1, 0.1, -1.15, 1.6));
}

const gallery::SceneRegistration registration({ "rings", "2.7", "Rings with shadows on each other",
  "Six tori are threaded on a seventh. Each casts its shadow on the others and on the disk below. "
  "The edges are classified per pixel and remain sharp.",
  {}, &Build });

const gallery::SceneRegistration softRegistration(
  { "rings-soft", "2.33", "Rings under a point light and under a disk light",
    "A disk light instead of a point light. The closer a part of a ring is to the floor, the "
    "sharper is its shadow.",
    {}, &BuildSoft });
}
