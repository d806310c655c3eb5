// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIntervalList.h"

#include "vtkObject.h"

#include <algorithm>

void vtkIntervalList::SetNumber(int number, vtkObject* owner)
{
  number = std::max(0, std::min(number, MaximumNumber));
  if (number != this->GetNumber())
  {
    this->Intervals.resize(number, { { 0.0, 0.0 } });
    owner->Modified();
  }
}

std::string vtkIntervalList::Set(int i, double lower, double upper, vtkObject* owner)
{
  if (i < 0 || i >= MaximumNumber)
  {
    return "Interval index " + std::to_string(i) + " is not in the range 0 to " +
      std::to_string(MaximumNumber - 1) + ".";
  }
  if (i >= this->GetNumber())
  {
    this->SetNumber(i + 1, owner);
  }
  const Interval interval{ { lower, upper } };
  if (this->Intervals[i] != interval)
  {
    this->Intervals[i] = interval;
    owner->Modified();
  }
  return {};
}

void vtkIntervalList::Get(int i, double& lower, double& upper) const
{
  if (i >= 0 && i < this->GetNumber())
  {
    lower = this->Intervals[i][0];
    upper = this->Intervals[i][1];
  }
}

void vtkIntervalList::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "Intervals: " << this->Intervals.size() << "\n";
  for (const Interval& interval : this->Intervals)
  {
    os << indent.GetNextIndent() << interval[0] << " to " << interval[1] << "\n";
  }
}
