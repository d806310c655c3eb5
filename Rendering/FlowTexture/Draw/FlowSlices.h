// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowSlices_h
#define interlume_FlowSlices_h

#include "Common/Error.h"

#include "vtkNew.h"
#include "vtkSliceMatter.h"
#include "vtkType.h"

#include <string>

class vtkImageData;
class vtkRenderer;
class vtkShadowedSliceMapper;
class vtkVolume;
class vtkWindow;

namespace interlume
{

class FlowTextures;
struct FlowPicture;
struct FlowScene;

/**
 * @class   FlowSlices
 * @brief   draws an implicit flow field in slices, with the shadows that its paint casts
 *
 * The matter of a vtkShadowedSliceMapper is what is painted; its scalars are 1 at voxels that
 * reached a surface and 0 elsewhere.
 */
class FlowSlices : public vtkSliceMatter
{
public:
  FlowSlices();
  ~FlowSlices() override;

  /// Returns whether a light of the renderer casts shadows: it is switched on and has a
  /// ShadowAttenuation above 0.
  static bool IsAsked(vtkRenderer* renderer);

  /// Draws an image, whose textures have been sent. Returns the errors and warnings that the mapper
  /// of slices reports.
  Error Draw(FlowPicture& picture, const FlowScene& scene, FlowTextures& textures);

  std::string GetSource() const override;
  bool HasReflection() const override;
  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;
  void ReportFault(const std::string& text) override { this->Reported = text; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void MakeReached();
  void Set();

  vtkNew<vtkImageData> Reached;
  vtkMTimeType ReachedVersion = 0;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkShadowedSliceMapper> Mapper;
  Error Reported;
  /// What is being drawn.
  FlowPicture* Picture = nullptr;
  const FlowScene* Scene = nullptr;
  FlowTextures* Textures = nullptr;
};

}

#endif
