// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LatticeSteps_h
#define interlume_LatticeSteps_h

#include "Advection/LaneSteps.h"
#include "Fields/ImageWalker.h"
#include "Streams/PartField.h"

namespace interlume
{

/**
 * LaneSteps::Take on images and on rectilinear grids, and on parts of them, for AVX2 where the
 * machine has it, and without on any machine. Nothing fuses a product and a sum, so that the bytes
 * are the same.
 */
namespace LatticeSteps
{
using Four = Lanes<4>;
using ImageSteps = LaneSteps<LatticeLanes<ImageFlowField, Four>>;
using GridSteps = LaneSteps<LatticeLanes<RectilinearFlowField, Four>>;
using ImagePartSteps = LaneSteps<LatticeLanes<ImagePartField, Four>>;
using GridPartSteps = LaneSteps<LatticeLanes<RectilinearPartField, Four>>;

unsigned int Take(ImageSteps& steps, unsigned int lanes);
unsigned int Take(GridSteps& steps, unsigned int lanes);
unsigned int Take(ImagePartSteps& steps, unsigned int lanes);
unsigned int Take(GridPartSteps& steps, unsigned int lanes);
unsigned int TakePlainly(ImageSteps& steps, unsigned int lanes);
unsigned int TakePlainly(GridSteps& steps, unsigned int lanes);
}

}

#endif
