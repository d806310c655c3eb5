// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/SimdStepDispatch.h"

#include "Common/SimdDispatch.h"

namespace interlume
{

template <typename Field>
unsigned int SimdStepDispatch::Take(Steps<Field>& steps, unsigned int lanes)
{
  return SimdDispatch::Call([&] { return steps.Take(lanes); });
}

template unsigned int SimdStepDispatch::Take(Steps<ImageFlowField>&, unsigned int);
template unsigned int SimdStepDispatch::Take(Steps<RectilinearFlowField>&, unsigned int);
template unsigned int SimdStepDispatch::Take(Steps<ImagePartField>&, unsigned int);
template unsigned int SimdStepDispatch::Take(Steps<RectilinearPartField>&, unsigned int);

}
