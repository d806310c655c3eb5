// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowParts_h
#define FlowParts_h

#include "Benchmarks/Suites/BenchSuite.h"

/// The parts of the suites in this directory; each source describes its rows.
namespace flow
{
BenchPart MakeTolerancePart();
BenchPart MakeVolumePart();
BenchPart MakeCheckpointPart();
BenchPart MakeConservationPart();
BenchPart MakeExplicitPart();
BenchPart MakeSpeedPart();
BenchPart MakeSharingPart();
}

#endif
