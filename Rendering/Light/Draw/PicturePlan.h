// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PicturePlan_h
#define interlume_PicturePlan_h

#include "Draw/SliceFrame.h"

#include "vtkShadowedSliceReport.h"
#include "vtkShadowedSliceSettings.h"
#include "vtkType.h"

#include <vector>

namespace interlume
{

/**
 * @class   PicturePlan
 * @brief   plans a picture of slices from settings of the mapper
 */
class PicturePlan
{
public:
  /// The spacing of slices along their normal, in voxels.
  static constexpr double AutomaticSpacing = 0.5;

  /**
   * Plans the picture of volumes that share slices, with the eye, lights and scene of \a frame.
   * Area lights whose shadows are not found by buffers of their own become lights of their samples.
   * \a coarseness is the factor of automatic spacings; buffers of automatic size have so many
   * columns or more.
   */
  static void Make(SliceFrame& frame, const std::vector<SlicePlan::Matter>& matter,
    const vtkShadowedSliceSettings& asked, double coarseness, vtkShadowedSliceReport& report,
    int leastBufferSize = 0);

  /// Returns the bytes of the buffers of the picture and of lights of volumes that share slices.
  static vtkIdType GetBufferBytes(const std::vector<const SliceFrame*>& frames);

  /// Returns the factor by which automatic spacings are made coarser, for a picture to take the
  /// time that is allocated, where the last one took so many seconds with a factor of its own.
  static double ChooseCoarseness(double seconds, double lastCoarseness, double allocated);
};

}

#endif
