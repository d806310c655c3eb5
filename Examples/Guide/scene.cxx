// SPDX-License-Identifier: BSD-3-Clause
// A scanned bonsai, a volume, on polygons. All of them cast shadows on each other under an area
// light.
#include <vtkActor.h>
#include <vtkAreaLight.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkExtractVOI.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkShadowedScenePass.h>
#include <vtkShadowedSliceMapper.h>
#include <vtkSphereSource.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLImageDataReader.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "../../Data/bonsai.vti");
  vtkNew<vtkExtractVOI> tree;
  tree->SetInputConnection(reader->GetOutputPort());
  tree->SetVOI(34, 222, 10, 236, 62, 255);
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputConnection(tree->GetOutputPort());
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(40, 0.30, 0.52, 0.16);
  colors->AddRGBPoint(65, 0.52, 0.68, 0.26);
  colors->AddRGBPoint(85, 0.55, 0.40, 0.24);
  colors->AddRGBPoint(170, 0.55, 0.36, 0.22);
  colors->AddRGBPoint(200, 0.80, 0.45, 0.30);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(34, 0);
  opacities->AddPoint(60, 0.5);
  opacities->AddPoint(130, 0.9);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->GetProperty()->ShadeOn();
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-300, 10, -300);
  ground->SetPoint1(600, 10, -300);
  ground->SetPoint2(-300, 10, 600);
  vtkNew<vtkPolyDataMapper> plate;
  plate->SetInputConnection(ground->GetOutputPort());
  vtkNew<vtkActor> floor;
  floor->SetMapper(plate);
  floor->GetProperty()->SetColor(0.50, 0.48, 0.46);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(20, 36, 60);
  sphere->SetRadius(26);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> ball;
  ball->SetMapper(surface);
  ball->GetProperty()->SetColor(0.8, 0.2, 0.15);
  vtkNew<vtkAreaLight> lamp;
  lamp->SetPosition(-150, 450, -50);
  lamp->SetFocalPoint(128, 60, 128);
  lamp->SetSize(120, 120);
  lamp->SetIntensity(1.4);
  vtkNew<vtkLight> sky;
  sky->SetPosition(0, 300, -400);
  sky->SetIntensity(0.4);
  sky->SetShadowAttenuation(0);
  vtkNew<vtkShadowedScenePass> shadows;

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->AddActor(floor);
  renderer->AddActor(ball);
  renderer->AddLight(lamp);
  renderer->AddLight(sky);
  renderer->SetPass(shadows);
  renderer->SetBackground(0.75, 0.78, 0.82);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(80, 300, -390);
  camera->SetFocalPoint(95, 112, 128);
  camera->SetViewUp(0, 1, 0);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Scene");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
