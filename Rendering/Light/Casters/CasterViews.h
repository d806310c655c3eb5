// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CasterViews_h
#define interlume_CasterViews_h

#include "Common/Vectors.h"
#include "Lights/LightSource.h"

#include <array>
#include <vector>

#include <glm/mat4x4.hpp>

class vtkCamera;
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
  /// The bounds of one surface in world coordinates, as VTK orders them.
  using Box = std::array<double, 6>;

  struct View
  {
    bool IsPerspective = false;
    /// From world to the light's own coordinates, where it looks along -z, and from those to clip
    /// coordinates.
    glm::dmat4 LightFromWorld{ 0.0 };
    glm::dmat4 ClipFromLight{ 0.0 };
    glm::dmat4 ClipFromWorld{ 0.0 };
    /// A texel's width as a depth: with w the fourth clip coordinate of a place this is [0] + [1] /
    /// w in normalised device coordinates.
    std::array<double, 2> TexelDepth{};
  };

  /// A light and its views, which follow each other.
  struct Light
  {
    vtkLight* Source = nullptr;
    double Strength = 0.0;
    int FirstView = 0;
    int Views = 0;
  };

  /**
   * Finds the views of all lights that cast shadows but headlights: what these do not reach the eye
   * does not see. \a lights are in \a space; tiles of the depth map have \a resolution columns and
   * rows.
   */
  void Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
    const std::vector<Box>& casters, int resolution);

  const std::vector<Light>& GetLights() const { return this->Lights; }
  const std::vector<View>& GetViews() const { return this->Views; }
  /// Returns the views of a light, or null where it has none.
  const Light* Find(vtkLight* light) const;

  /// Makes \a camera draw as the view sees.
  static void SetCamera(const View& view, vtkCamera* camera);

private:
  std::vector<Light> Lights;
  std::vector<View> Views;
};

}

#endif
