// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MatterLoop_h
#define interlume_MatterLoop_h

#include "Scattering/MatterCells.h"

#include "vtkSMPTools.h"

#include <cstddef>

#include <glm/vec3.hpp>

namespace interlume
{

/// Calls \a visit with the place and the index of each cell that has matter; layers of cells are
/// shared out to threads.
template <typename Visitor>
void ForCellsOfMatter(const MatterCells& matter, const Visitor& visit)
{
  const ScatteringMedium& box = matter.Box;
  vtkSMPTools::For(0, box.Cells.z,
    [&](vtkIdType begin, vtkIdType end)
    {
      glm::ivec3 cell(0);
      for (cell.z = static_cast<int>(begin); cell.z < end; ++cell.z)
      {
        for (cell.y = 0; cell.y < box.Cells.y; ++cell.y)
        {
          for (cell.x = 0; cell.x < box.Cells.x; ++cell.x)
          {
            const std::size_t at = box.GetIndex(cell);
            if (matter.Extinction[at] > 0.0f)
            {
              visit(cell, at);
            }
          }
        }
      }
    });
}

}

#endif
