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
 * @brief   volume, transfer functions and light screens on the graphics card
 */
class SliceTextures
{
public:
  SliceTextures();
  ~SliceTextures();

  ///@{
  /// Return the bytes on the graphics card.
  static vtkIdType GetBytes(const VolumeSamples& samples);
  static vtkIdType GetBytes(const MaterialTable& material);
  static vtkIdType GetBytes(const SliceScattering& scattering);
  ///@}

  ///@{
  /// Sends the samples, the tables of the material, or scattered light to the graphics card.
  /// Returns an error if they do not fit.
  Error Upload(vtkOpenGLRenderWindow* window, const VolumeSamples& samples);
  Error Upload(vtkOpenGLRenderWindow* window, const MaterialTable& material);
  Error Upload(vtkOpenGLRenderWindow* window, const SliceScattering& scattering);
  ///@}

  /// The matter that is looked up in textures of its own, which are bound with these; null for
  /// none.
  void SetMedium(vtkSliceMedium* medium) { this->Medium = medium; }

  /// The light that was scattered before; without a handle where there is none.
  vtkTextureObject* GetScattered() const { return this->Scattered; }

  /// The images of projective lights.
  ScreenTextures& GetScreens() { return this->Screens; }

  ///@{
  /// Binds the textures that \a program reads, and unbinds them.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  /// Unbinds them for a while.
  void Suspend();
  /// Binds them again. Returns whether each has the unit that programs know it by.
  bool Resume();
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Volume;
  vtkNew<vtkTextureObject> Mask;
  vtkNew<vtkTextureObject> Colors;
  vtkNew<vtkTextureObject> Extinctions;
  vtkNew<vtkTextureObject> ExtinctionSums;
  vtkNew<vtkTextureObject> GradientOpacities;
  vtkNew<vtkTextureObject> Transmissions;
  vtkNew<vtkTextureObject> Bends;
  vtkNew<vtkTextureObject> Phases;
  vtkNew<vtkTextureObject> Scattered;
  /// The sums that ExtinctionSums has yet to get.
  std::vector<float> SumTexels;
  ScreenTextures Screens;
  vtkSliceMedium* Medium = nullptr;
  /// The textures that are bound, or suspended, with their units.
  std::vector<std::pair<vtkTextureObject*, int>> Active;
};

}

#endif
