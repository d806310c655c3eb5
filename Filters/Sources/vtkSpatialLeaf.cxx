// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpatialLeaf.h"

#include "Common/NamedValue.h"
#include "Sampling/ClampedValue.h"

void vtkSpatialLeaf::SetDensity(double density)
{
  interlume::ClampedValue::Set(this, this->Density, density, 0.0, 1.0);
}

void vtkSpatialLeaf::SetColor(double red, double green, double blue)
{
  interlume::ClampedValue::Set(this, this->Color, { red, green, blue }, 0.0, 1.0);
}

void vtkSpatialLeaf::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(
    os, indent, { { "Density", this->Density }, { "Color", this->Color } });
}
