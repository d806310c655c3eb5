// SPDX-License-Identifier: BSD-3-Clause
// Tests that new values on the same mesh, as in time steps, do not rebuild the mesh, its adjacency,
// order or buffers. The image must equal the image of a new mapper.
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;

/// A window with a mapper that is reused after each change.
class Scene
{
public:
  Scene(int path, Blend how)
    : Stage(std::array<int, 2>{ { 48, 40 } })
    , Path(path)
  {
    this->What.Grid = MakeCube(3);
    this->What.Property = MakeRamp(0.1, 1.0, 0.25);
    this->What.Camera = LookAt(this->What.Grid, { { 0.3, -0.4, 1.0 } }, false);
    this->What.Settings.Size = { { 48, 40 } };
    this->What.Settings.How = how;
    this->What.Settings.Arrays.Scalars = "f";
    this->What.Settings.Layers = "layer";
    AddSlabIndices(this->What.Grid, "layer", 2, 3);
    this->Setup(this->Reused);
  }

  /// Renders with the reused mapper and compares the image with that of a new one.
  ReportCopy Draw(Check& check, const std::string& what)
  {
    this->Setup(this->Reused);
    const RgbaImage image = this->Capture(this->Stage, this->Reused, 1);
    const auto report = CopyReport(this->Reused->GetReport());
    VolumeStage stage(this->What.Settings.Size);
    vtkNew<Mapper> fresh;
    this->Setup(fresh);
    check.That(image.Values == this->Capture(stage, fresh, 1).Values,
      what + ": the image equals that of a new mapper");
    check.That(fresh->GetReport()->GetNumber("MeshRebuilt") > 0 &&
        fresh->GetReport()->GetNumber("ValuesUpdated") > 0,
      what + ": a new mapper reads the mesh and the values");
    return report;
  }

  vtkUnstructuredGrid* GetGrid() { return this->What.Grid; }
  vtkDataArray* GetArray(const char* name)
  {
    return this->GetGrid()->GetPointData()->GetArray(name);
  }

  ImageCase What;
  vtkSmartPointer<vtkPolyData> Boundary;
  vtkNew<vtkPlaneCollection> Planes;

private:
  void Setup(Mapper* mapper)
  {
    Configure(mapper, this->What);
    mapper->SetClippingPlanes(this->Planes);
    mapper->SetRenderPath(this->Path);
    mapper->SetBoundaryData(this->Boundary);
    mapper->AutoAdjustLevelOfDetailOff();
  }

  RgbaImage Capture(VolumeStage& stage, Mapper* mapper, int frames)
  {
    stage.SetVolume(mapper, this->What.Property);
    stage.SetCamera(this->What.Camera);
    return stage.Capture(frames);
  }

  VolumeStage Stage;
  vtkNew<Mapper> Reused;
  int Path;
};

/// Replaces an array of the grid with a changed copy, as a reader does.
void ReplaceValues(Scene& scene, const char* name, double scale)
{
  vtkDataArray* before = scene.GetArray(name);
  auto after = vtkSmartPointer<vtkDataArray>::Take(before->NewInstance());
  after->DeepCopy(before);
  after->SetName(name);
  for (vtkIdType p = 0; p < after->GetNumberOfTuples(); ++p)
  {
    after->SetComponent(p, 0, 0.1 + std::fmod(scale * (before->GetComponent(p, 0) + 0.07), 0.8));
  }
  scene.GetGrid()->GetPointData()->AddArray(after);
}

/// Replaces the grid with a deep copy.
void CopyGrid(Scene& scene)
{
  vtkNew<vtkUnstructuredGrid> copy;
  copy->DeepCopy(scene.GetGrid());
  scene.What.Grid = copy;
}

/// Replaces the grid with another one, which shares the point data arrays `f` and `extent`.
void ReplaceShape(Scene& scene, vtkSmartPointer<vtkUnstructuredGrid> grid)
{
  for (const char* name : { "f", "extent" })
  {
    grid->GetPointData()->AddArray(scene.GetArray(name));
  }
  grid->GetPointData()->SetActiveScalars("f");
  AddSlabIndices(grid, "layer", 2, 3);
  scene.What.Grid = grid;
}

