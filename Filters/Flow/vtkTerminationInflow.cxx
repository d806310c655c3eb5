// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationInflow.h"

#include "Termination/InflowFinder.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkTerminationInflow);

std::string vtkTerminationInflow::InitializeFromField(
  vtkDataSet* field, vtkDataArray* vectors, bool isBackward)
{
  interlume::InflowFinder finder;
  if (!finder.Find(field, vectors, !isBackward))
  {
    return "the field has no flow, so the inflow rectangle cannot be placed";
  }
  const int axes[2] = { (finder.GetAxis() + 1) % 3, (finder.GetAxis() + 2) % 3 };
  double corners[3][3];
  for (auto& corner : corners)
  {
    corner[finder.GetAxis()] = finder.GetPosition();
    for (int i = 0; i < 2; ++i)
    {
      corner[axes[i]] = finder.GetCenter()[i] - this->Size * finder.GetHalfWidth()[i];
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    corners[1 + i][axes[i]] += 2.0 * this->Size * finder.GetHalfWidth()[i];
  }
  // The setters do not modify the object if the rectangle is unchanged.
  this->SetOrigin(corners[0]);
  this->SetPoint1(corners[1]);
  this->SetPoint2(corners[2]);
  return {};
}

void vtkTerminationInflow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size << "\n";
}
