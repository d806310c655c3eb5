// SPDX-License-Identifier: BSD-3-Clause
// Material tables: color, extinction, gradient opacity and transmission at all columns and between
// them, compared with the transfer functions; upper bounds of the extinction, compared with brute
// force; extremes and invalid properties.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "Volume/MaterialTable.h"
#include "Volume/TransferNodes.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"
#include "Volume/VolumeSamples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr std::size_t Columns = interlume::MaterialTable::Columns;
using Range = std::array<double, 2>;

/// Creates two voxels, one with the lower and one with the upper values of the ranges.
interlume::VolumeSamples MakeSamples(const std::vector<Range>& ranges)
{
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfComponents(static_cast<int>(ranges.size()));
  array->SetNumberOfTuples(2);
  for (std::size_t c = 0; c < ranges.size(); ++c)
  {
    array->SetComponent(0, static_cast<int>(c), ranges[c][0]);
    array->SetComponent(1, static_cast<int>(c), ranges[c][1]);
  }
  interlume::VolumeSamples samples;
  static_cast<void>(samples.Build(array, { { 2, 1, 1 } }, false));
  return samples;
}

vtkNew<vtkPiecewiseFunction> MakeRamp(double x0, double y0, double x1, double y1)
{
  vtkNew<vtkPiecewiseFunction> ramp;
  ramp->AddPoint(x0, y0);
  ramp->AddPoint(x1, y1);
  return ramp;
}

double ScalarOf(const Range& range, std::size_t column)
{
  return range[0] + (range[1] - range[0]) * column / (Columns - 1);
}

float ValueOf(
  const interlume::MaterialTable& table, std::size_t row, std::size_t column, std::size_t channel)
{
  return table.Colors[4 * (row * Columns + column) + channel];
}

/// Returns the value of a table at the scalar \a x, as the shader computes it. A texel has
/// \a stride channels. If \a stride is above 1 and \a first is 0, returns the first three channels,
/// otherwise only channel \a first.
std::array<double, 3> Sample(const interlume::MaterialTable& table,
  const std::vector<float>& values, const std::vector<int>& bends,
  const std::vector<std::array<float, 2>>& edges, std::size_t first, std::size_t stride,
  const Range& range, double x)
{
  const std::size_t channels = stride > 1 && first == 0 ? 3 : 1;
  const double column =
    std::clamp((x - range[0]) / (range[1] - range[0]) * (Columns - 1), 0.0, Columns - 1.0);
  const std::size_t left = std::min(static_cast<std::size_t>(column), Columns - 2);
  const double offset = column - static_cast<double>(left);
  std::array<double, 3> result{};
  if (bends[left] > 0)
  {
    const float* list = &table.Bends[4 * static_cast<std::size_t>(bends[left])];
    const auto pieces = static_cast<std::size_t>(list[0]);
    // With one channel, a texel stores both nodes of a piece. With three channels, it stores one
    // node.
    const std::size_t end = channels == 1 ? 1 : 4;
    std::size_t piece = 1;
    while (piece < pieces && list[4 * piece + end] <= offset)
    {
      ++piece;
    }
    const float* a = &list[4 * piece];
    const double inside = std::clamp((offset - a[0]) / std::max(a[end] - a[0], 1e-30F), 0.0, 1.0);
    for (std::size_t c = 0; c < channels; ++c)
    {
      const double first = channels == 1 ? a[2] : a[1 + c];
      const double last = channels == 1 ? a[3] : a[5 + c];
      result[c] = first + inside * (last - first);
    }
    return result;
  }
  const std::array<float, 2>& edge = edges[left];
  const double inside =
    std::clamp((offset - edge[0]) / std::max(edge[1] - edge[0], 1e-5F), 0.0, 1.0);
  for (std::size_t c = 0; c < channels; ++c)
  {
    const double a = values[first + stride * left + c];
    result[c] = a + inside * (values[first + stride * (left + 1) + c] - a);
  }
  return result;
}

