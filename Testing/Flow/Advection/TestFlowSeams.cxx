// SPDX-License-Identifier: BSD-3-Clause
// Seams whose points match except for rounding errors or a small gap: grids that close on
// themselves and rings of blocks, compared with a known spiral. The report counts joined faces and
// faces that do not match an adjacent cell.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Flow/ReferenceSkin.h"

#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationMesh.h"

#include "vtkAppendFilter.h"
#include "vtkDataArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using namespace reference;

constexpr double Pi = 3.14159265358979324;
/// Number of cells in the radial, angular and axial direction. Cells are 0.25 wide radially and
/// axially, and at least 0.26 wide around the axis.
constexpr int Outward = 4;
constexpr int Around = 24;
constexpr int Along = 3;
constexpr double Growth = 0.1;

/// Flow around the z axis and outward. Cells interpolate it exactly.
Vector Spiral(const Vector& x)
{
  return { { Growth * x[0] - x[1], x[0] + Growth * x[1], 0.0 } };
}

/// Computes the time at which a streamline leaves the polygon with corners at radius 2.
double Trace(const Vector& start)
{
  const double inner = 2.0 * std::cos(Pi / Around);
  const double radius = std::hypot(start[0], start[1]);
  const double angle = std::atan2(start[1], start[0]);
  const auto room = [&](double time)
  {
    const double part = (angle + time) * Around / (2.0 * Pi);
    const double beside = (part - std::floor(part) - 0.5) * 2.0 * Pi / Around;
    return inner - radius * std::exp(Growth * time) * std::cos(beside);
  };
  double from = std::max(0.0, std::log(inner / radius) / Growth);
  double to = from;
  while (room(to) > 0.0)
  {
    from = to;
    to += 0.002;
  }
  for (int i = 0; i < 60; ++i)
  {
    const double midpoint = 0.5 * (from + to);
    (room(midpoint) > 0.0 ? from : to) = midpoint;
  }
  return from;
}

/// Returns part of a ring: cells \a first to \a last - 1 around the axis. The points at its end are
/// moved around the axis by the distance \a gap. In a full ring, their angle is computed as 2 pi,
/// as in user code.
vtkSmartPointer<vtkStructuredGrid> MakePart(int first, int last, double gap = 0.0)
{
  auto part = MakeStructuredGrid({ { Outward, last - first, Along } });
  const double begin = first * (2.0 * Pi / Around);
  MovePoints(part,
    [=](const Vector& x)
    {
      const double radius = 1.0 + x[0] / Outward;
      const double end = x[1] == last - first ? gap / radius : 0.0;
      const double angle = begin + x[1] * 2.0 * Pi / Around + end;
      return Vector{ { radius * std::cos(angle), radius * std::sin(angle), 0.25 * x[2] } };
    });
  AddVectors(part, Spiral);
  return part;
}

vtkSmartPointer<vtkPolyData> MakeSamples(int number)
{
  Random random(5);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < number; ++i)
  {
    const double radius = random.Get(1.01, 1.95);
    const double angle = random.Get(0.01, 2.0 * Pi - 0.01);
    points->InsertNextPoint(
      radius * std::cos(angle), radius * std::sin(angle), random.Get(0.01, 0.74));
  }
  auto samples = vtkSmartPointer<vtkPolyData>::New();
  samples->SetPoints(points);
  return samples;
}

/// Returns a filter that traces \a number streamlines to a mesh of the ring's outer boundary.
vtkSmartPointer<vtkImplicitFlowField> MakeFilter(vtkDataObject* field, int number)
{
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  vtkNew<vtkTerminationMesh> outside;
  outside->SetMesh(MakeSkin(MakePart(0, Around),
    [](const Vector& midpoint) { return std::hypot(midpoint[0], midpoint[1]) > 1.95; }));
  filter->AddTerminationSurface(outside);
  filter->SetInputDataObject(field);
  filter->SetSampleData(MakeSamples(number));
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  filter->SetDirectionToForward();
  return filter;
}

/// Checks that streamlines cross all seams and reach the outer boundary at the known times. \a gap
/// is the distance between the points of a seam. \a minimum and \a maximum bound the number of
/// faces joined within the tolerance.
void CheckClosed(const std::string& name, vtkDataObject* field, int number, double gap, int minimum,
  int maximum, Check& check)
{
  check.SetContext(name);
  auto filter = MakeFilter(field, number);
  const std::string warnings = WarningsOf(filter);
  check.That(warnings.empty(), "no warning: " + warnings);
  vtkInterlumeReport* report = filter->GetReport();
  check.Equal(report->GetCount("Statuses", vtkFlowStatus::REACHED_SURFACE), number,
    "samples that reach the outer boundary");
  const double joined = report->GetNumber("ToleranceMatchedFaces");
  check.That(joined >= minimum && joined <= maximum,
    "faces joined within the tolerance: " + std::to_string(joined));
  const double largest = report->GetNumber("LargestFaceGap");
  check.That(
    largest <= 5.0 * gap + 1e-14 && largest >= 3.0 * gap, "gap of " + std::to_string(largest));
  check.Equal(report->GetCount("NonconformingFaces"), 0, "faces that do not match");
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  double latest = 0.0;
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    Vector x;
    output->GetPoint(id, x.data());
    latest = std::max(latest,
      std::abs(output->GetPointData()->GetArray("AdvectionTime")->GetComponent(id, 0) - Trace(x)));
  }
  check.That(latest < 1e-4 + 20.0 * gap, "maximum time error " + std::to_string(latest));
  check.SetContext("");
}

