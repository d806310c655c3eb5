// SPDX-License-Identifier: BSD-3-Clause
// Disks painted on the inflow, advected through the flow around a sphere. A new image needs no new
// advection.
#include <vtkActor.h>
#include <vtkAnalyticFlowSource.h>
#include <vtkCamera.h>
#include <vtkImageCanvasSource2D.h>
#include <vtkImageData.h>
#include <vtkImplicitFlowField.h>
#include <vtkImplicitFlowVolumeMapper.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSphereSource.h>
#include <vtkTerminationPlane.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

int main()
{
  vtkNew<vtkAnalyticFlowSource> flow;
  flow->SetField(vtkAnalyticFlowSource::SPHERE);
  flow->SetBounds(-1.5, 1.5, -1, 1, -1, 1);
  flow->SetDimensions(97, 65, 65);
  flow->SetRadius(0.4);
  vtkNew<vtkTerminationPlane> inflow;
  inflow->SetOrigin(-1.5, -0.7, -0.7);
  inflow->SetPoint1(-1.5, 0.7, -0.7);
  inflow->SetPoint2(-1.5, -0.7, 0.7);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputConnection(flow->GetOutputPort());
  field->AddTerminationSurface(inflow);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  field->SetSampleDimensions(121, 81, 81);
  vtkNew<vtkImageCanvasSource2D> paint;
  paint->SetScalarTypeToUnsignedChar();
  paint->SetNumberOfScalarComponents(4);
  paint->SetExtent(0, 255, 0, 255, 0, 0);
  paint->SetDrawColor(0, 0, 0, 0);
  paint->FillBox(0, 255, 0, 255);
  for (const int y : { 32, 80, 128, 176, 224 })
  {
    for (const int x : { 32, 80, 128, 176, 224 })
    {
      paint->SetDrawColor(20 + x, 110, 260 - y, 240);
      paint->FillBox(x - 8, x + 8, y - 8, y + 8);
    }
  }
  paint->Update();
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInputConnection(field->GetOutputPort());
  mapper->SetInflowTexture(inflow->GetId(), paint->GetOutput());
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.05);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.4);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> ball;
  ball->SetMapper(surface);
  ball->GetProperty()->SetColor(0.85, 0.85, 0.85);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(ball);
  renderer->AddVolume(volume);
  renderer->SetBackground(0.94, 0.94, 0.93);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(-0.7, -1, 0.55);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(1.75);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Paint");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
