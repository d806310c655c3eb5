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
 * @brief   the data, scattered light and textures of a volume, updated when their inputs change
 */
class VolumeResources
{
public:
  /// The volume, and its mapper's input and settings.
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

  struct Result
  {
    /// Set if the volume could not be rendered.
    interlume::Error Error;
    std::vector<std::string> Warnings;
  };

  /// Begins an image with an empty report. \a error, which is set if the request is invalid,
  /// becomes the error of the result.
  void SetRequest(const Request& request, const Error& error);
  const Request& GetRequest() const { return this->CurrentRequest; }
  const VolumeRenderState& GetState() const { return this->State; }
  Result& GetResult() { return this->Results; }
  const Result& GetResult() const { return this->Results; }
  const SliceReport& GetReport() const { return this->Report; }

  ///@{
  /**
   * Steps of rendering, in this order. Steps that can fail return an error on failure.
   * - UpdateData updates samples and material, in the volume's own unit space.
   * - MoveTo moves the volume to a shared unit space.
   * - SetImage adds the volume to an image.
   * - UpdateScattering computes scattered light from the medium of all volumes, or copies it from
   *   \a other if the inputs are the same.
   * - Upload uploads the textures.
   */
  Error UpdateData(vtkOpenGLRenderWindow* window);
  void MoveTo(const glm::dvec3& center, double radius);
  void SetImage(const ImageState& image, int number);
  Error UpdateScattering(vtkRenderer* renderer,
    const std::vector<ScatteringUpdater::Volume>& volumes, int lightSamples,
    const VolumeResources* other);
  Error Upload(vtkOpenGLRenderWindow* window);
  ///@}

  ScatteringUpdater::Volume GetScatteringVolume() const;
  SlicePlan::SlicedVolume GetSlicedVolume() const;
  SliceTextures& GetTextures(vtkWindow* window);
  vtkIdType GetTextureBytes() const;

  /// Adds the volume's multiply scattered light to the scene, so that it lights the surfaces there.
  /// Call Upload first. Returns false if the volume has no multiply scattered light.
  bool AddScatteredLight(vtkOpenGLRenderWindow* window);

  /// Sets the report to \a shared, the values of all volumes, and adds \a features and the other
  /// values of this volume.
  void SetReport(const SliceReport& shared, const std::string& features);

  /// Returns true if UpdateData has nothing to compute for the request.
  bool IsCurrent() const;

  /// Copies the report of another volume, which was drawn instead of this one.
  void CopyReport(const VolumeResources& other) { this->Report = other.Report; }

  /// Sets the report to the report of the previous image, which is shown again without any passes.
  void ReuseReport();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct WindowResources;

  bool HasCurrentSamples() const;
  /// Returns the inputs of the material.
  std::vector<double> MakeMaterialKey() const;
  Error UpdateSamples();
  Error UpdateMaterial();

  Request CurrentRequest;
  Result Results;
  SliceReport Report;
  SliceReport PreviousReport;
  VolumeRenderState State;
  /// Inputs from which the samples and the material were last computed, to detect changes.
  vtkDataArray* Scalars = nullptr;
  vtkMTimeType SamplesTime = 0;
  bool IsWidened = false;
  const void* MaterialOwner = nullptr;
  std::vector<double> MaterialKey;
  ScatteringUpdater Scatterer;
  int SamplesVersion = 0;
  int MaterialVersion = 0;
  /// Number of bytes uploaded for the current image.
  vtkIdType UploadedBytes = 0;
  std::map<vtkWindow*, std::unique_ptr<WindowResources>> Windows;
};

}

#endif
