// SPDX-License-Identifier: BSD-3-Clause
#include "StabilityShapes.h"

#include "Support/Flow/ReferenceTerminationMesh.h"

#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkTerminationBox.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"
#include "vtkTerminationTube.h"

namespace stability
{

using namespace reference;

std::vector<Shape> MakeShapes()
{
  return {
    { [](double size, double midpoint)
      {
        auto plane = vtkSmartPointer<vtkTerminationPlane>::New();
        plane->SetOrigin(midpoint, 0.0, 0.0);
        plane->SetPoint1(midpoint + 2.0 * size, 0.0, 0.0);
        plane->SetPoint2(midpoint, 3.0 * size, 0.0);
        return vtkSmartPointer<vtkTerminationSurface>(plane);
      },
      6.0, 1e-12, { { 1.0, 1.0, 0.75 } }, 0.75 },
    { [](double size, double midpoint)
      {
        auto sphere = vtkSmartPointer<vtkTerminationSphere>::New();
        sphere->SetCenter(midpoint, 0.0, 0.0);
        sphere->SetRadius(size);
        return vtkSmartPointer<vtkTerminationSurface>(sphere);
      },
      4.0 * vtkMath::Pi(), 0.005, { { 0.0, 3.0, 4.0 } }, 4.0 },
    { [](double size, double midpoint)
      {
        auto box = vtkSmartPointer<vtkTerminationBox>::New();
        box->SetBounds(midpoint, midpoint + size, 0.0, 2.0 * size, 0.0, 3.0 * size);
        return vtkSmartPointer<vtkTerminationSurface>(box);
      },
      22.0, 1e-12, { { 0.5, 1.0, 5.0 } }, 2.0 },
    { [](double size, double midpoint)
      {
        auto cylinder = vtkSmartPointer<vtkTerminationCylinder>::New();
        cylinder->SetPoint1(midpoint, 0.0, 0.0);
        cylinder->SetPoint2(midpoint, 0.0, 2.0 * size);
        cylinder->SetRadius(size);
        return vtkSmartPointer<vtkTerminationSurface>(cylinder);
      },
      4.0 * vtkMath::Pi(), 0.005, { { 0.0, 3.0, 1.0 } }, 2.0 },
    { [](double size, double midpoint)
      {
        auto tube = vtkSmartPointer<vtkTerminationTube>::New();
        tube->AddPoint(midpoint, 0.0, 0.0);
        tube->AddPoint(midpoint, 2.0 * size, 0.0);
        tube->SetRadius(size);
        return vtkSmartPointer<vtkTerminationSurface>(tube);
      },
      4.0 * vtkMath::Pi(), 0.005, { { 0.0, 1.0, 3.0 } }, 2.0 },
    { [](double size, double midpoint)
      {
        TexturedMesh square;
        square.Points = { { { midpoint, 0, 0 } }, { { midpoint + size, 0, 0 } },
          { { midpoint + size, size, 0 } }, { { midpoint, size, 0 } } };
        square.Texture = { { { 0.0, 0.0 } }, { { 1.0, 0.0 } }, { { 1.0, 1.0 } }, { { 0.0, 1.0 } } };
        square.Triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
        auto mesh = vtkSmartPointer<vtkTerminationMesh>::New();
        mesh->SetMesh(square.MakeData());
        return vtkSmartPointer<vtkTerminationSurface>(mesh);
      },
      1.0, 1e-9, { { 0.25, 0.5, 2.0 } }, 2.0 },
  };
}

}
