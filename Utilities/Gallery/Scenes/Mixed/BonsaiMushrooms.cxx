// SPDX-License-Identifier: BSD-3-Clause
// Polygonal mushrooms under a scanned bonsai.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Bonsai.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"

#include "vtkActorCollection.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"

namespace
{
using namespace interlume;

/// Number of samples of area lights, for both the tree and the mushrooms.
constexpr int SAMPLES = 64;

/// Color of the ground.
constexpr Position3 GROUND{ { 0.82, 0.75, 0.64 } };

Model MakeMushrooms()
{
  Model all =
    Move(MakeMushroom(0.36, 0.16, 0.08), { { 0.34, -0.34, 0.0 } }, { { 0.0, 0.0, 20.0 } });
  Append(
    all, Move(MakeMushroom(0.22, 0.11, 0.15), { { 0.12, -0.62, 0.0 } }, { { 0.0, 0.0, -60.0 } }));
  return Append(
    all, Move(MakeMushroom(0.28, 0.13, 0.12), { { -0.27, -0.4, 0.0 } }, { { 0.0, 0.0, 200.0 } }));
}

/// Adds the mushrooms and the ground to a panel that shows the bonsai. For \a gain, see AddModel().
void AddSurfaces(gallery::Panel& panel, double gain)
{
  gallery::AddModel(panel, MakeMushrooms(), gain);
  gallery::AddGround(panel, { { 0.0, 0.0, 0.0 } }, 2.4, gain, GROUND);
  // The ground casts no shadows, so the mushrooms fill the shadow maps.
  vtkShadowedScenePass::SetCastsShadows(panel.GetRenderer()->GetActors()->GetLastActor(), false);
  gallery::UseFullResolution(panel);
  panel.SetBackground({ 0.88, 0.88, 0.82 }, { 0.48, 0.58, 0.60 });
}

/// Adds a panel of the bonsai in \a image and the mushrooms, with mutual shadows. Each
/// shadow-casting light in \a lights is replaced by a disk light of \a diameter.
gallery::Panel& AddSoftShadows(gallery::Stage& stage, const std::string& caption,
  vtkImageData* image, const gallery::Lights& lights, double diameter)
{
  gallery::Panel& panel = stage.AddPanel(caption);
  vtkSmartPointer<vtkVolume> volume =
    gallery::MakeSlicedVolume(image, gallery::MakeSolidMedium(image));
  gallery::GetSlicedMapper(volume)->SetLightBufferSize(512);
  panel.Add(volume);
  panel.SetLights(gallery::MakeDiskLights(lights, diameter));
  AddSurfaces(panel, gallery::EDGE_GAIN);
  gallery::UseSceneShadows(panel, SAMPLES);
  return panel;
}

void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::SampleBonsai(220);
  const gallery::Lights lights = gallery::MakeStudioLights({ -0.3, -2.5, 3.3 }, 1.15);
  gallery::ShadowPair pair =
    gallery::AddShadowPair(stage, image, gallery::MakeSolidMedium(image), lights);
  const vtkBoundingBox frame(-0.47, 0.62, -0.1, 0.1, -0.36, 1.06);
  pair.Look({ 0.1, -1.0, 0.5 }, frame);
  pair.Without.SetAmbientOcclusion(0.0);
  AddSurfaces(pair.Without, 1.0);
  AddSurfaces(pair.With, gallery::EDGE_GAIN);
  gallery::UseSceneShadows(pair.With, 1);
  gallery::Panel& soft = AddSoftShadows(stage, "with soft shadows", image, lights, 0.7);
  soft.ShareCamera(pair.Without);
  soft.Frame(frame);
}

void BuildOtherLight(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::SampleBonsai(240);
  const gallery::Lights lights = gallery::MakeStudioLights({ 2.1, -1.8, 2.75 }, 1.25);
  lights.back()->SetIntensity(0.5);
  gallery::Panel& panel =
    gallery::AddShadowPanel(stage, image, gallery::MakeSolidMedium(image), lights);
  AddSurfaces(panel, gallery::EDGE_GAIN);
  gallery::UseSceneShadows(panel, 1);
  panel.LookFrom({ 0.1, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.0, 0.6, -0.1, 0.1, -0.46, 1.08));
}

void BuildSoft(gallery::Stage& stage)
{
  gallery::Panel& panel = AddSoftShadows(stage, "", gallery::SampleBonsai(220),
    gallery::MakeStudioLights({ -2.4, -1.6, 3.0 }, 1.2), 0.5);
  panel.LookFrom({ 0.1, -1.0, 0.62 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-0.6, 1.0, -0.1, 0.1, -0.48, 1.2));
}

const gallery::SceneRegistration registration(
  { "bonsai-mushrooms", "2.41", "A bonsai and mushrooms: no shadows, hard shadows, soft shadows",
    "The bonsai and its pot are a volume, the mushrooms and the ground are polygons. With shadows "
    "all of them stand on the ground: the mushrooms cast shadows on it, and the tree on the pot "
    "and on the ground. Under a disk light the shadows widen with the distance from the occluder.",
    { "bonsai.vti" }, &Build });
const gallery::SceneRegistration otherRegistration(
  { "bonsai-mushrooms-light", "2.42", "A bonsai and mushrooms under another light",
    "The same objects under a light from the right. The shadow of the largest mushroom reaches the "
    "pot, and the branches of the tree are visible in its shadow.",
    { "bonsai.vti" }, &BuildOtherLight });
const gallery::SceneRegistration softRegistration(
  { "bonsai-mushrooms-soft", "2.49", "Soft shadows of a bonsai and mushrooms",
    "The bonsai is a volume, the mushrooms and the ground are polygons, the light is a disk. The "
    "shadow of the tree is blurred, because the crown is far above the ground. The shadows of the "
    "mushrooms, which stand on it, are sharper.",
    { "bonsai.vti" }, &BuildSoft });
}
