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
 * @brief   transmittance of a scene's opaque surfaces for all its lights
 *
 * The maps of lights without extent are in one texture, and the maps of area lights' samples in
 * another. Without area lights, the shaders contain no code for them.
 */
class SceneOccluders
{
public:
  /// Finds the views of the lights for which surfaces cast shadows. \a samples is the number of
  /// samples of an area light.
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
  /// Returns a GLSL call, without spaces, that yields a light's transmittance (float or vec3) at a
  /// position on a plane. Returns an empty string if surfaces cast no shadows for the light.
  std::string GetLightFraction(
    vtkLight* light, const std::string& position, const std::string& plane) const;
  /// Returns a GLSL call like that of GetLightFraction, for one sample of an area light. \a sample
  /// is a GLSL expression for the index of the sample among \a samples. Returns an empty string if
  /// the shadow maps use a different number of samples.
  std::string GetSampleLightFraction(vtkLight* light, int samples, const std::string& sample,
    const std::string& position, const std::string& plane) const;
  /// Sets the uniforms of a program with the source from GetSource. \a worldFromPosition transforms
  /// the program's positions to world coordinates. The textures must be active.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPosition) const;
  /// Sets the number of samples to 0 in a program that only draws depths, to avoid useless
  /// comparisons.
  void ClearUniforms(vtkShaderProgram* program) const;
  /// Compares sample maps as if positions were closer to the light by the width of \a texels
  /// texels. Use this for surfaces whose plane is unknown.
  void AddBias(vtkShaderProgram* program, double texels) const;
  /// Returns the names of the textures in the source, and the textures. Some of the textures may be
  /// empty.
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
