// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartPrinter_h
#define interlume_PartPrinter_h

#include "vtkObject.h"

namespace interlume
{

/**
 * Helps PrintSelf of objects that have others.
 */
namespace PartPrinter
{
/// Prints an object that another one has, or that there is none.
inline void Print(ostream& os, vtkIndent indent, const char* name, vtkObject* part)
{
  os << indent << name << ": " << (part ? "\n" : "none\n");
  if (part)
  {
    part->PrintSelf(os, indent.GetNextIndent());
  }
}
}

}

#endif
