// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowDrawing_h
#define FlowDrawing_h

#include "Support/Pictures/FlowPictures.h"

class vtkImplicitFlowVolumeMapper;
class vtkVolumeProperty;

namespace reference
{

/// The mapper's picture of voxels with the scene's camera and unit distance.
RgbaPicture DrawFlow(vtkImplicitFlowVolumeMapper* mapper, vtkImageData* voxels,
  const FlowScene& scene, vtkVolumeProperty* property = nullptr);

/// Voxels of two termination surfaces, 0 and 8, with the arrays Speed, and Ways of three
/// components.
vtkSmartPointer<vtkImageData> MakeTwoFlows();

/// Paint whose red goes up and down along u, \a frequency radians in all.
vtkSmartPointer<vtkImageData> MakeStripes(double frequency, double alpha);

}

#endif
