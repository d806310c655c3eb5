// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/PointArrays.h"

#include "Arrays/ArrayInterpolator.h"
#include "Arrays/RowCoordinates.h"
#include "Output/ExtractionMemory.h"

#include "vtkDataArray.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

namespace interlume
{

struct PointArrays::Writer
{
  std::unique_ptr<ArrayInterpolator> In;
  vtkDataArray* Out;
  // Where the values are, once there is room, and the bytes of a tuple.
  char* Values;
  vtkIdType Size;
};

PointArrays::PointArrays(vtkDataSet* input, int precision)
  : Arrays(input, precision)
{
  if (vtkPointSet* pointSet = vtkPointSet::SafeDownCast(input))
  {
    this->AddWriter(pointSet->GetPoints()->GetData(), this->GetPoints()->GetData());
  }
  else
  {
    this->Rows = std::make_unique<RowCoordinates>(input);
  }
  for (const CarriedArrays::Carried& array : this->Arrays.GetArrays())
  {
    if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(array.In))
    {
      this->AddWriter(numbers, vtkDataArray::SafeDownCast(array.Out));
    }
  }
}

PointArrays::~PointArrays() = default;

void PointArrays::AddWriter(vtkDataArray* in, vtkDataArray* out)
{
  const vtkIdType size = out->GetNumberOfComponents() * out->GetDataTypeSize();
  this->Writers.push_back({ ArrayInterpolator::Make(in, out->GetDataType()), out, nullptr, size });
}

void PointArrays::Allocate(vtkIdType number)
{
  if (this->Rows)
  {
    ExtractionMemory::SetNumberOfTuples(this->GetPoints()->GetData(), number);
  }
  for (Writer& writer : this->Writers)
  {
    ExtractionMemory::SetNumberOfTuples(writer.Out, number);
    writer.Values = static_cast<char*>(writer.Out->GetVoidPointer(0));
  }
  this->HasRoom = true;
}

void PointArrays::Write(const ExtractionPoint* points, vtkIdType number, vtkIdType first) const
{
  if (this->Rows)
  {
    void* const out = this->GetPoints()->GetVoidPointer(0);
    if (this->GetPoints()->GetDataType() == VTK_FLOAT)
    {
      this->Rows->Fill(points, number, static_cast<float*>(out) + 3 * first);
    }
    else
    {
      this->Rows->Fill(points, number, static_cast<double*>(out) + 3 * first);
    }
  }
  for (const Writer& writer : this->Writers)
  {
    writer.In->Interpolate(
      points, static_cast<std::size_t>(number), writer.Values + first * writer.Size);
  }
}

void PointArrays::Keep(const KeptRuns& kept)
{
  std::vector<vtkDataArray*> outs;
  for (const Writer& writer : this->Writers)
  {
    outs.push_back(writer.Out);
  }
  if (this->Rows)
  {
    outs.push_back(this->GetPoints()->GetData());
  }
  for (vtkDataArray* out : outs)
  {
    const vtkIdType size = out->GetNumberOfComponents() * out->GetDataTypeSize();
    kept.Compact(static_cast<char*>(out->GetVoidPointer(0)), size);
    ExtractionMemory::Shorten(out, kept.GetNumber());
  }
}

}
