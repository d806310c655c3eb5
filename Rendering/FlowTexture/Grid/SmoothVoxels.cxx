// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/SmoothVoxels.h"

#include "Grid/FlowGrid.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
// Merges an adjacent cell into the texel of a voxel.
void AddCell(const unsigned short* cell, bool isFirst, float* texel)
{
  const int kind = cell[0];
  const bool isOfLabel = kind != FlowGrid::SPLIT && kind <= FlowGrid::LARGEST_LABEL;
  const float code = isOfLabel ? static_cast<float>(kind)
    : kind > FlowGrid::EMPTY   ? static_cast<float>(FlowGrid::EMPTY - kind)
                               : SmoothVoxels::MIXED;
  const bool isUniform = isFirst || code == texel[3] || (code < 0.0F && texel[3] < 0.0F);
  texel[3] = isUniform ? (isFirst ? code : std::max(code, texel[3])) : SmoothVoxels::MIXED;
  if (isOfLabel && cell[1] > 1)
  {
    const double slope = std::exp2(cell[1] / 256.0 - 128.0);
    texel[2] = std::max(texel[2], static_cast<float>(std::min(slope, 1e30)));
  }
}
}

std::vector<float> SmoothVoxels::Make(const FlowGrid& grid)
{
  const int* size = grid.Size.data();
  std::vector<float> texels(2 * grid.Parameters.size(), 0.0F);
  vtkSMPTools::For(0, size[2],
    [&](vtkIdType firstSlice, vtkIdType lastSlice)
    {
      for (int k = static_cast<int>(firstSlice); k < lastSlice; ++k)
      {
        for (int j = 0; j < size[1]; ++j)
        {
          for (int i = 0; i < size[0]; ++i)
          {
            const vtkIdType voxel = i + size[0] * (j + static_cast<vtkIdType>(size[1]) * k);
            float* texel = &texels[4 * voxel];
            texel[0] = grid.Parameters[2 * voxel];
            texel[1] = grid.Parameters[2 * voxel + 1];
            bool isFirst = true;
            for (int z = std::max(k - 1, 0); z <= std::min(k, size[2] - 2); ++z)
            {
              for (int y = std::max(j - 1, 0); y <= std::min(j, size[1] - 2); ++y)
              {
                for (int x = std::max(i - 1, 0); x <= std::min(i, size[0] - 2); ++x)
                {
                  const vtkIdType cell =
                    x + (size[0] - 1) * (y + static_cast<vtkIdType>(size[1] - 1) * z);
                  AddCell(&grid.Cells[2 * cell], isFirst, texel);
                  isFirst = false;
                }
              }
            }
          }
        }
      }
    });
  return texels;
}

}
