// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnitSpaceCamera_h
#define interlume_UnitSpaceCamera_h

#include "Plan/SlicePlan.h"

class vtkRenderer;

namespace interlume
{

class UnitSpace;

/**
 * @class   UnitSpaceCamera
 * @brief   a renderer's camera in unit space
 */
class UnitSpaceCamera
{
public:
  static SlicePlan::Eye Get(vtkRenderer* renderer, const UnitSpace& space);
};

}

#endif
