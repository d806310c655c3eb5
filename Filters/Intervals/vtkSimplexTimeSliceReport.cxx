// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimplexTimeSliceReport.h"

#include "Common/NamedValue.h"

void vtkSimplexTimeSliceReport::Print(std::ostream& os, vtkIndent indent) const
{
  interlume::NamedValue::Print(os, indent,
    { { "Time", this->Time }, { "Simplices", this->Simplices }, { "Tetrahedra", this->Tetrahedra },
      { "NonFiniteSimplices", this->NonFiniteSimplices } });
}
