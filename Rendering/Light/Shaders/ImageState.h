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
 * @brief   camera, lights and slice plan shared by all volumes of an image
 */
struct ImageState
{
  SlicePlan::Camera Camera;
  SlicePlan Plan;
  std::vector<LightSource> Lights;
  glm::dvec3 Ambient{ 1.0, 1.0, 1.0 };

  /// Columns and rows.
  std::array<int, 2> Size{ { 0, 0 } };

  /// A clipping plane of the camera. If it cuts the volumes, Plane is the half space that is not
  /// clipped, in unit space.
  struct ViewPlane
  {
    bool IsCutting = false;
    std::array<double, 4> Plane{};
  };
  ViewPlane NearPlane;
  ViewPlane FarPlane;

  bool IsSmoothLookup = true;
  /// If true, at least one volume has a transmission color, so all light buffers have three
  /// channels.
  bool HasColoredLight = false;
  /// If true, opaque surfaces of the renderer can occlude volumes.
  bool MayBeOccluded = false;

  /// The scene that contains the volumes, or null.
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
