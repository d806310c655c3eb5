// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/DistributedField.h"

#include "Common/Blanking.h"
#include "Streams/SharedPoints.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExtentTranslator.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace interlume
{

namespace
{
constexpr double None = -std::numeric_limits<double>::infinity();

std::string Describe(const int extent[6])
{
  std::string text;
  for (int i = 0; i < 6; ++i)
  {
    text += (i > 0 ? " " : "") + std::to_string(extent[i]);
  }
  return text;
}

/// Copies a partition's coordinates along one axis into the coordinates of the whole grid.
void CopyCoordinates(
  vtkDataArray* from, int first, const int held[2], std::vector<double>& coordinates)
{
  for (int i = held[0]; from && i <= held[1] && i - held[0] < from->GetNumberOfTuples(); ++i)
  {
    coordinates[static_cast<std::size_t>(i - first)] = from->GetComponent(i - held[0], 0);
  }
}

/// Returns a copy without the duplicate flags of cells and points. The field includes duplicate
/// cells, and no sample belongs to more than one process.
vtkSmartPointer<vtkDataSet> WithoutDuplicates(vtkDataSet* data)
{
  const auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->ShallowCopy(data);
  const auto clear = [](vtkFieldData* attributes, unsigned char mark)
  {
    const char* name = vtkDataSetAttributes::GhostArrayName();
    auto* marks = vtkUnsignedCharArray::SafeDownCast(attributes->GetAbstractArray(name));
    const unsigned char* first = marks ? marks->GetPointer(0) : nullptr;
    const vtkIdType number = marks ? marks->GetNumberOfValues() : 0;
    if (std::none_of(first, first + number, [&](unsigned char value) { return value & mark; }))
    {
      return;
    }
    const auto others = static_cast<unsigned char>(~mark);
    vtkSmartPointer<vtkUnsignedCharArray> left;
    if (std::any_of(first, first + number, [&](unsigned char value) { return value & others; }))
    {
      left = vtkSmartPointer<vtkUnsignedCharArray>::New();
      left->SetName(name);
      left->SetNumberOfValues(number);
      std::transform(first, first + number, left->GetPointer(0),
        [&](unsigned char value) { return static_cast<unsigned char>(value & others); });
    }
    attributes->RemoveArray(name);
    if (left)
    {
      attributes->AddArray(left);
    }
  };
  clear(copy->GetPointData(), vtkDataSetAttributes::DUPLICATEPOINT);
  clear(copy->GetCellData(), vtkDataSetAttributes::DUPLICATECELL);
  return copy;
}

/// Returns the grid, or a copy without duplicate cells if it contains any.
vtkSmartPointer<vtkUnstructuredGrid> WithoutDuplicateCells(vtkUnstructuredGrid* grid)
{
  Blanking blanking;
  blanking.SetBlanking(grid);
  vtkNew<vtkIdList> retained;
  for (vtkIdType cell = 0; blanking.CellGhosts && cell < grid->GetNumberOfCells(); ++cell)
  {
    if (!blanking.IsCellDuplicate(cell))
    {
      retained->InsertNextId(cell);
    }
  }
  const vtkIdType number = retained->GetNumberOfIds();
  if (!blanking.CellGhosts || number == grid->GetNumberOfCells())
  {
    return grid;
  }
  const vtkSmartPointer<vtkUnstructuredGrid> part = vtkSmartPointer<vtkUnstructuredGrid>::New();
  part->SetPoints(grid->GetPoints());
  part->GetPointData()->ShallowCopy(grid->GetPointData());
  part->GetFieldData()->ShallowCopy(grid->GetFieldData());
  part->AllocateEstimate(number, 8);
  part->GetCellData()->CopyAllOn();
  part->GetCellData()->CopyAllocate(grid->GetCellData(), number);
  vtkNew<vtkIdList> corners;
  for (const vtkIdType cell : *retained)
  {
    grid->GetCellPoints(cell, corners);
    const vtkIdType newCell = part->InsertNextCell(grid->GetCellType(cell), corners);
    part->GetCellData()->CopyData(grid->GetCellData(), cell, newCell);
  }
  return part;
}
}

DistributedField::DistributedField(vtkMultiProcessController* controller, const int* full)
  : Exchange(controller)
  , WholeExtent{ { 0, -1, 0, -1, 0, -1 } }
{
  if (!full)
  {
    return;
  }
  std::copy_n(full, 6, this->WholeExtent.begin());
  vtkNew<vtkExtentTranslator> translator;
  const int ranks = this->Exchange.GetNumberOfRanks();
  this->Own.resize(static_cast<std::size_t>(ranks));
  for (int rank = 0; rank < ranks; ++rank)
  {
    Extent all = this->WholeExtent;
    Extent& own = this->Own[static_cast<std::size_t>(rank)];
    translator->PieceToExtentThreadSafe(
      rank, ranks, 0, all.data(), own.data(), vtkExtentTranslator::BLOCK_MODE, 0);
  }
}

bool DistributedField::IsEmpty() const
{
  if (this->Own.empty())
  {
    return this->Part.FirstCell == this->Part.EndCell;
  }
  return !FieldPartition::HasCells(
    this->Own[static_cast<std::size_t>(this->Exchange.GetRank())].data());
}

DistributedField::Extent DistributedField::GetHeldExtent() const
{
  Extent held = this->Own[static_cast<std::size_t>(this->Exchange.GetRank())];
  for (std::size_t axis = 0; axis < 3 && !this->IsEmpty(); ++axis)
  {
    held[2 * axis] = std::max(held[2 * axis] - 1, this->WholeExtent[2 * axis]);
    held[2 * axis + 1] = std::min(held[2 * axis + 1] + 1, this->WholeExtent[2 * axis + 1]);
  }
  return held;
}

int DistributedField::FindRank(const int cell[3]) const
{
  for (std::size_t rank = 0; rank < this->Own.size(); ++rank)
  {
    const Extent& own = this->Own[rank];
    bool isOwn = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int index = cell[axis] + this->WholeExtent[2 * axis];
      isOwn = isOwn && index >= own[2 * axis] && index < own[2 * axis + 1];
    }
    if (isOwn)
    {
      return static_cast<int>(rank);
    }
  }
  return -1;
}

