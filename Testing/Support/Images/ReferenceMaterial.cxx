// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceMaterial.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace reference
{

namespace
{

using Rgb = std::array<double, 3>;
using Sample = ReferenceMaterial::Sample;

Sample Between(const Sample& a, const Sample& b, double t)
{
  const auto mix = [t](double x, double y) { return x + t * (y - x); };
  return { mix(a.ColorArgument, b.ColorArgument), mix(a.OpacityArgument, b.OpacityArgument),
    { mix(a.Direct[0], b.Direct[0]), mix(a.Direct[1], b.Direct[1]), mix(a.Direct[2], b.Direct[2]) },
    mix(a.Weight, b.Weight) };
}

vtkDataArray* Find(vtkDataSetAttributes* data, const std::string& name)
{
  vtkDataArray* array = name.empty() ? data->GetScalars() : data->GetArray(name.c_str());
  if (!array)
  {
    throw std::invalid_argument("the grid does not have the array '" + name + "'");
  }
  return array;
}

}

ReferenceMaterial::ReferenceMaterial(
  vtkUnstructuredGrid* grid, vtkVolumeProperty* property, const MaterialArrays& arrays)
  : OfCells(arrays.OfCells)
  , Independent(property->GetIndependentComponents() != 0)
  , UnitDistance(property->GetScalarOpacityUnitDistance())
{
  vtkDataSetAttributes* data = grid->GetPointData();
  if (arrays.OfCells)
  {
    data = grid->GetCellData();
  }
  this->Scalars = Find(data, arrays.Scalars);
  if (!arrays.DeltaT.empty())
  {
    this->DeltaT = Find(grid->GetPointData(), arrays.DeltaT);
  }
  const int components = this->Scalars->GetNumberOfComponents();
  if (components > 4)
  {
    throw std::invalid_argument("the scalars have more than four components");
  }
  this->IsDirect = !this->Independent && components >= 3;
  this->ColorScale = this->Scalars->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
  this->Opacity = PiecewiseLinearFunction(property->GetScalarOpacity());
  if (property->GetColorChannels() == 1)
  {
    this->Color = PiecewiseLinearFunction(property->GetGrayTransferFunction());
    return;
  }
  vtkColorTransferFunction* color = property->GetRGBTransferFunction();
  this->Color = PiecewiseLinearFunction(color);
  if (this->Independent && components > 1)
  {
    this->Component =
      color->GetVectorMode() == vtkScalarsToColors::MAGNITUDE ? -1 : color->GetVectorComponent();
  }
}

Sample ReferenceMaterial::MakeSampleFromTuple(vtkIdType tuple) const
{
  double values[4];
  const int components = this->Scalars->GetNumberOfComponents();
  this->Scalars->GetTuple(tuple, values);
  Sample sample{};
  sample.Weight = 1.0;
  if (this->IsDirect)
  {
    for (int k = 0; k < 3; ++k)
    {
      sample.Direct[k] = this->ColorScale * values[k];
    }
    sample.OpacityArgument =
      components == 4 ? values[3] : (values[0] + values[1] + values[2]) / 3.0;
    sample.ColorArgument = sample.OpacityArgument;
  }
  else if (!this->Independent && components == 2)
  {
    sample.ColorArgument = values[0];
    sample.OpacityArgument = values[1];
  }
  else
  {
    double sum = 0.0;
    for (int k = 0; k < components; ++k)
    {
      sum += values[k] * values[k];
    }
    sample.ColorArgument = this->Component < 0 ? std::sqrt(sum) : values[this->Component];
    sample.OpacityArgument = sample.ColorArgument;
  }
  return sample;
}

bool ReferenceMaterial::IsFinite(vtkIdType cell, const std::array<vtkIdType, 4>& points) const
{
  return std::all_of(points.begin(), points.end(),
    [&](vtkIdType point)
    {
      const Sample sample = this->MakeSampleFromTuple(this->OfCells ? cell : point);
      return std::isfinite(sample.ColorArgument) && std::isfinite(sample.OpacityArgument) &&
        std::isfinite(sample.Direct[0]) && std::isfinite(sample.Direct[1]) &&
        std::isfinite(sample.Direct[2]) &&
        (!this->DeltaT || std::isfinite(this->DeltaT->GetComponent(point, 0)));
    });
}

Sample ReferenceMaterial::At(
  vtkIdType cell, const std::array<vtkIdType, 4>& points, const Barycentric& position) const
{
  // Rounding errors may put a position slightly outside the tetrahedron. Its barycentric
  // coordinates are clamped to >= 0 and normalized.
  std::array<double, 4> clamped;
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    clamped[i] = std::max(0.0, static_cast<double>(position[i]));
    sum += clamped[i];
  }
  Sample result{};
  for (int i = 0; i < 4; ++i)
  {
    const Sample corner = this->MakeSampleFromTuple(this->OfCells ? cell : points[i]);
    const double weight = this->DeltaT ? this->DeltaT->GetComponent(points[i], 0) : corner.Weight;
    const double part = clamped[i] / sum;
    result.ColorArgument += part * corner.ColorArgument;
    result.OpacityArgument += part * corner.OpacityArgument;
    result.Weight += part * weight;
    for (int k = 0; k < 3; ++k)
    {
      result.Direct[k] += part * corner.Direct[k];
    }
  }
  return result;
}

Rgb ReferenceMaterial::EvaluateColor(const Sample& sample, const Sample& inside) const
{
  return this->IsDirect ? sample.Direct
                        : this->Color.Evaluate(sample.ColorArgument, inside.ColorArgument);
}

Rgb ReferenceMaterial::GetColor(const Sample& sample) const
{
  return this->EvaluateColor(sample, sample);
}

double ReferenceMaterial::GetOpacity(const Sample& sample) const
{
  return this->Opacity.Evaluate(sample.OpacityArgument)[0];
}

void ReferenceMaterial::AppendParts(
  const Sample& begin, const Sample& end, double length, std::vector<LinearPart>& parts) const
{
  std::vector<double> positions = { 0.0, 1.0 };
  this->Opacity.AppendNodes(begin.OpacityArgument, end.OpacityArgument, positions);
  if (!this->IsDirect)
  {
    this->Color.AppendNodes(begin.ColorArgument, end.ColorArgument, positions);
  }
  std::sort(positions.begin(), positions.end());
  for (std::size_t i = 0; i + 1 < positions.size(); ++i)
  {
    const Sample inside = Between(begin, end, 0.5 * (positions[i] + positions[i + 1]));
    LinearPart part;
    part.Length = length * (positions[i + 1] - positions[i]);
    for (int side = 0; side < 2; ++side)
    {
      const Sample sample = Between(begin, end, positions[i + side]);
      part.Extinction[side] =
        this->Opacity.Evaluate(sample.OpacityArgument, inside.OpacityArgument)[0] /
        this->UnitDistance;
      part.Weight[side] = sample.Weight;
      part.Color[side] = this->EvaluateColor(sample, inside);
    }
    parts.push_back(part);
  }
}

LinearPart ReferenceMaterial::GetMeanPart(
  const Sample& begin, const Sample& end, double length) const
{
  LinearPart part;
  part.Length = length;
  part.Weight = { begin.Weight, end.Weight };
  part.Extinction.fill(
    0.5 * (this->GetOpacity(begin) + this->GetOpacity(end)) / this->UnitDistance);
  const Rgb first = this->GetColor(begin);
  const Rgb second = this->GetColor(end);
  Rgb mean;
  for (int k = 0; k < 3; ++k)
  {
    mean[k] = 0.5 * (first[k] + second[k]);
  }
  part.Color.fill(mean);
  return part;
}

}
