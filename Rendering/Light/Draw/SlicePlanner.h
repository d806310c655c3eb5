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
 * @brief   plans the slices of an image from the shared settings
 */
class SlicePlanner
{
public:
  /// The spacing of slices along their normal, in voxels.
  static constexpr double AutomaticSpacing = 0.5;

  using States = std::vector<const VolumeRenderState*>;

  /**
   * Plans the image of volumes, with the eye, lights and scene of \a image. Area lights whose
   * shadows are not found by buffers of their own become lights of their samples. \a coarseness is
   * the factor of automatic spacings.
   */
  static void Make(ImageState& image, const States& states,
    const std::vector<SlicePlan::Matter>& volumes, const ImageSettings& asked, double coarseness,
    SliceReport& report);

  /// Returns the bytes of the buffers of the image and of its lights.
  static vtkIdType GetBufferBytes(const ImageState& image, const States& states);

  /// Returns the factor by which automatic spacings are made coarser, for a picture to take the
  /// time that is allocated, where the last one took so many seconds with a factor of its own.
  static double ChooseCoarseness(double seconds, double lastCoarseness, double allocated);
};

}

#endif
