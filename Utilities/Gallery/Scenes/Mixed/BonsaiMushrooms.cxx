// SPDX-License-Identifier: BSD-3-Clause
// Polygonal mushrooms under a scanned bonsai.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Bonsai.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"

#include "vtkShadowedSliceMapper.h"

namespace
{
using namespace interlume;

/// Number of samples of area lights, for both the tree and the mushrooms.
constexpr int SAMPLES = 32;

/// Color of the ground.
constexpr Position3 GROUND{ { 0.70, 0.66, 0.56 } };

Model MakeMushrooms()
{
  Model all = Move(MakeMushroom(0.36, 0.16, 0.08), { { 0.3, -0.36, 0.0 } }, { { 0.0, 0.0, 20.0 } });
  Append(
    all, Move(MakeMushroom(0.22, 0.11, 0.15), { { 0.44, -0.58, 0.0 } }, { { 0.0, 0.0, -60.0 } }));
  return Append(
    all, Move(MakeMushroom(0.28, 0.13, 0.12), { { -0.29, -0.46, 0.0 } }, { { 0.0, 0.0, 200.0 } }));
}

/// Returns the tree on a floor that is part of the volume.
vtkSmartPointer<vtkImageData> SampleTreeOnFloor()
{
  return gallery::Sample(
    gallery::Unite({ gallery::MakeBonsai(), gallery::MakeFloor({ 0.66, 0.64, 0.52 }) }),
    vtkBoundingBox(-1.3, 1.3, -0.85, 0.95, -0.04, 1.08), 280, 0.5);
}

/// Returns the tree without a floor, for use with a polygonal ground. Under an area light, a floor
/// in the volume would show steps between light samples and between voxels.
vtkSmartPointer<vtkImageData> SampleTree(int resolution)
{
  return gallery::Sample(
    gallery::MakeBonsai(), vtkBoundingBox(-0.62, 0.62, -0.62, 0.62, -0.03, 1.1), resolution, 0.5);
}

/// Adds the mushrooms to a panel that shows the bonsai, with mutual shadows.
void AddMushrooms(gallery::Panel& panel)
{
  gallery::AddModel(panel, MakeMushrooms(), gallery::EDGE_GAIN);
  gallery::UseSceneShadows(panel, SAMPLES);
  gallery::UseFullResolution(panel);
}

/// Adds a panel of \a image lit by \a lights, with each shadow-casting light replaced by a disk
/// light of \a diameter.
gallery::Panel& AddSoftPanel(gallery::Stage& stage, const std::string& caption, vtkImageData* image,
  const gallery::Lights& lights, double diameter)
{
  gallery::Panel& panel = stage.AddPanel(caption);
  vtkSmartPointer<vtkVolume> volume =
    gallery::MakeSlicedVolume(image, gallery::MakeSolidMedium(image));
  gallery::GetSlicedMapper(volume)->SetLightBufferSize(224);
  gallery::GetSlicedMapper(volume)->SetNumberOfLightSamples(SAMPLES);
  panel.Add(volume);
  panel.SetLights(gallery::MakeDiskLights(lights, diameter));
  AddMushrooms(panel);
  return panel;
}

void Build(gallery::Stage& stage)
{
  const Position3 ground{ { 0.0, -0.1, 0.0 } };
  vtkSmartPointer<vtkImageData> image = SampleTree(170);
  const gallery::Lights lights = gallery::MakeStudioLights({ -1.8, -1.4, 3.2 }, 0.85);
  gallery::ShadowPair pair =
    gallery::AddShadowPair(stage, image, gallery::MakeSolidMedium(image), lights);
  pair.Without.SetAmbientOcclusion(0.0);
  gallery::AddModel(pair.Without, MakeMushrooms());
  gallery::AddGround(pair.Without, ground, 1.4, 1.0, GROUND);
  gallery::UseFullResolution(pair.Without);
  AddMushrooms(pair.With);
  gallery::AddGround(pair.With, ground, 1.4, gallery::EDGE_GAIN, GROUND);
  pair.UseBackdrop({ 0.86, 0.88, 0.82 }, { 0.48, 0.58, 0.52 });
  const vtkBoundingBox frame(-0.52, 0.6, -0.1, 0.1, -0.4, 1.06);
  pair.Look({ 0.1, -1.0, 0.5 }, frame);
  gallery::Panel& soft = AddSoftPanel(stage, "with soft shadows", image, lights, 0.7);
  gallery::AddGround(soft, ground, 1.4, gallery::EDGE_GAIN, GROUND);
  gallery::UseBackdrop(soft, { 0.86, 0.88, 0.82 }, { 0.48, 0.58, 0.52 });
  soft.ShareCamera(pair.Without);
  soft.Frame(frame);
}

void BuildOtherLight(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleTreeOnFloor();
  gallery::Panel& panel = gallery::AddShadowPanel(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ 2.2, -1.7, 2.2 }, 1.15));
  AddMushrooms(panel);
  gallery::UseBackdrop(panel, { 0.88, 0.84, 0.74 }, { 0.50, 0.44, 0.44 });
  panel.LookFrom({ 0.1, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-0.95, 0.85, -0.1, 0.1, -0.36, 1.12));
}

void BuildSoft(gallery::Stage& stage)
{
  gallery::Panel& panel = AddSoftPanel(
    stage, "", SampleTree(130), gallery::MakeStudioLights({ 2.0, 0.9, 2.5 }, 1.15), 0.5);
  gallery::AddGround(panel, { { -0.14, -0.1, 0.0 } }, 2.0, gallery::EDGE_GAIN, GROUND);
  gallery::UseBackdrop(panel, { 0.80, 0.84, 0.86 }, { 0.38, 0.46, 0.54 });
  panel.LookFrom({ 0.1, -1.0, 0.62 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.1, 0.75, -0.1, 0.1, -0.48, 1.16));
}

const gallery::SceneRegistration registration(
  { "bonsai-mushrooms", "2.41", "A bonsai and mushrooms: no shadows, hard shadows, soft shadows",
    "The bonsai and its pot are a volume, the mushrooms and the ground are polygons. With "
    "shadows all of them stand on the ground. The mushrooms cast shadows on the ground and on the "
    "pot, and the tree on the pot and the ground. Under a disk light the shadows widen with the "
    "distance "
    "from the occluder.",
    { "bonsai.vti" }, &Build });
const gallery::SceneRegistration otherRegistration(
  { "bonsai-mushrooms-light", "2.42", "A bonsai and mushrooms under another light",
    "The same objects, on a floor that is part of the volume, under a low light from the right. "
    "The shadows are long, and those of the mushrooms reach the pot.",
    { "bonsai.vti" }, &BuildOtherLight });
const gallery::SceneRegistration softRegistration(
  { "bonsai-mushrooms-soft", "2.49", "Soft shadows of a bonsai and mushrooms",
    "The bonsai is a volume, the mushrooms and the ground are polygons, the light is a disk. The "
    "shadow of the tree is blurred, because the crown is far above the ground. The shadows of the "
    "mushrooms, which stand on it, are sharper.",
    { "bonsai.vti" }, &BuildSoft });
}
