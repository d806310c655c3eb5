#ifndef vtkIntervalList_h
#define vtkIntervalList_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkIndent.h"                // for printing

#include <array>  // for an interval
#include <vector> // for the list

class vtkObject;

/**
 * @class   vtkIntervalList
 * @brief   the intervals of a filter, lower and upper bound each
 */
class INTERLUMEINTERVALS_EXPORT vtkIntervalList
{
public:
  using Interval = std::array<double, 2>;
  static constexpr int MaximumNumber = 10000;

  int GetNumber() const { return static_cast<int>(this->Intervals.size()); }
  const std::vector<Interval>& GetAll() const { return this->Intervals; }

  /// Clamped to 0 ... MaximumNumber; new intervals are [0, 0]. \a owner is marked modified when
  /// this changes anything.
  void SetNumber(int number, vtkObject* owner);
  /// Adds intervals where there are fewer than i + 1; an error of \a owner where i is out of range.
  void Set(int i, double lower, double upper, vtkObject* owner);
  /// Leaves its arguments where there is no interval i.
  void Get(int i, double& lower, double& upper) const;

  void Print(ostream& os, vtkIndent indent) const;

private:
  std::vector<Interval> Intervals;
};

#endif
