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
 * @brief   values that vtkImplicitFlowVolumeMapper reports of its last image
 *
 * Counts of what was not done are 0. Strings are empty before the first image.
 */
struct FlowVolumeRenderReport
{
  /// The numbers of surfaces that samples reached, and of those without a texture, which have
  /// DefaultColor.
  int Surfaces = 0;
  int SurfacesWithoutTexture = 0;
  /// The numbers of cells with one surface at all corners, of cells between surfaces, across a seam
  /// or with a corner that reached nothing, and of cells with no corner that reached a surface.
  /// Coordinates continue past a period, so a seam is only where one direction around an axis meets
  /// the other.
  vtkIdType UniformCells = 0;
  vtkIdType SplitCells = 0;
  vtkIdType EmptyCells = 0;
  /// The number of samples with no finite coordinates or time, or with no finite value of
  /// OpacityArray or ShadingArray. They are drawn as having reached no surface, or with the value
  /// 0.
  vtkIdType NonFiniteSamples = 0;
  /// The names of the parts of the shader that were compiled in, separated by spaces; with shadows
  /// after those of slices.
  std::string Features;
  /// The numbers of textures uploaded for this image: of voxels and cells, of inflow, and each of
  /// the others.
  int GridUploads = 0;
  int InflowUploads = 0;
  int DetailUploads = 0;
  int GateUploads = 0;
  int TransferUploads = 0;
  int ArrayUploads = 0;
  vtkIdType UploadedBytes = 0;
  /// The number of textures, and the bytes of textures and of the image's buffers.
  int Textures = 0;
  vtkIdType TextureBytes = 0;
  vtkIdType ImageBufferBytes = 0;
  /// The number of passes over the image without the one that shows it: 1, or 0 with slices.
  int Passes = 0;
  /// With shadows: the numbers of lights that cast them, of sweeps and of slices, the distance of
  /// slices in world units, the number of light buffers, the columns and rows of the largest and
  /// the bytes of all. Otherwise 0.
  int ShadowedLights = 0;
  int Sweeps = 0;
  int Slices = 0;
  double SliceSpacing = 0.0;
  int LightBuffers = 0;
  int LightBufferSize = 0;
  vtkIdType LightBufferBytes = 0;
  /// The distance of samples along a line of sight in world units.
  double SampleDistance = 0.0;
  /// The number of pixels of the viewport per pixel of the image, along an edge.
  double ImageSampleDistance = 1.0;
  /// Seconds of this image, until the graphics card has its commands.
  double Seconds = 0.0;

  /// Replaces all values of a report.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
