// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightGroup_h
#define interlume_LightGroup_h

#include "Common/Vectors.h"
#include "Plan/CameraRays.h"
#include "Space/BoxCorners.h"

namespace interlume
{

/**
 * @class   LightGroup
 * @brief   lights that share the slices of a sweep
 */
class LightGroup
{
public:
  /// A light that casts shadows.
  struct Light
  {
    Light(int index, const LightSource& source, const BoxCorners& corners);

    /// Index in the list of lights.
    int Index;
    /// Light direction; for a positional light, the direction to the center of the box.
    glm::dvec3 Direction;
    /// Directions of the light rays through the corners of the box.
    std::vector<glm::dvec3> Rays;
  };

  /// Creates a group with one light. The sweep runs front to back if the light comes from the
  /// viewer's side, otherwise back to front. If no normal for that order suits both the view and
  /// the light, the order with the better normal is used.
  static LightGroup Make(const CameraRays& view, const Light& light);

  /// Adds the light if the group has fewer than \a maximum lights and one slice normal suits all of
  /// them. Returns true if the light was added.
  bool Join(const CameraRays& view, const Light& light, std::size_t maximum);

  /// Returns true if the slices are drawn front to back.
  bool IsFrontToBack() const { return this->Side > 0.0; }
  const std::vector<Light>& GetLights() const { return this->Lights; }
  /// Returns the slice normal: the half vector of the view direction, or its opposite, and the
  /// average light direction (C. Zhang, dissertation, section 2.3.4), rotated as far as the rays
  /// require.
  const glm::dvec3& GetNormal() const { return this->Normal; }
  /// Returns the minimum cosine between the normal and the lights' rays.
  double GetLightCosine() const;

private:
  LightGroup(const CameraRays& view, const Light& light, double side);

  void FindNormal(const CameraRays& view);

  /// 1 if the sweep runs front to back, -1 if it runs back to front.
  double Side;
  std::vector<Light> Lights;
  glm::dvec3 Normal;
  /// SliceNormal::GetRatio of the best normal.
  double Ratio = 0.0;
};

}

#endif
