// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConstructiveVolume.h"

#include "Common/Batches.h"
#include "Common/Error.h"
#include "Sampling/ExtentRows.h"
#include "Sampling/PartPrinter.h"
#include "Sampling/SourceReport.h"
#include "Sampling/SpatialSampler.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkConstructiveVolume);

namespace
{
// Fraction of the progress reserved for the colors of points without density.
constexpr double DilationFraction = 0.1;

void Store(double value, float& stored)
{
  stored = static_cast<float>(value);
}

void Store(double value, unsigned char& stored)
{
  stored = static_cast<unsigned char>(std::lround(255.0 * value));
}

template <typename Value>
void Store(const vtkSpatialObject::Sample& sample, int numberOfComponents, Value* stored)
{
  Store(sample.Density, stored[numberOfComponents - 1]);
  for (int c = 0; c + 1 < numberOfComponents; ++c)
  {
    Store(sample.Color[c], stored[c]);
  }
}

// In rows first ... last - 1 of an extent, sets the color of points without density to the mean
// color of those of their 26 neighbors that have density. Only densities and colors of points with
// density are read, and neither is written, so the rows can be processed in any order.
template <typename Value>
void DilateRows(Value* values, const int extent[6], vtkIdType first, vtkIdType last)
{
  const int size[3] = { extent[1] - extent[0] + 1, extent[3] - extent[2] + 1,
    extent[5] - extent[4] + 1 };
  for (vtkIdType row = first; row < last; ++row)
  {
    const int y = static_cast<int>(row % size[1]);
    const int z = static_cast<int>(row / size[1]);
    // The row and its neighbors inside the extent.
    const Value* rows[9];
    int number = 0;
    for (int k = std::max(z - 1, 0); k <= std::min(z + 1, size[2] - 1); ++k)
    {
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size[1] - 1); ++j)
      {
        rows[number++] = values + (static_cast<vtkIdType>(k) * size[1] + j) * size[0] * 4;
      }
    }
    Value* written = values + row * size[0] * 4;
    for (int x = 0; x < size[0]; ++x)
    {
      if (written[4 * x + 3] > 0)
      {
        continue;
      }
      double sums[3] = { 0.0, 0.0, 0.0 };
      int count = 0;
      for (int r = 0; r < number; ++r)
      {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size[0] - 1); ++i)
        {
          const Value* value = rows[r] + static_cast<vtkIdType>(4) * i;
          if (value[3] > 0)
          {
            ++count;
            sums[0] += value[0];
            sums[1] += value[1];
            sums[2] += value[2];
          }
        }
      }
      for (int c = 0; c < 3; ++c)
      {
        written[4 * x + c] = static_cast<Value>(count ? sums[c] / count : 0.0);
      }
    }
  }
}

// Computes the values of all rows of an extent in parallel.
template <typename Value>
bool SampleRows(const interlume::SpatialSampler& sampler, const int extent[6],
  int numberOfComponents, Value* values, vtkAlgorithm* owner)
{
  const auto makeRow = [&](int j, int k, vtkIdType point)
  {
    vtkSpatialObject::Sample samples[vtkSpatialObject::SpanLength];
    Value* stored = values + point * numberOfComponents;
    for (int i = extent[0]; i <= extent[1]; i += vtkSpatialObject::SpanLength)
    {
      const int number = std::min(extent[1] + 1 - i, vtkSpatialObject::SpanLength);
      const int ijk[3] = { i, j, k };
      sampler.SampleSpan(ijk, number, samples);
      for (int s = 0; s < number; ++s, stored += numberOfComponents)
      {
        Store(samples[s], numberOfComponents, stored);
      }
    }
  };
  const bool isColored = numberOfComponents > 1;
  if (!interlume::ExtentRows::Run(
        extent, owner, 0.0, isColored ? 1.0 - DilationFraction : 1.0, makeRow))
  {
    return false;
  }
  const vtkIdType rows =
    static_cast<vtkIdType>(extent[3] - extent[2] + 1) * (extent[5] - extent[4] + 1);
  const auto dilate = [&](vtkIdType first, vtkIdType last)
  { DilateRows(values, extent, first, last); };
  return !isColored || interlume::Batches::Run(rows, owner, 1.0 - DilationFraction, 1.0, dilate);
}
}

vtkConstructiveVolume::vtkConstructiveVolume() = default;

vtkConstructiveVolume::~vtkConstructiveVolume() = default;

const char* vtkConstructiveVolume::GetOutputModeName(int mode)
{
  static const char* const names[NUMBER_OF_OUTPUT_MODES] = { "density", "color bytes",
    "color floats" };
  return mode >= 0 && mode < NUMBER_OF_OUTPUT_MODES ? names[mode] : nullptr;
}

vtkCxxSetSmartPointerMacro(vtkConstructiveVolume, Root, vtkSpatialObject);

vtkSpatialObject* vtkConstructiveVolume::GetRoot() const
{
  return this->Root;
}

