// SPDX-License-Identifier: BSD-3-Clause
// A sphere of smoke above a floor under an area light, with mutual shadows.

#include "GuideImage.h"

#include <vtkActor.h>
#include <vtkAreaLight.h>
#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkShadowedScenePass.h>
#include <vtkShadowedSliceMapper.h>
#include <vtkTurbulenceSource.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

int main(int argc, char* argv[])
{
  GuideImage image(argc, argv);
  vtkRenderer* renderer = image.GetRenderer();

  vtkNew<vtkTurbulenceSource> smoke;
  smoke->SetEnvelope(vtkTurbulenceSource::SPHERE);
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputConnection(smoke->GetOutputPort());
  vtkNew<vtkColorTransferFunction> gray;
  gray->AddRGBPoint(0.0, 0.9, 0.9, 0.9);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(1.0, 0.9);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(gray);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  renderer->AddVolume(volume);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-2.0, -2.0, -1.1);
  floor->SetPoint1(2.0, -2.0, -1.1);
  floor->SetPoint2(-2.0, 2.0, -1.1);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(floor->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(surface);
  renderer->AddActor(actor);
  vtkNew<vtkAreaLight> lamp;
  lamp->SetPosition(-2.0, 0.0, 2.5);
  lamp->SetSize(0.8, 0.8);
  renderer->AddLight(lamp);
  vtkNew<vtkShadowedScenePass> shadows;
  renderer->SetPass(shadows);

  return image.Write(0.4, -1.5, 0.8);
}
