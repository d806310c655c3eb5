// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkCroppingBox_h
#define vtkCroppingBox_h

#include "vtkBoundingBox.h"

class vtkVolumeMapper;

/**
 * @class   vtkCroppingBox
 * @brief   the box that a volume of ParaView is cropped to, the same in every process and version
 *
 * It is the bounds of the data times a scale, about the origin of the coordinates, moved by an
 * origin. Later ParaViews place the box of their own volumes otherwise, and all of them crop each
 * process's piece by bounds of its own.
 */
class vtkCroppingBox
{
public:
  /// Takes the bounds of all pieces of the data. All processes that have pieces must call it
  /// together; upside-down \a bounds are no piece.
  void Gather(const double bounds[6]);

  /// Crops what \a mapper draws, if it crops at all. Where no piece is known, as in a client that
  /// draws what servers have, the bounds are those of the mapper's input.
  void Apply(vtkVolumeMapper* mapper, const double origin[3], const double scale[3]) const;

private:
  vtkBoundingBox Bounds;
};

#endif
