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
template <typename Field>
using Steps = LaneSteps<LatticeLanes<Field, Four>>;

template <typename Field>
unsigned int Take(Steps<Field>& steps, unsigned int lanes);
template <typename Field>
unsigned int TakePlainly(Steps<Field>& steps, unsigned int lanes);
}

}

#endif
