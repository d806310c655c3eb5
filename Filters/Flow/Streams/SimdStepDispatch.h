// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimdStepDispatch_h
#define interlume_SimdStepDispatch_h

#include "Advection/SimdDormandPrince.h"
#include "Fields/ImageWalker.h"
#include "Streams/PartitionedField.h"

namespace interlume
{

/**
 * SimdDormandPrince::Take for images, rectilinear grids and partitions of both, compiled for the
 * instruction set of the current processor.
 */
namespace SimdStepDispatch
{
/// Pack of four doubles.
using Four = SimdPack<4>;
template <typename Field>
using Steps = SimdDormandPrince<SimdBoxWalker<Field, Four>>;

template <typename Field>
unsigned int Take(Steps<Field>& steps, unsigned int lanes);
}

}

#endif
