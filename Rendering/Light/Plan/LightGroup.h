// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightGroup_h
#define interlume_LightGroup_h

#include "Common/Vectors.h"
#include "Plan/ViewRange.h"
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
  struct Caster
  {
    Caster(int index, const LightSource& source, const BoxCorners& corners);

    /// The index in the list of lights.
    int Light;
    /// To the box's middle from positional lights.
    glm::dvec3 Direction;
    /// Through the box's corners.
    std::vector<glm::dvec3> Rays;
  };

  /// Makes a group of one light, on its own side of the view, unless only the other side has a
  /// normal that serves both.
  static LightGroup Make(const ViewRange& view, const Caster& caster);

  /// Takes the light into the group if the group stays below \a most and a normal serves all.
  bool Join(const ViewRange& view, const Caster& caster, std::size_t most);

  /// Returns whether light goes with the view, from front to back.
  bool IsFrontToBack() const { return this->Side > 0.0; }
  const std::vector<Caster>& GetCasters() const { return this->Casters; }
  /// The half vector of the view, or its opposite, and the average of lights (2.3.4), turned as far
  /// as rays need it.
  const glm::dvec3& GetNormal() const { return this->Normal; }
  /// The least cosine between the normal and a light's ray.
  double GetLightCosine() const;

private:
  LightGroup(const ViewRange& view, const Caster& caster, double side);

  void FindNormal(const ViewRange& view);

  /// The side of the lights: 1 along the view, -1 against it.
  double Side;
  std::vector<Caster> Casters;
  glm::dvec3 Normal;
  /// Of SliceNormal.
  double Ratio = 0.0;
};

}

#endif
