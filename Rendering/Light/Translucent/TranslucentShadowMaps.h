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
 * @brief   transmittance of translucent surfaces for each light, in layers as seen by the light
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
   * Draws the maps of all views. \a views must cover \a props. \a bias is DepthBias of
   * vtkShadowedScenePass. Returns an error if the GPU runs out of memory.
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

  /// Returns the GLSL source for a shader, or an empty string if no surface blocks light. If \a
  /// hasPlanes is true, the shader passes planes to the calls from GetLightFraction.
  std::string GetSource(bool hasPlanes) const;
  /// Returns a GLSL call for the transmittance of a light at a position on a plane, or an empty
  /// string if no surface blocks the light.
  std::string GetLightFraction(
    vtkLight* light, const std::string& position, const std::string& plane) const;
  /// Sets the uniforms of a program with the source from GetSource. \a worldFromPosition transforms
  /// the program's positions to world coordinates. The texture must be active.
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
  /// State of views and props at the last update.
  std::vector<double> State;
};

}

#endif
