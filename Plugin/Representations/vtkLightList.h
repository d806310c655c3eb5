// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkLightList_h
#define vtkLightList_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkLight;
class vtkRenderer;

/**
 * @class   vtkLightList
 * @brief   gets and sets the ordered list of all lights of a renderer
 */
namespace vtkLightList
{
std::vector<vtkSmartPointer<vtkLight>> Get(vtkRenderer* renderer);
void Set(vtkRenderer* renderer, const std::vector<vtkSmartPointer<vtkLight>>& lights);
}

#endif
