// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchParts_h
#define BenchParts_h

#include "Benchmarks/Suites/BenchSuite.h"

/// Functions that return the parts of all suites. The source file of each part describes its rows.
BenchPart MakeTablesPart();
BenchPart MakeFlowTexturePart();

namespace interval
{
BenchPart MakeContourPart();
BenchPart MakeSpeedPart();
BenchPart MakeDragPart();
BenchPart MakeMemoryPart();
BenchPart MakeOrientationPart();
BenchPart MakeErrorPart();
}

namespace tetrahedra
{
BenchPart MakeSpeedPart();
BenchPart MakeErrorPart();
}

namespace interval4d
{
BenchPart MakeSpeedPart();
BenchPart MakeFreshPart();
BenchPart MakeThroughputPart();
BenchPart MakeErrorPart();
}

namespace shadows
{
BenchPart MakeSpeedPart();
BenchPart MakeErrorPart();
BenchPart MakeSoftShadowPart();
}

namespace scattering
{
BenchPart MakeSlabPart();
BenchPart MakeCloudPart();
}

namespace mixed
{
BenchPart MakeMapPart();
BenchPart MakeCostPart();
}

namespace flow
{
BenchPart MakeTolerancePart();
BenchPart MakeVolumePart();
BenchPart MakeCheckpointPart();
BenchPart MakeExplicitPart();
BenchPart MakeSpeedPart();
BenchPart MakeSharingPart();
}

namespace growth
{
BenchPart MakePart();
}

#endif
