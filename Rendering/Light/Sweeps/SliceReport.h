// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceReport_h
#define interlume_SliceReport_h

#include "vtkType.h"

#include <string>

class vtkInterlumeReport;

namespace interlume
{

/**
 * @class   SliceReport
 * @brief   counts the work of vtkShadowedSliceMapper for its last image
 *
 * Counts of skipped work are 0.
 */
struct SliceReport
{
  /// The lights that shade the volume, and those of them that cast shadows in it.
  int Lights = 0;
  int ShadowedLights = 0;
  /// The sweeps of slices through the volume, and those of them from front to back. Lights on both
  /// sides of the volume, or a light inside it, require more than one.
  int Sweeps = 0;
  int FrontToBackSweeps = 0;
  /// The slices of all sweeps, those of them that intersect a block that is not empty, and the
  /// slice spacing of the first sweep in world units.
  int Slices = 0;
  int SlicesDrawn = 0;
  double SliceSpacing = 0.0;
  /// The passes over the image buffer, over light buffers, and to find opaque samples.
  int ImagePasses = 0;
  int LightPasses = 0;
  int OcclusionPasses = 0;
  /// The buffers of the image and of lights (one per light that casts shadows), and their bytes.
  int ImageBuffers = 0;
  vtkIdType ImageBufferBytes = 0;
  int LightBuffers = 0;
  vtkIdType LightBufferBytes = 0;
  /// The columns and rows of the largest light buffer, and the channels of light that are
  /// attenuated, 1 or 3.
  int LightBufferSize = 0;
  int LightChannels = 0;
  /// The area lights that cast shadows, and the method, named as the setting: `SampleLayers` (also
  /// for SAMPLED_LIGHTS in a vtkShadowedScenePass), `AccumulatedConvolution` or `SampledLights`;
  /// empty without soft shadows.
  int SoftShadowLights = 0;
  std::string SoftShadowMethod;
  /// The number of those lights that shine only from their center, with hard shadows: they are
  /// inside the volume, too close, or too large to be seen through planes.
  int AreaLightsWithHardShadows = 0;
  /// The sample layers of all lights, the lights that represent samples, the passes over layers and
  /// by convolution, and the bytes for soft shadows in addition to the light buffers.
  int LightLayers = 0;
  int SampledLights = 0;
  int SoftShadowPasses = 0;
  vtkIdType SoftShadowBytes = 0;
  /// The cells of multiply scattered light, those of them that opaque surfaces of a
  /// vtkShadowedScenePass block, the bytes of that light, how often it was computed since the
  /// settings request it (an image that reuses it does not count), and the seconds of the last
  /// computation.
  int ScatteringCells = 0;
  int ScatteringBlockedCells = 0;
  vtkIdType ScatteringBytes = 0;
  int ScatteringSolves = 0;
  double ScatteringSeconds = 0.0;
  /// The names of the compiled parts of the shaders, separated by spaces. Names of shadows
  /// (`shadow`, ...) are included only if a light casts them.
  std::string Features;

  /// The blocks of the volume, and those of them with something visible.
  int Blocks = 0;
  int BlocksDrawn = 0;
  /// The voxels with NaN or infinity, which are transparent.
  vtkIdType NonFiniteVoxels = 0;
  /// The bytes of the textures of volume and transfer functions, those of them uploaded for this
  /// image, and the bytes of the slices' triangles, which are uploaded for each image.
  vtkIdType TextureBytes = 0;
  vtkIdType UploadedBytes = 0;
  vtkIdType TriangleBytes = 0;
  /// The pixels of the viewport per pixel of the image, along an edge.
  double ImageSampleDistance = 1.0;
  /// The seconds of this image. With AutoAdjustSampleDistances this includes the work of the
  /// graphics card.
  double Seconds = 0.0;

  /// Replaces the values of a report.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
