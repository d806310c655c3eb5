// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a flow volume: tetrahedra match at faces, intervals of Inflow and time fill it
// without gap or overlap, and stream and time surfaces consist of faces of the tetrahedra, each
// face once. Triangles and normals point against the gradient.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkCellData.h"
#include "vtkFlowVolume.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInflowMapping.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace
{

using namespace reference;

// Returns the tetrahedra of all intervals of a grid.
std::vector<Tetrahedron> AllTetrahedra(vtkUnstructuredGrid* grid)
{
  std::vector<Tetrahedron> tetrahedra;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    tetrahedra.push_back({ { ids->GetId(0), ids->GetId(1), ids->GetId(2), ids->GetId(3) } });
  }
  return tetrahedra;
}

// Returns an implicit flow field with curved level sets, on an image or on tetrahedra.
vtkSmartPointer<vtkDataSet> MakeField(bool isTetrahedral)
{
  constexpr int cells = 12;
  vtkSmartPointer<vtkDataSet> data;
  if (isTetrahedral)
  {
    data = MakeMesh(MeshKind::Tetrahedra6, { { cells, cells, cells } });
  }
  else
  {
    data =
      MakeFlowImage({ { cells + 1, cells + 1, cells + 1 } }, { { 0, cells, 0, cells, 0, cells } });
  }
  AddFlow(data,
    [](const double* at) -> FlowResult
    {
      const double x[3] = { at[0] / cells, at[1] / cells, at[2] / cells };
      return { 0, 0, x[1] + 0.2 * std::sin(5.0 * x[0]), x[2] + 0.1 * x[0] * x[0],
        x[0] * (1.0 + 0.5 * x[1]) + 0.05 * std::cos(9.0 * x[2]) + 0.1 };
    },
    { { { 0, 0, 0 } } });
  return data;
}

struct Levels
{
  std::vector<std::array<double, 2>> Intervals;
  std::vector<double> StreamSurfaces;
  double Start;
  double End;
  std::vector<double> TimeSurfaces;
};

void Set(vtkFlowVolume* volume, const Levels& levels)
{
  volume->SetNumberOfIntervals(static_cast<int>(levels.Intervals.size()));
  for (std::size_t i = 0; i < levels.Intervals.size(); ++i)
  {
    volume->SetInterval(static_cast<int>(i), levels.Intervals[i][0], levels.Intervals[i][1]);
  }
  volume->SetNumberOfStreamSurfaces(static_cast<int>(levels.StreamSurfaces.size()));
  for (std::size_t i = 0; i < levels.StreamSurfaces.size(); ++i)
  {
    volume->SetStreamSurface(static_cast<int>(i), levels.StreamSurfaces[i]);
  }
  volume->SetTimeRange(levels.Start, levels.End);
  volume->SetNumberOfTimeSurfaces(static_cast<int>(levels.TimeSurfaces.size()));
  for (std::size_t i = 0; i < levels.TimeSurfaces.size(); ++i)
  {
    volume->SetTimeSurface(static_cast<int>(i), levels.TimeSurfaces[i]);
  }
}

// Returns the sorted distinct values.
std::vector<double> Sorted(std::vector<double> values)
{
  const std::set<double> each(values.begin(), values.end());
  return std::vector<double>(each.begin(), each.end());
}

// Checks that each triangle of \a surface is a face of a tetrahedron of \a mesh, occurs once, has
// the value of its id, and is oriented toward lower values.
void CheckSurface(vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* surface, const char* function,
  const char* idArray, const std::vector<double>& values, bool hasFlatCells, Check& check)
{
  std::map<std::array<vtkIdType, 3>, std::vector<vtkIdType>> opposite;
  for (const Tetrahedron& tetrahedron : AllTetrahedra(mesh))
  {
    for (int out = 0; out < 4; ++out)
    {
      std::array<vtkIdType, 3> face{ { tetrahedron[(out + 1) % 4], tetrahedron[(out + 2) % 4],
        tetrahedron[(out + 3) % 4] } };
      std::sort(face.begin(), face.end());
      opposite[face].push_back(tetrahedron[out]);
    }
  }
  check.That(surface->GetPoints() == mesh->GetPoints(), "points are shared");
  vtkDataArray* f = mesh->GetPointData()->GetArray(function);
  vtkDataArray* ids = surface->GetCellData()->GetArray(idArray);
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  check.That(normals && normals->GetName() == std::string("Normals"), "the normals exist");
  std::set<std::array<vtkIdType, 3>> met;
  const std::vector<Triangle> triangles = TrianglesOf(surface);
  check.That(!triangles.empty(), "there are triangles");
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    std::array<vtkIdType, 3> face = triangles[t];
    std::sort(face.begin(), face.end());
    check.That(met.insert(face).second, "no triangle is repeated");
    const auto found = opposite.find(face);
    if (!check.That(found != opposite.end(), "a triangle is a face of a tetrahedron"))
    {
      continue;
    }
    const double value = values[static_cast<int>(ids->GetComponent(static_cast<vtkIdType>(t), 0))];
    double x[4][3];
    for (int c = 0; c < 3; ++c)
    {
      mesh->GetPoint(triangles[t][c], x[c]);
      check.Near(f->GetComponent(triangles[t][c], 0), value, 1e-12, "value on a surface", 1.0);
    }
    double normal[3];
    double area = 0.0;
    {
      double a[3];
      double b[3];
      vtkMath::Subtract(x[1], x[0], a);
      vtkMath::Subtract(x[2], x[0], b);
      vtkMath::Cross(a, b, normal);
      area = vtkMath::Norm(normal);
    }
    for (const vtkIdType other : found->second)
    {
      // The tetrahedron with larger values is behind the triangle.
      mesh->GetPoint(other, x[3]);
      double way[3];
      vtkMath::Subtract(x[3], x[0], way);
      const double side = vtkMath::Dot(way, normal);
      const double difference = f->GetComponent(other, 0) - value;
      check.That(side * difference <= 1e-15, "the triangle is oriented to lower values");
    }
    for (int c = 0; c < 3; ++c)
    {
      double n[3];
      normals->GetTuple(triangles[t][c], n);
      check.Near(vtkMath::Norm(n), 1.0, 1e-6, "length of a normal");
      check.That(hasFlatCells || vtkMath::Dot(n, normal) > 0.5 * area || area < 1e-3,
        "the normal points to the side of the triangle");
    }
  }
}

