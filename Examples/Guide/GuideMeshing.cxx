// SPDX-License-Identifier: BSD-3-Clause
// An icosahedron filled with tetrahedra of bounded shape and volume, cut open.

#include "GuideImage.h"

#include <vtkActor.h>
#include <vtkDataSetMapper.h>
#include <vtkExtractGeometry.h>
#include <vtkPlane.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkProperty.h>
#include <vtkTetrahedralMesher.h>

int main(int argc, char* argv[])
{
  GuideImage image(argc, argv);
  vtkRenderer* renderer = image.GetRenderer();

  vtkNew<vtkPlatonicSolidSource> surface;
  surface->SetSolidTypeToIcosahedron();
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputConnection(surface->GetOutputPort());
  mesher->SetQualityBound(1.4);
  mesher->SetMaximumVolume(0.002);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, -1.0, 0.0);
  vtkNew<vtkExtractGeometry> half;
  half->SetInputConnection(mesher->GetOutputPort());
  half->SetImplicitFunction(plane);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(half->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.56, 0.76, 0.72);
  actor->GetProperty()->EdgeVisibilityOn();
  renderer->AddActor(actor);

  return image.Write(0.4, -1.5, 0.5);
}
