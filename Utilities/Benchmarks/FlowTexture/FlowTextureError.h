// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowTextureError_h
#define FlowTextureError_h

#include "Benchmarks/Approximations/Approximation.h"

namespace approximations
{
/// vtkImplicitFlowVolumeMapper by the number of voxels, with and without PaintFilter.
Family MakeFlowVoxelFamily();
}

#endif
