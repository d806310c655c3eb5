// SPDX-License-Identifier: BSD-3-Clause
// Gas that flows onto a hot disk: two nested stream volumes, colored by the time since the gas
// entered, cut in half.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataObject.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkFlowVolume.h>
#include <vtkImplicitFlowField.h>
#include <vtkInflowMapping.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTerminationPlane.h>
#include <vtkXMLUnstructuredGridReader.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "../../Data/disk_out_ref.vtu");
  vtkNew<vtkTerminationPlane> inlet;
  inlet->SetOrigin(-5.75, -5.75, 10);
  inlet->SetPoint1(5.75, -5.75, 10);
  inlet->SetPoint2(-5.75, 5.75, 10);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputConnection(reader->GetOutputPort());
  field->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
  field->AddTerminationSurface(inlet);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  field->SetSampleDimensions(65, 33, 65);
  field->SetSampleBounds(-5.7, 5.7, 0, 5.7, 0.1, 10);
  field->SetMaximumTime(20);
  vtkNew<vtkInflowMapping> radius;
  radius->SetInputConnection(field->GetOutputPort());
  radius->SetFormula(vtkInflowMapping::ALL, "2 * sqrt((u - 0.5)^2 + (v - 0.5)^2)");
  vtkNew<vtkFlowVolume> stream;
  stream->SetInputConnection(radius->GetOutputPort());
  stream->SetInterval(0, 0.3, 0.42);
  stream->SetInterval(1, 0.6, 0.72);
  stream->SetTimeRange(0, 5.5);
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputConnection(stream->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(surface->GetOutputPort());
  normals->SetFeatureAngle(45);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0, 0.18, 0.35, 0.75);
  colors->AddRGBPoint(0.7, 0.35, 0.70, 0.75);
  colors->AddRGBPoint(1.4, 0.95, 0.75, 0.35);
  colors->AddRGBPoint(2.2, 0.85, 0.30, 0.20);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("AdvectionTime");
  mapper->SetLookupTable(colors);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.93, 0.93, 0.92);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.3, -1, 0.3);
  camera->SetViewUp(1, 0, 0);
  renderer->ResetCamera();
  camera->Zoom(1.3);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Flow");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
