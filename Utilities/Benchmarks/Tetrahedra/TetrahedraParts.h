// SPDX-License-Identifier: BSD-3-Clause
#ifndef TetrahedraParts_h
#define TetrahedraParts_h

#include "Benchmarks/Suites/BenchSuite.h"

/// The parts of the suites in this directory; each source describes its rows.
namespace tetrahedra
{
BenchPart MakeSpeedPart();
BenchPart MakeErrorPart();
}

#endif
