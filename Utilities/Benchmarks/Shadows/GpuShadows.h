// SPDX-License-Identifier: BSD-3-Clause
#ifndef GpuShadows_h
#define GpuShadows_h

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkVersion.h"

/**
 * Volumetric shadows of vtkGPUVolumeRayCastMapper, available in VTK 9.2 and later.
 */
namespace shadows
{
/// Returns true if this VTK version has volumetric shadows.
constexpr bool HasGpuShadows()
{
  return VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0);
}

/// Enables shadow rays from each sample through the full volume (GlobalIlluminationReach 1) without
/// gradient shading (VolumetricScatteringBlending 2). Has no effect before VTK 9.2.
inline void EnableGpuShadows([[maybe_unused]] vtkGPUVolumeRayCastMapper* mapper)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  mapper->SetGlobalIlluminationReach(1.0f);
  mapper->SetVolumetricScatteringBlending(2.0f);
#endif
}
}

#endif
