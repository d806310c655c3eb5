// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceShadowMaps_h
#define interlume_SurfaceShadowMaps_h

#include "ShadowMaps/ShadowMapView.h"
#include "ShadowMaps/PropDepths.h"
#include "ShadowMaps/ShadowMapAtlas.h"
#include "Common/Error.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkOpenGLCamera;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   SurfaceShadowMaps
 * @brief   shadow maps of opaque surfaces: one depth map per view, in tiles of one texture
 *
 * The maps are redrawn only if the lights, props or resolution have changed.
 */
class SurfaceShadowMaps
{
public:
  SurfaceShadowMaps();
  ~SurfaceShadowMaps();

  /**
   * Draws the maps of all views. \a bias is the DepthBias of vtkShadowedScenePass. Returns an error
   * if the GPU runs out of memory.
   */
  Error Draw(vtkRenderer* renderer, const std::vector<ShadowMapView>& views,
    const std::vector<vtkProp*>& props, int resolution, double bias);
  /// Returns the number of maps rendered by the last call of Draw, or 0 if nothing had changed.
  int GetDrawn() const { return this->Drawn; }
  /// Returns the largest resolution at which the maps of \a views views fit into one texture. The
  /// width of the texture is limited by \a maximum and by the GPU.
  static int GetLargestResolution(int views, int maximum);

  vtkTextureObject* GetTexture() const { return this->Depths.GetTexture(); }
  vtkIdType GetBytes() const { return this->Depths.GetBytes(); }
  const ShadowMapAtlas& GetAtlas() const { return this->Tiles; }

  /// Returns the macros that InterlumeSceneShadowMaps.glsl requires.
  std::string GetFeatures() const;
  /// Sets the uniforms of a program that contains InterlumeSceneShadowMaps.glsl. \a
  /// worldFromPosition transforms the program's positions to world coordinates. The texture must be
  /// active.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPosition) const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  PropDepths Depths;
  vtkNew<vtkOpenGLCamera> Camera;
  ShadowMapAtlas Tiles;
  int Drawn = 0;
  /// Views, props and settings at the last update; see ShadowMapAtlas::GetState.
  std::vector<double> State;
};

}

#endif
