// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageWalker_h
#define interlume_ImageWalker_h

#include "Fields/ImageFlowField.h"
#include "Fields/LatticeWalker.h"
#include "Fields/RectilinearFlowField.h"

namespace interlume
{

/// The walkers of images and of rectilinear grids.
using ImageWalker = LatticeWalker<ImageFlowField>;
using RectilinearWalker = LatticeWalker<RectilinearFlowField>;

}

#endif
