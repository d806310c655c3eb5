// SPDX-License-Identifier: BSD-3-Clause
// Tests boundary triangles in the volume: opaque ones against vtkPolyDataMapper, a translucent face
// inside a slab against a formula, textures, and points that match by position.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/LargestError.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/ReferenceRay.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <set>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;

constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };
constexpr Point3 FaceOn = { { 0.0, 0.0, 1.0 } };
constexpr Point3 FaceColor = { { 0.2, 0.6, 0.9 } };
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<int, 2> Size = { { 96, 80 } };

/// Returns all distinct faces of tetrahedra whose three points are on the same plane. \a planeOf
/// returns the index of the plane through a point and perpendicular to an axis, or -1.
vtkSmartPointer<vtkPolyData> MakeFaces(
  vtkUnstructuredGrid* grid, const std::function<int(const double*, int)>& planeOf)
{
  vtkNew<vtkCellArray> triangles;
  std::set<std::set<vtkIdType>> known;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    grid->GetCellPoints(cell, size, corners);
    for (int opposite = 0; opposite < 4; ++opposite)
    {
      const vtkIdType ids[3] = { corners[(opposite + 1) % 4], corners[(opposite + 2) % 4],
        corners[(opposite + 3) % 4] };
      for (int axis = 0; axis < 3; ++axis)
      {
        std::set<int> planes;
        for (vtkIdType id : ids)
        {
          double x[3];
          grid->GetPoint(id, x);
          planes.insert(planeOf(x, axis));
        }
        const bool isFace = planes.size() == 1 && *planes.begin() >= 0;
        if (isFace && known.insert({ ids[0], ids[1], ids[2] }).second)
        {
          triangles->InsertNextCell(3, ids);
        }
      }
    }
  }
  auto faces = vtkSmartPointer<vtkPolyData>::New();
  faces->SetPoints(grid->GetPoints());
  faces->SetPolys(triangles);
  return faces;
}

/// Returns the six faces of the unit cube as triangles.
vtkSmartPointer<vtkPolyData> MakeSides(vtkUnstructuredGrid* grid)
{
  return MakeFaces(
    grid, [](const double* x, int axis) { return x[axis] == 0.0 ? 0
                                            : x[axis] == 1.0    ? 1
                                                                : -1; });
}

/// Returns the faces of tetrahedra in the plane z = 1/2.
vtkSmartPointer<vtkPolyData> MakeMidplane(vtkUnstructuredGrid* grid)
{
  return MakeFaces(
    grid, [](const double* x, int axis) { return axis == 2 && x[axis] == 0.5 ? 0 : -1; });
}

void MakeFlat(vtkProperty* property, const Point3& color, double opacity)
{
  property->SetColor(color[0], color[1], color[2]);
  property->SetAmbient(1.0);
  property->SetDiffuse(0.0);
  property->SetSpecular(0.0);
  property->SetOpacity(opacity);
}

/// A mapper with boundary triangles.
struct Surface
{
  vtkNew<Mapper> Drawer;
  vtkNew<vtkProperty> Property;

  Surface(int path, vtkDataSet* triangles, double opacity, const Point3& color = FaceColor)
  {
    MakeFlat(this->Property, color, opacity);
    this->Drawer->SetRenderPath(path);
    this->Drawer->SetBoundaryData(triangles);
    this->Drawer->SetBoundaryProperty(this->Property);
  }
};

std::string GetName(int path, bool parallel)
{
  return GetPathName(path) + (parallel ? ", parallel" : ", perspective");
}

/// Renders the triangles with vtkPolyDataMapper.
RgbaImage DrawTriangles(
  vtkPolyData* triangles, vtkCamera* camera, const Point3& color, vtkTexture* texture)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(triangles);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  MakeFlat(actor->GetProperty(), color, 1.0);
  vtkNew<Mapper> emptyMapper;
  emptyMapper->SetInputData(static_cast<vtkDataSet*>(vtkNew<vtkUnstructuredGrid>()));
  VolumeStage stage(Size);
  stage.SetVolume(emptyMapper, MakeRamp(0.0, 1.0));
  stage.AddActor(actor);
  stage.SetCamera(camera);
  return stage.Capture();
}

/// Compares those pixels for which \a grid covers the pixel and its eight neighbors.
void ExpectInside(Check& check, vtkUnstructuredGrid* grid, vtkCamera* camera,
  const RgbaImage& found, const RgbaImage& expected, const std::string& name)
{
  const PixelRays rays(camera, Size);
  int inside = 0;
  double largest = 0.0;
  for (int j = 1; j + 1 < Size[1]; ++j)
  {
    for (int i = 1; i + 1 < Size[0]; ++i)
    {
      bool isInside = true;
      for (int k = 0; k < 9; ++k)
      {
        isInside = isInside && GetChordLength(grid, rays.Get(i + k % 3 - 1, j + k / 3 - 1)) > 0.0;
      }
      for (int k = 0; k < 4 && isInside; ++k)
      {
        const double difference = std::abs(found.At(i, j)[k] - expected.At(i, j)[k]);
        reference::KeepLargest(largest, difference);
      }
      inside += isInside ? 1 : 0;
    }
  }
  std::cout << name << ": " << largest << " in " << inside << " pixels\n";
  check.That(inside > 1000, name + ": the cube is visible");
  check.Near(largest, 0.0, 1e-3, name, 1.0);
}

