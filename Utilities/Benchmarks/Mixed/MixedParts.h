// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedParts_h
#define MixedParts_h

#include "Benchmarks/Suites/BenchSuite.h"

/// The parts of the suites in this directory; each source describes its rows.
namespace mixed
{
BenchPart MakeErrorPart();
BenchPart MakeMapPart();
BenchPart MakeSoftPart();
BenchPart MakeCostPart();
BenchPart MakeTurnPart();
}

#endif
