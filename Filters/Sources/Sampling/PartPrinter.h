// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartPrinter_h
#define interlume_PartPrinter_h

#include "vtkObject.h"

namespace interlume
{

/**
 * Helper for PrintSelf of objects that contain other objects.
 */
namespace PartPrinter
{
/// Prints a contained object, or "none" if it is null.
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
