// SPDX-License-Identifier: BSD-3-Clause
#ifndef GpuShadows_h
#define GpuShadows_h

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkVersion.h"

/**
 * The volumetric shadows of vtkGPUVolumeRayCastMapper, which came with VTK 9.2.
 */
namespace shadows
{
/// Whether this VTK has them.
constexpr bool HasGpuShadows()
{
  return VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0);
}

/// Shadow rays from each sample through the whole volume (GlobalIlluminationReach 1) and nothing
/// else of the mapper's shading (VolumetricScatteringBlending 2); without effect before 9.2.
inline void CastGpuShadows([[maybe_unused]] vtkGPUVolumeRayCastMapper* mapper)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  mapper->SetGlobalIlluminationReach(1.0f);
  mapper->SetVolumetricScatteringBlending(2.0f);
#endif
}
}

#endif
