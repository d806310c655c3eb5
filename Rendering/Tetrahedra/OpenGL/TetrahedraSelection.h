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
 * @brief   the colours by which a hardware selector tells cells apart
 */
class TetrahedraSelection
{
public:
  /**
   * Returns whether this pass of the selector draws anything of a volume's cells.
   */
  static bool IsDrawn(vtkHardwareSelector* selector);

  /**
   * Makes four values for each pixel: the colour of this pass, and the value of the depth buffer,
   * below 0 where there is nothing. \a cells are cells plus 1, 0 for none.
   */
  static std::vector<float> MakeImage(vtkHardwareSelector* selector, const TetrahedraView& view,
    const std::vector<vtkIdType>& cells, const std::vector<float>& depths);
};

}

#endif
