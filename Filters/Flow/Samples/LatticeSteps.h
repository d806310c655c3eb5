// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LatticeSteps_h
#define interlume_LatticeSteps_h

#include "Advection/LaneSteps.h"
#include "Fields/ImageWalker.h"

namespace interlume
{

/**
 * LaneSteps::Take on images and on rectilinear grids, for AVX2 where the machine has it. Nothing
 * fuses a product and a sum, so that the bytes are the same on all machines.
 */
namespace LatticeSteps
{
unsigned int Take(LaneSteps<LatticeLanes<ImageFlowField>>& steps, unsigned int lanes);
unsigned int Take(LaneSteps<LatticeLanes<RectilinearFlowField>>& steps, unsigned int lanes);
}

}

#endif
