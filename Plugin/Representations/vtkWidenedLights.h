// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkWidenedLights_h
#define vtkWidenedLights_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <vector>

class vtkAreaLight;
class vtkLight;
class vtkRenderer;

/**
 * @class   vtkWidenedLights
 * @brief   gives the lights of a renderer an extent while it draws one picture
 *
 * Each light that is no vtkProjectiveLight or vtkAreaLight, and so has no extent or screen of its
 * own, is replaced by a round vtkAreaLight of the same values that is seen under the angle from the
 * light's focal point.
 */
class vtkWidenedLights
{
public:
  /// Replaces the lights; \a angle is in degrees.
  void Begin(vtkRenderer* renderer, double angle);
  /// Gives the renderer back what it had.
  void End(vtkRenderer* renderer);

private:
  struct Copy
  {
    vtkSmartPointer<vtkAreaLight> Light;
    vtkMTimeType Time = 0;
  };

  std::map<vtkLight*, Copy> Copies;
  std::vector<vtkSmartPointer<vtkLight>> Lights;
};

#endif
