// SPDX-License-Identifier: BSD-3-Clause
// Vortex tubes at three time steps and between them: blue tubes fade, red ones appear, white ones
// persist.
#include <vtkAnalyticFieldSource.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTemporalColorTransferFunction.h>
#include <vtkTimeVaryingIntervalVolume.h>
#include <vtkTimeWeightedTetrahedraMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

int main()
{
  vtkNew<vtkAnalyticFieldSource> vortices;
  vortices->SetFieldToVortex();
  vortices->SetDimensions(96, 96, 96);
  vortices->SetTimeRange(0, 2);
  vortices->SetNumberOfTimeSteps(3);
  vtkNew<vtkTimeVaryingIntervalVolume> swept;
  swept->SetInputConnection(vortices->GetOutputPort());
  swept->SetInterval(0, 0.5, 2);
  vtkNew<vtkTemporalColorTransferFunction> colors;
  const double times[] = { 0, 1, 2 };
  colors->SetTimes(3, times);
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(0, 14);
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  mapper->SetInputConnection(swept->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("Time");
  mapper->SetBlendModeToAdditive();
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(extinction);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.3, 1, 0.4);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(1.75);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Temporal colors");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
