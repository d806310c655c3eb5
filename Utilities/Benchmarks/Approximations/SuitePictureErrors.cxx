// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FamilySuite.h"
#include "Benchmarks/Approximations/PictureFamilies.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakePictureErrorsSuite()
{
  using namespace approximations;
  return MakeFamilySuite("picture-errors",
    "Mappers: error against time of a frame for each setting that approximates",
    "A case is one question: the same scene drawn by every setting and, where one can draw it, by "
    "mappers of VTK. Frames are off-screen, until OpenGL says they are done, the view turning from "
    "frame to frame; all ways take turns. Errors are those of a picture in a framebuffer of floats "
    "against one that is made in double precision without the mappers.",
    { MakeSortFamily(), MakeBlendFamily(), MakeTimeVolumeFamily(), MakeFastTimeVolumeFamily(),
      MakeLightLookupFamily(), MakeImageSampleFamily(), MakeTransmissionFamily(),
      MakeScalarTypeFamily(), MakeFlowVoxelFamily(), MakeFlowSampleFamily(), MakeStripeFamily() });
}
