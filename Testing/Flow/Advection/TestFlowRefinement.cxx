// SPDX-License-Identifier: BSD-3-Clause
// Samples refined where neighboring results differ. Cells match at faces and fill the original
// cells on grids of every kind. Each level halves the volume that a flow volume omits at a
// separatrix and at a surface to which the flow returns. Also tests arrays, threads, pieces,
// ghosts, progress and abort.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Meshes/ReferenceGrid.h"

#include "vtkFlowStatus.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationPlane.h"

#include "vtkAppendFilter.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkTetra.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace
{

using namespace reference;

constexpr double FullTurn = 6.283185307179586;

vtkSmartPointer<vtkTerminationPlane> MakePlane(
  const Vector& origin, const Vector& u, const Vector& v, int id)
{
  auto plane = vtkSmartPointer<vtkTerminationPlane>::New();
  plane->SetOrigin(origin[0], origin[1], origin[2]);
  plane->SetPoint1(origin[0] + u[0], origin[1] + u[1], origin[2] + u[2]);
  plane->SetPoint2(origin[0] + v[0], origin[1] + v[1], origin[2] + v[2]);
  plane->SetId(id);
  return plane;
}

/// The saddle (x, -y, 0). Backward streamlines reach the plane y = 1 from one side of the
/// separatrix y = 0, and the plane y = -1 from the other side.
Vector Saddle(const Vector& x)
{
  return { { x[0], -x[1], 0.0 } };
}
void AddPlanes(vtkImplicitFlowField* field)
{
  field->AddTerminationSurface(MakePlane({ { -5, 1, -5 } }, { { 10, 0, 0 } }, { { 0, 0, 10 } }, 0));
  field->AddTerminationSurface(
    MakePlane({ { -5, -1, -5 } }, { { 10, 0, 0 } }, { { 0, 0, 10 } }, 1));
}

/// Returns the volume of a cell from tetrahedra between its center and its faces. Exact for convex
/// cells.
double GetVolume(vtkCell* cell)
{
  double center[3] = { 0.0, 0.0, 0.0 };
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    double x[3];
    cell->GetPoints()->GetPoint(i, x);
    for (int axis = 0; axis < 3; ++axis)
    {
      center[axis] += x[axis] / cell->GetNumberOfPoints();
    }
  }
  double sum = 0.0;
  for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
  {
    vtkPoints* points = cell->GetFace(f)->GetPoints();
    const bool isPixel = cell->GetFace(f)->GetCellType() == VTK_PIXEL;
    const int cycle[4] = { 0, 1, isPixel ? 3 : 2, isPixel ? 2 : 3 };
    for (vtkIdType i = 1; i + 1 < points->GetNumberOfPoints(); ++i)
    {
      double x[3][3];
      points->GetPoint(cycle[0], x[0]);
      points->GetPoint(cycle[i], x[1]);
      points->GetPoint(cycle[i + 1], x[2]);
      sum += std::abs(vtkTetra::ComputeVolume(x[0], x[1], x[2], center));
    }
  }
  return sum;
}

/// Checks that cells have positive volumes and match at faces, so each interior face has two cells
/// and each boundary face has one, and that the total volume is \a volume.
void CheckMesh(vtkUnstructuredGrid* mesh, double volume, Check& check)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  std::map<std::vector<vtkIdType>, int> faces;
  std::map<std::vector<vtkIdType>, bool> isOutside;
  double sum = 0.0;
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    vtkCell* cell = mesh->GetCell(id);
    const double own = GetVolume(cell);
    check.That(own > 0.0, "a cell has a positive volume");
    sum += own;
    if (cell->GetCellType() == VTK_TETRA)
    {
      double x[4][3];
      for (int i = 0; i < 4; ++i)
      {
        cell->GetPoints()->GetPoint(i, x[i]);
      }
      check.That(vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]) > 0.0,
        "a tetrahedron is positively oriented");
    }
    for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
    {
      vtkCell* face = cell->GetFace(f);
      std::vector<vtkIdType> key(face->GetPointIds()->begin(), face->GetPointIds()->end());
      std::sort(key.begin(), key.end());
      double range[6];
      face->GetBounds(range);
      bool isAtSide = false;
      for (int side = 0; side < 6; ++side)
      {
        isAtSide = isAtSide ||
          (std::abs(range[side] - bounds[side]) < 1e-9 &&
            std::abs(range[side ^ 1] - bounds[side]) < 1e-9);
      }
      ++faces[key];
      isOutside[key] = isAtSide;
    }
  }
  for (const auto& face : faces)
  {
    check.Equal(face.second, isOutside[face.first] ? 1 : 2, "cells at a face");
  }
  check.Near(sum, volume, 1e-10, "volume");
}

