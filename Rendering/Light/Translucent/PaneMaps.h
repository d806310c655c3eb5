// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PaneMaps_h
#define interlume_PaneMaps_h

#include "Casters/CasterViews.h"
#include "Casters/ViewTiles.h"
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
 * @class   PaneMaps
 * @brief   what translucent surfaces leave of each light, in layers as the light sees them
 *
 * The light behind a surface of opacity a is 1 - a of the light before it, as the eye sees what is
 * behind it. The maps are drawn again only where lights, props or the resolution have changed.
 */
class PaneMaps
{
public:
  PaneMaps();
  ~PaneMaps();

  /**
   * Draws the maps of all views of \a props, which lie in \a views. \a bias is the setting
   * DepthBias of vtkShadowedScenePass. Returns an error if there is no memory for them.
   */
  Error Draw(vtkRenderer* renderer, const CasterViews& views, const std::vector<vtkProp*>& props,
    int resolution, double bias, std::size_t most, LayerShader& shader);
  /// Forgets what was drawn.
  void Clear(vtkWindow* window);

  /// The number of layers; 0 where nothing takes light.
  int GetLayers() const { return this->Layers; }
  /// When they were drawn last.
  vtkMTimeType GetDrawTime() const { return this->DrawTime.GetMTime(); }
  vtkTextureObject* GetTexture() const { return this->Texture; }
  vtkIdType GetBytes() const;

  /// Returns the source of GLSL that a shader needs; empty where nothing takes light. \a hasPlanes
  /// says that it is asked for places on planes.
  std::string GetSource(bool hasPlanes) const;
  /// Returns the call of it, for a light, a place and the plane that it lies on; empty where
  /// nothing takes the light.
  std::string GetShare(vtkLight* light, const std::string& place, const std::string& plane) const;
  /// Sets the uniforms of a program with that source, of which places are in coordinates that \a
  /// worldFromPlace leads from. The texture has to be active.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPlace) const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  Error DrawLayers(vtkRenderer* renderer, const std::vector<vtkProp*>& props, std::size_t most,
    LayerShader& shader);

  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLCamera> Camera;
  LayerTarget Target;
  CasterViews Views;
  ViewTiles Tiles;
  int Layers = 0;
  vtkTimeStamp DrawTime;
  /// What the maps were drawn of.
  std::vector<double> State;
};

}

#endif
