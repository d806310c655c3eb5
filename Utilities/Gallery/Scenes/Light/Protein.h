// SPDX-License-Identifier: BSD-3-Clause
#ifndef Protein_h
#define Protein_h

#include "vtkSmartPointer.h"
#include "vtkSpatialObject.h"

namespace gallery
{
/**
 * Returns the absolute value of the wave function of an electron in an iron protein, as an object
 * between -0.5 and 0.5 along each axis: blobs around the maxima.
 */
vtkSmartPointer<vtkSpatialObject> MakeProtein();
}

#endif
