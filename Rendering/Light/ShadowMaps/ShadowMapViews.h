// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ShadowMapViews_h
#define interlume_ShadowMapViews_h

#include "ShadowMaps/ShadowMapView.h"
#include "Lights/LightSource.h"

#include <vector>

class vtkLight;

namespace interlume
{

class UnitSpace;

/**
 * @class   ShadowMapViews
 * @brief   the shadow map views of all lights except area lights
 *
 * A directional light has one view, which contains the bounds of all surfaces. A positional light
 * has one view if the bounds of all surfaces are within 75 degrees of one direction, or if the half
 * angle of its cone is less than 75 degrees. Otherwise it has six views, one per face of a cube
 * around the light. Positions outside all views are never in shadow.
 */
class ShadowMapViews
{
public:
  /// A light and the indices of its views, which are consecutive.
  struct Light
  {
    vtkLight* Source = nullptr;
    int FirstView = 0;
    int Views = 0;
  };

  /// Returns true if the light casts shadows of surfaces. Headlights are excluded because the
  /// camera cannot see their shadows.
  static bool CastsShadows(const LightSource& source);

  /**
   * Finds the views of all shadow-casting lights except area lights. \a lights are given in \a
   * space. Each shadow map has \a resolution columns and rows.
   */
  void Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
    const std::vector<ShadowMapView::Box>& occluders, int resolution);

  const std::vector<Light>& GetLights() const { return this->Lights; }
  const std::vector<ShadowMapView>& GetViews() const { return this->Views; }
  /// Returns the views of a light, or null if it has no views.
  const Light* Find(vtkLight* light) const;

private:
  std::vector<Light> Lights;
  std::vector<ShadowMapView> Views;
};

}

#endif
