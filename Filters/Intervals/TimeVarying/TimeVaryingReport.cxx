// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/TimeVaryingReport.h"

#include "Common/ReportValue.h"

#include <algorithm>
#include <functional>

namespace interlume
{

void TimeVaryingReport::AddOutput(const TimeVaryingReport& other)
{
  const auto add = [](auto& sums, const auto& values)
  { std::transform(sums.begin(), sums.end(), values.begin(), sums.begin(), std::plus<>()); };
  this->Simplices += other.Simplices;
  this->FlatSimplices += other.FlatSimplices;
  this->InvertedSimplices += other.InvertedSimplices;
  add(this->Tetrahedra, other.Tetrahedra);
  add(this->Boundaries, other.Boundaries);
}

void TimeVaryingReport::CopyTo(vtkInterlumeReport* report) const
{
  this->ExtractionReport::CopyTo(report);
  ReportValue::Add(report,
    { { "TimeSteps", this->TimeSteps }, { "Slabs", this->Slabs }, { "Simplices", this->Simplices },
      { "FlatSimplices", this->FlatSimplices }, { "InvertedSimplices", this->InvertedSimplices },
      { "Tetrahedra", this->Tetrahedra }, { "Boundaries", this->Boundaries },
      { "TableLookups", this->TableLookups }, { "TableCasesComputed", this->TableCasesComputed } });
}

}
