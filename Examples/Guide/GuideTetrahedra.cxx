// SPDX-License-Identifier: BSD-3-Clause
// Hot gas around a spinning disk as a volume of tetrahedra whose extinction depends on temperature.

#include "GuideImage.h"

#include <vtkColorTransferFunction.h>
#include <vtkDataObject.h>
#include <vtkIntervalVolume.h>
#include <vtkPiecewiseFunction.h>
#include <vtkTimeWeightedTetrahedraMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLUnstructuredGridReader.h>

int main(int argc, char* argv[])
{
  GuideImage image(argc, argv);
  vtkRenderer* renderer = image.GetRenderer();

  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(image.GetPath("disk_out_ref.vtu").c_str());
  vtkNew<vtkIntervalVolume> gas;
  gas->SetInputConnection(reader->GetOutputPort());
  gas->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Temp");
  gas->SetInterval(0, 400.0, 900.0);
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  mapper->SetInputConnection(gas->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("Temp");
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(400.0, 0.22, 0.44, 0.72);
  colors->AddRGBPoint(650.0, 0.93, 0.69, 0.26);
  colors->AddRGBPoint(900.0, 0.79, 0.29, 0.23);
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(400.0, 0.1);
  extinction->AddPoint(900.0, 1.5);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(extinction);
  renderer->AddVolume(volume);

  return image.Write(1.0, -1.5, 0.7);
}
