// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchSuites_h
#define BenchSuites_h

#include "Benchmarks/Suites/BenchSuite.h"

BenchSuite MakeTablesSuite();
BenchSuite MakeIntervalSuite();
BenchSuite MakeContourSuite();
BenchSuite MakeTetrahedraSuite();
BenchSuite MakeInterval4dSuite();
BenchSuite MakeShadowsSuite();
BenchSuite MakeSoftShadowsSuite();
BenchSuite MakeScatteringSuite();
BenchSuite MakeMixedSuite();
BenchSuite MakeFlowSuite();
BenchSuite MakeFlowSpeedSuite();
BenchSuite MakeFlowSharingSuite();
BenchSuite MakeFlowTextureSuite();
BenchSuite MakeFilterErrorsSuite();
BenchSuite MakePictureErrorsSuite();
BenchSuite MakeGrowthSuite();

#endif
