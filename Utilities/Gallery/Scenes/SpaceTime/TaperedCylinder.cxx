// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/SpaceTime/TaperedCylinder.h"

#include "Gallery/Props.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkTaperedCylinderSource.h"

namespace gallery
{
vtkSmartPointer<vtkTaperedCylinderSource> MakeCylinderWake()
{
  auto wake = vtkSmartPointer<vtkTaperedCylinderSource>::New();
  wake->SetDimensions(80, 80, 40);
  wake->SetNumberOfTimeSteps(2);
  wake->SetTimeRange(0.0, 0.6);
  return wake;
}

vtkSmartPointer<vtkActor> MakeCylinder(vtkTaperedCylinderSource* wake, const vtkColor3d& colour)
{
  return MakeActor(MakeWall(wake->GetOutput(), 0, 0), colour);
}
}
