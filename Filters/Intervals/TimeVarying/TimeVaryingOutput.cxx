// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/TimeVaryingOutput.h"

#include "TimeVarying/TimeVaryingReport.h"
#include "TimeVarying/OutputCellArrays.h"
#include "TimeVarying/ProjectedTetrahedra.h"
#include "TimeVarying/TimeVaryingMesh.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace interlume
{

namespace
{
using Slab = TimeVaryingMesh::Slab;
constexpr int NumberOfPoints = SimplexProjection::NumberOfPoints;

// Assigns the points and point arrays of the mesh to the output without copying.
void AssignArrays(const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output)
{
  output->SetPoints(mesh.GetPoints());
  output->GetPointData()->ShallowCopy(mesh.GetArrays());
  output->GetPointData()->AddArray(mesh.GetTimes());
}
}

bool TimeVaryingOutput::FillTetrahedra(const ExtractionContext& context,
  const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output, TimeVaryingReport& report)
{
  return !mesh.GetPoints() || ProjectedTetrahedra(context, mesh, output).Fill(report);
}

double TimeVaryingOutput::EstimateBytes(const TimeVaryingMesh& mesh, double tetrahedra)
{
  if (!mesh.GetPoints())
  {
    return 0.0;
  }
  // Ids, offset and type of a cell, and its cell arrays.
  constexpr int bytesPerTetrahedron = 4 * 4 + 4 + 1 + 1 + 2 * sizeof(int);
  constexpr int bytesPerSimplex = NumberOfPoints * 4 + 4 + 1 + 1 + 2 * sizeof(int);
  const vtkTimeVaryingSettings& settings = mesh.GetOptions().Settings;
  const double points = static_cast<double>(mesh.GetPoints()->GetNumberOfPoints());
  const double pointBytes = static_cast<double>(mesh.GetBytesPerPoint());
  const auto simplices = static_cast<double>(mesh.GetNumberOfSimplices());
  double bytes = static_cast<double>(mesh.GetBytes()) + points * pointBytes;
  if (settings.GenerateTetrahedra)
  {
    // Each 4-simplex has a thick point. DeltaT is stored for all points.
    bytes += (points + simplices) * (pointBytes + sizeof(double)) +
      simplices * sizeof(SimplexSigns) + tetrahedra * bytesPerTetrahedron;
  }
  return settings.GenerateSimplices ? bytes + simplices * bytesPerSimplex : bytes;
}

void TimeVaryingOutput::FillBoundary(
  const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output, TimeVaryingReport& report)
{
  if (!mesh.GetPoints())
  {
    return;
  }
  AssignArrays(mesh, output);
  const auto& cells = mesh.GetBoundary();
  const vtkIdType number = static_cast<vtkIdType>(cells.size());
  auto* kinds = OutputCellArrays::Add<vtkIntArray>(output, "BoundaryKind", number);
  auto* items = OutputCellArrays::Add<vtkIntArray>(output, "IntervalId", number);
  auto* slabs = OutputCellArrays::Add<vtkIntArray>(output, "TimeSlab", number);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(number);
  vtkNew<vtkCellArray> list;
  list->AllocateEstimate(number, 4);
  for (vtkIdType c = 0; c < number; ++c)
  {
    const TimeVaryingMesh::BoundaryCell& cell = cells[c];
    const bool isTriangle = cell.Ids[3] < 0;
    list->InsertNextCell(isTriangle ? 3 : 4, cell.Ids.data());
    types->SetValue(c, isTriangle ? VTK_TRIANGLE : VTK_TETRA);
    kinds->SetValue(c, cell.Kind);
    items->SetValue(c, cell.Item);
    slabs->SetValue(c, cell.Slab);
    if (cell.Kind < vtkTimeVaryingSettings::NUMBER_OF_BOUNDARY_KINDS)
    {
      ++report.Boundaries[cell.Kind];
    }
  }
  output->SetCells(types, list);
}

void TimeVaryingOutput::FillSimplices(const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output)
{
  if (!mesh.GetPoints())
  {
    return;
  }
  AssignArrays(mesh, output);
  const vtkIdType number =
    mesh.GetNumberOfSimplices() + static_cast<vtkIdType>(mesh.GetStepVolume().size());
  SimplexList list;
  list.Allocate(number, NumberOfPoints, mesh.GetPoints()->GetNumberOfPoints());
  auto* items = OutputCellArrays::Add<vtkIntArray>(output, "IntervalId", number);
  auto* slabs = OutputCellArrays::Add<vtkIntArray>(output, "TimeSlab", number);
  auto* atStep = OutputCellArrays::Add<vtkUnsignedCharArray>(output, "AtStep", number);
  vtkIdType next = 0;
  for (const Slab& slab : mesh.GetSlabs())
  {
    for (std::size_t s = 0; s < slab.Simplices.GetSize(); ++s, ++next)
    {
      list.Write(next, slab.Simplices[s].data());
      items->SetValue(next, slab.GetItem(static_cast<vtkIdType>(s)));
      slabs->SetValue(next, slab.Number);
      atStep->SetValue(next,
        slab.Ties[s] ? vtkTimeVaryingSettings::NOTHING_AT_STEP
                     : vtkTimeVaryingSettings::FACES_AT_STEP);
    }
  }
  for (const TimeVaryingMesh::BoundaryCell& cell : mesh.GetStepVolume())
  {
    const vtkIdType ids[NumberOfPoints] = { cell.Ids[0], cell.Ids[1], cell.Ids[2], cell.Ids[3],
      cell.Ids[3] };
    list.Write(next, ids);
    items->SetValue(next, cell.Item);
    slabs->SetValue(next, cell.Slab);
    atStep->SetValue(next++, vtkTimeVaryingSettings::TETRAHEDRON_AT_STEP);
  }
  output->SetCells(VTK_POLY_VERTEX, list.MakeCells());
}

}