/// Returns the allowed opacity error. For a sharpness of 1, some versions of VTK evaluate a curve
/// instead of a step. If the midpoint is off center, the slope then changes so much within one
/// column that interlume::TransferColumns has a larger error.
double GetOpacityBound(vtkPiecewiseFunction* opacity)
{
  std::array<double, 4> first{};
  std::array<double, 4> second{};
  opacity->GetNodeValue(0, first.data());
  opacity->GetNodeValue(1, second.data());
  const double beforeMidpoint = first[0] + 0.99 * first[2] * (second[0] - first[0]);
  const bool isBent =
    first[3] == 1.0 && first[2] != 0.5 && opacity->GetValue(beforeMidpoint) != first[1];
  return isBent ? 5e-3 : 2e-3;
}

/// Checks that a function with one node does not limit the range, regardless of the values in
/// memory next to the node.
void CheckSingleNode(Check& check)
{
  check.SetContext("one node");
  constexpr double position = 0.25;
  const Range range = { 0.0, 1.0 };
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(position, 0.5);
  // The node is allocated in a gap between blocks of the same size, which are filled with the
  // node's position.
  using Block = std::array<double, sizeof(interlume::TransferNodes::Node) / sizeof(double)>;
  std::vector<std::unique_ptr<Block>> blocks(64);
  for (auto& block : blocks)
  {
    block = std::make_unique<Block>();
    block->fill(position);
  }
  for (std::size_t i = 1; i < blocks.size(); i += 2)
  {
    blocks[i].reset();
  }
  const interlume::TransferNodes nodes(function);
  check.Equal(nodes.GetNodes().size(), 1, "nodes");
  check.That(nodes.ClipRange(range) == range, "the full range");
}

