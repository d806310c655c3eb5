#ifndef vtkSliceEye_h
#define vtkSliceEye_h

#include "vtkSlicePlan.h"

class vtkRenderer;
class vtkUnitSpace;

/**
 * @class   vtkSliceEye
 * @brief   a renderer's camera in unit space
 */
class vtkSliceEye
{
public:
  static vtkSlicePlan::Eye Get(vtkRenderer* renderer, const vtkUnitSpace& space);
};

#endif
