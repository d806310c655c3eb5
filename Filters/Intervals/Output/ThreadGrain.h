// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ThreadGrain_h
#define interlume_ThreadGrain_h

#include "vtkType.h"

namespace interlume
{

/// The least work for a thread, where an item is a point or a simplex: less is done sooner than
/// another thread has started.
constexpr vtkIdType ThreadGrain = 8192;

}

#endif
