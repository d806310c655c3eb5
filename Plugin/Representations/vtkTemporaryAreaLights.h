// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTemporaryAreaLights_h
#define vtkTemporaryAreaLights_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <vector>

class vtkAreaLight;
class vtkLight;
class vtkRenderer;

/**
 * @class   vtkTemporaryAreaLights
 * @brief   replaces the lights of a renderer with area lights during one rendering
 *
 * Each standard light becomes a round vtkAreaLight with the same properties and a scaled intensity.
 * Its size is chosen so that it has a given angular diameter as seen from its focal point.
 * vtkProjectiveLight and vtkAreaLight are not replaced.
 */
class vtkTemporaryAreaLights
{
public:
  /// Replaces the lights. \a angle is the angular diameter in degrees; the intensities are
  /// multiplied by \a scale.
  void Begin(vtkRenderer* renderer, double angle, double scale);
  /// Restores the lights of the renderer.
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
