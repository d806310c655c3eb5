// SPDX-License-Identifier: BSD-3-Clause
#ifndef Interval4dParts_h
#define Interval4dParts_h

#include "Benchmarks/Suites/BenchSuite.h"

/// The parts of the suites in this directory; each source describes its rows.
namespace interval4d
{
BenchPart MakeSpeedPart();
BenchPart MakeFreshPart();
BenchPart MakeThroughputPart();
BenchPart MakeErrorPart();
}

#endif
