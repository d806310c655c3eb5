// SPDX-License-Identifier: BSD-3-Clause
#include "Soup/SoupArrays.h"

#include "Arrays/ExtractionArrays.h"
#include "Output/Interpolation.h"
#include "Scalars/ExtractionDispatch.h"
#include "Soup/SoupBuilder.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <type_traits>

namespace interlume
{

class SoupArrays::Writer
{
public:
  virtual ~Writer() = default;
  /// Appends the values of \a points to those of a part.
  virtual void Interpolate(
    const ExtractionPoint* points, std::size_t number, SoupPart& part) const = 0;
  virtual void Allocate(vtkIdType corners) const = 0;
  /// Copies the values of a part's entries to its corners.
  virtual void Write(SoupPart& part, vtkIdType first) const = 0;
};

namespace
{
// Values that lie one after the other in memory.
template <typename T>
struct Contiguous
{
  const T* Values;

  double Get(vtkIdType point, int component, int components) const
  {
    return static_cast<double>(this->Values[point * components + component]);
  }
};

// Any array, value by value.
struct AnyValues
{
  vtkDataArray* Values;

  double Get(vtkIdType point, int component, int) const
  {
    return this->Values->GetComponent(point, component);
  }
};
}

template <typename Source, typename Out>
class SoupArrays::TypedWriter : public Writer
{
public:
  // \a place is the number of components that parts have in that type before these.
  TypedWriter(const Source& source, vtkDataArray* out, std::size_t place)
    : In(source)
    , Result(vtkAOSDataArrayTemplate<Out>::FastDownCast(out))
    , Components(out->GetNumberOfComponents())
    , Place(place)
  {
  }

  void Interpolate(const ExtractionPoint* points, std::size_t number, SoupPart& part) const override
  {
    this->WithComponents(
      [&](auto known) { this->template InterpolateAll<known()>(points, number, part); });
  }

  void Allocate(vtkIdType corners) const override
  {
    this->Result->SetNumberOfTuples(corners);
    ExtractionMemory::PreferLargePages(this->Result);
  }

  void Write(SoupPart& part, vtkIdType first) const override
  {
    this->WithComponents([&](auto known) { this->template Write<known()>(part, first); });
  }

private:
  // A known number of components needs no loop.
  template <typename Function>
  void WithComponents(Function&& function) const
  {
    switch (this->Components)
    {
      case 1:
        return function(std::integral_constant<int, 1>());
      case 3:
        return function(std::integral_constant<int, 3>());
      default:
        return function(std::integral_constant<int, 0>());
    }
  }

  template <int Known>
  void InterpolateAll(const ExtractionPoint* points, std::size_t number, SoupPart& part) const
  {
    const int size = Known ? Known : this->Components;
    std::vector<Out>& values = part.GetValues<Out>();
    const std::size_t place = values.size();
    values.resize(place + size * number);
    Out* value = values.data() + place;
    for (std::size_t p = 0; p < number; ++p)
    {
      const ExtractionPoint& point = points[p];
      for (int c = 0; c < size; ++c)
      {
        *value++ = Interpolation::Between<Out>(
          this->In.Get(point.Near, c, size), this->In.Get(point.Far, c, size), point.Weight);
      }
    }
  }

  template <int Known>
  void Write(SoupPart& part, vtkIdType first) const
  {
    const int size = Known ? Known : this->Components;
    const Out* values = part.GetValues<Out>().data() + this->Place * part.NumberOfEntries;
    Out* out = this->Result->GetPointer(first * size);
    for (const SoupPart::Index corner : part.Corners)
    {
      const Out* value = values + static_cast<std::size_t>(corner) * size;
      for (int c = 0; c < size; ++c)
      {
        *out++ = value[c];
      }
    }
  }

  Source In;
  vtkAOSDataArrayTemplate<Out>* Result;
  int Components;
  std::size_t Place;
};

SoupArrays::SoupArrays(vtkDataSet* input, int precision)
  : Input(input)
{
  this->Points.TakeReference(vtkPoints::New(ExtractionArrays::ChoosePointType(input, precision)));
  this->AddWriter(
    vtkPointSet::SafeDownCast(input)->GetPoints()->GetData(), this->Points->GetData());
  vtkPointData* arrays = input->GetPointData();
  for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* in = arrays->GetAbstractArray(a);
    if (!ExtractionArrays::IsCarried(arrays, in))
    {
      continue;
    }
    const vtkSmartPointer<vtkAbstractArray> out = ExtractionArrays::NewInterpolated(in, 0);
    this->Arrays.push_back({ in, out });
    if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(in))
    {
      this->AddWriter(numbers, vtkDataArray::SafeDownCast(out));
    }
    else
    {
      this->HasOthers = true;
    }
  }
}

SoupArrays::~SoupArrays() = default;

void SoupArrays::AddWriter(vtkDataArray* in, vtkDataArray* out)
{
  const bool isFloat = out->GetDataType() == VTK_FLOAT;
  std::size_t& place = isFloat ? this->FloatComponents : this->DoubleComponents;
  const auto add = [&](const auto& source)
  {
    using Source = std::decay_t<decltype(source)>;
    if (isFloat)
    {
      this->Writers.push_back(std::make_unique<TypedWriter<Source, float>>(source, out, place));
    }
    else
    {
      this->Writers.push_back(std::make_unique<TypedWriter<Source, double>>(source, out, place));
    }
    return true;
  };
  const bool isContiguous = ExtractionDispatch::Execute(in,
    [&](const auto* values) { return add(Contiguous<std::decay_t<decltype(*values)>>{ values }); });
  if (!isContiguous)
  {
    add(AnyValues{ in });
  }
  place += out->GetNumberOfComponents();
}

SoupPart SoupArrays::Interpolate(const SoupBuilder& builder) const
{
  const ExtractionPoint* points = builder.GetPoints();
  const std::size_t number = builder.GetNumberOfPoints();
  SoupPart part;
  part.Corners = builder.GetCorners();
  part.NumberOfEntries = number;
  part.Floats.reserve(this->FloatComponents * number);
  part.Doubles.reserve(this->DoubleComponents * number);
  for (const auto& writer : this->Writers)
  {
    writer->Interpolate(points, number, part);
  }
  for (std::size_t p = 0; this->HasOthers && p < number; ++p)
  {
    part.Nearer.push_back(points[p].Near);
  }
  return part;
}

void SoupArrays::Allocate(vtkIdType corners)
{
  for (const auto& writer : this->Writers)
  {
    writer->Allocate(corners);
  }
  if (this->HasOthers)
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
  for (std::size_t c = 0; this->HasOthers && c < part.Corners.size(); ++c)
  {
    this->Nearer[first + c] = part.Nearer[part.Corners[c]];
  }
}

void SoupArrays::AddTo(vtkPointData* output)
{
  for (const Carried& array : this->Arrays)
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
    ExtractionArrays::AddLike(this->Input->GetPointData(), array.In, output, array.Out);
  }
}

}
