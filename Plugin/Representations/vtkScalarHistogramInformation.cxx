// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScalarHistogramInformation.h"

#include "OpacityEstimate.h"

#include "vtkAlgorithm.h"
#include "vtkClientServerStream.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkMultiProcessStream.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <functional>

vtkStandardNewMacro(vtkScalarHistogramInformation);

namespace
{
constexpr vtkIdType MAXIMUM_SAMPLES = 1 << 20;

double GetMagnitude(vtkDataArray* array, vtkIdType index)
{
  double sum = 0.0;
  for (int i = 0; i < array->GetNumberOfComponents(); ++i)
  {
    const double value = array->GetComponent(index, i);
    sum += value * value;
  }
  return std::sqrt(sum);
}
}

vtkScalarHistogramInformation::vtkScalarHistogramInformation()
  : Histogram(std::make_unique<interlume::ValueHistogram>())
{
}

vtkScalarHistogramInformation::~vtkScalarHistogramInformation() = default;

void vtkScalarHistogramInformation::Initialize(int port, int association, const std::string& array,
  int component, const interlume::ValueHistogram& histogram)
{
  this->Port = port;
  this->Association = association;
  this->Array = array;
  this->Component = component;
  *this->Histogram = histogram;
}

void vtkScalarHistogramInformation::CopyFromObject(vtkObject* object)
{
  std::fill(this->Histogram->Counts.begin(), this->Histogram->Counts.end(), 0.0);
  auto* algorithm = vtkAlgorithm::SafeDownCast(object);
  const bool hasPort = algorithm && this->Port < algorithm->GetNumberOfOutputPorts();
  vtkDataObject* data = hasPort ? algorithm->GetOutputDataObject(this->Port) : nullptr;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    for (vtkDataSet* part : vtkCompositeDataSet::GetDataSets(composite))
    {
      this->AddDataSet(part);
    }
  }
  else
  {
    this->AddDataSet(vtkDataSet::SafeDownCast(data));
  }
}

void vtkScalarHistogramInformation::AddDataSet(vtkDataSet* data)
{
  vtkDataArray* array =
    data ? data->GetAttributes(this->Association)->GetArray(this->Array.c_str()) : nullptr;
  if (!array || this->Component >= array->GetNumberOfComponents())
  {
    return;
  }
  const vtkIdType count = array->GetNumberOfTuples();
  const vtkIdType step = std::max<vtkIdType>(1, count / MAXIMUM_SAMPLES);
  vtkIdType offset = 0;
  for (vtkIdType begin = 0; begin < count; begin += step)
  {
    // Vary the offset. With a constant offset, all samples of an image could be in the same few
    // columns.
    offset = (offset * 5 + 3) % step;
    const vtkIdType index = std::min(begin + offset, count - 1);
    this->Histogram->Add(this->Component < 0 ? GetMagnitude(array, index)
                                             : array->GetComponent(index, this->Component),
      static_cast<double>(step));
  }
}

void vtkScalarHistogramInformation::AddInformation(vtkPVInformation* other)
{
  if (auto* histogram = vtkScalarHistogramInformation::SafeDownCast(other))
  {
    std::vector<double>& counts = this->Histogram->Counts;
    const std::vector<double>& added = histogram->Histogram->Counts;
    counts.resize(std::max(counts.size(), added.size()));
    std::transform(added.begin(), added.end(), counts.begin(), counts.begin(), std::plus<double>());
  }
}

void vtkScalarHistogramInformation::CopyToStream(vtkClientServerStream* stream)
{
  const std::vector<double>& counts = this->Histogram->Counts;
  stream->Reset();
  *stream << vtkClientServerStream::Reply
          << vtkClientServerStream::InsertArray(counts.data(), static_cast<int>(counts.size()))
          << vtkClientServerStream::End;
}

void vtkScalarHistogramInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  vtkTypeUInt32 size = 0;
  std::vector<double>& counts = this->Histogram->Counts;
  counts.clear();
  if (stream->GetArgumentLength(0, 0, &size))
  {
    counts.resize(size);
    stream->GetArgument(0, 0, counts.data(), size);
  }
}

void vtkScalarHistogramInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << this->Port << this->Association << this->Array << this->Component
         << this->Histogram->First << this->Histogram->Width
         << static_cast<int>(this->Histogram->Counts.size());
}

void vtkScalarHistogramInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  int bins = 0;
  stream >> this->Port >> this->Association >> this->Array >> this->Component >>
    this->Histogram->First >> this->Histogram->Width >> bins;
  this->Histogram->Counts.assign(static_cast<std::size_t>(std::max(bins, 0)), 0.0);
}

void vtkScalarHistogramInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Array: " << this->Array << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Bins: " << this->Histogram->Counts.size() << "\n";
}