int DistributedField::FindRank(vtkIdType cell) const
{
  // Find the last process whose first cell is at or before \a cell. A process without cells has the
  // same first cell as the next process.
  return static_cast<int>(
    std::upper_bound(this->FirstCells.begin(), this->FirstCells.end() - 1, cell) -
    this->FirstCells.begin() - 1);
}

vtkIdType DistributedField::GetNumberOfCells() const
{
  return this->FirstCells.empty() ? this->FullGrid->GetNumberOfCells() : this->FirstCells.back();
}

Error DistributedField::CheckData(vtkDataSet* data) const
{
  int held[6] = { 0, -1, 0, -1, 0, -1 };
  if (vtkImageData* image = vtkImageData::SafeDownCast(data))
  {
    image->GetExtent(held);
  }
  else if (vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    grid->GetExtent(held);
  }
  else if (vtkStructuredGrid* curved = vtkStructuredGrid::SafeDownCast(data))
  {
    curved->GetExtent(held);
  }
  const Extent requested = this->GetHeldExtent();
  for (std::size_t axis = 0; axis < 3 && !this->IsEmpty(); ++axis)
  {
    if (held[2 * axis] > requested[2 * axis] || held[2 * axis + 1] < requested[2 * axis + 1])
    {
      return "Process " + std::to_string(this->Exchange.GetRank()) + " received the extent " +
        Describe(held) + " of the field but requested " + Describe(requested.data()) +
        ". The source must provide the requested extent.";
    }
  }
  return {};
}

Error DistributedField::SetData(vtkDataSet* data, vtkIdType few, bool isOfBlocks)
{
  if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    this->Data = WithoutDuplicates(WithoutDuplicateCells(grid));
    this->MakeUnstructuredGrid(few);
    if (isOfBlocks && !this->PartitionError)
    {
      this->PartitionError = this->UniteBlocks();
    }
    this->Part.FullGrid = this->FullGrid;
    return {};
  }
  if (Error error = this->Exchange.FindFirst(this->CheckData(data)))
  {
    return error;
  }
  this->Data = WithoutDuplicates(data);
  std::copy_n(this->WholeExtent.begin(), 6, this->Part.WholeExtent);
  std::copy_n(
    this->Own[static_cast<std::size_t>(this->Exchange.GetRank())].begin(), 6, this->Part.Own);
  Error error;
  if (vtkStructuredGrid::SafeDownCast(data))
  {
    this->MakeStructuredGrid(data);
  }
  else if (vtkImageData::SafeDownCast(data))
  {
    error = this->MakeImage(data);
  }
  else
  {
    this->MakeRectilinearGrid(data);
  }
  this->Part.FullGrid = this->FullGrid;
  this->NumberOfPoints = this->FullGrid->GetNumberOfPoints();
  return this->Exchange.FindFirst(error);
}