/// Replaces either the points or the connectivity of the grid, and keeps the other object.
void ReplacePart(Scene& scene, bool isPoints, double stretch)
{
  vtkUnstructuredGrid* before = scene.GetGrid();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(before->GetPoints());
  grid->SetCells(VTK_TETRA, before->GetCells());
  if (isPoints)
  {
    MovePoints(grid, { { 0.0, 0.0, 0.0 } }, 1.0, { { stretch, 1.0, 1.0 / stretch } });
  }
  else
  {
    vtkNew<vtkCellArray> cells;
    cells->DeepCopy(before->GetCells());
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    before->GetCellPoints(0, size, corners);
    // Swap two cells.
    const std::vector<vtkIdType> first(corners, corners + 4);
    before->GetCellPoints(1, size, corners);
    cells->ReplaceCellAtId(0, 4, std::vector<vtkIdType>(corners, corners + 4).data());
    cells->ReplaceCellAtId(1, 4, first.data());
    grid->SetCells(VTK_TETRA, cells);
  }
  ReplaceShape(scene, grid);
}

/// Returns a face of the first tetrahedron as the boundary.
vtkSmartPointer<vtkPolyData> MakeBoundary(vtkUnstructuredGrid* grid)
{
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  grid->GetCellPoints(0, size, corners);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell(3, corners);
  auto boundary = vtkSmartPointer<vtkPolyData>::New();
  boundary->SetPoints(grid->GetPoints());
  boundary->SetPolys(triangles);
  return boundary;
}

void ExpectOnlyValues(Check& check, vtkInterlumeReport* report, const std::string& what)
{
  check.That(report->GetNumber("ValuesUpdated") > 0, what + ": values are read");
  check.That(!report->GetNumber("MeshRebuilt"), what + ": the mesh is not rebuilt");
  check.That(!report->GetNumber("Sorted"), what + ": the mesh is not sorted again");
  check.Equal(report->GetCount("UploadedOrderBytes"), 0, what + ": no order is uploaded");
}

/// Tests all ways of changing only the values.
void TestValues(Check& check, int path)
{
  Scene scene(path, Blend::Composite);
  scene.Boundary = MakeBoundary(scene.GetGrid());
  const ReportCopy first = scene.Draw(check, "first");
  check.That(first->GetNumber("MeshRebuilt") > 0 && first->GetNumber("ValuesUpdated") > 0 &&
      first->GetNumber("Sorted") > 0,
    "first: everything is built");
  const ReportCopy still = scene.Draw(check, "still");
  check.That(!still->GetNumber("MeshRebuilt") && !still->GetNumber("ValuesUpdated"),
    "still: nothing is built");

  scene.GetArray("f")->SetComponent(5, 0, 0.9);
  scene.GetArray("f")->Modified();
  ExpectOnlyValues(check, scene.Draw(check, "one value"), "one value");
  ReplaceValues(scene, "f", 3.0);
  const ReportCopy array = scene.Draw(check, "another array");
  ExpectOnlyValues(check, array, "another array");
  check.Equal(
    array->GetCount("BoundaryTriangles"), 1, "another array: the boundary still has its triangle");
  CopyGrid(scene);
  ReplaceValues(scene, "f", 2.0);
  const ReportCopy grid = scene.Draw(check, "another grid");
  ExpectOnlyValues(check, grid, "another grid");
  check.That(grid->GetNumber("HasAdjacency") > 0, "another grid: the adjacency is reused");
  // Buffers store 16 bytes per point for positions, 20 bytes per tetrahedron for corners and
  // volume, and 4 bytes per point for values. The rest is for transfer functions.
  const vtkIdType values = 4 * scene.GetGrid()->GetNumberOfPoints();
  const vtkIdType mesh =
    16 * scene.GetGrid()->GetNumberOfPoints() + 20 * scene.GetGrid()->GetNumberOfCells();
  if (path == Mapper::OPENGL_PATH)
  {
    check.That(grid->GetNumber("UploadedStaticBytes") >= values &&
        grid->GetNumber("UploadedStaticBytes") <= first->GetNumber("UploadedStaticBytes") - mesh,
      "another grid: only values are uploaded");
  }

  AddLinearArray(scene.GetGrid(), "extent", 1.0, { { -0.8, 0.5, 0.3 } });
  scene.What.Settings.Arrays.DeltaT = "extent";
  check.That(!scene.Draw(check, "an extent in time")->GetNumber("MeshRebuilt"),
    "an extent in time: the mesh is not rebuilt");
  ReplaceValues(scene, "extent", 1.7);
  ExpectOnlyValues(check, scene.Draw(check, "another extent"), "another extent");
}

