// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkImplicitFlowVolumeReport_h
#define vtkImplicitFlowVolumeReport_h

#include "InterlumeFlowTextureModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <string> // for the features

/**
 * @class   vtkImplicitFlowVolumeReport
 * @brief   what vtkImplicitFlowVolumeMapper did in its last picture
 *
 * This is a plain value object. Counts of what was not done are 0; strings are empty before the
 * first picture.
 *
 * @sa vtkImplicitFlowVolumeMapper
 */
struct INTERLUMEFLOWTEXTURE_EXPORT vtkImplicitFlowVolumeReport
{
  /// The numbers of surfaces that samples reached, and of those among them without a texture, which
  /// have DefaultColor.
  int Surfaces = 0;
  int SurfacesWithoutTexture = 0;
  /// The numbers of cells with one surface at all corners, of cells between surfaces, over a seam
  /// or where nothing was reached at a corner, and of cells with nothing reached at all. Places go
  /// on beyond a period, so that a seam is only where one way round an axis meets the other.
  vtkIdType UniformCells = 0;
  vtkIdType SplitCells = 0;
  vtkIdType EmptyCells = 0;
  /// The number of samples with no finite place or time, or with no finite value of OpacityArray or
  /// ShadingArray. They are drawn as having reached no surface, or with the value 0.
  vtkIdType NonFiniteSamples = 0;
  /// The names of the parts of the shader that were compiled in, separated by spaces; with shadows
  /// those of slices stand before them.
  std::string Features;
  /// The number of textures of voxels and cells that were sent for this picture, of inflow
  /// textures, and of each of the others.
  int GridUploads = 0;
  int InflowUploads = 0;
  int DetailUploads = 0;
  int GateUploads = 0;
  int TransferUploads = 0;
  int ArrayUploads = 0;
  vtkIdType UploadedBytes = 0;
  /// The numbers of textures and their bytes, and of the picture's buffers.
  int Textures = 0;
  vtkIdType TextureBytes = 0;
  vtkIdType ImageBufferBytes = 0;
  /// The number of passes over the picture: one, without the one that shows it; none where there
  /// are slices.
  int Passes = 0;
  /// With shadows: the numbers of lights that cast them, of sweeps and slices, these' distance in
  /// world units, the number of buffers of lights, the columns and rows of the largest and the
  /// bytes of all. Without them 0.
  int ShadowedLights = 0;
  int Sweeps = 0;
  int Slices = 0;
  double SliceSpacing = 0.0;
  int LightBuffers = 0;
  int LightBufferSize = 0;
  vtkIdType LightBufferBytes = 0;
  /// The distance of samples along a line of sight in world units.
  double SampleDistance = 0.0;
  /// The number of pixels of the viewport for each pixel of the picture, along an edge.
  double ImageSampleDistance = 1.0;
  /// The seconds that this picture took, until the graphics card has its commands.
  double Seconds = 0.0;

  void Print(ostream& os, vtkIndent indent) const;
};

#endif
