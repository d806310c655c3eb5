// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIntervalList_h
#define vtkIntervalList_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkIndent.h"                // for printing

#include <array>  // for an interval
#include <string> // for error messages
#include <vector> // for the list

class vtkObject;

/**
 * @class   vtkIntervalList
 * @brief   list of intervals of a filter, each with a lower and an upper bound
 */
class INTERLUMEINTERVALS_EXPORT vtkIntervalList
{
public:
  using Interval = std::array<double, 2>;
  static constexpr int MaximumNumber = 10000;

  int GetNumber() const { return static_cast<int>(this->Intervals.size()); }
  const std::vector<Interval>& GetAll() const { return this->Intervals; }

  /// Sets the number of intervals, clamped to the range from 0 to MaximumNumber. New intervals are
  /// [0, 0]. Marks \a owner as modified if the list changes.
  void SetNumber(int number, vtkObject* owner);
  /// Sets interval \a i and extends the list if needed. Returns an error message if \a i is out of
  /// range, otherwise an empty string.
  std::string Set(int i, double lower, double upper, vtkObject* owner);
  /// Gets the bounds of interval \a i. Leaves its arguments unchanged if \a i is out of range.
  void Get(int i, double& lower, double& upper) const;

  void Print(ostream& os, vtkIndent indent) const;

private:
  std::vector<Interval> Intervals;
};

#endif
