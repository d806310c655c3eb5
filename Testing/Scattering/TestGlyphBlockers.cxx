// SPDX-License-Identifier: BSD-3-Clause
// The triangles of glyphs that block scattered light match the glyphs that VTK draws. They are
// compared with vtkTransform for each orientation mode, scale, source index, mask and actor
// transform. Concave polygons are covered exactly once.
#include "ShadowMaps/PropSurfaces.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkActor.h"
#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using reference::Check;
using Tuple = std::vector<double>;

constexpr double Size = 2.0;

/// Returns a triangle whose first vertex is at x = \a start.
vtkSmartPointer<vtkPolyData> MakeTriangle(double start)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(start, 0.0, 0.0);
  points->InsertNextPoint(start + 1.0, 0.0, 0.0);
  points->InsertNextPoint(start, 0.5, 0.25);
  vtkNew<vtkCellArray> cells;
  const std::array<vtkIdType, 3> ids{ { 0, 1, 2 } };
  cells->InsertNextCell(3, ids.data());
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

/// Glyphs at two points, with two sources. Initially both glyphs use the first source at its
/// original size.
struct Glyphs
{
  Glyphs()
  {
    vtkNew<vtkPoints> positions;
    positions->SetDataTypeToDouble();
    positions->InsertNextPoint(0.0, 0.0, 0.0);
    positions->InsertNextPoint(1.0, 2.0, 3.0);
    this->Points->SetPoints(positions);
    this->Mapper->SetInputData(this->Points);
    this->Mapper->SetSourceData(0, MakeTriangle(0.0));
    this->Mapper->SetSourceData(1, MakeTriangle(10.0));
    this->Mapper->SetScaleFactor(Size);
    this->Mapper->OrientOff();
    this->Actor->SetMapper(this->Mapper);
  }

  void AddArray(const char* name, const Tuple& first, const Tuple& second)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(first.size()));
    array->InsertNextTuple(first.data());
    array->InsertNextTuple(second.data());
    this->Points->GetPointData()->AddArray(array);
  }

  void Orient(int mode, const Tuple& tuple)
  {
    this->AddArray("turn", Tuple(tuple.size(), 0.5), tuple);
    this->Mapper->SetOrientationArray("turn");
    this->Mapper->OrientOn();
    this->Mapper->SetOrientationMode(mode);
  }

  std::vector<glm::dvec3> GetCorners() const
  {
    const auto surfaces = interlume::PropSurfaces::Get({ this->Actor.Get() });
    return surfaces.empty() ? std::vector<glm::dvec3>() : surfaces[0].Corners;
  }

  vtkNew<vtkPolyData> Points;
  vtkNew<vtkGlyph3DMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

/// Expects that the last triangle is at the second point, with \a transform applied to
/// MakeTriangle(\a start).
void CheckLast(Check& check, const Glyphs& glyphs, std::size_t triangles, vtkTransform* transform,
  double start, const std::string& name)
{
  const std::vector<glm::dvec3> corners = glyphs.GetCorners();
  if (!check.Equal(
        static_cast<long long>(corners.size()), static_cast<long long>(3 * triangles), name))
  {
    return;
  }
  const vtkSmartPointer<vtkPolyData> source = MakeTriangle(start);
  for (int i = 0; i < 3; ++i)
  {
    std::array<double, 3> expected{};
    transform->TransformPoint(source->GetPoint(i), expected.data());
    for (int axis = 0; axis < 3; ++axis)
    {
      check.Near(corners[corners.size() - 3 + static_cast<std::size_t>(i)][axis],
        expected[static_cast<std::size_t>(axis)], 1e-12,
        name + ", vertex " + std::to_string(i) + ", axis " + std::to_string(axis), 1.0);
    }
  }
}

vtkSmartPointer<vtkTransform> AtSecond()
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->Translate(1.0, 2.0, 3.0);
  return transform;
}

