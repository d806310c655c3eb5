// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BeyondTrace_h
#define interlume_BeyondTrace_h

#include "Advection/Advection.h"
#include "Advection/AdvectionOptions.h"
#include "Samples/BeyondCorners.h"

#include "vtkMath.h"
#include "vtkTerminationSurface.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace interlume
{

/**
 * @class   BeyondTrace
 * @brief   follows what a sample beside a surface would have on the surface's other side
 *
 * Streamlines that leave towards the surface are followed on through it, those that leave away from
 * it are followed back to it. Each thread needs its own object.
 */
template <typename Walker>
class BeyondTrace
{
public:
  /// The result for one sample.
  struct Answer
  {
    /// Whether the sample stands still on the surface, so that no streamline tells of its other
    /// side.
    bool IsStill = false;
    /// The side as in TerminationSide, and 0 on the surface.
    signed char Side = 0;
    double Normal[3] = { 0.0, 0.0, 0.0 };
    /// The result beyond the surface. Status is not REACHED_SURFACE and Id is -1 where nothing
    /// would be reached.
    AdvectionResult Beyond;
  };

  /// Makes a trace on a copy of \a walker. \a options must not change while it is used.
  BeyondTrace(const Walker& walker, const AdvectionOptions& options)
    : Field(walker)
    , Options(options)
    , Pairs(options.Surfaces.size())
  {
  }

  Answer Find(const BeyondCorners::Corner& corner, const double x[3])
  {
    Answer answer;
    answer.Beyond.Means.assign(this->Options.MeanNumbers.size(), 0.0);
    const vtkTerminationSurface* surface =
      this->Options.Surfaces[static_cast<std::size_t>(corner.Surface)].Shape;
    surface->EvaluateNormal(x, answer.Normal);
    double v[3] = { 0.0, 0.0, 0.0 };
    const bool isMoving = this->GetWay(x, v);
    answer.IsStill = !isMoving && corner.Distance == 0.0;
    // A streamline along the surface counts as leaving, as in TerminationSide.
    const bool isAway = corner.Distance * vtkMath::Dot(answer.Normal, v) >= 0.0;
    const int side = corner.Distance == 0.0 ? 0 : (corner.Distance < 0.0 ? -1 : 1);
    answer.Side =
      static_cast<signed char>(side * (isAway ? vtkFlowStatus::AWAY : vtkFlowStatus::TOWARDS));
    if (isMoving && side != 0 && isAway)
    {
      this->FindBack(corner, x, answer.Beyond);
    }
    else if (isMoving && corner.IsOtherReached)
    {
      this->FindOn(corner, x, answer.Beyond);
    }
    if (answer.Beyond.Status != vtkFlowStatus::REACHED_SURFACE)
    {
      answer.Beyond.Id = -1;
    }
    return answer;
  }

private:
  // The advections to one surface alone, with and against the streamlines' direction.
  struct Pair
  {
    Pair(const Walker& walker, const AdvectionOptions& options, int surface)
      : OptionsTo(options)
    {
      this->OptionsTo.Surfaces = { options.Surfaces[static_cast<std::size_t>(surface)] };
      this->OptionsTo.DomainFaces = false;
      this->OptionsTo.MaximumTime = VTK_DOUBLE_MAX;
      this->OptionsTo.MaximumNumberOfSteps = MostSteps;
      this->OptionsBack = this->OptionsTo;
      this->OptionsBack.SetBackward(!options.IsBackward());
      this->To = std::make_unique<Advection<Walker>>(walker, this->OptionsTo);
      this->Back = std::make_unique<Advection<Walker>>(walker, this->OptionsBack);
    }
    AdvectionOptions OptionsTo;
    AdvectionOptions OptionsBack;
    std::unique_ptr<Advection<Walker>> To;
    std::unique_ptr<Advection<Walker>> Back;
  };
  // The most steps that are taken; a cell is crossed in a few.
  static constexpr int MostSteps = 100;
  // The largest way, as a share of a cell's diagonal, that a streamline may go to the surface
  // beside it, and the share from which it goes on behind the surface.
  static constexpr double MostWay = 4.0;
  static constexpr double Start = 1e-4;

  Pair& GetPair(int surface)
  {
    std::unique_ptr<Pair>& pair = this->Pairs[static_cast<std::size_t>(surface)];
    if (!pair)
    {
      pair = std::make_unique<Pair>(this->Field, this->Options, surface);
    }
    return *pair;
  }

  // Computes the velocity that streamlines are followed with. Returns false where there is none.
  bool GetWay(const double x[3], double v[3])
  {
    double p[3];
    double rate[3];
    if (!this->Field.Locate(x, p))
    {
      return false;
    }
    this->Field.GetVelocity(p, rate);
    this->Field.GetWorldVector(p, rate, v);
    for (int i = 0; i < 3; ++i)
    {
      v[i] = this->Options.IsBackward() ? -v[i] : v[i];
    }
    const double speed = vtkMath::Norm(v);
    return std::isfinite(speed) && speed > this->Options.MinimumSpeed;
  }

  static bool IsHit(
    const AdvectionResult& result, const BeyondCorners::Corner& corner, const double x[3])
  {
    return result.Status == vtkFlowStatus::REACHED_SURFACE &&
      std::sqrt(vtkMath::Distance2BetweenPoints(result.Position, x)) <= MostWay * corner.Length;
  }

  void FindBack(const BeyondCorners::Corner& corner, const double x[3], AdvectionResult& back)
  {
    this->GetPair(corner.Surface).Back->Follow(x, back);
    back.Status = IsHit(back, corner, x) ? back.Status : vtkFlowStatus::OUTSIDE;
    back.Time = -back.Time;
    back.ArcLength = -back.ArcLength;
  }

  void FindOn(const BeyondCorners::Corner& corner, const double x[3], AdvectionResult& on)
  {
    AdvectionResult to;
    this->GetPair(corner.Surface).To->Follow(x, to);
    double v[3];
    if (!IsHit(to, corner, x) || !this->GetWay(to.Position, v))
    {
      return;
    }
    const double speed = vtkMath::Norm(v);
    const double way = Start * corner.Length;
    double behind[3];
    for (int i = 0; i < 3; ++i)
    {
      behind[i] = to.Position[i] + way / speed * v[i];
    }
    if (!this->Whole)
    {
      this->Whole = std::make_unique<Advection<Walker>>(this->Field, this->Options);
    }
    this->Whole->Follow(behind, on);
    const double before = to.Time + way / speed;
    const double after = on.Time;
    const auto unite = [&](double first, double second)
    { return (before * first + after * second) / (before + after); };
    on.Time = before + after;
    on.MaximumSpeed = std::max(to.MaximumSpeed, on.MaximumSpeed);
    on.ArcLength += to.ArcLength + way;
    on.MeanVorticity = unite(to.MeanVorticity, on.MeanVorticity);
    for (std::size_t i = 0; i < on.Means.size(); ++i)
    {
      on.Means[i] = unite(to.Means[i], on.Means[i]);
    }
  }

  Walker Field;
  const AdvectionOptions& Options;
  std::vector<std::unique_ptr<Pair>> Pairs;
  std::unique_ptr<Advection<Walker>> Whole;
};

}

#endif
