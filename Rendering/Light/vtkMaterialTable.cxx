#include "vtkMaterialTable.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeSamples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
constexpr int Columns = vtkMaterialTable::Columns;
/// Columns, and the gaps between them.
constexpr int Places = 2 * Columns - 1;
/// Powers of two up to Places.
constexpr int Levels = 13;
static_assert((1 << Levels) > Places && (1 << (Levels - 1)) <= Places, "one row of each width");
/// Texels are rounded, and graphics cards interpolate with 8 bits: values closer to a column, in
/// columns, are taken to be on it.
constexpr double OnColumn = 1e-3;

/// The component's range where that is wide enough to be told apart in texels, else a wider one.
/// Differences of its ends are finite.
std::array<double, 2> FindTableRange(const vtkVolumeSamples& samples, int component)
{
  constexpr double largest = 0.25 * std::numeric_limits<double>::max();
  const double lower = std::clamp(samples.Range[component][0], -largest, largest);
  const double upper = std::clamp(samples.Range[component][1], -largest, largest);
  const double scale = samples.Scale[component];
  return { { lower, upper - lower < scale / 65536.0 ? lower + scale / 256.0 : upper } };
}

/// Where \a value lies in a row, in columns, 0 to Columns - 1.
double FindColumn(const std::array<double, 2>& range, double value)
{
  const double part = (value - range[0]) / (range[1] - range[0]);
  const double column = std::clamp(part, 0.0, 1.0) * (Columns - 1);
  const double nearest = std::round(column);
  return std::abs(column - nearest) < OnColumn ? nearest : column;
}

double FindExtinction(double opacity, double unitDistance)
{
  const double clamped = std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) : 0.0;
  const double depth = std::min(-std::log1p(-clamped), vtkMaterialTable::LargestOpticalDepth);
  return std::min(depth / unitDistance, static_cast<double>(std::numeric_limits<float>::max()));
}

/// The values of a function, or a ramp to \a last where it has no points, as in VTK.
std::vector<double> Sample(
  vtkPiecewiseFunction* function, const std::array<double, 2>& range, double last)
{
  std::vector<double> values(Columns);
  if (function->GetSize() > 0)
  {
    function->GetTable(range[0], range[1], Columns, values.data());
    return values;
  }
  for (int i = 0; i < Columns; ++i)
  {
    values[static_cast<std::size_t>(i)] = last * i / (Columns - 1);
  }
  return values;
}

/// Red, green, blue of each column.
std::vector<double> SampleColors(
  vtkVolumeProperty* property, int component, const std::array<double, 2>& range)
{
  std::vector<double> colors(3 * Columns);
  if (property->GetColorChannels(component) == 3 &&
    property->GetRGBTransferFunction(component)->GetSize() > 0)
  {
    property->GetRGBTransferFunction(component)->GetTable(
      range[0], range[1], Columns, colors.data());
    return colors;
  }
  vtkNew<vtkPiecewiseFunction> none;
  const std::vector<double> grays =
    Sample(property->GetColorChannels(component) == 1 ? property->GetGrayTransferFunction(component)
                                                      : none.Get(),
      range, 1.0);
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    colors[i] = grays[i / 3];
  }
  return colors;
}
}

//------------------------------------------------------------------------------
std::string vtkMaterialTable::Build(vtkVolumeProperty* property, const vtkVolumeSamples& samples,
  vtkColorTransferFunction* transmission)
{
  *this = vtkMaterialTable();
  const bool independent = property->GetIndependentComponents() || samples.Components == 1;
  if (!independent && samples.Components == 3)
  {
    return "three components that are not independent have no opacity";
  }
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
  {
    return "transfer functions of two dimensions are not supported";
  }
  if (transmission && (independent ? samples.Components != 1 : samples.Components != 2))
  {
    return "TransmissionColor is for one component, or for two that are not independent, not for " +
      std::to_string(samples.Components);
  }
  const int rows = independent ? samples.Components : 1;
  for (int row = 0; row < rows; ++row)
  {
    const double unit = property->GetScalarOpacityUnitDistance(row);
    if (!(unit > 0.0) || !std::isfinite(unit))
    {
      return "ScalarOpacityUnitDistance of component " + std::to_string(row) + " is " +
        std::to_string(unit) + "; it must be above 0";
    }
  }

  this->Kind = independent ? INDEPENDENT : samples.Components == 2 ? COLOR_OPACITY : RGB_OPACITY;
  this->Rows = rows;
  for (int row = 0; row < rows; ++row)
  {
    this->OpacityRange[row] = FindTableRange(samples, this->GetOpacityComponent(row));
    this->ColorRange[row] =
      this->Kind == COLOR_OPACITY ? FindTableRange(samples, 0) : this->OpacityRange[row];
    this->GradientRange[row] = 0.25 * (this->OpacityRange[row][1] - this->OpacityRange[row][0]);
    this->BuildRow(property, row);
  }
  this->BuildGradientOpacity(property);
  this->BuildTransmission(transmission);
  return std::string();
}

