// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MediumLoop_h
#define interlume_MediumLoop_h

#include "Scattering/SanitizedMedium.h"

#include "vtkSMPTools.h"

#include <cstddef>

#include <glm/vec3.hpp>

namespace interlume
{

/// Calls \a visit in parallel with the indices of each cell whose extinction is above 0: (i, j, k)
/// and the linear index.
template <typename Visitor>
void ForEachOccupiedCell(const SanitizedMedium& medium, const Visitor& visit)
{
  const ScatteringMedium& box = medium.Box;
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
            if (medium.Extinction[at] > 0.0f)
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
