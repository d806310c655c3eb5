// SPDX-License-Identifier: BSD-3-Clause
// The 4-simplices of a constant hypercube, each projected along time, and their sum.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/VectorArithmetic.h"
#include "Gallery/Volumes.h"

#include "Support/Images/HypercubePlate.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTubeFilter.h"

#include <map>
#include <set>
#include <vector>

namespace
{
constexpr int COLUMNS = 5;
/// Distance between two hypercubes.
constexpr double DISTANCE = 1.6;

/// Direction from which the camera looks.
const vtkVector3d FROM(0.35, -1.0, 0.3);

/// The tetrahedra of a 4-simplex, all of which have the same point with a duration.
using Tetrahedra = std::vector<vtkIdType>;

std::vector<Tetrahedra> FindSimplices(vtkUnstructuredGrid* grid)
{
  vtkDataArray* durations = grid->GetPointData()->GetArray("DeltaT");
  std::map<vtkIdType, Tetrahedra> simplices;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, corners);
    for (const vtkIdType corner : *corners)
    {
      if (durations->GetComponent(corner, 0) > 0.0)
      {
        simplices[corner].push_back(cell);
      }
    }
  }
  std::vector<Tetrahedra> all;
  for (const auto& [point, cells] : simplices)
  {
    all.push_back(cells);
  }
  return all;
}

/// Lines between points.
class Lines
{
public:
  void Add(const vtkVector3d& from, const vtkVector3d& to)
  {
    const vtkIdType ids[2] = { this->Points->InsertNextPoint(from.GetData()),
      this->Points->InsertNextPoint(to.GetData()) };
    this->Cells->InsertNextCell(2, ids);
  }

  vtkSmartPointer<vtkActor> MakeTubes(double radius, const vtkColor3d& color)
  {
    vtkNew<vtkPolyData> lines;
    lines->SetPoints(this->Points);
    lines->SetLines(this->Cells);
    vtkNew<vtkTubeFilter> tubes;
    tubes->SetInputData(lines);
    tubes->SetRadius(radius);
    tubes->SetNumberOfSides(12);
    tubes->CappingOn();
    tubes->Update();
    return gallery::MakeActor(tubes->GetOutput(), color);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
};

void AddCube(const vtkVector3d& corner, Lines& lines)
{
  for (int from = 0; from < 8; ++from)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto at = [&corner](int vertex)
      { return corner + vtkVector3d(vertex & 1, (vertex >> 1) & 1, (vertex >> 2) & 1); };
      if (!(from & (1 << axis)))
      {
        lines.Add(at(from), at(from | (1 << axis)));
      }
    }
  }
}

/// Adds the projected 4-simplices in rows, with spheres where they have a duration.
void AddSimplices(gallery::Panel& panel, vtkUnstructuredGrid* grid)
{
  vtkDataArray* durations = grid->GetPointData()->GetArray("DeltaT");
  const vtkBoundingBox box(grid->GetBounds());
  const vtkVector3d origin(box.GetMinPoint());
  const vtkVector3d right = vtkVector3d(-FROM[1], FROM[0], 0.0).Normalized();
  const vtkVector3d up = FROM.Normalized().Cross(right);
  Lines cubes;
  Lines edges;
  vtkNew<vtkAppendPolyData> spheres;
  int number = 0;
  vtkNew<vtkIdList> corners;
  for (const Tetrahedra& simplex : FindSimplices(grid))
  {
    const vtkVector3d offset = DISTANCE * ((number % COLUMNS) * right - (number / COLUMNS) * up);
    ++number;
    AddCube(offset, cubes);
    std::set<std::pair<vtkIdType, vtkIdType>> known;
    for (const vtkIdType cell : simplex)
    {
      grid->GetCellPoints(cell, corners);
      for (const vtkIdType a : *corners)
      {
        const vtkVector3d from = vtkVector3d(grid->GetPoint(a)) - origin + offset;
        for (const vtkIdType b : *corners)
        {
          if (a < b && known.emplace(a, b).second)
          {
            edges.Add(from, vtkVector3d(grid->GetPoint(b)) - origin + offset);
          }
        }
        if (durations->GetComponent(a, 0) > 0.0 && known.emplace(a, a).second)
        {
          vtkNew<vtkSphereSource> sphere;
          sphere->SetCenter(from.GetData());
          sphere->SetRadius(0.09);
          sphere->SetThetaResolution(24);
          sphere->SetPhiResolution(24);
          spheres->AddInputConnection(sphere->GetOutputPort());
        }
      }
    }
  }
  spheres->Update();
  panel.Add(cubes.MakeTubes(0.014, { 0.62, 0.64, 0.67 }));
  panel.Add(edges.MakeTubes(0.03, gallery::IntervalColor(0)));
  panel.Add(gallery::MakeActor(spheres->GetOutput(), gallery::IntervalColor(3)));
}

void Build(gallery::Stage& stage)
{
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInterval(0, -1.0, 1.0);
  const vtkSmartPointer<vtkUnstructuredGrid> tetrahedra =
    stage.Extract(interval, reference::MakeHypercubePlate(1, 2, 1.0, false));
  gallery::Panel& parts = stage.AddPanel("4-simplices, projected; red: with Δt");
  parts.LookFrom(FROM, { 0.0, 0.0, 1.0 });
  parts.UseParallelProjection();
  AddSimplices(parts, tetrahedra);
  gallery::Panel& sum = stage.AddPanel("all together, as a volume");
  sum.LookFrom(FROM, { 0.0, 0.0, 1.0 });
  sum.UseParallelProjection();
  sum.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColor(0), 1.1 } }));
}

const gallery::SceneRegistration registration(
  { "projected-hypercube", "3.16", "The projected 4-simplices of a constant hypercube",
    "A cell whose value is constant over a time step is a hypercube in space-time. Each of its 24 "
    "4-simplices is projected along time to a tetrahedron, whose duration Δt is nonzero at one "
    "point only (red; figures 3.16 and 3.18). Four tetrahedra overlap everywhere, and their "
    "durations add up to the constant duration of the cell: rendered together, they are a uniform "
    "cube (figure 3.17).",
    {}, &Build });
}
