// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageWalker_h
#define interlume_ImageWalker_h

#include "Fields/ImageFlowField.h"
#include "Fields/BoxWalker.h"
#include "Fields/RectilinearFlowField.h"

namespace interlume
{

/// Walkers of images and rectilinear grids.
using ImageWalker = BoxWalker<ImageFlowField>;
using RectilinearWalker = BoxWalker<RectilinearFlowField>;

}

#endif