Error DistributedField::MakeImage(vtkDataSet* data)
{
  vtkImageData* image = vtkImageData::SafeDownCast(data);
  const vtkSmartPointer<vtkImageData> full = vtkSmartPointer<vtkImageData>::New();
  image->GetExtent(this->Part.Held);
  full->SetOrigin(image->GetOrigin());
  full->SetSpacing(image->GetSpacing());
  full->SetDirectionMatrix(image->GetDirectionMatrix());
  full->SetExtent(this->WholeExtent.data());
  this->FullGrid = full;
  // A value is the same in all processes if its maximum equals its minimum. The minimum is computed
  // as the maximum of the negated values.
  std::vector<double> numbers(image->GetOrigin(), image->GetOrigin() + 3);
  numbers.insert(numbers.end(), image->GetSpacing(), image->GetSpacing() + 3);
  const double* directions = image->GetDirectionMatrix()->GetData();
  numbers.insert(numbers.end(), directions, directions + 9);
  std::vector<double> negatives(numbers.size());
  std::transform(numbers.begin(), numbers.end(), negatives.begin(), std::negate<double>());
  this->Exchange.ReduceMax(numbers);
  this->Exchange.ReduceMax(negatives);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (numbers[i] != -negatives[i])
    {
      return "The origin, spacing or direction matrix of the image differs between processes. "
             "Use the same values in all processes.";
    }
  }
  return {};
}

void DistributedField::MakeRectilinearGrid(vtkDataSet* data)
{
  vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(data);
  const vtkSmartPointer<vtkRectilinearGrid> full = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->GetExtent(this->Part.Held);
  full->SetExtent(this->WholeExtent.data());
  vtkDataArray* const own[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = this->WholeExtent[static_cast<std::size_t>(2 * axis)];
    const int last = this->WholeExtent[static_cast<std::size_t>(2 * axis + 1)];
    std::vector<double> values(static_cast<std::size_t>(last - first + 1), None);
    CopyCoordinates(own[axis], first, this->Part.Held + 2 * axis, values);
    this->Exchange.ReduceMax(values);
    coordinates[axis]->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), coordinates[axis]->GetPointer(0));
  }
  full->SetXCoordinates(coordinates[0]);
  full->SetYCoordinates(coordinates[1]);
  full->SetZCoordinates(coordinates[2]);
  this->FullGrid = full;
}

std::array<double, 6> DistributedField::FindBounds()
{
  std::array<double, 6> bounds{ { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX,
    VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX } };
  if (!this->IsEmpty())
  {
    this->Data->GetBounds(bounds.data());
  }
  this->Exchange.Unite(bounds.data());
  return bounds;
}

void DistributedField::MakeStructuredGrid(vtkDataSet* data)
{
  vtkStructuredGrid::SafeDownCast(data)->GetExtent(this->Part.Held);
  const std::array<double, 6> bounds = this->FindBounds();
  const vtkSmartPointer<vtkRectilinearGrid> full = vtkSmartPointer<vtkRectilinearGrid>::New();
  full->SetExtent(this->WholeExtent.data());
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto first = static_cast<std::size_t>(2 * axis);
    const int number = this->WholeExtent[first + 1] - this->WholeExtent[first] + 1;
    coordinates[axis]->SetNumberOfTuples(number);
    coordinates[axis]->Fill(bounds[first]);
    coordinates[axis]->SetValue(number - 1, bounds[first + 1]);
  }
  full->SetXCoordinates(coordinates[0]);
  full->SetYCoordinates(coordinates[1]);
  full->SetZCoordinates(coordinates[2]);
  this->FullGrid = full;
}

