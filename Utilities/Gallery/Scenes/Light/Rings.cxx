// SPDX-License-Identifier: BSD-3-Clause
// Seven tori, with shadows on each other and on a plate.

#include "Gallery/Scenes/Light/Rings.h"

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModelSource.h"

vtkSmartPointer<vtkImageData> gallery::SampleRings()
{
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite(
    { gallery::Place(
        gallery::Soften(vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::RINGS)),
        { 0.0, 0.0, 0.42 }, 8.0),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 1.25, 0.06, gallery::Plaster()) });
  return gallery::Sample(all, vtkBoundingBox(-1.3, 1.3, -1.3, 1.3, -0.1, 0.8), 220);
}

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::SampleRings();
  gallery::Panel& panel = gallery::AddShadowPanel(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -2.2, -1.2, 3.6 }, 0.85));
  panel.LookFrom({ 0.1, -1.0, 0.8 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.4, 1.4, -0.1, 0.1, -1.18, 0.98));
}

void BuildSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::SampleRings();
  gallery::AddSoftPair(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -2.2, -1.2, 3.6 }, 0.85), 0.9)
    .Look({ 0.1, -1.0, 0.8 }, vtkBoundingBox(-1.28, 1.28, -0.1, 0.1, -1.1, 0.98));
}

const gallery::SceneRegistration registration({ "rings", "2.7", "Rings with shadows on each other",
  "Six tori are threaded on a seventh. Each casts its shadow on the others and on the disk below. "
  "The edges are classified per pixel and remain sharp.",
  {}, &Build });

const gallery::SceneRegistration softRegistration(
  { "rings-soft", "2.33", "Rings under a point light and under a disk light",
    "A disk light instead of a point light. A shadow is sharp where a ring touches another ring or "
    "the plate, and becomes wider with the distance from the ring.",
    {}, &BuildSoft });
}
