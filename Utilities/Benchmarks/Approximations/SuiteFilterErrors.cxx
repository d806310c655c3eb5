// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"
#include "Benchmarks/Approximations/FamilySuite.h"
#include "Benchmarks/Suites/BenchSuites.h"

std::unique_ptr<BenchSuite> MakeFilterErrorsSuite()
{
  using namespace approximations;
  return std::make_unique<FamilySuite>("filter-errors",
    "Filters and sources: error against run time for each setting that approximates",
    "A case is one question: the same done by every setting and, where there is one, by a filter "
    "of "
    "VTK; all ways take turns. Errors are those of the result against a formula in double "
    "precision.",
    std::vector<Family>{ MakeContourFamily(), MakeTableRouteFamily(), MakeMesherFamily(),
      MakeCriticalPointFamily(), MakeVortexAxisFamily(), MakeStreamSurfaceFamily(),
      MakeLicStepFamily(), MakeLicLengthFamily(), MakeSourceSampleFamily(),
      MakeSourceVoxelFamily() });
}
