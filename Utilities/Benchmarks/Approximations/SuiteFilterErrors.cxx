// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"
#include "Benchmarks/Approximations/FamilySuite.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeFilterErrorsSuite()
{
  using namespace approximations;
  return MakeFamilySuite("filter-errors",
    "Filters and sources: error against run time for each setting that approximates",
    "A case is one question: the same done by every setting and, where there is one, by a filter "
    "of VTK; all ways take turns. Errors are those of the result against a formula in double "
    "precision.",
    { MakeContourFamily(), MakeTableRouteFamily(), MakeMesherFamily(), MakeCriticalPointFamily(),
      MakeVortexAxisFamily(), MakeStreamSurfaceFamily(), MakeLicStepFamily(), MakeLicLengthFamily(),
      MakeSourceSampleFamily(), MakeSourceVoxelFamily() });
}