void DistributedField::MakeUnstructuredGrid(vtkIdType few)
{
  const auto rank = static_cast<std::size_t>(this->Exchange.GetRank());
  std::vector<vtkIdType> cells(static_cast<std::size_t>(this->Exchange.GetNumberOfRanks()), 0);
  cells[rank] = this->Data->GetNumberOfCells();
  this->Exchange.ReduceSum(cells);
  this->FirstCells.assign(cells.size() + 1, 0);
  std::partial_sum(cells.begin(), cells.end(), this->FirstCells.begin() + 1);
  this->Part.FirstCell = this->FirstCells[rank];
  this->Part.EndCell = this->FirstCells[rank + 1];
  const vtkSmartPointer<vtkUnstructuredGrid> full = vtkSmartPointer<vtkUnstructuredGrid>::New();
  this->FullGrid = full;
  if (this->FirstCells.back() == 0)
  {
    this->PartitionError = "the field has no cells in any process";
    return;
  }
  const std::array<double, 6> bounds = this->FindBounds();
  vtkNew<vtkPoints> ends;
  ends->SetDataTypeToDouble();
  ends->InsertNextPoint(bounds[0], bounds[2], bounds[4]);
  ends->InsertNextPoint(bounds[1], bounds[3], bounds[5]);
  full->SetPoints(ends);
  this->PartitionError = this->FindPartitionError();
  std::vector<vtkIdType> points{ this->Data->GetNumberOfPoints() };
  this->Exchange.ReduceSum(points);
  // Usually only a few processes share a point. If the processes' points add up to far more than
  // \a few, more than \a few remain after removal of duplicates.
  constexpr vtkIdType maximumRatio = 16;
  if (points[0] > few && points[0] <= maximumRatio * few)
  {
    ArrayRows positions;
    std::vector<vtkIdType> own(static_cast<std::size_t>(this->Data->GetNumberOfPoints()));
    std::iota(own.begin(), own.end(), 0);
    if (!own.empty())
    {
      positions.Build(vtkPointSet::SafeDownCast(this->Data)->GetPoints()->GetData());
    }
    std::vector<vtkIdType> repeated{ static_cast<vtkIdType>(
      SharedPoints::FindRepeated(own, positions, this->Exchange).size()) };
    this->Exchange.ReduceSum(repeated);
    points[0] -= repeated[0];
  }
  this->NumberOfPoints = points[0];
}

Error DistributedField::UniteBlocks()
{
  vtkPointData* data = this->Data->GetPointData();
  std::vector<vtkDataArray*> arrays;
  std::vector<std::string> names;
  for (int i = 0; !this->IsEmpty() && i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = data->GetArray(i))
    {
      arrays.push_back(array);
      names.push_back(std::string(array->GetName() ? array->GetName() : "") + " " +
        array->GetDataTypeAsString() + " " + std::to_string(array->GetNumberOfComponents()) +
        (array == data->GetVectors() ? " vectors" : ""));
    }
  }
  ArrayRows positions;
  std::string own;
  if (!this->IsEmpty())
  {
    vtkDataArray* points = vtkPointSet::SafeDownCast(this->Data)->GetPoints()->GetData();
    positions.Build(points);
    own = points->GetDataTypeAsString();
  }
  for (const std::string& name : names)
  {
    own += "; " + name;
  }
  const std::string first = this->Exchange.FindFirstText(own);
  if (this->Exchange.IsAnywhere(!own.empty() && own != first))
  {
    return "the blocks of the processes have different arrays or data types";
  }
  SharedPoints::CopyFromLowestRank(
    positions, arrays, this->IsEmpty() ? 0 : this->Data->GetNumberOfPoints(), this->Exchange);
  return {};
}

Error DistributedField::FindPartitionError()
{
  // Data of each process: numbers of cells and points, bounds, and one corner each of the first and
  // the last cell.
  constexpr std::size_t size = 14;
  const auto ranks = static_cast<std::size_t>(this->Exchange.GetNumberOfRanks());
  std::vector<double> known(size * ranks, None);
  if (!this->IsEmpty())
  {
    double* own = known.data() + size * static_cast<std::size_t>(this->Exchange.GetRank());
    own[0] = static_cast<double>(this->Data->GetNumberOfCells());
    own[1] = static_cast<double>(this->Data->GetNumberOfPoints());
    this->Data->GetBounds(own + 2);
    vtkNew<vtkIdList> corners;
    this->Data->GetCellPoints(0, corners);
    this->Data->GetPoint(corners->GetId(0), own + 8);
    this->Data->GetCellPoints(this->Data->GetNumberOfCells() - 1, corners);
    this->Data->GetPoint(corners->GetId(0), own + 11);
  }
  this->Exchange.ReduceMax(known);
  std::vector<std::vector<double>> parts;
  for (std::size_t rank = 0; rank < ranks; ++rank)
  {
    const auto first = known.begin() + static_cast<std::ptrdiff_t>(size * rank);
    if (*first != None)
    {
      parts.emplace_back(first, first + size);
    }
  }
  std::sort(parts.begin(), parts.end());
  if (parts.size() < 2)
  {
    return "the source assigns all cells to one process";
  }
  return std::adjacent_find(parts.begin(), parts.end()) == parts.end()
    ? Error()
    : "the source assigns the same cells to several processes";
}

}
