// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/ExtractionArrays.h"

#include "Arrays/RowCoordinates.h"
#include "Common/ArrayMatch.h"
#include "Output/Interpolation.h"
#include "Output/ThreadGrain.h"

#include "vtkAlgorithm.h"
#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"

#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace interlume
{

namespace
{
using PointList = ExtractionBuffer<ExtractionPoint>;

// Interpolates from two arrays, of which the second has the points from Split on.
struct InterpolateWorker
{
  const PointList& Points;
  vtkIdType Split;

  template <typename InArray, typename OutArray>
  void operator()(InArray* first, InArray* second, OutArray* out) const
  {
    // A known number of components needs no loop.
    switch (first->GetNumberOfComponents())
    {
      case 1:
        return this->Run<1>(first, second, out);
      case 3:
        return this->Run<3>(first, second, out);
      default:
        return this->Run<0>(first, second, out);
    }
  }

private:
  template <int Known, typename InArray, typename OutArray>
  void Run(InArray* first, InArray* second, OutArray* out) const
  {
    const auto from = vtk::DataArrayValueRange(first);
    const auto fromSecond = vtk::DataArrayValueRange(second);
    auto to = vtk::DataArrayValueRange(out);
    using Out = vtk::GetAPIType<OutArray>;
    const vtkIdType components = Known ? Known : first->GetNumberOfComponents();
    const auto value = [&](vtkIdType point, vtkIdType c)
    {
      return static_cast<double>(point < this->Split
          ? from[point * components + c]
          : fromSecond[(point - this->Split) * components + c]);
    };
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Points.GetSize()), ThreadGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType p = begin; p < end; ++p)
        {
          const ExtractionPoint& point = this->Points[p];
          for (vtkIdType c = 0; c < (Known ? Known : components); ++c)
          {
            to[p * components + c] =
              Interpolation::Between<Out>(value(point.Near, c), value(point.Far, c), point.Weight);
          }
        }
      });
  }
};

constexpr vtkIdType NoSplit = std::numeric_limits<vtkIdType>::max();

void InterpolateArray(vtkDataArray* first, vtkDataArray* second, vtkIdType split,
  const PointList& points, vtkDataArray* out)
{
  const InterpolateWorker worker{ points, split };
  // The output is a float or a double array; the input any.
  const auto intoKnown = [&](auto* known)
  {
    const auto pair = [&](auto* a, auto* b)
    {
      if constexpr (std::is_same<decltype(a), decltype(b)>::value)
      {
        worker(a, b, known);
      }
      else
      {
        worker(first, second, known);
      }
    };
    const auto single = [&](auto* array) { worker(array, array, known); };
    const bool isDone = first == second
      ? vtkArrayDispatch::Dispatch::Execute(first, single)
      : vtkArrayDispatch::Dispatch2SameValueType::Execute(first, second, pair);
    if (!isDone)
    {
      worker(first, second, known);
    }
  };
  if (vtkFloatArray* floats = vtkFloatArray::SafeDownCast(out))
  {
    intoKnown(floats);
  }
  else
  {
    intoKnown(vtkDoubleArray::SafeDownCast(out));
  }
}

template <typename OutArray>
void FillRowPoints(vtkDataSet* input, const PointList& points, OutArray* out)
{
  using Out = vtk::GetAPIType<OutArray>;
  const RowCoordinates coordinates(input);
  Out* to = out->GetPointer(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(points.GetSize()), ThreadGrain,
    [&](vtkIdType first, vtkIdType last)
    { coordinates.Fill(points.GetData() + first, last - first, to + 3 * first); });
}

}

int ExtractionArrays::ChoosePointType(vtkDataSet* input, int precision)
{
  if (precision == vtkAlgorithm::DEFAULT_PRECISION)
  {
    if (vtkPointSet* pointSet = vtkPointSet::SafeDownCast(input))
    {
      return pointSet->GetPoints()->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE;
    }
    vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(input);
    return grid && grid->GetXCoordinates()->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT;
  }
  return precision == vtkAlgorithm::DOUBLE_PRECISION ? VTK_DOUBLE : VTK_FLOAT;
}

