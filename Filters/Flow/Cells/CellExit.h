// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellExit_h
#define interlume_CellExit_h

#include "Common/Vectors.h"
#include "Numerics/BernsteinRoot.h"
#include "Numerics/BracketedRoot.h"
#include "Numerics/DenseOutput.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

/// What CellExit takes for near and far, in widths of a cell.
struct ExitLimits
{
  static constexpr double Tolerance = 1e-12;
  /// How far a step may overshoot a face.
  static constexpr double LargestOvershoot = 0.5;
  /// How far beyond a face is much; from less the streamline goes on if it comes back.
  static constexpr double MuchOutside = 1e-6;
};

/**
 * @class   CellExit
 * @brief   the faces of a walker's cell as a streamline sees them: how far they are, and which it
 * leaves by
 *
 * A streamline may be outside of a face by Tolerance of the cell's width, so that one along a face
 * stays in one cell. The field goes on smoothly there.
 */
template <typename Walker>
class CellExit
{
public:
  static constexpr double Tolerance = ExitLimits::Tolerance;
  static constexpr int MaximumNumberOfFaces = 6;

  /**
   * Looks from \a p along \a rate. If \a isHeld, nothing is crossed at p, and faces that p is on or
   * beyond may be left behind by a hundredth of a width, which ends going around an edge for ever.
   */
  void Approach(const Walker& field, const double p[3], const double rate[3], bool isHeld)
  {
    this->NumberOfFaces = field.GetNumberOfFaces();
    if (field.IsBox())
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Distances[2 * axis] = p[axis];
        this->Distances[2 * axis + 1] = 1.0 - p[axis];
        this->Rates[2 * axis] = rate[axis];
        this->Rates[2 * axis + 1] = -rate[axis];
      }
    }
    else
    {
      this->FindRates(field, p, rate);
    }
    double fastest = 0.0;
    this->Outside = 0.0;
    for (int face = 0; face < this->NumberOfFaces; ++face)
    {
      fastest = std::max(fastest, std::abs(this->Rates[face]));
      this->Outside = std::max(this->Outside, -this->Distances[face]);
    }
    this->Fastest = fastest;
    this->TimeLimit = std::numeric_limits<double>::infinity();
    this->FaceAhead = -1;
    for (int face = 0; face < this->NumberOfFaces; ++face)
    {
      const double outside = std::max(0.0, -this->Distances[face]);
      const bool isBehind = isHeld && this->Distances[face] <= Tolerance;
      this->Slacks[face] = Tolerance + 2.0 * outside + (isBehind ? 0.02 : 0.0);
      if (this->Rates[face] < 0.0)
      {
        const double room = isBehind ? 0.01 : 1.1 * std::max(0.0, this->Distances[face]) + 0.05;
        const double time = room / -this->Rates[face];
        if (time < this->TimeLimit)
        {
          this->TimeLimit = time;
          this->FaceAhead = face;
        }
      }
    }
  }

  /// Returns the time until the end of a straight step is somewhat outside of the cell.
  double GetTimeLimit() const { return this->TimeLimit; }

  /// Returns the face that a straight step is likely to leave by; -1 for none.
  int GetFaceAhead() const { return this->FaceAhead; }

  /// Returns the largest rate at which a distance from a face changes, in widths per unit of time.
  double GetFastest() const { return this->Fastest; }

  /**
   * Returns the face to cross before the next step, -1 for none: the streamline is on it or beyond
   * and goes outwards, or is beyond by much. \a closed has bits for faces that there is no way
   * through.
   */
  int GetFaceToCross(unsigned int closed) const
  {
    int first = -1;
    for (int face = 0; face < this->NumberOfFaces; ++face)
    {
      const bool isOutwards = this->Rates[face] < -1e-12 * this->Fastest;
      const double distance = this->Distances[face];
      if (((isOutwards && distance <= Tolerance) || distance < -MuchOutside) &&
        !(closed >> face & 1U) && (first < 0 || distance < this->Distances[first]))
      {
        first = face;
      }
    }
    return first;
  }

  /**
   * Finds where a step first leaves the cell approached last, and by which face;
   * BernsteinRoot::None and -1 where it stays. \a isFar tells whether its end is so far outside
   * that the field may no longer be smooth there. \a points are the control points of \a dense.
   */
  double Find(const Walker& field, const DenseOutput& dense,
    const double points[DenseOutput::MaximumDegree + 1][3], int& exitFace, bool& isFar) const
  {
    exitFace = -1;
    double first = BernsteinRoot::None;
    double end = std::numeric_limits<double>::infinity();
    const auto leave = [&](int face, double theta)
    {
      if (theta < first)
      {
        first = theta;
        exitFace = face;
      }
    };
    if constexpr (Walker::FacesAreAffine)
    {
      end = field.IsBox() ? this->FindInBox(points, dense.Degree, leave)
                          : this->FindInPlanes(field, points, dense.Degree, leave);
    }
    else
    {
      end = this->FindInSamples(field, dense, leave);
    }
    isFar = end < -LargestOvershoot - this->Outside;
    return first;
  }

