// SPDX-License-Identifier: BSD-3-Clause
// Pay for use: what a picture did not need was not done, by the report of both render paths.
#include "Support/Drawing/PictureCases.h"
#include "Support/Pictures/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"
#include "Tetrahedra/MapperPicture.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;

constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };
constexpr Point3 Red = { { 1.0, 0.1, 0.0 } };

/// One volume in one window by one path and one projection, drawn again and again.
class Scene
{
public:
  Scene(int path, bool parallel)
    : Name(GetPathName(path) + (parallel ? ", parallel" : ", perspective"))
    , Stage(std::array<int, 2>{ { 80, 64 } })
    , Path(path)
  {
    this->What.Grid = MakeCube(4);
    this->What.Property = MakeRamp(0.1, 1.0, 0.25);
    this->What.Camera = LookAt(this->What.Grid, Slanted, parallel);
    this->Drawer->SetRenderPath(path);
    // Levels of detail come by the clock.
    this->Drawer->AutoAdjustLevelOfDetailOff();
  }

  /// Draws with the mapper as it is.
  ReportCopy Draw()
  {
    this->Stage.SetVolume(this->Drawer, this->What.Property);
    this->Stage.SetCamera(this->What.Camera);
    this->Stage.Render();
    return CopyReport(this->Drawer->GetReport());
  }

  /// Draws with the settings.
  ReportCopy Draw(Blend blend)
  {
    this->What.Settings.How = blend;
    Configure(this->Drawer, this->What);
    return this->Draw();
  }

  bool IsOpenGL() const { return this->Path == Mapper::OPENGL_PATH; }
  vtkIdType GetCells() const { return this->What.Grid->GetNumberOfCells(); }

  std::string Name;
  PictureCase What;
  vtkNew<Mapper> Drawer;

private:
  VolumeStage Stage;
  int Path;
};

/// Both paths write features in their own spelling: `delta-t`, `DELTA_T`.
bool HasFeature(vtkInterlumeReport* report, const std::string& feature)
{
  std::string text = report->GetText("Features");
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter)
    { return letter == '_' ? '-' : static_cast<char>(std::tolower(letter)); });
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    if (word == feature)
    {
      return true;
    }
  }
  return false;
}

void ExpectNothingSent(Check& check, vtkInterlumeReport* report, const std::string& what)
{
  check.That(!report->GetNumber("Sorted"), what + ": not sorted");
  check.Near(report->GetNumber("UploadedStaticBytes"), 0, 0.0, what + ": static bytes");
  check.Near(report->GetNumber("UploadedOrderBytes"), 0, 0.0, what + ": bytes of the order");
  check.Near(report->GetNumber("UploadedImageBytes"), 0, 0.0, what + ": bytes of the image");
}

void TestReasons(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  check.That(
    scene.Drawer->GetReport()->GetText("PathReason").empty(), "no reason before a picture");
  const ReportCopy report = scene.Draw(Blend::Composite);
  check.Near(report->GetNumber("RenderPath"), path, 0.0, scene.Name + ": path");
  check.That(!report->GetText("PathReason").empty(), scene.Name + ": a reason of the path");
  check.That(!report->GetText("BlendReason").empty(), scene.Name + ": a reason of the blend mode");
  check.That(!report->GetText("SortReason").empty(), scene.Name + ": a reason of the order");
  check.Near(report->GetNumber("Tetrahedra"), scene.GetCells(), 0.0, scene.Name + ": tetrahedra");
  check.Near(
    report->GetNumber("TetrahedraDrawn"), scene.GetCells(), 0.0, scene.Name + ": tetrahedra drawn");
  check.Near(report->GetNumber("TetrahedraClipped"), 0, 0.0, scene.Name + ": tetrahedra clipped");
  check.Near(report->GetNumber("Passes"), 1, 0.0, scene.Name + ": passes");
  check.Near(report->GetNumber("Layers"), 0, 0.0, scene.Name + ": layers");
  check.That(report->GetNumber("MemoryBytes") > 0 && report->GetNumber("BufferBytes") > 0,
    scene.Name + ": memory");
}

void TestDeltaT(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  Configure(scene.Drawer, scene.What);
  scene.Drawer->SetDeltaTArrayName(nullptr);
  scene.Drawer->SetBlendModeToAutomatic();
  const ReportCopy without = scene.Draw();
  check.That(!without->GetText("Features").empty(), scene.Name + ": features");
  check.That(!HasFeature(without, "delta-t"), scene.Name + ": no extent in time");
  check.Near(without->GetNumber("BlendMode"), Mapper::COMPOSITE_BLEND, 0.0,
    scene.Name + ": automatic blend");
  AddLinear(scene.What.Grid, "DeltaT", 1.0, { { -0.8, 0.5, 0.3 } });
  const ReportCopy with = scene.Draw();
  check.That(HasFeature(with, "delta-t"), scene.Name + ": an extent in time");
  check.Near(with->GetNumber("BlendMode"), Mapper::OPTICAL_DEPTH_BLEND, 0.0,
    scene.Name + ": automatic blend");
  check.Near(
    with->GetNumber("SortMode"), Mapper::NO_SORT, 0.0, scene.Name + ": automatic blend, no order");
}

