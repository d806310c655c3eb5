// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationInflow.h"

#include "Termination/InflowFinder.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkTerminationInflow);

std::string vtkTerminationInflow::InitializeFromField(
  vtkDataSet* field, vtkDataArray* vectors, bool isBackward)
{
  interlume::InflowFinder finder;
  if (!finder.Find(field, vectors, !isBackward))
  {
    return "the field has no flow, so the inflow rectangle cannot be placed";
  }
  double low[3];
  double high[3];
  const int axis = finder.GetAxis();
  low[axis] = high[axis] = finder.GetPosition();
  for (int i = 0; i < 2; ++i)
  {
    const int across = (axis + 1 + i) % 3;
    low[across] = finder.GetCenter()[i] - this->Size * finder.GetHalfWidth()[i];
    high[across] = finder.GetCenter()[i] + this->Size * finder.GetHalfWidth()[i];
  }
  // If the flow is along y, v decreases along z, so that u is along x and the normal along y.
  const int alongU = axis == 0 ? 1 : 0;
  const int alongV = axis == 2 ? 1 : 2;
  if (axis == 1)
  {
    std::swap(low[alongV], high[alongV]);
  }
  double corners[3][3];
  for (auto& corner : corners)
  {
    std::copy_n(low, 3, corner);
  }
  corners[1][alongU] = high[alongU];
  corners[2][alongV] = high[alongV];
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
