// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/DistributedSamples.h"

#include "Samples/SampleGrid.h"
#include "Streams/DistributedField.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace interlume
{

namespace
{
/// Index of each sample that this process sends, and id of its point in the data of this process.
using Rows = std::vector<std::pair<vtkIdType, vtkIdType>>;

Rows FindRows(DistributedField& field, const std::array<std::vector<vtkIdType>, 3>& indices)
{
  const FieldPartition& part = field.GetPart();
  Rows rows;
  vtkIdType sample = 0;
  for (const vtkIdType k : indices[2])
  {
    for (const vtkIdType j : indices[1])
    {
      for (const vtkIdType i : indices[0])
      {
        const vtkIdType index[3] = { i, j, k };
        int cell[3];
        vtkIdType row = 0;
        vtkIdType stride = 1;
        for (int axis = 0; axis < 3; ++axis)
        {
          const int first = part.WholeExtent[2 * axis];
          const int cells = part.WholeExtent[2 * axis + 1] - first;
          cell[axis] = std::min(static_cast<int>(index[axis]), cells - 1);
          row += stride * (first + index[axis] - part.Held[2 * axis]);
          stride *= part.Held[2 * axis + 1] - part.Held[2 * axis] + 1;
        }
        if (field.FindRank(cell) == field.GetExchange().GetRank())
        {
          rows.emplace_back(sample, row);
        }
        ++sample;
      }
    }
  }
  return rows;
}

/// Fills \a to with the tuples of \a from that all processes send. Each tuple is sent by one
/// process, and the others contribute zeros. Therefore the sum of the bytes over all processes is
/// the tuple. \a from may be null if this process sends nothing.
void Gather(RankExchange& exchange, const Rows& rows, vtkDataArray* from, vtkDataArray* to)
{
  const auto bytes = static_cast<std::size_t>(to->GetNumberOfComponents() * to->GetDataTypeSize());
  const std::size_t words = (bytes + sizeof(vtkIdType) - 1) / sizeof(vtkIdType);
  std::vector<vtkIdType> all(words * static_cast<std::size_t>(to->GetNumberOfTuples()), 0);
  for (std::size_t i = 0; from && i < rows.size(); ++i)
  {
    std::memcpy(&all[words * static_cast<std::size_t>(rows[i].first)],
      from->GetVoidPointer(rows[i].second * to->GetNumberOfComponents()), bytes);
  }
  exchange.ReduceSum(all);
  for (vtkIdType sample = 0; sample < to->GetNumberOfTuples(); ++sample)
  {
    std::memcpy(to->GetVoidPointer(sample * to->GetNumberOfComponents()),
      &all[words * static_cast<std::size_t>(sample)], bytes);
  }
}

/// Adds to \a samples the point arrays of the field. The first process with points defines which
/// arrays there are, except that there is a ghost array if any process has one.
void GatherArrays(DistributedField& field, const Rows& rows, vtkDataSet* samples)
{
  vtkPointData* from = field.GetData()->GetPointData();
  std::ostringstream layout;
  for (int i = 0; !field.IsEmpty() && i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = from->GetArray(i);
    if (array && array->GetName() &&
      std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName())
    {
      layout << array->GetDataType() << " " << array->GetNumberOfComponents() << " "
             << from->IsArrayAnAttribute(i) << " " << array->GetName() << "\n";
    }
  }
  // A ghost array may exist in only some of the partitions.
  const char* ghosts = vtkDataSetAttributes::GhostArrayName();
  const bool hasGhosts = field.GetExchange().IsAnywhere(from->GetArray(ghosts) != nullptr);
  std::istringstream known(field.GetExchange().FindFirstText(layout.str()) +
    (hasGhosts ? std::to_string(VTK_UNSIGNED_CHAR) + " 1 -1 " + ghosts + "\n" : std::string()));
  int type = 0;
  int components = 0;
  int attribute = 0;
  std::string name;
  while (known >> type >> components >> attribute && std::getline(known.ignore(), name))
  {
    const auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(samples->GetNumberOfPoints());
    Gather(field.GetExchange(), rows, from->GetArray(name.c_str()), array);
    const int index = samples->GetPointData()->AddArray(array);
    if (attribute >= 0)
    {
      samples->GetPointData()->SetActiveAttribute(index, attribute);
    }
  }
}
}

vtkSmartPointer<vtkDataSet> DistributedSamples::Make(DistributedField& field)
{
  if (vtkUnstructuredGrid::SafeDownCast(field.GetData()))
  {
    return SampleGrid::MakeVoxels(field.GetFullGrid()->GetBounds());
  }
  vtkSmartPointer<vtkDataSet> samples = SampleGrid::Make(field.GetFullGrid());
  const Rows rows = FindRows(field, SampleGrid::GetIndices(field.GetPart().WholeExtent));
  if (vtkStructuredGrid* data = vtkStructuredGrid::SafeDownCast(field.GetData()))
  {
    const vtkSmartPointer<vtkStructuredGrid> grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetExtent(vtkRectilinearGrid::SafeDownCast(samples)->GetExtent());
    vtkDataArray* from = field.IsEmpty() ? nullptr : data->GetPoints()->GetData();
    // The data type of the coordinates is unknown in a process without points.
    std::vector<double> type{ from ? static_cast<double>(from->GetDataType()) : 0.0 };
    field.GetExchange().ReduceMax(type);
    vtkNew<vtkPoints> points;
    points->SetDataType(static_cast<int>(type[0]));
    points->SetNumberOfPoints(samples->GetNumberOfPoints());
    Gather(field.GetExchange(), rows, from, points->GetData());
    grid->SetPoints(points);
    samples = grid;
  }
  GatherArrays(field, rows, samples);
  return samples;
}

}
