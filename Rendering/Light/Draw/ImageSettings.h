// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageSettings_h
#define interlume_ImageSettings_h

#include "vtkShadowedSliceSettings.h"
#include "vtkType.h"

#include <limits>

namespace interlume
{

/**
 * @class   ImageSettings
 * @brief   settings shared by all volumes of a rendered image
 *
 * If the volumes' settings differ, the highest quality and the lowest memory limit apply; see
 * vtkShadowedScenePass.h.
 */
struct ImageSettings
{
  /// Merges the settings of a volume into these settings.
  void Add(const vtkShadowedSliceSettings& settings);
  /// Reduces slices, light buffers and light samples for the first passes of a progressive image.
  /// \a coarseness is above 1.
  void Coarsen(double coarseness);

  bool HasShadows = false;
  int MaximumNumberOfShadowLights = 0;
  bool IsSmoothLookup = false;
  double ImageSampleDistance = std::numeric_limits<double>::max();
  bool AutoAdjustSampleDistances = true;
  int NumberOfLightSamples = 1;
  int SoftShadowMethod = vtkShadowedSliceSettings::SAMPLED_LIGHTS;
  /// Number of columns and rows of light buffers, or 0 if any volume requests an automatic size.
  /// MinimumBufferSize is then a lower bound.
  int LightBufferSize = std::numeric_limits<int>::max();
  int MinimumBufferSize = 0;
  vtkIdType MaximumTextureMemory = 0;
  bool HasColoredLight = false;
  /// Factor for the slice spacings that volumes set, and divisor for the number of texels per voxel
  /// of automatic light buffers.
  double Coarseness = 1.0;
};

}

#endif
