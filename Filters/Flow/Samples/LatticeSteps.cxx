// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/LatticeSteps.h"

#include "Common/FunctionClones.h"

namespace interlume
{

namespace
{
// Overloaded functions have no clones.
INTERLUME_FUNCTION_CLONES("avx2")
unsigned int TakeOnImage(LaneSteps<LatticeLanes<ImageFlowField>>& steps, unsigned int lanes)
{
  return steps.Take(lanes);
}

INTERLUME_FUNCTION_CLONES("avx2")
unsigned int TakeOnGrid(LaneSteps<LatticeLanes<RectilinearFlowField>>& steps, unsigned int lanes)
{
  return steps.Take(lanes);
}
}

unsigned int LatticeSteps::Take(LaneSteps<LatticeLanes<ImageFlowField>>& steps, unsigned int lanes)
{
  return TakeOnImage(steps, lanes);
}

unsigned int LatticeSteps::Take(
  LaneSteps<LatticeLanes<RectilinearFlowField>>& steps, unsigned int lanes)
{
  return TakeOnGrid(steps, lanes);
}

}
