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
 * @brief   the lights of a renderer in unit space
 */
class LightSources
{
public:
  struct Settings
  {
    bool Shadows = true;
    int MaximumNumberOfShadows = 16;
  };

  /**
   * Gathers all lights that are switched on and not black, in the renderer's order, with the
   * position and direction they have in world coordinates for the renderer's camera. Among lights
   * that cast shadows only the brightest (intensity times the largest channel of the diffuse
   * colour) keep their ShadowStrength. \a warnings gets one text for each light left out: position
   * and focal point the same (of lights that need a direction: all but positional ones without
   * cone, screen and emitter), values that are not finite, a projective or area light whose image
   * has no samples or another kind of samples than it may. An emitter's image multiplies the
   * diffuse and specular colour by its own.
   */
  static std::vector<LightSource> Gather(vtkRenderer* renderer, const UnitSpace& space,
    const Settings& settings, std::vector<std::string>& warnings);
};

}

#endif
