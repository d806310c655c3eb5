// SPDX-License-Identifier: BSD-3-Clause
// Slices of a triangulated region of space-time have no cracks and no overlap at any time. At the
// region's time levels each tetrahedron occurs exactly once, also next to holes and if the cell
// array AtStep selects tetrahedra. Pieces with global ids match.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceBoundary.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace
{

using namespace reference;

std::vector<Tetrahedron> TetrahedraOf(vtkUnstructuredGrid* grid)
{
  std::vector<Tetrahedron> all(grid->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    grid->GetCellPoints(cell, count, ids);
    std::copy_n(ids, 4, all[cell].begin());
  }
  return all;
}

/// Checks that the slice fills the unit cube: every face is shared by two tetrahedra or lies on the
/// cube's boundary, which is covered once.
void CheckFillsCube(vtkUnstructuredGrid* slice, Check& check)
{
  const TetrahedraVolume volume = MeasureTetrahedra(slice);
  check.Near(static_cast<double>(volume.Sum), 1.0, 1e-13, "volume");
  check.Equal(volume.Inverted, 0, "inverted tetrahedra");
  check.That(IsValid(slice, VTK_TETRA), "the output consists of tetrahedra");
  const DomainBoundary boundary(MakeMesh(MeshKind::Hexahedra, { { 1, 1, 1 } }));
  std::vector<double> covered(boundary.GetNumberOfFaces(), 0.0);
  long long cracks = 0;
  std::set<vtkIdType> used;
  for (const FaceUse& face : CountUses(FacesOf(TetrahedraOf(slice))))
  {
    used.insert(face.Key.begin(), face.Key.end());
    check.That(face.Plus <= 1 && face.Minus <= 1, "a face is used at most once from each side");
    if (face.Net() == 0)
    {
      continue;
    }
    Triangle triangle = face.Key;
    if (face.Net() < 0)
    {
      std::swap(triangle[1], triangle[2]);
    }
    std::vector<DomainBoundary::Point> points(3);
    for (int v = 0; v < 3; ++v)
    {
      slice->GetPoint(triangle[v], points[v].data());
    }
    const int side = boundary.Find(points);
    cracks += side < 0;
    if (side >= 0)
    {
      covered[side] += boundary.SignedArea(side, points);
    }
  }
  check.Equal(cracks, 0, "interior faces that do not match");
  for (const double area : covered)
  {
    check.Near(area, 1.0, 1e-12, "area of a side of the cube");
  }
  check.Equal(static_cast<long long>(used.size()), slice->GetNumberOfPoints(), "points in use");
}

void CheckRegion(const KuhnOptions& options, const std::vector<double>& times, Check& check)
{
  auto grid = MakeKuhnGrid(options);
  for (const double t : times)
  {
    check.SetContext("moved " + std::to_string(options.MovedInSpace) + ", " +
      std::to_string(options.MovedInTime) + ", t = " + std::to_string(t));
    CheckFillsCube(SliceAt(grid, t), check);
  }
}

/// Returns the faces of 4-simplices at time \a t, without duplicates, as positively oriented
/// tetrahedra.
vtkSmartPointer<vtkUnstructuredGrid> FacesAt(vtkUnstructuredGrid* grid, double t)
{
  std::set<Tetrahedron> faces;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const SimplexIds ids = GetSimplexIds(grid, cell);
    const SimplexEvents events = GetSimplexEvents(grid, cell);
    Tetrahedron face;
    size_t number = 0;
    for (size_t v = 0; v < ids.size(); ++v)
    {
      if (events[v][3] == t)
      {
        face[number++] = ids[v];
      }
    }
    if (number == face.size())
    {
      std::sort(face.begin(), face.end());
      faces.insert(face);
    }
  }
  auto expected = vtkSmartPointer<vtkUnstructuredGrid>::New();
  expected->SetPoints(grid->GetPoints());
  vtkNew<vtkCellArray> cells;
  for (Tetrahedron face : faces)
  {
    std::array<std::array<long double, 3>, 4> x;
    for (int v = 0; v < 4; ++v)
    {
      double point[3];
      grid->GetPoint(face[v], point);
      std::copy_n(point, 3, x[v].begin());
    }
    if (Determinant(x[0], x[1], x[2], x[3]) < 0)
    {
      std::swap(face[0], face[1]);
    }
    cells->InsertNextCell(4, face.data());
  }
  expected->SetCells(VTK_TETRA, cells);
  return expected;
}

/// At the time of a step, the slice contains each face at this time once, even if some simplices
/// are missing.
void CheckHoles(unsigned int seed, double fraction, Check& check)
{
  std::mt19937 random(seed);
  std::bernoulli_distribution isRetained(fraction);
  KuhnOptions options;
  options.Cells = { { 3, 4, 3, 3 } };
  options.MovedInSpace = 0.15;
  options.Seed = seed;
  options.IsRetained = [&](const std::array<int, 4>&) { return isRetained(random); };
  auto grid = MakeKuhnGrid(options);
  for (const double t : { 0.0, 1.0, 2.0, 3.0 })
  {
    check.SetContext("holes " + std::to_string(seed) + ", t = " + std::to_string(t));
    auto expected = FacesAt(grid, t);
    check.That(expected->GetNumberOfCells() > 0, "there are faces");
    check.That(GeometricSet(SliceAt(grid, t)) == GeometricSet(expected),
      "the slice consists of the faces at the level without duplicates");
  }
}

