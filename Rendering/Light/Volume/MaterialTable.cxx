// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/MaterialTable.h"

#include "Volume/VolumeSamples.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace interlume
{

namespace
{
using Range = TransferColumns::Range;

/// Tolerances within which a scalar counts as equal to a point of a function, since texels are
/// rounded: OnColumn is relative to the width of a column, OnTexel to the difference between scalar
/// and offset.
constexpr double OnColumn = 1e-3;
/// A ramp whose width is at most this fraction of the range counts as a step.
constexpr double StepWidth = 1e-3;
constexpr double OnTexel = 1.0 / (1 << 21);

/// Returns the component's range, enlarged if it is too narrow for the precision of texels. The
/// width of the result is finite.
std::array<double, 2> FindTableRange(const VolumeSamples& samples, int component)
{
  constexpr double largest = 0.25 * std::numeric_limits<double>::max();
  const double lower = std::clamp(samples.Range[component][0], -largest, largest);
  const double upper = std::clamp(samples.Range[component][1], -largest, largest);
  const double scale = samples.Scale[component];
  return { { lower, upper - lower < scale / 65536.0 ? lower + scale / 256.0 : upper } };
}

double FindExtinction(double opacity, double unitDistance)
{
  const double clamped = std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) : 0.0;
  const double depth = std::min(-std::log1p(-clamped), MaterialTable::LargestOpticalDepth);
  return std::min(depth / unitDistance, static_cast<double>(std::numeric_limits<float>::max()));
}

/// Returns the function's nodes, or a ramp over the range if it has no points, as in VTK.
template <typename Function>
TransferNodes GetNodes(Function* function, const Range& range, double last)
{
  return function && function->GetSize() > 0 ? TransferNodes(function)
                                             : TransferNodes(range, 0.0, last);
}

TransferNodes GetColorNodes(vtkVolumeProperty* property, int component, const Range& range)
{
  if (property->GetColorChannels(component) == 3)
  {
    return GetNodes(property->GetRGBTransferFunction(component), range, 1.0);
  }
  return GetNodes(property->GetColorChannels(component) == 1
      ? property->GetGrayTransferFunction(component)
      : static_cast<vtkPiecewiseFunction*>(nullptr),
    range, 1.0);
}

double Identity(double value)
{
  return value;
}

double ClampToOne(double value)
{
  return std::clamp(value, 0.0, 1.0);
}

const TransferColumns::Mapping Unchanged{ Identity, Identity };
const TransferColumns::Mapping Clamped{ ClampToOne, Identity };
}

Error MaterialTable::Build(vtkVolumeProperty* property, const VolumeSamples& samples,
  vtkColorTransferFunction* transmission, const Scattering& scattering)
{
  *this = MaterialTable();
  const bool independent = property->GetIndependentComponents() || samples.Components == 1;
  if (!independent && samples.Components == 3)
  {
    return "The volume has three components that are not independent, and none of them defines the "
           "opacity. Use one, two or four components, or turn on IndependentComponents.";
  }
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
  {
    return "2D transfer functions are not supported. Set the transfer function mode to TF_1D.";
  }
  for (const bool isTransmission : { true, false })
  {
    if ((isTransmission ? transmission : scattering.Albedo) &&
      (independent ? samples.Components != 1 : samples.Components != 2))
    {
      return std::string(isTransmission ? "TransmissionColor" : "ScatteringAlbedo") +
        " requires one component, or two that are not independent, but the volume has " +
        std::to_string(samples.Components) + (independent ? " independent" : "") + " components.";
    }
  }
  const int rows = independent ? samples.Components : 1;
  for (int row = 0; row < rows; ++row)
  {
    const double unit = property->GetScalarOpacityUnitDistance(row);
    if (!(unit > 0.0) || !std::isfinite(unit))
    {
      return "ScalarOpacityUnitDistance of component " + std::to_string(row) + " is " +
        std::to_string(unit) + ". It must be positive and finite.";
    }
  }

  this->Kind = independent ? INDEPENDENT : samples.Components == 2 ? COLOR_OPACITY : RGB_OPACITY;
  this->Rows = rows;
  for (int row = 0; row < rows; ++row)
  {
    this->BuildRow(property, samples, row, transmission, scattering);
  }
  this->BuildGradientOpacity(property);
  return {};
}

double MaterialTable::GetExtinction(int row, double opacity) const
{
  return this->Weight[row] * FindExtinction(opacity, this->UnitDistance[row]);
}

