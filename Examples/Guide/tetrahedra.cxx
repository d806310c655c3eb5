// SPDX-License-Identifier: BSD-3-Clause
// Hot gas around a spinning disk, as a volume of tetrahedra.
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataObject.h>
#include <vtkIntervalVolume.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTimeWeightedTetrahedraMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLUnstructuredGridReader.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "../../Data/disk_out_ref.vtu");
  vtkNew<vtkIntervalVolume> gas;
  gas->SetInputConnection(reader->GetOutputPort());
  gas->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Temp");
  gas->SetInterval(0, 400, 950);
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  mapper->SetInputConnection(gas->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("Temp");
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(400, 0.15, 0.35, 0.80);
  colors->AddRGBPoint(550, 0.30, 0.75, 0.75);
  colors->AddRGBPoint(700, 1.00, 0.80, 0.30);
  colors->AddRGBPoint(880, 1.00, 0.30, 0.10);
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(400, 0.10);
  extinction->AddPoint(550, 0.15);
  extinction->AddPoint(700, 0.60);
  extinction->AddPoint(880, 4.00);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(extinction);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetBackground(0.06, 0.07, 0.10);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.4, -1, 0.6);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  camera->Zoom(1.4);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(900, 600);
  window->SetWindowName("Tetrahedra");
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
}