bool ExtractionArrays::IsCarried(vtkDataSetAttributes* attributes, vtkAbstractArray* array)
{
  return array != attributes->GetAbstractAttribute(vtkDataSetAttributes::GLOBALIDS) &&
    array != attributes->GetAbstractAttribute(vtkDataSetAttributes::PEDIGREEIDS) &&
    !(array->GetName() &&
      std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) == 0);
}

void ExtractionArrays::AddLike(vtkDataSetAttributes* input, vtkAbstractArray* in,
  vtkDataSetAttributes* output, vtkAbstractArray* out)
{
  out->SetName(in->GetName());
  out->CopyComponentNames(in);
  const int index = output->AddArray(out);
  for (int role = 0; role < vtkDataSetAttributes::NUM_ATTRIBUTES; ++role)
  {
    if (input->GetAbstractAttribute(role) == in)
    {
      output->SetActiveAttribute(index, role);
    }
  }
}

namespace
{
struct CopyWorker
{
  const vtkIdType* Cells;
  vtkIdType Number;

  template <typename Array>
  void operator()(Array* in, vtkDataArray* base) const
  {
    Array* out = Array::FastDownCast(base);
    // A known number of components needs no loop.
    in->GetNumberOfComponents() == 1 ? this->Run<1>(in, out) : this->Run<0>(in, out);
  }

private:
  template <int Known, typename Array>
  void Run(Array* in, Array* out) const
  {
    const auto from = vtk::DataArrayValueRange(in);
    auto to = vtk::DataArrayValueRange(out);
    const vtkIdType components = Known ? Known : in->GetNumberOfComponents();
    vtkSMPTools::For(0, this->Number, ThreadGrain,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          for (vtkIdType c = 0; c < (Known ? Known : components); ++c)
          {
            to[i * components + c] = from[this->Cells[i] * components + c];
          }
        }
      });
  }
};
}

bool ExtractionArrays::IsAlike(vtkAbstractArray* a, vtkAbstractArray* b)
{
  return a && b && a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    a->IsA("vtkDataArray") == b->IsA("vtkDataArray") &&
    (a->IsA("vtkDataArray") || a->GetDataType() == b->GetDataType());
}

bool ExtractionArrays::GetRowDimensions(vtkDataSet* input, int dimensions[3])
{
  if (vtkImageData* image = vtkImageData::SafeDownCast(input))
  {
    image->GetDimensions(dimensions);
  }
  else if (vtkRectilinearGrid* rectilinear = vtkRectilinearGrid::SafeDownCast(input))
  {
    rectilinear->GetDimensions(dimensions);
  }
  else if (vtkStructuredGrid* structured = vtkStructuredGrid::SafeDownCast(input))
  {
    structured->GetDimensions(dimensions);
  }
  else
  {
    return false;
  }
  return true;
}

int ExtractionArrays::GetInterpolatedType(int dataType)
{
  switch (dataType)
  {
    case VTK_BIT:
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
    case VTK_FLOAT:
      return VTK_FLOAT;
    default:
      return VTK_DOUBLE;
  }
}

vtkSmartPointer<vtkAbstractArray> ExtractionArrays::NewInterpolated(
  vtkAbstractArray* in, vtkIdType number)
{
  vtkSmartPointer<vtkAbstractArray> out;
  vtkDataArray* numbers = vtkDataArray::SafeDownCast(in)
    ? vtkDataArray::CreateDataArray(GetInterpolatedType(in->GetDataType()))
    : nullptr;
  out.TakeReference(numbers ? numbers : in->NewInstance());
  out->SetNumberOfComponents(in->GetNumberOfComponents());
  if (numbers)
  {
    ExtractionMemory::SetNumberOfTuples(numbers, number);
  }
  else
  {
    out->SetNumberOfTuples(number);
  }
  return out;
}

