// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/TimeVaryingReport.h"

#include "Common/ReportValue.h"

namespace interlume
{

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
