// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowVolumeRenderer_h
#define interlume_FlowVolumeRenderer_h

#include "Common/Error.h"
#include "Draw/FlowRenderFrame.h"

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

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct WindowResources;

  Error UpdateGrid(vtkImageData* image);
  Error FindArrays(FlowRenderFrame& pass);
  Error Update(FlowRenderFrame& pass);
  Error Draw(FlowRenderFrame& pass, WindowResources& resources);
  /// Releases the resources of Slices in a window or, if shadows are off, Slices itself.
  void ReleaseSlices(vtkOpenGLRenderWindow* window, bool hasShadows);
  Error DrawSlices(FlowRenderFrame& pass, WindowResources& resources);

  FlowRenderState Scene;
  std::pair<const void*, vtkMTimeType> GridStamp{ nullptr, 0 };
  Error GridError;
  std::map<vtkWindow*, std::unique_ptr<WindowResources>> Windows;
  /// Null if shadows are off.
  std::unique_ptr<FlowSlices> Slices;
};

}

#endif
