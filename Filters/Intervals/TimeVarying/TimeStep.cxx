// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/TimeStep.h"

#include "Arrays/ExtractionArrays.h"
#include "Common/ArrayMatch.h"
#include "Common/GridCells.h"
#include "Pass/GhostCells.h"
#include "Scalars/ExtractionDispatch.h"
#include "Scalars/ExtractionScalars.h"
#include "Static/ExtractionLinearizer.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <vector>

namespace interlume
{

namespace
{
bool HasSameValues(vtkDataArray* a, vtkDataArray* b)
{
  if (a == b)
  {
    return true;
  }
  if (a->GetNumberOfValues() != b->GetNumberOfValues())
  {
    return false;
  }
  if (a->GetDataType() == b->GetDataType() && a->HasStandardMemoryLayout() &&
    b->HasStandardMemoryLayout())
  {
    return std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
             static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) == 0;
  }
  for (vtkIdType tuple = 0; tuple < a->GetNumberOfTuples(); ++tuple)
  {
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      if (a->GetComponent(tuple, c) != b->GetComponent(tuple, c))
      {
        return false;
      }
    }
  }
  return true;
}

bool HasSameFrame(vtkImageData* a, vtkImageData* b)
{
  return std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin()) &&
    std::equal(a->GetSpacing(), a->GetSpacing() + 3, b->GetSpacing()) &&
    std::equal(a->GetExtent(), a->GetExtent() + 6, b->GetExtent()) &&
    std::equal(a->GetDirectionMatrix()->GetData(), a->GetDirectionMatrix()->GetData() + 9,
      b->GetDirectionMatrix()->GetData());
}

// Returns the scalars, the other point arrays and the coordinates.
std::vector<vtkDataArray*> GetArrays(vtkDataSet* input, vtkDataArray* scalars)
{
  std::vector<vtkDataArray*> arrays = { scalars };
  for (int a = 0; a < input->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = input->GetPointData()->GetArray(a);
    if (array && array != scalars)
    {
      arrays.push_back(array);
    }
  }
  vtkPointSet* set = vtkPointSet::SafeDownCast(input);
  if (set && set->GetPoints())
  {
    arrays.push_back(set->GetPoints()->GetData());
  }
  return arrays;
}

const void* GetMemory(vtkDataArray* array)
{
  return array->HasStandardMemoryLayout() ? array->GetVoidPointer(0) : array;
}

std::string DescribeChange(const char* what, vtkIdType before, vtkIdType now)
{
  std::ostringstream words;
  words << "the number of " << what << " is " << now << " but was " << before
        << " at the previous time step";
  return words.str();
}
}

TimeStep::TimeStep(vtkDataSet* input, vtkDataArray* scalars, double time, bool isCopied)
  : Time(time)
  , NumberOfInputCells(input->GetNumberOfCells())
{
  vtkSmartPointer<vtkDataSet> copy;
  if (isCopied)
  {
    copy.TakeReference(input->NewInstance());
    copy->DeepCopy(input);
    for (int a = 0; a < input->GetPointData()->GetNumberOfArrays(); ++a)
    {
      if (input->GetPointData()->GetAbstractArray(a) == scalars)
      {
        scalars = copy->GetPointData()->GetArray(a);
        break;
      }
    }
    input = copy;
  }
  else
  {
    for (vtkDataArray* array : GetArrays(input, scalars))
    {
      this->Sources.push_back({ array, array->GetMTime() });
    }
  }
  this->HasRows = ExtractionArrays::GetRowDimensions(input, this->Dimensions);
  if (!this->HasRows && ExtractionLinearizer::IsNeeded(input))
  {
    std::vector<vtkIdType> cellIds;
    this->Grid = ExtractionLinearizer::Execute(input, cellIds, this->NumberOfConcave);
    scalars = vtkDataArray::SafeDownCast(
      ArrayMatch::Find(input->GetPointData(), scalars, this->Grid->GetPointData()));
  }
  else
  {
    this->Grid.TakeReference(input->NewInstance());
    this->Grid->ShallowCopy(input);
  }
  this->Scalars = ExtractionDispatch::MakeContiguous(scalars);
  GhostCells::SetBlanking(this->Grid, *this);
  this->NonFinite = NonFinitePoints(this->Grid);
}

vtkUnstructuredGrid* TimeStep::GetUnstructuredGrid() const
{
  return vtkUnstructuredGrid::SafeDownCast(this->Grid);
}

