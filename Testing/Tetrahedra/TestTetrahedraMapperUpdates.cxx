// SPDX-License-Identifier: BSD-3-Clause
// New values on the same mesh, as those of a time step, keep the mesh, its adjacency, order and
// what was sent of it; what is drawn then has the bytes that a mapper made anew draws.
#include "Support/Drawing/PictureCases.h"
#include "Support/Pictures/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"
#include "Tetrahedra/MapperPicture.h"

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

/// A mapper that lives from change to change, in a window of its own.
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
    AddSlabs(this->What.Grid, "layer", 2, 3);
    this->Setup(this->Kept);
  }

  /// Draws by the mapper that is kept, and compares with one made anew.
  ReportCopy Draw(Check& check, const std::string& what)
  {
    this->Setup(this->Kept);
    const RgbaPicture picture = this->Capture(this->Stage, this->Kept, 1);
    const auto report = CopyReport(this->Kept->GetReport());
    VolumeStage stage(this->What.Settings.Size);
    vtkNew<Mapper> anew;
    this->Setup(anew);
    check.That(picture.Values == this->Capture(stage, anew, 1).Values, what + ": the same bytes");
    check.That(anew->GetReport()->GetNumber("MeshRebuilt") > 0 &&
        anew->GetReport()->GetNumber("ValuesUpdated") > 0,
      what + ": a mapper made anew takes all");
    return report;
  }

  vtkUnstructuredGrid* GetGrid() { return this->What.Grid; }
  vtkDataArray* GetArray(const char* name)
  {
    return this->GetGrid()->GetPointData()->GetArray(name);
  }

  PictureCase What;
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

  RgbaPicture Capture(VolumeStage& stage, Mapper* mapper, int frames)
  {
    stage.SetVolume(mapper, this->What.Property);
    stage.SetCamera(this->What.Camera);
    return stage.Capture(frames);
  }

  VolumeStage Stage;
  vtkNew<Mapper> Kept;
  int Path;
};

/// Gives the grid another array with the values of the old one changed, as a reader does.
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

/// Gives the scene a new grid with arrays of its own, the same to the last bit.
void CopyGrid(Scene& scene)
{
  vtkNew<vtkUnstructuredGrid> copy;
  copy->DeepCopy(scene.GetGrid());
  scene.What.Grid = copy;
}

/// Gives the scene a grid of another shape that has the same arrays of points, the objects.
void ReplaceShape(Scene& scene, vtkSmartPointer<vtkUnstructuredGrid> grid)
{
  for (const char* name : { "f", "extent" })
  {
    grid->GetPointData()->AddArray(scene.GetArray(name));
  }
  grid->GetPointData()->SetActiveScalars("f");
  AddSlabs(grid, "layer", 2, 3);
  scene.What.Grid = grid;
}

/// The same connectivity, the object, with points of their own, or the other way round.
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
    // Two cells change places.
    const std::vector<vtkIdType> first(corners, corners + 4);
    before->GetCellPoints(1, size, corners);
    cells->ReplaceCellAtId(0, 4, std::vector<vtkIdType>(corners, corners + 4).data());
    cells->ReplaceCellAtId(1, 4, first.data());
    grid->SetCells(VTK_TETRA, cells);
  }
  ReplaceShape(scene, grid);
}

/// A face of the first tetrahedron as the boundary.
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

void ExpectKept(Check& check, vtkInterlumeReport* report, const std::string& what)
{
  check.That(report->GetNumber("ValuesUpdated") > 0, what + ": values are taken");
  check.That(!report->GetNumber("MeshRebuilt"), what + ": the mesh is kept");
  check.That(!report->GetNumber("Sorted"), what + ": the order is kept");
  check.Near(report->GetNumber("UploadedOrderBytes"), 0, 0.0, what + ": no order is sent");
}

