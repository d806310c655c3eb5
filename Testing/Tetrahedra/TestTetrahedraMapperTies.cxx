// SPDX-License-Identifier: BSD-3-Clause
// Tests random meshes with almost or exactly coinciding points in the image, faces seen edge-on,
// and nearly flat tetrahedra. Also tests a random sequence of changes with one mapper.
#include "Support/Drawing/ImageCases.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Tetrahedra/MapperImage.h"
#include "Tetrahedra/PathComparison.h"

#include "vtkCamera.h"
#include "vtkCellType.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;

/// Maximum fraction of silhouette pixels that differ. It is large because the images are small and
/// many silhouettes are aligned with pixels.
constexpr double SilhouetteFraction = 0.02;

/// Adds point scalars `f`: a linear field plus noise.
void AddScalars(vtkUnstructuredGrid* grid, Random& random)
{
  const Point3 gradient = random.GetPoint(0.4);
  AddLinearArray(grid, "f", 0.5, gradient);
  // Without noise, interpolation in the wrong tetrahedron would have no effect.
  vtkDataArray* values = grid->GetPointData()->GetArray("f");
  for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
  {
    values->SetTuple1(id, std::clamp(values->GetTuple1(id) + random.Get(-0.2, 0.2), 0.0, 1.0));
  }
  grid->GetPointData()->SetActiveScalars("f");
}

