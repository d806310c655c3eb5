// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowVolumeRenderer_h
#define interlume_FlowVolumeRenderer_h

#include "Draw/FlowPicture.h"

#include "vtkImplicitFlowVolumeReport.h"

#include <map>
#include <memory>
#include <string>

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

  /// Draws an image of \a image, as the mapper is set. Returns an error message, or an empty string
  /// on success; nothing is drawn otherwise.
  std::string Render(vtkRenderer* renderer, vtkVolume* volume, vtkImplicitFlowVolumeMapper& mapper,
    vtkImageData* image, vtkImplicitFlowVolumeReport& report);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct WindowResources;

  std::string UpdateGrid(vtkImageData* image);
  std::string FindArrays(FlowPicture& picture);
  std::string Update(FlowPicture& picture);
  std::string Draw(FlowPicture& picture, WindowResources& resources);
  /// Frees what slices have in a window while no light asks, or all of it where none is asked for.
  void ReleaseSlices(vtkOpenGLRenderWindow* window, bool isAsked);
  std::string DrawSlices(FlowPicture& picture, WindowResources& resources);

  FlowScene Scene;
  std::pair<const void*, vtkMTimeType> GridStamp{ nullptr, 0 };
  std::string GridError;
  std::map<vtkWindow*, std::unique_ptr<WindowResources>> Windows;
  /// Null where shadows are off.
  std::unique_ptr<FlowSlices> Slices;
};

}

#endif
