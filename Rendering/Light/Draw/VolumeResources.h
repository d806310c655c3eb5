// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeResources_h
#define interlume_VolumeResources_h

#include "Common/Error.h"
#include "Draw/ScatteringUpdater.h"
#include "Shaders/VolumeRenderState.h"
#include "Sweeps/SliceReport.h"

#include "vtkShadowedSliceSettings.h"
#include "vtkType.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkInterlumeReport;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkSliceMedium;
class vtkVolume;
class vtkWindow;

namespace interlume
{

class SliceTextures;

/**
 * @class   VolumeResources
 * @brief   the data, scattered light and textures of a volume, updated where they have changed
 */
class VolumeResources
{
public:
  /// The volume, and the input and settings of its mapper.
  struct Request
  {
    vtkVolume* Volume = nullptr;
    vtkImageData* Image = nullptr;
    vtkDataArray* Scalars = nullptr;
    bool IsOfCells = false;
    vtkShadowedSliceSettings Settings;
    /// See VolumeRenderState.
    vtkSliceMedium* Medium = nullptr;
    ClipRegion::Cuts Cuts;
    /// The mapper's report.
    vtkInterlumeReport* Report = nullptr;
  };

  VolumeResources();
  ~VolumeResources();

  /// The results of an image for the volume.
  struct Result
  {
    /// The error if the volume is not in the image.
    interlume::Error Error;
    std::vector<std::string> Warnings;
  };

  /// Begins an image with an empty report. \a error is the result if the request cannot be
  /// rendered.
  void SetRequest(const Request& request, const Error& error);
  const Request& GetRequest() const { return this->Asked; }
  const VolumeRenderState& GetState() const { return this->State; }
  Result& GetResult() { return this->Results; }
  const Result& GetResult() const { return this->Results; }
  const SliceReport& GetReport() const { return this->Report; }

  ///@{
  /**
   * The steps of an image, which return an error if they fail: update samples and material, in the
   * volume's own unit space; move to a unit space that volumes share; make the volume part of an
   * image; update scattered light, from the medium of all volumes, or copy it from another volume
   * that has the same; upload textures.
   */
  Error UpdateData(vtkOpenGLRenderWindow* window);
  void MoveTo(const glm::dvec3& center, double radius);
  void SetImage(const ImageState& image, int number);
  Error UpdateScattering(vtkRenderer* renderer,
    const std::vector<ScatteringUpdater::Volume>& volumes, int lightSamples,
    const VolumeResources* other);
  Error Upload(vtkOpenGLRenderWindow* window);
  ///@}

  /// Returns the input of ScatteringUpdater.
  ScatteringUpdater::Volume GetScatteringVolume() const;
  /// Returns the input of SlicePlan.
  SlicePlan::Matter GetSlicedVolume() const;
  SliceTextures& GetTextures(vtkWindow* window);
  vtkIdType GetTextureBytes() const;

  /// Adds the light that was scattered before to a scene, for its surfaces, after Upload. Returns
  /// whether there is any.
  bool AddScatteredLight(vtkOpenGLRenderWindow* window);

  /// Sets the report: the values that all volumes of the image share, and the volume's own.
  void SetReport(const SliceReport& shared, const std::string& features);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct WindowResources;

  Error UpdateSamples();
  Error UpdateMaterial();

  Request Asked;
  Result Results;
  SliceReport Report;
  VolumeRenderState State;
  /// The data that the samples and the material were built from.
  vtkDataArray* Scalars = nullptr;
  vtkMTimeType SamplesTime = 0;
  bool IsWidened = false;
  const void* MaterialOwner = nullptr;
  std::vector<double> MaterialKey;
  ScatteringUpdater Scatterer;
  int SamplesVersion = 0;
  int MaterialVersion = 0;
  /// The bytes of Upload for this image.
  vtkIdType UploadedBytes = 0;
  std::map<vtkWindow*, std::unique_ptr<WindowResources>> Windows;
};

}

#endif
