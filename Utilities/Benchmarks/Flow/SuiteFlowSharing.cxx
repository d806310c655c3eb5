// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowParts.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeFlowSharingSuite()
{
  return { "flow-sharing",
    "vtkImplicitFlowField, ShareStreamlines: error of what is interpolated, run time",
    {
      "shared: about 100,000 samples on an image, with ShareStreamlines against all streamlines, "
      "processor time of one thread; the parameter is MaximumError over the largest speed, in the "
      "stiff saddle too. dense: as many samples in a box a quarter as wide. share: the part of the "
      "samples that are interpolated. Their errors, in units of the tolerance for the time of "
      "their streamline, have median, q99, q999 (99.9 %) and largest; an answer of another status "
      "or id is off by 1e30. within: the part of all answers whose error is at most 10.",
    },
    { flow::MakeSharingPart() } };
}