void MaterialTable::BuildRow(vtkVolumeProperty* property, const VolumeSamples& samples, int row,
  vtkColorTransferFunction* transmission, const Scattering& scattering)
{
  const int component = this->GetOpacityComponent(row);
  this->UnitDistance[row] = property->GetScalarOpacityUnitDistance(row);
  this->Weight[row] = this->Rows > 1 ? property->GetComponentWeight(row) : 1.0;
  this->Offset[row] = samples.Offset[component];
  this->ScalarRange[row] = FindTableRange(samples, component);
  this->Opacities[row] = GetNodes(property->GetScalarOpacity(row), this->ScalarRange[row], 0.5);
  this->OpacityRange[row] = this->Opacities[row].ClipRange(this->ScalarRange[row]);
  const double unit = this->UnitDistance[row];
  const double weight = this->Weight[row];
  const TransferColumns::Mapping mapping{ [&](double opacity)
    { return this->GetExtinction(row, opacity); },
    [=](double extinction)
    { return weight > 0.0 ? -std::expm1(-extinction / weight * unit) : 0.0; } };
  const TransferColumns extinctions(
    this->Opacities[row], TransferColumns::ONE, this->OpacityRange[row], mapping, this->Bends);
  this->ExtinctionBends.insert(
    this->ExtinctionBends.end(), extinctions.Bends.begin(), extinctions.Bends.end());
  this->ExtinctionEdges.insert(
    this->ExtinctionEdges.end(), extinctions.Edges.begin(), extinctions.Edges.end());

  const Range scalars =
    this->Kind == COLOR_OPACITY ? FindTableRange(samples, 0) : this->ScalarRange[row];
  const TransferNodes colors = this->Kind == RGB_OPACITY ? TransferNodes(scalars, 1.0, 1.0)
    : scattering.Albedo                                  ? GetNodes(scattering.Albedo, scalars, 1.0)
                                                         : GetColorNodes(property, row, scalars);
  this->ColorRange[row] = colors.ClipRange(scalars);
  if (transmission)
  {
    // The color and transmission functions are sampled over one common range. A transmission
    // function without points is black.
    const TransferNodes transmissions = transmission->GetSize() > 0
      ? TransferNodes(transmission)
      : TransferNodes(this->ColorRange[row], 0.0, 0.0);
    const Range range = transmissions.ClipRange(scalars);
    this->ColorRange[row] = { { std::min(this->ColorRange[row][0], range[0]),
      std::max(this->ColorRange[row][1], range[1]) } };
    TransferColumns columns(
      transmissions, TransferColumns::THREE, this->ColorRange[row], Clamped, this->Bends);
    for (const TransferColumns::Value& value : columns.Values)
    {
      for (const double channel : value)
      {
        this->Transmission.push_back(static_cast<float>(channel));
      }
    }
    this->TransmissionBends = std::move(columns.Bends);
    this->TransmissionEdges = std::move(columns.Edges);
  }
  const TransferColumns columns(colors, TransferColumns::THREE, this->ColorRange[row],
    scattering.IsOn ? Clamped : Unchanged, this->Bends);
  this->ColorBends.insert(this->ColorBends.end(), columns.Bends.begin(), columns.Bends.end());
  this->ColorEdges.insert(this->ColorEdges.end(), columns.Edges.begin(), columns.Edges.end());
  for (std::size_t i = 0; i < columns.Values.size(); ++i)
  {
    for (const double channel : columns.Values[i])
    {
      this->Colors.push_back(static_cast<float>(channel));
    }
    this->Colors.push_back(static_cast<float>(extinctions.Values[i][0]));
  }
}

void MaterialTable::BuildGradientOpacity(vtkVolumeProperty* property)
{
  bool any = false;
  std::vector<float> values;
  std::vector<int> bends;
  std::vector<std::array<float, 2>> edges;
  for (int row = 0; row < this->Rows; ++row)
  {
    const std::array<double, 2>& scalars = this->ScalarRange[row];
    Range range{ { 0.0, 0.25 * (scalars[1] - scalars[0]) } };
    TransferNodes nodes(range, 1.0, 1.0);
    // GetGradientOpacity would create a missing function. It returns a constant 1 if gradient
    // opacity is disabled.
    if (property->HasGradientOpacity(row))
    {
      nodes = GetNodes(property->GetGradientOpacity(row), range, 0.5);
      range[1] = nodes.ClipRange(range)[1];
    }
    this->GradientRange[row] = range[1];
    const TransferColumns columns(nodes, TransferColumns::ONE, range, Clamped, this->Bends);
    for (const TransferColumns::Value& value : columns.Values)
    {
      values.push_back(static_cast<float>(value[0]));
      any = any || values.back() < 1.0F;
    }
    bends.insert(bends.end(), columns.Bends.begin(), columns.Bends.end());
    edges.insert(edges.end(), columns.Edges.begin(), columns.Edges.end());
  }
  if (any || std::any_of(bends.begin(), bends.end(), [](int first) { return first > 0; }))
  {
    this->GradientOpacity = std::move(values);
    this->GradientOpacityBends = std::move(bends);
    this->GradientOpacityEdges = std::move(edges);
  }
}

bool MaterialTable::HasEdges() const
{
  const auto isAny = [](const std::vector<std::array<float, 2>>& edges)
  {
    return std::any_of(edges.begin(), edges.end(),
      [](const std::array<float, 2>& edge) { return edge[0] > 0.0F || edge[1] < 1.0F; });
  };
  return isAny(this->ColorEdges) || isAny(this->ExtinctionEdges) ||
    isAny(this->GradientOpacityEdges) || isAny(this->TransmissionEdges);
}

bool MaterialTable::HasSharpOpacity() const
{
  bool isSharp = this->GradientOpacity.empty();
  for (int row = 0; row < this->Rows; ++row)
  {
    const Range& range = this->ScalarRange[row];
    isSharp = isSharp && this->Opacities[row].IsStepwise(range, StepWidth * (range[1] - range[0]));
  }
  return isSharp;
}

double MaterialTable::GetSmallestExtinction() const
{
  double smallest = 0.0;
  for (int row = 0; row < this->Rows; ++row)
  {
    const double extinction =
      this->GetExtinction(row, this->Opacities[row].GetSmallestAboveZero(this->ScalarRange[row]));
    if (extinction > 0.0 && (smallest == 0.0 || extinction < smallest))
    {
      smallest = extinction;
    }
  }
  return smallest;
}

double MaterialTable::GetLargestExtinction(int row, double lower, double upper) const
{
  if (!(lower <= upper))
  {
    return 0.0;
  }
  const Range& range = this->OpacityRange[row];
  const double column = OnColumn * (range[1] - range[0]) / (Columns - 1);
  const auto near = [&](double value)
  { return std::max(column, OnTexel * std::abs(value - this->Offset[row])); };
  const double largest =
    this->Opacities[row].GetLargest({ { lower, upper } }, { { near(lower), near(upper) } });
  return static_cast<float>(this->GetExtinction(row, largest));
}

}
