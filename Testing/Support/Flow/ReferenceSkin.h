// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSkin_h
#define ReferenceSkin_h

#include "Support/Flow/ReferenceFlowGrid.h" // for vectors

#include "vtkSmartPointer.h" // for the mesh

#include <functional> // for the selection of faces

class vtkDataSet;
class vtkPolyData;

namespace reference
{

/**
 * Returns the boundary faces of a grid as polygons, but only those whose center satisfies \a
 * isWanted. The output has all points of the grid, with coordinates of the data type \a type. All
 * points have the texture coordinates (0.25, 0.75).
 */
vtkSmartPointer<vtkPolyData> MakeSkin(vtkDataSet* grid,
  const std::function<bool(const Vector& center)>& isWanted, int type = VTK_DOUBLE);

}

#endif
