// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneOccluders_h
#define interlume_SceneOccluders_h

#include "ShadowMaps/SurfaceShadowMaps.h"
#include "ShadowMaps/ShadowMapViews.h"
#include "ShadowMaps/AreaLightViews.h"
#include "Common/Error.h"
#include "Space/UnitSpace.h"

#include "vtkTimeStamp.h"

#include <string>
#include <utility>
#include <vector>

class vtkLight;
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

struct SceneReport;

/**
 * @class   SceneOccluders
 * @brief   shadows that the opaque surfaces of a scene cast, for all its lights
 *
 * One texture contains the shadow maps of the lights without extent, and another one the shadow
 * maps of all samples of area lights. Without area lights, the shaders contain no code for them.
 */
class SceneOccluders
{
public:
  /// Finds the shadow map views of all lights that cast shadows. \a samples is the number of
  /// samples per area light.
  void Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
    const std::vector<ShadowMapView::Box>& occluders, int resolution, int samples);
  void Clear();
  bool HasViews() const;
  /// Returns the number of samples of each area light with maps, or 0 if no area light has maps.
  int GetLightSamples() const { return this->Emitters.GetSamples().empty() ? 0 : this->Samples; }
  /// Returns the time of the last map update. It changes when a map changes.
  vtkMTimeType GetDrawTime() const { return this->DrawTime.GetMTime(); }

  /// Draws the maps. \a bias is DepthBias of vtkShadowedScenePass. Returns an error if the GPU runs
  /// out of memory.
  Error Draw(vtkRenderer* renderer, const std::vector<vtkProp*>& props, int resolution, double bias,
    SceneReport& report);

  /// Return the macros and the GLSL functions for a shader that contains calls from
  /// GetLightFraction.
  std::string GetFeatures() const;
  std::string GetSource() const;
  /// Returns a GLSL call, without spaces, that yields the transmittance (float or vec3) of a light
  /// at \a position on \a plane, which are GLSL expressions. Returns an empty string if surfaces
  /// cast no shadows for the light.
  std::string GetLightFraction(
    vtkLight* light, const std::string& position, const std::string& plane) const;
  /// Returns a GLSL call like that of GetLightFraction, for one sample of an area light. \a sample
  /// is a GLSL expression for the index of the sample among \a samples. Returns an empty string if
  /// the shadow maps use a different number of samples.
  std::string GetSampleLightFraction(vtkLight* light, int samples, const std::string& sample,
    const std::string& position, const std::string& plane) const;
  /// Sets the uniforms of a program that contains the source from GetSource. \a worldFromPosition
  /// transforms the positions in the program to world coordinates. The textures must be active.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPosition) const;
  /// Sets the number of samples to 0 in a program that only draws depths, to avoid useless shadow
  /// map comparisons.
  void DisableSampleShadows(vtkShaderProgram* program) const;
  /// Adds the width of \a texels texels to the depth bias of the maps of area light samples. Use
  /// this for surfaces whose plane is unknown.
  void AddBias(vtkShaderProgram* program, double texels) const;
  /// Returns the textures and their names in the GLSL code. Textures may be empty.
  std::vector<std::pair<const char*, vtkTextureObject*>> GetTextures() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void SetEmitterUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPosition) const;

  ShadowMapViews Views;
  SurfaceShadowMaps Maps;
  AreaLightViews Emitters;
  SurfaceShadowMaps EmitterMaps;
  UnitSpace Space;
  int Samples = 0;
  vtkTimeStamp DrawTime;
};

}

#endif