void TestOpaque(Check& check, int path, bool parallel)
{
  const ImageCase what = MakeCase(MakeCube(4), MakeRamp(0.1, 1.0, 0.25), Slanted, parallel, Size);
  auto sides = MakeSides(what.Grid);
  check.Equal(sides->GetNumberOfCells(), 6 * 4 * 4 * 2, "triangles of the cube's sides");
  Surface surface(path, sides, 1.0);
  const std::string name = GetName(path, parallel) + ", opaque sides";
  const RgbaImage found = DrawByMapper(surface.Drawer, what);
  check.Equal(surface.Drawer->GetReport()->GetCount("BoundaryTriangles"), sides->GetNumberOfCells(),
    name + ": triangles");
  ExpectInside(check, what.Grid, what.Camera, found,
    DrawTriangles(sides, what.Camera, FaceColor, nullptr), name);
}

/// Tests that triangles are lit on the visible side for both directions of their normals.
void TestBothSides(Check& check, int path)
{
  const ImageCase what = MakeCase(MakeCube(4), MakeRamp(0.0, 1.0, 0.25), Slanted, false, Size);
  RgbaImage images[2];
  double brightest = 0.0;
  for (const int side : { 0, 1 })
  {
    const auto midplane = MakeMidplane(what.Grid);
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (vtkIdType id = 0; id < midplane->GetNumberOfPoints(); ++id)
    {
      normals->InsertNextTuple3(0.0, 0.0, side == 0 ? 1.0 : -1.0);
    }
    midplane->GetPointData()->SetNormals(normals);
    Surface surface(path, midplane, 1.0);
    surface.Property->SetAmbient(0.0);
    surface.Property->SetDiffuse(1.0);
    images[side] = DrawByMapper(surface.Drawer, what);
    brightest = std::max(brightest, images[side].At(Size[0] / 2, Size[1] / 2)[2]);
  }
  const std::string name = GetPathName(path) + ", normals away from the camera";
  check.That(brightest > 0.5, name + ": the face is lit");
  check.Near(CompareImages(images[1], images[0]).Max, 0.0, 1e-6, name, 1.0);
}

/// Returns a texture whose left and right halves have different colors. Adds the x and y
/// coordinates of the points as texture coordinates.
vtkSmartPointer<vtkTexture> MakeTexture(vtkPolyData* triangles)
{
  constexpr int width = 64;
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 2 * width; ++i)
  {
    auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(i % width, i / width, 0));
    const bool isLeft = i % width < width / 2;
    pixel[0] = isLeft ? 255 : 51;
    pixel[1] = isLeft ? 102 : 204;
    pixel[2] = isLeft ? 0 : 255;
  }
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType id = 0; id < triangles->GetNumberOfPoints(); ++id)
  {
    double x[3];
    triangles->GetPoint(id, x);
    coordinates->InsertNextTuple(x);
  }
  triangles->GetPointData()->SetTCoords(coordinates);
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->RepeatOff();
  texture->InterpolateOn();
  return texture;
}

void TestTexture(Check& check, int path, bool parallel)
{
  const ImageCase what = MakeCase(MakeLayers(4, { 0.0, 0.5, 1.0 }),
    MakeProperty({ { 0.0, { { 1.0, 1.0, 1.0 } }, 0.0 } }), FaceOn, parallel, Size);
  auto midplane = MakeMidplane(what.Grid);
  auto texture = MakeTexture(midplane);
  Surface surface(path, midplane, 0.5);
  surface.Drawer->SetBoundaryTexture(texture);
  const RgbaImage found = DrawByMapper(surface.Drawer, what);
  const std::string name = GetName(path, parallel) + ", textured";
  const PixelRays rays(what.Camera, Size);
  const Point3 halves[2] = { { { 1.0, 0.4, 0.0 } }, { { 0.2, 0.8, 1.0 } } };
  int seen[2] = { 0, 0 };
  for (const auto& [j, i] : AllIndices(Size[1], Size[0]))
  {
    const Ray ray = rays.Get(i, j);
    const Real distance = (Real(0.5) - ray.Origin[2]) / ray.Direction[2];
    const auto u = static_cast<double>(ray.Origin[0] + distance * ray.Direction[0]);
    const auto v = static_cast<double>(ray.Origin[1] + distance * ray.Direction[1]);
    const bool isWithin = u > 0.02 && u < 0.98 && v > 0.02 && v < 0.98;
    if (isWithin && std::abs(u - 0.5) > 0.02)
    {
      const int half = u < 0.5 ? 0 : 1;
      ++seen[half];
      for (int k = 0; k < 3; ++k)
      {
        check.Near(found.At(i, j)[k], 0.5 * halves[half][k] * FaceColor[k], 1e-3, name, 1.0);
      }
      check.Near(found.At(i, j)[3], 0.5, 1e-3, name + ", alpha", 1.0);
    }
  }
  check.That(seen[0] > 500 && seen[1] > 500, name + ": both halves are visible");
}

