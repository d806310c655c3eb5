// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightSources_h
#define interlume_LightSources_h

#include "Lights/LightSource.h"

#include <string>
#include <vector>

class vtkRenderer;

namespace interlume
{

class UnitSpace;

/**
 * @class   LightSources
 * @brief   collects the lights of a renderer in unit space
 */
class LightSources
{
public:
  struct Settings
  {
    bool Shadows = true;
    int MaximumNumberOfShadowLights = 16;
  };

  /**
   * Returns all lights that are switched on and not black, in the renderer's order. Positions and
   * directions of lights that follow the camera are computed for the renderer's camera. Among
   * lights that cast shadows, only the MaximumNumberOfShadowLights brightest (intensity times the
   * largest channel of the diffuse color) keep their ShadowStrength. The diffuse and specular
   * colors of an area light are multiplied by vtkAreaLight::GetEmitterColor.
   *
   * Skips lights with values that are not finite, projective and area lights with an invalid image,
   * and lights whose position and focal point coincide. Adds a message to \a warnings for each of
   * them, and adds them to \a skipped if it is not null. Coinciding points are allowed for
   * positional lights that need no direction, which have no cone, screen or emitter with an extent.
   */
  static std::vector<LightSource> Gather(vtkRenderer* renderer, const UnitSpace& space,
    const Settings& settings, std::vector<std::string>& warnings,
    std::vector<vtkLight*>* skipped = nullptr);
};

}

#endif