void CheckLevels(const Levels& levels, bool isTetrahedral, const std::string& name, Check& check)
{
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputData(MakeField(isTetrahedral));
  for (bool isStepped : { false, true })
  {
    const bool isThin = levels.Intervals[0][1] - levels.Intervals[0][0] < 0.01;
    const bool hasFlatCells = isStepped || (isThin && !isTetrahedral);
    check.SetContext(name + (isStepped ? ", values equal to bounds" : ""));
    mapping->SetFormula(
      vtkInflowMapping::ALL, isStepped ? "floor(8*(u*u+0.7*v)+0.5)/8" : "u*u+0.7*v");
    vtkNew<vtkFlowVolume> volume;
    volume->SetInputConnection(mapping->GetOutputPort());
    volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    volume->GenerateStreamSurfacesOn();
    volume->GenerateTimeSurfacesOn();
    volume->GenerateNormalsOn();
    Set(volume, levels);
    volume->Update();
    vtkUnstructuredGrid* mesh = volume->GetOutput();
    // A face belongs to at most two tetrahedra, on opposite sides. Degenerate cells without face
    // neighbors may remain if values equal bounds, or if a thin interval is curved inside a cell.
    for (const FaceUse& face : CountUses(FacesOf(AllTetrahedra(mesh))))
    {
      check.That(
        face.Total() <= 2 && (hasFlatCells || face.Net() == 0 || face.Total() == 1), "faces match");
    }
    // The values in a cell are in the intervals given by its ids.
    const std::vector<double> times = [&]()
    {
      std::vector<double> all = levels.TimeSurfaces;
      all.push_back(levels.Start);
      all.push_back(levels.End);
      return Sorted(all);
    }();
    std::vector<double> streams = levels.StreamSurfaces;
    for (const auto& interval : levels.Intervals)
    {
      streams.insert(streams.end(), interval.begin(), interval.end());
    }
    streams = Sorted(streams);
    vtkDataArray* inflow = mesh->GetPointData()->GetArray("Inflow");
    vtkDataArray* time = mesh->GetPointData()->GetArray("AdvectionTime");
    vtkDataArray* intervalIds = mesh->GetCellData()->GetArray("IntervalId");
    vtkDataArray* timeIds = mesh->GetCellData()->GetArray("TimeIntervalId");
    const std::vector<Tetrahedron> tetrahedra = AllTetrahedra(mesh);
    for (std::size_t cell = 0; cell < tetrahedra.size(); ++cell)
    {
      const vtkIdType id = static_cast<vtkIdType>(cell);
      const int timeId = static_cast<int>(timeIds->GetComponent(id, 0));
      const auto& interval = levels.Intervals[static_cast<int>(intervalIds->GetComponent(id, 0))];
      double lowest = VTK_DOUBLE_MAX;
      double highest = -VTK_DOUBLE_MAX;
      for (const vtkIdType p : tetrahedra[cell])
      {
        const double t = time->GetComponent(p, 0);
        const double f = inflow->GetComponent(p, 0);
        lowest = std::min(lowest, f);
        highest = std::max(highest, f);
        check.That(t >= times[timeId] - 1e-12 && t <= times[timeId + 1] + 1e-12, "time of a cell");
        check.That(f >= interval[0] - 1e-12 && f <= interval[1] + 1e-12, "Inflow of a cell");
      }
      check.That(std::none_of(streams.begin(), streams.end(),
                   [&](double value) { return value > lowest + 1e-12 && value < highest - 1e-12; }),
        "no cell on both sides of a stream surface");
    }
    // The volumes of the time intervals add up to the volume without time surfaces.
    vtkNew<vtkFlowVolume> full;
    full->SetInputConnection(mapping->GetOutputPort());
    full->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    Set(full, levels);
    full->SetNumberOfTimeSurfaces(0);
    full->SetNumberOfStreamSurfaces(0);
    full->Update();
    const double expected = MeasureVolume(full->GetOutput());
    check.That(expected > 0.5, "the volume is positive");
    check.Near(MeasureVolume(mesh), expected, isTetrahedral ? 1e-12 : 0.005, "sum of all volumes");
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < times.size(); ++i)
    {
      sum += MeasureVolume(mesh, "TimeIntervalId", static_cast<int>(i));
    }
    check.Near(sum, MeasureVolume(mesh), 1e-12, "sum of time intervals");
    // The areas of the stream surfaces before, in and after the time range add up to the area
    // without a time range.
    const double clipped = MeasureArea(volume->GetOutput(1));
    volume->SetTimeRange(0.0, levels.Start);
    volume->Update();
    const double before = MeasureArea(volume->GetOutput(1));
    volume->SetTimeRange(levels.End, VTK_DOUBLE_MAX);
    volume->Update();
    const double after = MeasureArea(volume->GetOutput(1));
    volume->SetTimeRange(0.0, VTK_DOUBLE_MAX);
    volume->SetNumberOfTimeSurfaces(0);
    volume->Update();
    check.Near(clipped + before + after, MeasureArea(volume->GetOutput(1)), 1e-9,
      "sum of the stream surfaces");
    Set(volume, levels);
    volume->Update();
    if (!isStepped)
    {
      CheckSurface(volume->GetOutput(), volume->GetOutput(1), "Inflow", "StreamSurfaceId", streams,
        hasFlatCells, check);
    }
    CheckSurface(volume->GetOutput(), volume->GetOutput(2), "AdvectionTime", "TimeSurfaceId", times,
      hasFlatCells, check);
  }
}

