// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceRenderer_h
#define interlume_SliceRenderer_h

#include "Draw/SliceFrame.h"
#include "Draw/SliceScatterer.h"

#include "vtkShadowedSliceReport.h"
#include "vtkShadowedSliceSettings.h"
#include "vtkType.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkLight;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkSliceMatter;
class vtkVolume;
class vtkWindow;

namespace interlume
{

class SliceTextures;
struct SliceScene;

/**
 * @class   SliceRenderer
 * @brief   makes the changed parts of a picture of slices, plans it and has it drawn
 */
class SliceRenderer
{
public:
  /// What a picture is asked for: the mapper's input, its settings and those of its superclasses.
  struct Request
  {
    vtkImageData* Image = nullptr;
    vtkDataArray* Scalars = nullptr;
    bool IsOfCells = false;
    vtkShadowedSliceSettings Settings;
    /// What the matter is looked up by; null for the scalars.
    vtkSliceMatter* Matter = nullptr;
    ClipRegion::Cuts Cuts;
    /// The scene that the picture is drawn ahead for, and not shown yet; else null.
    SliceScene* Scene = nullptr;
  };

  SliceRenderer();
  ~SliceRenderer();

  /**
   * Draws a picture. Returns what is wrong, or nothing; \a warnings gets what is left out of the
   * picture. Where something is wrong the last picture of the window is shown again.
   */
  std::string Render(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
    std::vector<std::string>& warnings, vtkShadowedSliceReport& report);

  /// Shows the last picture of the renderer's window again, if there is one.
  void ShowLast(vtkRenderer* renderer);

  /// Does what vtkShadowedSliceMapper::ReadLightBuffer documents.
  bool ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image);

  void ReleaseGraphicsResources(vtkWindow* window);

  ///@{
  /**
   * The steps of a picture, for volumes that share slices: makes the changed parts of the volume,
   * in a unit space of its own, and returns what is wrong or nothing; moves it to the shared unit
   * space; looks up how it is seen and lit; finds how light is scattered; sends textures that have
   * changed.
   */
  std::string UpdateVolume(
    vtkOpenGLRenderWindow* window, vtkVolume* volume, const Request& request);
  void MoveTo(const Request& request, const glm::dvec3& center, double radius);
  void UpdateView(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
    double coarseness, std::vector<std::string>& warnings, vtkShadowedSliceReport& report);
  /// What scattered light has to know of the volume.
  SliceScatterer::Matter GetScatteringMatter(const Request& request) const;
  /// Finds the light that was scattered before in all matter of the picture, or takes it from
  /// another volume's renderer that has found the same. Returns what is wrong, or nothing.
  std::string UpdateScattering(vtkRenderer* renderer, const Request& request,
    const std::vector<SliceScatterer::Matter>& matter, const SliceRenderer* other,
    vtkShadowedSliceReport& report);
  std::string Upload(vtkOpenGLRenderWindow* window, vtkShadowedSliceReport& report);
  ///@}
  /// Gives a scene the light that was scattered before, if there is any, for its surfaces; after
  /// Upload.
  void AddField(vtkOpenGLRenderWindow* window, SliceScene& scene);
  SliceFrame& GetFrame() { return this->Frame; }
  /// What the plan has to know of the volume.
  SlicePlan::Matter GetMatter(const Request& request) const;
  SliceTextures& GetTextures(vtkWindow* window);
  vtkIdType GetTextureBytes() const;
  /// Frees the picture of a window and its buffers, and keeps the volume's textures.
  void ReleasePicture(vtkWindow* window);

private:
  struct WindowResources;

  std::string Update(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
    std::vector<std::string>& warnings, vtkShadowedSliceReport& report);
  std::string UpdateSamples(const Request& request, bool isSoftware);
  std::string UpdateMaterial(vtkVolume* volume, const Request& request);
  void UpdateShading(vtkVolume* volume);

  SliceFrame Frame;
  /// The data that the samples and the material were made of.
  vtkDataArray* Scalars = nullptr;
  vtkMTimeType SamplesTime = 0;
  bool IsWidened = false;
  std::vector<double> MaterialKey;
  vtkMTimeType TransmissionTime = 0;
  vtkMTimeType AlbedoTime = 0;
  bool IsScattering = false;
  SliceScatterer Scatterer;
  const void* MaterialOwner = nullptr;
  int SamplesVersion = 0;
  int MaterialVersion = 0;
  std::map<vtkWindow*, std::unique_ptr<WindowResources>> Windows;
  /// The seconds of the last picture, and how coarse it was.
  double LastSeconds = 0.0;
  double LastCoarseness = 1.0;
};

}

#endif
