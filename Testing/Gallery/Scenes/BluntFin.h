#ifndef BluntFin_h
#define BluntFin_h

#include "vtkSmartPointer.h"

class vtkActor;
class vtkStructuredGrid;

namespace gallery
{
/**
 * The fin in the blunt fin data: both sides and the top. The grid holds one side of the flow; its
 * surface j = 0 lies on the fin, and the plane of symmetry is y = 0.
 */
vtkSmartPointer<vtkActor> MakeBluntFin(vtkStructuredGrid* flow);

/**
 * The plate the fin stands on, surface k = 0.
 */
vtkSmartPointer<vtkActor> MakeBluntFinPlate(vtkStructuredGrid* flow);
}

#endif
