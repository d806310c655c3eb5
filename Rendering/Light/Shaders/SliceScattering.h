// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceScattering_h
#define interlume_SliceScattering_h

#include "vtkShadowedSliceSettings.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

class vtkLight;

namespace interlume
{

/**
 * @class   SliceScattering
 * @brief   how the light of a volume's picture is scattered towards the eye
 *
 * Light that was scattered before is known at the nodes of a grid: maps of four floats a node, one
 * behind the other along z of one texture. The first two are Fluence and Lean of ScatteringField,
 * the latter in the axes of unit space, then comes Forward of each light.
 */
struct SliceScattering
{
  /// The number of values of a phase function by a table, over the cosine from -1 to 1.
  static constexpr int PhaseColumns = 4096;

  bool IsOn() const { return this->Mode != vtkShadowedSliceSettings::NO_SCATTERING; }
  bool HasField() const { return !this->Texels.empty(); }
  /// The number of the map of a light; 0 where it has none.
  int GetForwardMap(const vtkLight* light) const
  {
    const auto found = std::find(this->ForwardLights.begin(), this->ForwardLights.end(), light);
    return found == this->ForwardLights.end()
      ? 0
      : 2 + static_cast<int>(std::distance(this->ForwardLights.begin(), found));
  }
  int GetMaps() const { return 2 + static_cast<int>(this->ForwardLights.size()); }
  glm::ivec3 GetTextureSize() const
  {
    return { this->Nodes.x, this->Nodes.y, this->Nodes.z * this->GetMaps() };
  }

  /// See vtkShadowedSliceSettings::ScatteringModes and PhaseFunctions.
  int Mode = vtkShadowedSliceSettings::NO_SCATTERING;
  int Kind = vtkShadowedSliceSettings::ISOTROPIC_PHASE;
  /// Of Henyey and Greenstein's function.
  double Anisotropy = 0.0;
  /// The mean cosine of any.
  double MeanCosine = 0.0;
  /// What the eye sees of all scattered light.
  double Brightness = 1.0;
  /// 4 pi times the phase function, PhaseColumns values, of one by a table.
  std::vector<float> Phases;

  /// The maps; empty without light that was scattered before.
  std::vector<float> Texels;
  glm::ivec3 Nodes{ 0 };
  /// Whether there is light in all directions.
  bool HasFluence = false;
  /// From unit space to numbers of nodes.
  glm::dmat4 NodeFromUnit{ 1.0 };
  /// The lights that have a map.
  std::vector<const vtkLight*> ForwardLights;
};

}

#endif
