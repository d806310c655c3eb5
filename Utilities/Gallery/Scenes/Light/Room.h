// SPDX-License-Identifier: BSD-3-Clause
#ifndef Room_h
#define Room_h

#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkSpatialObject.h"
#include "vtkVector.h"

namespace gallery
{
/**
 * Returns a room with a floor, a wall at +y and a wall at -x; the other sides are open. The
 * interior is \a inside.
 */
vtkSmartPointer<vtkSpatialObject> MakeRoom(
  const vtkBoundingBox& inside = vtkBoundingBox(-1.0, 1.0, -1.0, 1.0, 0.0, 1.3));

/// Returns a round cloud of smoke.
vtkSmartPointer<vtkSpatialObject> MakePuff(const vtkVector3d& center);

/**
 * Returns an image created by Sample(), with \a resolution points along the longest side: the room
 * with a robot, rings that lean on the wall, and a cloud of smoke. Densities below a quarter of the
 * maximum are smoke.
 */
vtkSmartPointer<vtkImageData> SampleFurnishedRoom(int resolution);
}

#endif