// Compares normals with gradients of known functions.
void CheckNormals(Check& check)
{
  check.SetContext("normals");
  auto image = MakeFlowImage({ { 41, 41, 41 } }, { { -1, 1, -1, 1, -1, 1 } });
  AddFlow(image, SphereFlow(0.2), { { { 0, 1, 0 } } });
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputData(image);
  mapping->SetFormula(vtkInflowMapping::ALL, "-v");
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(mapping->GetOutputPort());
  volume->SetInterval(0, -0.6, -0.3);
  volume->SetTimeRange(0.2, 0.6);
  volume->GenerateStreamSurfacesOn();
  volume->GenerateTimeSurfacesOn();
  volume->GenerateNormalsOn();
  volume->Update();
  for (int port : { 1, 2 })
  {
    vtkUnstructuredGrid* surface = volume->GetOutput(port);
    double worst = 1.0;
    for (const Triangle& triangle : TrianglesOf(surface))
    {
      for (const vtkIdType p : triangle)
      {
        double x[3];
        double n[3];
        surface->GetPoint(p, x);
        surface->GetPointData()->GetNormals()->GetTuple(p, n);
        const double flat = std::hypot(x[0], x[1]);
        // Time increases outward. -v increases toward the pole v = 0.
        double expected[3] = { -x[0], -x[1], -x[2] };
        if (port == 1)
        {
          expected[0] = x[0] * x[2] / flat;
          expected[1] = x[1] * x[2] / flat;
          expected[2] = -flat;
        }
        vtkMath::Normalize(expected);
        worst = std::min(worst, vtkMath::Dot(n, expected));
      }
    }
    check.That(
      worst > std::cos(0.12), "maximum error of a normal: " + std::to_string(std::acos(worst)));
  }
}

}

int TestFlowVolumeMesh(int, char*[])
{
  Check check;
  for (bool isTetrahedral : { false, true })
  {
    const std::string grid = isTetrahedral ? "tetrahedra, " : "image, ";
    CheckLevels({ { { { 0.25, 0.75 } } }, { 0.75, 0.5, 0.25 }, 0.3, 0.9, { 0.9, 0.5, 0.7 } },
      isTetrahedral, grid + "one interval", check);
    CheckLevels({ { { { 0.25, 0.5 } }, { { 0.5, 0.75 } }, { { 0.875, 1.0 } } },
                  { 0.625, 0.375, 0.8 }, 0.25, 1.1, { 0.75 } },
      isTetrahedral, grid + "several intervals", check);
    // An interval thinner than a cell, which contains no grid point.
    CheckLevels({ { { { 0.4, 0.402 } } }, { 0.401 }, 0.3, 0.9, { 0.5 } }, isTetrahedral,
      grid + "a thin interval", check);
  }
  CheckNormals(check);
  return check.Result();
}
