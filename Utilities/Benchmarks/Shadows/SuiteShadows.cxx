// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Shadows/ShadowsParts.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeShadowsSuite()
{
  return { "shadows", "vtkShadowedSliceMapper: cost of lights and shadows, error against run time",
    { "One frame, off-screen, until OpenGL says it is done, on the device that the counts name. "
      "The camera turns by half a degree from frame to frame. Each method has a window of its own, "
      "so that nothing but the frame is made when they take turns. The parameter is the number of "
      "directional lights, all on the viewer's side (but for \"both sides\") and together of "
      "intensity 1. shadows-off: the same lights without shadows. unlit: Shade and shadows off, "
      "one light in the scene, against no-lights, no light in the scene. gpu is "
      "vtkGPUVolumeRayCastMapper with a sample each voxel and Shade on; gpu-shadows is the same "
      "with volumetric shadows of full reach (from VTK 9.2 on).",
      "Error against run time: pictures of one light in a float framebuffer against a ray marcher "
      "in double precision that follows a ray to the light from every sample. \"scattering\": "
      "every part of the matter scatters light evenly, C = c kd I T, without ambient light and "
      "surfaces; vtkShadowedSliceMapper draws this with Shade off and gpu-shadows with "
      "VolumetricScatteringBlending 2 and GlobalIlluminationReach 1, so that both mean the same "
      "picture. \"shaded\": equation 2.6, which gpu-shadows does not have. spacing: the parameter "
      "is the distance of slices over the default one; buffer: the size of the light's buffer; "
      "gpu-shadows: the distance of samples in voxels, along view and shadow rays alike. The "
      "second norm is the difference from the same mapper's own picture with slices at an eighth "
      "of the default distance and a buffer of 512^2, or samples every quarter of a voxel. "
      "equal-error: the time of the default, and the time of gpu-shadows where a straight line "
      "between its points in the log-log plot has the same error.",
      "surfaces: sharp ones, at the mapper's own settings. Cube and plates against closed forms, "
      "all else by scattered light against the ray marcher; the difference of a pixel's red, over "
      "the pixels that show anything: mean, p95, largest, rms over the mean of what is expected; "
      "brightness is the picture's mean over that, less 1." },
    { shadows::MakeSpeedPart(), shadows::MakeErrorPart(), shadows::MakeSurfacePart() } };
}
