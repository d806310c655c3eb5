// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchSuites.h"

std::vector<BenchSuite> MakeAllSuites()
{
  return { MakeTablesSuite(), MakeIntervalSuite(), MakeContourSuite(), MakeTetrahedraSuite(),
    MakeInterval4dSuite(), MakeShadowsSuite(), MakeSoftShadowsSuite(), MakeScatteringSuite(),
    MakeMixedSuite(), MakeFlowSuite(), MakeFlowSpeedSuite(), MakeFlowSharingSuite(),
    MakeFlowTextureSuite(), MakeFilterErrorsSuite(), MakePictureErrorsSuite(), MakeGrowthSuite() };
}
