// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScatteringParts_h
#define ScatteringParts_h

#include "Benchmarks/Suites/BenchSuite.h"

/// The parts of the suites in this directory; each source describes its rows.
namespace scattering
{
BenchPart MakeSlabPart();
BenchPart MakeCloudPart();
}

#endif
