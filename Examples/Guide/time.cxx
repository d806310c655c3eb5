// SPDX-License-Identifier: BSD-3-Clause
// Vortex tubes over all times between two steps: blue at the first, red at the second.
#include <vtkAnalyticFieldSource.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTimeVaryingIntervalVolume.h>
#include <vtkTimeWeightedTetrahedraMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

int main()
{
  vtkNew<vtkAnalyticFieldSource> vortices;
  vortices->SetFieldToVortex();
  vortices->SetDimensions(96, 96, 96);
  vortices->SetTimeRange(1.2, 2.0);
  vortices->SetNumberOfTimeSteps(2);
  vtkNew<vtkTimeVaryingIntervalVolume> swept;
  swept->SetInputConnection(vortices->GetOutputPort());
  swept->SetInterval(0, 0.5, 2);
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  mapper->SetInputConnection(swept->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("Time");
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(1.2, 0.10, 0.35, 0.95);
  colors->AddRGBPoint(1.6, 0.75, 0.60, 0.65);
  colors->AddRGBPoint(2.0, 0.95, 0.25, 0.10);
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(1.2, 60);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(extinction);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetBackground(0.04, 0.05, 0.07);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.3, -1, 0.25);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(1.75);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Time");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
