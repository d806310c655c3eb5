#ifndef vtkSliceView_h
#define vtkSliceView_h

#include "vtkBoxCorners.h"
#include "vtkSlicePlan.h"

/**
 * @class   vtkSliceView
 * @brief   the rays of the eye to which slices must not be too flat
 *
 * They are the rays through the box's corners, or those through the picture's corners where these
 * spread less, as from close to the volume or inside it.
 */
struct vtkSliceView
{
  vtkSliceView(const vtkSlicePlan::Eye& eye, const vtkBoxCorners& corners);

  /// To the box's middle with the first kind of rays, else the eye's.
  vtkBoxCorners::Vector Direction;
  std::vector<vtkBoxCorners::Vector> Rays;
};

#endif