/// Returns columns of triangular prisms along z, with three tetrahedra per prism. The base is a
/// square, triangulated with random interior points. The points of each layer are displaced in x
/// and y by up to \a shift. When seen along z, the layers nearly coincide, or exactly if \a shift
/// is 0.
vtkSmartPointer<vtkUnstructuredGrid> MakeColumns(
  int cells, const std::vector<double>& layers, double shift, Random& random)
{
  std::vector<std::array<double, 2>> base;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const bool isInner = i > 0 && i < cells && j > 0 && j < cells;
      const double offset = isInner ? 0.25 : 0.0;
      base.push_back({ { (i + random.Get(-offset, offset)) / cells,
        (j + random.Get(-offset, offset)) / cells } });
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (double z : layers)
  {
    for (const std::array<double, 2>& p : base)
    {
      points->InsertNextPoint(
        p[0] + shift * random.Get(-1.0, 1.0), p[1] + shift * random.Get(-1.0, 1.0), z);
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  const auto stride = static_cast<vtkIdType>(base.size());
  for (std::size_t layer = 0; layer + 1 < layers.size(); ++layer)
  {
    for (int cell = 0; cell < cells * cells; ++cell)
    {
      const vtkIdType a =
        static_cast<vtkIdType>(layer) * stride + cell / cells * (cells + 1) + cell % cells;
      const vtkIdType corners[2][3] = { { a, a + 1, a + cells + 2 },
        { a, a + cells + 1, a + cells + 2 } };
      for (const vtkIdType* c : corners)
      {
        // Split by ascending ids, which is consistent between neighbors.
        const vtkIdType tetrahedra[3][4] = { { c[0], c[1], c[2], c[2] + stride },
          { c[0], c[1], c[1] + stride, c[2] + stride },
          { c[0], c[0] + stride, c[1] + stride, c[2] + stride } };
        for (const vtkIdType* ids : tetrahedra)
        {
          grid->InsertNextCell(VTK_TETRA, 4, ids);
        }
      }
    }
  }
  AddScalars(grid, random);
  return grid;
}

/// Returns the z coordinates of layers. Every other layer is thinner by a random factor of up to
/// 10,000.
std::vector<double> MakeLayerPositions(int layers, Random& random)
{
  std::vector<double> positions = { 0.0 };
  for (int i = 0; i < layers; ++i)
  {
    positions.push_back(
      positions.back() + std::pow(10.0, i % 2 ? random.Get(-4.0, -1.0) : 0.0) / layers);
  }
  return positions;
}

ImageCase MakeCase(vtkUnstructuredGrid* grid, const std::array<int, 2>& size)
{
  ImageCase what;
  what.Grid = grid;
  what.Property =
    MakeProperty({ { 0.0, { { 0.1, 0.2, 0.9 } }, 0.0 }, { 0.4, { { 0.9, 0.9, 0.9 } }, 0.4 },
                   { 1.0, { { 1.0, 0.1, 0.0 } }, 1.0 } },
      0.2);
  what.Settings.Size = size;
  return what;
}

void TestColumns(Check& check, Random& random)
{
  // Displacements below, near and above the rounding error of single precision.
  for (double shift : { 0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3 })
  {
    const auto grid = MakeColumns(5, MakeLayerPositions(6, random), shift, random);
    ImageCase what = MakeCase(grid, { { 64, 48 } });
    for (bool parallel : { false, true })
    {
      for (const Point3& direction :
        { Point3{ { 0.0, 0.0, 1.0 } }, Point3{ { 0.0, 0.0, -1.0 } }, Point3{ { 1.0, 0.0, 0.0 } },
          Point3{ { 1.0, 1.0, 0.0 } }, Point3{ { 1.0, 1.0, 1.0 } } })
      {
        what.Camera = LookAt(grid, direction, parallel);
        CompareRenderPaths(what,
          "columns " + std::to_string(shift) + (parallel ? ", parallel" : ", perspective") +
            ", along " + std::to_string(direction[0]) + " " + std::to_string(direction[1]) + " " +
            std::to_string(direction[2]),
          check, SilhouetteFraction);
      }
    }
  }
}

/// Tests regular grids seen along axes, face diagonals and cell diagonals. Points are exact, or
/// displaced by about the rounding error of single precision or more.
void TestRegularGrids(Check& check, Random& random)
{
  const Point3 directions[] = { { { 1.0, 0.0, 0.0 } }, { { 0.0, -1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } }, { { 1.0, 1.0, 0.0 } }, { { 0.0, 1.0, -1.0 } }, { { 1.0, 1.0, 1.0 } },
    { { -1.0, 1.0, 1.0 } } };
  for (double shift : { 0.0, 1e-7, 1e-4 })
  {
    for (bool hasFive : { true, false })
    {
      auto grid = hasFive ? MakeCube(4) : MakeBox({ { 4, 4, 4 } });
      for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
      {
        double x[3];
        grid->GetPoint(id, x);
        const Point3 offset = random.GetPoint(shift);
        vtkMath::Add(x, offset.data(), x);
        grid->GetPoints()->SetPoint(id, x);
      }
      AddScalars(grid, random);
      // An image of odd size has a central pixel whose ray lies in faces. This is tested only with
      // exact points: displaced faces are not quite coplanar, so the ray may be on either side of
      // them, since the render paths and the reference round it differently.
      const bool isOdd = shift == 0.0;
      ImageCase what =
        MakeCase(grid, isOdd ? std::array<int, 2>{ { 61, 45 } } : std::array<int, 2>{ { 60, 44 } });
      for (const Point3& direction : directions)
      {
        for (bool parallel : { false, true })
        {
          what.Camera = LookAt(grid, direction, parallel);
          CompareRenderPaths(what,
            (hasFive ? "five per cube, moved by " : "six per cube, moved by ") +
              std::to_string(shift) + (parallel ? ", parallel" : ", perspective") + ", along " +
              std::to_string(direction[0]) + " " + std::to_string(direction[1]) + " " +
              std::to_string(direction[2]),
            check, SilhouetteFraction);
        }
      }
    }
  }
}

/// Tests that, after random changes of data, colors and camera, the image equals that of a new
/// mapper.
void TestChanges(Check& check, Random& random)
{
  const Point3 directions[] = { { { 1.0, 0.0, 0.0 } }, { { 0.0, -1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } }, { { 1.0, 1.0, 0.0 } }, { { 0.3, -0.4, 1.0 } } };
  for (int path : AllRenderPaths())
  {
    vtkNew<Mapper> reused;
    reused->SetRenderPath(path);
    reused->AutoAdjustLevelOfDetailOff();
    ImageCase what = MakeCase(MakeCube(3), { { 40, 40 } });
    what.Camera = LookAt(what.Grid, directions[0], false);
    for (int step = 0; step < 30; ++step)
    {
      const auto change = static_cast<int>(random.Get(0.0, 4.0));
      if (change == 0)
      {
        what.Grid = MakeColumns(3, MakeLayerPositions(3, random), 1e-7, random);
      }
      else if (change == 1)
      {
        what.Property = MakeRamp(random.Get(0.0, 0.3), random.Get(0.5, 1.0), 0.2);
      }
      else if (change == 2)
      {
        what.Settings.How =
          what.Settings.How == Blend::Composite ? Blend::OpticalDepth : Blend::Composite;
      }
      what.Camera = LookAt(
        what.Grid, directions[static_cast<int>(random.Get(0.0, 5.0))], random.Get(0.0, 1.0) < 0.5);
      const RgbaImage found = DrawByMapper(reused, what);
      const RgbaImage fresh = DrawByPath(path, what);
      check.Near(CompareImages(found, fresh).Max, 0.0, 0.0,
        GetPathName(path) + ": step " + std::to_string(step) + " differs from a new mapper", 1.0);
    }
  }
}

}

int TestTetrahedraMapperTies(int, char*[])
{
  Check check;
  Random random(16);
  TestColumns(check, random);
  TestRegularGrids(check, random);
  TestChanges(check, random);
  return check.Result();
}
