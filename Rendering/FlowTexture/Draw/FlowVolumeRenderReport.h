// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowVolumeRenderReport_h
#define interlume_FlowVolumeRenderReport_h

#include "vtkType.h"

#include <string>

class vtkInterlumeReport;

namespace interlume
{

/**
 * @class   FlowVolumeRenderReport
 * @brief   values that vtkImplicitFlowVolumeMapper reports for its last frame
 *
 * Counts are 0 for stages that the frame skipped. Strings are empty before the first frame.
 */
struct FlowVolumeRenderReport
{
  /// Number of surfaces that samples reached, and number of these without a texture, drawn in
  /// DefaultColor.
  int Surfaces = 0;
  int SurfacesWithoutTexture = 0;
  /// UniformCells: cells whose corners all reached the same surface. SplitCells: cells at a border
  /// between surfaces, at a seam, or with some corners that reached no surface. EmptyCells: cells
  /// without a corner that reached a surface. UnwrappedParameters describes seams.
  vtkIdType UniformCells = 0;
  vtkIdType SplitCells = 0;
  vtkIdType EmptyCells = 0;
  /// Number of samples whose coordinates, time, OpacityArray or ShadingArray are not finite. They
  /// are drawn as if they had reached no surface, or with the value 0.
  vtkIdType NonFiniteSamples = 0;
  /// Names of the compiled shader features, separated by spaces. With shadows, they are listed
  /// after the features of vtkShadowedSliceMapper.
  std::string Features;
  /// Number of textures uploaded for this frame, by source.
  int GridUploads = 0;
  int InflowUploads = 0;
  int DetailUploads = 0;
  int GateUploads = 0;
  int TransferUploads = 0;
  int ArrayUploads = 0;
  vtkIdType UploadedBytes = 0;
  /// Number of textures, and memory of the textures and of the image buffers in bytes.
  int Textures = 0;
  vtkIdType TextureBytes = 0;
  vtkIdType ImageBufferBytes = 0;
  /// Number of ray casting passes: 1, or 0 with slices. The pass that displays the result is not
  /// counted.
  int Passes = 0;
  /// With shadows: number of lights that cast shadows, number of sweeps, number of slices, slice
  /// spacing in world units, number of light buffers, number of columns and rows of the largest
  /// light buffer, and memory of all light buffers in bytes. Otherwise 0.
  int ShadowedLights = 0;
  int Sweeps = 0;
  int Slices = 0;
  double SliceSpacing = 0.0;
  int LightBuffers = 0;
  int LightBufferSize = 0;
  vtkIdType LightBufferBytes = 0;
  /// Distance between samples along a view ray, in world units.
  double SampleDistance = 0.0;
  /// Number of viewport pixels per rendered pixel, in x and in y.
  double ImageSampleDistance = 1.0;
  /// Seconds from the start of the frame until all of its commands are sent to the GPU.
  double Seconds = 0.0;

  /// Replaces the contents of \a report with these values.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
