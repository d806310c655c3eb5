// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SpaceTimeTable_h
#define interlume_SpaceTimeTable_h

#include "vtkIsotableCache.h"

namespace interlume
{

/// The interval table of a cell times time, for Filters/Intervals.
using SpaceTimeTable = vtkIsotableCache;

}

#endif