/// Tests functions with peaks, steps and curves that are much narrower than the data range.
void CheckShapes(Check& check)
{
  const interlume::VolumeSamples samples = MakeSamples({ { { -50.0, 1e7 } } });
  std::mt19937 random(3);
  const auto uniform = [&]() { return random() / static_cast<double>(random.max()); };
  const auto measure =
    [&](const std::string& name, vtkPiecewiseFunction* opacity, vtkColorTransferFunction* color)
  {
    check.SetContext(name);
    vtkNew<vtkVolumeProperty> property;
    property->SetScalarOpacity(opacity);
    property->SetColor(color);
    interlume::MaterialTable table;
    check.That(!table.Build(property, samples, color), "no error");
    check.That(table.OpacityRange[0][1] < 400.0, "the range is not the range of the data");
    std::vector<double> scalars = { -50.0, 1e7, 1e3 };
    for (int i = 0; i < 20000; ++i)
    {
      scalars.push_back(-20.0 + 320.0 * uniform());
    }
    double opacityError = 0.0;
    double colorError = 0.0;
    double transmissionError = 0.0;
    double below = 0.0;
    bool areFinite = true;
    for (const double x : scalars)
    {
      const double expected =
        std::min(-std::log1p(-std::clamp(opacity->GetValue(x), 0.0, 1.0)), 69.0);
      const double found = Sample(table, table.Colors, table.ExtinctionBends, table.ExtinctionEdges,
        3, 4, table.OpacityRange[0], x)[0];
      reference::KeepLargest(opacityError, std::abs(std::exp(-found) - std::exp(-expected)));
      below = std::max(below, expected - table.GetLargestExtinction(0, x - 1e-3, x + 1e-3));
      std::array<double, 3> rgb{};
      color->GetColor(x, rgb.data());
      const auto sampledColor = Sample(
        table, table.Colors, table.ColorBends, table.ColorEdges, 0, 4, table.ColorRange[0], x);
      const auto sampledTransmission = Sample(table, table.Transmission, table.TransmissionBends,
        table.TransmissionEdges, 0, 3, table.ColorRange[0], x);
      for (std::size_t c = 0; c < 3; ++c)
      {
        // VTK returns NaN for values below 0 on a logarithmic scale. The table must be finite.
        const bool isDefined = std::isfinite(rgb[c]);
        reference::KeepLargest(colorError, isDefined ? std::abs(sampledColor[c] - rgb[c]) : 0.0);
        reference::KeepLargest(
          transmissionError, isDefined ? std::abs(sampledTransmission[c] - rgb[c]) : 0.0);
        areFinite &= std::isfinite(sampledColor[c]) && std::isfinite(sampledTransmission[c]);
      }
    }
    check.Near(opacityError, 0.0, GetOpacityBound(opacity), "opacity", 1.0);
    check.Near(colorError, 0.0, 2e-3, "color", 1.0);
    check.Near(transmissionError, 0.0, 2e-3, "transmission", 1.0);
    check.That(areFinite, "all colors are finite");
    check.That(below < 1e-4, "the bound of the extinction is not below the extinction");
  };
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.1, 0.9, 0.3);
  color->AddRGBPoint(130.0, 0.8, 0.2, 0.1);
  color->AddRGBPoint(255.0, 0.2, 0.3, 1.0);
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 1.0);
  measure("a ramp", opacity, color);
  for (int peak = 0; peak < 500; ++peak)
  {
    opacity->AddPoint(20.0 + 0.01 * peak, peak % 2 == 0 ? 0.0 : 0.1 + 0.8 * uniform());
  }
  measure("500 nodes", opacity, color);
  for (const double sharpness : { 0.0, 0.4, 1.0 })
  {
    for (const double midpoint : { 0.5, 0.2 })
    {
      opacity->RemoveAllPoints();
      opacity->AddPoint(0.0, 0.05, midpoint, sharpness);
      opacity->AddPoint(101.0, 0.9, midpoint, sharpness);
      opacity->AddPoint(255.0, 0.1);
      color->RemoveAllPoints();
      color->AddRGBPoint(3.0, 0.1, 0.9, 0.3, midpoint, sharpness);
      color->AddRGBPoint(130.0, 0.8, 0.2, 0.1, midpoint, sharpness);
      color->AddRGBPoint(255.0, 0.2, 0.3, 1.0);
      for (const int space : { VTK_CTF_RGB, VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_STEP })
      {
        color->SetColorSpace(space);
        measure("sharpness " + std::to_string(sharpness) + ", midpoint " +
            std::to_string(midpoint) + ", space " + std::to_string(space),
          opacity, color);
      }
    }
  }
  color->SetColorSpaceToRGB();
  color->SetScaleToLog10();
  opacity->ClampingOff();
  color->ClampingOff();
  measure("a logarithmic scale without clamping", opacity, color);
  opacity->ClampingOn();
  color->ClampingOn();
  color->UseBelowRangeColorOn();
  color->UseAboveRangeColorOn();
  color->SetAboveRangeColor(0.0, 1.0, 0.0);
  measure("colors outside the range", opacity, color);
}

