// SPDX-License-Identifier: BSD-3-Clause
// Streamlines that leave the field at a surface on the domain boundary. The surfaces are meshes of
// the field's boundary faces, for all kinds of grids, with and without deformation. Results are
// compared with known streamlines. Also tests planes through rounded points, samples on the
// boundary, no-slip walls, and surfaces that must not be reached.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Flow/ReferenceSkin.h"

#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationPlane.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
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

constexpr int Cells = 4;
constexpr int NumberOfSamples = 10000;

/// Center of a linear flow, which cells interpolate exactly. Its rates along x, y and z differ.
const Vector Center = { { 1.9, 2.2, 2.05 } };
const Vector Rates = { { 1.0, 0.7, -0.4 } };

Vector Diverge(const Vector& x)
{
  Vector v{};
  for (int i = 0; i < 3; ++i)
  {
    v[i] = Rates[i] * (x[i] - Center[i]);
  }
  return v;
}

/// Where and when a streamline leaves the box. Side is 2 * axis, plus 1 for the upper side.
struct Exit
{
  int Side = -1;
  double Time = VTK_DOUBLE_MAX;
  Vector Position{};
  /// Distance from the position to the nearest other side of the box.
  double Clearance = VTK_DOUBLE_MAX;
};

Exit Trace(const Vector& start)
{
  Exit exit;
  for (int i = 0; i < 3; ++i)
  {
    const double from = start[i] - Center[i];
    const double to = (from > 0.0 ? Cells : 0.0) - Center[i];
    const double time = std::log(to / from) / Rates[i];
    if (time >= 0.0 && time < exit.Time)
    {
      exit.Side = 2 * i + (from > 0.0 ? 1 : 0);
      exit.Time = time;
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    exit.Position[i] = Center[i] + (start[i] - Center[i]) * std::exp(Rates[i] * exit.Time);
    if (i != exit.Side / 2)
    {
      exit.Clearance = std::min({ exit.Clearance, exit.Position[i], Cells - exit.Position[i] });
    }
  }
  return exit;
}

/// Returns a function that displaces all points, including boundary points.
VectorField Shake(double bend)
{
  return [bend](const Vector& x)
  {
    return Vector{ { x[0] + bend * std::sin(2.9 * x[1] + 1.7 * x[2] + 4.0 * x[0]),
      x[1] + bend * std::cos(2.3 * x[2] + 2.6 * x[0] + 3.0 * x[1]),
      x[2] + bend * std::sin(3.1 * x[0] - 1.3 * x[1] + 5.0 * x[2]) } };
  };
}

std::vector<std::pair<std::string, vtkSmartPointer<vtkPointSet>>> MakeGrids(double bend)
{
  const std::array<int, 3> cells = { { Cells, Cells, Cells } };
  std::vector<std::pair<std::string, vtkSmartPointer<vtkPointSet>>> grids;
  grids.emplace_back("structured", MakeStructuredGrid(cells));
  for (const MeshKind kind : { MeshKind::Hexahedra, MeshKind::Wedges, MeshKind::Pyramids,
         MeshKind::Tetrahedra6, MeshKind::Mixed })
  {
    grids.emplace_back(GetName(kind), MakeFlowMesh(kind, cells, false));
  }
  for (auto& grid : grids)
  {
    grid.first += " displaced by " + std::to_string(bend);
    MovePoints(grid.second, Shake(bend));
    AddVectors(grid.second, Diverge);
  }
  return grids;
}

vtkSmartPointer<vtkTerminationMesh> MakeSurface(vtkPolyData* skin, int id)
{
  auto mesh = vtkSmartPointer<vtkTerminationMesh>::New();
  mesh->SetMesh(skin);
  mesh->SetId(id);
  return mesh;
}

vtkSmartPointer<vtkImplicitFlowField> MakeFilter(vtkDataSet* field, vtkDataSet* samples)
{
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  filter->SetInputDataObject(field);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  if (samples)
  {
    filter->SetSampleData(samples);
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  }
  filter->SetDirectionToForward();
  return filter;
}

vtkDataSet* Update(vtkImplicitFlowField* filter)
{
  filter->Update();
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

double GetValue(vtkDataSet* data, const char* name, vtkIdType id)
{
  return data->GetPointData()->GetArray(name)->GetComponent(id, 0);
}

vtkSmartPointer<vtkPolyData> MakeSamples(int number)
{
  Random random(17);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < number; ++i)
  {
    points->InsertNextPoint(random.Get(0.05, Cells - 0.05), random.Get(0.05, Cells - 0.05),
      random.Get(0.05, Cells - 0.05));
  }
  auto samples = vtkSmartPointer<vtkPolyData>::New();
  samples->SetPoints(points);
  return samples;
}

/// Tests six meshes, one per side of the boundary. All samples reach the expected mesh.
void TestBoundary(Check& check)
{
  auto samples = MakeSamples(NumberOfSamples);
  for (const double bend : { 0.0, 1e-6, 1e-3 })
  {
    for (const auto& grid : MakeGrids(bend))
    {
      check.SetContext(grid.first);
      auto filter = MakeFilter(grid.second, samples);
      for (int side = 0; side < 6; ++side)
      {
        const double position = side % 2 == 0 ? 0.0 : Cells;
        auto skin = MakeSkin(grid.second,
          [side, position](const Vector& center)
          { return std::abs(center[side / 2] - position) < 0.1; });
        filter->AddTerminationSurface(MakeSurface(skin, side));
      }
      vtkDataSet* output = Update(filter);
      check.Equal(filter->GetReport()->GetCount("Statuses", vtkFlowStatus::REACHED_SURFACE),
        NumberOfSamples, "samples that reached the boundary");
      int unexpected = 0;
      double latest = 0.0;
      for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
      {
        Vector x;
        output->GetPoint(id, x.data());
        const Exit exit = Trace(x);
        const bool isSide = GetValue(output, "TerminationId", id) == exit.Side;
        unexpected += isSide || exit.Clearance < 0.01 + 4.0 * bend ? 0 : 1;
        if (isSide)
        {
          const double speed = std::abs(Diverge(exit.Position)[exit.Side / 2]);
          latest =
            std::max(latest, speed * std::abs(GetValue(output, "AdvectionTime", id) - exit.Time));
        }
      }
      check.Equal(unexpected, 0, "samples that reached an unexpected side");
      check.That(latest < 2.5 * bend + 1e-4, "maximum distance error " + std::to_string(latest));
    }
  }
  check.SetContext("");
}

/// Tests a mesh in single precision for a field in double precision, with and without the arrival
/// tolerance.
void TestRounding(Check& check)
{
  auto samples = MakeSamples(1000);
  for (const double bend : { 0.0, 1e-6, 1e-3 })
  {
    auto grid = MakeStructuredGrid({ { Cells, Cells, Cells } });
    MovePoints(grid, Shake(bend));
    MovePoints(grid,
      [](const Vector& x) {
        return Vector{ { 0.1 + x[0] / 3.0, x[1] / 7.0, 0.3 + x[2] / 11.0 } };
      });
    AddVectors(grid, [](const Vector& x) { return Vector{ { x[0] - 0.8, 0.4, x[2] - 0.5 } }; });
    vtkNew<vtkPolyData> placed;
    placed->DeepCopy(samples);
    MovePoints(placed,
      [](const Vector& x) {
        return Vector{ { 0.1 + x[0] / 3.0, x[1] / 7.0, 0.3 + x[2] / 11.0 } };
      });
    auto filter = MakeFilter(grid, placed);
    filter->AddTerminationSurface(
      MakeSurface(MakeSkin(
                    grid, [](const Vector&) { return true; }, VTK_FLOAT),
        3));
    Update(filter);
    check.Equal(filter->GetReport()->GetCount("Statuses", vtkFlowStatus::REACHED_SURFACE), 1000,
      "samples that reached the single-precision mesh");
    filter->SetArrivalTolerance(0.0);
    Update(filter);
    check.That(filter->GetReport()->GetNumber("Statuses", vtkFlowStatus::LEFT_DOMAIN) > 100,
      "without the tolerance, rounding errors decide");
    check.Equal(filter->GetReport()->GetCount("ReachedWithinTolerance"), 0,
      "samples within a tolerance of 0");
  }
}

/// Tests a plane at the inlet of a grid with single-precision points. Some samples are on the
/// inlet.
void TestPlane(Check& check)
{
  const std::array<int, 3> cells = { { 6, 10, 10 } };
  auto grid = MakeStructuredGrid(cells);
  const double slope = 0.37;
  MovePoints(grid,
    [slope](const Vector& x)
    {
      const Vector p = { { 0.1 * x[0], 0.1 * x[1], 0.1 * x[2] } };
      return Vector{ { p[0] + slope * p[1], p[1] - slope * p[0], p[2] } };
    });
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  floats->DeepCopy(grid->GetPoints());
  grid->SetPoints(floats);
  AddVectors(grid, [slope](const Vector&) { return Vector{ { 1.0, -slope, 0.0 } }; });
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(slope, 1.0, 0.0);
  plane->SetPoint2(0.0, 0.0, 1.0);
  auto filter = MakeFilter(grid, nullptr);
  filter->SetDirection(vtkImplicitFlowField::BACKWARD);
  filter->AddTerminationSurface(plane);
  for (const int direction : { vtkImplicitFlowField::BACKWARD, vtkImplicitFlowField::FORWARD })
  {
    filter->SetDirection(direction);
    vtkDataSet* output = Update(filter);
    for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
    {
      const auto i = id % (cells[0] + 1);
      const auto j = id / (cells[0] + 1) % (cells[1] + 1);
      // At the side walls (j == 0 or j == cells[1]), rounding errors decide whether a backward
      // streamline leaves the grid, so its status is not checked.
      const bool isReached =
        i == 0 || (direction == vtkImplicitFlowField::BACKWARD && j > 0 && j < cells[1]);
      if (isReached || direction == vtkImplicitFlowField::FORWARD)
      {
        check.Equal(static_cast<int>(GetValue(output, "FlowStatus", id)),
          isReached ? vtkFlowStatus::REACHED_SURFACE : vtkFlowStatus::LEFT_DOMAIN,
          "samples that reach the inlet");
      }
      if (i == 0)
      {
        check.That(
          GetValue(output, "AdvectionTime", id) == 0.0, "a sample on the surface ends at once");
        check.Equal(static_cast<int>(GetValue(output, "TerminationSide", id)), 0,
          "a sample on the surface has no side");
      }
    }
  }
}

/// Streamlines slow down toward a no-slip wall. They still reach a surface at the wall.
void TestWall(Check& check)
{
  auto image = MakeFlowImage(5, [](const Vector& x) { return Vector{ { 0.0, -x[1], 0.0 } }; });
  vtkNew<vtkTerminationPlane> wall;
  wall->SetOrigin(0.0, -0.005, 0.0);
  wall->SetPoint1(4.0, -0.005, 0.0);
  wall->SetPoint2(0.0, -0.005, 4.0);
  auto filter = MakeFilter(image, nullptr);
  filter->AddTerminationSurface(wall);
  Update(filter);
  check.Equal(filter->GetReport()->GetCount("Statuses", vtkFlowStatus::REACHED_SURFACE), 125,
    "samples that reached the wall");
  filter->SetArrivalTolerance(0.0);
  AllowWarnings(filter);
  Update(filter);
  check.Equal(filter->GetReport()->GetSize("SurfaceIds"), 0,
    "number of surfaces reached without the tolerance");
}

/// Tests a surface parallel to the streamline, surfaces past the end of the field, and surfaces
/// whose boundary edge is near the end of the streamline. Only surfaces within the tolerance are
/// reached.
void TestMissed(Check& check)
{
  auto image = MakeFlowImage(5, [](const Vector&) { return Vector{ { 1.0, 0.0, 0.0 } }; });
  struct Case
  {
    std::string What;
    Vector Origin;
    Vector Point1;
    Vector Point2;
    bool IsReached;
  };
  const Case cases[] = {
    { "behind the end", { { 4.02, 0, 0 } }, { { 4.02, 4, 0 } }, { { 4.02, 0, 4 } }, false },
    { "slightly behind the end", { { 4.005, 0, 0 } }, { { 4.005, 4, 0 } }, { { 4.005, 0, 4 } },
      true },
    { "along the streamline", { { 0, 2.005, 0 } }, { { 8, 2.005, 0 } }, { { 0, 2.005, 4 } },
      false },
    { "outside its boundary edge", { { 4, 2.02, 0 } }, { { 4, 4, 0 } }, { { 4, 2.02, 4 } }, false },
    { "at its boundary edge", { { 4, 2.005, 0 } }, { { 4, 4, 0 } }, { { 4, 2.005, 4 } }, true },
    { "askew", { { 4.005, 2, 0 } }, { { 5.005, 3, 0 } }, { { 4.005, 2, 4 } }, true },
  };
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, 2.0, 1.5);
  vtkNew<vtkPolyData> sample;
  sample->SetPoints(points);
  for (const Case& one : cases)
  {
    vtkNew<vtkTerminationPlane> plane;
    plane->SetOrigin(one.Origin.data());
    plane->SetPoint1(one.Point1.data());
    plane->SetPoint2(one.Point2.data());
    auto filter = MakeFilter(image, sample);
    filter->AddTerminationSurface(plane);
    filter->DomainFacesOn();
    vtkDataSet* output = Update(filter);
    check.Equal(static_cast<int>(GetValue(output, "TerminationId", 0)), one.IsReached ? 0 : 1001,
      "a surface " + one.What);
    check.Near(GetValue(output, "AdvectionTime", 0), 3.5, 1e-12, "time of leaving the field");
    check.Equal(filter->GetReport()->GetCount("ReachedWithinTolerance"), one.IsReached ? 1 : 0,
      "samples that reach a surface within the tolerance");
  }
  // The closest of several surfaces is reached.
  auto filter = MakeFilter(image, sample);
  for (const double gap : { 0.008, 0.002, 0.006 })
  {
    filter->AddTerminationSurface(MakeFlowPlane(4.0 + gap));
  }
  check.Equal(
    static_cast<int>(GetValue(Update(filter), "TerminationId", 0)), 1, "the closest surface");
}

}

int TestFlowArrival(int, char*[])
{
  Check check;
  TestBoundary(check);
  TestRounding(check);
  TestPlane(check);
  TestWall(check);
  TestMissed(check);
  return check.Result();
}
