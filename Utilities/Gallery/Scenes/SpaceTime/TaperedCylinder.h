// SPDX-License-Identifier: BSD-3-Clause
#ifndef TaperedCylinder_h
#define TaperedCylinder_h

#include "vtkColor.h"
#include "vtkSmartPointer.h"

class vtkActor;
class vtkTaperedCylinderSource;

namespace gallery
{
/**
 * The wake of a tapered cylinder at times 0 and 0.6, on 80 x 80 x 40 points.
 */
vtkSmartPointer<vtkTaperedCylinderSource> MakeCylinderWake();

/**
 * The cylinder in this wake: surface i = 0 of its grid. The wake was updated.
 */
vtkSmartPointer<vtkActor> MakeCylinder(vtkTaperedCylinderSource* wake, const vtkColor3d& colour);
}

#endif
