// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlicePlanner_h
#define interlume_SlicePlanner_h

#include "Plan/SlicePlan.h"

#include "vtkType.h"

#include <vector>

namespace interlume
{

struct ImageSettings;
struct ImageState;
struct SliceReport;
struct VolumeRenderState;

/**
 * @class   SlicePlanner
 * @brief   creates the slice plan of an image from the volumes' shared settings
 */
class SlicePlanner
{
public:
  /// Automatic slice spacing, in voxels.
  static constexpr double AutomaticSpacing = 0.5;

  using States = std::vector<const VolumeRenderState*>;

  /**
   * Plans the slices of \a volumes for \a image, whose camera, lights and scene must be set. With
   * the soft-shadow method SAMPLED_LIGHTS and no scene, each area light with shadows is replaced by
   * one light per sample. \a coarseness multiplies automatic slice spacings.
   */
  static void Make(ImageState& image, const States& states,
    const std::vector<SlicePlan::SlicedVolume>& volumes, const ImageSettings& shared,
    double coarseness, SliceReport& report);

  /// Returns the size of the image and light buffers in bytes.
  static vtkIdType GetBufferBytes(const ImageState& image, const States& states);
};

}

#endif
