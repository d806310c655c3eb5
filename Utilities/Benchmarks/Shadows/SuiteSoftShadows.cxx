// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Shadows/ShadowsParts.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeSoftShadowsSuite()
{
  return { "soft-shadows", "vtkAreaLight: error of soft shadows against run time",
    { "One frame of vtkShadowedSliceMapper, off-screen, until OpenGL says it is done, with one "
      "round, positional area light, as wide as a diagonal of the volume and 1.5 of them from its "
      "middle. Every part of the matter scatters light evenly. The camera turns by half a degree "
      "from frame to frame; all methods take turns. processor_seconds are those of all threads; "
      "over_hard and equal times are by them.",
      "Error: pictures in a float framebuffer against the same mapper's with each of 256 samples "
      "of the light as a light of its own (32 in quick runs), the mean of pictures of sixteen, "
      "slices at half the default distance and a light buffer of 256^2 (128^2). sample-layers, the "
      "default, and sampled-lights: the parameter is the number of samples. "
      "accumulated-convolution, the published method: the parameter is the distance of slices over "
      "the default one. \", buffer\": it is the size of the light's buffer. refined: the default "
      "with samples and buffer times the parameter, and the distance of slices over it. hard: the "
      "light without its extent. equal-time: the default, against the convolution's smallest error "
      "in at most its time, or its fastest setting where all take longer." },
    { shadows::MakeSoftShadowPart() } };
}
