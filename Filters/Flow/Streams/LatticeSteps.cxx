// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/LatticeSteps.h"

#include "Common/FunctionClones.h"

namespace interlume
{

namespace
{
template <typename Field>
INTERLUME_AVX2_FUNCTION unsigned int TakeByAVX2(
  LatticeSteps::Steps<Field>& steps, unsigned int lanes)
{
  return steps.Take(lanes);
}
}

template <typename Field>
unsigned int LatticeSteps::Take(Steps<Field>& steps, unsigned int lanes)
{
  return INTERLUME_HAS_AVX2 ? TakeByAVX2<Field>(steps, lanes) : TakePlainly<Field>(steps, lanes);
}

template <typename Field>
[[gnu::flatten]] unsigned int LatticeSteps::TakePlainly(Steps<Field>& steps, unsigned int lanes)
{
  return steps.Take(lanes);
}

template unsigned int LatticeSteps::Take(Steps<ImageFlowField>&, unsigned int);
template unsigned int LatticeSteps::Take(Steps<RectilinearFlowField>&, unsigned int);
template unsigned int LatticeSteps::Take(Steps<ImagePartField>&, unsigned int);
template unsigned int LatticeSteps::Take(Steps<RectilinearPartField>&, unsigned int);
template unsigned int LatticeSteps::TakePlainly(Steps<ImageFlowField>&, unsigned int);
template unsigned int LatticeSteps::TakePlainly(Steps<RectilinearFlowField>&, unsigned int);
template unsigned int LatticeSteps::TakePlainly(Steps<ImagePartField>&, unsigned int);
template unsigned int LatticeSteps::TakePlainly(Steps<RectilinearPartField>&, unsigned int);

}
