// SPDX-License-Identifier: BSD-3-Clause
// A checkered image on the inflow, advected through the volume. A new image needs no new advection.

#include "GuideImage.h"

#include <vtkAnalyticFlowSource.h>
#include <vtkImageCanvasSource2D.h>
#include <vtkImplicitFlowField.h>
#include <vtkImplicitFlowVolumeMapper.h>
#include <vtkTerminationPlane.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

int main(int argc, char* argv[])
{
  GuideImage image(argc, argv);
  vtkRenderer* renderer = image.GetRenderer();

  vtkNew<vtkAnalyticFlowSource> flow;
  flow->SetField(vtkAnalyticFlowSource::SADDLE);
  flow->SetBounds(-1.0, 1.0, -1.0, 1.0, 0.0, 1.0);
  vtkNew<vtkTerminationPlane> inflow;
  inflow->SetOrigin(-0.6, -0.6, 1.0);
  inflow->SetPoint1(0.6, -0.6, 1.0);
  inflow->SetPoint2(-0.6, 0.6, 1.0);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputConnection(flow->GetOutputPort());
  field->AddTerminationSurface(inflow);
  vtkNew<vtkImageCanvasSource2D> paint;
  paint->SetScalarTypeToUnsignedChar();
  paint->SetNumberOfScalarComponents(4);
  paint->SetExtent(0, 63, 0, 63, 0, 0);
  paint->SetDrawColor(0.0, 0.0, 0.0, 0.0);
  paint->FillBox(0, 63, 0, 63);
  paint->SetDrawColor(200.0, 74.0, 59.0, 200.0);
  paint->FillBox(8, 28, 8, 55);
  paint->SetDrawColor(56.0, 112.0, 184.0, 200.0);
  paint->FillBox(36, 56, 8, 55);
  paint->Update();
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInputConnection(field->GetOutputPort());
  mapper->SetInflowTexture(inflow->GetId(), paint->GetOutput());
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.3);
  renderer->AddVolume(volume);

  return image.Write(1.0, -1.5, 0.5);
}