private:
  static constexpr double LargestOvershoot = ExitLimits::LargestOvershoot;
  static constexpr double MuchOutside = ExitLimits::MuchOutside;
  /// The number of samples of the distances from faces that are not affine.
  static constexpr int NumberOfSamples = 16;

  void FindRates(const Walker& field, const double p[3], const double rate[3])
  {
    // Affine distances have the same slope everywhere, which is found best from a point well apart.
    const double scale =
      (Walker::FacesAreAffine ? 1.0 : 1e-6) / Vectors::InfinityNorm(glm::make_vec3(rate));
    double ahead[3];
    for (int i = 0; i < 3; ++i)
    {
      ahead[i] = p[i] + scale * rate[i];
    }
    for (int face = 0; face < this->NumberOfFaces; ++face)
    {
      const double distance = field.GetFaceDistance(face, p);
      this->Distances[face] = distance;
      this->Rates[face] = (field.GetFaceDistance(face, ahead) - distance) / scale;
    }
  }

  // Three ways to look for exits: each calls leave(face, theta) where a face may be crossed, and
  // returns the least distance at the step's end. Control points outside of a plane need not mean
  // that the curve is; samples inside of a face not that it is not.

  template <typename Leave>
  double FindInBox(const double (*points)[3], int degree, Leave&& leave) const
  {
    double low[3];
    double high[3];
    std::copy(points[0], points[0] + 3, low);
    std::copy(points[0], points[0] + 3, high);
    for (int k = 1; k <= degree; ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], points[k][axis]);
        high[axis] = std::max(high[axis], points[k][axis]);
      }
    }
    double end = std::numeric_limits<double>::infinity();
    for (int face = 0; face < 6; ++face)
    {
      const int axis = face >> 1;
      const bool isUpper = face & 1;
      const double last = points[degree][axis];
      end = std::min(end, isUpper ? 1.0 - last : last);
      if ((isUpper ? 1.0 - high[axis] : low[axis]) <= -this->Slacks[face])
      {
        double b[DenseOutput::MaximumDegree + 1] = {};
        for (int k = 0; k <= degree; ++k)
        {
          b[k] = isUpper ? 1.0 - points[k][axis] : points[k][axis];
        }
        leave(face, CellExit::FindAffine(b, degree, this->Slacks[face]));
      }
    }
    return end;
  }

  template <typename Leave>
  double FindInPlanes(
    const Walker& field, const double (*points)[3], int degree, Leave&& leave) const
  {
    double end = std::numeric_limits<double>::infinity();
    for (int face = 0; face < this->NumberOfFaces; ++face)
    {
      double b[DenseOutput::MaximumDegree + 1] = {};
      double least = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= degree; ++k)
      {
        b[k] = field.GetFaceDistance(face, points[k]);
        least = std::min(least, b[k]);
      }
      end = std::min(end, b[degree]);
      if (least <= -this->Slacks[face])
      {
        leave(face, CellExit::FindAffine(b, degree, this->Slacks[face]));
      }
    }
    return end;
  }

  template <typename Leave>
  double FindInSamples(const Walker& field, const DenseOutput& dense, Leave&& leave) const
  {
    double end = std::numeric_limits<double>::infinity();
    for (int face = 0; face < this->NumberOfFaces; ++face)
    {
      double samples[NumberOfSamples + 1];
      double least = std::numeric_limits<double>::infinity();
      for (int i = 0; i <= NumberOfSamples; ++i)
      {
        samples[i] = CellExit::GetDistance(field, face, dense, i / double(NumberOfSamples));
        least = std::min(least, samples[i]);
      }
      end = std::min(end, samples[NumberOfSamples]);
      if (least <= 0.5)
      {
        leave(face, this->FindSmooth(field, face, dense, samples));
      }
    }
    return end;
  }

  /// Returns where the distance falls below -slack, moved back to where it was 0.
  static double FindAffine(double* b, int degree, double slack)
  {
    for (int i = 0; i <= degree; ++i)
    {
      b[i] += slack;
    }
    const double theta = BernsteinRoot::Find(b, degree);
    if (theta > 1.0)
    {
      return theta;
    }
    double at[BernsteinRoot::MaximumDegree + 1];
    std::copy(b, b + degree + 1, at);
    double slope = 0.0;
    for (int level = 1; level <= degree; ++level)
    {
      slope = degree * (at[1] - at[0]);
      for (int i = 0; i <= degree - level; ++i)
      {
        at[i] += theta * (at[i + 1] - at[i]);
      }
    }
    // A streamline that hardly goes outwards stays where it is.
    return slope < -1e4 * slack ? std::max(0.0, theta + slack / slope) : theta;
  }

  static double GetDistance(const Walker& field, int face, const DenseOutput& dense, double theta)
  {
    double p[3];
    dense.GetPoint(theta, p);
    return field.GetFaceDistance(face, p);
  }

  double FindSmooth(
    const Walker& field, int face, const DenseOutput& dense, const double* samples) const
  {
    const double slack = this->Slacks[face];
    auto function = [&](double theta)
    { return CellExit::GetDistance(field, face, dense, theta) + slack; };
    for (int i = 1; i <= NumberOfSamples; ++i)
    {
      const double from = (i - 1) / double(NumberOfSamples);
      const double before = samples[i - 1] + slack;
      if (samples[i] + slack < 0.0)
      {
        return BracketedRoot::Find(
          function, from, before, i / double(NumberOfSamples), samples[i] + slack);
      }
      // The lowest point of the parabola through three samples.
      if (i < NumberOfSamples && samples[i] <= samples[i - 1] && samples[i] < samples[i + 1])
      {
        const double bend = samples[i - 1] - 2.0 * samples[i] + samples[i + 1];
        const double lowest =
          (i + 0.5 * (samples[i - 1] - samples[i + 1]) / bend) / NumberOfSamples;
        const double value = function(lowest);
        if (value < 0.0)
        {
          return BracketedRoot::Find(function, from, before, lowest, value);
        }
      }
    }
    return BernsteinRoot::None;
  }

  int NumberOfFaces = 0;
  double Distances[MaximumNumberOfFaces];
  double Rates[MaximumNumberOfFaces];
  double Slacks[MaximumNumberOfFaces];
  double Outside = 0.0;
  double Fastest = 0.0;
  double TimeLimit = 0.0;
  int FaceAhead = -1;
};

}

#endif