/// Values alone, by each way that they come.
void TestValues(Check& check, int path)
{
  Scene scene(path, Blend::Composite);
  scene.Boundary = MakeBoundary(scene.GetGrid());
  const ReportCopy first = scene.Draw(check, "first");
  check.That(first->GetNumber("MeshRebuilt") > 0 && first->GetNumber("ValuesUpdated") > 0 &&
      first->GetNumber("Sorted") > 0,
    "first: all is made");
  const ReportCopy still = scene.Draw(check, "still");
  check.That(!still->GetNumber("MeshRebuilt") && !still->GetNumber("ValuesUpdated"),
    "still: nothing is made");

  scene.GetArray("f")->SetComponent(5, 0, 0.9);
  scene.GetArray("f")->Modified();
  ExpectKept(check, scene.Draw(check, "one value"), "one value");
  ReplaceValues(scene, "f", 3.0);
  const ReportCopy array = scene.Draw(check, "another array");
  ExpectKept(check, array, "another array");
  check.Near(array->GetNumber("BoundaryTriangles"), 1, 0.0, "another array: the boundary is kept");
  CopyGrid(scene);
  ReplaceValues(scene, "f", 2.0);
  const ReportCopy grid = scene.Draw(check, "another grid");
  ExpectKept(check, grid, "another grid");
  check.That(grid->GetNumber("HasAdjacency") > 0, "another grid: the adjacency is kept");
  // Positions are 16 bytes a point, corners and volume 20 bytes a tetrahedron, values 4 bytes a
  // point; what is left are the pieces of the transfer functions.
  const vtkIdType values = 4 * scene.GetGrid()->GetNumberOfPoints();
  const vtkIdType mesh =
    16 * scene.GetGrid()->GetNumberOfPoints() + 20 * scene.GetGrid()->GetNumberOfCells();
  if (path == Mapper::OPENGL_PATH)
  {
    check.That(grid->GetNumber("UploadedStaticBytes") >= values &&
        grid->GetNumber("UploadedStaticBytes") <= first->GetNumber("UploadedStaticBytes") - mesh,
      "another grid: values alone are sent");
  }

  AddLinear(scene.GetGrid(), "extent", 1.0, { { -0.8, 0.5, 0.3 } });
  scene.What.Settings.Arrays.DeltaT = "extent";
  check.That(!scene.Draw(check, "an extent in time")->GetNumber("MeshRebuilt"),
    "an extent in time: the mesh is kept");
  ReplaceValues(scene, "extent", 1.7);
  ExpectKept(check, scene.Draw(check, "another extent"), "another extent");
}

/// What leaves tetrahedra out belongs to the mesh.
void TestHoles(Check& check, int path)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Scene scene(path, Blend::Composite);
  scene.Draw(check, "whole");
  scene.GetArray("f")->SetComponent(5, 0, nan);
  scene.GetArray("f")->Modified();
  const ReportCopy hole = scene.Draw(check, "a hole");
  check.That(hole->GetNumber("MeshRebuilt") > 0 && hole->GetNumber("NonFiniteTetrahedra") > 0,
    "a hole: another mesh");
  scene.GetArray("f")->SetComponent(6, 0, 0.7);
  scene.GetArray("f")->Modified();
  ExpectKept(check, scene.Draw(check, "the same hole"), "the same hole");
  scene.GetArray("f")->SetComponent(7, 0, nan);
  scene.GetArray("f")->SetComponent(5, 0, 0.7);
  scene.GetArray("f")->Modified();
  check.That(
    scene.Draw(check, "another hole")->GetNumber("MeshRebuilt") > 0, "another hole: another mesh");
  scene.GetArray("f")->SetComponent(7, 0, 0.5);
  scene.GetArray("f")->Modified();
  check.That(
    scene.Draw(check, "whole again")->GetNumber("MeshRebuilt") > 0, "whole again: another mesh");
}

/// Layers are values that have an order.
void TestLayers(Check& check, int path)
{
  Scene scene(path, Blend::Priority);
  scene.Draw(check, "layers");
  AddSlabs(scene.GetGrid(), "layer", 1, 2);
  const ReportCopy report = scene.Draw(check, "other layers");
  check.That(!report->GetNumber("MeshRebuilt"), "other layers: the mesh is kept");
  check.Near(report->GetNumber("Layers"), 2, 0.0, "other layers: two");
}

/// Any change after any other.
void TestSequence(Check& check, int path, Blend how, unsigned int seed)
{
  Scene scene(path, how);
  AddLinear(scene.GetGrid(), "extent", 1.0, { { -0.8, 0.5, 0.3 } });
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
    bool IsOfMesh;
    std::function<void()> Make;
  } changes[] = {
    { "values", false, [&]() { ReplaceValues(scene, "f", 1.5 + number(5)); } },
    { "extents", false, [&]() { ReplaceValues(scene, "extent", 1.5 + number(5)); } },
    { "whether there is an extent", false,
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
    { "colours", false,
      [&]() { scene.What.Property = MakeRamp(0.1, 1.0, 0.1 + 0.1 * number(5)); } },
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
        double place[3];
        scene.GetGrid()->GetPoint(moved, place);
        place[number(3)] += 0.01 + 0.01 * number(5);
        scene.GetGrid()->GetPoints()->SetPoint(moved, place);
        scene.GetGrid()->GetPoints()->Modified();
      } },
    { "turned tetrahedron", true,
      [&]()
      {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        const vtkIdType turned = cell();
        scene.GetGrid()->GetCellPoints(turned, size, corners);
        const std::vector<vtkIdType> ids = { corners[1], corners[0], corners[2], corners[3] };
        scene.GetGrid()->GetCells()->ReplaceCellAtId(turned, 4, ids.data());
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
    check.That(
      report->GetNumber("MeshRebuilt") == change.IsOfMesh, name + ": whether the mesh is made");
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
