// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AdvectionLanes_h
#define interlume_AdvectionLanes_h

#include "Advection/Advection.h"
#include "Advection/LaneSteps.h"

#include <memory>

namespace interlume
{

/**
 * @class   AdvectionLanes
 * @brief   follows several streamlines at a time by LaneSteps
 *
 * Each streamline has an Advection, which takes the steps that LaneSteps does not: the first, those
 * near surfaces, at edges of cells, at the end of the field, rejected and stiff ones, where a
 * window of a test ends. Where one ends the next begins in its lane. Results are those of
 * Advection, bit-identical.
 */
template <typename Walker, typename Lanes>
class AdvectionLanes
{
public:
  using LaneWalker = typename Walker::template LaneWalker<Lanes>;
  using Steps = LaneSteps<LaneWalker>;

  /// \a take calls Take of its first argument, compiled for the machine.
  using Function = unsigned int (*)(Steps& steps, unsigned int lanes);

  /// As Advection is made.
  AdvectionLanes(const Walker& field, const AdvectionOptions& options, Function take)
    : Group(LaneWalker(&field.GetField()), options)
    , Take(take)
  {
    for (auto& advection : this->Advections)
    {
      advection = std::make_unique<Advection<Walker>>(field, options);
    }
  }

  /// Follows streamlines as StreamlineIntegrator does.
  template <typename Begin, typename End>
  void Follow(Begin&& begin, End&& end)
  {
    unsigned int lanes = 0;
    for (int lane = 0; lane < Lanes::Number; ++lane)
    {
      lanes |= this->BeginLane(lane, begin, end) ? 1U << lane : 0U;
    }
    while (lanes != 0)
    {
      const unsigned int stopped = this->Take(this->Group, lanes);
      for (int lane = 0; lane < Lanes::Number; ++lane)
      {
        if (stopped >> lane & 1U)
        {
          if (this->Advections[lane]->IsClear(this->Group, lane))
          {
            continue;
          }
          this->Advections[lane]->TakeFrom(this->Group, lane);
          if (!this->GoOn(lane, end) && !this->BeginLane(lane, begin, end))
          {
            lanes &= ~(1U << lane);
          }
        }
      }
    }
  }

private:
  /// Begins streamlines until one goes on in the lane. Returns false after the last.
  template <typename Begin, typename End>
  bool BeginLane(int lane, Begin& begin, End& end)
  {
    while (true)
    {
      bool goesOn = false;
      this->Ids[lane] = begin(*this->Advections[lane], goesOn);
      if (this->Ids[lane] < 0)
      {
        return false;
      }
      if (!goesOn)
      {
        end(this->Ids[lane], *this->Advections[lane]);
      }
      else if (this->GoOn(lane, end))
      {
        return true;
      }
    }
  }

  /// Goes on until the lane can. Returns false where the streamline has ended.
  template <typename End>
  bool GoOn(int lane, End& end)
  {
    do
    {
      if (!this->Advections[lane]->GoStep())
      {
        end(this->Ids[lane], *this->Advections[lane]);
        return false;
      }
    } while (!this->Advections[lane]->GiveTo(this->Group, lane));
    return true;
  }

  Steps Group;
  Function Take;
  std::unique_ptr<Advection<Walker>> Advections[Lanes::Number];
  vtkIdType Ids[Lanes::Number];
};

}

#endif
