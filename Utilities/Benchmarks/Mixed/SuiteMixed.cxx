// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Mixed/MixedParts.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeMixedSuite()
{
  return { "mixed",
    "vtkShadowedScenePass: error and time of surfaces and volumes under the same lights",
    { "Times are those of one frame, off-screen, until OpenGL says it is done; the camera turns by "
      "half a degree from frame to frame, and all methods take turns, each in a window of its own. "
      "\"light moves\": lights turn as well, by a fifth of a degree, so that depth maps are drawn "
      "for each frame.",
      "slab: a box behind, within, across and before a slab of smoke between light and plane, "
      "under light against the eye's direction, from a lamp, and with a second slab that overlaps "
      "the first; pictures in a float framebuffer against a ray caster in double precision. "
      "flat_p95 is the difference below which 95 % of the pixels away from edges are. edges: with "
      "depth maps (the parameter is their resolution) of which a texel is four pixels wide; "
      "edge_texels is how far edges are from their places in the mean.",
      "posts: surfaces alone under a spotlight, beside vtkShadowMapPass with depth maps of the "
      "same resolution, the parameter; both against the ray caster.",
      "posts, round light: soft shadows of surfaces; the parameter is NumberOfLightSamples, the "
      "peer the light without its extent, both moving, and the ray caster follows 400 rays to the "
      "light from each pixel.",
      "bonsai, smoke: balls of a million triangles (the parameter) around a volume; the peer is "
      "the time of the volume alone plus twice that of the actors, each drawn by VTK without a "
      "pass.",
      "views, lights: pictures a degree apart, over as many degrees as the parameter says. The "
      "error is the largest distance of a picture's mean from the middle of its neighbours', over "
      "the mean of all; change_* is that of the largest change of a pixel from one picture to the "
      "next." },
    { mixed::MakeErrorPart(), mixed::MakeMapPart(), mixed::MakeSoftPart(), mixed::MakeCostPart(),
      mixed::MakeTurnPart() } };
}
