// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowPicture_h
#define interlume_FlowPicture_h

#include "Draw/FlowLights.h"
#include "Draw/FlowPaints.h"
#include "Draw/FlowShader.h"
#include "Draw/FlowView.h"
#include "Draw/FlowVolumeRenderReport.h"
#include "Grid/FlowGrid.h"

#include <array>

class vtkDataArray;
class vtkImageData;
class vtkImplicitFlowVolumeMapper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkVolume;

namespace interlume
{

/**
 * @class   FlowScene
 * @brief   what pictures of an implicit flow field are made of
 */
struct FlowScene
{
  FlowGrid Grid;
  /// Grows when the grid changes.
  vtkMTimeType GridVersion = 0;
  FlowPaints Paints;
  FlowView View;
  FlowLights Lights;
};

/**
 * @class   FlowPicture
 * @brief   what one picture is asked for, and what was found for it
 */
struct FlowPicture
{
  vtkRenderer* Renderer;
  vtkOpenGLRenderWindow* Window;
  vtkVolume* Volume;
  /// The mapper, whose settings are read, and its input.
  vtkImplicitFlowVolumeMapper& Mapper;
  vtkImageData* Image;
  FlowVolumeRenderReport& Report;

  std::array<int, 2> Size{};
  bool HasShadows = false;
  FlowShader::Parts Parts{};
  vtkDataArray* OpacityValues = nullptr;
  vtkDataArray* ShadingValues = nullptr;
  std::array<int, 3> DetailSize{ { 1, 1, 1 } };
  std::array<double, 2> TransferRange{ { 0.0, 1.0 } };
  double SampleDistance = 1.0;
};

}

#endif