/// A texture of a ramp along x with a checkerboard of single pixels.
struct Checkerboard
{
  std::array<int, 2> Dimensions;

  static constexpr double First = 0.25;
  static constexpr double Rise = 0.5;
  static constexpr double Contrast = 0.2;

  vtkSmartPointer<vtkTexture> MakeTexture() const
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(this->Dimensions[0], this->Dimensions[1], 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (const auto& [j, i] : AllIndices(this->Dimensions[1], this->Dimensions[0]))
    {
      const double value =
        First + Rise * (i + 0.5) / this->Dimensions[0] + ((i + j) % 2 == 0 ? Contrast : -Contrast);
      *static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0)) =
        static_cast<unsigned char>(std::lround(255.0 * value));
    }
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(image);
    texture->RepeatOff();
    texture->InterpolateOn();
    texture->MipmapOn();
    return texture;
  }

  /// Returns the value between pixel centers, \a texels from pixel to pixel of the screen.
  /// Interpolation to the next mipmap level removes the checkerboard.
  double GetValue(const std::array<double, 2>& at, double texels) const
  {
    double wave = Contrast * std::max(0.0, 1.0 - std::max(0.0, std::log2(texels)));
    for (int axis = 0; axis < 2; ++axis)
    {
      const double x = at[axis] * this->Dimensions[axis] - 0.5;
      wave *= std::abs(2.0 * (x - 2.0 * std::floor(0.5 * x) - 1.0)) - 1.0;
    }
    return First + Rise * at[0] + wave;
  }
};

/// Tests that details of a texture that are smaller than a pixel fade to their mean.
void TestMipmaps(Check& check, int path, bool parallel, const Point3& direction)
{
  const ImageCase what = MakeCase(MakeLayers(4, { 0.0, 0.5, 1.0 }),
    MakeProperty({ { 0.0, { { 1.0, 1.0, 1.0 } }, 0.0 } }), direction, parallel, Size);
  auto midplane = MakeMidplane(what.Grid);
  MakeTexture(midplane);
  const PixelRays rays(what.Camera, Size);
  const auto locate = [&rays](int i, int j)
  {
    const Ray ray = rays.Get(i, j);
    const Real distance = (Real(0.5) - ray.Origin[2]) / ray.Direction[2];
    return std::array<double, 2>{ { static_cast<double>(
                                      ray.Origin[0] + distance * ray.Direction[0]),
      static_cast<double>(ray.Origin[1] + distance * ray.Direction[1]) } };
  };
  std::array<int, 3> seen{};
  for (const Checkerboard& board : { Checkerboard{ { { 24, 20 } } }, Checkerboard{ { { 77, 64 } } },
         Checkerboard{ { { 301, 190 } } } })
  {
    Surface surface(path, midplane, 1.0, { { 1.0, 1.0, 1.0 } });
    surface.Drawer->SetBoundaryTexture(board.MakeTexture());
    const RgbaImage found = DrawByMapper(surface.Drawer, what);
    const std::string name =
      GetName(path, parallel) + ", mipmaps of " + std::to_string(board.Dimensions[0]) + " pixels";
    double largest = 0.0;
    for (int j = 1; j + 1 < Size[1]; ++j)
    {
      for (int i = 1; i + 1 < Size[0]; ++i)
      {
        const std::array<double, 2> at = locate(i, j);
        const auto getTexels = [&](int di, int dj)
        {
          const auto before = locate(i - di, j - dj);
          const auto after = locate(i + di, j + dj);
          return 0.5 *
            std::hypot((after[0] - before[0]) * board.Dimensions[0],
              (after[1] - before[1]) * board.Dimensions[1]);
        };
        const double texels = std::max(getTexels(1, 0), getTexels(0, 1));
        if (std::min(at[0], at[1]) > 0.1 && std::max(at[0], at[1]) < 0.9)
        {
          ++seen[texels <= 1.0 ? 0 : texels < 2.0 ? 1 : 2];
          KeepLargest(largest, std::abs(found.At(i, j)[0] - board.GetValue(at, texels)));
        }
      }
    }
    std::cout << name << ": " << largest << "\n";
    check.Near(largest, 0.0, 2e-3, name, 1.0);
  }
  check.That(*std::min_element(seen.begin(), seen.end()) > 300,
    GetName(path, parallel) + ": pixels for all kinds of levels");
}

