// SPDX-License-Identifier: BSD-3-Clause
// A sphere with a hole, defined by formulas, with its shadow.

#include "GuideImage.h"

#include <vtkColorTransferFunction.h>
#include <vtkConstructiveVolume.h>
#include <vtkLight.h>
#include <vtkPiecewiseFunction.h>
#include <vtkShadowedSliceMapper.h>
#include <vtkSpatialOperation.h>
#include <vtkSpatialPrimitive.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

int main(int argc, char* argv[])
{
  GuideImage rendered(argc, argv);
  vtkRenderer* renderer = rendered.GetRenderer();

  vtkNew<vtkSpatialPrimitive> ball;
  ball->SetShapeToSphere();
  ball->SetRadius(0.9);
  vtkNew<vtkSpatialPrimitive> hole;
  hole->SetShapeToCylinder();
  hole->SetRadius(0.4);
  hole->SetHeight(3.0);
  vtkNew<vtkSpatialOperation> ring;
  ring->SetOperationToDifference();
  ring->AddOperand(ball);
  ring->AddOperand(hole);
  vtkNew<vtkConstructiveVolume> image;
  image->SetRoot(ring);
  image->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  image->SetDimensions(96, 96, 96);
  image->SetNumberOfSubsamples(4);
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputConnection(image->GetOutputPort());
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.93, 0.69, 0.26);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(1.0, 0.9);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.03);
  volume->GetProperty()->ShadeOn();
  renderer->AddVolume(volume);
  vtkNew<vtkLight> sun;
  sun->SetPosition(1.0, -0.4, 1.6);
  sun->SetIntensity(1.8);
  renderer->AddLight(sun);

  return rendered.Write(0.6, -1.0, 1.2);
}
