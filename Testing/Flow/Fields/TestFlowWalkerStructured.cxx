// SPDX-License-Identifier: BSD-3-Clause
// The walker of structured grids, compared with VTK's hexahedra, finite differences, linear fields
// and straight lines. Also tests seams, blanking, collapsed and folded cells, and threads.
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Flow/ReferenceWalker.h"

#include "Fields/FieldDispatch.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

namespace
{

using namespace reference;

const std::array<int, 3> Cells = { { 5, 4, 6 } };

vtkSmartPointer<vtkStructuredGrid> MakeCurved(double bend, const VectorField& position)
{
  auto grid = MakeStructuredGrid(Cells);
  MovePoints(grid, MakeDisplacement(Cells, bend));
  MovePoints(grid, position);
  return grid;
}

// \a isBox is true if the grid fills its bounds.
void CheckGrid(const std::string& name, vtkStructuredGrid* grid, double unit, double tolerance,
  bool isBox, Check& check)
{
  check.SetContext(name);
  auto vectors = AddRandomVectors(grid, 3);
  CallWithWalker(grid, vectors, check,
    [&](const auto& walker)
    {
      CheckLocations(walker, grid, vectors, 4, tolerance, check, unit >= 1.0);
      CheckDerivatives(walker, grid, vectors, 1e-6, check);
      CheckPoints(walker, grid, check);
      if (isBox)
      {
        CheckLines(walker, grid, 20, unit, check);
      }
    });
  CheckLinearField(grid, unit, tolerance, check);
}

void CheckGrids(Check& check)
{
  const VectorField same = [](const Vector& x) { return x; };
  CheckGrid("boxes", MakeCurved(0.0, same), 1.0, 1e-12, true, check);
  CheckGrid("curved", MakeCurved(0.35, same), 1.0, 1e-11, true, check);
  CheckGrid("slightly curved", MakeCurved(1e-4, same), 1.0, 1e-11, true, check);
  CheckGrid("left-handed",
    MakeCurved(0.35,
      [](const Vector& x) {
        return Vector{ { -x[0], x[1], x[2] } };
      }),
    1.0, 1e-11, true, check);
  CheckGrid("sheared",
    MakeCurved(0.2,
      [](const Vector& x) {
        return Vector{ { x[0] + 3.0 * x[1], x[1], x[2] - 2.0 * x[0] } };
      }),
    1.0, 1e-10, false, check);
  for (const double unit : { 1e-9, 1e9 })
  {
    CheckGrid("curved of " + std::to_string(unit),
      MakeCurved(0.35,
        [unit](const Vector& x) {
          return Vector{ { unit * (x[0] - 2.0), unit * x[1], unit * x[2] } };
        }),
      unit, 1e-11, true, check);
    CheckGrid("planar of " + std::to_string(unit),
      MakeCurved(0.35,
        [unit](const Vector& x) {
          return Vector{ { unit * x[0], 1e-4 * unit * x[1], unit * x[2] } };
        }),
      unit, 1e-10, true, check);
  }
}

void CheckCorners(Check& check)
{
  auto grid = MakeStructuredGrid({ { 4, 4, 4 } });
  CheckCornerLines("", grid, check);
  CallWithWalker(grid, grid->GetPointData()->GetVectors(), check,
    [&](const auto& walker) {
      CheckLine(walker, grid, { { 2, 2, 2 } }, { { -1, -1, 1 } }, 1.0, check);
    });
}

// Walks once around a closed ring, across the seam.
void CheckSeam(Check& check)
{
  check.SetContext("seam");
  const std::array<int, 3> cells = { { 3, 16, 4 } };
  auto ring = MakeRing(cells);
  auto vectors = AddVectors(ring, [](const Vector& x) { return Vector{ { -x[1], x[0], 0.1 } }; });
  CallWithWalker(ring, vectors, check,
    [&](auto walker)
    {
      CheckLocations(walker, ring, vectors, 3, 1e-12, check);
      for (const int around : { 3, 2 })
      {
        const Vector start = { { 1.4, 0.1, 1.3 } };
        Vector p;
        check.That(walker.Locate(start.data(), p.data()), "the start is found");
        const vtkIdType first = walker.GetCell();
        for (int step = 0; step < cells[1]; ++step)
        {
          check.Equal(walker.GetDomainFace(around), -1, "no domain face around the ring");
          p[1] = around == 3 ? 1.0 : 0.0;
          const Vector before = PositionOf(walker, p);
          check.That(walker.Cross(around, p.data()), "the next cell around");
          check.Near(
            GetNorm(PositionOf(walker, p) - before), 0.0, 1e-15, "the position is unchanged", 1.0);
        }
        check.Equal(walker.GetCell(), first, "after one rotation");
        check.That(
          !walker.Cross(4, p.data()) || walker.GetDomainFace(5) == -1, "domain faces along z");
      }
      // The inner side is a polygon. The points are in the bounding box of a cell, on both sides
      // of the cell's inner face.
      const double midpoint = 3.14159265358979324 / cells[1];
      for (const double beside : { -1e-4, -1e-9, 1e-9 })
      {
        const double radius = std::cos(midpoint) + beside;
        const double x[3] = { radius * std::cos(midpoint), radius * std::sin(midpoint), 0.5 };
        Vector there;
        check.Equal(walker.Locate(x, there.data()), beside > 0.0,
          "the point is inside or outside as expected");
      }
      const double inner[3] = { 1.0, 0.02, 0.5 };
      Vector p;
      check.That(walker.Locate(inner, p.data()), "a point at the inner side");
      check.Equal(walker.GetDomainFace(0), 0, "the inner side");
      check.Equal(walker.GetDomainFace(4), 4, "the lower side");
      check.Equal(walker.GetDomainFace(5), -1, "an inner face");
      double uv[2];
      walker.GetDomainParameters(0, p.data(), uv);
      check.Near(uv[1], 0.125, 1e-12, "v of -i is along k");
    });
}

// The branch cut of a C-grid in parabolic coordinates, where the side j = 0 folds back on itself.
void CheckCut(Check& check)
{
  check.SetContext("cut");
  const std::array<int, 3> cells = { { 6, 3, 2 } };
  auto grid = MakeStructuredGrid(cells);
  MovePoints(grid,
    [](const Vector& index)
    {
      const double s = index[0] - 3.0;
      return Vector{ { s * s - index[1] * index[1], 2.0 * s * index[1], index[2] } };
    });
  auto vectors = AddRandomVectors(grid, 3);
  CallWithWalker(grid, vectors, check,
    [&](auto walker)
    {
      const double start[3] = { 2.3, 0.4, 0.7 };
      Vector p;
      check.That(walker.Locate(start, p.data()), "the start is found");
      check.Equal(walker.GetCell(), 4, "before the cut");
      check.Equal(walker.GetDomainFace(2), -1, "the cut is not a domain face");
      p[1] = 0.0;
      const Vector before = PositionOf(walker, p);
      check.That(walker.Cross(2, p.data()), "the cut is crossed");
      check.Equal(walker.GetCell(), 1, "after the cut");
      check.Near(p[1], 0.0, 0.0, "on the cut", 1.0);
      check.Near(
        GetNorm(PositionOf(walker, p) - before), 0.0, 1e-15, "the position is unchanged", 1.0);
      check.That(walker.Cross(2, p.data()) && walker.GetCell() == 4, "back across the cut");
      check.Near(
        GetNorm(PositionOf(walker, p) - before), 0.0, 1e-15, "the position is unchanged", 1.0);
    });
}

void CheckBlanking(Check& check)
{
  check.SetContext("blanking");
  auto grid = MakeStructuredGrid({ { 4, 3, 3 } });
  auto vectors = AddRandomVectors(grid, 5);
  grid->AllocateCellGhostArray();
  HideLayer(grid->GetCellGhostArray());
  CallWithWalker(
    grid, vectors, check, [&](const auto& walker) { CheckHiddenLayer(walker, check); });
}

// A wedge of revolution. The faces of cells at i = 0 collapse to lines on the axis.
void CheckCollapsed(Check& check)
{
  check.SetContext("collapsed");
  auto grid = MakeStructuredGrid({ { 3, 5, 3 } });
  MovePoints(grid,
    [](const Vector& index)
    {
      const double angle = 0.25 * index[1];
      return Vector{ { index[0] * std::cos(angle), index[0] * std::sin(angle), index[2] } };
    });
  auto vectors = AddVectors(grid, [](const Vector&) { return Vector{ { 0.0, 0.0, 2.0 } }; });
  CallWithWalker(grid, vectors, check,
    [&](auto walker)
    {
      CheckLocations(walker, grid, vectors, 3, 1e-10, check, false);
      const double axis[3] = { 0.0, 0.0, 1.5 };
      Vector p;
      Vector rate;
      check.That(walker.Locate(axis, p.data()), "the axis is found");
      walker.GetVelocity(p.data(), rate.data());
      check.Near(rate[0], 0.0, 1e-12, "no velocity outward", 1.0);
      check.Near(rate[1], 0.0, 1e-12, "no velocity around the axis", 1.0);
      check.Near(rate[2], 2.0, 1e-12, "velocity along the axis");
      std::array<double, 9> jacobian;
      walker.GetJacobian(p.data(), jacobian.data());
      check.That(std::isfinite(GetLargest(jacobian)), "the Jacobian is finite");
    });
}

// A corner with an angle of 180 degrees: two columns of the Jacobian dx/dp are parallel except for
// rounding errors.
void CheckStraightCorner(Check& check)
{
  check.SetContext("straight corner");
  const Vector along = { { 0.48, 0.64, 0.6 } };
  const Vector across = { { -0.8, 0.6, 0.0 } };
  const Vector up = { { 0.1, 0.3, 1.7 } };
  auto grid = MakeStructuredGrid({ { 1, 1, 1 } });
  MovePoints(grid,
    [&](const Vector& index)
    {
      const double part = (index[0] - 0.6 * index[1]) / 0.7;
      const double away = index[0] * index[1];
      Vector x{};
      for (int i = 0; i < 3; ++i)
      {
        x[i] = 0.37 + part * along[i] + away * across[i] + index[2] * up[i];
      }
      return x;
    });
  const Vector expected = { { up[0] + along[0], up[1] + along[1], up[2] + along[2] } };
  auto vectors = AddVectors(grid, [&](const Vector&) { return expected; });
  Random random(43);
  CallWithWalker(grid, vectors, check,
    [&](auto walker)
    {
      CheckLocations(walker, grid, vectors, 20, 1e-10, check, false);
      const Vector inside = SampleCell(grid, vectors, 0, random).Position;
      Vector p;
      check.That(walker.Locate(inside.data(), p.data()), "the cell is found");
      p = { { 0.0, 0.0, 0.25 } };
      Vector rate;
      walker.GetVelocity(p.data(), rate.data());
      check.Near(GetNorm(VelocityOf(walker, p) - expected), 0.0, 1e-12,
        "the velocity along the other columns", 1.0);
      check.Near(rate[0] - 0.6 * rate[1], 0.7, 1e-12, "one of the two columns is used");
      check.Near(rate[0] * rate[1], 0.0, 1e-12, "the other rate is 0", 1.0);
      check.Near(rate[2], 1.0, 1e-12, "upward");
    });
}

// Returns whether the determinant of dx/dp in the walker's cell is positive at 125 positions.
template <typename Walker>
bool IsPositive(const Walker& walker)
{
  for (int position = 0; position < 125; ++position)
  {
    const double p[3] = { 0.25 * (position % 5), 0.25 * (position / 5 % 5),
      0.25 * (position / 25 % 5) };
    double w[3][3];
    for (int j = 0; j < 3; ++j)
    {
      const double along[3] = { j == 0 ? 1.0 : 0.0, j == 1 ? 1.0 : 0.0, j == 2 ? 1.0 : 0.0 };
      walker.GetWorldVector(p, along, w[j]);
    }
    const double volume = w[0][0] * (w[1][1] * w[2][2] - w[1][2] * w[2][1]) +
      w[0][1] * (w[1][2] * w[2][0] - w[1][0] * w[2][2]) +
      w[0][2] * (w[1][0] * w[2][1] - w[1][1] * w[2][0]);
    if (volume <= 0.0)
    {
      return false;
    }
  }
  return true;
}

// Strongly distorted cells, in which Newton's method, started at the center, does not find all
// positions.
void CheckDistorted(Check& check)
{
  check.SetContext("distorted");
  int cells = 0;
  for (unsigned int seed = 1; seed < 3000; ++seed)
  {
    auto grid = MakeStructuredGrid({ { 1, 1, 1 } });
    Random random(seed);
    MovePoints(grid,
      [&](const Vector& x)
      {
        const Vector d = random.GetPoint(0.7);
        return Vector{ { x[0] + d[0], x[1] + d[1], x[2] + d[2] } };
      });
    auto vectors = AddRandomVectors(grid, seed);
    CallWithWalker(grid, vectors, check,
      [&](auto walker)
      {
        Vector p;
        CellSample sample = SampleCell(grid, vectors, 0, random);
        if (!walker.Locate(sample.Position.data(), p.data()) || !IsPositive(walker))
        {
          return;
        }
        ++cells;
        for (int i = 0; i < 20; ++i)
        {
          sample = SampleCell(grid, vectors, 0, random);
          check.That(walker.Locate(sample.Position.data(), p.data()), "the position is found");
          check.Near(GetNorm(VelocityOf(walker, p) - sample.Velocity), 0.0, 1e-9,
            "velocity at the position", 1.0);
        }
      });
  }
  check.That(cells > 100, "the field has such cells");
}

// A cell inverted by a moved point, and cells with a collapsed edge: located positions are correct,
// and velocities are finite.
void CheckFolded(Check& check)
{
  check.SetContext("folded");
  auto grid = MakeStructuredGrid({ { 4, 3, 3 } });
  auto vectors = AddRandomVectors(grid, 9);
  grid->GetPoints()->SetPoint(1 + 5 * (1 + 4), 3.4, 1.2, 1.1);
  grid->GetPoints()->SetPoint(3 + 5 * (2 + 4 * 2), 2.0, 2.0, 2.0);
  Random random(23);
  CallWithWalker(grid, vectors, check,
    [&](auto walker)
    {
      for (int i = 0; i < 2000; ++i)
      {
        Vector x = { { random.Get(0.0, 4.0), random.Get(0.0, 3.0), random.Get(0.0, 3.0) } };
        Vector p;
        if (walker.Locate(x.data(), p.data()))
        {
          check.Near(GetNorm(PositionOf(walker, p) - x), 0.0, 1e-10, "position", 1.0);
          Vector rate;
          walker.GetVelocity(p.data(), rate.data());
          check.That(std::isfinite(GetNorm(rate)), "the velocity is finite");
        }
      }
    });
}

void CheckErrors(Check& check)
{
  check.SetContext("errors");
  auto grid = MakeStructuredGrid({ { 3, 3, 3 } });
  auto vectors = AddRandomVectors(grid, 1);
  const auto find = [&]
  { return interlume::FieldDispatch::Execute(grid, vectors, {}, [](const auto&) {}).GetMessage(); };
  grid->GetPoints()->SetPoint(63, 0.0, std::nan(""), 0.0);
  check.That(find() == "point 63 is not finite", find());
  grid->GetPoints()->SetNumberOfPoints(60);
  check.That(find() == "the grid has 60 points; its dimensions require 64", find());
  grid->SetDimensions(4, 1, 4);
  check.That(find().find("the field has no three-dimensional cells. ") == 0, find());
}

// Returns the cell, cell coordinates and velocity at each point. The field is built and read in
// parallel.
std::vector<double> FindAll(vtkDataSet* data, vtkDataArray* vectors, Check& check)
{
  std::vector<double> all(7 * data->GetNumberOfPoints());
  CallWithWalker(data, vectors, check,
    [&](const auto& prototype)
    {
      vtkSMPTools::For(0, data->GetNumberOfPoints(), 7,
        [&](vtkIdType first, vtkIdType last)
        {
          auto walker = prototype;
          for (vtkIdType point = first; point < last; ++point)
          {
            double x[3];
            data->GetPoint(point, x);
            double* to = &all[7 * point];
            to[0] = walker.Locate(x, to + 1) ? static_cast<double>(walker.GetCell()) : -1.0;
            walker.GetVelocity(to + 1, to + 4);
          }
        });
    });
  return all;
}

void CheckThreads(Check& check)
{
  auto grid = MakeCurved(0.35, [](const Vector& x) { return x; });
  auto vectors = AddRandomVectors(grid, 3);
  CheckSame(
    "cells, positions and velocities", [&]() { return FindAll(grid, vectors, check); }, check);
}

}

int TestFlowWalkerStructured(int, char*[])
{
  return RunChecks({ CheckGrids, CheckCorners, CheckSeam, CheckCut, CheckBlanking, CheckCollapsed,
    CheckStraightCorner, CheckDistorted, CheckFolded, CheckErrors, CheckThreads });
}
