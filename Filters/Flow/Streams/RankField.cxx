// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/RankField.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExtentTranslator.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <functional>
#include <limits>

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

/// Takes the coordinates of a part into those of the whole.
void CopyCoordinates(
  vtkDataArray* from, int first, const int held[2], std::vector<double>& coordinates)
{
  for (int i = held[0]; from && i <= held[1] && i - held[0] < from->GetNumberOfTuples(); ++i)
  {
    coordinates[static_cast<std::size_t>(i - first)] = from->GetComponent(i - held[0], 0);
  }
}

/// Returns the data without the marks of cells and points that another process has too: they are
/// part of the field, and samples of one process are no copies of another's.
vtkSmartPointer<vtkDataSet> WithoutDuplicates(vtkDataSet* data)
{
  const auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->ShallowCopy(data);
  const auto clear = [](vtkFieldData* attributes, unsigned char mark)
  {
    const char* name = vtkDataSetAttributes::GhostArrayName();
    auto* marks = vtkUnsignedCharArray::SafeDownCast(attributes->GetAbstractArray(name));
    if (!marks)
    {
      return;
    }
    const unsigned char* first = marks->GetPointer(0);
    const vtkIdType number = marks->GetNumberOfValues();
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
}

RankField::RankField(vtkMultiProcessController* controller, const int whole[6])
  : Exchange(controller)
{
  std::copy_n(whole, 6, this->WholeExtent.begin());
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

bool RankField::IsEmpty() const
{
  return !FieldPart::HasCells(this->Own[static_cast<std::size_t>(this->Exchange.GetRank())].data());
}

RankField::Extent RankField::GetHeld() const
{
  Extent held = this->Own[static_cast<std::size_t>(this->Exchange.GetRank())];
  for (std::size_t axis = 0; axis < 3 && !this->IsEmpty(); ++axis)
  {
    held[2 * axis] = std::max(held[2 * axis] - 1, this->WholeExtent[2 * axis]);
    held[2 * axis + 1] = std::min(held[2 * axis + 1] + 1, this->WholeExtent[2 * axis + 1]);
  }
  return held;
}

int RankField::FindRank(const int cell[3]) const
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

std::string RankField::CheckData(vtkDataSet* data) const
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
  const Extent asked = this->GetHeld();
  for (std::size_t axis = 0; axis < 3 && !this->IsEmpty(); ++axis)
  {
    if (held[2 * axis] > asked[2 * axis] || held[2 * axis + 1] < asked[2 * axis + 1])
    {
      return "Process " + std::to_string(this->Exchange.GetRank()) + " got the extent " +
        Describe(held) + " of the field, and asked for " + Describe(asked.data()) + ".";
    }
  }
  return {};
}

std::string RankField::SetData(vtkDataSet* data)
{
  const std::string wrong = this->Exchange.FindFirst(this->CheckData(data));
  if (!wrong.empty())
  {
    return wrong;
  }
  this->Data = WithoutDuplicates(data);
  std::copy_n(this->WholeExtent.begin(), 6, this->Part.WholeExtent);
  std::copy_n(
    this->Own[static_cast<std::size_t>(this->Exchange.GetRank())].begin(), 6, this->Part.Own);
  std::string error;
  if (vtkStructuredGrid::SafeDownCast(data))
  {
    this->MakeStructuredGrid(data);
  }
  else
  {
    error =
      vtkImageData::SafeDownCast(data) ? this->MakeImage(data) : this->MakeRectilinearGrid(data);
  }
  this->Part.Whole = this->Whole;
  return this->Exchange.FindFirst(error);
}

std::string RankField::MakeImage(vtkDataSet* data)
{
  vtkImageData* image = vtkImageData::SafeDownCast(data);
  const vtkSmartPointer<vtkImageData> whole = vtkSmartPointer<vtkImageData>::New();
  image->GetExtent(this->Part.Held);
  whole->SetOrigin(image->GetOrigin());
  whole->SetSpacing(image->GetSpacing());
  whole->SetDirectionMatrix(image->GetDirectionMatrix());
  whole->SetExtent(this->WholeExtent.data());
  this->Whole = whole;
  // The largest of a number and of its negative are the same number in all processes.
  std::vector<double> numbers(image->GetOrigin(), image->GetOrigin() + 3);
  numbers.insert(numbers.end(), image->GetSpacing(), image->GetSpacing() + 3);
  const double* directions = image->GetDirectionMatrix()->GetData();
  numbers.insert(numbers.end(), directions, directions + 9);
  std::vector<double> negatives(numbers.size());
  std::transform(numbers.begin(), numbers.end(), negatives.begin(), std::negate<double>());
  this->Exchange.Maximize(numbers);
  this->Exchange.Maximize(negatives);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (numbers[i] != -negatives[i])
    {
      return "The pieces of the field differ in origin, spacing or direction between processes.";
    }
  }
  return {};
}

std::string RankField::MakeRectilinearGrid(vtkDataSet* data)
{
  vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(data);
  const vtkSmartPointer<vtkRectilinearGrid> whole = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->GetExtent(this->Part.Held);
  whole->SetExtent(this->WholeExtent.data());
  vtkDataArray* const own[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = this->WholeExtent[static_cast<std::size_t>(2 * axis)];
    const int last = this->WholeExtent[static_cast<std::size_t>(2 * axis + 1)];
    std::vector<double> values(static_cast<std::size_t>(last - first + 1), None);
    CopyCoordinates(own[axis], first, this->Part.Held + 2 * axis, values);
    this->Exchange.Maximize(values);
    coordinates[axis]->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), coordinates[axis]->GetPointer(0));
  }
  whole->SetXCoordinates(coordinates[0]);
  whole->SetYCoordinates(coordinates[1]);
  whole->SetZCoordinates(coordinates[2]);
  this->Whole = whole;
  return {};
}

void RankField::MakeStructuredGrid(vtkDataSet* data)
{
  vtkStructuredGrid::SafeDownCast(data)->GetExtent(this->Part.Held);
  double bounds[6] = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX,
    VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  if (!this->IsEmpty())
  {
    this->Data->GetBounds(bounds);
  }
  this->Exchange.Unite(bounds);
  const vtkSmartPointer<vtkRectilinearGrid> whole = vtkSmartPointer<vtkRectilinearGrid>::New();
  whole->SetExtent(this->WholeExtent.data());
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto first = static_cast<std::size_t>(2 * axis);
    const int number = this->WholeExtent[first + 1] - this->WholeExtent[first] + 1;
    coordinates[axis]->SetNumberOfTuples(number);
    coordinates[axis]->Fill(bounds[2 * axis]);
    coordinates[axis]->SetValue(number - 1, bounds[2 * axis + 1]);
  }
  whole->SetXCoordinates(coordinates[0]);
  whole->SetYCoordinates(coordinates[1]);
  whole->SetZCoordinates(coordinates[2]);
  this->Whole = whole;
}

}
