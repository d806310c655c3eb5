// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceCrossing_h
#define interlume_SurfaceCrossing_h

#include "Advection/AdvectionOptions.h"
#include "Common/Vectors.h"
#include "Numerics/BracketedRoot.h"

#include "vtkTerminationSurface.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <vector>

namespace interlume
{

/**
 * @class   SurfaceCrossing
 * @brief   the first termination surface that a streamline meets, step by step
 *
 * A distance never changes by more than the way between two points. So of each surface is kept how
 * far the streamline can go before it can have come there, and its distance is evaluated only then.
 * Steps that can have come there are walked through in pieces: beyond where the distance would be 0
 * by its slope, which shows by a change of sign; where it came near and went away again within a
 * piece, by the least distance (golden section).
 *
 * A point within Tolerance of a surface, relative to the coordinates, is on it where a streamline
 * begins and where a step ends; FindNear is for where the field ends. Whether a streamline that
 * touches a surface to within that has reached it depends on rounding, and is the same in each run.
 */
class SurfaceCrossing
{
public:
  static constexpr double Tolerance = 1e-12;
  /// The value that Find returns where no surface is met.
  static constexpr double None = 2.0;
  /// The share of a step by which it ends after a surface.
  static constexpr double Margin = 0.001;

  explicit SurfaceCrossing(const std::vector<AdvectionOptions::Surface>& surfaces)
    : Surfaces(surfaces)
    , States(surfaces.size())
  {
  }

  /// Begins a streamline in a cell of about this size. Returns the surface that \a x is on, or -1.
  int Begin(const double x[3], double size)
  {
    this->Evaluations = 0;
    this->Size = size;
    int on = -1;
    for (std::size_t i = 0; i < this->States.size(); ++i)
    {
      State& state = this->States[i];
      state.SetDistance(this->Evaluate(i, x));
      const bool isClose = std::abs(state.Distance) <= this->GetTolerance(x);
      state.Side = isClose ? 0 : (state.Distance < 0.0 ? -1 : 1);
      if (on < 0 && isClose && this->Surfaces[i].Shape->IsOn(x))
      {
        on = static_cast<int>(i);
      }
    }
    return on;
  }

  /**
   * Finds where the step first meets a surface, and which. \a place(theta, x) computes the place at
   * theta, \a end is the last theta that counts, \a reach is the most that the streamline can go
   * from theta = 0 to 1.
   */
  template <typename Place>
  double Find(Place& place, double end, double reach, int& surface)
  {
    double first = None;
    surface = -1;
    for (std::size_t i = 0; i < this->States.size(); ++i)
    {
      const double theta = this->FindOne(place, i, std::min(end, first), reach);
      // Crossings closer than rounding are at the same place, and the surface added first counts.
      if (theta <= 1.0 && (first > 1.0 || (first - theta) * reach > this->LastTolerance))
      {
        first = theta;
        surface = static_cast<int>(i);
      }
    }
    return first;
  }

  /**
   * Finds the same crossing on a step that ends after it by Margin of the step. Returns None where
   * it is not there.
   */
  template <typename Place>
  double Refine(Place& place, int surface)
  {
    const auto i = static_cast<std::size_t>(surface);
    double x[3];
    auto distance = [&](double theta)
    {
      place(theta, x);
      return this->Evaluate(i, x);
    };
    constexpr double from = 1.0 - 3.0 * Margin;
    const double before = distance(from);
    const double after = distance(1.0);
    // Their product may be no number.
    if (!(before < 0.0 ? after > 0.0 : before > 0.0 && after < 0.0))
    {
      return None;
    }
    const double root = BracketedRoot::Find(distance, from, before, 1.0, after);
    const bool isThere = std::abs(distance(root)) <= this->GetTolerance(x);
    return isThere && this->Surfaces[i].Shape->IsOn(x) ? root : None;
  }

