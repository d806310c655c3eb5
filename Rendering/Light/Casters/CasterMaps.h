// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CasterMaps_h
#define interlume_CasterMaps_h

#include "Casters/CasterView.h"
#include "Casters/PropDepths.h"
#include "Casters/ViewTiles.h"
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
 * @class   CasterMaps
 * @brief   the depths of the surfaces that each light sees, in tiles of one texture
 *
 * The maps are drawn again only where lights, props or
 * the resolution have changed.
 */
class CasterMaps
{
public:
  CasterMaps();
  ~CasterMaps();

  /**
   * Draws the maps of all views. \a bias is the setting DepthBias of vtkShadowedScenePass. Returns
   * an error if there is no memory for them.
   */
  Error Draw(vtkRenderer* renderer, const std::vector<CasterView>& views,
    const std::vector<vtkProp*>& props, int resolution, double bias);
  /// The number of maps that the last Draw drew; 0 where nothing had changed.
  int GetDrawn() const { return this->Drawn; }
  /// The largest resolution with which that many views fit into a texture of \a most columns, where
  /// the graphics card has such.
  static int GetLargestResolution(int views, int most);

  vtkTextureObject* GetTexture() const { return this->Depths.GetTexture(); }
  vtkIdType GetBytes() const { return this->Depths.GetBytes(); }
  const ViewTiles& GetTiles() const { return this->Tiles; }

  /// The features of a shader that reads the maps by InterlumeSceneCasters.glsl.
  std::string GetFeatures() const;
  /// Sets the uniforms of a program with that source, of which places are in coordinates that \a
  /// worldFromPlace leads from. The texture has to be active.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPlace) const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  PropDepths Depths;
  vtkNew<vtkOpenGLCamera> Camera;
  ViewTiles Tiles;
  int Drawn = 0;
  /// What the maps were drawn of.
  std::vector<double> State;
};

}

#endif
