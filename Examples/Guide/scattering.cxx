// SPDX-License-Identifier: BSD-3-Clause
// A cloud in the sun, with light scattered in it many times.
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkShadowedSliceMapper.h>
#include <vtkTurbulenceSource.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

int main()
{
  vtkNew<vtkTurbulenceSource> cloud;
  cloud->SetEnvelope(vtkTurbulenceSource::CLOUD);
  cloud->SetBounds(-1.6, 1.6, -1, 1, -0.9, 0.9);
  cloud->SetDimensions(128, 80, 72);
  cloud->SetFrequency(1.7);
  cloud->SetNumberOfOctaves(6);
  cloud->SetAmplitude(0.8);
  cloud->SetOffset(0.2);
  cloud->SetSeed(4);
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputConnection(cloud->GetOutputPort());
  mapper->SetScatteringModeToFull();
  mapper->SetPhaseFunctionToHenyeyGreenstein();
  mapper->SetAnisotropy(0.7);
  mapper->SetScatteringGridSize(32);
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0, 1, 1, 1);
  mapper->SetScatteringAlbedo(white);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0, 0);
  opacities->AddPoint(0.1, 0.8);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(white);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.06);
  vtkNew<vtkLight> sun;
  sun->SetPosition(-1, -0.1, 0.9);
  sun->SetColor(1, 0.95, 0.85);
  sun->SetIntensity(0.45);
  vtkNew<vtkLight> sky;
  sky->SetPosition(0.3, -1, 0.6);
  sky->SetColor(0.6, 0.75, 1);
  sky->SetIntensity(0.25);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->AddLight(sun);
  renderer->AddLight(sky);
  renderer->SetBackground(0.62, 0.76, 0.92);
  renderer->SetBackground2(0.20, 0.40, 0.72);
  renderer->GradientBackgroundOn();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.2, -1, 0.05);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(1.95);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Scattering");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
