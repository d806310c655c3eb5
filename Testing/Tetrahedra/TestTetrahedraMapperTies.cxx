// SPDX-License-Identifier: BSD-3-Clause
// Meshes at random whose points coincide on the screen, or nearly so, whose faces are seen edge-on
// and whose tetrahedra are nearly flat; and one mapper through a sequence of changes at random.
#include "Support/Drawing/PictureCases.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Tetrahedra/MapperPicture.h"
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

/// Small pictures of few tetrahedra, whose silhouettes are made to line up with pixels.
constexpr double ShareOfSilhouettes = 0.02;

/// The point scalars `f`: linear, and a part at random.
void AddScalars(vtkUnstructuredGrid* grid, Random& random)
{
  const Point3 gradient = random.GetPoint(0.4);
  AddLinear(grid, "f", 0.5, gradient);
  // Values that are not linear over the mesh show what is taken from beyond a tetrahedron.
  vtkDataArray* values = grid->GetPointData()->GetArray("f");
  for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
  {
    values->SetTuple1(id, std::clamp(values->GetTuple1(id) + random.Get(-0.2, 0.2), 0.0, 1.0));
  }
  grid->GetPointData()->SetActiveScalars("f");
}

/// Columns of triangular prisms along z, three tetrahedra each, over a triangulated square with its
/// points moved aside at random. Each layer's points are moved aside by up to \a shift more, so
/// that those of a column nearly coincide seen along z; with 0 they do.
vtkSmartPointer<vtkUnstructuredGrid> MakeColumns(
  int cells, const std::vector<double>& layers, double shift, Random& random)
{
  std::vector<std::array<double, 2>> base;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const bool isInner = i > 0 && i < cells && j > 0 && j < cells;
      const double aside = isInner ? 0.25 : 0.0;
      base.push_back(
        { { (i + random.Get(-aside, aside)) / cells, (j + random.Get(-aside, aside)) / cells } });
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
        // Cut by ascending ids, on which neighbours agree.
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

/// Layers at random, every other one down to a ten thousandth as thick.
std::vector<double> MakeLayerPlaces(int layers, Random& random)
{
  std::vector<double> places = { 0.0 };
  for (int i = 0; i < layers; ++i)
  {
    places.push_back(places.back() + std::pow(10.0, i % 2 ? random.Get(-4.0, -1.0) : 0.0) / layers);
  }
  return places;
}

PictureCase MakeCase(vtkUnstructuredGrid* grid, const std::array<int, 2>& size)
{
  PictureCase what;
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
  // As far as single precision of coordinates, and around it.
  for (double shift : { 0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3 })
  {
    const auto grid = MakeColumns(5, MakeLayerPlaces(6, random), shift, random);
    PictureCase what = MakeCase(grid, { { 64, 48 } });
    for (bool parallel : { false, true })
    {
      for (const Point3& direction :
        { Point3{ { 0.0, 0.0, 1.0 } }, Point3{ { 0.0, 0.0, -1.0 } }, Point3{ { 1.0, 0.0, 0.0 } },
          Point3{ { 1.0, 1.0, 0.0 } }, Point3{ { 1.0, 1.0, 1.0 } } })
      {
        what.Camera = LookAt(grid, direction, parallel);
        ComparePaths(what,
          "columns " + std::to_string(shift) + (parallel ? ", parallel" : ", perspective") +
            ", along " + std::to_string(direction[0]) + " " + std::to_string(direction[1]) + " " +
            std::to_string(direction[2]),
          check, ShareOfSilhouettes);
      }
    }
  }
}

/// Lattices seen along axes, diagonals of faces and of cells, as they are and with points moved
/// aside by rounding of single precision and more.
void TestLattices(Check& check, Random& random)
{
  const Point3 directions[] = { { { 1.0, 0.0, 0.0 } }, { { 0.0, -1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } }, { { 1.0, 1.0, 0.0 } }, { { 0.0, 1.0, -1.0 } }, { { 1.0, 1.0, 1.0 } },
    { { -1.0, 1.0, 1.0 } } };
  for (double shift : { 0.0, 1e-7, 1e-4 })
  {
    for (bool isOfFive : { true, false })
    {
      auto grid = isOfFive ? MakeCube(4) : MakeBox({ { 4, 4, 4 } });
      for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
      {
        double x[3];
        grid->GetPoint(id, x);
        const Point3 aside = random.GetPoint(shift);
        vtkMath::Add(x, aside.data(), x);
        grid->GetPoints()->SetPoint(id, x);
      }
      AddScalars(grid, random);
      // Odd sizes have a pixel in the middle, whose line of sight lies in faces. Where those are
      // not quite planar it says nothing, since paths and reference pass it as far aside as the
      // points.
      const bool isOdd = shift == 0.0;
      PictureCase what =
        MakeCase(grid, isOdd ? std::array<int, 2>{ { 61, 45 } } : std::array<int, 2>{ { 60, 44 } });
      for (const Point3& direction : directions)
      {
        for (bool parallel : { false, true })
        {
          what.Camera = LookAt(grid, direction, parallel);
          ComparePaths(what,
            (isOfFive ? "five a cube, moved by " : "six a cube, moved by ") +
              std::to_string(shift) + (parallel ? ", parallel" : ", perspective") + ", along " +
              std::to_string(direction[0]) + " " + std::to_string(direction[1]) + " " +
              std::to_string(direction[2]),
            check, ShareOfSilhouettes);
        }
      }
    }
  }
}

/// Changes of data, colours and camera in any order: always as a new mapper draws.
void TestChanges(Check& check, Random& random)
{
  const Point3 directions[] = { { { 1.0, 0.0, 0.0 } }, { { 0.0, -1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } }, { { 1.0, 1.0, 0.0 } }, { { 0.3, -0.4, 1.0 } } };
  for (int path : AllRenderPaths())
  {
    vtkNew<Mapper> kept;
    kept->SetRenderPath(path);
    kept->AutoAdjustLevelOfDetailOff();
    PictureCase what = MakeCase(MakeCube(3), { { 40, 40 } });
    what.Camera = LookAt(what.Grid, directions[0], false);
    for (int step = 0; step < 30; ++step)
    {
      const auto change = static_cast<int>(random.Get(0.0, 4.0));
      if (change == 0)
      {
        what.Grid = MakeColumns(3, MakeLayerPlaces(3, random), 1e-7, random);
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
      const RgbaPicture found = DrawByMapper(kept, what);
      const RgbaPicture fresh = DrawByPath(path, what);
      check.Near(ComparePictures(found, fresh).Max, 0.0, 0.0,
        GetPathName(path) + ": step " + std::to_string(step) + " as a fresh mapper", 1.0);
    }
  }
}

}

int TestTetrahedraMapperTies(int, char*[])
{
  Check check;
  Random random(16);
  TestColumns(check, random);
  TestLattices(check, random);
  TestChanges(check, random);
  return check.Result();
}