void TestOrder(Check& check, int path, bool parallel)
{
  const struct
  {
    Blend How;
    const char* Name;
  } modes[] = { { Blend::Additive, "additive" }, { Blend::MaximumIntensity, "maximum" },
    { Blend::Priority, "priority" }, { Blend::OpticalDepth, "optical depth" },
    { Blend::Composite, "composite of one colour" } };
  for (const auto& mode : modes)
  {
    Scene scene(path, parallel);
    AddSlabs(scene.What.Grid, "IntervalId", 2, 3);
    if (mode.How == Blend::Composite)
    {
      scene.What.Property = MakeProperty({ { 0.0, Red, 0.1 }, { 1.0, Red, 1.0 } });
    }
    const std::string name = scene.Name + ", " + mode.Name;
    const ReportCopy report = scene.Draw(mode.How);
    check.Near(report->GetNumber("SortMode"), Mapper::NO_SORT, 0.0, name + ": order");
    check.That(!report->GetNumber("Sorted"), name + ": not sorted");
    check.That(!report->GetNumber("HasAdjacency"), name + ": no adjacency");
    const bool isPriority = mode.How == Blend::Priority;
    check.Near(report->GetNumber("UploadedOrderBytes"),
      isPriority && scene.IsOpenGL() ? 4 * scene.GetCells() : 0, 0.0,
      name + ": bytes of the order");
    check.Near(report->GetNumber("Layers"), isPriority ? 3 : 0, 0.0, name + ": layers");
    check.Near(report->GetNumber("Passes"), isPriority ? 3 : 1, 0.0, name + ": passes");
    ExpectNothingSent(check, scene.Draw(), name + ", again");
    scene.What.Camera->Azimuth(10.0);
    const ReportCopy moved = scene.Draw();
    check.Near(moved->GetNumber("UploadedStaticBytes"), 0, 0.0, name + ", moved: static bytes");
    check.Near(
      moved->GetNumber("UploadedOrderBytes"), 0, 0.0, name + ", moved: bytes of the order");
    check.That(!moved->GetNumber("Sorted"), name + ", moved: not sorted");
  }
}

void TestSortedFrames(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  const vtkIdType orderBytes = scene.IsOpenGL() ? 4 * scene.GetCells() : 0;
  const ReportCopy first = scene.Draw(Blend::Composite);
  check.Near(first->GetNumber("SortMode"), Mapper::MPVONC_SORT, 0.0, scene.Name + ": order");
  check.That(first->GetNumber("Sorted") > 0, scene.Name + ": sorted");
  check.That(first->GetNumber("HasAdjacency") > 0, scene.Name + ": adjacency");
  check.Near(
    first->GetNumber("UploadedOrderBytes"), orderBytes, 0.0, scene.Name + ": bytes of the order");
  // What is 0 later was not before.
  check.That((first->GetNumber("UploadedStaticBytes") > 0) == scene.IsOpenGL(),
    scene.Name + ": static bytes");
  check.That((first->GetNumber("UploadedImageBytes") > 0) == !scene.IsOpenGL(),
    scene.Name + ": image bytes");
  ExpectNothingSent(check, scene.Draw(), scene.Name + ", still");
  ExpectNothingSent(check, scene.Draw(), scene.Name + ", still again");

  for (int step = 0; step < 3; ++step)
  {
    scene.What.Camera->Azimuth(10.0);
    const ReportCopy moved = scene.Draw();
    check.That(moved->GetNumber("Sorted") > 0, scene.Name + ", moved: sorted");
    check.Near(
      moved->GetNumber("UploadedStaticBytes"), 0, 0.0, scene.Name + ", moved: static bytes");
    check.Near(moved->GetNumber("UploadedOrderBytes"), orderBytes, 0.0,
      scene.Name + ", moved: bytes of the order");
    ExpectNothingSent(check, scene.Draw(), scene.Name + ", moved and still");
  }

  // Colours alone.
  scene.What.Property->GetRGBTransferFunction()->AddRGBPoint(0.5, 0.0, 1.0, 0.0);
  const ReportCopy colored = scene.Draw();
  check.That(!colored->GetNumber("Sorted"), scene.Name + ", other colours: not sorted");
  check.Near(colored->GetNumber("UploadedOrderBytes"), 0, 0.0,
    scene.Name + ", other colours: bytes of the order");
  if (scene.IsOpenGL())
  {
    check.That(colored->GetNumber("UploadedStaticBytes") > 0 &&
        colored->GetNumber("UploadedStaticBytes") < first->GetNumber("UploadedStaticBytes"),
      scene.Name + ", other colours: bytes of the colours and no more");
  }
  else
  {
    check.Near(colored->GetNumber("UploadedImageBytes"), first->GetNumber("UploadedImageBytes"),
      0.0, scene.Name + ", other colours: another image");
  }
  ExpectNothingSent(check, scene.Draw(), scene.Name + ", other colours, still");
}