/// Tests color and alpha of a slab from z = 0 to 1 with boundary triangles at z = 1/2. If \a cut is
/// not negative, the view is along z and the near plane is at z = \a cut.
void TestSlab(Check& check, int path, bool parallel, const Point3& direction, double opacity,
  vtkDataSet* faces, vtkUnstructuredGrid* grid, const std::string& kind, double cut = -1.0)
{
  constexpr double extinction = 1.5;
  const Point3 slab = { { 0.9, 0.5, 0.1 } };
  const ImageCase what =
    MakeCase(grid, MakeProperty({ { 0.0, slab, extinction } }), direction, parallel, Size);
  if (cut >= 0.0)
  {
    const double distance = what.Camera->GetDistance();
    what.Camera->SetClippingRange(distance - 0.5 + cut, 2.0 * distance);
  }
  const double front = 0.5 - std::min(std::max(cut, 0.0), 0.5);
  const double back = 1.0 - std::max(cut, 0.5);
  const double faceOpacity = cut < 0.5 ? opacity : 0.0;
  Surface surface(path, faces, opacity);
  const RgbaImage found = DrawByMapper(surface.Drawer, what);
  const std::string name =
    GetName(path, parallel) + ", " + kind + ", opacity " + std::to_string(opacity);
  check.Equal(surface.Drawer->GetReport()->GetCount("BoundaryTriangles"), faces->GetNumberOfCells(),
    name + ": triangles");
  check.Equal(
    surface.Drawer->GetReport()->GetCount("UnmatchedTriangles"), 0, name + ": unmatched triangles");
  const PixelRays rays(what.Camera, Size);
  int inside = 0;
  double largest = 0.0;
  for (const auto& [j, i] : AllIndices(Size[1], Size[0]))
  {
    const Ray ray = rays.Get(i, j);
    const double chord = GetChordLength(grid, ray);
    const double height = chord * std::abs(static_cast<double>(ray.Direction[2]));
    // Use only rays through the faces z = 0 and z = 1 of the slab.
    if (std::abs(height - 1.0) < 1e-9)
    {
      ++inside;
      const double first = -std::expm1(-front * extinction * chord);
      const double second = -std::expm1(-back * extinction * chord);
      const double afterFront = 1.0 - first;
      const double afterFace = afterFront * (1.0 - faceOpacity);
      for (int k = 0; k < 4; ++k)
      {
        const double volume = k < 3 ? slab[k] : 1.0;
        const double face = k < 3 ? FaceColor[k] : 1.0;
        const double expected =
          first * volume + afterFront * faceOpacity * face + afterFace * second * volume;
        const double difference = std::abs(found.At(i, j)[k] - expected);
        reference::KeepLargest(largest, difference);
      }
    }
  }
  std::cout << name << ": " << largest << " in " << inside << " pixels\n";
  check.That(inside > 300, name + ": the slab is visible");
  // Thin remainders of tetrahedra cut by the near plane have larger errors, up to the mapper's
  // general bound.
  check.Near(largest, 0.0, cut < 0.0 ? 1e-4 : 1e-3, name, 1.0);
}

/// Returns the faces with only the points that they use, in double precision.
vtkSmartPointer<vtkUnstructuredGrid> Compact(vtkPolyData* faces)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->Allocate(faces->GetNumberOfCells());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::map<vtkIdType, vtkIdType> newIds;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < faces->GetNumberOfCells(); ++cell)
  {
    faces->GetCellPoints(cell, corners);
    for (vtkIdType& corner : *corners)
    {
      const auto entry = newIds.emplace(corner, points->GetNumberOfPoints());
      if (entry.second)
      {
        points->InsertNextPoint(faces->GetPoint(corner));
      }
      corner = entry.first->second;
    }
    grid->InsertNextCell(faces->GetCellType(cell), corners);
  }
  grid->SetPoints(points);
  return grid;
}

void TestFaces(Check& check, int path, bool parallel)
{
  auto grid = MakeLayers(4, { 0.0, 0.25, 0.5, 1.0 });
  auto midplane = MakeMidplane(grid);
  check.Equal(midplane->GetNumberOfCells(), 4 * 4 * 2, "triangles of the midplane");
  for (double opacity : { 0.0, 0.3, 1.0 })
  {
    TestSlab(check, path, parallel, FaceOn, opacity, midplane, grid, "face-on");
    TestSlab(check, path, parallel, Slanted, opacity, midplane, grid, "slanted");
  }
  TestSlab(check, path, parallel, { { 0.2, 0.1, -1.0 } }, 0.4, midplane, grid, "from behind");
  for (double cut : { 0.1, 0.4, 0.6, 0.9 })
  {
    TestSlab(check, path, parallel, FaceOn, 0.3, midplane, grid,
      "near plane at " + std::to_string(cut), cut);
  }
  auto compact = Compact(midplane);
  check.Equal(compact->GetNumberOfPoints(), 5 * 5, "points of the compacted triangles");
  TestSlab(check, path, parallel, Slanted, 0.3, compact, grid, "compacted points");
}

