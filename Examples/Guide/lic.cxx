// SPDX-License-Identifier: BSD-3-Clause
// Streaks of line integral convolution on a slice of the flow past a post.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFlowLIC.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkXMLStructuredGridReader.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkXMLStructuredGridReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "../../Data/post.vts");
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2.4, -2, 1.5);
  plane->SetPoint1(3.6, -2, 1.5);
  plane->SetPoint2(-2.4, 2, 1.5);
  plane->SetResolution(300, 200);
  vtkNew<vtkFlowLIC> lic;
  lic->SetInputConnection(plane->GetOutputPort());
  lic->SetFieldConnection(reader->GetOutputPort());
  lic->SetNoiseScale(0.07);
  lic->SetLength(0.5);
  lic->SetContrast(0.25);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0, 0.02, 0.10, 0.25);
  colors->AddRGBPoint(0.5, 0.20, 0.55, 0.75);
  colors->AddRGBPoint(1, 1.0, 0.98, 0.90);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(lic->GetOutputPort());
  mapper->SetLookupTable(colors);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.06, 0.07, 0.09);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, -0.4, 1);
  camera->SetViewUp(0, 1, 0);
  renderer->ResetCamera();
  camera->Zoom(1.75);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("LIC");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
