// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchSuites.h"

std::vector<std::unique_ptr<BenchSuite>> MakeAllSuites()
{
  std::vector<std::unique_ptr<BenchSuite>> suites;
  suites.push_back(MakeTablesSuite());
  suites.push_back(MakeIntervalSuite());
  suites.push_back(MakeContourSuite());
  suites.push_back(MakeTetrahedraSuite());
  suites.push_back(MakeInterval4dSuite());
  suites.push_back(MakeShadowsSuite());
  suites.push_back(MakeSoftShadowsSuite());
  suites.push_back(MakeScatteringSuite());
  suites.push_back(MakeMixedSuite());
  suites.push_back(MakeFlowSuite());
  suites.push_back(MakeFlowSpeedSuite());
  suites.push_back(MakeFlowSharingSuite());
  suites.push_back(MakeFlowTextureSuite());
  suites.push_back(MakeFilterErrorsSuite());
  suites.push_back(MakePictureErrorsSuite());
  suites.push_back(MakeGrowthSuite());
  return suites;
}
