// SPDX-License-Identifier: BSD-3-Clause
// A polygonal dart that points at rings in a volume.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Rings.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::SampleRings();
  gallery::Panel& panel = gallery::AddShadowPanel(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -1.6, -1.6, 3.8 }, 0.85));
  // With this gain, the dart is as bright as the volume, whose soft edges attenuate the light.
  gallery::AddModel(panel,
    interlume::Move(interlume::MakeDart(), { { -0.12, -0.2, 0.52 } }, { { 45.0, 24.0, 28.0 } }),
    gallery::EDGE_GAIN);
  gallery::UseSceneShadows(panel);
  gallery::UseFullResolution(panel);
  panel.SetBackground({ 0.84, 0.80, 0.74 }, { 0.52, 0.44, 0.42 });
  panel.LookFrom({ 0.1, -1.0, 0.8 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.4, 1.4, -0.1, 0.1, -1.18, 0.98));
}

const gallery::SceneRegistration registration({ "rings-dart", "2.44", "A dart and rings",
  "The rings and the plate are a volume, the dart consists of polygons. Its shadow curves over the "
  "rings and continues on the plate. The rings shade the tip of the dart.",
  {}, &Build });
}
