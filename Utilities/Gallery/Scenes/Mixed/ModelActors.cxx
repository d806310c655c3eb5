// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Mixed/ModelActors.h"

#include "Gallery/Panel.h"
#include "Gallery/Scenes/Light/ShadowScene.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeCollection.h"

namespace gallery
{
void AddModel(Panel& panel, const interlume::Model& model, double gain, double ambient)
{
  for (const interlume::ModelPart& part : model)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(part.Shape);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    vtkProperty* property = actor->GetProperty();
    property->SetColor(part.Color[0], part.Color[1], part.Color[2]);
    // By default, \a ambient is the same as for volumes.
    property->SetAmbient(ambient);
    property->SetDiffuse(0.8 / gain);
    property->SetSpecular(part.Gloss / gain);
    property->SetSpecularPower(40.0);
    panel.Add(actor);
  }
}

void UseSceneShadows(Panel& panel, int samples)
{
  vtkNew<vtkShadowedScenePass> pass;
  pass->SetDepthMapResolution(2048);
  pass->SetNumberOfLightSamples(samples);
  panel.SetAmbientOcclusion(0.0);
  panel.GetRenderer()->SetPass(pass);
}

void UseFullResolution(Panel& panel)
{
  vtkVolumeCollection* volumes = panel.GetRenderer()->GetVolumes();
  vtkCollectionSimpleIterator cookie;
  volumes->InitTraversal(cookie);
  while (vtkVolume* volume = volumes->GetNextVolume(cookie))
  {
    GetSlicedMapper(volume)->SetImageSampleDistance(1.0);
  }
}

void AddGround(Panel& panel, const interlume::Position3& top, double radius, double gain,
  const interlume::Position3& color)
{
  const double edge = 0.02;
  AddModel(panel,
    { { interlume::MoveShape(
          interlume::Revolve({ { { 0.0, -3.0 * edge } }, { { radius - edge, -3.0 * edge } },
                               { { radius, -2.0 * edge } }, { { radius, -edge } },
                               { { radius - edge, 0.0 } }, { { 0.0, 0.0 } } },
            false),
          top),
      color, 0.05 } },
    gain);
}
}
