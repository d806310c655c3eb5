// SPDX-License-Identifier: BSD-3-Clause
// Streamlines as stripes on a stream surface of a tornado, from afar and close up: nearer views
// have more.
#include <vtkActor.h>
#include <vtkAnalyticFlowSource.h>
#include <vtkCamera.h>
#include <vtkFlowVolume.h>
#include <vtkImplicitFlowField.h>
#include <vtkInflowMapping.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkStreamSurfaceMapper.h>
#include <vtkStreamSurfaceParameters.h>
#include <vtkStreamlineTexture.h>
#include <vtkTerminationCylinder.h>

int main()
{
  vtkNew<vtkAnalyticFlowSource> tornado;
  tornado->SetField(vtkAnalyticFlowSource::TORNADO);
  tornado->SetDimensions(65, 65, 65);
  tornado->SetBounds(-1, 1, -1, 1, -1, 1);
  tornado->SetCoreRadius(0.3);
  vtkNew<vtkTerminationCylinder> inflow;
  inflow->SetPoint1(0, 0, -1);
  inflow->SetPoint2(0, 0, 1);
  inflow->SetRadius(0.9);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputConnection(tornado->GetOutputPort());
  field->AddTerminationSurface(inflow);
  field->SetMaximumTime(5);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  field->SetSampleDimensions(121, 121, 121);
  vtkNew<vtkInflowMapping> height;
  height->SetInputConnection(field->GetOutputPort());
  height->SetFormula(vtkInflowMapping::ALL, "v");
  vtkNew<vtkFlowVolume> stream;
  stream->SetInputConnection(height->GetOutputPort());
  stream->SetStreamSurface(0, 0.13);
  stream->SetTimeRange(0.45, 3.9);
  stream->GenerateStreamSurfacesOn();
  stream->GenerateNormalsOn();
  vtkNew<vtkStreamSurfaceParameters> coordinates;
  coordinates->SetInputConnection(stream->GetOutputPort(1));
  coordinates->SetMapping(height);
  coordinates->AddTerminationSurface(inflow, 0);
  coordinates->SetLengthScale(1 / (2 * 3.14159 * 0.9));
  vtkNew<vtkStreamSurfaceMapper> mapper;
  mapper->SetInputConnection(coordinates->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->GetStreamlineTexture()->SetTexelsPerLine(64);
  mapper->GetStreamlineTexture()->SetLineColor(0.1, 0.1, 0.2);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.93, 0.69, 0.26);

  vtkNew<vtkRenderer> overview;
  overview->SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkRenderer> closeup;
  closeup->SetViewport(0.5, 0, 1, 1);
  for (vtkRenderer* renderer : { overview.Get(), closeup.Get() })
  {
    renderer->AddActor(actor);
    renderer->SetBackground(0.94, 0.94, 0.93);
    renderer->GetActiveCamera()->SetPosition(0.4, -1, 0.5);
    renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
    renderer->ResetCamera();
  }
  closeup->GetActiveCamera()->Zoom(4);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Stripes");
  window->AddRenderer(overview);
  window->AddRenderer(closeup);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
