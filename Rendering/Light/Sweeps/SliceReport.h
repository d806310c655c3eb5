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
 * @brief   counts the work of vtkShadowedSliceMapper for its last frame
 *
 * Counters of skipped work are 0.
 */
struct SliceReport
{
  /// Number of lights that shade the volume, and number of lights that cast shadows in it.
  int Lights = 0;
  int ShadowedLights = 0;
  /// Number of sweeps of slices through the volume, and number of front-to-back sweeps. Lights on
  /// both sides of the volume, or a light inside it, require more than one sweep.
  int Sweeps = 0;
  int FrontToBackSweeps = 0;
  /// Number of slices of all sweeps, number of slices that intersect a nonempty block, and slice
  /// spacing of the first sweep in world units.
  int Slices = 0;
  int SlicesDrawn = 0;
  double SliceSpacing = 0.0;
  /// Number of passes over the image buffer, over light buffers, and to find opaque samples.
  int ImagePasses = 0;
  int LightPasses = 0;
  int OcclusionPasses = 0;
  /// Number of image buffers and light buffers (one per light that casts shadows), and their bytes.
  int ImageBuffers = 0;
  vtkIdType ImageBufferBytes = 0;
  int LightBuffers = 0;
  vtkIdType LightBufferBytes = 0;
  /// Columns and rows of the largest light buffer, and number of attenuated color channels, 1 or 3.
  int LightBufferSize = 0;
  int LightChannels = 0;
  /// Number of area lights that cast shadows, and the method, named after the setting:
  /// `SampleLayers` (also for SAMPLED_LIGHTS in a vtkShadowedScenePass), `AccumulatedConvolution`
  /// or `SampledLights`. The method is empty if there are no soft shadows.
  int SoftShadowLights = 0;
  std::string SoftShadowMethod;
  /// Number of area lights with hard shadows from their center. They are inside the volume, too
  /// close, or too large for the method.
  int AreaLightsWithHardShadows = 0;
  /// Number of sample layers of all lights, of lights that represent samples, and of passes over
  /// layers or for convolution. Bytes for soft shadows in addition to the light buffers.
  int LightLayers = 0;
  int SampledLights = 0;
  int SoftShadowPasses = 0;
  vtkIdType SoftShadowBytes = 0;
  /// Number of grid cells of multiply scattered light, and number of cells blocked by opaque
  /// surfaces of a vtkShadowedScenePass. Bytes for this light. Number of computations since the
  /// settings enabled it; a frame that reuses the light does not count. Duration of the last
  /// computation in seconds.
  int ScatteringCells = 0;
  int ScatteringBlockedCells = 0;
  vtkIdType ScatteringBytes = 0;
  int ScatteringSolves = 0;
  double ScatteringSeconds = 0.0;
  /// Names of the compiled parts of the shaders, separated by spaces. Names of shadow features
  /// (`shadow`, ...) are included only if a light casts shadows.
  std::string Features;

  /// Number of blocks of the volume, and number of visible blocks.
  int Blocks = 0;
  int BlocksDrawn = 0;
  /// Number of voxels with NaN or infinity, which are transparent.
  vtkIdType NonFiniteVoxels = 0;
  /// Bytes of the textures of the volume and of transfer functions, bytes uploaded for this frame,
  /// and bytes of the slices' triangles, which are uploaded for each frame.
  vtkIdType TextureBytes = 0;
  vtkIdType UploadedBytes = 0;
  vtkIdType TriangleBytes = 0;
  /// Size of a pixel of the rendered image in viewport pixels, along an edge.
  double ImageSampleDistance = 1.0;
  /// Duration of this frame in seconds. With AutoAdjustSampleDistances it includes GPU time.
  double Seconds = 0.0;

  /// Replaces all values of \a report by these values.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
