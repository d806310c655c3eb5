// SPDX-License-Identifier: BSD-3-Clause
#ifndef IntervalParts_h
#define IntervalParts_h

#include "Benchmarks/Suites/BenchSuite.h"

/// The parts of the suites in this directory; each source describes its rows.
namespace interval
{
BenchPart MakeSpeedPart();
BenchPart MakeDragPart();
BenchPart MakeWholePart();
BenchPart MakeMemoryPart();
BenchPart MakeOrientationPart();
BenchPart MakeErrorPart();
}

#endif
