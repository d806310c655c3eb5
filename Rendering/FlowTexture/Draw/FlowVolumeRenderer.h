// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowVolumeRenderer_h
#define interlume_FlowVolumeRenderer_h

#include "Common/Error.h"
#include "Draw/FlowRenderFrame.h"
#include "Refinement/ImageRefinement.h"
#include "Refinement/PassTimes.h"

#include <map>
#include <memory>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkWindow;

namespace interlume
{

class FlowSlices;

/**
 * @class   FlowVolumeRenderer
 * @brief   draws frames of an implicit flow field, updating only the data that have changed
 */
class FlowVolumeRenderer
{
public:
  FlowVolumeRenderer();
  ~FlowVolumeRenderer();

  /// Draws the flow field \a image with the settings of the mapper. Returns an error if it cannot
  /// be drawn.
  Error Render(vtkRenderer* renderer, vtkVolume* volume, vtkImplicitFlowVolumeMapper& mapper,
    vtkImageData* image, FlowVolumeRenderReport& report);

  /// Returns true if the last frame was not final.
  bool IsRefinementPending() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct WindowResources;

  Error UpdateGrid(vtkImageData* image);
  Error FindArrays(FlowRenderFrame& pass);
  Error Update(FlowRenderFrame& pass);
  Error Draw(FlowRenderFrame& pass, WindowResources& resources);
  /// Casts the view rays. Returns false if the frame was aborted.
  bool DrawRays(FlowRenderFrame& pass, WindowResources& resources, const FlowShader& shader);
  /// Begins a pass of a progressive image. Returns false if the last image is to be shown again.
  bool BeginPass(FlowRenderFrame& pass);
  /// Updates the data and draws the frame, or shows the last image again.
  Error DrawPass(FlowRenderFrame& pass, WindowResources& resources);
  /// Ends a complete pass that began at \a start.
  void EndPass(const FlowRenderFrame& pass, double start);
  /// Releases the resources of Slices in a window or, if shadows are off, Slices itself.
  void ReleaseSlices(vtkOpenGLRenderWindow* window, bool hasShadows);
  Error DrawSlices(FlowRenderFrame& pass, WindowResources& resources);

  FlowRenderState Scene;
  std::pair<const void*, vtkMTimeType> GridStamp{ nullptr, 0 };
  Error GridError;
  std::map<vtkWindow*, std::unique_ptr<WindowResources>> Windows;
  /// Null if shadows are off.
  std::unique_ptr<FlowSlices> Slices;
  /// If true, the last frame was drawn in slices.
  bool HasSlices = false;
  /// Passes of progressive images without shadows, their times, and the report of the last pass.
  ImageRefinement Refinement;
  PassTimes Times;
  FlowVolumeRenderReport PassReport;
};

}

#endif
