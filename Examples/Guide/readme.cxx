// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkShadowedSliceMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLImageDataReader.h>

int main()
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName("Data/bonsai.vti");
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetCroppingRegionPlanes(30, 226, 12, 236, 62, 255);
  mapper->CroppingOn();
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddSegment(34, 0.0, 120, 1.0);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBSegment(40, 0.4, 0.6, 0.2, 100, 0.7, 0.5, 0.3);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->GetProperty()->SetColor(colors);
  vtkNew<vtkLight> sun;
  sun->SetPosition(1.0, 1.6, -0.8);
  sun->SetIntensity(1.8);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.93, 0.93, 0.94);
  renderer->AddVolume(volume);
  renderer->AddLight(sun);
  renderer->GetActiveCamera()->SetPosition(0.1, 0.4, -1);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.9);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
  return 0;
}
