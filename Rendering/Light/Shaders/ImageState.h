// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageState_h
#define interlume_ImageState_h

#include "Common/Vectors.h"
#include "Lights/LightSource.h"
#include "Plan/SlicePlan.h"

#include <array>
#include <vector>

namespace interlume
{

struct SliceScene;

/**
 * @class   ImageState
 * @brief   view, lights and slices, which all volumes of an image share
 */
struct ImageState
{
  SlicePlan::Eye Eye;
  SlicePlan Plan;
  std::vector<LightSource> Lights;
  glm::dvec3 Ambient{ 1.0, 1.0, 1.0 };

  /// Columns and rows.
  std::array<int, 2> Size{ { 0, 0 } };

  /// A clipping plane of the camera: whether it cuts the volumes, and the half space that remains,
  /// in unit space.
  struct ViewPlane
  {
    bool IsCutting = false;
    std::array<double, 4> Plane{};
  };
  ViewPlane NearPlane;
  ViewPlane FarPlane;

  bool IsSmoothLookup = true;
  /// If true, some volume transmits colored light, so that all light has three channels.
  bool HasColoredLight = false;
  /// If true, opaque surfaces of the renderer may occlude volumes.
  bool MayBeOccluded = false;

  /// The scene around the volumes; null if they are rendered without one.
  SliceScene* Scene = nullptr;

  int GetLightChannels() const { return this->HasColoredLight ? 3 : 1; }
  bool HasShadows() const
  {
    for (const SlicePlan::Sweep& sweep : this->Plan.Sweeps)
    {
      if (!sweep.Lights.empty())
      {
        return true;
      }
    }
    return false;
  }
};

}

#endif
