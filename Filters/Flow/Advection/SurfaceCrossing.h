// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceCrossing_h
#define interlume_SurfaceCrossing_h

#include "Advection/AdvectionOptions.h"
#include "Common/Vectors.h"
#include "Numerics/BracketedRoot.h"

#include "vtkTerminationSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace interlume
{

/**
 * @class   SurfaceCrossing
 * @brief   finds the first termination surface that a streamline reaches, step by step
 *
 * Between two points of a streamline, the distance to a surface changes by at most the path length.
 * Therefore a clearance is stored for each surface: the path length that the streamline can cover
 * without reaching it. The distance is evaluated again only when the clearance is used up.
 *
 * A step that may reach a surface is searched in intervals. Each interval extends a little past the
 * zero that the slope of the distance predicts. A sign change reveals a crossing. If the streamline
 * approaches and recedes within one interval, a golden-section search finds the minimum distance.
 *
 * At the start of a streamline and at the end of a step, a point within Tolerance (relative to the
 * coordinates) of a surface counts as on the surface. FindNear applies a larger tolerance at the
 * boundary of the field. If a streamline touches a surface within Tolerance, rounding decides
 * whether it reaches the surface. The decision is the same in every run.
 */
class SurfaceCrossing
{
public:
  static constexpr double Tolerance = 1e-12;
  /// Value that Find returns if no surface is reached.
  static constexpr double None = 2.0;
  /// Overshoot of the refined step past the surface, as a fraction of the step.
  static constexpr double Margin = 0.001;

  explicit SurfaceCrossing(const std::vector<AdvectionOptions::Surface>& surfaces)
    : Surfaces(surfaces)
    , States(surfaces.size())
  {
  }

  /// Starts a streamline in a cell of approximately the given size. Returns the index of the
  /// surface that \a x is on, or -1.
  int Begin(const double x[3], double size);

  /**
   * Returns the first theta at which the step reaches a surface, and the index of that surface. If
   * no surface is reached, these are None and -1. \a getPosition(theta, x) computes the position at
   * theta, \a end is the last valid theta, and \a reach is a bound on the path length from theta =
   * 0 to 1.
   */
  template <typename GetPositionAt>
  double Find(GetPositionAt& getPosition, double end, double reach, int& surface)
  {
    double first = None;
    surface = -1;
    for (std::size_t i = 0; i < this->States.size(); ++i)
    {
      const double theta = this->FindOne(getPosition, i, std::min(end, first), reach);
      // If crossings differ only by rounding error, the surface that was added first takes
      // precedence.
      if (theta <= 1.0 && (first > 1.0 || (first - theta) * reach > this->LastTolerance))
      {
        first = theta;
        surface = static_cast<int>(i);
      }
    }
    return first;
  }

  /**
   * Finds the crossing on the repeated, shorter step, which overshoots it by Margin. Returns None
   * if there is no crossing.
   */
  template <typename GetPositionAt>
  double Refine(GetPositionAt& getPosition, int surface)
  {
    const auto i = static_cast<std::size_t>(surface);
    double x[3];
    auto distance = [&](double theta)
    {
      getPosition(theta, x);
      return this->Evaluate(i, x);
    };
    constexpr double from = 1.0 - 3.0 * Margin;
    const double before = distance(from);
    const double after = distance(1.0);
    // The signs are compared because the product of the distances may be NaN.
    if (!(before < 0.0 ? after > 0.0 : before > 0.0 && after < 0.0))
    {
      return None;
    }
    const double root = BracketedRoot::Find(distance, from, before, 1.0, after);
    const bool isThere = std::abs(distance(root)) <= this->GetTolerance(x);
    return isThere && this->Surfaces[i].Shape->IsOn(x) ? root : None;
  }

  /// Returns a lower bound of the distance from the current point to any surface.
  double GetClearance() const
  {
    double minimum = std::numeric_limits<double>::infinity();
    for (const State& state : this->States)
    {
      minimum = std::min(minimum, state.Clearance);
    }
    return minimum;
  }

  /**
   * Returns the index of the nearest surface within \a tolerance of \a x, or -1. \a x is the end of
   * a streamline on a face of the field. \a faceNormal and \a direction are unit vectors or zero.
   * The tolerance is reduced, down to 0, for a surface that is perpendicular to the face and
   * parallel to the direction, because a small displacement of the face or the streamline does not
   * reach such a surface.
   */
  int FindNear(const double x[3], double tolerance, const double faceNormal[3],
    const double direction[3]) const;

  void GetResult(int surface, const double x[3], AdvectionEnd& result) const;

  /// Returns the distance from \a x to the nearest surface, or infinity if there are no surfaces.
  double GetMinimumDistance(const double x[3]);

  std::size_t GetNumber() const { return this->States.size(); }
  /// Returns the path length that the streamline can cover without reaching the surface.
  double GetClearance(std::size_t surface) const { return this->States[surface].Clearance; }
  /// Sets the clearance after steps that cannot have reached the surface.
  void RestoreClearance(std::size_t surface, double clearance)
  {
    this->States[surface].Clearance = clearance;
    this->States[surface].IsFresh = false;
  }

  /// Evaluates the distance from \a x to the only surface if the clearance does not exceed \a
  /// pathLength, as Find does. Returns false if a step of length \a pathLength may still reach the
  /// surface.
  bool UpdateClearance(const double x[3], double pathLength)
  {
    State& state = this->States.front();
    if (state.Clearance <= pathLength && !state.IsFresh)
    {
      state.SetDistance(this->Evaluate(0, x));
    }
    return state.Clearance > pathLength;
  }

  ///@{
  /// Appends the state of the streamline to \a numbers, or reads it back.
  void Save(std::vector<double>& numbers) const;
  const double* Restore(const double* numbers);
  ///@}

  bool IsEmpty() const { return this->States.empty(); }
  int GetNumberOfEvaluations() const { return this->Evaluations; }

private:
  static constexpr int MaximumIntervals = 64;

  struct State
  {
    double Distance = 0.0;
    /// Path length that the streamline can cover without reaching the surface.
    double Clearance = 0.0;
    /// Side of the surface that the streamline is on, as the sign of the distance: -1 or 1, or 0 if
    /// the streamline started on the surface and is still on it.
    int Side = 0;
    /// If true, Distance is the distance at the start of the step.
    bool IsFresh = false;

    void SetDistance(double distance)
    {
      this->Distance = distance;
      this->Clearance = std::abs(distance);
      this->IsFresh = true;
    }
    void Pass(double pathLength)
    {
      this->Clearance -= pathLength;
      this->IsFresh = false;
    }
  };

  /// Returns the largest absolute coordinate of \a x or, if larger, the size of the first cell.
  double GetSize(const double x[3]) const
  {
    return std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]), this->Size });
  }
  double GetTolerance(const double x[3]) const { return Tolerance * this->GetSize(x); }

  double Evaluate(std::size_t surface, const double x[3])
  {
    ++this->Evaluations;
    return this->Surfaces[surface].Shape->EvaluateDistance(x);
  }

  template <typename GetPositionAt>
  double FindOne(GetPositionAt& getPosition, std::size_t i, double end, double reach)
  {
    State& state = this->States[i];
    const double pathLength = end * reach;
    if (state.Clearance > pathLength)
    {
      state.Pass(pathLength);
      return None;
    }
    double x[3];
    if (!state.IsFresh)
    {
      getPosition(0.0, x);
      state.SetDistance(this->Evaluate(i, x));
      if (state.Clearance > pathLength)
      {
        state.Pass(pathLength);
        return None;
      }
    }
    getPosition(end, x);
    this->LastTolerance = this->GetTolerance(x);
    const double before = state.Distance;
    state.SetDistance(this->Evaluate(i, x));
    const bool isClose = std::abs(state.Distance) <= this->LastTolerance;
    const bool isOnSide = state.Side != 0 && state.Side * state.Distance > 0.0;
    if (!isOnSide || std::abs(before) + std::abs(state.Distance) <= pathLength)
    {
      const double theta = this->Walk(getPosition, i, before, end, reach);
      if (theta <= 1.0)
      {
        return theta;
      }
    }
    return isClose && this->Surfaces[i].Shape->IsOn(x) ? end : None;
  }

  /// Returns the first crossing of the surface between theta = 0 and \a end.
  template <typename GetPositionAt>
  double Walk(GetPositionAt& getPosition, std::size_t i, double before, double end, double reach)
  {
    State& state = this->States[i];
    double x[3];
    auto distance = [&](double theta)
    {
      getPosition(theta, x);
      return this->Evaluate(i, x);
    };
    double from = 0.0;
    double start = before;
    // The interval width adapts to the distance, so that few intervals are needed. After
    // MaximumIntervals intervals, the rest of the step is a single interval.
    for (int interval = 0; from < end && interval < 2 * MaximumIntervals; ++interval)
    {
      double width = 0.25 * end;
      bool isApproaching = false;
      if (state.Side != 0 && state.Side * start > 0.0)
      {
        const double clear = std::abs(start) / reach;
        const double probe = std::min({ 0.5 * clear, width / 16.0, 0.5 * (end - from) });
        if (probe > 1e-12 * end)
        {
          const double fall = std::abs(start) - std::abs(distance(from + probe));
          isApproaching = fall > 0.0;
          width = isApproaching ? std::min(width, 1.5 * probe * (std::abs(start) / fall))
                                : std::min(width, std::max(2.0 * clear, end / 16.0));
        }
      }
      const double to = interval < MaximumIntervals && from + width < end ? from + width : end;
      const double last = to < end ? distance(to) : state.Distance;
      if (state.Side == 0)
      {
        getPosition(to, x);
        state.Side = std::abs(last) <= this->GetTolerance(x) ? 0 : (last < 0.0 ? -1 : 1);
      }
      else if (state.Side * last < 0.0 ||
        (isApproaching && state.Side * last > 0.0 &&
          this->FindSignChange(distance, state.Side, from, to, last, reach)))
      {
        const double inside = state.Side * last < 0.0 ? to : this->NegativePosition;
        const double root = this->FindRoot(distance, state.Side, from, start, inside);
        const double rootDistance = distance(root);
        // A discontinuity of the distance is not a crossing. Neither is a point past the edge of
        // the surface.
        if (std::abs(rootDistance) <= this->GetTolerance(x) + 1e-12 * reach &&
          this->Surfaces[i].Shape->IsOn(x))
        {
          return root;
        }
        state.Side = -state.Side;
        from = std::nextafter(root, 2.0);
        start = 0.0;
        if (inside < to)
        {
          // The distance changes sign again between \a inside and \a to.
          from = inside;
          start = distance(inside);
        }
        continue;
      }
      from = to;
      start = last;
    }
    return None;
  }

  /// Finds the root between \a from, where the sign of the distance is \a side, and \a to, where it
  /// is opposite.
  template <typename Distance>
  double FindRoot(Distance& distance, int side, double from, double start, double to)
  {
    auto function = [&](double theta) { return side * distance(theta); };
    const double first = side * start > 0.0 ? side * start : 0.0;
    return first > 0.0 ? BracketedRoot::Find(function, from, first, to, function(to)) : from;
  }

  /**
   * Returns true if the distance changes sign between \a from and \a to, although it has the same
   * sign at both, and sets NegativePosition to a theta past the sign change. The absolute distance
   * decreases at \a from. The distance at \a to is \a last.
   */
  template <typename Distance>
  bool FindSignChange(
    Distance& distance, int side, double from, double to, double last, double reach)
  {
    // The probe is so close to \a to that the distance cannot change sign between them.
    const double probe = std::min((to - from) / 64.0, 0.5 * side * last / reach);
    if (side * distance(to - probe) >= side * last)
    {
      return false;
    }
    constexpr double golden = 0.6180339887498949;
    double low = from;
    double high = to;
    double left = high - golden * (high - low);
    double right = low + golden * (high - low);
    double atLeft = side * distance(left);
    double atRight = side * distance(right);
    for (int iteration = 0; iteration < 80; ++iteration)
    {
      const double minimum = std::min(atLeft, atRight);
      if (minimum <= 0.0)
      {
        this->NegativePosition = atLeft <= atRight ? left : right;
        return true;
      }
      // The distance changes by at most reach * (high - low) within the interval.
      if (minimum > reach * (high - low) || high - low <= 1e-15 * high)
      {
        return false;
      }
      if (atLeft < atRight)
      {
        high = right;
        right = left;
        atRight = atLeft;
        left = high - golden * (high - low);
        atLeft = side * distance(left);
      }
      else
      {
        low = left;
        left = right;
        atLeft = atRight;
        right = low + golden * (high - low);
        atRight = side * distance(right);
      }
    }
    return false;
  }

  const std::vector<AdvectionOptions::Surface>& Surfaces;
  std::vector<State> States;
  double Size = 0.0;
  double NegativePosition = 0.0;
  double LastTolerance = 0.0;
  int Evaluations = 0;
};

}

#endif