/// Checks that the extinction is -ln(1 - opacity) per unit distance, for a linear opacity function.
void CheckExtinction(Check& check)
{
  const interlume::VolumeSamples samples = MakeSamples({ { { -2.0, 3.0 } } });
  for (const double unit : { 1e-6, 0.25, 1.0, 1e6 })
  {
    check.SetContext("unit distance " + std::to_string(unit));
    vtkNew<vtkVolumeProperty> property;
    const auto ramp = MakeRamp(-2.0, 0.0, 3.0, 1.0);
    property->SetScalarOpacity(ramp);
    property->SetScalarOpacityUnitDistance(unit);
    // The weight of a single component has no effect.
    property->SetComponentWeight(0, 0.5);
    interlume::MaterialTable table;
    check.That(!table.Build(property, samples, nullptr), "no error");
    check.That(table.Kind == interlume::MaterialTable::INDEPENDENT && table.Rows == 1, "one row");
    // The default color function has the range 0 to 1024, which is limited to the data range.
    check.That(table.ColorRange[0] == Range{ { 0.0, 3.0 } }, "range of the colors");
    check.That(table.OpacityRange[0] == Range{ { -2.0, 3.0 } }, "range of the opacity");
    check.Equal(static_cast<long long>(table.Colors.size()), 4 * Columns, "values");
    for (std::size_t i = 0; i < Columns; ++i)
    {
      const long double opacity = static_cast<long double>(i) / (Columns - 1);
      const double depth =
        i == Columns - 1 ? 69.0 : std::min(static_cast<double>(-std::log1p(-opacity)), 69.0);
      check.Near(ValueOf(table, 0, i, 3), depth / unit, 1e-6, "extinction");
    }
    check.Near(
      table.GetLargestExtinction(0, -2.0, 3.0), 69.0 / unit, 1e-6, "the largest extinction");
  }
}

void CheckColors(Check& check)
{
  check.SetContext("RGB and gray");
  const interlume::VolumeSamples samples = MakeSamples({ { { 0.0, 10.0 } }, { { 100.0, 300.0 } } });
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.0, 1.0, 0.5);
  colors->AddRGBPoint(10.0, 1.0, 0.25, 0.5);
  const auto gray = MakeRamp(100.0, 0.25, 300.0, 0.75);
  const auto opacity = MakeRamp(0.0, 0.5, 10.0, 0.5);
  property->SetColor(0, colors);
  property->SetColor(1, gray);
  property->SetScalarOpacity(0, opacity);
  property->SetScalarOpacity(1, opacity);
  property->SetComponentWeight(1, 0.25);
  property->SetScalarOpacityUnitDistance(1, 2.0);
  interlume::MaterialTable table;
  check.That(!table.Build(property, samples, nullptr), "no error");
  check.Equal(table.Rows, 2, "rows");
  check.That(table.OpacityRange[1] == Range{ { 100.0, 300.0 } }, "range of the second component");
  for (std::size_t i = 0; i < Columns; ++i)
  {
    const double fraction = i / (Columns - 1.0);
    check.Near(ValueOf(table, 0, i, 0), fraction, 1e-6, "red", 1.0);
    check.Near(ValueOf(table, 0, i, 1), 1.0 - 0.75 * fraction, 1e-6, "green", 1.0);
    check.Near(ValueOf(table, 0, i, 2), 0.5, 1e-6, "blue");
    check.Near(ValueOf(table, 0, i, 3), std::log(2.0), 1e-6, "extinction");
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      check.Near(ValueOf(table, 1, i, channel), 0.25 + 0.5 * fraction, 1e-6, "gray");
    }
    check.Near(ValueOf(table, 1, i, 3), 0.25 * std::log(2.0) / 2.0, 1e-6, "weighted extinction");
  }

  check.SetContext("functions without points");
  vtkNew<vtkVolumeProperty> empty;
  vtkNew<vtkColorTransferFunction> noColors;
  vtkNew<vtkPiecewiseFunction> noOpacity;
  empty->SetColor(noColors);
  empty->SetScalarOpacity(noOpacity);
  check.That(!table.Build(empty, MakeSamples({ { { 0.0, 10.0 } } }), nullptr), "no error");
  check.Near(ValueOf(table, 0, Columns - 1, 1), 1.0, 1e-6, "white at the end");
  check.Near(ValueOf(table, 0, Columns - 1, 3), std::log(2.0), 1e-6, "0.5 at the end");
  check.Equal(noOpacity->GetSize() + noColors->GetSize(), 0, "the functions remain empty");
}

