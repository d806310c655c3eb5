// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowTextureError_h
#define FlowTextureError_h

#include "Benchmarks/Approximations/Approximation.h"

namespace approximations
{
/// Returns the family that measures vtkImplicitFlowVolumeMapper with several resolutions of the
/// flow field, and with TextureFilter on and off.
Family MakeFlowVoxelFamily();
}

#endif
