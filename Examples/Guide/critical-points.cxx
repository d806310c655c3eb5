// SPDX-License-Identifier: BSD-3-Clause
// The axis of a hurricane with streamlines around it, and the point at which the air rests.
#include <vtkActor.h>
#include <vtkAnalyticFlowSource.h>
#include <vtkCamera.h>
#include <vtkFlowCriticalPoints.h>
#include <vtkGlyph3D.h>
#include <vtkNew.h>
#include <vtkPointSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSphereSource.h>
#include <vtkStreamTracer.h>
#include <vtkTubeFilter.h>
#include <vtkVortexAxis.h>

int main()
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkAnalyticFlowSource> flow;
  flow->SetField(vtkAnalyticFlowSource::HURRICANE);
  flow->SetDimensions(65, 65, 65);

  vtkNew<vtkVortexAxis> axis;
  axis->SetInputConnection(flow->GetOutputPort());
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(axis->GetOutputPort());
  tube->SetRadius(0.04);
  tube->SetNumberOfSides(16);
  vtkNew<vtkPolyDataMapper> axisMapper;
  axisMapper->SetInputConnection(tube->GetOutputPort());
  axisMapper->ScalarVisibilityOff();
  vtkNew<vtkActor> axisActor;
  axisActor->SetMapper(axisMapper);
  axisActor->GetProperty()->SetColor(0.93, 0.69, 0.26);
  renderer->AddActor(axisActor);

  vtkNew<vtkFlowCriticalPoints> points;
  points->SetInputConnection(flow->GetOutputPort());
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.09);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  vtkNew<vtkGlyph3D> glyphs;
  glyphs->SetInputConnection(points->GetOutputPort());
  glyphs->SetSourceConnection(sphere->GetOutputPort());
  glyphs->ScalingOff();
  vtkNew<vtkPolyDataMapper> pointMapper;
  pointMapper->SetInputConnection(glyphs->GetOutputPort());
  pointMapper->ScalarVisibilityOff();
  vtkNew<vtkActor> pointActor;
  pointActor->SetMapper(pointMapper);
  pointActor->GetProperty()->SetColor(0.85, 0.25, 0.20);
  renderer->AddActor(pointActor);

  vtkNew<vtkPointSource> seeds;
  seeds->SetRadius(0.6);
  seeds->SetNumberOfPoints(16);
  vtkNew<vtkStreamTracer> streamlines;
  streamlines->SetInputConnection(flow->GetOutputPort());
  streamlines->SetSourceConnection(seeds->GetOutputPort());
  streamlines->SetIntegrationDirectionToBoth();
  streamlines->SetMaximumPropagation(1.5);
  vtkNew<vtkTubeFilter> thin;
  thin->SetInputConnection(streamlines->GetOutputPort());
  thin->SetRadius(0.008);
  thin->SetNumberOfSides(8);
  vtkNew<vtkPolyDataMapper> lineMapper;
  lineMapper->SetInputConnection(thin->GetOutputPort());
  lineMapper->ScalarVisibilityOff();
  vtkNew<vtkActor> lineActor;
  lineActor->SetMapper(lineMapper);
  lineActor->GetProperty()->SetColor(0.45, 0.65, 0.85);
  renderer->AddActor(lineActor);

  renderer->SetBackground(0.10, 0.12, 0.16);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.4, -1, 0.6);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(1.35);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Critical points");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