/// Returns grids of every kind over [-1,1]^3 with the velocity of the saddle.
std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> MakeGrids()
{
  std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> grids;
  constexpr int cells = 5;
  const auto scale = [](const Vector& x) {
    return Vector{ { 0.4 * x[0] - 1, 0.4 * x[1] - 1, 0.4 * x[2] - 1 } };
  };
  grids.emplace_back("image", MakeFlowImage({ { 6, 6, 6 } }, { { -1, 1, -1, 1, -1, 1 } }));
  auto rectilinear = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> positions;
  for (const double position : { -1.0, -0.5, -0.1, 0.15, 0.6, 1.0 })
  {
    positions->InsertNextValue(position);
  }
  rectilinear->SetDimensions(6, 6, 6);
  rectilinear->SetXCoordinates(positions);
  rectilinear->SetYCoordinates(positions);
  rectilinear->SetZCoordinates(positions);
  grids.emplace_back("rectilinear", rectilinear);
  auto structured = MakeStructuredGrid({ { cells, cells, cells } });
  MovePoints(structured, scale);
  grids.emplace_back("structured", structured);
  for (const MeshKind kind : FlowMeshKinds())
  {
    auto mesh = MakeFlowMesh(kind, { { cells, cells, cells } });
    MovePoints(mesh, scale);
    grids.emplace_back(GetName(kind), mesh);
  }
  for (auto& grid : grids)
  {
    AddVectors(grid.second, Saddle);
  }
  return grids;
}

void TestGrids(Check& check)
{
  for (const auto& grid : MakeGrids())
  {
    vtkNew<vtkIntArray> numbers;
    numbers->SetName("Number");
    for (vtkIdType id = 0; id < grid.second->GetNumberOfCells(); ++id)
    {
      numbers->InsertNextValue(static_cast<int>(id));
    }
    grid.second->GetCellData()->AddArray(numbers);
    vtkNew<vtkImplicitFlowField> field;
    field->SetInputDataObject(grid.second);
    AddPlanes(field);
    vtkIdType before = grid.second->GetNumberOfPoints();
    const int maximum = grid.first == "image" || grid.first == "tetrahedra6" ? 3 : 2;
    for (int levels = 0; levels <= maximum; ++levels)
    {
      check.SetContext(grid.first + ", levels " + std::to_string(levels));
      field->SetRefinementLevels(levels);
      check.That(UpdateAndGetErrors(field).empty(), "no messages");
      vtkDataSet* output = vtkDataSet::SafeDownCast(field->GetOutputDataObject(0));
      vtkInterlumeReport* report = field->GetReport();
      check.Equal(report->GetSize("AddedSamples"), levels, "levels in the report");
      check.Equal(report->GetCount("Samples"), output->GetNumberOfPoints(), "no duplicate samples");
      auto* mesh = vtkUnstructuredGrid::SafeDownCast(output);
      if (levels == 0)
      {
        check.That(
          std::strcmp(output->GetClassName(), grid.second->GetClassName()) == 0, "the output type");
        continue;
      }
      check.That(report->GetNumber("RefinedCells", levels - 1) > 0, "some cells are refined");
      check.Near(output->GetNumberOfPoints() - before,
        report->GetNumber("AddedSamples", levels - 1), 0.0, "samples");
      before = output->GetNumberOfPoints();
      CheckMesh(mesh, 8.0, check);
      vtkDataArray* vectors = mesh->GetPointData()->GetVectors();
      for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
      {
        double x[3];
        mesh->GetPoint(id, x);
        // All streamlines reach one of the planes, except those on the separatrix.
        const auto status =
          static_cast<int>(mesh->GetPointData()->GetArray("FlowStatus")->GetComponent(id, 0));
        const double time = std::log(1.0 / std::abs(x[1]));
        if (std::abs(x[1]) > 1e-6)
        {
          check.Equal(status, vtkFlowStatus::REACHED_SURFACE, "reached");
          check.Near(mesh->GetPointData()->GetArray("AdvectionTime")->GetComponent(id, 0), time,
            1e-4, "time", 1.0);
        }
        const Vector v = Saddle({ { x[0], x[1], x[2] } });
        for (int i = 0; i < 3; ++i)
        {
          check.Near(vectors->GetComponent(id, i), v[i], 1e-12, "vectors", 1.0);
        }
      }
      vtkDataArray* parents = mesh->GetCellData()->GetArray("Number");
      for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
      {
        double bounds[6];
        double range[6];
        mesh->GetCellBounds(id, range);
        grid.second->GetCellBounds(static_cast<vtkIdType>(parents->GetComponent(id, 0)), bounds);
        for (int side = 0; side < 6; ++side)
        {
          const double over =
            side % 2 == 0 ? bounds[side] - range[side] : range[side] - bounds[side];
          check.That(over <= 1e-12, "a refined cell lies in its parent cell");
        }
      }
    }
  }
}

