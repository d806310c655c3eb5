// SPDX-License-Identifier: BSD-3-Clause
#include "Soup/SoupArrays.h"

#include "Arrays/ArrayInterpolator.h"
#include "Arrays/ExtractionArrays.h"
#include "Soup/SoupBuilder.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>

namespace interlume
{

class SoupArrays::Writer
{
public:
  virtual ~Writer() = default;
  /// Writes the values of \a points into a part that has room for them.
  virtual void Interpolate(
    const ExtractionPoint* points, std::size_t number, SoupPart& part) const = 0;
  virtual void Allocate(vtkIdType corners) const = 0;
  /// Copies the values of a part's entries to its corners.
  virtual void Write(SoupPart& part, vtkIdType first) const = 0;
};

template <typename Out>
class SoupArrays::TypedWriter : public Writer
{
public:
  // \a place is the number of components that parts have in that type before these.
  TypedWriter(vtkDataArray* in, vtkDataArray* out, std::size_t place)
    : In(ArrayInterpolator::Make(in, out->GetDataType()))
    , Result(vtkAOSDataArrayTemplate<Out>::FastDownCast(out))
    , Components(out->GetNumberOfComponents())
    , Place(place)
  {
  }

  void Interpolate(const ExtractionPoint* points, std::size_t number, SoupPart& part) const override
  {
    this->In->Interpolate(points, number, part.GetValues<Out>().GetData() + this->Place * number);
  }

  void Allocate(vtkIdType corners) const override
  {
    this->Result->SetNumberOfTuples(corners);
    ExtractionMemory::PreferLargePages(this->Result);
  }

  void Write(SoupPart& part, vtkIdType first) const override
  {
    // A known number of components needs no loop.
    switch (this->Components)
    {
      case 1:
        return this->template Write<1>(part, first);
      case 3:
        return this->template Write<3>(part, first);
      default:
        return this->template Write<0>(part, first);
    }
  }

private:
  template <int Known>
  void Write(SoupPart& part, vtkIdType first) const
  {
    const int size = Known ? Known : this->Components;
    const Out* values = part.GetValues<Out>().GetData() + this->Place * part.NumberOfEntries;
    Out* out = this->Result->GetPointer(first * size);
    const SoupPart::Index* const corners = part.Corners.GetData();
    const std::size_t number = part.Corners.GetSize();
    for (std::size_t corner = 0; corner < number; ++corner)
    {
      const Out* value = values + static_cast<std::size_t>(corners[corner]) * size;
      for (int c = 0; c < size; ++c)
      {
        *out++ = value[c];
      }
    }
  }

  std::unique_ptr<ArrayInterpolator> In;
  vtkAOSDataArrayTemplate<Out>* Result;
  int Components;
  std::size_t Place;
};

SoupArrays::SoupArrays(vtkDataSet* input, int precision)
  : Arrays(input, precision)
{
  this->AddWriter(
    vtkPointSet::SafeDownCast(input)->GetPoints()->GetData(), this->GetPoints()->GetData());
  for (const CarriedArrays::Carried& array : this->Arrays.GetArrays())
  {
    if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(array.In))
    {
      this->AddWriter(numbers, vtkDataArray::SafeDownCast(array.Out));
    }
  }
}

SoupArrays::~SoupArrays() = default;

void SoupArrays::AddWriter(vtkDataArray* in, vtkDataArray* out)
{
  const bool isFloat = out->GetDataType() == VTK_FLOAT;
  std::size_t& place = isFloat ? this->FloatComponents : this->DoubleComponents;
  if (isFloat)
  {
    this->Writers.push_back(std::make_unique<TypedWriter<float>>(in, out, place));
  }
  else
  {
    this->Writers.push_back(std::make_unique<TypedWriter<double>>(in, out, place));
  }
  place += out->GetNumberOfComponents();
}

SoupPart SoupArrays::Interpolate(const SoupBuilder& builder) const
{
  const ExtractionPoint* points = builder.GetPoints();
  const std::size_t number = builder.GetNumberOfPoints();
  SoupPart part;
  const std::size_t corners = builder.GetNumberOfCorners();
  part.Corners.Allocate(corners);
  std::copy_n(builder.GetCorners(), corners, part.Corners.GetData());
  part.NumberOfEntries = number;
  part.Floats.Allocate(this->FloatComponents * number);
  part.Doubles.Allocate(this->DoubleComponents * number);
  for (const auto& writer : this->Writers)
  {
    writer->Interpolate(points, number, part);
  }
  if (this->Arrays.HasOthers())
  {
    part.Nearer.Allocate(number);
    std::transform(points, points + number, part.Nearer.GetData(),
      [](const ExtractionPoint& point) { return point.Near; });
  }
  return part;
}

void SoupArrays::Allocate(vtkIdType corners)
{
  for (const auto& writer : this->Writers)
  {
    writer->Allocate(corners);
  }
  if (this->Arrays.HasOthers())
  {
    this->Nearer.Allocate(corners);
  }
  this->HasRoom = true;
}

void SoupArrays::Write(SoupPart& part, vtkIdType first)
{
  for (const auto& writer : this->Writers)
  {
    writer->Write(part, first);
  }
  for (std::size_t c = 0; this->Arrays.HasOthers() && c < part.Corners.GetSize(); ++c)
  {
    this->Nearer[first + c] = part.Nearer[part.Corners[c]];
  }
}

void SoupArrays::AddTo(vtkPointData* output)
{
  for (const CarriedArrays::Carried& array : this->Arrays.GetArrays())
  {
    if (!vtkDataArray::SafeDownCast(array.In))
    {
      const vtkIdType corners = static_cast<vtkIdType>(this->Nearer.GetSize());
      array.Out->SetNumberOfTuples(corners);
      for (vtkIdType corner = 0; corner < corners; ++corner)
      {
        array.Out->SetTuple(corner, this->Nearer[corner], array.In);
      }
    }
  }
  this->Arrays.AddTo(output);
}

}
