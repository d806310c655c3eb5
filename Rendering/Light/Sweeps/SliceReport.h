// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedSliceReport_h
#define vtkShadowedSliceReport_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <string> // for the features

/**
 * @class   vtkShadowedSliceReport
 * @brief   what vtkShadowedSliceMapper did in its last picture
 *
 * This is a plain value object. Counts of what was not done are 0; strings are empty before the
 * first picture.
 *
 * @sa vtkShadowedSliceMapper
 */
struct INTERLUMELIGHT_EXPORT vtkShadowedSliceReport
{
  /// The numbers of lights that shade the volume, and of those among them that cast shadows in it.
  int Lights = 0;
  int ShadowedLights = 0;
  /// The numbers of sweeps of slices through the volume, and of those among them from front to
  /// back. Lights on both sides of the volume, or one inside it, take more than one.
  int Sweeps = 0;
  int FrontToBackSweeps = 0;
  /// The numbers of slices over all sweeps and of those that meet a block that is not empty, and
  /// their distance in world units (that of the first sweep).
  int Slices = 0;
  int SlicesDrawn = 0;
  double SliceSpacing = 0.0;
  /// The numbers of passes over the picture's buffer, over light buffers, and to find what is
  /// already opaque.
  int EyePasses = 0;
  int LightPasses = 0;
  int OcclusionPasses = 0;
  /// The numbers of buffers of the picture and of lights (one for each that casts shadows), and
  /// their bytes.
  int ImageBuffers = 0;
  vtkIdType ImageBufferBytes = 0;
  int LightBuffers = 0;
  vtkIdType LightBufferBytes = 0;
  /// The number of columns and rows of the largest light buffer, and the number of channels of
  /// light that are attenuated, 1 or 3.
  int LightBufferSize = 0;
  int LightChannels = 0;
  /// The number of area lights that cast shadows, and the way, as the setting is called:
  /// `SampleLayers` (of SAMPLED_LIGHTS too in a vtkShadowedScenePass), `AccumulatedConvolution`,
  /// `SampledLights`; empty without soft shadows.
  int SoftLights = 0;
  std::string SoftShadowMethod;
  /// The number of those lights that shine from their centre alone, with hard shadows: they are
  /// inside the volume or too close, or too large, to be seen through planes.
  int HardLightsInstead = 0;
  /// The numbers of layers of samples of all lights, and of lights that stand for samples, of
  /// passes over layers and by convolution, and the bytes of what soft shadows have beside the
  /// light buffers.
  int LightLayers = 0;
  int SampledLights = 0;
  int SoftShadowPasses = 0;
  vtkIdType SoftShadowBytes = 0;
  /// The number of cells that light is scattered in on and on, of those among them that opaque
  /// surfaces of a vtkShadowedScenePass block, the bytes of what it is there, how often that was
  /// found since it is asked for (a picture that finds nothing new leaves the number as it is) and
  /// the seconds that this took the last time.
  int ScatteringCells = 0;
  int ScatteringBlockedCells = 0;
  vtkIdType ScatteringBytes = 0;
  int ScatteringSolves = 0;
  double ScatteringSeconds = 0.0;
  /// The names of the parts of the shaders that were compiled in, separated by spaces. Words of
  /// shadows (`shadow`, ...) stand there only when a light casts them.
  std::string Features;

  /// The numbers of blocks of the volume, and of those with something to see.
  int Blocks = 0;
  int BlocksDrawn = 0;
  /// The number of voxels with NaN or infinity, which are transparent.
  vtkIdType NonFiniteVoxels = 0;
  /// The bytes of textures of volume and transfer functions, of those sent for this picture, and of
  /// the slices' triangles, which are sent for each picture.
  vtkIdType TextureBytes = 0;
  vtkIdType UploadedBytes = 0;
  vtkIdType TriangleBytes = 0;
  /// The number of pixels of the viewport for each pixel of the picture, along an edge.
  double ImageSampleDistance = 1.0;
  /// The seconds that this picture took, until the graphics card was done where the mapper measures
  /// that.
  double Seconds = 0.0;

  void Print(ostream& os, vtkIndent indent) const;
};

#endif
