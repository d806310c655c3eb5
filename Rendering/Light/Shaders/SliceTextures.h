// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceTextures_h
#define interlume_SliceTextures_h

#include "Common/Error.h"
#include "Lights/ScreenTextures.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkSliceMedium;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

class MaterialTable;
class VolumeSamples;
struct SliceScattering;

/**
 * @class   SliceTextures
 * @brief   textures of a volume, its transfer functions and the screens of projective lights
 */
class SliceTextures
{
public:
  SliceTextures();
  ~SliceTextures();

  ///@{
  /// Return the size of the textures in bytes.
  static vtkIdType GetBytes(const VolumeSamples& samples);
  static vtkIdType GetBytes(const MaterialTable& material);
  static vtkIdType GetBytes(const SliceScattering& scattering);
  static vtkIdType GetDifferenceBytes(const VolumeSamples& samples);
  ///@}

  ///@{
  /// Upload the samples, the transfer functions or scattered light. Return an error if they exceed
  /// the memory or the texture size of the graphics card.
  Error Upload(vtkOpenGLRenderWindow* window, const VolumeSamples& samples);
  Error Upload(vtkOpenGLRenderWindow* window, const MaterialTable& material);
  Error Upload(vtkOpenGLRenderWindow* window, const SliceScattering& scattering);
  ///@}

  /// Uploads the result of FindDifferences, or releases it if \a samples is null.
  Error UploadDifferences(vtkOpenGLRenderWindow* window, const VolumeSamples* samples);

  /// Sets a custom medium, or null. Its textures are bound together with those of this object.
  void SetMedium(vtkSliceMedium* medium) { this->Medium = medium; }

  /// Returns the texture of multiply scattered light. It has no handle if there is no such light.
  vtkTextureObject* GetScatteredLightTexture() const { return this->Scattered; }

  /// Returns the textures of the images of projective lights.
  ScreenTextures& GetScreens() { return this->Screens; }

  ///@{
  /// Bind and unbind the textures used by \a program.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  /// Unbinds the textures temporarily.
  void Suspend();
  /// Binds the textures again. Returns true if all texture units are unchanged.
  bool Resume();
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Volume;
  vtkNew<vtkTextureObject> Mask;
  vtkNew<vtkTextureObject> Differences;
  vtkNew<vtkTextureObject> Colors;
  vtkNew<vtkTextureObject> Extinctions;
  vtkNew<vtkTextureObject> ExtinctionSums;
  vtkNew<vtkTextureObject> GradientOpacities;
  vtkNew<vtkTextureObject> Transmissions;
  vtkNew<vtkTextureObject> Bends;
  vtkNew<vtkTextureObject> Phases;
  vtkNew<vtkTextureObject> Scattered;
  /// Sums not yet uploaded to ExtinctionSums.
  std::vector<float> SumTexels;
  ScreenTextures Screens;
  vtkSliceMedium* Medium = nullptr;
  /// Textures that are bound or suspended, with their texture units.
  std::vector<std::pair<vtkTextureObject*, int>> Active;
};

}

#endif