/// Tests that triangles that are not faces of tetrahedra are reported as unmatched, even if they
/// use points of the mesh.
void TestUnmatched(Check& check, int path)
{
  const ImageCase what = MakeCase(MakeCube(2), MakeRamp(0.1, 1.0), Slanted, true, { { 64, 64 } });
  auto sides = MakeSides(what.Grid);
  const vtkIdType matched = sides->GetNumberOfCells();
  // A triangle through the interior of the cube.
  sides->GetPolys()->InsertNextCell({ 0, 2, 26 });
  Surface surface(path, sides, 0.5);
  DrawByMapper(surface.Drawer, what);
  const std::string name = GetPathName(path);
  check.Equal(
    surface.Drawer->GetReport()->GetCount("BoundaryTriangles"), matched, name + ": matched");
  check.Equal(surface.Drawer->GetReport()->GetCount("UnmatchedTriangles"), 1, name + ": unmatched");

  auto compact = Compact(sides);
  double x[3];
  compact->GetPoint(compact->GetNumberOfPoints() - 1, x);
  compact->GetPoints()->SetPoint(compact->GetNumberOfPoints() - 1, x[0], x[1], x[2] + 1e-3);
  vtkIdType moved = 0;
  for (vtkIdType cell = 0; cell < compact->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    compact->GetCellPoints(cell, size, corners);
    moved +=
      std::set<vtkIdType>(corners, corners + size).count(compact->GetNumberOfPoints() - 1) ? 1 : 0;
  }
  Surface other(path, compact, 0.5);
  DrawByMapper(other.Drawer, what);
  const vtkIdType found = other.Drawer->GetReport()->GetNumber("BoundaryTriangles");
  const vtkIdType unmatched = other.Drawer->GetReport()->GetNumber("UnmatchedTriangles");
  check.Equal(
    found + unmatched, compact->GetNumberOfCells(), name + ": all triangles are reported");
  check.That(moved > 1 && unmatched >= moved && unmatched <= moved + 1,
    name + ": triangles at the moved point are unmatched");
}

/// Tests that, after changing triangles, properties and textures, the image equals that of a new
/// mapper.
void TestChanges(Check& check, int path)
{
  ImageCase what;
  what.Grid = MakeCube(2);
  what.Property = MakeRamp(0.1, 1.0);
  what.Settings.Size = Size;
  auto sides = MakeSides(what.Grid);
  auto midplane = MakeMidplane(what.Grid);
  auto texture = MakeTexture(sides);
  Surface changed(path, sides, 0.3);
  VolumeStage stage(Size);
  stage.SetVolume(changed.Drawer, what.Property);
  RgbaImage before(Size[0], Size[1]);
  const auto expect = [&](const std::string& step, vtkDataSet* triangles)
  {
    what.Camera->SetClippingRange(1.0, 20.0);
    Configure(changed.Drawer, what);
    stage.SetCamera(what.Camera);
    const RgbaImage found = stage.Capture();
    vtkNew<Mapper> fresh;
    fresh->SetRenderPath(path);
    fresh->SetBoundaryData(triangles);
    fresh->SetBoundaryProperty(changed.Property);
    fresh->SetBoundaryTexture(changed.Drawer->GetBoundaryTexture());
    const std::string name = GetPathName(path) + ", changed: " + step;
    // Do not share the property: the second volume would modify it.
    ImageCase other = what;
    other.Property = MakeRamp(0.1, 1.0);
    check.Near(CompareImages(found, DrawByMapper(fresh, other)).Max, 0.0, 1e-6,
      name + ", difference from a new mapper", 1.0);
    check.That(CompareImages(found, before).Max > 0.01, name + ", the image changes");
    before = found;
  };
  what.Camera = LookAt(what.Grid, Slanted, true);
  expect("nothing", sides);
  changed.Property->SetOpacity(0.8);
  expect("opacity", sides);
  changed.Property->SetColor(0.9, 0.2, 0.1);
  expect("color", sides);
  changed.Property->SetDiffuse(0.9);
  changed.Property->SetAmbient(0.1);
  changed.Property->SetSpecular(0.5);
  expect("light", sides);
  what.Camera = LookAt(what.Grid, { { -0.8, 0.3, 0.6 } }, false);
  expect("camera", sides);
  changed.Drawer->SetBoundaryTexture(texture);
  expect("texture", sides);
  auto* pixels =
    vtkUnsignedCharArray::SafeDownCast(texture->GetInput()->GetPointData()->GetScalars());
  pixels->FillValue(128);
  texture->GetInput()->Modified();
  expect("image", sides);
  changed.Drawer->SetBoundaryTexture(nullptr);
  expect("no texture", sides);
  changed.Drawer->SetBoundaryData(midplane);
  expect("other triangles", midplane);
  what.Settings.How = Blend::Additive;
  expect("additive", midplane);
  what.Settings.How = Blend::Composite;
  expect("composite", midplane);
  changed.Drawer->SetBoundaryData(nullptr);
  expect("no triangles", nullptr);
}

/// Returns the faces in the planes z = 1/4, 1/2 and 3/4, with the cell array "surface": 7, -3
/// and 99.
vtkSmartPointer<vtkPolyData> MakePlanes(vtkUnstructuredGrid* grid)
{
  auto planes = MakeFaces(grid,
    [](const double* x, int axis)
    {
      const double plane = 4.0 * x[axis];
      return axis == 2 && (plane == 1.0 || plane == 2.0 || plane == 3.0) ? static_cast<int>(plane)
                                                                         : -1;
    });
  vtkNew<vtkIntArray> ids;
  ids->SetName("surface");
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < planes->GetNumberOfCells(); ++cell)
  {
    planes->GetCellPoints(cell, corners);
    const double z = planes->GetPoint(corners->GetId(0))[2];
    ids->InsertNextValue(z < 0.3 ? 7 : z < 0.6 ? -3 : 99);
  }
  planes->GetCellData()->AddArray(ids);
  return planes;
}

