// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rings_h
#define Rings_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace gallery
{
/**
 * Returns six tori threaded on a seventh, above a disk of radius 1.25 whose upper side is at z = 0,
 * as a `Color` image of Sample().
 */
vtkSmartPointer<vtkImageData> SampleRings();
}

#endif