/// Tests that NaN values, which exclude tetrahedra, rebuild the mesh.
void TestHoles(Check& check, int path)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Scene scene(path, Blend::Composite);
  scene.Draw(check, "complete");
  scene.GetArray("f")->SetComponent(5, 0, nan);
  scene.GetArray("f")->Modified();
  const ReportCopy hole = scene.Draw(check, "a hole");
  check.That(hole->GetNumber("MeshRebuilt") > 0 && hole->GetNumber("NonFiniteTetrahedra") > 0,
    "a hole: the mesh is rebuilt");
  scene.GetArray("f")->SetComponent(6, 0, 0.7);
  scene.GetArray("f")->Modified();
  ExpectOnlyValues(check, scene.Draw(check, "the same hole"), "the same hole");
  scene.GetArray("f")->SetComponent(7, 0, nan);
  scene.GetArray("f")->SetComponent(5, 0, 0.7);
  scene.GetArray("f")->Modified();
  check.That(scene.Draw(check, "another hole")->GetNumber("MeshRebuilt") > 0,
    "another hole: the mesh is rebuilt");
  scene.GetArray("f")->SetComponent(7, 0, 0.5);
  scene.GetArray("f")->Modified();
  check.That(scene.Draw(check, "complete again")->GetNumber("MeshRebuilt") > 0,
    "complete again: the mesh is rebuilt");
}

/// Tests that changed layers do not rebuild the mesh.
void TestLayers(Check& check, int path)
{
  Scene scene(path, Blend::Priority);
  scene.Draw(check, "layers");
  AddSlabIndices(scene.GetGrid(), "layer", 1, 2);
  const ReportCopy report = scene.Draw(check, "other layers");
  check.That(!report->GetNumber("MeshRebuilt"), "other layers: the mesh is not rebuilt");
  check.Equal(report->GetCount("Layers"), 2, "other layers: number of layers");
}

