// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/PointArrays.h"

#include "Arrays/ArrayInterpolator.h"
#include "Arrays/ExtractionArrays.h"
#include "Arrays/RowCoordinates.h"
#include "Common/ArrayMatch.h"
#include "Output/OutputAllocation.h"
#include "Output/ThreadGrain.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>

namespace interlume
{

namespace
{
// Copies the tuples of all corners. \a Known is the size of a tuple in bytes if it is known at
// compile time, which avoids a loop over bytes, otherwise 0.
template <std::size_t Known>
void CopyTuples(const char* values, const PointArrays::Part& part, std::size_t size, char* out)
{
  const std::size_t bytes = Known ? Known : size;
  const PointArrays::Part::Index* const corners = part.Corners.GetData();
  for (std::size_t c = 0; c < part.Corners.GetSize(); ++c)
  {
    std::memcpy(out + c * bytes, values + corners[c] * bytes, bytes);
  }
}

void CopyCorners(const char* values, const PointArrays::Part& part, std::size_t size, char* out)
{
  switch (size)
  {
    case sizeof(float):
      return CopyTuples<sizeof(float)>(values, part, size, out);
    case sizeof(double):
      return CopyTuples<sizeof(double)>(values, part, size, out);
    case 3 * sizeof(float):
      return CopyTuples<3 * sizeof(float)>(values, part, size, out);
    case 3 * sizeof(double):
      return CopyTuples<3 * sizeof(double)>(values, part, size, out);
    default:
      return CopyTuples<0>(values, part, size, out);
  }
}
}

struct PointArrays::Column
{
  std::unique_ptr<ArrayInterpolator> In;
  vtkDataArray* Out;
  // The values of Out, set by Allocate(), and the size of a tuple in bytes.
  char* Values;
  std::size_t Size;

  // Returns the size of the values of \a points points in bytes, padded to align the next column.
  std::size_t GetBytes(std::size_t points) const
  {
    constexpr std::size_t step = sizeof(double);
    return (points * this->Size + step - 1) / step * step;
  }
};

PointArrays::PointArrays() = default;

PointArrays::PointArrays(vtkDataSet* input, int precision)
{
  this->AddCoordinates(input, precision);
  this->AddArrays(input->GetPointData(), input->GetPointData(), VTK_ID_MAX);
}

PointArrays::PointArrays(vtkPointData* first, vtkPointData* second, vtkIdType split)
{
  this->AddArrays(first, second, split);
}

PointArrays::~PointArrays() = default;

vtkSmartPointer<vtkPoints> PointArrays::MakePoints(
  vtkDataSet* input, const ExtractionBuffer<ExtractionPoint>& points, int precision)
{
  PointArrays made;
  made.AddCoordinates(input, precision);
  made.Fill(points);
  return made.Points;
}

void PointArrays::AddCoordinates(vtkDataSet* input, int precision)
{
  this->Points.TakeReference(vtkPoints::New(ExtractionArrays::ChoosePointType(input, precision)));
  if (vtkPointSet* pointSet = vtkPointSet::SafeDownCast(input))
  {
    vtkDataArray* coordinates = pointSet->GetPoints()->GetData();
    this->AddColumn(coordinates, coordinates, this->Points->GetData());
  }
  else
  {
    this->Rows = std::make_unique<RowCoordinates>(input);
  }
}

void PointArrays::AddArrays(vtkPointData* first, vtkPointData* second, vtkIdType split)
{
  this->Input = first;
  this->HasKeys = first != second;
  this->Split = split;
  for (int a = 0; a < first->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* in = first->GetAbstractArray(a);
    vtkAbstractArray* inSecond = this->HasKeys ? ArrayMatch::Find(first, in, second) : in;
    if (!ExtractionArrays::IsCarried(first, in) || !ExtractionArrays::AreCompatible(in, inSecond))
    {
      continue;
    }
    this->Arrays.push_back({ in, inSecond, ExtractionArrays::NewInterpolatedArray(in) });
    if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(in))
    {
      this->AddColumn(numbers, vtkDataArray::SafeDownCast(inSecond),
        vtkDataArray::SafeDownCast(this->Arrays.back().Out));
    }
    else
    {
      this->HasOthers = true;
    }
  }
}

void PointArrays::AddColumn(vtkDataArray* first, vtkDataArray* second, vtkDataArray* out)
{
  this->Columns.push_back(
    { ArrayInterpolator::Make(first, second, this->Split, out->GetDataType()), out, nullptr,
      static_cast<std::size_t>(out->GetNumberOfComponents() * out->GetDataTypeSize()) });
}

