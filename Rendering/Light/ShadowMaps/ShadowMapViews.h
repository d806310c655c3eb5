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
 * @brief   shadow map views of lights: their positions and windows
 *
 * A directional light has one view, a rectangle around the boxes of all surfaces. A positional
 * light has one view if all boxes are within 75 degrees of one direction, or if its cone is
 * narrower. Otherwise it has six views, the faces of a cube around it. Positions outside all
 * windows are never in shadow.
 */
class ShadowMapViews
{
public:
  /// A light and its consecutive views.
  struct Light
  {
    vtkLight* Source = nullptr;
    int FirstView = 0;
    int Views = 0;
  };

  /// Returns true if surfaces cast shadows for the light. Headlights are excluded because their
  /// shadows are hidden from the camera.
  static bool Casts(const LightSource& source);

  /**
   * Finds the views of all shadow-casting lights without extent. \a lights are in \a space. Each
   * tile of the shadow map has \a resolution columns and rows.
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
