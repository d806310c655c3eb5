// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpatialLeaf.h"

#include "Common/NamedValue.h"
#include "Sampling/ClampedValue.h"

void vtkSpatialLeaf::SetDensity(double density)
{
  if (interlume::ClampedValue::Assign(this->Density, density, 0.0, 1.0))
  {
    this->Modified();
  }
}

void vtkSpatialLeaf::SetColor(double red, double green, double blue)
{
  if (interlume::ClampedValue::Assign(this->Color, { red, green, blue }, 0.0, 1.0))
  {
    this->Modified();
  }
}

void vtkSpatialLeaf::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(
    os, indent, { { "Density", this->Density }, { "Color", this->Color } });
}
