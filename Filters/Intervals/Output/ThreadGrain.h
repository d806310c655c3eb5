// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ThreadGrain_h
#define interlume_ThreadGrain_h

#include "vtkType.h"

namespace interlume
{

/// Minimum number of points or simplices per thread. Processing fewer takes less time than starting
/// a thread.
constexpr vtkIdType ThreadGrain = 8192;

}

#endif
