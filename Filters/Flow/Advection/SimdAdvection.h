// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimdAdvection_h
#define interlume_SimdAdvection_h

#include "Advection/Advection.h"
#include "Advection/SimdDormandPrince.h"

#include <memory>

namespace interlume
{

/**
 * @class   SimdAdvection
 * @brief   traces several streamlines at once, one per SIMD lane
 *
 * SimdDormandPrince takes the ordinary steps. Each SIMD lane has an Advection object for all other
 * steps: first steps, rejected and stiff steps, and steps near surfaces, near cell edges, at the
 * boundary of the field or at the end of a stagnation window. When a streamline ends, the next one
 * starts in the same SIMD lane. Results are bit-identical to those of Advection.
 */
template <typename Walker, typename SimdPack>
class SimdAdvection
{
public:
  using SimdWalker = typename Walker::template SimdWalker<SimdPack>;
  using Steps = SimdDormandPrince<SimdWalker>;

  /// Function that calls steps.Take(lanes), compiled for the instruction set of the processor.
  using Function = unsigned int (*)(Steps& steps, unsigned int lanes);

  /// Constructs an Advection object for each SIMD lane. \a options must outlive the object and must
  /// not change.
  SimdAdvection(const Walker& field, const AdvectionOptions& options, Function take)
    : Group(SimdWalker(&field.GetField()), options)
    , Take(take)
  {
    for (auto& advection : this->Advections)
    {
      advection = std::make_unique<Advection<Walker>>(field, options);
    }
  }

  /// Traces streamlines. For \a begin and \a end see StreamlineIntegrator.
  template <typename Begin, typename End>
  void Follow(Begin&& begin, End&& end)
  {
    unsigned int lanes = 0;
    for (int lane = 0; lane < SimdPack::Number; ++lane)
    {
      lanes |= this->StartNext(lane, begin, end) ? 1U << lane : 0U;
    }
    while (lanes != 0)
    {
      const unsigned int stopped = this->Take(this->Group, lanes);
      for (int lane = 0; lane < SimdPack::Number; ++lane)
      {
        if (stopped >> lane & 1U)
        {
          if (this->Advections[lane]->IsClear(this->Group, lane))
          {
            continue;
          }
          this->Advections[lane]->LoadFromSimdLane(this->Group, lane);
          if (!this->AdvanceUntilSimdReady(lane, end) && !this->StartNext(lane, begin, end))
          {
            lanes &= ~(1U << lane);
          }
        }
      }
    }
  }

private:
  /// Starts streamlines until one can continue in the SIMD lane. Returns false if no streamline is
  /// left.
  template <typename Begin, typename End>
  bool StartNext(int lane, Begin& begin, End& end)
  {
    while (true)
    {
      bool isActive = false;
      this->Ids[lane] = begin(*this->Advections[lane], isActive);
      if (this->Ids[lane] < 0)
      {
        return false;
      }
      if (!isActive)
      {
        end(this->Ids[lane], *this->Advections[lane]);
      }
      else if (this->AdvanceUntilSimdReady(lane, end))
      {
        return true;
      }
    }
  }

  /// Advances the streamline until it can continue in its SIMD lane. Returns false if it has ended.
  template <typename End>
  bool AdvanceUntilSimdReady(int lane, End& end)
  {
    do
    {
      if (!this->Advections[lane]->Advance())
      {
        end(this->Ids[lane], *this->Advections[lane]);
        return false;
      }
    } while (!this->Advections[lane]->StoreToSimdLane(this->Group, lane));
    return true;
  }

  Steps Group;
  Function Take;
  std::unique_ptr<Advection<Walker>> Advections[SimdPack::Number];
  vtkIdType Ids[SimdPack::Number];
};

}

#endif
