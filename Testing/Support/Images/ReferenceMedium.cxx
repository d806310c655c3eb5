// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceMedium.h"

#include "Support/Images/ShadowScene.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkVolumeProperty.h"

#include <stdexcept>

namespace reference
{

namespace
{

/// exp(-OpticalDepthOfOpaque) is negligible.
constexpr double OpticalDepthOfOpaque = 700.0;

}

ReferenceMedium::ReferenceMedium(const SceneVolume& volume)
  : Image(volume.Image, volume.Array, volume.Matrix)
  , IsIndependent(
      volume.Property->GetIndependentComponents() != 0 || this->Image.GetNumberOfComponents() == 1)
  , IsDirect(!this->IsIndependent && this->Image.GetNumberOfComponents() == 4)
  , CroppingFlags(volume.CroppingFlags)
  , CroppingPlanes(volume.CroppingPlanes)
  , Planes(volume.ClippingPlanes)
{
  const int components = this->Image.GetNumberOfComponents();
  if (!this->IsIndependent && components == 3)
  {
    throw std::invalid_argument("three dependent components are not supported");
  }
  vtkVolumeProperty* property = volume.Property;
  this->Rows.resize(this->IsIndependent ? components : 1);
  for (int k = 0; k < static_cast<int>(this->Rows.size()); ++k)
  {
    Row& row = this->Rows[k];
    row.Color = property->GetColorChannels(k) == 1
      ? PiecewiseLinearFunction(property->GetGrayTransferFunction(k))
      : PiecewiseLinearFunction(property->GetRGBTransferFunction(k));
    row.Opacity = PiecewiseLinearFunction(property->GetScalarOpacity(k));
    row.HasGradientOpacity = property->HasGradientOpacity(k);
    if (row.HasGradientOpacity)
    {
      row.GradientOpacity = PiecewiseLinearFunction(property->GetGradientOpacity(k));
    }
    row.UnitDistance = property->GetScalarOpacityUnitDistance(k);
    row.Weight = this->Rows.size() > 1 ? property->GetComponentWeight(k) : 1.0;
    row.Reflect = { property->GetShade() != 0, property->GetAmbient(k), property->GetDiffuse(k),
      property->GetSpecular(k), property->GetSpecularPower(k) };
  }
  this->HasTransmission = volume.TransmissionColor != nullptr;
  if (this->HasTransmission)
  {
    this->Transmission = PiecewiseLinearFunction(volume.TransmissionColor.Get());
  }
}

bool ReferenceMedium::IsCropped(const Double3& index) const
{
  if (this->CroppingFlags == 0)
  {
    return false;
  }
  const Double3 x = this->Image.ToVolume(index);
  int region = 0;
  int factor = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isAbove = x[axis] > this->CroppingPlanes[2 * axis + 1];
    region += factor * (isAbove ? 2 : (x[axis] < this->CroppingPlanes[2 * axis] ? 0 : 1));
    factor *= 3;
  }
  return (this->CroppingFlags & (1 << region)) == 0;
}

double ReferenceMedium::GetExtinction(const Row& row, const Double3& index,
  const ImageInterpolator::Sample& sample, int component) const
{
  double opacity = row.Opacity.Evaluate(sample.Values[component])[0];
  if (opacity > 0.0 && row.HasGradientOpacity)
  {
    opacity *= row.GradientOpacity.Evaluate(this->Image.GetMagnitude(index, component))[0];
  }
  const double depth = opacity < 1.0 ? -std::log1p(-opacity) : OpticalDepthOfOpaque;
  return sample.Finite * row.Weight * std::min(depth, OpticalDepthOfOpaque) / row.UnitDistance;
}

int ReferenceMedium::GetParts(
  const Double3& index, bool withColors, std::array<Part, 4>& parts) const
{
  if (this->IsCropped(index))
  {
    return 0;
  }
  const ImageInterpolator::Sample sample = this->Image.At(index);
  int count = 0;
  for (int k = 0; k < static_cast<int>(this->Rows.size()); ++k)
  {
    const int component = this->IsIndependent ? k : this->Image.GetNumberOfComponents() - 1;
    Part part;
    part.Row = k;
    part.Extinction = this->GetExtinction(this->Rows[k], index, sample, component);
    if (!(part.Extinction > 0.0))
    {
      continue;
    }
    if (withColors)
    {
      part.Color = this->Rows[k].Color.Evaluate(sample.Values[k]);
      for (int channel = 0; channel < 3 && this->IsDirect; ++channel)
      {
        part.Color[channel] = this->Image.GetColorScale() * sample.Values[channel];
      }
      if (this->Rows[k].Reflect.Shade)
      {
        const Double3 gradient = this->Image.GetGradient(index, component);
        const double length = vtkMath::Norm(gradient.data());
        for (int axis = 0; axis < 3 && length > 0.0; ++axis)
        {
          part.Normal[axis] = -gradient[axis] / length;
        }
      }
    }
    parts[count++] = part;
  }
  return count;
}

Double3 ReferenceMedium::GetLightExtinction(const Double3& index) const
{
  std::array<Part, 4> parts;
  const int count = this->GetParts(index, false, parts);
  double sum = 0.0;
  for (int k = 0; k < count; ++k)
  {
    sum += parts[k].Extinction;
  }
  Double3 extinction = { { sum, sum, sum } };
  if (this->HasTransmission && sum > 0.0)
  {
    const Double3 color = this->Transmission.Evaluate(this->Image.At(index).Values[0]);
    for (int channel = 0; channel < 3; ++channel)
    {
      extinction[channel] *= 1.0 - color[channel];
    }
  }
  return extinction;
}

std::vector<double> ReferenceMedium::GetCuts(const IndexLine& line) const
{
  std::vector<double> cuts;
  if (this->CroppingFlags != 0)
  {
    const Double3 begin = this->Image.ToVolume(line.Begin);
    const Double3 end = this->Image.ToVolume(line.At(1.0));
    for (int side = 0; side < 6; ++side)
    {
      const int axis = side / 2;
      cuts.push_back((this->CroppingPlanes[side] - begin[axis]) / (end[axis] - begin[axis]));
    }
  }
  return cuts;
}

bool ReferenceMedium::Clip(
  const Double3& world, const Double3& direction, double& begin, double& end) const
{
  for (const auto& plane : this->Planes)
  {
    double normal[3];
    plane->GetNormal(normal);
    Double3 x = world;
    const double value = plane->EvaluateFunction(x.data());
    const double slope = vtkMath::Dot(normal, direction.data());
    if (slope > 0.0)
    {
      begin = std::max(begin, -value / slope);
    }
    else if (slope < 0.0)
    {
      end = std::min(end, -value / slope);
    }
    else if (value < 0.0)
    {
      return false;
    }
  }
  return begin < end;
}

}
