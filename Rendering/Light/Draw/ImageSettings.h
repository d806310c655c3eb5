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
 * @brief   the settings that all volumes of an image share
 *
 * Of the settings of several volumes each is the one of highest quality and of least memory, as
 * vtkShadowedScenePass.h documents.
 */
struct ImageSettings
{
  /// Includes the settings of a volume.
  void Add(const vtkShadowedSliceSettings& settings);

  bool HasShadows = false;
  int MaximumNumberOfShadows = 0;
  bool IsSmoothLookup = false;
  double ImageSampleDistance = std::numeric_limits<double>::max();
  bool AutoAdjustSampleDistances = true;
  int NumberOfLightSamples = 1;
  int SoftShadowMethod = vtkShadowedSliceSettings::SAMPLED_LIGHTS;
  /// The size of light buffers, 0 if a volume leaves it open. LeastBufferSize bounds it then.
  int LightBufferSize = std::numeric_limits<int>::max();
  int LeastBufferSize = 0;
  vtkIdType MaximumTextureMemory = 0;
  bool HasColoredLight = false;
};

}

#endif
