// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TranslucentShadowMaps_h
#define interlume_TranslucentShadowMaps_h

#include "ShadowMaps/ShadowMapViews.h"
#include "ShadowMaps/ShadowMapAtlas.h"
#include "Common/Error.h"
#include "Translucent/DepthLayers.h"

#include "vtkNew.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkLight;
class vtkOpenGLCamera;
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;

namespace interlume
{

/**
 * @class   TranslucentShadowMaps
 * @brief   shadow maps of translucent surfaces: transmittance in layers seen from each light
 *
 * A surface of opacity a transmits 1 - a of the light, consistent with its opacity for the camera.
 * The maps are redrawn only if the lights, props or resolution have changed.
 */
class TranslucentShadowMaps
{
public:
  TranslucentShadowMaps();
  ~TranslucentShadowMaps();

  /**
   * Draws the maps of all views. \a views must contain the bounds of \a props. \a bias is the
   * DepthBias of vtkShadowedScenePass. \a maximum is the maximum number of layers. Returns an error
   * if the GPU runs out of memory.
   */
  Error Draw(vtkRenderer* renderer, const ShadowMapViews& views, const std::vector<vtkProp*>& props,
    int resolution, double bias, std::size_t maximum, LayerShader& shader);
  /// Clears the maps.
  void Clear(vtkWindow* window);

  /// Returns the number of layers, or 0 if no surface blocks light.
  int GetLayers() const { return this->Layers; }
  /// Returns the time of the last update.
  vtkMTimeType GetDrawTime() const { return this->DrawTime.GetMTime(); }
  vtkTextureObject* GetTexture() const { return this->Texture; }
  vtkIdType GetBytes() const;

  /// Returns the GLSL functions that shaders need, or an empty string if no surface blocks light.
  /// If \a hasPlanes is true, lookups account for the plane passed to GetLightFraction.
  std::string GetSource(bool hasPlanes) const;
  /// Returns a GLSL expression for the fraction of a light that reaches a position, or an empty
  /// string if no surface blocks the light. \a position and \a plane, the plane of the surface
  /// there, are GLSL expressions.
  std::string GetLightFraction(
    vtkLight* light, const std::string& position, const std::string& plane) const;
  /// Sets the uniforms of a program that contains the result of GetSource. \a worldFromPosition
  /// transforms the program's positions to world coordinates. The texture must be active.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPosition) const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  Error DrawLayers(vtkRenderer* renderer, const std::vector<vtkProp*>& props, std::size_t maximum,
    LayerShader& shader);

  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLCamera> Camera;
  LayerTarget Target;
  ShadowMapViews Views;
  ShadowMapAtlas Tiles;
  int Layers = 0;
  vtkTimeStamp DrawTime;
  /// Views, props and settings at the last update; see ShadowMapAtlas::GetState.
  std::vector<double> State;
};

}

#endif
