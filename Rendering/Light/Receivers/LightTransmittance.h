// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightTransmittance_h
#define interlume_LightTransmittance_h

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkLight;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   LightTransmittance
 * @brief   transmittance of volumes for each light, at the surface visible in each pixel
 *
 * Each light has a tile, as large as the viewport, in one texture. Texels where nothing is drawn
 * are 1. Call Clear at the start of a frame. The texture is allocated when it is first needed.
 */
class LightTransmittance
{
public:
  LightTransmittance();
  ~LightTransmittance();

  /// Starts a frame with one tile for each of \a lights, and \a channels (1 or 3) per texel.
  void Clear(int width, int height, int channels, const std::vector<vtkLight*>& lights);

  /// Returns the tile of a light, or -1 if there is no tile.
  int GetTile(vtkLight* light) const;
  /// Returns the first column and row of a tile.
  std::array<int, 2> GetOrigin(int tile) const;

  /// Binds the texture, so that transmittances can be multiplied into it, and allocates it if
  /// necessary. Returns false if the GPU runs out of memory.
  bool Bind(vtkOpenGLRenderWindow* window);
  /// Allocates the texture if necessary, with a transmittance of 1. Returns false if the GPU runs
  /// out of memory.
  bool Make(vtkOpenGLRenderWindow* window);
  /// Returns true if the texture has been allocated since Clear.
  bool IsUsed() const { return this->HasContents; }

  vtkTextureObject* GetTexture() const { return this->Texture; }
  vtkIdType GetBytes() const { return this->HasContents ? this->Bytes : 0; }
  const std::vector<vtkLight*>& GetLights() const { return this->Lights; }
  int GetChannels() const { return this->Channels; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::vector<vtkLight*> Lights;
  int Width = 0;
  int Height = 0;
  int Channels = 1;
  int Columns = 1;
  vtkIdType Bytes = 0;
  bool HasContents = false;
};

}

#endif