vtkSmartPointer<vtkPoints> ExtractionArrays::MakePoints(
  vtkDataSet* input, const ExtractionBuffer<ExtractionPoint>& points, int precision)
{
  vtkSmartPointer<vtkPoints> made =
    vtkSmartPointer<vtkPoints>::Take(vtkPoints::New(ChoosePointType(input, precision)));
  ExtractionMemory::SetNumberOfTuples(made->GetData(), static_cast<vtkIdType>(points.GetSize()));
  if (vtkPointSet* pointSet = vtkPointSet::SafeDownCast(input))
  {
    vtkDataArray* coordinates = pointSet->GetPoints()->GetData();
    InterpolateArray(coordinates, coordinates, NoSplit, points, made->GetData());
  }
  else if (vtkFloatArray* floats = vtkFloatArray::SafeDownCast(made->GetData()))
  {
    FillRowPoints(input, points, floats);
  }
  else
  {
    FillRowPoints(input, points, vtkDoubleArray::SafeDownCast(made->GetData()));
  }
  return made;
}

int ExtractionArrays::InterpolatePointData(
  vtkPointData* input, const ExtractionBuffer<ExtractionPoint>& points, vtkPointData* output)
{
  return InterpolatePointData(input, input, NoSplit, points, output);
}

int ExtractionArrays::InterpolatePointData(vtkPointData* first, vtkPointData* second,
  vtkIdType split, const ExtractionBuffer<ExtractionPoint>& points, vtkPointData* output)
{
  int number = 0;
  for (int a = 0; a < first->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* in = first->GetAbstractArray(a);
    vtkAbstractArray* inSecond = first == second ? in : ArrayMatch::Find(first, in, second);
    if (!IsCarried(first, in) || !IsAlike(in, inSecond))
    {
      continue;
    }
    vtkDataArray* numbers = vtkDataArray::SafeDownCast(in);
    const vtkSmartPointer<vtkAbstractArray> out =
      NewInterpolated(in, static_cast<vtkIdType>(points.GetSize()));
    if (numbers)
    {
      InterpolateArray(numbers, vtkDataArray::SafeDownCast(inSecond), split, points,
        vtkDataArray::SafeDownCast(out));
    }
    else
    {
      for (std::size_t p = 0; p < points.GetSize(); ++p)
      {
        const vtkIdType near = points[p].Near;
        out->SetTuple(static_cast<vtkIdType>(p), near < split ? near : near - split,
          near < split ? in : inSecond);
      }
    }
    AddLike(first, in, output, out);
    if (first != second)
    {
      out->SetName(ArrayMatch::GetKey(first, in).c_str());
    }
    ++number;
  }
  return number;
}

int ExtractionArrays::CopyCellData(
  vtkCellData* input, const vtkIdType* cells, vtkIdType number, vtkCellData* output)
{
  int arrays = 0;
  const CopyWorker worker{ cells, number };
  for (int a = 0; a < input->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* in = input->GetAbstractArray(a);
    if (!IsCarried(input, in))
    {
      continue;
    }
    vtkSmartPointer<vtkAbstractArray> out;
    out.TakeReference(in->NewInstance());
    out->SetNumberOfComponents(in->GetNumberOfComponents());
    vtkDataArray* numbers = vtkDataArray::SafeDownCast(in);
    if (numbers)
    {
      ExtractionMemory::SetNumberOfTuples(vtkDataArray::SafeDownCast(out), number);
    }
    else
    {
      out->SetNumberOfTuples(number);
    }
    if (!numbers ||
      !vtkArrayDispatch::Dispatch::Execute(numbers, worker, vtkDataArray::SafeDownCast(out)))
    {
      for (vtkIdType i = 0; i < number; ++i)
      {
        out->SetTuple(i, cells[i], in);
      }
    }
    AddLike(input, in, output, out);
    ++arrays;
  }
  return arrays;
}

void ExtractionArrays::ActivateScalars(const char* name, vtkPointData* output)
{
  if (name && *name && output->GetArray(name))
  {
    output->SetActiveScalars(name);
  }
}

}
