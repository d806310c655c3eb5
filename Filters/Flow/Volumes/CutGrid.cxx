// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/CutGrid.h"

#include "Common/Blanking.h"
#include "Common/GlobalIds.h"
#include "Samples/FarSideSamples.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Volumes/InterpolableCells.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace interlume
{

namespace
{
// Kinds of excluded cells that may be cut at a surface.
constexpr unsigned char Cuttable = InterpolableCells::WITHOUT_RESULT |
  InterpolableCells::BETWEEN_SURFACES | InterpolableCells::ACROSS_SURFACE;

vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, int components, vtkIdType number)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(number);
  return array;
}
}

vtkIdType CutGrid::GetOrAddPoint(const Point& point)
{
  // A point with known values is shared by the parts on both sides.
  const int side = point.Kind == FarSideSamples::UNKNOWN ? point.Side : 0;
  const auto added =
    this->Known.emplace(std::make_tuple(point.Sample, point.Kind, side, point.IsBoundary),
      static_cast<vtkIdType>(this->Points.size()));
  if (added.second)
  {
    this->Points.push_back(point);
  }
  return added.first->second;
}

void CutGrid::FindCells(vtkDataSet* input, const FarSideSamples& farSide,
  const ImplicitFlowArrays& arrays, const InterpolableCells& cells, vtkIdType& numberOfCells)
{
  Blanking blanking;
  blanking.SetBlanking(input);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < cells.GetNumberOfCells(); ++cell)
  {
    if (!(cells.GetKind(cell) & Cuttable))
    {
      continue;
    }
    input->GetCellPoints(cell, corners);
    if (std::any_of(corners->begin(), corners->end(),
          [&](vtkIdType p) { return blanking.IsPointBlanked(p); }))
    {
      continue;
    }
    const FarSideSamples::Parts parts =
      farSide.GetParts(arrays, corners->GetPointer(0), corners->GetNumberOfIds());
    bool isCut = false;
    for (const FarSideSamples::Part& part : parts.All)
    {
      if (part.Side == 0)
      {
        continue;
      }
      isCut = true;
      this->Cells.push_back(cell);
      const vtkIdType other = *std::find_if(corners->begin(), corners->end(),
        [&](vtkIdType p)
        { return farSide.GetSide(farSide.GetRow(p, part.IsBoundary)) == part.Side; });
      for (const vtkIdType corner : *corners)
      {
        const FarSideSamples::Roles kind = farSide.GetRole(arrays, corner, part);
        this->Ids.push_back(
          this->GetOrAddPoint({ corner, kind, other, part.IsNear, part.Side, part.IsBoundary }));
      }
    }
    numberOfCells += isCut ? 1 : 0;
  }
}

