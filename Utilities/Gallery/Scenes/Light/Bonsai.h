// SPDX-License-Identifier: BSD-3-Clause
#ifndef Bonsai_h
#define Bonsai_h

#include "vtkSmartPointer.h"
#include "vtkSpatialObject.h"

namespace gallery
{
/**
 * The scanned bonsai as an object: about 1.05 high, on z = 0, its trunk near the z axis. The scan
 * cuts off the pot at one side, which is at +y here. Noise in the air and the sheet that the pot
 * stood on are left out.
 */
vtkSmartPointer<vtkSpatialObject> MakeBonsai();
}

#endif