//------------------------------------------------------------------------------
void vtkMaterialTable::BuildRow(vtkVolumeProperty* property, int row)
{
  vtkPiecewiseFunction* function = property->GetScalarOpacity(row);
  const double unit = property->GetScalarOpacityUnitDistance(row);
  const double weight = this->Rows > 1 ? property->GetComponentWeight(row) : 1.0;
  const std::vector<double> opacities = Sample(function, this->OpacityRange[row], 0.5);
  const std::vector<double> colors = this->Kind == RGB_OPACITY
    ? std::vector<double>(3 * Columns, 1.0)
    : SampleColors(property, row, this->ColorRange[row]);

  std::vector<float> largest(Places, 0.0F);
  for (std::size_t i = 0; i < Columns; ++i)
  {
    const auto extinction = static_cast<float>(weight * FindExtinction(opacities[i], unit));
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      this->Colors.push_back(static_cast<float>(colors[3 * i + channel]));
    }
    this->Colors.push_back(extinction);
    largest[2 * i] = extinction;
  }
  for (int node = 0; node < function->GetSize(); ++node)
  {
    std::array<double, 4> point{};
    function->GetNodeValue(node, point.data());
    if (point[0] >= this->OpacityRange[row][0] && point[0] <= this->OpacityRange[row][1])
    {
      const double column = FindColumn(this->OpacityRange[row], point[0]);
      const auto place = static_cast<std::size_t>(std::floor(column) + std::ceil(column));
      largest[place] =
        std::max(largest[place], static_cast<float>(weight * FindExtinction(point[1], unit)));
    }
  }

  for (int level = 0; level < Levels; ++level)
  {
    const std::size_t width = std::size_t(1) << level;
    this->Largest.insert(this->Largest.end(), largest.begin(), largest.end());
    for (std::size_t i = 0; i + width < Places; ++i)
    {
      largest[i] = std::max(largest[i], largest[i + width]);
    }
  }
}

//------------------------------------------------------------------------------
void vtkMaterialTable::BuildGradientOpacity(vtkVolumeProperty* property)
{
  bool any = false;
  std::vector<float> values;
  for (int row = 0; row < this->Rows; ++row)
  {
    std::vector<double> opacities(Columns, 1.0);
    // Asking for a function that is not there would make one. One that is disabled is 1.
    if (property->HasGradientOpacity(row))
    {
      opacities =
        Sample(property->GetGradientOpacity(row), { { 0.0, this->GradientRange[row] } }, 0.5);
    }
    for (const double opacity : opacities)
    {
      values.push_back(static_cast<float>(std::clamp(opacity, 0.0, 1.0)));
      any = any || values.back() < 1.0F;
    }
  }
  if (any)
  {
    this->GradientOpacity = std::move(values);
  }
}

//------------------------------------------------------------------------------
void vtkMaterialTable::BuildTransmission(vtkColorTransferFunction* transmission)
{
  if (!transmission)
  {
    return;
  }
  std::vector<double> colors(3 * Columns, 0.0);
  if (transmission->GetSize() > 0)
  {
    transmission->GetTable(this->ColorRange[0][0], this->ColorRange[0][1], Columns, colors.data());
  }
  for (const double color : colors)
  {
    this->Transmission.push_back(static_cast<float>(std::clamp(color, 0.0, 1.0)));
  }
}

//------------------------------------------------------------------------------
double vtkMaterialTable::GetLargestExtinction(int row, double lower, double upper) const
{
  if (!(lower <= upper))
  {
    return 0.0;
  }
  const auto first =
    static_cast<std::size_t>(2.0 * std::floor(FindColumn(this->OpacityRange[row], lower)));
  const auto last =
    static_cast<std::size_t>(2.0 * std::ceil(FindColumn(this->OpacityRange[row], upper)));
  std::size_t level = 0;
  while ((std::size_t(2) << level) <= last - first + 1)
  {
    ++level;
  }
  const float* largest = &this->Largest[(static_cast<std::size_t>(row) * Levels + level) * Places];
  return std::max(largest[first], largest[last + 1 - (std::size_t(1) << level)]);
}
