// SPDX-License-Identifier: BSD-3-Clause
// A stream volume around a hot disk: the region whose streamlines start between two values of an
// inflow mapping.

#include "GuideImage.h"

#include <vtkColorTransferFunction.h>
#include <vtkDataObject.h>
#include <vtkFlowVolume.h>
#include <vtkImplicitFlowField.h>
#include <vtkInflowMapping.h>
#include <vtkPiecewiseFunction.h>
#include <vtkTerminationPlane.h>
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
  vtkNew<vtkTerminationPlane> inflow;
  inflow->SetOrigin(-5.0, -5.0, 10.0);
  inflow->SetPoint1(5.0, -5.0, 10.0);
  inflow->SetPoint2(-5.0, 5.0, 10.0);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputConnection(reader->GetOutputPort());
  field->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
  field->AddTerminationSurface(inflow);
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(field->GetOutputPort());
  mapping->SetFormula(vtkInflowMapping::ALL, "sqrt((u - 0.5)^2 + (v - 0.5)^2)");
  vtkNew<vtkFlowVolume> stream;
  stream->SetInputConnection(mapping->GetOutputPort());
  stream->SetInterval(0, 0.05, 0.2);
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  mapper->SetInputConnection(stream->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray("Temp");
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(300.0, 0.22, 0.44, 0.72);
  colors->AddRGBPoint(900.0, 0.79, 0.29, 0.23);
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(300.0, 1.0);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(extinction);
  renderer->AddVolume(volume);

  return image.Write(1.0, -1.5, 0.7);
}
