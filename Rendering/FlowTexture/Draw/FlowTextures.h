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
 * @brief   stores textures by sampler name and uploads a texture only if its source has changed
 */
class FlowTextures
{
public:
  /// Contents and parameters of a texture.
  struct Source
  {
    std::array<int, 3> Size{ { 1, 1, 1 } };
    int Components = 1;
    /// VTK_FLOAT or VTK_UNSIGNED_SHORT.
    int Type = VTK_FLOAT;
    const void* Values = nullptr;
    /// Set if the contents are not available.
    interlume::Error Error;
    /// Whether to interpolate linearly, to repeat outside [0, 1], and to use mipmaps.
    bool IsSmooth = false;
    bool IsRepeated = false;
    bool HasLevels = false;
  };

  /// Identifies the contents of a texture by the object that provides them, its modification time
  /// or version, and a size or range.
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

  /// Begins a frame. Textures that are not updated before Finish are released.
  void Begin(vtkOpenGLRenderWindow* window);
  /**
   * Updates a texture, three-dimensional if \a isVolume. If the stamp differs from the previous
   * stamp, calls \a make, uploads the result and increments \a count. After an error, further calls
   * do nothing. The error message begins with \a title.
   */
  void Update(const std::string& name, const std::string& title, bool isVolume, const Stamp& stamp,
    const std::function<Source()>& make, int& count);
  /// Ends a frame. Returns the first error since Begin.
  Error Finish();

  /// Returns the number of bytes uploaded since Begin.
  vtkIdType GetUploadedBytes() const { return this->UploadedBytes; }
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
    Stamp SourceStamp;
    vtkIdType Bytes = 0;
    bool IsUsed = false;
  };

  Error Upload(bool isVolume, Texture& texture, const Source& source);

  vtkOpenGLRenderWindow* Window = nullptr;
  vtkIdType UploadedBytes = 0;
  Error FirstError;
  std::map<std::string, Texture> Textures;
  std::vector<vtkTextureObject*> Active;
};

}

#endif
