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
 * @brief   whether a streamline goes round and round, and cannot reach a surface before its steps
 * are used up
 *
 * A face that the streamline crosses is kept, a new one each time that it has entered twice as many
 * cells, unless it comes back to it. At each return its place on the face tells how far it has got
 * in k turns, and after 2 k turns how much farther in as many again, by coordinates. What it gets
 * in all turns that are left is then at most the sum of a series, each block of k turns a quarter
 * more than these two say of the next. A closed orbit is one of which this sum is less than the
 * least distance of the streamline from the surfaces in the turns after the first, and less than a
 * twentieth of its extent. So a spiral is none as long as it could come to a surface in time,
 * inward or outward. k is 1, 2, 4, ...: the fewer turns are left, the surer what they can do.
 *
 * Where the time is used up before the steps a streamline is to end by it, and is let go on.
 *
 * Nothing is measured before the first return. An orbit within one cell crosses no face and is not
 * found.
 */
class RecurrenceTest
{
public:
  /// The steps and the time of a streamline, or the largest numbers of both.
  struct Budget
  {
    double Steps = 0.0;
    double Time = 0.0;
  };

  /// Returns whether Enter is to be called, after a face from one cell to another was crossed.
  bool IsDue(vtkIdType cells, vtkIdType from, vtkIdType to) const
  {
    return cells >= this->NextFace || (to == this->To && from == this->From);
  }

  /// Returns the crossings that Enter is to be called for: a number of cells, and a face that was
  /// crossed before.
  vtkIdType GetNextFace() const { return this->NextFace; }
  vtkIdType GetFrom() const { return this->From; }
  vtkIdType GetTo() const { return this->To; }

  /// Notes a crossing. \a cells is the number of cells that were entered, \a x the place on the
  /// face.
  void Enter(vtkIdType cells, vtkIdType from, vtkIdType to, const double x[3], const Budget& used,
    const Budget& most)
  {
    if (to == this->To && from == this->From)
    {
      ++this->Returns;
      this->LastReturn = cells;
      if (this->Returns == 1 &&
        GetTurns(used.Time - this->UsedBefore.Time, most.Time - used.Time) <=
          GetTurns(used.Steps - this->UsedBefore.Steps, most.Steps - used.Steps))
      {
        // The streamline ends by its time, as it should.
        *this = RecurrenceTest();
        this->NextFace = std::numeric_limits<vtkIdType>::max();
        return;
      }
      if ((this->Returns & (this->Returns - 1)) == 0)
      {
        this->Closed = this->Returns > 1 && this->IsSame(x, used, most);
        std::copy(x, x + 3, this->Middle);
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

  /// Returns whether Watch is to be called, for each step.
  bool IsWatching() const { return this->Returns > 0; }

  /**
   * Notes a step to \a x of at most the length \a way. \a distance is the least distance from the
   * surfaces there, \a limit the farthest that the streamline may get because of other ends.
   */
  void Watch(const double x[3], double distance, double way, double limit)
  {
    // No place of the step is further than half the way from one of its ends.
    this->Clearance =
      std::min({ this->Clearance, distance - 0.5 * way, this->DistanceBefore - 0.5 * way, limit });
    this->DistanceBefore = distance;
    const double apart[3] = { x[0] - this->Start[0], x[1] - this->Start[1], x[2] - this->Start[2] };
    this->Extent = std::max(this->Extent, Vectors::SafeLength(glm::make_vec3(apart)));
  }

  bool IsClosed() const { return this->Closed; }

private:
  static constexpr vtkIdType Patience = 64;

  /// Returns how often \a one is in \a left.
  static double GetTurns(double one, double left) { return left / one; }

  bool IsSame(const double x[3], const Budget& used, const Budget& most) const
  {
    const double blocks =
      GetTurns(0.5 * (used.Steps - this->UsedBefore.Steps), most.Steps - used.Steps);
    double first[3];
    double second[3];
    double rounding = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      first[i] = std::abs(this->Middle[i] - this->Start[i]);
      second[i] = std::abs(x[i] - this->Middle[i]);
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
    const double room = std::min(this->Clearance, 0.05 * this->Extent);
    double sum = 0.0;
    // A sum that is NaN is no orbit.
    for (double left = blocks; left > 0.0 && sum < room; left -= 1.0)
    {
      block *= growth;
      sum += block;
    }
    return sum < room;
  }

  vtkIdType NextFace = Patience;
  vtkIdType From = -1;
  vtkIdType To = -1;
  vtkIdType First = 0;
  vtkIdType LastReturn = 0;
  vtkIdType Returns = 0;
  Budget UsedBefore;
  // The places on the face: the first, and that of half the returns.
  double Start[3] = {};
  double Middle[3] = {};
  double Clearance = std::numeric_limits<double>::infinity();
  double DistanceBefore = std::numeric_limits<double>::infinity();
  double Extent = 0.0;
  bool Closed = false;
};

}

#endif