/// Tests color and alpha of a slab with three nested translucent planes of different colors,
/// opacities and textures against the integral along each ray.
void TestMaterials(Check& check, int path, bool parallel, const Point3& direction)
{
  constexpr double extinction = 1.2;
  const Point3 slab = { { 0.9, 0.5, 0.1 } };
  auto grid = MakeLayers(4, { 0.0, 0.25, 0.5, 0.75, 1.0 });
  const ImageCase what =
    MakeCase(grid, MakeProperty({ { 0.0, slab, extinction } }), direction, parallel, Size);
  auto planes = MakePlanes(grid);
  auto texture = MakeTexture(planes);
  const Point3 colors[3] = { { { 1.0, 0.2, 0.4 } }, { { 0.5, 1.0, 0.8 } }, FaceColor };
  const double opacities[3] = { 0.35, 0.6, 0.25 };
  // Each part has all points of the grid. Those that it does not use have other coordinates.
  vtkNew<vtkAppendPolyData> append;
  for (const bool isLast : { false, true })
  {
    auto part = vtkSmartPointer<vtkPolyData>::New();
    part->DeepCopy(planes);
    for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
    {
      if (isLast != (part->GetCellData()->GetArray("surface")->GetComponent(cell, 0) == 99.0))
      {
        part->DeleteCell(cell);
      }
    }
    part->RemoveDeletedCells();
    if (isLast)
    {
      part->GetPointData()->GetTCoords()->Fill(0.0);
    }
    append->AddInputData(part);
  }
  append->Update();
  Surface surface(path, append->GetOutput(), opacities[2]);
  vtkNew<vtkProperty> properties[2];
  for (int i = 0; i < 2; ++i)
  {
    MakeFlat(properties[i], colors[i], opacities[i]);
    surface.Drawer->SetBoundaryProperty(i == 0 ? 7 : -3, properties[i]);
  }
  surface.Drawer->SetBoundaryTexture(-3, texture);
  surface.Drawer->SetBoundaryIdArrayName("surface");
  const RgbaImage found = DrawByMapper(surface.Drawer, what);
  const std::string name = GetName(path, parallel) + ", materials";
  check.Equal(surface.Drawer->GetReport()->GetCount("BoundaryTriangles"), 3 * 4 * 4 * 2,
    name + ": triangles");
  const PixelRays rays(what.Camera, Size);
  const Point3 halves[2] = { { { 1.0, 0.4, 0.0 } }, { { 0.2, 0.8, 1.0 } } };
  int inside = 0;
  int off = 0;
  for (const auto& [j, i] : AllIndices(Size[1], Size[0]))
  {
    const Ray ray = rays.Get(i, j);
    const double chord = GetChordLength(grid, ray);
    const Real distance = (Real(0.5) - ray.Origin[2]) / ray.Direction[2];
    const auto u = static_cast<double>(ray.Origin[0] + distance * ray.Direction[0]);
    // Use only rays through both faces of the slab, away from the edge of the texture.
    if (std::abs(chord * std::abs(static_cast<double>(ray.Direction[2])) - 1.0) > 1e-9 ||
      std::abs(u - 0.5) < 0.02)
    {
      continue;
    }
    ++inside;
    const bool isReversed = ray.Direction[2] < Real(0);
    std::array<double, 4> expected{ { 0.0, 0.0, 0.0, 0.0 } };
    const auto add = [&](const Point3& color, double opacity)
    {
      const double share = (1.0 - expected[3]) * opacity;
      for (int k = 0; k < 3; ++k)
      {
        expected[k] += share * color[k];
      }
      expected[3] += share;
    };
    for (int layer = 0; layer < 4; ++layer)
    {
      add(slab, -std::expm1(-0.25 * extinction * chord));
      if (layer < 3)
      {
        const int plane = isReversed ? 2 - layer : layer;
        Point3 color = colors[plane];
        for (int k = 0; k < 3 && plane == 1; ++k)
        {
          color[k] *= halves[u < 0.5 ? 0 : 1][k];
        }
        add(color, opacities[plane]);
      }
    }
    double difference = 0.0;
    for (int k = 0; k < 4; ++k)
    {
      reference::KeepLargest(difference, std::abs(found.At(i, j)[k] - expected[k]));
    }
    off += difference > 1e-3 ? 1 : 0;
  }
  std::cout << name << ": " << off << " of " << inside << " pixels differ\n";
  check.That(inside > 300, name + ": the slab is visible");
  // OpenGL has single precision, in which a pixel next to an edge may belong to both triangles.
  check.That(off <= (path == Mapper::SOFTWARE_PATH ? 0 : 1), name);
}