/// Returns every \a pieces-th simplex of a grid, starting at \a number. Points are renumbered
/// randomly. Their global ids are the ids in the full grid.
vtkSmartPointer<vtkUnstructuredGrid> MakePiece(
  vtkUnstructuredGrid* grid, int number, int pieces, std::mt19937& random)
{
  const vtkIdType points = grid->GetNumberOfPoints();
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName("global");
  globalIds->SetNumberOfValues(points);
  std::vector<vtkIdType> newIds(points);
  std::iota(newIds.begin(), newIds.end(), 0);
  std::shuffle(newIds.begin(), newIds.end(), random);
  std::vector<Event> events(points);
  vtkDataArray* times = grid->GetPointData()->GetArray("Time");
  for (vtkIdType point = 0; point < points; ++point)
  {
    Event& event = events[newIds[point]];
    grid->GetPoint(point, event.data());
    event[3] = times->GetComponent(point, 0);
    globalIds->SetValue(newIds[point], point);
  }
  std::vector<SimplexIds> simplices;
  for (vtkIdType cell = number; cell < grid->GetNumberOfCells(); cell += pieces)
  {
    SimplexIds ids = GetSimplexIds(grid, cell);
    std::transform(ids.begin(), ids.end(), ids.begin(), [&](vtkIdType id) { return newIds[id]; });
    simplices.push_back(ids);
  }
  auto piece = MakeSimplexGrid(events, simplices);
  piece->GetPointData()->SetGlobalIds(globalIds);
  return piece;
}

/// Adds all tetrahedra at the time of a step as cells. The array AtStep enables only some of the
/// faces at that time, each of which duplicates one of these tetrahedra.
void CheckAtStep(Check& check)
{
  using Filter = vtkTimeVaryingIntervalVolume;
  KuhnOptions options;
  options.MovedInSpace = 0.15;
  auto grid = MakeKuhnGrid(options);
  const double level = 1.0;
  auto faces = FacesAt(grid, level);
  const auto before = GeometricSet(SliceAt(grid, 1.4));
  vtkNew<vtkUnsignedCharArray> atStep;
  atStep->SetName("AtStep");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    atStep->InsertNextValue(cell % 3 == 0 ? Filter::FACES_AT_STEP : Filter::NOTHING_AT_STEP);
  }
  check.SetContext("AtStep");
  grid->GetCellData()->AddArray(atStep);
  const auto slice = SliceAt(grid, level);
  const vtkIdType some = slice->GetNumberOfCells();
  check.That(0 < some && some < faces->GetNumberOfCells(), "the slice contains some faces");
  check.That(!slice->GetCellData()->HasArray("AtStep"), "a slice has no AtStep");
  for (const Tetrahedron& face : TetrahedraOf(faces))
  {
    const SimplexIds ids = { { face[0], face[1], face[2], face[3], face[3] } };
    grid->InsertNextCell(VTK_POLY_VERTEX, 5, ids.data());
    atStep->InsertNextValue(Filter::TETRAHEDRON_AT_STEP);
  }
  check.That(GeometricSet(SliceAt(grid, level)) == GeometricSet(faces),
    "the slice at the level consists of the tetrahedra without duplicates");
  check.That(GeometricSet(SliceAt(grid, 1.4)) == before, "the slice at another time is unchanged");
  grid->GetCellData()->RemoveArray("AtStep");
  check.That(GeometricSet(SliceAt(grid, level)) == GeometricSet(faces),
    "without the array, all faces are used and degenerate cells are ignored");
}

void CheckPieces(Check& check)
{
  KuhnOptions options;
  options.MovedInSpace = 0.15;
  options.MovedInTime = 0.15;
  auto grid = MakeKuhnGrid(options);
  std::mt19937 random(3);
  const double t = 1.4;
  std::vector<GeometricSimplex> together;
  for (int number = 0; number < 3; ++number)
  {
    const auto part = GeometricSet(SliceAt(MakePiece(grid, number, 3, random), t));
    together.insert(together.end(), part.begin(), part.end());
  }
  std::sort(together.begin(), together.end());
  check.SetContext("pieces");
  check.That(
    together == GeometricSet(SliceAt(grid, t)), "the pieces yield the tetrahedra of the full grid");
}

}

int TestSimplexTimeSliceTiling(int, char*[])
{
  Check check;
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    KuhnOptions options;
    options.Seed = seed;
    CheckRegion(options, { 0.0, 0.3, 1.0, 1.5, 2.0, 2.999, 3.0 }, check);
    options.MovedInSpace = 0.15;
    CheckRegion(options, { 0.0, 0.3, 1.0, 1.5, 2.0, 2.999, 3.0 }, check);
    options.MovedInTime = 0.15;
    CheckRegion(options, { 0.0, 0.1, 0.9, 1.0, 1.07, 1.5, 2.2, 3.0 }, check);
    options.HasEqualTimes = true;
    CheckRegion(options, { 0.0, 0.875, 1.0, 1.125, 1.5, 1.875, 2.0, 3.0 }, check);
    CheckHoles(seed, 0.7, check);
    CheckHoles(seed, 0.3, check);
  }
  CheckAtStep(check);
  CheckPieces(check);
  return check.Result();
}
