// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/LatticeSteps.h"

#include "Common/FunctionClones.h"

namespace interlume
{

namespace
{
INTERLUME_AVX2_FUNCTION
unsigned int TakeByAVX2(LatticeSteps::ImageSteps& steps, unsigned int lanes)
{
  return steps.Take(lanes);
}

INTERLUME_AVX2_FUNCTION
unsigned int TakeByAVX2(LatticeSteps::GridSteps& steps, unsigned int lanes)
{
  return steps.Take(lanes);
}

INTERLUME_AVX2_FUNCTION
unsigned int TakeByAVX2(LatticeSteps::ImagePartSteps& steps, unsigned int lanes)
{
  return steps.Take(lanes);
}

INTERLUME_AVX2_FUNCTION
unsigned int TakeByAVX2(LatticeSteps::GridPartSteps& steps, unsigned int lanes)
{
  return steps.Take(lanes);
}
}

unsigned int LatticeSteps::Take(ImageSteps& steps, unsigned int lanes)
{
  return INTERLUME_HAS_AVX2 ? TakeByAVX2(steps, lanes) : TakePlainly(steps, lanes);
}

unsigned int LatticeSteps::Take(GridSteps& steps, unsigned int lanes)
{
  return INTERLUME_HAS_AVX2 ? TakeByAVX2(steps, lanes) : TakePlainly(steps, lanes);
}

unsigned int LatticeSteps::Take(ImagePartSteps& steps, unsigned int lanes)
{
  return INTERLUME_HAS_AVX2 ? TakeByAVX2(steps, lanes) : steps.Take(lanes);
}

unsigned int LatticeSteps::Take(GridPartSteps& steps, unsigned int lanes)
{
  return INTERLUME_HAS_AVX2 ? TakeByAVX2(steps, lanes) : steps.Take(lanes);
}

unsigned int LatticeSteps::TakePlainly(ImageSteps& steps, unsigned int lanes)
{
  return steps.Take(lanes);
}

unsigned int LatticeSteps::TakePlainly(GridSteps& steps, unsigned int lanes)
{
  return steps.Take(lanes);
}

}
