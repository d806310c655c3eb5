// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowDrawing_h
#define FlowDrawing_h

#include "Pictures/FlowPictures.h"

class vtkImplicitFlowVolumeMapper;
class vtkVolumeProperty;

namespace reference
{

/// The mapper's picture of voxels with the scene's camera and unit distance.
RgbaPicture DrawFlow(vtkImplicitFlowVolumeMapper* mapper, vtkImageData* voxels,
  const FlowScene& scene, vtkVolumeProperty* property = nullptr);

}

#endif