/// Tests random sequences of changes.
void TestSequence(Check& check, int path, Blend how, unsigned int seed)
{
  Scene scene(path, how);
  AddLinearArray(scene.GetGrid(), "extent", 1.0, { { -0.8, 0.5, 0.3 } });
  std::mt19937 random(seed);
  const auto number = [&random](int limit)
  { return static_cast<int>(random() % static_cast<unsigned int>(limit)); };
  const auto cell = [&]()
  { return static_cast<vtkIdType>(number(static_cast<int>(scene.GetGrid()->GetNumberOfCells()))); };
  const auto point = [&]() {
    return static_cast<vtkIdType>(number(static_cast<int>(scene.GetGrid()->GetNumberOfPoints())));
  };
  int shape = 0;
  const struct
  {
    const char* Name;
    bool ChangesMesh;
    std::function<void()> Make;
  } changes[] = {
    { "values", false, [&]() { ReplaceValues(scene, "f", 1.5 + number(5)); } },
    { "extents", false, [&]() { ReplaceValues(scene, "extent", 1.5 + number(5)); } },
    { "toggle the extent", false,
      [&]()
      {
        std::string& name = scene.What.Settings.Arrays.DeltaT;
        name = name.empty() ? "extent" : "";
      } },
    { "copy", false, [&]() { CopyGrid(scene); } },
    { "camera", false, [&]() { scene.What.Camera->Azimuth(5.0 + number(90)); } },
    { "near plane", false,
      [&]()
      {
        double range[2];
        scene.What.Camera->GetClippingRange(range);
        const bool isCut = range[0] > 0.9 * scene.What.Camera->GetDistance();
        scene.What.Camera->SetClippingRange(
          (isCut ? 0.1 : 0.95) * scene.What.Camera->GetDistance(), range[1]);
      } },
    { "colors", false, [&]() { scene.What.Property = MakeRamp(0.1, 1.0, 0.1 + 0.1 * number(5)); } },
    { "shear", false,
      [&]()
      {
        const bool isSheared = scene.What.Camera->GetViewShear()[0] != 0.0;
        scene.What.Camera->SetViewShear(isSheared ? 0.0 : 0.3, isSheared ? 0.0 : -0.1, 0.8);
      } },
    { "clipping plane", false,
      [&]()
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(1.0 + number(3), number(5) - 2.0, number(5) - 2.0);
        plane->SetOrigin(0.4, 0.4, 0.5);
        scene.Planes->AddItem(plane);
      } },
    { "no clipping plane", false, [&]() { scene.Planes->RemoveAllItems(); } },
    { "boundary", false,
      [&]() { scene.Boundary = scene.Boundary ? nullptr : MakeBoundary(scene.GetGrid()); } },
    { "same arrays in another shape", true,
      [&]()
      {
        shape = (shape + 1) % 3;
        ReplaceShape(scene,
          shape == 0     ? MakeCube(3)
            : shape == 1 ? MakeBox({ { 1, 3, 7 } })
                         : MakeBox({ { 7, 3, 1 } }));
      } },
    { "same cells with other points", true,
      [&]() { ReplacePart(scene, true, number(2) != 0 ? 1.1 : 0.9); } },
    { "same points with other cells", true, [&]() { ReplacePart(scene, false, 1.0); } },
    { "point", true,
      [&]()
      {
        const vtkIdType moved = point();
        double position[3];
        scene.GetGrid()->GetPoint(moved, position);
        position[number(3)] += 0.01 + 0.01 * number(5);
        scene.GetGrid()->GetPoints()->SetPoint(moved, position);
        scene.GetGrid()->GetPoints()->Modified();
      } },
    { "inverted tetrahedron", true,
      [&]()
      {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        const vtkIdType inverted = cell();
        scene.GetGrid()->GetCellPoints(inverted, size, corners);
        const std::vector<vtkIdType> ids = { corners[1], corners[0], corners[2], corners[3] };
        scene.GetGrid()->GetCells()->ReplaceCellAtId(inverted, 4, ids.data());
        scene.GetGrid()->GetCells()->Modified();
        scene.GetGrid()->Modified();
      } },
    { "hidden tetrahedron", true,
      [&]()
      {
        scene.GetGrid()->AllocateCellGhostArray();
        auto* ghosts = scene.GetGrid()->GetCellGhostArray();
        const vtkIdType hidden = cell();
        ghosts->SetValue(hidden,
          ghosts->GetValue(hidden) ^ static_cast<unsigned char>(vtkDataSetAttributes::HIDDENCELL));
        ghosts->Modified();
      } },
  };
  const int kinds = static_cast<int>(sizeof(changes) / sizeof(changes[0]));
  std::string name = "seed " + std::to_string(seed);
  scene.Draw(check, name);
  for (int step = 0; step < 24; ++step)
  {
    const auto& change = changes[number(kinds)];
    change.Make();
    name += std::string(", ") + change.Name;
    const ReportCopy report = scene.Draw(check, name);
    check.That(report->GetNumber("MeshRebuilt") == change.ChangesMesh,
      name + ": the mesh is rebuilt only if needed");
  }
}

}

int TestTetrahedraMapperUpdates(int, char*[])
{
  Check check;
  for (int path : AllRenderPaths())
  {
    check.SetContext(GetPathName(path));
    TestValues(check, path);
    TestHoles(check, path);
    TestLayers(check, path);
    unsigned int seed = 1;
    for (Blend how :
      { Blend::Composite, Blend::OpticalDepth, Blend::MaximumIntensity, Blend::Priority })
    {
      TestSequence(check, path, how, seed++);
    }
  }
  return check.Result();
}
