// SPDX-License-Identifier: BSD-3-Clause
// A rounded cube with three drilled holes, computed from formulas, and drawn with its shadows.
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkConstructiveVolume.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkShadowedSliceMapper.h>
#include <vtkSpatialOperation.h>
#include <vtkSpatialPrimitive.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

int main()
{
  vtkNew<vtkSpatialPrimitive> box;
  box->SetEdgeWidth(0.04);
  box->SetShapeToBox();
  box->SetLengths(1.5, 1.5, 1.5);
  vtkNew<vtkSpatialPrimitive> ball;
  ball->SetEdgeWidth(0.04);
  ball->SetShapeToSphere();
  ball->SetRadius(1.0);
  vtkNew<vtkSpatialPrimitive> hole;
  hole->SetEdgeWidth(0.04);
  hole->SetShapeToSphere();
  hole->SetRadius(0.86);
  vtkNew<vtkSpatialOperation> shell;
  shell->SetOperationToIntersection();
  shell->AddOperand(box);
  shell->AddOperand(ball);
  vtkNew<vtkSpatialOperation> cage;
  cage->SetOperationToDifference();
  cage->AddOperand(shell);
  cage->AddOperand(hole);
  vtkNew<vtkSpatialPrimitive> core;
  core->SetEdgeWidth(0.04);
  core->SetShapeToTorus();
  core->SetRadius(0.36);
  core->SetTubeRadius(0.16);
  vtkNew<vtkSpatialOperation> model;
  model->SetOperationToUnion();
  model->AddOperand(cage);
  model->AddOperand(core);
  vtkNew<vtkConstructiveVolume> image;
  image->SetRoot(model);
  image->SetBounds(-0.9, 0.9, -0.9, 0.9, -0.9, 0.9);
  image->SetDimensions(128, 128, 128);
  image->SetNumberOfSubsamples(3);
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputConnection(image->GetOutputPort());
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0, 0.95, 0.62, 0.25);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0, 0);
  opacities->AddPoint(1, 0.9);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.02);
  volume->GetProperty()->ShadeOn();
  volume->GetProperty()->SetAmbient(0.3);
  vtkNew<vtkLight> sun;
  sun->SetPosition(0.2, -1.0, 1.2);
  sun->SetIntensity(2.0);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->AddLight(sun);
  renderer->SetBackground(0.12, 0.14, 0.18);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.7, -1, 0.6);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(1.5);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Sources");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
