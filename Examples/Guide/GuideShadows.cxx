// SPDX-License-Identifier: BSD-3-Clause
// The electron density in a hydrogen atom: its lobes cast shadows on the ring around it.

#include "GuideImage.h"

#include <vtkColorTransferFunction.h>
#include <vtkLight.h>
#include <vtkPiecewiseFunction.h>
#include <vtkShadowedSliceMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLImageDataReader.h>

int main(int argc, char* argv[])
{
  GuideImage image(argc, argv);
  vtkRenderer* renderer = image.GetRenderer();

  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(image.GetPath("hydrogen_orbital.vti").c_str());
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.05, 0.28, 0.65, 0.58);
  colors->AddRGBPoint(0.5, 0.93, 0.69, 0.26);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.05, 0.0);
  opacities->AddPoint(0.08, 0.9);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->GetProperty()->ShadeOn();
  renderer->AddVolume(volume);
  vtkNew<vtkLight> sun;
  sun->SetPosition(0.8, -0.5, 1.2);
  sun->SetIntensity(1.6);
  renderer->AddLight(sun);

  return image.Write(1.0, -1.5, 0.7);
}
