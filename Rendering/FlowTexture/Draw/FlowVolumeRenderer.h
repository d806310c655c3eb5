// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowVolumeRenderer_h
#define interlume_FlowVolumeRenderer_h

#include "Draw/FlowLights.h"
#include "Draw/FlowPaints.h"
#include "Draw/FlowView.h"
#include "Grid/FlowGrid.h"

#include "vtkImplicitFlowVolumeReport.h"
#include "vtkImplicitFlowVolumeSettings.h"

#include <map>
#include <memory>
#include <string>

class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;
class vtkVolume;
class vtkWindow;

namespace interlume
{

class FlowShader;
class FlowTextures;

/**
 * @class   FlowVolumeRenderer
 * @brief   makes the changed parts of a picture of an implicit flow field and draws it
 */
class FlowVolumeRenderer
{
public:
  /// What a picture is asked for: the mapper's input, its settings and those of its superclasses.
  struct Request
  {
    vtkImageData* Image = nullptr;
    vtkImplicitFlowVolumeSettings Settings;
    FlowView::Cuts Cuts;
  };

  FlowVolumeRenderer();
  ~FlowVolumeRenderer();

  /// Draws a picture. Returns what is wrong, or nothing; then nothing is drawn.
  std::string Render(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
    vtkImplicitFlowVolumeReport& report);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct WindowResources;
  struct Picture;

  std::string UpdateGrid(const Request& request);
  std::string FindArrays(Picture& picture);
  std::string Update(Picture& picture);
  std::string KeepTextures(Picture& picture);
  std::string KeepGrid(Picture& picture);
  std::string KeepPaints(Picture& picture);
  std::string KeepArrays(Picture& picture);
  std::string Draw(Picture& picture);
  void SetUniforms(const Picture& picture, vtkShaderProgram* program) const;
  void SetViewUniforms(const Picture& picture, vtkShaderProgram* program) const;

  FlowGrid Grid;
  std::pair<const void*, vtkMTimeType> GridStamp{ nullptr, 0 };
  std::string GridError;
  vtkMTimeType GridVersion = 0;
  FlowPaints Paints;
  FlowView View;
  FlowLights Lights;
  std::map<vtkWindow*, std::unique_ptr<WindowResources>> Windows;
};

}

#endif
