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
 * @brief   what volumes leave of each light at the surface that each pixel shows
 *
 * Each light has a tile of one texture, as large as the viewport; all light comes through where
 * nothing is drawn. A frame begins with Clear; the first light asks for the texture.
 */
class LightTransmittance
{
public:
  LightTransmittance();
  ~LightTransmittance();

  /// Forgets what was there. A picture of \a channels, 1 or 3, of \a lights has tiles of this size.
  void Clear(int width, int height, int channels, const std::vector<vtkLight*>& lights);

  /// Returns the tile of a light, or -1 where it has none.
  int GetTile(vtkLight* light) const;
  /// Returns the first column and row of a tile.
  std::array<int, 2> GetOrigin(int tile) const;

  /// Binds the texture for what is multiplied with it, and makes it where it is not. Returns false
  /// where the graphics card has no memory.
  bool Bind(vtkOpenGLRenderWindow* window);
  /// Makes the texture where it is not: all light comes through. Returns false as Bind.
  bool Make(vtkOpenGLRenderWindow* window);
  /// Whether something has been drawn, or the texture made, since Clear.
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
