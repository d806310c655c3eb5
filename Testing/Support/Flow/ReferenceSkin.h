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
 * Returns the boundary faces of a grid whose centers satisfy \a isWanted, as polygons. All points
 * have the texture coordinates (0.25, 0.75). The output has all points of the grid. \a type is the
 * data type of their coordinates.
 */
vtkSmartPointer<vtkPolyData> MakeSkin(vtkDataSet* grid,
  const std::function<bool(const Vector& center)>& isWanted, int type = VTK_DOUBLE);

}

#endif
