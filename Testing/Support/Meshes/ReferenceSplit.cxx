// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceSplit.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"

#include <algorithm>

namespace reference
{

void ForEachTetrahedron(
  vtkDataSet* mesh, const std::function<void(vtkIdType cell, const SplitTetrahedron&)>& visit)
{
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetCell(c, cell);
    if (cell->GetCellDimension() < 3)
    {
      continue;
    }
    const std::vector<vtkIdType> ids(cell->GetPointIds()->begin(), cell->GetPointIds()->end());
    if (cell->GetCellType() == VTK_TETRA)
    {
      visit(c, { { { ids[0] }, { ids[1] }, { ids[2] }, { ids[3] } } });
      continue;
    }
    for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
    {
      vtkCell* face = cell->GetFace(f);
      std::vector<vtkIdType> ring(face->GetPointIds()->begin(), face->GetPointIds()->end());
      if (face->GetCellType() == VTK_PIXEL)
      {
        // The points of a pixel are not in cyclic order.
        std::swap(ring[2], ring[3]);
      }
      std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
      for (size_t i = 2; i < ring.size(); ++i)
      {
        // Face normals point outward, so the triangles are reversed.
        visit(c, { { { ring[0] }, { ring[i] }, { ring[i - 1] }, ids } });
      }
    }
  }
}

}
