// SPDX-License-Identifier: BSD-3-Clause
#ifndef Protein_h
#define Protein_h

#include "vtkSmartPointer.h"
#include "vtkSpatialObject.h"

namespace gallery
{
/**
 * Returns an object that consists of blobs around the maxima of an electron's wave function in an
 * iron protein (its absolute value). The object extends from -0.5 to 0.5 along each axis.
 */
vtkSmartPointer<vtkSpatialObject> MakeProtein();
}

#endif