vtkSmartPointer<vtkStructuredGrid> WithFloats(vtkStructuredGrid* grid)
{
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  floats->DeepCopy(grid->GetPoints());
  auto copy = vtkSmartPointer<vtkStructuredGrid>::New();
  copy->ShallowCopy(grid);
  copy->SetPoints(floats);
  return copy;
}

vtkSmartPointer<vtkUnstructuredGrid> WithoutOrder(vtkDataSet* grid)
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(grid);
  append->Update();
  return append->GetOutput();
}

void TestClosed(Check& check)
{
  const int seam = Outward * Along;
  auto ring = MakePart(0, Around);
  check.That(ring->GetPoint((Outward + 1) * Around)[1] != 0.0,
    "the last angle differs from the first by a rounding error");
  CheckClosed("ring", ring, 10000, 0.0, seam, seam, check);
  CheckClosed("mesh of a ring", WithoutOrder(ring), 1000, 0.0, seam, seam, check);
  CheckClosed("ring in single precision", WithFloats(MakePart(0, Around, 1e-6)), 1000, 1e-6, seam,
    seam, check);
  CheckClosed("ring with a gap", MakePart(0, Around, -1e-4), 1000, 1e-4, seam, seam, check);
  CheckClosed(
    "ring with displaced points", MakePart(0, Around, 1e-6), 1000, 1e-6, seam, seam, check);
  auto closed = MakeRing({ { Outward, Around, Along } });
  MovePoints(closed, [](const Vector& x) { return Vector{ { x[0], x[1], 0.25 * x[2] } }; });
  AddVectors(closed, Spiral);
  CheckClosed("a closed ring", closed, 100, 0.0, 0, 0, check);
}

vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(const std::vector<vtkStructuredGrid*>& parts)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (vtkStructuredGrid* part : parts)
  {
    blocks->SetBlock(blocks->GetNumberOfBlocks(), part);
  }
  return blocks;
}

void TestBlocks(Check& check)
{
  auto first = MakePart(0, 7);
  auto second = MakePart(7, 16);
  auto third = MakePart(16, Around);
  // Despite rounding errors, some faces between blocks are identical. The faces at the angles 0 and
  // 2 pi are not.
  const int seam = Outward * Along;
  CheckClosed("blocks", MakeBlocks({ first, second, third }), 10000, 0.0, seam, 3 * seam, check);
  CheckClosed("blocks with a gap", MakeBlocks({ MakePart(0, 7, 1e-5), second, third }), 1000, 1e-5,
    2 * seam, 3 * seam, check);
}

/// Tests faces that do not match: streamlines end there, and a warning contains the number of these
/// faces.
void TestOpen(Check& check)
{
  auto coarse = MakeStructuredGrid({ { Outward, 8, 1 } });
  MovePoints(coarse,
    [](const Vector& x)
    {
      const double radius = 1.0 + x[0] / Outward;
      const double angle = (16.0 + x[1]) * 2.0 * Pi / Around;
      return Vector{ { radius * std::cos(angle), radius * std::sin(angle), 0.75 * x[2] } };
    });
  AddVectors(coarse, Spiral);
  auto first = MakePart(0, 16);
  auto filter = MakeFilter(MakeBlocks({ first, coarse }), 500);
  const std::string warnings = WarningsOf(filter);
  // All faces at both interfaces are open. The coarse side has a third as many faces as the fine
  // side.
  check.That(warnings.find("at 32 cell faces") != std::string::npos, "a warning: " + warnings);
  check.Equal(filter->GetReport()->GetCount("NonconformingFaces"), 2 * (Outward * Along + Outward),
    "number of open faces");
  check.That(filter->GetReport()->GetNumber("Statuses", vtkFlowStatus::LEFT_DOMAIN) > 100,
    "some streamlines end there");
  // Cells at an axis have collapsed faces, which cause no warning.
  auto wedges = MakePart(0, Around);
  MovePoints(wedges,
    [](const Vector& x)
    {
      const double radius = std::hypot(x[0], x[1]);
      const double scale = radius < 1.0 + 1e-9 ? 0.0 : 1.0;
      return Vector{ { scale * x[0], scale * x[1], x[2] } };
    });
  auto axis = MakeFilter(wedges, 500);
  const std::string nothing = WarningsOf(axis);
  check.That(nothing.empty(), "no warning for collapsed faces: " + nothing);
  auto apart = MakeFilter(MakePart(0, Around, -1e-3), 500);
  check.That(WarningsOf(apart).find("cell faces") != std::string::npos, "a gap that is too wide");
  check.Equal(apart->GetReport()->GetCount("ToleranceMatchedFaces"), 0, "faces are joined over");
}

}

int TestFlowSeams(int, char*[])
{
  Check check;
  TestClosed(check);
  TestBlocks(check);
  TestOpen(check);
  return check.Result();
}