void CheckDependent(Check& check)
{
  vtkNew<vtkVolumeProperty> property;
  property->IndependentComponentsOff();
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
  colors->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
  const auto opacity = MakeRamp(0.0, 0.0, 255.0, 0.5);
  property->SetColor(colors);
  property->SetScalarOpacity(opacity);
  property->SetComponentWeight(0, 0.5);

  check.SetContext("color and opacity");
  interlume::MaterialTable table;
  check.That(!table.Build(property, MakeSamples({ { { 0.0, 1.0 } }, { { 0.0, 255.0 } } }), nullptr),
    "no error");
  check.That(table.Kind == interlume::MaterialTable::COLOR_OPACITY && table.Rows == 1, "one row");
  check.That(table.ColorRange[0] == Range{ { 0.0, 1.0 } }, "range of the colors");
  check.That(table.OpacityRange[0] == Range{ { 0.0, 255.0 } }, "range of the opacity");
  check.Equal(table.GetOpacityComponent(0), 1, "component of the opacity");
  check.Near(ValueOf(table, 0, Columns - 1, 0), 1.0, 1e-6, "red");
  check.Near(ValueOf(table, 0, Columns - 1, 3), std::log(2.0), 1e-6, "extinction");

  check.SetContext("bytes of RGB and opacity");
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetNumberOfComponents(4);
  bytes->SetNumberOfTuples(2);
  bytes->FillValue(255);
  bytes->SetComponent(0, 3, 0);
  interlume::VolumeSamples samples;
  check.That(!samples.Build(bytes, { { 2, 1, 1 } }, false), "samples");
  check.That(!table.Build(property, samples, nullptr), "no error");
  check.That(table.Kind == interlume::MaterialTable::RGB_OPACITY && table.Rows == 1, "one row");
  check.That(table.OpacityRange[0] == Range{ { 0.0, 255.0 } }, "0 to 255");
  check.Equal(table.GetOpacityComponent(0), 3, "component of the opacity");
  check.Near(ValueOf(table, 0, Columns - 1, 3), std::log(2.0), 1e-6, "extinction");
  check.Near(ValueOf(table, 0, 17, 2), 1.0, 0.0, "white");
}

void CheckGradientOpacity(Check& check)
{
  check.SetContext("gradient opacity");
  const interlume::VolumeSamples samples = MakeSamples({ { { 0.0, 80.0 } }, { { 0.0, 8.0 } } });
  vtkNew<vtkVolumeProperty> property;
  interlume::MaterialTable table;
  check.That(!table.Build(property, samples, nullptr), "no error");
  check.That(table.GradientOpacity.empty(), "no gradient opacity without a function");
  check.That(!property->HasGradientOpacity(0), "no gradient opacity function is created");
  property->GetGradientOpacity(0);
  check.That(!table.Build(property, samples, nullptr), "no error");
  check.That(table.GradientOpacity.empty(), "no gradient opacity with the default function");
  const auto ramp = MakeRamp(0.0, 0.0, 4.0, 1.0);
  property->SetGradientOpacity(1, ramp);
  check.That(!table.Build(property, samples, nullptr), "no error");
  check.Equal(static_cast<long long>(table.GradientOpacity.size()), 2 * Columns, "two rows");
  check.Near(table.GradientRange[0], 20.0, 1e-12, "a quarter of the range");
  check.Near(table.GradientRange[1], 2.0, 1e-12, "a quarter of the range");
  for (std::size_t i = 0; i < Columns; ++i)
  {
    check.Near(table.GradientOpacity[i], 1.0, 0.0, "without a function, the value is 1");
    check.Near(table.GradientOpacity[Columns + i], 0.5 * i / (Columns - 1), 1e-6, "the ramp");
  }
  property->SetDisableGradientOpacity(1, 1);
  check.That(!table.Build(property, samples, nullptr), "no error");
  check.That(table.GradientOpacity.empty(), "no gradient opacity if it is disabled");
}

