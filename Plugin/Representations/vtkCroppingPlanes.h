// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkCroppingPlanes_h
#define vtkCroppingPlanes_h

class vtkVolumeMapper;

/// Crops what \a mapper draws, if it crops at all, to \a bounds times \a scale, about the origin of
/// the coordinates, moved by \a origin. Later ParaViews place the box of their own volumes
/// otherwise.
void vtkCroppingPlanes(
  vtkVolumeMapper* mapper, const double bounds[6], const double origin[3], const double scale[3]);

#endif
