// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowVolumeRenderer_h
#define interlume_FlowVolumeRenderer_h

#include "Common/Error.h"
#include "Draw/FlowPicture.h"

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
 * @brief   makes the changed parts of a picture of an implicit flow field and draws it
 */
class FlowVolumeRenderer
{
public:
  FlowVolumeRenderer();
  ~FlowVolumeRenderer();

  /// Draws an image of \a image, as the mapper is set. Returns an error if nothing can be drawn.
  Error Render(vtkRenderer* renderer, vtkVolume* volume, vtkImplicitFlowVolumeMapper& mapper,
    vtkImageData* image, FlowVolumeRenderReport& report);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct WindowResources;

  Error UpdateGrid(vtkImageData* image);
  Error FindArrays(FlowPicture& picture);
  Error Update(FlowPicture& picture);
  Error Draw(FlowPicture& picture, WindowResources& resources);
  /// Frees what slices have in a window while no light asks, or all of it where none is asked for.
  void ReleaseSlices(vtkOpenGLRenderWindow* window, bool isAsked);
  Error DrawSlices(FlowPicture& picture, WindowResources& resources);

  FlowScene Scene;
  std::pair<const void*, vtkMTimeType> GridStamp{ nullptr, 0 };
  Error GridError;
  std::map<vtkWindow*, std::unique_ptr<WindowResources>> Windows;
  /// Null where shadows are off.
  std::unique_ptr<FlowSlices> Slices;
};

}

#endif
