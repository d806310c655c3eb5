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
 * @brief   settings and results of light scattering in a volume
 *
 * Multiply scattered light is stored at the nodes of a grid, in maps of four floats per node. The
 * maps are stacked along z in one texture. The first two maps are Fluence and NetFlux of
 * ScatteredLight, with NetFlux in unit space. The other maps are those of Forward, one per light.
 */
struct SliceScattering
{
  /// Number of samples of a tabulated phase function, at cosines from -1 to 1.
  static constexpr int PhaseColumns = 4096;

  bool IsOn() const { return this->Mode != vtkShadowedSliceSettings::NO_SCATTERING; }
  bool HasMaps() const { return !this->Texels.empty(); }
  /// Returns the index of a light's map, or 0 if it has no map.
  int GetForwardMap(const vtkLight* light) const
  {
    const auto found = std::find(this->ForwardLights.begin(), this->ForwardLights.end(), light);
    return found == this->ForwardLights.end()
      ? 0
      : 2 + static_cast<int>(std::distance(this->ForwardLights.begin(), found));
  }
  int GetNumberOfMaps() const { return 2 + static_cast<int>(this->ForwardLights.size()); }
  glm::ivec3 GetTextureSize() const
  {
    return { this->Nodes.x, this->Nodes.y, this->Nodes.z * this->GetNumberOfMaps() };
  }

  /// See vtkShadowedSliceSettings::ScatteringModes and PhaseFunctions.
  int Mode = vtkShadowedSliceSettings::NO_SCATTERING;
  int Kind = vtkShadowedSliceSettings::ISOTROPIC_PHASE;
  /// Mean cosine of the Henyey-Greenstein function.
  double Anisotropy = 0.0;
  /// Mean cosine of the selected phase function.
  double MeanCosine = 0.0;
  /// Brightness factor for all scattered light.
  double Brightness = 1.0;
  /// For a tabulated phase function, PhaseColumns values of 4 pi times the function.
  std::vector<float> Phases;

  /// The maps. Empty if there is no multiple scattering.
  std::vector<float> Texels;
  glm::ivec3 Nodes{ 0 };
  /// If true, there is scattered light in all directions.
  bool HasFluence = false;
  /// Transformation from unit space to node indices.
  glm::dmat4 NodeFromUnit{ 1.0 };
  /// Lights with a map.
  std::vector<const vtkLight*> ForwardLights;
};

}

#endif
