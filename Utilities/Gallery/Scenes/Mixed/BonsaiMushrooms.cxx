// SPDX-License-Identifier: BSD-3-Clause
// Mushrooms of polygons under a scanned bonsai.

#include "Gallery/Panel.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Bonsai.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkSpatialObject.h"
#include "vtkSpatialPrimitive.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{
using namespace interlume;

Model MakeMushrooms()
{
  Model all = Move(MakeMushroom(0.36, 0.16, 0.08), { { 0.3, -0.36, 0.0 } }, { { 0.0, 0.0, 20.0 } });
  Append(
    all, Move(MakeMushroom(0.22, 0.11, 0.15), { { 0.44, -0.58, 0.0 } }, { { 0.0, 0.0, -60.0 } }));
  return Append(
    all, Move(MakeMushroom(0.28, 0.13, 0.12), { { -0.36, -0.46, 0.0 } }, { { 0.0, 0.0, 200.0 } }));
}

vtkSmartPointer<vtkImageData> SampleTree()
{
  return gallery::Sample(gallery::Unite({ gallery::MakeBonsai(),
                           gallery::MakeDisk({ 0.0, -0.1, 0.0 }, 0.74, 0.05, gallery::Plaster()) }),
    vtkBoundingBox(-0.76, 0.76, -0.86, 0.66, -0.07, 1.1), 230, 0.5);
}

void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleTree();
  gallery::ShadowPair pair = gallery::AddShadowPair(stage, image, gallery::MakeSolidMatter(image),
    gallery::MakeStudioLights({ -1.8, -1.4, 3.2 }, 0.85));
  pair.Without.SetAmbientOcclusion(0.0);
  gallery::AddModel(pair.Without, MakeMushrooms());
  gallery::AddModel(pair.With, MakeMushrooms(), gallery::EDGE_GAIN);
  gallery::UseSceneShadows(pair.With);
  for (gallery::Panel* panel : { &pair.Without, &pair.With })
  {
    gallery::UseFinePictures(*panel);
  }
  pair.Look({ 0.1, -1.0, 0.5 }, vtkBoundingBox(-0.7, 0.7, -0.1, 0.1, -0.4, 1.06));
}

void BuildOtherLight(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleTree();
  gallery::Panel& panel = gallery::AddShadowPanel(stage, image, gallery::MakeSolidMatter(image),
    gallery::MakeStudioLights({ 2.2, -1.7, 2.2 }, 1.15));
  gallery::AddModel(panel, MakeMushrooms(), gallery::EDGE_GAIN);
  gallery::UseSceneShadows(panel);
  gallery::UseFinePictures(panel);
  panel.LookFrom({ 0.1, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-0.9, 0.9, -0.1, 0.1, -0.54, 1.08));
}

const gallery::SceneRegistration registration({ "bonsai-mushrooms", "2.41",
  "A bonsai and mushrooms, without and with shadows",
  "The bonsai, its pot and the plate are a volume, the mushrooms are of polygons. With shadows all "
  "of them stand on the plate: the mushrooms' shadows fall on it and on the pot, that of the tree "
  "on the pot and the plate.",
  { "bonsai.vti" }, &Build });
const gallery::SceneRegistration otherRegistration(
  { "bonsai-mushrooms-light", "2.42", "A bonsai and mushrooms under another light",
    "The same in a low light from the right, with long shadows: those of the mushrooms reach the "
    "pot.",
    { "bonsai.vti" }, &BuildOtherLight });
}