vtkMTimeType vtkConstructiveVolume::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Root ? std::max(own, this->Root->GetMTime()) : own;
}

void vtkConstructiveVolume::FitRoot(int resolution, double margin)
{
  double box[6];
  if (!this->Root || !this->Root->GetBounds(box))
  {
    vtkErrorMacro("FitRoot: there is no root, or its bounds are not available. Call SetRoot with a "
                  "valid vtkSpatialObject first.");
    return;
  }
  double lengths[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    lengths[axis] = box[2 * axis + 1] - box[2 * axis];
  }
  const double longest = *std::max_element(lengths, lengths + 3);
  if (!(*std::min_element(lengths, lengths + 3) >= 0.0) || !(longest > 0.0) ||
    !std::isfinite(longest) || !std::isfinite(margin) || !(margin > 0.0))
  {
    vtkErrorMacro("FitRoot: the bounds of the root must be finite and not empty, and the margin ("
      << margin << ") must be finite and greater than 0.");
    return;
  }
  int dimensions[3];
  const int points = std::max(2, resolution);
  const double spacing = longest * (1.0 + 2.0 * margin) / (points - 1);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = lengths[axis] + 2.0 * margin * longest;
    dimensions[axis] = std::max(2, static_cast<int>(std::lround(length / spacing)) + 1);
    box[2 * axis] -= margin * longest;
    box[2 * axis + 1] += margin * longest;
  }
  this->SetBounds(box);
  this->SetDimensions(dimensions[0], dimensions[1], dimensions[2]);
}

double vtkConstructiveVolume::Evaluate(const double x[3], double color[3])
{
  vtkSpatialObject::Sample sample;
  if (this->Root)
  {
    this->Root->Evaluate(x, sample);
  }
  else
  {
    vtkErrorMacro("Evaluate: there is no root. Call SetRoot first.");
  }
  if (color)
  {
    std::copy_n(sample.Color, 3, color);
  }
  return sample.Density;
}

int vtkConstructiveVolume::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestInformation(request, inputs, outputs);
  vtkDataObject::SetPointDataActiveScalarInfo(outputs->GetInformationObject(0),
    this->OutputMode == COLOR_BYTES ? VTK_UNSIGNED_CHAR : VTK_FLOAT,
    this->OutputMode == DENSITY ? 1 : 4);
  return 1;
}

bool vtkConstructiveVolume::Sample(const int extent[6], vtkDataArray* values)
{
  double origin[3];
  double spacing[3];
  this->GetOriginAndSpacing(origin, spacing);
  const interlume::SpatialSampler sampler(this->Root, origin, spacing, this->NumberOfSubsamples);
  const int components = values->GetNumberOfComponents();
  if (auto* bytes = vtkUnsignedCharArray::SafeDownCast(values))
  {
    return SampleRows(sampler, extent, components, bytes->GetPointer(0), this);
  }
  auto* floats = vtkFloatArray::SafeDownCast(values);
  return SampleRows(sampler, extent, components, floats->GetPointer(0), this);
}

int vtkConstructiveVolume::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  interlume::SourceReport().CopyTo(this->GetReport());
  if (const interlume::Error error = this->Root
      ? this->Root->Update()
      : "The vtkConstructiveVolume has no root to sample. Call SetRoot.")
  {
    vtkErrorMacro(<< error);
    image->Initialize();
    return 1;
  }
  // Colors of points without density depend on neighbors outside the requested extent.
  int requested[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), requested);
  int extent[6];
  std::copy_n(requested, 6, extent);
  for (int axis = 0; axis < 3 && this->OutputMode != DENSITY; ++axis)
  {
    extent[2 * axis] = std::max(requested[2 * axis] - 1, this->GetWholeExtent()[2 * axis]);
    extent[2 * axis + 1] =
      std::min(requested[2 * axis + 1] + 1, this->GetWholeExtent()[2 * axis + 1]);
  }
  this->SetGeometry(image, extent);
  vtkSmartPointer<vtkDataArray> values = vtk::TakeSmartPointer(
    vtkDataArray::CreateDataArray(this->OutputMode == COLOR_BYTES ? VTK_UNSIGNED_CHAR : VTK_FLOAT));
  values->SetName(this->OutputMode == DENSITY ? "Density" : "Color");
  values->SetNumberOfComponents(this->OutputMode == DENSITY ? 1 : 4);
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  if (!this->Sample(extent, values))
  {
    image->Initialize();
    return 1;
  }
  image->GetPointData()->SetScalars(values);
  const vtkIdType samples = image->GetNumberOfPoints();
  image->Crop(requested);
  const int n = this->NumberOfSubsamples;
  interlume::SourceReport::Of(image, samples * n * n * n).CopyTo(this->GetReport());
  this->UpdateProgress(1.0);
  return 1;
}

void vtkConstructiveVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputMode: " << GetOutputModeName(this->OutputMode) << "\n";
  os << indent << "NumberOfSubsamples: " << this->NumberOfSubsamples << "\n";
  interlume::PartPrinter::Print(os, indent, "Root", this->Root);
}