/// Tests changes of materials against a new mapper, and materials that equal the common one.
void TestMaterialChanges(Check& check, int path)
{
  auto grid = MakeLayers(4, { 0.0, 0.25, 0.5, 0.75, 1.0 });
  const ImageCase what =
    MakeCase(grid, MakeProperty({ { 0.0, { { 0.9, 0.5, 0.1 } }, 0.8 } }), Slanted, false, Size);
  auto planes = MakePlanes(grid);
  auto texture = MakeTexture(planes);
  const std::string name = GetPathName(path) + ", changed materials";
  Surface plain(path, planes, 0.4);
  const RgbaImage without = DrawByMapper(plain.Drawer, what);
  Surface surface(path, planes, 0.4);
  surface.Drawer->SetBoundaryIdArrayName("surface");
  vtkNew<vtkProperty> same;
  same->DeepCopy(surface.Property);
  const auto compare = [&](const RgbaImage& expected, const std::string& how, bool isSame = true)
  {
    const double difference = CompareImages(DrawByMapper(surface.Drawer, what), expected).Max;
    check.That(isSame ? difference < 1e-6 : difference > 0.01, name + ": " + how);
  };
  const auto drawNew = [&](vtkProperty* property, vtkTexture* image)
  {
    Surface made(path, planes, 0.4);
    made.Drawer->SetBoundaryIdArrayName("surface");
    made.Drawer->SetBoundaryProperty(7, property);
    made.Drawer->SetBoundaryTexture(99, image);
    return DrawByMapper(made.Drawer, what);
  };
  compare(without, "an array without materials");
  surface.Drawer->SetBoundaryProperty(7, same);
  compare(without, "the same material");
  same->SetColor(1.0, 0.0, 0.0);
  compare(without, "another color", false);
  compare(drawNew(same, nullptr), "the color in a new mapper");
  surface.Drawer->SetBoundaryTexture(99, texture);
  compare(drawNew(same, texture), "a texture");
  texture->RepeatOn();
  compare(drawNew(same, texture), "a repeated texture");
  same->SetOpacity(0.9);
  compare(drawNew(same, texture), "opacity");
  surface.Drawer->SetBoundaryTexture(99, nullptr);
  surface.Drawer->SetBoundaryProperty(7, nullptr);
  check.That(surface.Drawer->GetBoundaryIds().empty(), name + ": nothing left");
  compare(without, "removed materials");
  surface.Drawer->SetBoundaryProperty(7, same);
  surface.Drawer->SetBoundaryIdArrayName(nullptr);
  compare(without, "no array");
  surface.Drawer->SetBoundaryIdArrayName("missing");
  const std::string error =
    CaptureErrors(surface.Drawer, [&] { compare(without, "a missing array"); });
  check.Contains(error, "\"missing\"");
  surface.Drawer->SetBoundaryIdArrayName("surface");
  for (int id = 0; id < 256; ++id)
  {
    surface.Drawer->SetBoundaryProperty(id, same);
  }
  check.Contains(
    CaptureErrors(surface.Drawer, [&] { compare(without, "too many ids"); }), "256 boundary ids");
  surface.Drawer->SetBoundaryProperty(0, nullptr);
  compare(drawNew(same, nullptr), "255 ids, of which two exist", false);
  surface.Drawer->RemoveAllBoundaryIds();
  compare(without, "all ids removed");
}

/// Tests that materials remain on tetrahedra that a plane or the near plane cuts.
void TestCutMaterials(Check& check, int path)
{
  auto grid = MakeLayers(4, { 0.0, 0.25, 0.5, 0.75, 1.0 });
  const ImageCase what =
    MakeCase(grid, MakeProperty({ { 0.0, { { 0.9, 0.5, 0.1 } }, 0.8 } }), Slanted, false, Size);
  auto planes = MakePlanes(grid);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.47, 0.0, 0.0);
  plane->SetNormal(1.0, 0.3, 0.2);
  for (const bool isNear : { false, true })
  {
    const std::string name =
      GetPathName(path) + (isNear ? ", cut by the near plane" : ", cut by a plane");
    const double distance = what.Camera->GetDistance();
    what.Camera->SetClippingRange(isNear ? distance : 0.01 * distance, 4.0 * distance);
    RgbaImage images[3];
    for (int i = 0; i < 3; ++i)
    {
      Surface surface(path, planes, 0.4);
      if (!isNear)
      {
        surface.Drawer->AddClippingPlane(plane);
      }
      surface.Drawer->SetBoundaryIdArrayName("surface");
      vtkNew<vtkProperty> property;
      MakeFlat(property, i == 1 ? FaceColor : Point3{ { 1.0, 0.0, 0.0 } }, 0.4);
      for (const int id : { 7, -3, 99 })
      {
        surface.Drawer->SetBoundaryProperty(id, i > 0 ? property.Get() : nullptr);
      }
      images[i] = DrawByMapper(surface.Drawer, what);
    }
    check.Near(CompareImages(images[1], images[0]).Max, 0.0, 1e-6, name, 1.0);
    check.That(CompareImages(images[2], images[0]).Max > 0.1, name + ": materials are visible");
  }
}