  /// Returns a distance that no surface is nearer than to where the streamline stands.
  double GetClearance() const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const State& state : this->States)
    {
      least = std::min(least, state.Clearance);
    }
    return least;
  }

  /**
   * Returns the surface nearest to \a x, where a streamline going into \a direction ends at a face;
   * -1 where none is as near as \a tolerance. Both vectors have length 1, or 0. A surface that lies
   * across the face and along the direction is reached by no small displacement of either, and so
   * has less of the tolerance, down to none.
   */
  int FindNear(const double x[3], double tolerance, const double faceNormal[3],
    const double direction[3]) const
  {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->States.size(); ++i)
    {
      const vtkTerminationSurface* shape = this->Surfaces[i].Shape;
      // A mesh may know its own points less well than the tolerance.
      if (this->States[i].Clearance > tolerance + FLT_EPSILON * this->GetSize(x))
      {
        continue;
      }
      const double gap = shape->EvaluateGap(x);
      double normal[3];
      shape->EvaluateNormal(x, normal);
      const double part = 2.0 *
        std::max(
          std::abs(Vectors::Dot(normal, faceNormal)), std::abs(Vectors::Dot(normal, direction)));
      if (gap < least && gap <= std::min(1.0, part) * tolerance)
      {
        least = gap;
        nearest = static_cast<int>(i);
      }
    }
    return nearest;
  }

  void GetResult(int surface, const double x[3], AdvectionEnd& result) const
  {
    const AdvectionOptions::Surface& found = this->Surfaces[static_cast<std::size_t>(surface)];
    result.Id = found.Id + found.Shape->EvaluatePart(x);
    found.Shape->EvaluateParameters(x, result.Parameters);
  }

  /// Returns the least distance from any surface; infinite without one.
  double GetLeastDistance(const double x[3])
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->Surfaces.size(); ++i)
    {
      least = std::min(least, std::abs(this->Evaluate(i, x)));
    }
    return least;
  }

  std::size_t GetNumber() const { return this->States.size(); }
  /// Returns the distance that the streamline may still go until it can have come to a surface.
  double GetClearance(std::size_t surface) const { return this->States[surface].Clearance; }
  /// Notes what steps have left of it that cannot have come there.
  void RestoreClearance(std::size_t surface, double clearance)
  {
    this->States[surface].Clearance = clearance;
    this->States[surface].IsFresh = false;
  }

  /// Computes how far the only surface is from \a x, where the streamline stands, as Find does
  /// where a step may come to it. Returns false where the step of the length \a way still may.
  bool Renew(const double x[3], double way)
  {
    State& state = this->States.front();
    if (state.Clearance <= way && !state.IsFresh)
    {
      state.SetDistance(this->Evaluate(0, x));
    }
    return state.Clearance > way;
  }

  ///@{
  /// Appends what is known of the streamline to \a numbers, and takes it from there.
  void Save(std::vector<double>& numbers) const
  {
    numbers.push_back(this->Size);
    numbers.push_back(this->Evaluations);
    for (const State& state : this->States)
    {
      numbers.insert(numbers.end(),
        { state.Distance, state.Clearance, static_cast<double>(state.Side),
          state.IsFresh ? 1.0 : 0.0 });
    }
  }
  const double* Restore(const double* numbers)
  {
    this->Size = *numbers++;
    this->Evaluations = static_cast<int>(*numbers++);
    for (State& state : this->States)
    {
      state.Distance = *numbers++;
      state.Clearance = *numbers++;
      state.Side = static_cast<int>(*numbers++);
      state.IsFresh = *numbers++ != 0.0;
    }
    return numbers;
  }
  ///@}

  bool IsEmpty() const { return this->States.empty(); }
  int GetNumberOfEvaluations() const { return this->Evaluations; }

