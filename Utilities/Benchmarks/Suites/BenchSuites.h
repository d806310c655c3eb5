// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchSuites_h
#define BenchSuites_h

#include "Benchmarks/Suites/BenchSuite.h"

#include <memory>
#include <vector>

std::unique_ptr<BenchSuite> MakeTablesSuite();
std::unique_ptr<BenchSuite> MakeIntervalSuite();
std::unique_ptr<BenchSuite> MakeContourSuite();
std::unique_ptr<BenchSuite> MakeTetrahedraSuite();
std::unique_ptr<BenchSuite> MakeInterval4dSuite();
std::unique_ptr<BenchSuite> MakeShadowsSuite();
std::unique_ptr<BenchSuite> MakeSoftShadowsSuite();
std::unique_ptr<BenchSuite> MakeScatteringSuite();
std::unique_ptr<BenchSuite> MakeMixedSuite();
std::unique_ptr<BenchSuite> MakeFlowSuite();
std::unique_ptr<BenchSuite> MakeFlowSpeedSuite();
std::unique_ptr<BenchSuite> MakeFlowSharingSuite();
std::unique_ptr<BenchSuite> MakeFlowTextureSuite();
std::unique_ptr<BenchSuite> MakeFilterErrorsSuite();
std::unique_ptr<BenchSuite> MakePictureErrorsSuite();
std::unique_ptr<BenchSuite> MakeGrowthSuite();

/**
 * Every suite, in the order of the report.
 */
std::vector<std::unique_ptr<BenchSuite>> MakeAllSuites();

#endif
