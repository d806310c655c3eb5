// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TimeVarying/ReferenceWalls.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>

namespace reference
{

DomainWalls::DomainWalls(const TimeSteps& steps)
{
  vtkDataSet* first = GetDataSet(steps.front());
  this->Tolerance = 1e-10 * first->GetLength();
  for (const TimeStep& step : steps)
  {
    this->Times.push_back(step.Time);
    this->Boxes.emplace_back();
    GetDataSet(step)->GetBounds(this->Boxes.back().data());
  }
  if (!HasBoxDomain(first))
  {
    this->Faces = std::make_unique<DomainBoundary>(first);
  }
}

DomainWalls::Box DomainWalls::BoxAt(double time) const
{
  const size_t slab = std::clamp<std::ptrdiff_t>(
    std::upper_bound(this->Times.begin(), this->Times.end(), time) - this->Times.begin(), 1,
    static_cast<std::ptrdiff_t>(this->Times.size()) - 1);
  const double weight =
    (time - this->Times[slab - 1]) / (this->Times[slab] - this->Times[slab - 1]);
  Box box;
  for (size_t i = 0; i < box.size(); ++i)
  {
    box[i] = this->Boxes[slab - 1][i] + weight * (this->Boxes[slab][i] - this->Boxes[slab - 1][i]);
  }
  return box;
}

bool DomainWalls::Hold(const std::vector<Event>& events) const
{
  if (this->Faces)
  {
    std::vector<DomainBoundary::Point> points;
    std::transform(events.begin(), events.end(), std::back_inserter(points),
      [](const Event& event) { return event.X; });
    return this->Faces->Find(points) >= 0;
  }
  for (int side = 0; side < 6; ++side)
  {
    if (std::all_of(events.begin(), events.end(),
          [&](const Event& event) {
            return std::abs(event.X[side / 2] - this->BoxAt(event.Time)[side]) <= this->Tolerance;
          }))
    {
      return true;
    }
  }
  return false;
}

}