/// Tests textures without coordinates, with a changed lookup table and with too few pixels,
/// coordinates that are not finite, triangles with different orientations, and triangles that are
/// not faces.
void TestOddBoundaries(Check& check, int path)
{
  auto grid = MakeLayers(4, { 0.0, 0.5, 1.0 });
  const ImageCase what =
    MakeCase(grid, MakeProperty({ { 0.0, { { 0.9, 0.5, 0.1 } }, 0.3 } }), Slanted, false, Size);
  auto midplane = MakeMidplane(grid);
  const std::string name = GetPathName(path);
  Surface plain(path, midplane, 0.6);
  const RgbaImage untextured = DrawByMapper(plain.Drawer, what);
  vtkNew<vtkPolyData> mapped;
  mapped->DeepCopy(midplane);
  auto texture = MakeTexture(mapped);
  plain.Drawer->SetBoundaryTexture(texture);
  check.Near(CompareImages(DrawByMapper(plain.Drawer, what), untextured).Max, 0.0, 1e-6,
    name + ", a texture without coordinates", 1.0);
  Surface textured(path, mapped, 0.6);
  textured.Drawer->SetBoundaryTexture(texture);
  vtkNew<vtkLookupTable> table;
  table->SetTableRange(0.0, 1.0);
  vtkNew<vtkImageData> values;
  values->SetDimensions(2, 2, 1);
  values->AllocateScalars(VTK_FLOAT, 1);
  values->GetPointData()->GetScalars()->Fill(0.5);
  texture->SetInputData(values);
  texture->SetLookupTable(table);
  const RgbaImage before = DrawByMapper(textured.Drawer, what);
  table->SetHueRange(0.1, 0.2);
  table->Build();
  check.That(CompareImages(DrawByMapper(textured.Drawer, what), before).Max > 0.1,
    name + ", a changed lookup table");
  mapped->GetPointData()->GetTCoords()->SetTuple2(7, NaN, 1e30);
  mapped->GetPointData()->GetTCoords()->Modified();
  texture->RepeatOn();
  check.That(LargestAlpha(DrawByMapper(textured.Drawer, what)) > 0.5,
    name + ", coordinates that are not finite");
  values->GetPointData()->GetScalars()->SetNumberOfTuples(1);
  values->Modified();
  check.Near(CompareImages(DrawByMapper(textured.Drawer, what), untextured).Max, 0.0, 1e-6,
    name + ", too few pixels", 1.0);

  vtkNew<vtkPolyData> mixed;
  mixed->DeepCopy(midplane);
  for (vtkIdType cell = 0; cell < mixed->GetNumberOfCells(); cell += 2)
  {
    mixed->ReverseCell(cell);
  }
  RgbaImage lit[2];
  for (int i = 0; i < 2; ++i)
  {
    Surface surface(path, i == 0 ? midplane.Get() : mixed.Get(), 0.6);
    surface.Property->SetAmbient(0.1);
    surface.Property->SetDiffuse(0.9);
    lit[i] = DrawByMapper(surface.Drawer, what);
  }
  check.Near(CompareImages(lit[1], lit[0]).Max, 0.0, 1e-5, name + ", mixed orientations", 1.0);

  vtkNew<vtkTransformPolyDataFilter> move;
  vtkNew<vtkTransform> transform;
  transform->Translate(0.1, 0.0, 0.0);
  move->SetTransform(transform);
  move->SetInputData(midplane);
  move->Update();
  Surface moved(path, move->GetOutput(), 0.6);
  int warnings = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&warnings);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  moved.Drawer->AddObserver(vtkCommand::WarningEvent, count);
  DrawByMapper(moved.Drawer, what);
  DrawByMapper(moved.Drawer, what);
  check.Equal(warnings, 1, name + ", one warning if no triangle is a face");
}

/// Tests that blend modes that do not support boundary triangles ignore them.
void TestOtherModes(Check& check, int path)
{
  ImageCase what;
  what.Grid = MakeCube(2);
  AddSlabIndices(what.Grid, "IntervalId", 2, 2);
  what.Property = MakeRamp(0.1, 1.0);
  what.Camera = LookAt(what.Grid, Slanted, true);
  auto sides = MakeSides(what.Grid);
  for (Blend how :
    { Blend::Additive, Blend::MaximumIntensity, Blend::Priority, Blend::OpticalDepth })
  {
    what.Settings.How = how;
    Surface surface(path, sides, 0.5);
    const RgbaImage found = DrawByMapper(surface.Drawer, what);
    const std::string name = GetPathName(path) + ", blend " + std::to_string(static_cast<int>(how));
    check.Equal(
      surface.Drawer->GetReport()->GetCount("BoundaryTriangles"), 0, name + ": triangles");
    check.Near(CompareImages(found, DrawByPath(path, what)).Max, 0.0, 1e-6,
      name + ": difference from a mapper without triangles", 1.0);
    check.That(LargestAlpha(found) > 0.1, name + ": the volume is visible");
  }
}

}

int TestTetrahedraMapperSurface(int, char*[])
{
  Check check;
  for (int path : AllRenderPaths())
  {
    for (bool parallel : { true, false })
    {
      TestOpaque(check, path, parallel);
      TestTexture(check, path, parallel);
      TestMipmaps(check, path, parallel, FaceOn);
      TestMipmaps(check, path, parallel, { { 0.5, -0.4, 1.0 } });
      TestFaces(check, path, parallel);
      TestMaterials(check, path, parallel, FaceOn);
      TestMaterials(check, path, parallel, { { 0.2, 0.1, -1.0 } });
    }
    TestMaterialChanges(check, path);
    TestCutMaterials(check, path);
    TestOddBoundaries(check, path);
    TestBothSides(check, path);
    TestUnmatched(check, path);
    TestChanges(check, path);
    TestOtherModes(check, path);
  }
  return check.Result();
}
