// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraSelection_h
#define interlume_TetrahedraSelection_h

#include "View/TetrahedraView.h"

#include <cstdint>
#include <vector>

class vtkHardwareSelector;

namespace interlume
{

/**
 * @class   TetrahedraSelection
 * @brief   encodes cell ids as colors for vtkHardwareSelector
 */
class TetrahedraSelection
{
public:
  /**
   * Returns true if tetrahedra are drawn in the current pass: in all passes except those for point
   * ids.
   */
  static bool IsDrawn(vtkHardwareSelector* selector);

  /**
   * Returns four values for each pixel: the RGB color for the current pass, and the depth buffer
   * value, which is negative if there is no cell. \a cells are cell ids plus 1, or 0 for no cell.
   */
  static std::vector<float> MakeImage(vtkHardwareSelector* selector, const TetrahedraView& view,
    const std::vector<vtkIdType>& cells, const std::vector<float>& depths);
};

}

#endif
