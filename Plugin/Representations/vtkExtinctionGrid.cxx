// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExtinctionGrid.h"

#include "vtkColorTransferFunction.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiProcessController.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double MaximumOpacity = 1.0 - 1e-6;
constexpr int TableSize = 4096;

/// Table of the extinction in each color channel over the range of the scalars.
class Extinctions
{
public:
  Extinctions(const vtkExtinctionGrid::Piece& piece, int channels)
    : Channels(channels)
    , Component(piece.Scalars->GetNumberOfComponents() - 1)
    , Values(static_cast<std::size_t>(channels) * TableSize)
  {
    piece.Scalars->GetRange(this->Range, this->Component);
    vtkVolumeProperty* property = piece.Property;
    for (int i = 0; i < TableSize; ++i)
    {
      const double value = this->Range[0] + (this->Range[1] - this->Range[0]) * i / (TableSize - 1);
      const double opacity =
        std::clamp(property->GetScalarOpacity(0)->GetValue(value), 0.0, MaximumOpacity);
      const double extinction = -std::log1p(-opacity) / property->GetScalarOpacityUnitDistance(0);
      double color[3] = { 0.0, 0.0, 0.0 };
      if (channels == 3)
      {
        property->GetRGBTransferFunction(0)->GetColor(value, color);
      }
      for (int k = 0; k < channels; ++k)
      {
        this->Values[i * channels + k] = static_cast<float>(extinction * (1.0 - color[k]));
      }
    }
  }

  /// Returns the extinction of a tuple in each channel, or null if its value is not finite.
  const float* Get(vtkDataArray* scalars, vtkIdType tuple) const
  {
    const double value = scalars->GetComponent(tuple, this->Component);
    if (!std::isfinite(value))
    {
      return nullptr;
    }
    const double extent = this->Range[1] - this->Range[0];
    const double fraction = extent > 0.0 ? (value - this->Range[0]) / extent : 0.0;
    const int index = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * (TableSize - 1) + 0.5);
    return this->Values.data() + static_cast<std::size_t>(index) * this->Channels;
  }

private:
  int Channels;
  int Component;
  double Range[2] = { 0.0, 0.0 };
  std::vector<float> Values;
};
}

std::array<double, 6> vtkExtinctionGrid::GetBounds(vtkImageData* image)
{
  double inverse[9];
  vtkMatrix3x3::Invert(image->GetDirectionMatrix()->GetData(), inverse);
  double origin[3];
  vtkMatrix3x3::MultiplyPoint(inverse, image->GetOrigin(), origin);
  std::array<double, 6> bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int* extent = image->GetExtent() + 2 * axis;
    const double ends[2] = { origin[axis] + extent[0] * image->GetSpacing()[axis],
      origin[axis] + extent[1] * image->GetSpacing()[axis] };
    bounds[2 * axis] = std::min(ends[0], ends[1]);
    bounds[2 * axis + 1] = std::max(ends[0], ends[1]);
  }
  return bounds;
}

std::vector<std::vector<vtkExtinctionGrid::Overlap>> vtkExtinctionGrid::FindOverlaps(
  const Piece& piece, int axis) const
{
  const int samples = piece.Image->GetDimensions()[axis] - (piece.IsOfCells ? 1 : 0);
  const double step = piece.Image->GetSpacing()[axis];
  const double spacing = std::abs(step);
  const std::array<double, 6> box = GetBounds(piece.Image);
  const double* bounds = &box[2 * axis];
  const double lower = this->Bounds[2 * axis];
  std::vector<std::vector<Overlap>> overlaps(std::max(samples, 0));
  for (int i = 0; i < samples; ++i)
  {
    const int index = step < 0.0 ? samples - 1 - i : i;
    // The voxel of a point sample extends by half the spacing to either side of the point.
    const double begin = bounds[0] + spacing * (piece.IsOfCells ? index : index - 0.5);
    const double from = std::max(begin, bounds[0]);
    const double to = std::min(begin + spacing, bounds[1]);
    const int last = this->Size[axis] - 1;
    const int first = std::clamp(static_cast<int>((from - lower) / this->Cell[axis]), 0, last);
    for (int cell = first; cell <= last; ++cell)
    {
      const double left = lower + cell * this->Cell[axis];
      const double length = std::min(to, left + this->Cell[axis]) - std::max(from, left);
      if (length > 0.0)
      {
        overlaps[i].push_back({ cell, length / this->Cell[axis] });
      }
      if (left + this->Cell[axis] >= to)
      {
        break;
      }
    }
  }
  return overlaps;
}

