// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rings_h
#define Rings_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace gallery
{
/**
 * Six tori on a seventh, over a disk of radius 1.25 with its upper side at z = 0, as a `Color` of
 * Sample().
 */
vtkSmartPointer<vtkImageData> SampleRings();
}

#endif
