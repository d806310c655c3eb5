// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowRenderFrame_h
#define interlume_FlowRenderFrame_h

#include "Draw/FlowLights.h"
#include "Draw/SurfacePaintTextures.h"
#include "Draw/FlowShader.h"
#include "Draw/FlowViewRays.h"
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
 * @class   FlowRenderState
 * @brief   state for rendering an implicit flow field, cached between frames
 */
struct FlowRenderState
{
  FlowGrid Grid;
  /// Incremented when the grid changes.
  vtkMTimeType GridVersion = 0;
  SurfacePaintTextures Paints;
  FlowViewRays View;
  FlowLights Lights;
};

/**
 * @class   FlowRenderFrame
 * @brief   inputs and derived values of one frame
 */
struct FlowRenderFrame
{
  vtkRenderer* Renderer;
  vtkOpenGLRenderWindow* Window;
  vtkVolume* Volume;
  /// The mapper, which provides the settings, and its input.
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
  /// Factor for the distances between pixels and samples; above 1 in coarse passes of a progressive
  /// image.
  double Coarseness = 1.0;
  /// Number of horizontal bands in which the image is drawn. Between them, it can be aborted.
  int Bands = 1;
};

}

#endif