void TestOrientations(Check& check)
{
  Glyphs rotation;
  rotation.Orient(vtkGlyph3DMapper::ROTATION, { 20.0, 30.0, 40.0 });
  auto transform = AtSecond();
  transform->RotateZ(40.0);
  transform->RotateX(20.0);
  transform->RotateY(30.0);
  transform->Scale(Size, Size, Size);
  CheckLast(check, rotation, 2, transform, 0.0, "rotation");

  // A rotation by 180 degrees about the bisector of the x-axis and the glyph's direction.
  Glyphs direction;
  direction.Orient(vtkGlyph3DMapper::DIRECTION, { 1.0, 2.0, 2.0 });
  transform = AtSecond();
  transform->RotateWXYZ(180.0, 4.0, 2.0, 2.0);
  transform->Scale(Size, Size, Size);
  CheckLast(check, direction, 2, transform, 0.0, "direction");

  Glyphs backwards;
  backwards.Orient(vtkGlyph3DMapper::DIRECTION, { -1.0, 0.0, 0.0 });
  transform = AtSecond();
  transform->RotateY(180.0);
  transform->Scale(Size, Size, Size);
  CheckLast(check, backwards, 2, transform, 0.0, "direction against x");

  const double half = 0.5 * std::acos(-1.0) / 3.0;
  Glyphs quaternion;
  quaternion.Orient(vtkGlyph3DMapper::QUATERNION,
    { std::cos(half), 0.6 * std::sin(half), 0.0, 0.8 * std::sin(half) });
  transform = AtSecond();
  transform->RotateWXYZ(60.0, 0.6, 0.0, 0.8);
  transform->Scale(Size, Size, Size);
  CheckLast(check, quaternion, 2, transform, 0.0, "quaternion");

  Glyphs invalid;
  invalid.Orient(vtkGlyph3DMapper::QUATERNION, { 1.0, 2.0, 3.0 });
  check.That(invalid.GetCorners().empty(), "three-component quaternions create no glyphs");
}

void TestScales(Check& check)
{
  Glyphs scaled;
  scaled.AddArray("scale", { 1.0, 1.0, 1.0 }, { 1.0, 2.0, -2.0 });
  scaled.Mapper->SetScaleArray("scale");
  scaled.Mapper->SetScaleModeToScaleByMagnitude();
  auto transform = AtSecond();
  transform->Scale(3.0 * Size, 3.0 * Size, 3.0 * Size);
  CheckLast(check, scaled, 2, transform, 0.0, "scale by magnitude");
  scaled.Mapper->SetScaleModeToScaleByVectorComponents();
  transform = AtSecond();
  transform->Scale(Size, 2.0 * Size, -2.0 * Size);
  CheckLast(check, scaled, 2, transform, 0.0, "scale by components");
  scaled.Mapper->ClampingOn();
  scaled.Mapper->SetRange(0.5, 1.5);
  transform = AtSecond();
  transform->Scale(0.5 * Size, Size, 1e-10);
  CheckLast(check, scaled, 2, transform, 0.0, "clamped scale");
  scaled.Mapper->ScalingOff();
  CheckLast(check, scaled, 2, AtSecond(), 0.0, "no scale");
}

void TestChoice(Check& check)
{
  Glyphs chosen;
  chosen.AddArray("which", { 0.0 }, { 1.0 });
  chosen.Mapper->SetSourceIndexArray("which");
  chosen.Mapper->SourceIndexingOn();
  chosen.Mapper->SetRange(0.0, 2.0);
  auto transform = AtSecond();
  transform->Scale(Size, Size, Size);
  CheckLast(check, chosen, 2, transform, 10.0, "second source");
  vtkNew<vtkBitArray> mask;
  mask->SetName("mask");
  mask->InsertNextValue(0);
  mask->InsertNextValue(1);
  chosen.Points->GetPointData()->AddArray(mask);
  chosen.Mapper->SetMaskArray("mask");
  chosen.Mapper->MaskingOn();
  CheckLast(check, chosen, 1, transform, 10.0, "masked");
  chosen.Actor->SetPosition(5.0, 0.0, 0.0);
  transform->Identity();
  transform->Translate(6.0, 2.0, 3.0);
  transform->Scale(Size, Size, Size);
  CheckLast(check, chosen, 1, transform, 10.0, "moved actor");
}

void TestConcavePolygon(Check& check)
{
  // A triangle fan from the first vertex would leave the polygon at the concave vertex, which is
  // the second vertex.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(9.0, 9.0, 9.0);
  points->InsertNextPoint(4.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 4.0, 0.0);
  points->InsertNextPoint(1.0, 1.0, 0.0);
  vtkNew<vtkCellArray> cells;
  const std::array<vtkIdType, 4> ids{ { 1, 4, 3, 2 } };
  cells->InsertNextCell(4, ids.data());
  vtkNew<vtkPolyData> polygon;
  polygon->SetPoints(points);
  polygon->SetPolys(cells);
  Glyphs concave;
  concave.Mapper->SetSourceData(0, polygon);
  const std::vector<glm::dvec3> corners = concave.GetCorners();
  check.Equal(static_cast<long long>(corners.size()), 12LL, "two triangles per point");
  double area = 0.0;
  for (std::size_t i = 2; i < corners.size(); i += 3)
  {
    area +=
      0.5 * glm::length(glm::cross(corners[i - 1] - corners[i - 2], corners[i] - corners[i - 2]));
  }
  check.Near(area, 2.0 * 4.0 * Size * Size, 1e-12, "area of a concave polygon", 1.0);
}
}

int TestGlyphBlockers(int, char*[])
{
  Check check;
  TestOrientations(check);
  TestScales(check);
  TestChoice(check);
  TestConcavePolygon(check);
  return check.Result();
}