/// Tests the volume that a flow volume omits at a separatrix. No sample lies on the separatrix at
/// any level.
void TestSeparatrix(Check& check)
{
  constexpr double position = 0.0237;
  vtkNew<vtkImplicitFlowField> field;
  auto image = MakeFlowImage({ { 10, 10, 4 } }, { { -1, 1, -1, 1, -0.3, 0.3 } });
  AddVectors(image, [](const Vector& x) { return Vector{ { x[0], position - x[1], 0.0 } }; });
  field->SetInputData(image);
  AddPlanes(field);
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(field->GetOutputPort());
  volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  double before = 0.0;
  for (int levels = 0; levels <= 4; ++levels)
  {
    check.SetContext("separatrix, level " + std::to_string(levels));
    field->SetRefinementLevels(levels);
    volume->Update();
    vtkDataSet* samples = vtkDataSet::SafeDownCast(field->GetOutputDataObject(0));
    vtkDataArray* ids = samples->GetPointData()->GetArray("TerminationId");
    const double width = 2.0 / 9.0 / (1 << levels);
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < samples->GetNumberOfCells(); ++cell)
    {
      samples->GetCellPoints(cell, corners);
      const double id = ids->GetComponent(corners->GetId(0), 0);
      if (std::any_of(corners->begin(), corners->end(),
            [&](vtkIdType corner) { return ids->GetComponent(corner, 0) != id; }))
      {
        double bounds[6];
        samples->GetCellBounds(cell, bounds);
        check.That(std::max(position - bounds[2], bounds[3] - position) <= width, "within a cell");
      }
    }
    // All samples reach a plane, so the exact volume is the volume of the domain, 2.4.
    const double omitted = 2.4 - MeasureVolume(volume->GetOutput());
    check.That(omitted > 0.0 && omitted <= 1.2 * width + 1e-9, "omitted volume");
    check.That(levels == 0 || omitted < 0.6 * before, "the omitted volume halves per level");
    before = omitted;
  }
}

/// Tests the flow volume of a rotation: the sector of a disk from which streamlines reach the
/// surface within 0.9 rotations.
void TestRotation(Check& check)
{
  check.SetContext("rotation");
  vtkNew<vtkImplicitFlowField> field;
  auto image = MakeFlowImage({ { 12, 12, 2 } }, { { -1.1, 1.1, -1.1, 1.1, 0.0, 0.2 } });
  AddVectors(image, [](const Vector& x) { return Vector{ { -x[1], x[0], 0.0 } }; });
  field->SetInputData(image);
  field->AddTerminationSurface(MakePlane({ { 0, 0, -1 } }, { { 0, 0, 3 } }, { { 3, 0, 0 } }, 0));
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(field->GetOutputPort());
  volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  volume->SetTimeRange(0.0, 0.9 * FullTurn);
  // Streamlines that start inside the disk never leave it.
  const double exact = 0.2 * 0.9 * 0.5 * FullTurn * 1.1 * 1.1;
  double before = 0.0;
  for (int levels = 0; levels <= 4; ++levels)
  {
    field->SetRefinementLevels(levels);
    volume->Update();
    vtkUnstructuredGrid* mesh = volume->GetOutput();
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      double bounds[6];
      mesh->GetCellBounds(cell, bounds);
      const bool isAcross = bounds[2] < -1e-9 && bounds[3] > 1e-9;
      check.That(!(isAcross && bounds[0] > -1e-9), "no cell crosses the surface");
    }
    const double error = std::abs(MeasureVolume(mesh) - exact) / exact;
    check.That(
      levels == 0 || error < 0.65 * before, "the volume converges: " + std::to_string(error));
    before = error;
  }
  check.That(before < 0.03, "the volume is close to the exact volume: " + std::to_string(before));
  check.That(volume->GetReport()->GetNumber("CellsAcrossSurfaces") > 0, "some cells are omitted");
}

