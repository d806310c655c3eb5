// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTimeVaryingReport.h"

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
  os << indent << "TimeSteps: " << this->TimeSteps << "\n";
  os << indent << "Slabs: " << this->Slabs << "\n";
  os << indent << "Simplices: " << this->Simplices << "\n";
  os << indent << "FlatSimplices: " << this->FlatSimplices << "\n";
  os << indent << "InvertedSimplices: " << this->InvertedSimplices << "\n";
  PrintList(os, indent, "Tetrahedra", this->Tetrahedra);
  PrintList(os, indent, "Boundaries", this->Boundaries);
  os << indent << "TableLookups: " << this->TableLookups << "\n";
  os << indent << "TableCasesMade: " << this->TableCasesMade << "\n";
}