void PointArrays::Allocate(vtkIdType number)
{
  if (this->Rows)
  {
    OutputAllocation::SetNumberOfTuples(this->Points->GetData(), number);
  }
  for (Column& column : this->Columns)
  {
    OutputAllocation::SetNumberOfTuples(column.Out, number);
    column.Values = static_cast<char*>(column.Out->GetVoidPointer(0));
  }
  if (this->HasOthers)
  {
    this->Nearer.Allocate(static_cast<std::size_t>(number));
  }
  this->Allocated = true;
}

void PointArrays::Fill(const ExtractionBuffer<ExtractionPoint>& points)
{
  const vtkIdType number = static_cast<vtkIdType>(points.GetSize());
  this->Allocate(number);
  vtkSMPTools::For(0, number, ThreadGrain,
    [&](vtkIdType first, vtkIdType last)
    { this->Write(points.GetData() + first, last - first, first); });
}

void PointArrays::Write(const ExtractionPoint* points, vtkIdType number, vtkIdType first)
{
  if (this->Rows)
  {
    void* const out = this->Points->GetVoidPointer(0);
    if (this->Points->GetDataType() == VTK_FLOAT)
    {
      this->Rows->Fill(points, number, static_cast<float*>(out) + 3 * first);
    }
    else
    {
      this->Rows->Fill(points, number, static_cast<double*>(out) + 3 * first);
    }
  }
  for (const Column& column : this->Columns)
  {
    column.In->Interpolate(points, static_cast<std::size_t>(number),
      column.Values + static_cast<std::size_t>(first) * column.Size);
  }
  for (vtkIdType p = 0; this->HasOthers && p < number; ++p)
  {
    this->Nearer[first + p] = points[p].Near;
  }
}

void PointArrays::Keep(const RetainedIdRanges& retained)
{
  std::vector<vtkDataArray*> outs;
  for (const Column& column : this->Columns)
  {
    outs.push_back(column.Out);
  }
  if (this->Rows)
  {
    outs.push_back(this->Points->GetData());
  }
  for (vtkDataArray* out : outs)
  {
    const vtkIdType size = out->GetNumberOfComponents() * out->GetDataTypeSize();
    retained.Compact(static_cast<char*>(out->GetVoidPointer(0)), size);
    OutputAllocation::Shorten(out, retained.GetNumber());
  }
  if (this->HasOthers)
  {
    retained.Compact(this->Nearer.GetData(), 1);
    this->Nearer.Truncate(static_cast<std::size_t>(retained.GetNumber()));
  }
}

PointArrays::Part PointArrays::Interpolate(const ExtractionPoint* points, std::size_t number,
  const Part::Index* corners, std::size_t numberOfCorners) const
{
  Part part;
  part.Corners.Allocate(numberOfCorners);
  std::copy_n(corners, numberOfCorners, part.Corners.GetData());
  part.NumberOfPoints = number;
  std::size_t bytes = 0;
  for (const Column& column : this->Columns)
  {
    bytes += column.GetBytes(number);
  }
  part.Values.Allocate(bytes);
  char* values = part.Values.GetData();
  for (const Column& column : this->Columns)
  {
    column.In->Interpolate(points, number, values);
    values += column.GetBytes(number);
  }
  if (this->HasOthers)
  {
    part.Nearer.Allocate(number);
    std::transform(points, points + number, part.Nearer.GetData(),
      [](const ExtractionPoint& point) { return point.Near; });
  }
  return part;
}

void PointArrays::Write(const Part& part, vtkIdType first)
{
  const char* values = part.Values.GetData();
  for (const Column& column : this->Columns)
  {
    CopyCorners(
      values, part, column.Size, column.Values + static_cast<std::size_t>(first) * column.Size);
    values += column.GetBytes(part.NumberOfPoints);
  }
  for (std::size_t c = 0; this->HasOthers && c < part.Corners.GetSize(); ++c)
  {
    this->Nearer[first + c] = part.Nearer[part.Corners[c]];
  }
}

void PointArrays::AddTo(vtkPointData* output)
{
  for (const Carried& array : this->Arrays)
  {
    if (!vtkDataArray::SafeDownCast(array.First))
    {
      const vtkIdType number = static_cast<vtkIdType>(this->Nearer.GetSize());
      array.Out->SetNumberOfTuples(number);
      for (vtkIdType p = 0; p < number; ++p)
      {
        const vtkIdType near = this->Nearer[p];
        array.Out->SetTuple(p, near < this->Split ? near : near - this->Split,
          near < this->Split ? array.First : array.Second);
      }
    }
    ExtractionArrays::AddArrayLike(this->Input, array.First, output, array.Out);
    if (this->HasKeys)
    {
      array.Out->SetName(ArrayMatch::GetKey(this->Input, array.First).c_str());
    }
  }
}

}
