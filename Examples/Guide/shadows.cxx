// SPDX-License-Identifier: BSD-3-Clause
// A scanned bonsai that casts shadows on itself.
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkExtractVOI.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkShadowedSliceMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLImageDataReader.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "../../Data/bonsai.vti");
  vtkNew<vtkExtractVOI> tree;
  tree->SetInputConnection(reader->GetOutputPort());
  tree->SetVOI(30, 226, 10, 236, 62, 255);
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
  vtkNew<vtkLight> sun;
  sun->SetPosition(-1.0, 1.4, 0.4);
  sun->SetIntensity(2.4);
  vtkNew<vtkLight> sky;
  sky->SetPosition(0.6, 0.5, -1.0);
  sky->SetIntensity(0.5);
  sky->SetShadowAttenuation(0);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->AddLight(sun);
  renderer->AddLight(sky);
  renderer->SetBackground(0.92, 0.92, 0.90);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.2, 0.3, -1);
  camera->SetViewUp(0, 1, 0);
  renderer->ResetCamera();
  camera->Zoom(1.5);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Shadows");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