void CheckTransmission(Check& check)
{
  check.SetContext("transmission");
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkColorTransferFunction> transmission;
  interlume::MaterialTable table;
  check.That(!table.Build(property, MakeSamples({ { { 0.0, 4.0 } } }), transmission), "no error");
  check.That(table.Transmission == std::vector<float>(3 * Columns, 0.0F),
    "without points, the transmission is black");
  transmission->AddRGBPoint(0.0, 0.0, 0.5, 1.0);
  transmission->AddRGBPoint(4.0, 1.0, 0.5, 0.0);
  check.That(!table.Build(property, MakeSamples({ { { 0.0, 4.0 } } }), transmission), "no error");
  for (std::size_t i = 0; i < Columns; ++i)
  {
    const double fraction = i / (Columns - 1.0);
    const std::size_t first = 3 * i;
    check.Near(table.Transmission[first], fraction, 1e-6, "red", 1.0);
    check.Near(table.Transmission[first + 1], 0.5, 1e-6, "green", 1.0);
    check.Near(table.Transmission[first + 2], 1.0 - fraction, 1e-6, "blue", 1.0);
  }
  const interlume::VolumeSamples two = MakeSamples({ { { 0.0, 4.0 } }, { { 0.0, 1.0 } } });
  check.That(static_cast<bool>(table.Build(property, two, transmission)),
    "independent components are an error");
  property->IndependentComponentsOff();
  check.That(!table.Build(property, two, transmission), "color and opacity are valid");
}

/// Checks the upper bounds of the extinction for a function with peaks, some of them narrower than
/// a column, and for a ramp.
void CheckLargest(Check& check)
{
  check.SetContext("the largest extinction");
  std::mt19937 random(7);
  const auto uniform = [&]() { return random() / static_cast<double>(random.max()); };
  vtkNew<vtkPiecewiseFunction> function;
  const Range range{ { -1.0, 3.0 } };
  function->AddPoint(-1.0, 0.0);
  function->AddPoint(3.0, 0.0);
  const double width = 4.0 / (Columns - 1);
  std::vector<double> peaks;
  for (std::size_t i = 0; i < 12; ++i)
  {
    const double x = ScalarOf(range, 150 + 320 * i) + width * (0.2 + 0.6 * uniform());
    peaks.push_back(x);
    const double half = (i % 2 == 0 ? 0.1 : 30.0) * width;
    function->AddPoint(x - half, 0.0);
    function->AddPoint(x, 0.1 + 0.8 * uniform());
    function->AddPoint(x + half, 0.0);
  }
  vtkNew<vtkVolumeProperty> property;
  property->SetScalarOpacity(function);
  interlume::MaterialTable table;
  check.That(!table.Build(property, MakeSamples({ range }), nullptr), "no error");
  const auto extinction = [&](double x) { return -std::log1p(-function->GetValue(x)); };
  const auto getMaximum = [&](double lower, double upper)
  {
    double largest = std::max(extinction(lower), extinction(upper));
    for (int i = 0; i < function->GetSize(); ++i)
    {
      std::array<double, 4> node{};
      function->GetNodeValue(i, node.data());
      largest =
        node[0] >= lower && node[0] <= upper ? std::max(largest, extinction(node[0])) : largest;
    }
    return largest;
  };
  for (int i = 0; i < 4000; ++i)
  {
    const double center = i % 2 == 0 ? -1.0 + 4.0 * uniform()
                                     : peaks[random() % peaks.size()] + 40.0 * width * uniform();
    const double reach = width * std::pow(2000.0, uniform());
    const double lower = std::clamp(center - reach, range[0], range[1]);
    const double upper = std::clamp(center + reach, range[0], range[1]);
    const double found = table.GetLargestExtinction(0, lower, upper);
    check.That(
      found >= getMaximum(lower, upper) * (1.0 - 1e-5), "the bound is not below the function");
    check.That(found <= getMaximum(std::max(lower - 1.01 * width, range[0]),
                          std::min(upper + 1.01 * width, range[1])) *
          (1.0 + 1e-5),
      "the bound is not above the function within one column");
  }

  check.SetContext("a background at the foot of a ramp");
  const auto ramp = MakeRamp(0.0, 0.0, 255.0, 1.0);
  property->SetScalarOpacity(ramp);
  check.That(!table.Build(property, MakeSamples({ { { 0.0, 255.0 } } }), nullptr), "build");
  check.That(table.GetLargestExtinction(0, 0.0, 0.0) == 0.0, "no extinction at 0");
  check.That(
    table.GetLargestExtinction(0, 0.0, 1e-5) == 0.0, "no extinction at 0 with rounding error");
  check.That(table.GetLargestExtinction(0, 0.0, 0.01) > 0.0, "some extinction next to 0");
  check.That(table.GetLargestExtinction(0, 1.0, 0.0) == 0.0, "no extinction in an empty range");
  check.Near(table.GetLargestExtinction(0, -1e9, 1e9), 69.0, 1e-6, "a range past both ends");
}

