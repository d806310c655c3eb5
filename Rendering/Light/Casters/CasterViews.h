// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CasterViews_h
#define interlume_CasterViews_h

#include "Casters/CasterView.h"
#include "Lights/LightSource.h"

#include <vector>

class vtkLight;

namespace interlume
{

class UnitSpace;

/**
 * @class   CasterViews
 * @brief   from where and through which windows lights see the surfaces that cast shadows
 *
 * A directional light sees them all through one rectangle around their boxes. A positional light
 * does so too where all of them lie within 75 degrees of one direction or where its cone is
 * narrower than that; else it looks through the six sides of a cube around itself. Nothing outside
 * of a window can be in a shadow of the light.
 */
class CasterViews
{
public:
  /// A light and its views, which follow each other.
  struct Light
  {
    vtkLight* Source = nullptr;
    int FirstView = 0;
    int Views = 0;
  };

  /// Whether surfaces cast shadows of the light: not of headlights, since what these do not reach
  /// the eye does not see.
  static bool Casts(const LightSource& source);

  /**
   * Finds the views of all lights without extent that surfaces cast shadows of. \a lights are in \a
   * space; tiles of the depth map have \a resolution columns and rows.
   */
  void Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
    const std::vector<CasterView::Box>& casters, int resolution);

  const std::vector<Light>& GetLights() const { return this->Lights; }
  const std::vector<CasterView>& GetViews() const { return this->Views; }
  /// Returns the views of a light, or null where it has none.
  const Light* Find(vtkLight* light) const;

private:
  std::vector<Light> Lights;
  std::vector<CasterView> Views;
};

}

#endif
