// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/MergedDataSets.h"

#include "Common/Blanking.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <tuple>

namespace interlume
{

namespace
{
/// One of the merged datasets, with the ids of the cells and points to copy.
struct Part
{
  vtkDataSet* Data = nullptr;
  std::vector<vtkIdType> Cells;
  std::vector<vtkIdType> Points;
  /// Id in the merged grid for each point of the part, or -1 if no cell to copy uses the point.
  std::vector<vtkIdType> Merged;
};

Part MakePart(vtkDataSet* data)
{
  Part part;
  part.Data = data;
  part.Merged.assign(static_cast<std::size_t>(data->GetNumberOfPoints()), -1);
  Blanking blanking;
  blanking.SetBlanking(data);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, corners);
    if (blanking.IsCellBlanked(cell) ||
      std::any_of(corners->begin(), corners->end(),
        [&](vtkIdType corner) { return blanking.IsPointBlanked(corner); }))
    {
      continue;
    }
    part.Cells.push_back(cell);
    for (const vtkIdType corner : *corners)
    {
      part.Merged[static_cast<std::size_t>(corner)] = 0;
    }
  }
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    if (part.Merged[static_cast<std::size_t>(point)] == 0)
    {
      part.Points.push_back(point);
    }
  }
  return part;
}

/// A point of a part. Keys are ordered by the bit patterns of their coordinates, because NaN is
/// unordered.
struct PointKey
{
  std::array<std::uint64_t, 3> Bits;
  std::size_t Part;
  vtkIdType Point;

  PointKey(std::size_t part, vtkIdType point, const double x[3])
    : Part(part)
    , Point(point)
  {
    // Adding 0 converts -0 to 0.
    const double sums[3] = { x[0] + 0.0, x[1] + 0.0, x[2] + 0.0 };
    std::memcpy(this->Bits.data(), sums, sizeof(sums));
  }
  bool operator<(const PointKey& other) const
  {
    return std::tie(this->Bits, this->Part, this->Point) <
      std::tie(other.Bits, other.Part, other.Point);
  }
};

/// Assigns an id in the merged grid to each point. Points with equal coordinates get the same id.
/// Returns the number of ids.
vtkIdType NumberPoints(std::vector<Part>& parts)
{
  std::vector<PointKey> keys;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    for (const vtkIdType point : parts[i].Points)
    {
      double x[3];
      parts[i].Data->GetPoint(point, x);
      keys.emplace_back(i, point, x);
    }
  }
  vtkSMPTools::Sort(keys.begin(), keys.end());
  const auto getMerged = [&](const PointKey& key) -> vtkIdType&
  { return parts[key.Part].Merged[static_cast<std::size_t>(key.Point)]; };
  std::vector<std::pair<const PointKey*, const PointKey*>> repeated;
  const PointKey* first = nullptr;
  for (const PointKey& key : keys)
  {
    if (first && first->Bits == key.Bits)
    {
      getMerged(key) = -1;
      repeated.emplace_back(&key, first);
    }
    else
    {
      first = &key;
    }
  }
  vtkIdType number = 0;
  for (Part& part : parts)
  {
    const auto isRepeated = [&](vtkIdType point)
    {
      vtkIdType& merged = part.Merged[static_cast<std::size_t>(point)];
      if (merged == 0)
      {
        merged = number++;
        return false;
      }
      return true;
    };
    part.Points.erase(
      std::remove_if(part.Points.begin(), part.Points.end(), isRepeated), part.Points.end());
  }
  for (const auto& pair : repeated)
  {
    getMerged(*pair.first) = getMerged(*pair.second);
  }
  return number;
}

bool HasFloats(vtkDataSet* data)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  return points && points->GetPoints() && points->GetPoints()->GetDataType() == VTK_FLOAT;
}

/// Converts arrays that exist in all parts, but with different types, to double.
void UniteTypes(std::vector<vtkSmartPointer<vtkDataSet>>& parts, int attributes)
{
  vtkDataSetAttributes* first = parts[0]->GetAttributes(attributes);
  for (int i = 0; i < first->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = first->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    const auto find = [&](vtkDataSet* part)
    {
      vtkDataArray* own =
        name.empty() ? nullptr : part->GetAttributes(attributes)->GetArray(name.c_str());
      return own && own->GetNumberOfComponents() == array->GetNumberOfComponents() ? own : nullptr;
    };
    const bool isCommon = std::all_of(parts.begin(), parts.end(), find);
    if (!isCommon || name == vtkDataSetAttributes::GhostArrayName() ||
      std::all_of(parts.begin(), parts.end(),
        [&](vtkDataSet* part) { return find(part)->GetDataType() == array->GetDataType(); }))
    {
      continue;
    }
    for (vtkDataSet* part : parts)
    {
      vtkNew<vtkDoubleArray> doubles;
      doubles->DeepCopy(find(part));
      part->GetAttributes(attributes)->AddArray(doubles);
    }
  }
}

/// Concatenates the arrays of all parts. \a ids is Part::Points or Part::Cells, the ids of the
/// tuples to copy.
void CopyArrays(const std::vector<Part>& parts, int attributes, std::vector<vtkIdType> Part::*ids,
  vtkIdType number, vtkDataSetAttributes* to)
{
  vtkDataSetAttributes::FieldList common;
  for (const Part& part : parts)
  {
    common.IntersectFieldList(part.Data->GetAttributes(attributes));
  }
  to->CopyAllOn();
  to->CopyAllocate(common, number);
  vtkIdType next = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    vtkDataSetAttributes* from = parts[i].Data->GetAttributes(attributes);
    for (const vtkIdType id : parts[i].*ids)
    {
      to->CopyData(common, from, static_cast<int>(i), id, next++);
    }
  }
  to->RemoveArray(vtkDataSetAttributes::GhostArrayName());
}
}

vtkSmartPointer<vtkUnstructuredGrid> MergedDataSets::Merge(const std::vector<vtkDataSet*>& datasets)
{
  std::vector<vtkSmartPointer<vtkDataSet>> united;
  for (vtkDataSet* data : datasets)
  {
    united.push_back(vtk::TakeSmartPointer(data->NewInstance()));
    united.back()->ShallowCopy(data);
  }
  UniteTypes(united, vtkDataObject::POINT);
  UniteTypes(united, vtkDataObject::CELL);
  std::vector<Part> parts;
  vtkIdType cells = 0;
  for (vtkDataSet* data : united)
  {
    parts.push_back(MakePart(data));
    cells += static_cast<vtkIdType>(parts.back().Cells.size());
  }
  const vtkIdType number = NumberPoints(parts);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(
    std::all_of(datasets.begin(), datasets.end(), HasFloats) ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(number);
  grid->SetPoints(points);
  grid->AllocateEstimate(cells, 8);
  vtkNew<vtkIdList> corners;
  for (const Part& part : parts)
  {
    for (const vtkIdType point : part.Points)
    {
      double x[3];
      part.Data->GetPoint(point, x);
      points->SetPoint(part.Merged[static_cast<std::size_t>(point)], x);
    }
    for (const vtkIdType cell : part.Cells)
    {
      part.Data->GetCellPoints(cell, corners);
      for (vtkIdType& corner : *corners)
      {
        corner = part.Merged[static_cast<std::size_t>(corner)];
      }
      grid->InsertNextCell(part.Data->GetCellType(cell), corners);
    }
  }
  CopyArrays(parts, vtkDataObject::POINT, &Part::Points, number, grid->GetPointData());
  CopyArrays(parts, vtkDataObject::CELL, &Part::Cells, cells, grid->GetCellData());
  return grid;
}

}