void TestBoundary(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  const ReportCopy without = scene.Draw(Blend::Composite);
  check.Near(without->GetNumber("BoundaryTriangles"), 0, 0.0, scene.Name + ": no triangles");
  check.That(!HasFeature(without, "surface"), scene.Name + ": no surface");
  // A face of the first tetrahedron.
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  scene.What.Grid->GetCellPoints(0, size, corners);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell(3, corners);
  vtkNew<vtkPolyData> boundary;
  boundary->SetPoints(scene.What.Grid->GetPoints());
  boundary->SetPolys(triangles);
  scene.Drawer->SetBoundaryData(boundary);
  const ReportCopy with = scene.Draw();
  check.Near(with->GetNumber("BoundaryTriangles"), 1, 0.0, scene.Name + ": one triangle");
  check.Near(with->GetNumber("UnmatchedTriangles"), 0, 0.0, scene.Name + ": no other triangle");
  check.That(HasFeature(with, "surface"), scene.Name + ": a surface");
  ExpectNothingSent(check, scene.Draw(), scene.Name + ", with a triangle, still");
  // Light and camera go to the shader as numbers.
  scene.What.Camera->Azimuth(10.0);
  check.Near(scene.Draw()->GetNumber("UploadedStaticBytes"), 0, 0.0,
    scene.Name + ", with a triangle, moved");
  scene.Drawer->SetBoundaryData(nullptr);
  const ReportCopy after = scene.Draw();
  check.Near(after->GetNumber("BoundaryTriangles"), 0, 0.0, scene.Name + ": the triangle is gone");
  check.That(!HasFeature(after, "surface"), scene.Name + ": the surface is gone");
}

/// Parts that the near plane cuts are made for one view, and sent for one.
void TestNearPlane(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  double range[2];
  scene.What.Camera->GetClippingRange(range);
  scene.What.Camera->SetClippingRange(scene.What.Camera->GetDistance(), range[1]);
  const ReportCopy first = scene.Draw(Blend::Composite);
  check.That(first->GetNumber("TetrahedraClipped") > 0, scene.Name + ": the near plane cuts");
  const ReportCopy still = scene.Draw();
  check.Near(still->GetNumber("TetrahedraClipped"), first->GetNumber("TetrahedraClipped"), 0.0,
    scene.Name + ": it cuts again");
  ExpectNothingSent(check, still, scene.Name + ", cut by the near plane, still");
}

/// What sorting found is not reported of a picture that was not sorted.
void TestGaps(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  scene.What.Grid = MakeCube(3);
  AddSlabs(scene.What.Grid, "slab", 2, 3);
  vtkNew<vtkCellArray> cells;
  for (vtkIdType cell = 0; cell < scene.What.Grid->GetNumberOfCells(); ++cell)
  {
    if (scene.What.Grid->GetCellData()->GetArray("slab")->GetComponent(cell, 0) != 1.0)
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      scene.What.Grid->GetCellPoints(cell, size, corners);
      cells->InsertNextCell(size, corners);
    }
  }
  scene.What.Grid->GetCellData()->Initialize();
  scene.What.Grid->SetCells(VTK_TETRA, cells);
  const ReportCopy sorted = scene.Draw(Blend::Composite);
  check.That(sorted->GetNumber("Sorted") > 0 && sorted->GetNumber("Gaps") > 0,
    scene.Name + ": gaps of a mesh in two parts");
  const ReportCopy unsorted = scene.Draw(Blend::Additive);
  check.That(!unsorted->GetNumber("Sorted"), scene.Name + ": additive after composite, not sorted");
  check.Near(unsorted->GetNumber("Gaps"), 0, 0.0, scene.Name + ": additive after composite, gaps");
}

}

int TestTetrahedraMapperCounters(int, char*[])
{
  Check check;
  for (int path : AllRenderPaths())
  {
    for (bool parallel : { true, false })
    {
      TestReasons(check, path, parallel);
      TestDeltaT(check, path, parallel);
      TestOrder(check, path, parallel);
      TestSortedFrames(check, path, parallel);
      TestBoundary(check, path, parallel);
      TestNearPlane(check, path, parallel);
      TestGaps(check, path, parallel);
    }
  }
  return check.Result();
}
