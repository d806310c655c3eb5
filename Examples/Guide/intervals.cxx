// SPDX-License-Identifier: BSD-3-Clause
// A scanned tooth cut in half: pulp, dentine and enamel as adjacent intervals of its density, in
// one mesh.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkExtractVOI.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkIntervalVolume.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkXMLImageDataReader.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "../../Data/tooth.vti");
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputConnection(reader->GetOutputPort());
  smooth->SetStandardDeviation(1.0);
  vtkNew<vtkExtractVOI> half;
  half->SetInputConnection(smooth->GetOutputPort());
  half->SetVOI(0, 102, 44, 93, 0, 160);
  vtkNew<vtkIntervalVolume> tissues;
  tissues->SetInputConnection(half->GetOutputPort());
  tissues->SetInterval(0, 105, 150);
  tissues->SetInterval(1, 150, 205);
  tissues->SetInterval(2, 205, 255);
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputConnection(tissues->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(surface->GetOutputPort());
  normals->SetFeatureAngle(45);
  vtkNew<vtkLookupTable> colors;
  colors->SetNumberOfTableValues(3);
  colors->SetTableValue(0, 0.79, 0.29, 0.23);
  colors->SetTableValue(1, 0.93, 0.69, 0.26);
  colors->SetTableValue(2, 0.95, 0.94, 0.90);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("IntervalId");
  mapper->SetLookupTable(colors);
  mapper->SetScalarRange(0, 2);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetSpecular(0.3);
  actor->GetProperty()->SetSpecularPower(30);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.13, 0.15, 0.19);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.3, -1, 0.3);
  camera->SetViewUp(1, 0, 0.2);
  renderer->ResetCamera();
  camera->Zoom(1.7);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Intervals");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
