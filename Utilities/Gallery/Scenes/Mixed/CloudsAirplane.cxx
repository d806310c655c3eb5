// SPDX-License-Identifier: BSD-3-Clause
// A polygonal airplane above clouds.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/CloudScene.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"
#include "Support/Inputs/Clouds.h"

#include "vtkSpatialTurbulence.h"

namespace
{
/// Returns a layer of clouds so flat that the shadow on it keeps its shape.
vtkSmartPointer<vtkSpatialObject> MakeLayer()
{
  vtkSmartPointer<vtkSpatialPrimitive> slab =
    gallery::MakeBox({ -9.0, -9.0, -1.0 }, { 9.0, 9.0, 0.2 }, { 1.0, 1.0, 1.0 });
  slab->SetEdgeWidth(0.1);
  auto layer = vtkSmartPointer<vtkSpatialTurbulence>::New();
  layer->SetOperand(slab);
  layer->SetSum(vtkTurbulenceSource::FRACTAL_SUM);
  layer->SetNumberOfOctaves(5);
  layer->SetFrequency(2.3);
  layer->SetAmplitude(0.1);
  return layer;
}

void Build(gallery::Stage& stage)
{
  const std::vector<interlume::Cumulus> heaps = {
    { { { -1.25, 0.95, 0.0 } }, 0.75, 0.8, 0.62, 11, 4 },
    { { { 0.45, 1.2, 0.0 } }, 0.85, 0.7, 0.5, 11, 7 },
    { { { 1.65, 0.55, 0.0 } }, 0.6, 0.8, 0.46, 9, 11 },
    { { { -1.25, -0.5, 0.0 } }, 0.5, 0.8, 0.3, 9, 13 },
  };
  gallery::Panel& panel = stage.AddPanel("", { 0.12, -1.0, 0.62 });
  // In thinner clouds, scattered light would blur the shadow. The anisotropy is lower than that of
  // real droplets, so that the clouds are white up to their edges.
  vtkSmartPointer<vtkVolume> volume =
    gallery::MakeCloudVolume(gallery::Unite({ interlume::MakeClouds(heaps), MakeLayer() }),
      { { -2.0, 2.2, -1.2, 1.9, -0.1, 0.8 } }, 340, gallery::Scattering::FULL, 70.0);
  gallery::Scatter(volume, gallery::Scattering::FULL, 0.2, 128);
  panel.Add(volume);
  interlume::Model airplane = interlume::MakeAirplane();
  airplane.front().Color = airplane.back().Color = { { 0.80, 0.16, 0.10 } };
  gallery::AddModel(
    panel, interlume::Move(airplane, { { -0.38, 0.1, 0.6 } }, { { 14.0, -4.0, -24.0 } }), 0.5, 0.5);
  gallery::UseSceneShadows(panel);
  // The skylight comes from the camera, so that only the shadow of sunlight is visible.
  gallery::UseSky(panel, { -0.55, 0.3, 1.0 }, { 0.12, -1.0, 0.62 }, 0.23, 0.11);
  panel.SetBackground({ 0.10, 0.22, 0.40 }, { 0.36, 0.54, 0.74 });
  panel.Frame(vtkBoundingBox(-1.05, 1.05, -0.1, 0.1, -0.1, 0.98));
}

const gallery::SceneRegistration registration(
  { "clouds-airplane", "2.54", "An airplane above clouds",
    "The airplane consists of polygons, the clouds are a volume with full multiple scattering. The "
    "airplane casts its shadow on the clouds.",
    {}, &Build });
}
