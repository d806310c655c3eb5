// SPDX-License-Identifier: BSD-3-Clause
#ifndef Protein_h
#define Protein_h

#include "vtkSmartPointer.h"
#include "vtkSpatialObject.h"

namespace gallery
{
/**
 * The absolute value of an electron's wave function in an iron protein, as an object in -0.5 to
 * 0.5: lumps around its maxima.
 */
vtkSmartPointer<vtkSpatialObject> MakeProtein();
}

#endif
