// SPDX-License-Identifier: BSD-3-Clause
#ifndef Protein_h
#define Protein_h

#include "vtkSmartPointer.h"
#include "vtkSpatialObject.h"

namespace gallery
{
/**
 * Returns an object made of blobs around the maxima of the absolute value of an electron's wave
 * function in an iron protein. The object extends from -0.5 to 0.5 along each axis.
 */
vtkSmartPointer<vtkSpatialObject> MakeProtein();
}

#endif
