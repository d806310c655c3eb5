// SPDX-License-Identifier: BSD-3-Clause
#include "Static/Extraction.h"

#include "Arrays/ExtractionArrays.h"
#include "Arrays/PointArrays.h"
#include "Common/ArrayMatch.h"
#include "Common/GridCells.h"
#include "Common/ParallelFor.h"
#include "Grid/InteriorCellFilter.h"
#include "Output/SizeWarning.h"
#include "Pass/ExtractionCleanup.h"
#include "Pass/ExtractionIndex.h"
#include "Pass/GhostCells.h"
#include "Pass/NonFinitePoints.h"
#include "Pass/InteriorFaces.h"
#include "Scalars/ExtractionDispatch.h"
#include "Static/ExtractionInput.h"
#include "Static/ExtractionLinearizer.h"
#include "Static/InteriorCellOutput.h"
#include "Static/SurfaceCells.h"
#include "Structured/StructuredExtraction.h"
#include "Unstructured/UnstructuredExtraction.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace interlume
{

namespace
{
void AddNamed(vtkDataSetAttributes* attributes, vtkDataArray* array, const char* name)
{
  array->SetName(name);
  attributes->AddArray(array);
}

void MapIds(const std::vector<vtkIdType>& map, vtkIdType* ids, std::size_t number)
{
  std::transform(ids, ids + number, ids, [&map](vtkIdType id) { return map[id]; });
}

void AddPointOrigins(const ExtractionBuffer<ExtractionPoint>& points, vtkPointData* output)
{
  const vtkIdType number = static_cast<vtkIdType>(points.GetSize());
  vtkNew<vtkIdTypeArray> ends;
  ends->SetNumberOfComponents(2);
  ends->SetNumberOfTuples(number);
  vtkNew<vtkDoubleArray> weights;
  weights->SetNumberOfValues(number);
  ParallelFor(0, number,
    [&](vtkIdType p)
    {
      ends->SetValue(2 * p, points[p].Near);
      ends->SetValue(2 * p + 1, points[p].Far);
      weights->SetValue(p, points[p].Near == points[p].Far ? 0.0 : points[p].Weight);
    });
  AddNamed(output, ends, "OriginPoints");
  AddNamed(output, weights, "OriginWeight");
}

void AddCellOrigins(const vtkIdType* cells, std::size_t number, vtkCellData* output)
{
  vtkNew<vtkIdTypeArray> origins;
  origins->SetNumberOfValues(static_cast<vtkIdType>(number));
  std::copy_n(cells, number, origins->GetPointer(0));
  AddNamed(output, origins, "OriginCell");
}
}

// Warns if the output is large. The bytes include the lists of points and cells that exist until
// the arrays are filled.
void Extraction::CheckSize(const ExtractionContext& context, vtkIdType points, vtkIdType simplices,
  vtkIdType interiorCells) const
{
  constexpr int pointsOfInteriorCell = 8;
  const vtkIdType cells = simplices + interiorCells;
  const vtkIdType ids = context.GetSimplexSize() * simplices + pointsOfInteriorCell * interiorCells;
  const std::size_t idBytes = SimplexList::CanUse32BitStorage(points, ids) ? 4 : 8;
  const std::size_t pointBytes =
    ExtractionArrays::GetBytesPerPoint(context.Input, this->OutputPointsPrecision) +
    (context.Arrays ? 0 : sizeof(ExtractionPoint));
  const std::size_t cellBytes = ExtractionArrays::GetBytesPerCell(context.Input) + idBytes + 1 +
    sizeof(int) + (context.KeepCellIds ? sizeof(vtkIdType) : 0);
  this->Warning->Add(static_cast<double>(simplices),
    static_cast<double>(points) * pointBytes + static_cast<double>(cells) * cellBytes +
      static_cast<double>(ids) * idBytes,
    this->InteriorPass || this->Dimension == 2
      ? "Use narrower intervals or a coarser input."
      : "Use narrower intervals or a coarser input, or turn on KeepInteriorCells.",
    this->Dimension == 2 ? "triangles" : "tetrahedra");
}

bool Extraction::ExtractMesh(ExtractionContext& context, ExtractionMesh& mesh, PointArrays& arrays)
{
  int dimensions[3];
  const bool hasRows = ExtractionArrays::GetRowDimensions(context.Input, dimensions);
  const vtkIdType cells = context.Input->GetNumberOfCells();
  const bool isFlat = hasRows && *std::min_element(dimensions, dimensions + 3) < 2;
  if (cells == 0 || isFlat)
  {
    context.Report->LowerDimensionalCells += cells;
    return true;
  }
  if (context.Index)
  {
    if (context.Index->Select(
          context.Input, context.Scalars, hasRows ? dimensions : nullptr, this->Dimension))
    {
      context.Index->Activate(*context.Values);
    }
    else
    {
      context.Index = nullptr;
    }
  }
  if (hasRows)
  {
    const bool needsList = !this->SharePoints || this->GenerateOriginArrays ||
      this->InputBoundary || this->InteriorPass || this->GenerateBoundaries;
    context.Arrays = needsList ? nullptr : &arrays;
    return StructuredExtraction::Execute(context, dimensions, mesh);
  }
  context.Unshared = this->SharePoints ? nullptr : &arrays;
  context.IncludeGhostCells = GhostCells::HaveTies(context);
  return UnstructuredExtraction::Execute(
    context, vtkUnstructuredGrid::SafeDownCast(context.Input), mesh);
}

ExtractionIndex::LinearGrid* Extraction::Linearize(
  ExtractionContext& context, ExtractionIndex::LinearGrid& own) const
{
  vtkDataSet* const input = context.Input;
  const bool isSurface = this->Dimension == 2;
  int dimensions[3];
  // Passes after the first copy the interior polyhedra instead of splitting them.
  const bool isFurther = this->InteriorPass && this->InteriorPass->First >= 0;
  const bool isNeeded = isSurface
    ? SurfaceCells::IsNeeded(input)
    : !isFurther && !ExtractionArrays::GetRowDimensions(input, dimensions) &&
      ExtractionLinearizer::IsNeeded(input);
  if (!isNeeded)
  {
    return nullptr;
  }
  ExtractionIndex::LinearGrid& linear =
    this->Index ? this->Index->GetLinearGrid(input, this->Dimension) : own;
  if (!linear.Grid && isSurface)
  {
    SurfaceCells::Convert(input, linear);
  }
  else if (!linear.Grid)
  {
    linear.Grid = ExtractionLinearizer::Execute(input, linear.CellIds, linear.NumberOfConcave);
  }
  ExtractionReport& report = *context.Report;
  report.ConcavePolyhedra = linear.NumberOfConcave;
  report.FoldedCells = linear.NumberOfFolded;
  report.LinearizedCells = linear.NumberOfHigherOrder;
  report.LowerDimensionalCells = this->IsMixed ? 0 : linear.NumberOfLowerDimensional;
  context.Input = linear.Grid;
  GhostCells::SetBlanking(linear.Grid, context);
  context.Scalars = vtkDataArray::SafeDownCast(
    ArrayMatch::Find(input->GetPointData(), context.Scalars, linear.Grid->GetPointData()));
  return &linear;
}

bool Extraction::Execute(vtkDataSet* input, vtkDataArray* scalars, vtkUnstructuredGrid* output,
  vtkUnstructuredGrid* boundary, ExtractionReport& report)
{
  ExtractionContext context;
  context.Owner = this->Owner;
  context.Values = this->Values;
  context.Input = input;
  context.Scalars = scalars;
  context.Dimension = this->Dimension;
  context.IsMixed = this->IsMixed;
  context.Index = this->Index;
  context.Report = &report;
  context.GenerateBoundaries = this->GenerateBoundaries;
  const bool isSurface = this->Dimension == 2;
  context.KeepOrientation = this->KeepOrientation || isSurface;
  context.KeepCellIds = input->GetCellData()->GetNumberOfArrays() > 0 || this->InputBoundary ||
    this->GenerateOriginArrays;
  GhostCells::SetBlanking(input, context);

  ExtractionIndex::LinearGrid ownLinear;
  ExtractionIndex::LinearGrid* const linear = this->Linearize(context, ownLinear);
  const vtkSmartPointer<vtkDataArray> contiguous =
    ExtractionDispatch::MakeContiguous(context.Scalars);
  context.Scalars = contiguous;
  vtkSmartPointer<vtkDataSet> shown;
  if (!this->SkippedConstants.empty())
  {
    shown = ExtractionInput::HideCells(context.Input,
      [&](vtkIdList* points)
      {
        return std::any_of(this->SkippedConstants.begin(), this->SkippedConstants.end(),
          [&](double constant)
          {
            return std::all_of(points->begin(), points->end(),
              [&](vtkIdType point) { return contiguous->GetComponent(point, 0) == constant; });
          });
      });
    context.Input = shown;
    GhostCells::SetBlanking(shown, context);
  }
  // If orientations are kept, the previous pass computed the input points, which are thus finite.
  const NonFinitePoints nonFinite =
    this->KeepOrientation ? NonFinitePoints() : NonFinitePoints(context.Input);
  context.NonFinitePoints = nonFinite.GetMarks();

  std::optional<InteriorCellFilter> interiorFilter;
  if (this->InteriorPass)
  {
    interiorFilter.emplace(input, linear ? &linear->CellIds : nullptr, *this->InteriorPass);
    context.InteriorFilter = &*interiorFilter;
    context.KeepCellIds |= interiorFilter->HasParts();
  }

  // The points of a converted image are doubles.
  const bool isDouble =
    ExtractionArrays::ChoosePointType(input, this->OutputPointsPrecision) == VTK_DOUBLE;
  PointArrays arrays(context.Input,
    !isSurface   ? this->OutputPointsPrecision
      : isDouble ? vtkAlgorithm::DOUBLE_PRECISION
                 : vtkAlgorithm::SINGLE_PRECISION);
  ExtractionMesh mesh;
  mesh.HasSeveralItems = this->Values->GetItems().size() > 1;
  if (this->Warning && this->Warning->IsPending())
  {
    mesh.BeforeAllocation = [this, &context](
                              vtkIdType points, vtkIdType simplices, vtkIdType interiorCells)
    { this->CheckSize(context, points, simplices, interiorCells); };
  }
  if (!this->ExtractMesh(context, mesh, arrays))
  {
    return false;
  }
  if (this->InputBoundary)
  {
    this->SetIntervals(input, mesh);
  }
  report.Cells = isSurface && this->IsMixed ? 0 : input->GetNumberOfCells();
  report.FoldedCells += ExtractionInput::CountFoldedRectilinearCells(input);
  if (!mesh.TiedSimplices.empty())
  {
    ExtractionCleanup::RemoveOppositeSimplices(mesh, context.GetSimplexSize());
  }
  if (!mesh.TiedTriangles.empty())
  {
    ExtractionCleanup::ResolveTiedTriangles(context, mesh);
  }
  if (context.IncludeGhostCells)
  {
    GhostCells::Remove(context, mesh);
  }
  if (mesh.Used.GetSize() > 0)
  {
    ExtractionCleanup::RemoveUnusedPoints(mesh, arrays.IsAllocated() ? &arrays : nullptr);
  }
  if (this->InputBoundary)
  {
    ExtractionCleanup::CutBoundary(context, this->InputBoundary, this->InteriorPass, mesh);
  }
  if (!arrays.IsAllocated())
  {
    if (!this->SharePoints)
    {
      ExtractionCleanup::SplitPoints(mesh);
    }
    arrays.Fill(mesh.Points);
  }
  if (this->InteriorPass)
  {
    const bool isFurther = this->InteriorPass->First >= 0;
    report.InteriorCells = mesh.Simplices.GetNumberOfInteriorCells();
    report.NonPlanarFaces =
      isFurther ? 0 : InteriorFaces::CountNonPlanar(context, mesh, arrays.GetPoints());
    this->InteriorPass->First = mesh.Simplices.GetNumber();
    this->InteriorPass->Points = {};
    this->InteriorPass->TriangleInteriorCells = std::move(mesh.TriangleInteriorCells);
  }
  if (linear)
  {
    MapIds(linear->CellIds, mesh.CellIds.GetData(), mesh.CellIds.GetSize());
    MapIds(linear->CellIds, mesh.TriangleCellIds.data(), mesh.TriangleCellIds.size());
  }
  output->SetPoints(arrays.GetPoints());
  this->FillOutput(context, mesh, arrays, input, output);
  if (boundary && (this->GenerateBoundaries || this->InputBoundary))
  {
    this->FillBoundary(context, mesh, input, output, boundary);
  }
  const int origins = this->GenerateOriginArrays ? 1 : 0;
  report.ArraysInterpolated = output->GetPointData()->GetNumberOfArrays() - 2 * origins;
  report.ArraysCopied =
    output->GetCellData()->GetNumberOfArrays() - (this->IdName ? 1 : 0) - origins;
  return true;
}

void Extraction::SetIntervals(vtkDataSet* input, ExtractionMesh& mesh) const
{
  vtkDataArray* const intervals = input->GetCellData()->GetArray("IntervalId");
  const auto getInterval = [intervals](vtkIdType cell)
  { return static_cast<int>(intervals->GetComponent(cell, 0)); };
  for (vtkIdType cell = 0; cell < mesh.ItemIds->GetNumberOfValues(); ++cell)
  {
    mesh.ItemIds->SetValue(cell, getInterval(mesh.CellIds[cell]));
  }
  mesh.HasSeveralItems = true;
  for (vtkIdType t = 0; t < mesh.TriangleSides->GetNumberOfValues(); ++t)
  {
    mesh.TriangleItemIds->SetValue(t, getInterval(mesh.TriangleCellIds[t]));
    mesh.TriangleSides->SetValue(t, this->Sides[mesh.TriangleSides->GetValue(t)]);
  }
  const auto& items = this->Values->GetItems();
  if (items.size() == 2 && items[0].Upper == items[1].Lower)
  {
    // Outside of an interval of zero width, triangles cancel at its value.
    mesh.TiedTriangles.resize(mesh.Triangles.size());
    std::iota(mesh.TiedTriangles.begin(), mesh.TiedTriangles.end(), vtkIdType(0));
  }
}

void Extraction::FillOutput(const ExtractionContext& context, ExtractionMesh& mesh,
  PointArrays& arrays, vtkDataSet* original, vtkUnstructuredGrid* output) const
{
  this->Owner->UpdateProgress(0.85);
  if (mesh.Simplices.GetNumberOfInteriorCells() > 0)
  {
    InteriorCellOutput::SetCells(original, mesh, output);
  }
  else
  {
    GridCells::SetCellsOfOneType(output, context.GetSimplexSize() == 4 ? VTK_TETRA : VTK_TRIANGLE,
      mesh.Simplices.MakeCells(), ThreadGrain,
      [](vtkUnsignedCharArray* types, vtkIdType number)
      { OutputAllocation::SetNumberOfTuples(types, number); });
  }
  arrays.AddTo(output->GetPointData());
  this->Owner->UpdateProgress(0.95);
  ExtractionArrays::CopyCellData(original->GetCellData(), mesh.CellIds.GetData(),
    static_cast<vtkIdType>(mesh.CellIds.GetSize()), output->GetCellData());
  if (this->IdName)
  {
    AddNamed(output->GetCellData(), mesh.ItemIds, this->IdName);
  }
  if (this->GenerateOriginArrays)
  {
    AddPointOrigins(mesh.Points, output->GetPointData());
    AddCellOrigins(mesh.CellIds.GetData(), mesh.CellIds.GetSize(), output->GetCellData());
  }
}

void Extraction::FillBoundary(const ExtractionContext& context, const ExtractionMesh& mesh,
  vtkDataSet* original, vtkUnstructuredGrid* output, vtkUnstructuredGrid* boundary) const
{
  boundary->SetPoints(output->GetPoints());
  boundary->GetPointData()->ShallowCopy(output->GetPointData());
  const vtkIdType number = static_cast<vtkIdType>(mesh.Triangles.size());
  SimplexList triangles;
  triangles.Allocate(number, context.Dimension, output->GetNumberOfPoints());
  for (vtkIdType t = 0; t < number; ++t)
  {
    triangles.Write(t, mesh.Triangles[t].data());
  }
  boundary->SetCells(context.Dimension == 2 ? VTK_LINE : VTK_TRIANGLE, triangles.MakeCells());
  ExtractionArrays::CopyCellData(original->GetCellData(), mesh.TriangleCellIds.data(),
    static_cast<vtkIdType>(mesh.TriangleCellIds.size()), boundary->GetCellData());
  AddNamed(boundary->GetCellData(), mesh.TriangleItemIds, "IntervalId");
  AddNamed(boundary->GetCellData(), mesh.TriangleSides, "BoundarySide");
  if (this->GenerateOriginArrays)
  {
    AddCellOrigins(
      mesh.TriangleCellIds.data(), mesh.TriangleCellIds.size(), boundary->GetCellData());
  }
}

}
