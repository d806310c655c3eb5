// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowsParts_h
#define ShadowsParts_h

#include "Benchmarks/Suites/BenchSuite.h"

/// The parts of the suites in this directory; each source describes its rows.
namespace shadows
{
BenchPart MakeSpeedPart();
BenchPart MakeErrorPart();
BenchPart MakeSurfacePart();
BenchPart MakeSoftShadowPart();
}

#endif