vtkSmartPointer<vtkImplicitFlowField> MakeField(int points, int levels)
{
  auto image = MakeFlowImage({ { points, points, points } }, { { -1, 1, -1, 1, -1, 1 } });
  AddVectors(image, Saddle);
  auto field = vtkSmartPointer<vtkImplicitFlowField>::New();
  field->SetInputData(image);
  AddPlanes(field);
  field->SetRefinementLevels(levels);
  return field;
}

void TestThreads(Check& check)
{
  check.SetContext("threads");
  CheckThreads(
    "refined",
    []()
    {
      auto field = MakeField(8, 2);
      field->Update();
      auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
      copy->ShallowCopy(field->GetOutputDataObject(0));
      return std::vector<vtkSmartPointer<vtkUnstructuredGrid>>{ copy };
    },
    check);
}

/// Tests refinement of samples on an image and on an input, refinement in pieces, and turning
/// refinement off again.
void TestSamples(Check& check)
{
  check.SetContext("image of samples");
  auto field = MakeField(4, 1);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  field->SetSampleDimensions(6, 6, 6);
  field->Update();
  CheckMesh(vtkUnstructuredGrid::SafeDownCast(field->GetOutputDataObject(0)), 8.0, check);
  const vtkIdType whole = field->GetReport()->GetNumber("RefinedCells", 0);
  check.Equal(whole, 25, "cells");
  check.SetContext("pieces");
  for (const int mode : { vtkImplicitFlowField::SAMPLES_OF_IMAGE,
         vtkImplicitFlowField::SAMPLES_OF_FIELD, vtkImplicitFlowField::SAMPLES_OF_INPUT })
  {
    field->SetSampleMode(mode);
    // The sample input has four cells of width 1 along each axis.
    vtkNew<vtkRTAnalyticSource> samples;
    samples->SetWholeExtent(-2, 2, -2, 2, -2, 2);
    field->SetSampleConnection(samples->GetOutputPort());
    const double expected = mode == vtkImplicitFlowField::SAMPLES_OF_INPUT ? 64.0 : 8.0;
    double volume = 0.0;
    for (int piece = 0; piece < 3; ++piece)
    {
      field->UpdatePiece(piece, 3, 0);
      auto* mesh = vtkUnstructuredGrid::SafeDownCast(field->GetOutputDataObject(0));
      check.That(mesh->GetNumberOfCells() > 0, "there are cells");
      for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
      {
        volume += GetVolume(mesh->GetCell(cell));
      }
    }
    check.Near(volume, expected, 1e-10, "sum");
  }
  check.SetContext("refinement turned off again");
  // The sample input, which has a different extent, remains connected.
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  field->SetRefinementLevels(0);
  check.That(field->GetExecutive()->Update() != 0, "unused samples have no effect");
  check.That(vtkImageData::SafeDownCast(field->GetOutputDataObject(0)), "an image again");
  field->SetRefinementLevels(7);
  check.Equal(field->GetRefinementLevels(), 6, "clamped");
  CheckPrinted(Print(field), { "RefinementLevels: 6" }, check);
}

/// Tests that an unstructured output has the samples, cells and arrays of the ordinary output, with
/// and without pieces, and that the ordinary type returns. VTK converts the ordinary output.
void TestUnstructuredOutput(Check& check)
{
  for (const auto& grid : MakeGrids())
  {
    check.SetContext("unstructured output of " + grid.first);
    vtkNew<vtkImplicitFlowField> field;
    field->SetInputDataObject(grid.second);
    AddPlanes(field);
    vtkNew<vtkAppendFilter> expected;
    expected->SetInputConnection(field->GetOutputPort());
    expected->SetOutputPointsPrecision(vtkPointSet::SafeDownCast(grid.second)
        ? vtkAlgorithm::DEFAULT_PRECISION
        : vtkAlgorithm::DOUBLE_PRECISION);
    expected->Update();
    vtkNew<vtkUnstructuredGrid> converted;
    converted->ShallowCopy(expected->GetOutput());
    // The filter sorts the arrays by name.
    auto* ordinary = vtkDataSet::SafeDownCast(field->GetOutputDataObject(0));
    converted->GetPointData()->ShallowCopy(ordinary->GetPointData());
    converted->GetCellData()->ShallowCopy(ordinary->GetCellData());
    field->UnstructuredOutputOn();
    field->Update();
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(field->GetOutputDataObject(0));
    check.That(mesh != nullptr, "the type");
    const std::string difference = FindDifference(mesh, converted);
    check.That(difference.empty(), "equal to the output as VTK converts it: " + difference);
    check.That(
      mesh->GetFieldData()->GetAbstractArray("TerminationSurfaces") != nullptr, "surfaces");
    vtkIdType cells = 0;
    for (int piece = 0; piece < 3; ++piece)
    {
      field->UpdatePiece(piece, 3, 0);
      cells += vtkDataSet::SafeDownCast(field->GetOutputDataObject(0))->GetNumberOfCells();
    }
    check.Equal(cells, converted->GetNumberOfCells(), "cells of pieces");
    field->UnstructuredOutputOff();
    field->Update();
    check.That(
      std::strcmp(field->GetOutputDataObject(0)->GetClassName(), grid.second->GetClassName()) == 0,
      "the type is that of the input again");
  }
}