void CheckExtremes(Check& check)
{
  for (const Range& range :
    { Range{ { 5.0, 5.0 } }, Range{ { 0.0, 0.0 } }, Range{ { -1e308, 1e308 } },
      Range{ { 1e308, 1e308 } }, Range{ { 1e-320, 2e-320 } }, Range{ { 1e9, 1e9 + 1e-6 } } })
  {
    check.SetContext("range " + std::to_string(range[0]) + " to " + std::to_string(range[1]));
    vtkNew<vtkVolumeProperty> property;
    const auto opacity = MakeRamp(range[0] - 1.0, 0.5, range[0] + 1.0, 0.5);
    property->SetScalarOpacity(opacity);
    const interlume::VolumeSamples samples = MakeSamples({ range });
    interlume::MaterialTable table;
    check.That(!table.Build(property, samples, nullptr), "no error");
    const double width = table.OpacityRange[0][1] - table.OpacityRange[0][0];
    check.That(width > 0.0 && std::isfinite(width), "the range is finite");
    const double slope = samples.Scale[0] / width;
    check.That(slope > 0.0 && slope < 1e30,
      "the scale from texels to columns is representable in single precision");
    check.That(std::all_of(table.Colors.begin(), table.Colors.end(),
                 [](float c) { return std::isfinite(c); }),
      "finite values");
    check.Near(
      table.GetLargestExtinction(0, range[0], range[1]), std::log(2.0), 1e-6, "extinction");
    check.That(std::isfinite(table.GradientRange[0]) && table.GradientRange[0] > 0.0, "gradients");
  }
}

void CheckErrors(Check& check)
{
  check.SetContext("errors");
  interlume::MaterialTable table;
  vtkNew<vtkVolumeProperty> property;
  const interlume::VolumeSamples one = MakeSamples({ { { 0.0, 1.0 } } });
  property->SetScalarOpacityUnitDistance(0.0);
  check.That(table.Build(property, one, nullptr).GetMessage().find("is 0") != std::string::npos,
    "distance 0");
  property->SetScalarOpacityUnitDistance(1.0);
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  check.That(static_cast<bool>(table.Build(property, one, nullptr)),
    "a two-dimensional transfer function is an error");
  property->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  property->IndependentComponentsOff();
  check.That(!table.Build(property, one, nullptr), "a single component is always independent");
  const Range range{ { 0.0, 1.0 } };
  check.That(
    static_cast<bool>(table.Build(property, MakeSamples({ range, range, range }), nullptr)),
    "three components are an error");
}
}

int TestMaterialTable(int, char*[])
{
  Check check;
  CheckExtinction(check);
  CheckSingleNode(check);
  CheckShapes(check);
  CheckColors(check);
  CheckDependent(check);
  CheckGradientOpacity(check);
  CheckTransmission(check);
  CheckLargest(check);
  CheckExtremes(check);
  CheckErrors(check);
  return check.Result();
}
