// SPDX-License-Identifier: BSD-3-Clause
// The region between two values of an electron density, as the surface of its tetrahedra.

#include "GuideImage.h"

#include <vtkActor.h>
#include <vtkDataObject.h>
#include <vtkDataSetMapper.h>
#include <vtkIntervalVolume.h>
#include <vtkProperty.h>
#include <vtkXMLImageDataReader.h>

int main(int argc, char* argv[])
{
  GuideImage image(argc, argv);
  vtkRenderer* renderer = image.GetRenderer();

  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(image.GetPath("hydrogen_orbital.vti").c_str());
  vtkNew<vtkIntervalVolume> region;
  region->SetInputConnection(reader->GetOutputPort());
  region->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "probability_density");
  region->SetInterval(0, 0.06, 0.4);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(region->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.28, 0.65, 0.58);
  renderer->AddActor(actor);

  return image.Write(1.0, -1.5, 0.7);
}
