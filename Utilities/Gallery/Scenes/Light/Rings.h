// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rings_h
#define Rings_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace gallery
{
/**
 * Returns an image created by Sample(): six tori threaded on a seventh torus, above a disk of
 * radius 1.25 whose upper side is at z = 0.
 */
vtkSmartPointer<vtkImageData> SampleRings();
}

#endif
