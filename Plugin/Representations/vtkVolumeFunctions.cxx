// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeFunctions.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMCoreUtilities.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Returns true if the function is a ramp over the narrow range that ParaView uses for a constant
/// array.
bool HasSingleValueRange(vtkPiecewiseFunction* function)
{
  if (function->GetSize() != 2)
  {
    return false;
  }
  double first[4];
  double last[4];
  function->GetNodeValue(0, first);
  function->GetNodeValue(1, last);
  double range[2] = { first[0], first[0] };
  vtkSMCoreUtilities::AdjustRange(range);
  return first[1] == 0.0 && std::abs(last[0] - range[1]) <= 1e-3 * (range[1] - range[0]);
}

void SetConstant(vtkPiecewiseFunction* function, double value)
{
  if (function->GetSize() != 1 || function->GetValue(0.0) != value)
  {
    function->RemoveAllPoints();
    function->AddPoint(0.0, value);
  }
}
}

vtkVolumeFunctions::vtkVolumeFunctions() = default;

vtkVolumeFunctions::~vtkVolumeFunctions() = default;

void vtkVolumeFunctions::SetColor(vtkColorTransferFunction* color)
{
  this->Color = color;
}

void vtkVolumeFunctions::SetScalarOpacity(vtkPiecewiseFunction* opacity)
{
  this->ScalarOpacity = opacity;
}

void vtkVolumeFunctions::SetOpacity(double opacity)
{
  this->Opacity = std::clamp(opacity, 0.0, 1.0);
}

void vtkVolumeFunctions::SetSolidColor(double red, double green, double blue)
{
  this->SolidColor[0] = red;
  this->SolidColor[1] = green;
  this->SolidColor[2] = blue;
}

void vtkVolumeFunctions::Apply(vtkVolumeProperty* property, bool hasArray)
{
  SetConstant(this->Flat, FLAT_OPACITY * this->Opacity);
  if (hasArray)
  {
    property->SetColor(this->Color);
    property->SetScalarOpacity(this->GetShownOpacity());
    return;
  }
  double color[3] = { -1.0, -1.0, -1.0 };
  if (this->Solid->GetSize() == 1)
  {
    this->Solid->GetColor(0.0, color);
  }
  if (!std::equal(color, color + 3, this->SolidColor))
  {
    this->Solid->RemoveAllPoints();
    this->Solid->AddRGBPoint(0.0, this->SolidColor[0], this->SolidColor[1], this->SolidColor[2]);
  }
  property->SetColor(this->Solid);
  property->SetScalarOpacity(this->Flat);
}

vtkPiecewiseFunction* vtkVolumeFunctions::GetShownOpacity()
{
  vtkPiecewiseFunction* source = this->ScalarOpacity;
  if (source && HasSingleValueRange(source))
  {
    return this->Flat;
  }
  if (!source || this->Opacity == 1.0)
  {
    return source;
  }
  if (this->ScaledSource != source || this->ScaledTime != source->GetMTime() ||
    this->ScaledBy != this->Opacity)
  {
    this->ScaledSource = source;
    this->ScaledTime = source->GetMTime();
    this->ScaledBy = this->Opacity;
    this->Scaled->DeepCopy(source);
    for (int i = 0; i < this->Scaled->GetSize(); ++i)
    {
      double node[4];
      this->Scaled->GetNodeValue(i, node);
      node[1] *= this->Opacity;
      this->Scaled->SetNodeValue(i, node);
    }
  }
  return this->Scaled;
}