void vtkExtinctionGrid::Add(const Piece& piece, std::vector<float>& values) const
{
  const Extinctions extinctions(piece, this->Channels);
  const std::vector<std::vector<Overlap>> overlaps[] = { this->FindOverlaps(piece, 0),
    this->FindOverlaps(piece, 1), this->FindOverlaps(piece, 2) };
  vtkIdType tuple = 0;
  for (const std::vector<Overlap>& slice : overlaps[2])
  {
    for (const std::vector<Overlap>& row : overlaps[1])
    {
      for (const std::vector<Overlap>& sample : overlaps[0])
      {
        const float* extinction = extinctions.Get(piece.Scalars, tuple++);
        if (!extinction ||
          std::all_of(
            extinction, extinction + this->Channels, [](float value) { return value == 0.0f; }))
        {
          continue;
        }
        for (const Overlap& z : slice)
        {
          for (const Overlap& y : row)
          {
            for (const Overlap& x : sample)
            {
              const std::size_t cell = x.Cell +
                this->Size[0] * (y.Cell + static_cast<std::size_t>(this->Size[1]) * z.Cell);
              for (int k = 0; k < this->Channels; ++k)
              {
                values[cell * this->Channels + k] +=
                  static_cast<float>(x.Fraction * y.Fraction * z.Fraction * extinction[k]);
              }
            }
          }
        }
      }
    }
  }
}

void vtkExtinctionGrid::Gather(
  const Piece& piece, int resolution, vtkMultiProcessController* controller)
{
  double lower[3] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double upper[3] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  if (piece.Image)
  {
    const std::array<double, 6> bounds = GetBounds(piece.Image);
    for (int axis = 0; axis < 3; ++axis)
    {
      lower[axis] = bounds[2 * axis];
      upper[axis] = bounds[2 * axis + 1];
    }
  }
  double minimum[3];
  double maximum[3];
  controller->AllReduce(lower, minimum, 3, vtkCommunicator::MIN_OP);
  controller->AllReduce(upper, maximum, 3, vtkCommunicator::MAX_OP);
  const double extents[3] = { maximum[0] - minimum[0], maximum[1] - minimum[1],
    maximum[2] - minimum[2] };
  const double longest = *std::max_element(extents, extents + 3);
  this->Channels = piece.IsColored ? 3 : 1;
  this->IsFilled = false;
  if (!(longest > 0.0) || !std::isfinite(longest))
  {
    return;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Bounds[2 * axis] = minimum[axis];
    this->Bounds[2 * axis + 1] = maximum[axis];
    this->Size[axis] =
      std::max(1, static_cast<int>(std::ceil(resolution * extents[axis] / longest)));
    this->Cell[axis] = std::max(extents[axis], 1e-6 * longest) / this->Size[axis];
  }
  const std::size_t count =
    static_cast<std::size_t>(this->Channels) * this->Size[0] * this->Size[1] * this->Size[2];
  std::vector<float> local(count, 0.0f);
  if (piece.Image && piece.Scalars)
  {
    this->Add(piece, local);
  }
  this->Values.assign(count, 0.0f);
  controller->AllReduce(
    local.data(), this->Values.data(), static_cast<vtkIdType>(count), vtkCommunicator::SUM_OP);
  for (std::size_t i = 0; i < count; ++i)
  {
    // Treat a difference within rounding error as 0.
    const float outside = this->Values[i] - local[i];
    this->Values[i] = outside > 1e-6f * local[i] ? outside : 0.0f;
    this->IsFilled = this->IsFilled || this->Values[i] > 0.0f;
  }
}

double vtkExtinctionGrid::FindEntry(const std::array<double, 6>& bounds,
  const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double step = to[axis] - from[axis];
    const double lower = bounds[2 * axis] - from[axis];
    const double upper = bounds[2 * axis + 1] - from[axis];
    if (step == 0.0)
    {
      leave = lower > 0.0 || upper < 0.0 ? -1.0 : leave;
      continue;
    }
    enter = std::max(enter, std::min(lower / step, upper / step));
    leave = std::min(leave, std::max(lower / step, upper / step));
  }
  return enter <= leave ? enter : 2.0;
}

void vtkExtinctionGrid::Integrate(
  const std::array<double, 3>& from, const std::array<double, 3>& to, double* depths) const
{
  const double length = std::sqrt((to[0] - from[0]) * (to[0] - from[0]) +
    (to[1] - from[1]) * (to[1] - from[1]) + (to[2] - from[2]) * (to[2] - from[2]));
  const double cell = *std::min_element(this->Cell.begin(), this->Cell.end());
  // Use two steps per cell. Extinction is interpolated between the cell centers.
  const int steps = std::clamp(static_cast<int>(std::ceil(2.0 * length / cell)), 1, 4096);
  for (int step = 0; step < steps; ++step)
  {
    int index[3];
    double fraction[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double point = from[axis] + (to[axis] - from[axis]) * (step + 0.5) / steps;
      const double position = std::clamp(
        (point - this->Bounds[2 * axis]) / this->Cell[axis] - 0.5, 0.0, this->Size[axis] - 1.0);
      index[axis] = std::min(static_cast<int>(position), std::max(this->Size[axis] - 2, 0));
      fraction[axis] = position - index[axis];
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = length / steps;
      std::size_t cellIndex = 0;
      for (int axis = 2; axis >= 0; --axis)
      {
        const int next = (corner >> axis) & 1;
        weight *= next ? fraction[axis] : 1.0 - fraction[axis];
        cellIndex =
          cellIndex * this->Size[axis] + std::min(index[axis] + next, this->Size[axis] - 1);
      }
      for (int k = 0; weight > 0.0 && k < this->Channels; ++k)
      {
        depths[k] += weight * this->Values[cellIndex * this->Channels + k];
      }
    }
  }
}