private:
  static constexpr int MostPieces = 64;

  struct State
  {
    double Distance = 0.0;
    /// The distance that the streamline may still go.
    double Clearance = 0.0;
    /// The side of the surface that the streamline is on; 0 while it has not left a place of no
    /// side.
    int Side = 0;
    /// Whether Distance is that at the step's start.
    bool IsFresh = false;

    void SetDistance(double distance)
    {
      this->Distance = distance;
      this->Clearance = std::abs(distance);
      this->IsFresh = true;
    }
    void Pass(double way)
    {
      this->Clearance -= way;
      this->IsFresh = false;
    }
  };

  /// Returns the largest of the coordinates and the cell's size.
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

  template <typename Place>
  double FindOne(Place& place, std::size_t i, double end, double reach)
  {
    State& state = this->States[i];
    const double way = end * reach;
    if (state.Clearance > way)
    {
      state.Pass(way);
      return None;
    }
    double x[3];
    if (!state.IsFresh)
    {
      place(0.0, x);
      state.SetDistance(this->Evaluate(i, x));
      if (state.Clearance > way)
      {
        state.Pass(way);
        return None;
      }
    }
    place(end, x);
    this->LastTolerance = this->GetTolerance(x);
    const double before = state.Distance;
    state.SetDistance(this->Evaluate(i, x));
    const bool isClose = std::abs(state.Distance) <= this->LastTolerance;
    const bool isOnSide = state.Side != 0 && state.Side * state.Distance > 0.0;
    if (!isOnSide || std::abs(before) + std::abs(state.Distance) <= way)
    {
      const double theta = this->Walk(place, i, before, end, reach);
      if (theta <= 1.0)
      {
        return theta;
      }
    }
    return isClose && this->Surfaces[i].Shape->IsOn(x) ? end : None;
  }

  /// Finds the first crossing on the surface from theta = 0 to \a end.
  template <typename Place>
  double Walk(Place& place, std::size_t i, double before, double end, double reach)
  {
    State& state = this->States[i];
    double x[3];
    auto distance = [&](double theta)
    {
      place(theta, x);
      return this->Evaluate(i, x);
    };
    double from = 0.0;
    double start = before;
    // Pieces whose widths follow the distance are few; after those the rest is one piece.
    for (int piece = 0; from < end && piece < 2 * MostPieces; ++piece)
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
      const double to = piece < MostPieces && from + width < end ? from + width : end;
      const double last = to < end ? distance(to) : state.Distance;
      if (state.Side == 0)
      {
        place(to, x);
        state.Side = std::abs(last) <= this->GetTolerance(x) ? 0 : (last < 0.0 ? -1 : 1);
      }
      else if (state.Side * last < 0.0 ||
        (isApproaching && state.Side * last > 0.0 &&
          this->FindLeast(distance, state.Side, from, to, last, reach)))
      {
        const double inside = state.Side * last < 0.0 ? to : this->Least;
        const double root = this->FindRoot(distance, state.Side, from, start, inside);
        const double there = distance(root);
        // A jump is no crossing, nor is a place where the surface has ended.
        if (std::abs(there) <= this->GetTolerance(x) + 1e-12 * reach &&
          this->Surfaces[i].Shape->IsOn(x))
        {
          return root;
        }
        state.Side = -state.Side;
        from = std::nextafter(root, 2.0);
        start = 0.0;
        if (inside < to)
        {
          // The streamline is out again in the same piece.
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

  /// Finds a root between \a from, on \a side, and \a to, on the other.
  template <typename Distance>
  double FindRoot(Distance& distance, int side, double from, double start, double to)
  {
    auto function = [&](double theta) { return side * distance(theta); };
    const double first = side * start > 0.0 ? side * start : 0.0;
    return first > 0.0 ? BracketedRoot::Find(function, from, first, to, function(to)) : from;
  }

  /**
   * Returns whether the distance, which falls from \a from and is \a last at \a to, changes sign in
   * between, which it then does at Least.
   */
  template <typename Distance>
  bool FindLeast(Distance& distance, int side, double from, double to, double last, double reach)
  {
    // The probe is so close to the end that the distance changes sign nowhere between.
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
      const double least = std::min(atLeft, atRight);
      if (least <= 0.0)
      {
        this->Least = atLeft <= atRight ? left : right;
        return true;
      }
      // No point in between is further than half the way from one of the two ends.
      if (least > reach * (high - low) || high - low <= 1e-15 * high)
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
  double Least = 0.0;
  double LastTolerance = 0.0;
  int Evaluations = 0;
};

}

#endif
