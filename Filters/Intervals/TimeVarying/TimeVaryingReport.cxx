// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTimeVaryingReport.h"

#include "Common/NamedValue.h"

#include <ostream>

namespace
{
template <typename List>
void PrintList(ostream& os, vtkIndent indent, const char* name, const List& list)
{
  os << indent << name << ":";
  for (const vtkIdType number : list)
  {
    os << " " << number;
  }
  os << "\n";
}
}

void vtkTimeVaryingReport::Print(ostream& os, vtkIndent indent) const
{
  this->vtkExtractionReport::Print(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "TimeSteps", this->TimeSteps }, { "Slabs", this->Slabs }, { "Simplices", this->Simplices },
      { "FlatSimplices", this->FlatSimplices }, { "InvertedSimplices", this->InvertedSimplices } });
  PrintList(os, indent, "Tetrahedra", this->Tetrahedra);
  PrintList(os, indent, "Boundaries", this->Boundaries);
  interlume::NamedValue::Print(os, indent,
    { { "TableLookups", this->TableLookups }, { "TableCasesMade", this->TableCasesMade } });
}
