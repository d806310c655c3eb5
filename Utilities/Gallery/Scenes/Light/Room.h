// SPDX-License-Identifier: BSD-3-Clause
#ifndef Room_h
#define Room_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkSpatialObject.h"

namespace gallery
{
/**
 * A floor, a wall at +y and one at -x, open to the other sides: inside -1 to 1, -1 to 1, 0 to 1.3.
 */
vtkSmartPointer<vtkSpatialObject> MakeRoom();

/**
 * The room with a robot, rings that lean on the wall and a cloud of smoke, with \a resolution
 * points along the longest side; smoke is matter below a quarter of full density.
 */
vtkSmartPointer<vtkImageData> SampleFurnishedRoom(int resolution);
}

#endif