/// Cells of types that cannot be refined are unchanged. Other cells next to them are refined.
void TestOtherCells(Check& check)
{
  for (const MeshKind kind : { MeshKind::Boxes, MeshKind::Honeycomb })
  {
    check.SetContext(GetName(kind));
    auto samples = MakeMesh(kind, { { 3, 3, 1 } });
    MovePoints(samples,
      [](const Vector& x) {
        return Vector{ { 0.3 * x[0] - 0.5, 0.3 * x[1] - 0.5, 0.3 * x[2] } };
      });
    auto field = MakeField(6, 2);
    field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
    field->SetSampleData(samples);
    check.That(UpdateAndGetErrors(field).empty(), "no messages");
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(field->GetOutputDataObject(0));
    check.Equal(mesh->GetNumberOfCells(), samples->GetNumberOfCells(), "cells");
    check.Equal(mesh->GetNumberOfPoints(), samples->GetNumberOfPoints(), "points");
    check.Equal(field->GetReport()->GetCount("RefinedCells", 1), 0, "no cell is refined");
    check.Near(mesh->GetCell(0)->GetNumberOfFaces(), samples->GetCell(0)->GetNumberOfFaces(), 0.0,
      "faces", 1.0);
  }
  check.SetContext("polyhedra next to other cells");
  auto samples = MakeMesh(MeshKind::Mixed, { { 4, 4, 2 } });
  MovePoints(samples,
    [](const Vector& x) {
      return Vector{ { 0.3 * x[0] - 0.5, 0.3 * x[1] - 0.5, 0.3 * x[2] } };
    });
  auto mixed = MakeField(6, 1);
  mixed->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  mixed->SetSampleData(samples);
  mixed->Update();
  auto* output = vtkUnstructuredGrid::SafeDownCast(mixed->GetOutputDataObject(0));
  vtkIdType polyhedra = 0;
  for (vtkUnstructuredGrid* grid : { samples.GetPointer(), output })
  {
    vtkIdType count = 0;
    double volume = 0.0;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      count += grid->GetCellType(cell) == VTK_POLYHEDRON ? 1 : 0;
      volume += GetVolume(grid->GetCell(cell));
    }
    check.That(count > 0 && (grid == samples || count == polyhedra), "polyhedra");
    check.Near(volume, 32.0 * 0.027, 1e-9, "volume");
    polyhedra = count;
  }
  check.That(output->GetNumberOfCells() > samples->GetNumberOfCells(), "other cells are refined");
  check.SetContext("points without cells");
  auto field = MakeField(6, 1);
  auto flat = MakeFlowImage({ { 5, 5, 2 } }, { { -1, 1, -1, 1, 0, 1 } });
  flat->SetDimensions(5, 5, 1);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  for (const int cells : { 16, 0 })
  {
    vtkSmartPointer<vtkDataSet> samples = flat;
    if (cells == 0)
    {
      vtkNew<vtkPolyData> points;
      vtkNew<vtkPoints> positions;
      positions->InsertNextPoint(0.1, 0.2, 0.3);
      points->SetPoints(positions);
      samples = points;
    }
    field->SetSampleData(samples);
    check.That(UpdateAndGetErrors(field).empty(), "no messages");
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(field->GetOutputDataObject(0));
    check.Equal(mesh->GetNumberOfCells(), cells, "cells");
    check.Equal(mesh->GetNumberOfPoints(), samples->GetNumberOfPoints(), "points");
  }
}

