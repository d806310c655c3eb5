// SPDX-License-Identifier: BSD-3-Clause
#ifndef BluntFin_h
#define BluntFin_h

#include "vtkSmartPointer.h"

class vtkActor;
class vtkStructuredGrid;

namespace gallery
{
/**
 * The flow past a blunt fin, both halves. The data hold one, whose surface i = 0 is the plane of
 * symmetry y = 0 upstream of the fin; the other is its mirror image, and both share the points of
 * that surface. Point arrays of one component are kept, and `Speed` is the length of the velocity.
 */
vtkSmartPointer<vtkStructuredGrid> ReadBluntFin();

/**
 * The fin in the flow: both sides, surface j = 0, and the top.
 */
vtkSmartPointer<vtkActor> MakeBluntFin(vtkStructuredGrid* flow);

/**
 * The plate the fin stands on, surface k = 0.
 */
vtkSmartPointer<vtkActor> MakeBluntFinPlate(vtkStructuredGrid* flow);
}

#endif
