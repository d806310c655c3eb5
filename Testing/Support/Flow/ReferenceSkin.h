// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSkin_h
#define ReferenceSkin_h

#include "Support/Flow/ReferenceFlowGrid.h" // for vectors

#include "vtkSmartPointer.h" // for the mesh

#include <functional> // for the choice of faces

class vtkDataSet;
class vtkPolyData;

namespace reference
{

/**
 * The faces of a grid that belong to one cell only, those whose middle \a isWanted says so of, as
 * polygons with texture coordinates that are made up. The points are those of the grid, of \a type.
 */
vtkSmartPointer<vtkPolyData> MakeSkin(vtkDataSet* grid,
  const std::function<bool(const Vector& middle)>& isWanted, int type = VTK_DOUBLE);

}

#endif