/// Hidden cells are not refined. Duplicate cells are refined into duplicate cells.
void TestGhosts(Check& check)
{
  check.SetContext("ghosts");
  auto field = MakeField(6, 1);
  auto samples = MakeFlowImage({ { 6, 6, 6 } }, { { -1, 1, -1, 1, -1, 1 } });
  vtkNew<vtkUnsignedCharArray> cells;
  cells->SetName("vtkGhostType");
  cells->SetNumberOfValues(samples->GetNumberOfCells());
  cells->Fill(0);
  // Two distant cells in the layer that is refined.
  const vtkIdType hidden = 0 + 5 * 2 + 25 * 0;
  const vtkIdType duplicate = 4 + 5 * 2 + 25 * 4;
  cells->SetValue(hidden, vtkDataSetAttributes::HIDDENCELL);
  cells->SetValue(duplicate, vtkDataSetAttributes::DUPLICATECELL);
  samples->GetCellData()->AddArray(cells);
  // Returns whether a position is in the duplicate cell or, for the sign -1, in the hidden cell.
  const auto isIn = [](const double x[3], double sign)
  { return sign * x[0] > 0.6 - 1e-6 && std::abs(x[1]) < 0.2 + 1e-6 && sign * x[2] > 0.6 - 1e-6; };
  vtkNew<vtkUnsignedCharArray> points;
  points->SetName("vtkGhostType");
  for (vtkIdType p = 0; p < samples->GetNumberOfPoints(); ++p)
  {
    points->InsertNextValue(
      isIn(samples->GetPoint(p), 1.0) ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  }
  samples->GetPointData()->AddArray(points);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  field->SetSampleData(samples);
  field->Update();
  check.Equal(field->GetReport()->GetCount("RefinedCells", 0), 24,
    "all cells are refined except the hidden cell");
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(field->GetOutputDataObject(0));
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  vtkIdType counts[2] = { 0, 0 };
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    counts[0] += ghosts->GetValue(cell) == vtkDataSetAttributes::HIDDENCELL ? 1 : 0;
    counts[1] += ghosts->GetValue(cell) == vtkDataSetAttributes::DUPLICATECELL ? 1 : 0;
    double bounds[6];
    mesh->GetCellBounds(cell, bounds);
    const double center[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
      0.5 * (bounds[4] + bounds[5]) };
    check.Equal(ghosts->GetValue(cell),
      isIn(center, -1.0)    ? vtkDataSetAttributes::HIDDENCELL
        : isIn(center, 1.0) ? vtkDataSetAttributes::DUPLICATECELL
                            : 0,
      "ghost flag of a cell");
  }
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    check.Equal(mesh->GetPointGhostArray()->GetValue(p),
      isIn(mesh->GetPoint(p), 1.0) ? vtkDataSetAttributes::DUPLICATEPOINT : 0,
      "ghost flag of a point");
  }
  check.Equal(counts[0], 1, "the hidden cell is not refined");
  // Each of the six faces of the duplicate cell is split into eight triangles, and each triangle
  // belongs to a different new cell.
  check.Equal(counts[1], 48, "cells that replace the duplicate cell");
}

void TestProgress(Check& check)
{
  check.SetContext("progress");
  auto field = MakeField(8, 2);
  ProgressWatch watch;
  ObserveProgress(field, watch);
  field->Update();
  CheckMonotonicProgress(watch, 30, check);
  check.That(watch.Progress.back() > 0.9, "progress reaches the end");
  auto aborted = MakeField(8, 2);
  ProgressWatch second;
  second.AbortAt = 0.5;
  ObserveProgress(aborted, second);
  aborted->Update();
  check.Equal(vtkDataSet::SafeDownCast(aborted->GetOutputDataObject(0))->GetNumberOfPoints(), 0,
    "the output is empty after an abort in a level");
  check.SetContext("errors");
  auto wrong = MakeField(4, 2);
  wrong->RemoveAllTerminationSurfaces();
  check.That(!UpdateAndGetErrors(wrong).empty(), "an error for the missing surface");
  check.Equal(
    vtkDataSet::SafeDownCast(wrong->GetOutputDataObject(0))->GetNumberOfPoints(), 0, "no output");
}

}

int TestFlowRefinement(int, char*[])
{
  Check check;
  TestGrids(check);
  TestSeparatrix(check);
  TestRotation(check);
  TestThreads(check);
  TestSamples(check);
  TestUnstructuredOutput(check);
  TestOtherCells(check);
  TestGhosts(check);
  TestProgress(check);
  return check.Result();
}
