// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Inputs/Shapes.h"

#include "vtkAppendPolyData.h"
#include "vtkCardinalSpline.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkLinearExtrusionFilter.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkRotationalExtrusionFilter.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangleFilter.h"
#include "vtkTubeFilter.h"

#include <cmath>

namespace interlume
{

namespace
{

constexpr int TurnSteps = 72;
constexpr int SplineSteps = 12; ///< between two points

/// Returns points on a cardinal spline through \a rows, which are points with N coordinates.
template <std::size_t N>
std::vector<std::array<double, N>> Spline(const std::vector<std::array<double, N>>& rows)
{
  const int steps = SplineSteps * static_cast<int>(rows.size() - 1);
  std::vector<std::array<double, N>> points(steps + 1);
  for (std::size_t column = 0; column < N; ++column)
  {
    vtkNew<vtkCardinalSpline> spline;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      spline->AddPoint(static_cast<double>(i), rows[i][column]);
    }
    for (int i = 0; i <= steps; ++i)
    {
      points[i][column] = spline->Evaluate(static_cast<double>(i) / SplineSteps);
    }
  }
  return points;
}

/// Returns one polyline through the points.
vtkSmartPointer<vtkPolyData> MakeLine(const std::vector<Position3>& positions)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(positions.size()));
  for (const Position3& position : positions)
  {
    lines->InsertCellPoint(points->InsertNextPoint(position.data()));
  }
  auto line = vtkSmartPointer<vtkPolyData>::New();
  line->SetPoints(points);
  line->SetLines(lines);
  return line;
}

/// Triangulates a surface, merges duplicate points along seams, removes degenerate triangles and
/// computes outward normals.
vtkSmartPointer<vtkPolyData> Finish(vtkPolyData* shape, double sharp)
{
  shape->GetPointData()->Initialize();
  shape->GetCellData()->Initialize();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(shape);
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  clean->SetTolerance(1e-7);
  clean->Update();
  // Removes triangles that collapsed to lines or points.
  vtkPolyData* merged = clean->GetOutput();
  merged->SetVerts(nullptr);
  merged->SetLines(nullptr);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(merged);
  normals->SetFeatureAngle(sharp);
  normals->ConsistencyOn();
  normals->AutoOrientNormalsOn();
  normals->Update();
  return normals->GetOutput();
}

}

vtkSmartPointer<vtkPolyData> Revolve(
  const std::vector<ProfilePoint>& profile, bool smooth, double sharp)
{
  std::vector<Position3> positions;
  for (const ProfilePoint& point : smooth ? Spline(profile) : profile)
  {
    positions.push_back({ { std::max(point[0], 0.0), 0.0, point[1] } });
  }
  vtkNew<vtkRotationalExtrusionFilter> turn;
  turn->SetInputData(MakeLine(positions));
  turn->SetResolution(TurnSteps);
  turn->CappingOff();
  turn->Update();
  return Finish(turn->GetOutput(), sharp);
}

vtkSmartPointer<vtkPolyData> MakeTube(
  const std::vector<Position3>& positions, const std::vector<double>& radii)
{
  std::vector<std::array<double, 4>> rows;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    rows.push_back({ { positions[i][0], positions[i][1], positions[i][2], radii[i] } });
  }
  std::vector<Position3> path;
  vtkNew<vtkDoubleArray> widths;
  for (const auto& row : Spline(rows))
  {
    path.push_back({ { row[0], row[1], row[2] } });
    widths->InsertNextValue(row[3]);
  }
  vtkSmartPointer<vtkPolyData> line = MakeLine(path);
  line->GetPointData()->SetScalars(widths);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(line);
  tube->SetNumberOfSides(32);
  tube->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  tube->CappingOn();
  tube->Update();
  return Finish(tube->GetOutput(), 50.0);
}

vtkSmartPointer<vtkPolyData> MakeRoundedBox(const Position3& lengths, double radius)
{
  // A sphere is cut along the three coordinate planes. The octants move to the corners of the box,
  // and the gaps between them are filled with flat faces and quarter cylinders.
  constexpr int steps = 6;
  constexpr int columns = 4 * (steps + 1);
  const double step = 0.5 * vtkMath::Pi() / steps;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  for (int row = 0; row < 2 * (steps + 1); ++row)
  {
    const double z = row <= steps ? 1.0 : -1.0;
    const double polar = step * (row <= steps ? row : row - 1);
    for (int column = 0; column < columns; ++column)
    {
      const int quadrant = column / (steps + 1);
      const double around = step * (column - quadrant);
      const double n[3] = { std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
        std::cos(polar) };
      const double x = quadrant == 0 || quadrant == 3 ? 1.0 : -1.0;
      const double y = quadrant < 2 ? 1.0 : -1.0;
      points->InsertNextPoint(x * (0.5 * lengths[0] - radius) + radius * n[0],
        y * (0.5 * lengths[1] - radius) + radius * n[1],
        z * (0.5 * lengths[2] - radius) + radius * n[2]);
      normals->InsertNextTuple(n);
    }
  }
  vtkNew<vtkCellArray> cells;
  for (int row = 0; row + 1 < 2 * (steps + 1); ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const vtkIdType a = row * columns + column;
      const vtkIdType b = row * columns + (column + 1) % columns;
      cells->InsertNextCell({ a, a + columns, b + columns, b });
    }
  }
  const vtkIdType last = (2 * (steps + 1) - 1) * columns;
  constexpr int part = steps + 1;
  cells->InsertNextCell({ 0, part, 2 * part, 3 * part });
  cells->InsertNextCell({ last + 3 * part, last + 2 * part, last + part, last });
  vtkNew<vtkPolyData> box;
  box->SetPoints(points);
  box->SetPolys(cells);
  box->GetPointData()->SetNormals(normals);
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(box);
  clean->SetTolerance(1e-7);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(clean->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  return triangles->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakePlate(
  const std::vector<std::array<double, 2>>& outline, double thickness)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(outline.size()));
  for (const auto& corner : outline)
  {
    cells->InsertCellPoint(points->InsertNextPoint(corner[0], corner[1], -0.5 * thickness));
  }
  vtkNew<vtkPolyData> face;
  face->SetPoints(points);
  face->SetPolys(cells);
  vtkNew<vtkLinearExtrusionFilter> extrusion;
  extrusion->SetInputData(face);
  extrusion->SetExtrusionTypeToVectorExtrusion();
  extrusion->SetVector(0.0, 0.0, thickness);
  extrusion->CappingOn();
  extrusion->Update();
  return Finish(extrusion->GetOutput(), 20.0);
}

vtkSmartPointer<vtkPolyData> MoveShape(
  vtkPolyData* shape, const Position3& offset, const Position3& degrees)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(offset.data());
  transform->RotateZ(degrees[2]);
  transform->RotateY(degrees[1]);
  transform->RotateX(degrees[0]);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(shape);
  filter->SetTransform(transform);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkSmartPointer<vtkPolyData>>& shapes)
{
  vtkNew<vtkAppendPolyData> all;
  for (const auto& shape : shapes)
  {
    all->AddInputData(shape);
  }
  all->Update();
  return all->GetOutput();
}

}
