// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellExit_h
#define interlume_CellExit_h

#include "Cells/BoxExit.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

/**
 * @class   CellExit
 * @brief   finds the face through which an integration step leaves the cell of a walker
 *
 * For box cells, BoxExit handles the unambiguous cases. A streamline may be up to Tolerance cell
 * widths outside a face, where the field continues smoothly. Therefore a streamline that runs along
 * a face remains in one cell.
 */
template <typename Walker>
class CellExit : private BoxExit<double>
{
public:
  using BoxExit<double>::Tolerance;

  /**
   * Prepares the search from \a p along \a rate. Returns the face to cross before the next step, or
   * -1. The streamline must cross a face if it is on or outside the face and moves outward, or if
   * it is far outside. \a closed has a bit for each face that cannot be crossed. If \a isHeld is
   * true, no face is crossed at \a p. If \a p is on or outside a face, the streamline may then move
   * outward by another hundredth of a cell width. This prevents infinite loops around an edge.
   */
  int PrepareSearch(
    const Walker& field, const double p[3], const double rate[3], bool isHeld, unsigned int closed)
  {
    if (field.IsBox() && !isHeld && BoxExit<double>::PrepareSearch(p, rate))
    {
      return -1;
    }
    this->NumberOfFaces = field.GetNumberOfFaces();
    double rates[MaximumNumberOfFaces];
    CellExit::FindRates(field, p, rate, this->NumberOfFaces, this->Distances, rates);
    this->Fastest = 0.0;
    this->Outside = 0.0;
    for (int face = 0; face < this->NumberOfFaces; ++face)
    {
      this->Fastest = std::max(this->Fastest, std::abs(rates[face]));
      this->Outside = std::max(this->Outside, -this->Distances[face]);
    }
    this->TimeLimit = std::numeric_limits<double>::infinity();
    this->FaceAhead = -1.0;
    for (int face = 0; face < this->NumberOfFaces; ++face)
    {
      const double outside = std::max(0.0, -this->Distances[face]);
      const bool isBehind = isHeld && this->Distances[face] <= Tolerance;
      this->Slacks[face] = Tolerance + 2.0 * outside + (isBehind ? 0.02 : 0.0);
      if (rates[face] < 0.0)
      {
        const double distance = isBehind ? 0.01 : 1.1 * std::max(0.0, this->Distances[face]) + 0.05;
        const double time = distance / -rates[face];
        if (time < this->TimeLimit)
        {
          this->TimeLimit = time;
          this->FaceAhead = face;
        }
      }
    }
    return isHeld ? -1 : this->GetFaceToCross(rates, closed);
  }

  /// Returns the time step after which a straight streamline is slightly outside the cell.
  double GetTimeLimit() const { return this->TimeLimit; }

  /// Returns the likely exit face of a straight streamline, or -1.
  int GetFaceAhead() const { return static_cast<int>(this->FaceAhead); }

  /// Returns the largest rate of change of a distance to a face, in cell widths per unit of time.
  double GetFastest() const { return this->Fastest; }

  /**
   * Returns the fraction of the step (theta) at which it leaves the cell passed to Approach, and
   * computes the exit face. If the step remains inside, they are BernsteinRoot::None and -1. Sets
   * \a isFar to true if the step ends so far outside that the field may not be smooth there.
   * \a points are the control points of the step. Control points may be outside a face even if the
   * curve is not.
   */
  double Find(
    const Walker& field, const double (*points)[3], int degree, int& exitFace, bool& isFar) const
  {
    double first = BernsteinRoot::None;
    double boxFace = -1.0;
    isFar = false;
    if (field.IsBox() && BoxExit<double>::Find(points, degree, first, boxFace))
    {
      exitFace = static_cast<int>(boxFace);
      return first;
    }
    first = BernsteinRoot::None;
    exitFace = -1;
    double end = std::numeric_limits<double>::infinity();
    const bool isBox = field.IsBox();
    const int faces = field.GetNumberOfFaces();
    for (int face = 0; face < faces; ++face)
    {
      double b[Size] = {};
      double minimum = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= degree; ++k)
      {
        b[k] = isBox ? GetBoxDistance(face, points[k]) : field.GetFaceDistance(face, points[k]);
        minimum = std::min(minimum, b[k]);
      }
      end = std::min(end, b[degree]);
      const double theta = minimum <= -this->Slacks[face]
        ? CellExit::FindCrossing(b, degree, this->Slacks[face])
        : BernsteinRoot::None;
      exitFace = theta < first ? face : exitFace;
      first = std::min(first, theta);
    }
    isFar = end < -LargestOvershoot - this->Outside;
    return first;
  }

private:
  static constexpr int MaximumNumberOfFaces = 6;

  static double GetBoxDistance(int face, const double p[3])
  {
    return face & 1 ? 1.0 - p[face >> 1] : p[face >> 1];
  }

  static void FindRates(const Walker& field, const double p[3], const double rate[3], int faces,
    double* distances, double* rates)
  {
    // The distance to a face is affine, so its slope can be computed accurately from a distant
    // point.
    const double scale = 1.0 / Vectors::InfinityNorm(glm::make_vec3(rate));
    double ahead[3];
    for (int i = 0; i < 3; ++i)
    {
      ahead[i] = p[i] + scale * rate[i];
    }
    const bool isBox = field.IsBox();
    for (int face = 0; face < faces; ++face)
    {
      distances[face] = isBox ? GetBoxDistance(face, p) : field.GetFaceDistance(face, p);
      rates[face] = isBox ? (face & 1 ? -rate[face >> 1] : rate[face >> 1])
                          : (field.GetFaceDistance(face, ahead) - distances[face]) / scale;
    }
  }

  int GetFaceToCross(const double* rates, unsigned int closed) const
  {
    int first = -1;
    for (int face = 0; face < this->NumberOfFaces; ++face)
    {
      const bool isOutward = rates[face] < -1e-12 * this->Fastest;
      const double distance = this->Distances[face];
      if (((isOutward && distance <= Tolerance) || distance < -MuchOutside) &&
        !(closed >> face & 1U) && (first < 0 || distance < this->Distances[first]))
      {
        first = face;
      }
    }
    return first;
  }

  /// Returns the theta at which the distance first falls below -slack, moved back to the zero of
  /// the distance by MoveBack, or BernsteinRoot::None.
  static double FindCrossing(double* b, int degree, double slack)
  {
    for (int i = 0; i <= degree; ++i)
    {
      b[i] += slack;
    }
    const double theta = BernsteinRoot::Find(b, degree);
    return theta > 1.0 ? theta : BoxExit<double>::MoveBack(b, degree, slack, theta);
  }

  int NumberOfFaces = 0;
};

}

#endif