vtkSmartPointer<vtkUnstructuredGrid> CutGrid::Make(vtkDataSet* input,
  const ImplicitFlowArrays& arrays, const InterpolableCells& cells, vtkIdType& numberOfCells)
{
  *this = CutGrid();
  numberOfCells = 0;
  const FarSideSamples farSide(input);
  const auto inflow = FarSideSamples::GetName(vtkFlowStatus::InflowArray());
  const bool isMapped = !input->GetPointData()->HasArray(vtkFlowStatus::InflowArray()) ||
    input->GetFieldData()->HasArray(inflow.c_str());
  if (!farSide.IsEmpty() && isMapped)
  {
    this->FindCells(input, farSide, arrays, cells, numberOfCells);
  }
  if (this->Cells.empty())
  {
    return nullptr;
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  this->AddPoints(input, farSide, arrays, grid);
  const auto number = static_cast<vtkIdType>(this->Cells.size());
  grid->AllocateEstimate(number, 8);
  grid->GetCellData()->CopyAllOn();
  grid->GetCellData()->CopyAllocate(input->GetCellData(), number);
  vtkNew<vtkIdList> corners;
  const vtkIdType* ids = this->Ids.data();
  for (const vtkIdType from : this->Cells)
  {
    input->GetCellPoints(from, corners);
    const vtkIdType size = corners->GetNumberOfIds();
    const vtkIdType cell = grid->InsertNextCell(input->GetCellType(from), size, ids);
    grid->GetCellData()->CopyData(input->GetCellData(), from, cell);
    ids += size;
  }
  grid->GetFieldData()->ShallowCopy(input->GetFieldData());
  return grid;
}

void CutGrid::AddPoints(vtkDataSet* input, const FarSideSamples& farSide,
  const ImplicitFlowArrays& arrays, vtkUnstructuredGrid* grid) const
{
  const auto number = static_cast<vtkIdType>(this->Points.size());
  vtkPointData* from = input->GetPointData();
  vtkPointData* to = grid->GetPointData();
  to->CopyAllOn();
  to->CopyAllocate(from, number);
  vtkNew<vtkPoints> points;
  vtkPointSet* set = vtkPointSet::SafeDownCast(input);
  points->SetDataType(set ? set->GetPoints()->GetDataType() : VTK_DOUBLE);
  points->SetNumberOfPoints(number);
  const vtkSmartPointer<GlobalIds::Array> globalIds = GlobalIds::Get(from);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(globalIds ? from->GetGlobalIds()->GetName() : IdArray());
  ids->SetNumberOfValues(number);
  const auto first = static_cast<vtkIdType>(
    globalIds ? globalIds->GetRange()[1] + 1.0 : static_cast<double>(input->GetNumberOfPoints()));
  for (vtkIdType p = 0; p < number; ++p)
  {
    const Point& point = this->Points[static_cast<std::size_t>(p)];
    points->SetPoint(p, input->GetPoint(point.Sample));
    to->CopyData(from, point.Kind == FarSideSamples::UNKNOWN ? point.Other : point.Sample, p);
    const auto own = globalIds ? globalIds->GetValue(point.Sample) : point.Sample;
    ids->SetValue(p, point.Kind == FarSideSamples::OWN ? own : first + p);
  }
  this->SetValues(input, farSide, arrays, to);
  to->SetGlobalIds(ids);
  grid->SetPoints(points);
}

void CutGrid::SetValues(vtkDataSet* input, const FarSideSamples& farSide,
  const ImplicitFlowArrays& arrays, vtkPointData* to) const
{
  const auto number = static_cast<vtkIdType>(this->Points.size());
  const auto gaps = MakeArray(GapArray(), 1, number);
  const auto gradients = MakeArray(GradientArray(), 3, number);
  const auto nearTimes = MakeArray(NearTimeArray(), 1, number);
  vtkDataArray* times = to->GetArray(vtkFlowStatus::TimeArray());
  for (vtkIdType p = 0; p < number; ++p)
  {
    const Point& point = this->Points[static_cast<std::size_t>(p)];
    const vtkIdType row = farSide.GetRow(point.Sample, point.IsBoundary);
    const double gap = farSide.GetDistance(row);
    gaps->SetValue(p, point.Kind == FarSideSamples::OWN ? gap : -gap);
    double normal[3];
    farSide.GetNormal(row, normal);
    for (int i = 0; i < 3; ++i)
    {
      gradients->SetTypedComponent(p, i, point.Side * normal[i]);
    }
    double nearTime = farSide.GetTimeToSurface(arrays, row);
    if (point.Kind == FarSideSamples::UNKNOWN)
    {
      const vtkIdType other = farSide.GetRow(point.Other, point.IsBoundary);
      nearTime = -farSide.GetTimeToSurface(arrays, other) * (gap / farSide.GetDistance(other));
      if (point.IsNear && farSide.HasSurface(row))
      {
        times->SetComponent(p, 0, nearTime);
      }
    }
    nearTimes->SetValue(p, nearTime);
  }
  for (int a = 0; a < to->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = to->GetAbstractArray(a);
    vtkAbstractArray* other = array->GetName()
      ? input->GetFieldData()->GetAbstractArray(FarSideSamples::GetName(array->GetName()).c_str())
      : nullptr;
    if (!other || other->GetNumberOfComponents() != array->GetNumberOfComponents())
    {
      continue;
    }
    for (vtkIdType p = 0; p < number; ++p)
    {
      const Point& point = this->Points[static_cast<std::size_t>(p)];
      if (point.Kind == FarSideSamples::KNOWN)
      {
        array->SetTuple(p, farSide.GetRow(point.Sample, point.IsBoundary), other);
      }
    }
  }
  // All corners of the copies have a result.
  to->GetArray(vtkFlowStatus::StatusArray())->Fill(vtkFlowStatus::REACHED_SURFACE);
  to->RemoveArray(vtkFlowStatus::SideArray());
  to->AddArray(gaps);
  to->AddArray(gradients);
  to->AddArray(nearTimes);
}

}
