// SPDX-License-Identifier: BSD-3-Clause
// A scanned tooth with full multiple scattering.

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
  reader->SetFileName(image.GetPath("tooth.vti").c_str());
  vtkNew<vtkColorTransferFunction> albedo;
  albedo->AddRGBPoint(0.0, 0.999, 0.995, 0.975);
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetScatteringModeToFull();
  mapper->SetPhaseFunctionToHenyeyGreenstein();
  mapper->SetAnisotropy(0.8);
  mapper->SetScatteringAlbedo(albedo);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(115.0, 0.0);
  opacities->AddPoint(150.0, 0.4);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(albedo);
  volume->GetProperty()->SetScalarOpacity(opacities);
  renderer->AddVolume(volume);
  vtkNew<vtkLight> sun;
  sun->SetPosition(1.0, 0.6, 0.5);
  sun->SetIntensity(0.6);
  renderer->AddLight(sun);

  return image.Write(0.3, -1.5, 0.4);
}