bool TimeStep::MakeCodes(const ExtractionContext& context, double from, double to)
{
  if (this->Codes.GetSize() > 0)
  {
    return true;
  }
  this->Codes.Allocate(this->GetNumberOfPoints());
  const auto scalars =
    ExtractionScalars::Make(this->Scalars, *context.Values, this->NonFinite.GetMarks());
  return context.Run(this->GetNumberOfPoints(), from, to,
    [&](vtkIdType first, vtkIdType last)
    {
      ExtractionValues::Code* codes = this->Codes.GetData() + first;
      scalars->Classify(first, last - first, codes);
      ExtractionValues::Code bits = 0;
      for (vtkIdType p = 0; p < last - first; ++p)
      {
        bits = static_cast<ExtractionValues::Code>(bits | codes[p]);
      }
      if (ExtractionValues::IsTie(bits))
      {
        this->Ties = true;
      }
    });
}

bool TimeStep::IsOverwritten(vtkDataSet* next, vtkDataArray* scalars) const
{
  const std::vector<vtkDataArray*> arrays = GetArrays(next, scalars);
  return std::any_of(arrays.begin(), arrays.end(),
    [this, scalars](vtkDataArray* array)
    {
      const void* memory = GetMemory(array);
      const auto source = std::find_if(this->Sources.begin(), this->Sources.end(),
        [memory](const Source& one) { return GetMemory(one.Array) == memory; });
      // Not every VTK source marks overwritten scalars as modified. Two steps have different
      // scalars, so shared memory proves that the scalars of this step were overwritten.
      return source != this->Sources.end() &&
        (array == scalars || array->GetMTime() > source->Time);
    });
}

Error TimeStep::FindDifference(const TimeStep& before) const
{
  if (std::strcmp(this->Grid->GetClassName(), before.Grid->GetClassName()) != 0)
  {
    return std::string("the dataset is a ") + this->Grid->GetClassName() + " but was a " +
      before.Grid->GetClassName() + " at the previous time step";
  }
  if (this->GetNumberOfPoints() != before.GetNumberOfPoints())
  {
    return DescribeChange("points", before.GetNumberOfPoints(), this->GetNumberOfPoints());
  }
  if (this->GetNumberOfCells() != before.GetNumberOfCells())
  {
    return DescribeChange("cells", before.GetNumberOfCells(), this->GetNumberOfCells());
  }
  if (this->HasRows)
  {
    return std::equal(this->Dimensions, this->Dimensions + 3, before.Dimensions)
      ? Error()
      : "the dimensions differ from the previous time step";
  }
  vtkUnstructuredGrid* now = this->GetUnstructuredGrid();
  vtkUnstructuredGrid* then = before.GetUnstructuredGrid();
  const bool isSame = this->GetNumberOfCells() == 0 ||
    (HasSameValues(GridCells::GetStoredTypes(now), GridCells::GetStoredTypes(then)) &&
      HasSameValues(now->GetCells()->GetOffsetsArray(), then->GetCells()->GetOffsetsArray()) &&
      HasSameValues(
        now->GetCells()->GetConnectivityArray(), then->GetCells()->GetConnectivityArray()));
  return isSame ? Error() : "the cell types or the cell points differ from the previous time step";
}

bool TimeStep::HasSamePoints(const TimeStep& other) const
{
  if (vtkPointSet* set = vtkPointSet::SafeDownCast(this->Grid))
  {
    vtkPoints* points = set->GetPoints();
    vtkPoints* otherPoints = vtkPointSet::SafeDownCast(other.Grid)->GetPoints();
    return points == otherPoints || HasSameValues(points->GetData(), otherPoints->GetData());
  }
  if (vtkImageData* image = vtkImageData::SafeDownCast(this->Grid))
  {
    return HasSameFrame(image, vtkImageData::SafeDownCast(other.Grid));
  }
  vtkRectilinearGrid* a = vtkRectilinearGrid::SafeDownCast(this->Grid);
  vtkRectilinearGrid* b = vtkRectilinearGrid::SafeDownCast(other.Grid);
  return HasSameValues(a->GetXCoordinates(), b->GetXCoordinates()) &&
    HasSameValues(a->GetYCoordinates(), b->GetYCoordinates()) &&
    HasSameValues(a->GetZCoordinates(), b->GetZCoordinates());
}

}
