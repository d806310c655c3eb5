// SPDX-License-Identifier: BSD-3-Clause
// Tests that the colors of both passes for ids contain the ids, including those of more than 24
// bits.
#include "Draw/TetrahedraSelection.h"
#include "Support/Checks/ReferenceCheck.h"

#include <cmath>
#include <string>

int TestTetrahedraSelectionIds(int, char*[])
{
  reference::Check check;
  for (vtkIdType id : { 0LL, 1LL, 255LL, 256LL, 0x10203LL, 0xffffffLL, 0x1000000LL, 0x1234567LL,
         0xfffffffeLL, 0x123456789abcLL })
  {
    vtkIdType decoded = 0;
    for (bool isHigh : { false, true })
    {
      const std::array<float, 3> color = interlume::TetrahedraSelection::GetColor(id, isHigh);
      for (int c = 0; c < 3; ++c)
      {
        const auto byte = static_cast<vtkIdType>(std::lround(255.0f * color[c]));
        decoded |= byte << (8 * c + (isHigh ? 24 : 0));
      }
    }
    check.Equal(decoded, id, "id " + std::to_string(id));
  }
  return check.Result();
}
