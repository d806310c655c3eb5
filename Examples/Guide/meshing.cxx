// SPDX-License-Identifier: BSD-3-Clause
// An icosahedron filled with tetrahedra of bounded shape and volume, cut open and pulled apart.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataSetMapper.h>
#include <vtkExtractGeometry.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkShrinkFilter.h>
#include <vtkTetrahedralMesher.h>

int main()
{
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToIcosahedron();
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputConnection(solid->GetOutputPort());
  mesher->SetQualityBound(1.4);
  mesher->SetMaximumVolume(0.004);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0, -1, 0);
  vtkNew<vtkExtractGeometry> half;
  half->SetInputConnection(mesher->GetOutputPort());
  half->SetImplicitFunction(plane);
  vtkNew<vtkShrinkFilter> apart;
  apart->SetInputConnection(half->GetOutputPort());
  apart->SetShrinkFactor(0.85);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(apart->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.95, 0.72, 0.35);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.15);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.13, 0.15, 0.19);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.8, -1, 0.5);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(1.4);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Meshing");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
