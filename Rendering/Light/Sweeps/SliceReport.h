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
 * @brief   statistics of the last frame of vtkShadowedSliceMapper
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
  /// Number of slices in all sweeps, number of these slices that intersect a visible block, and
  /// slice spacing of the first sweep in world units.
  int Slices = 0;
  int SlicesDrawn = 0;
  double SliceSpacing = 0.0;
  /// Number of passes that draw slices into the image buffer, number of passes that draw them into
  /// light buffers, and number of passes that mark opaque pixels.
  int ImagePasses = 0;
  int LightPasses = 0;
  int OcclusionPasses = 0;
  /// Number of image buffers and number of light buffers (one per light that casts shadows), each
  /// followed by their size in bytes.
  int ImageBuffers = 0;
  vtkIdType ImageBufferBytes = 0;
  int LightBuffers = 0;
  vtkIdType LightBufferBytes = 0;
  /// Number of columns and rows of the largest light buffer, and number of color channels of the
  /// light buffers: 1 or 3.
  int LightBufferSize = 0;
  int LightChannels = 0;
  /// Number of area lights that cast shadows, and the method that computes the shadows:
  /// `SampleLayers`, `AccumulatedConvolution` or `SampledLights`, or an empty string if there are
  /// no such lights. In a vtkShadowedScenePass, `SampleLayers` replaces `SampledLights`.
  int SoftShadowLights = 0;
  std::string SoftShadowMethod;
  /// Number of area lights that cast hard shadows from their center because they are inside the
  /// volume, too close to it, or too large for the method.
  int AreaLightsWithHardShadows = 0;
  /// Number of sample layers of all lights, number of lights that replace area lights if the method
  /// is `SampledLights`, number of passes that update sample layers or compute convolutions, and
  /// bytes that soft shadows require in addition to the light buffers.
  int LightLayers = 0;
  int SampledLights = 0;
  int SoftShadowPasses = 0;
  vtkIdType SoftShadowBytes = 0;
  /// For multiply scattered light: number of grid cells, number of cells blocked by opaque surfaces
  /// of a vtkShadowedScenePass, bytes of the textures, number of computations since it was enabled
  /// (excluding frames that reuse the result), and duration of the last computation in seconds.
  int ScatteringCells = 0;
  int ScatteringBlockedCells = 0;
  vtkIdType ScatteringBytes = 0;
  int ScatteringSolves = 0;
  double ScatteringSeconds = 0.0;
  /// Names of the features compiled into the shaders, separated by spaces, such as `shadow`.
  std::string Features;

  /// Number of blocks of the volume, and number of visible blocks.
  int Blocks = 0;
  int BlocksDrawn = 0;
  /// Number of voxels with NaN or infinity, which are transparent.
  vtkIdType NonFiniteVoxels = 0;
  /// Bytes of the textures of the volume and of the transfer functions, bytes of textures uploaded
  /// for this frame, and bytes of the slices' triangles, which are uploaded for each frame.
  vtkIdType TextureBytes = 0;
  vtkIdType UploadedBytes = 0;
  vtkIdType TriangleBytes = 0;
  /// Edge length of a pixel of the rendered image, in viewport pixels.
  double ImageSampleDistance = 1.0;
  /// Rendering time of this frame in seconds. It includes GPU time if AutoAdjustSampleDistances is
  /// on.
  double Seconds = 0.0;

  /// Replaces all values of \a report with these values.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
