// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RecurrenceTest_h
#define interlume_RecurrenceTest_h

#include "Common/Vectors.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

/**
 * @class   RecurrenceTest
 * @brief   detects closed orbits that cannot reach a surface within the remaining steps
 *
 * The test stores one face that the streamline crossed. A new face replaces it whenever the
 * number of cells entered has doubled, unless the streamline returns to the face.
 *
 * Each return completes one revolution. The crossing points yield the displacement over the first k
 * revolutions and over the next k. The largest ratio of their coordinates, increased by a quarter,
 * bounds the growth from each block of k revolutions to the next. A geometric series then bounds
 * the total drift over all remaining revolutions. The orbit is closed if this bound is less than
 * the minimum distance to the surfaces after the first revolution, and less than a twentieth of the
 * extent of the orbit. Therefore a spiral that could still reach a surface, inward or outward, is
 * not a closed orbit. The bound is computed for k = 1, 2, 4, ... and becomes tighter because fewer
 * revolutions are left each time.
 *
 * If the streamline would run out of time before it runs out of steps, the test is switched off and
 * the streamline ends at the time limit.
 *
 * Distances are not measured before the first return. An orbit within one cell crosses no face and
 * is not detected.
 */
class RecurrenceTest
{
public:
  /// Steps and time that a streamline has used, or their limits.
  struct Budget
  {
    double Steps = 0.0;
    double Time = 0.0;
  };

  /// Returns true if Enter must be called after crossing the face between two cells.
  bool IsDue(vtkIdType cells, vtkIdType from, vtkIdType to) const
  {
    return cells >= this->NextFace || (to == this->To && from == this->From);
  }

  /// Return the values that IsDue compares: the number of entered cells at which the stored face is
  /// replaced, and the two cells at that face.
  vtkIdType GetNextFace() const { return this->NextFace; }
  vtkIdType GetFrom() const { return this->From; }
  vtkIdType GetTo() const { return this->To; }

  /// Records a crossing. \a cells is the number of cells entered, \a x the point on the face.
  void Enter(vtkIdType cells, vtkIdType from, vtkIdType to, const double x[3], const Budget& used,
    const Budget& limits)
  {
    if (to == this->To && from == this->From)
    {
      ++this->Returns;
      this->LastReturn = cells;
      if (this->Returns == 1 &&
        GetRevolutions(used.Time - this->UsedBefore.Time, limits.Time - used.Time) <=
          GetRevolutions(used.Steps - this->UsedBefore.Steps, limits.Steps - used.Steps))
      {
        // The streamline will run out of time before steps run out, so no test is needed.
        *this = RecurrenceTest();
        this->NextFace = std::numeric_limits<vtkIdType>::max();
        return;
      }
      if ((this->Returns & (this->Returns - 1)) == 0)
      {
        this->Closed = this->Returns > 1 && this->IsSame(x, used, limits);
        std::copy(x, x + 3, this->Halfway);
      }
    }
    if (cells < this->NextFace)
    {
      return;
    }
    if (this->Returns > 0 && cells - this->LastReturn <= this->LastReturn - this->First + Patience)
    {
      this->NextFace = cells + Patience;
      return;
    }
    *this = RecurrenceTest();
    this->NextFace = 2 * cells;
    this->From = from;
    this->To = to;
    this->First = cells;
    this->UsedBefore = used;
    std::copy(x, x + 3, this->Start);
  }

  /// Returns true if Watch must be called for each step.
  bool IsWatching() const { return this->Returns > 0; }

  /**
   * Records a step to \a x with a path length of at most \a pathLength. \a distance is the distance
   * from \a x to the nearest surface. \a limit is the largest drift that does not end the
   * streamline in another way, such as at a domain face.
   */
  void Watch(const double x[3], double distance, double pathLength, double limit)
  {
    // Every point of the step is within half the path length of one of the ends of the step.
    this->Clearance = std::min({ this->Clearance, distance - 0.5 * pathLength,
      this->DistanceBefore - 0.5 * pathLength, limit });
    this->DistanceBefore = distance;
    const double offset[3] = { x[0] - this->Start[0], x[1] - this->Start[1],
      x[2] - this->Start[2] };
    this->Extent = std::max(this->Extent, Vectors::SafeLength(glm::make_vec3(offset)));
  }

  bool IsClosed() const { return this->Closed; }

private:
  static constexpr vtkIdType Patience = 64;

  /// Returns how many revolutions the remaining budget \a left allows if one revolution uses \a
  /// one.
  static double GetRevolutions(double one, double left) { return left / one; }

  bool IsSame(const double x[3], const Budget& used, const Budget& limits) const
  {
    const double blocks =
      GetRevolutions(0.5 * (used.Steps - this->UsedBefore.Steps), limits.Steps - used.Steps);
    double first[3];
    double second[3];
    double rounding = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      first[i] = std::abs(this->Halfway[i] - this->Start[i]);
      second[i] = std::abs(x[i] - this->Halfway[i]);
      rounding = std::max(rounding, 1e-12 * std::abs(x[i]));
    }
    double block = std::max({ Vectors::SafeLength(glm::make_vec3(first)),
      Vectors::SafeLength(glm::make_vec3(second)), rounding });
    double growth = 1.0;
    for (int i = 0; i < 3; ++i)
    {
      growth = std::max(growth, second[i] / std::max({ first[i], 1e-3 * block, rounding }));
    }
    growth *= 1.25;
    const double maximumDrift = std::min(this->Clearance, 0.05 * this->Extent);
    double sum = 0.0;
    // Comparisons with NaN are false, so an orbit whose values are NaN does not count as closed.
    for (double left = blocks; left > 0.0 && sum < maximumDrift; left -= 1.0)
    {
      block *= growth;
      sum += block;
    }
    return sum < maximumDrift;
  }

  vtkIdType NextFace = Patience;
  vtkIdType From = -1;
  vtkIdType To = -1;
  vtkIdType First = 0;
  vtkIdType LastReturn = 0;
  vtkIdType Returns = 0;
  Budget UsedBefore;
  // Points on the face: the first crossing, and the crossing after half of the returns.
  double Start[3] = {};
  double Halfway[3] = {};
  double Clearance = std::numeric_limits<double>::infinity();
  double DistanceBefore = std::numeric_limits<double>::infinity();
  double Extent = 0.0;
  bool Closed = false;
};

}

#endif
