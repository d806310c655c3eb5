// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowTextures_h
#define interlume_FlowTextures_h

#include "Common/Error.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   FlowTextures
 * @brief   textures by the names that a shader has for them, each sent when its source has changed
 */
class FlowTextures
{
public:
  /// What a texture is made of.
  struct Source
  {
    std::array<int, 3> Size{ { 1, 1, 1 } };
    int Components = 1;
    /// VTK_FLOAT or VTK_UNSIGNED_SHORT.
    int Type = VTK_FLOAT;
    const void* Values = nullptr;
    /// Set if there is nothing to send.
    interlume::Error Error;
    /// Whether it is interpolated, goes on beyond its ends, and has levels of detail.
    bool IsSmooth = false;
    bool IsRepeated = false;
    bool HasLevels = false;
  };

  /// What tells that a source has changed: who it is, its time or version, and its size or range.
  struct Stamp
  {
    const void* Owner = nullptr;
    vtkMTimeType Time = 0;
    std::array<double, 3> Extent{};

    bool operator==(const Stamp& other) const
    {
      return this->Owner == other.Owner && this->Time == other.Time && this->Extent == other.Extent;
    }
  };

  /// Begins an image: textures that are not kept until Finish are released there.
  void Begin(vtkOpenGLRenderWindow* window);
  /**
   * Keeps a texture, of three dimensions if \a isVolume; \a make is called if the stamp is not that
   * of the last time. \a count grows if it was sent. Nothing is kept after an error, whose message
   * begins with \a title.
   */
  void Keep(const std::string& name, const std::string& title, bool isVolume, const Stamp& stamp,
    const std::function<Source()>& make, int& count);
  /// Returns the first error since Begin.
  Error Finish();

  /// Returns the bytes sent since Begin.
  vtkIdType GetSentBytes() const { return this->SentBytes; }
  int GetNumber() const { return static_cast<int>(this->Textures.size()); }
  vtkIdType GetBytes() const;

  /// Binds all textures that the program uses.
  void Activate(vtkShaderProgram* program);
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Texture
  {
    vtkSmartPointer<vtkTextureObject> Object;
    Stamp Made;
    vtkIdType Bytes = 0;
    bool IsUsed = false;
  };

  Error Send(bool isVolume, Texture& texture, const Source& source);

  vtkOpenGLRenderWindow* Window = nullptr;
  vtkIdType SentBytes = 0;
  Error FirstError;
  std::map<std::string, Texture> Textures;
  std::vector<vtkTextureObject*> Active;
};

}

#endif
