// SPDX-License-Identifier: BSD-3-Clause
// Tests the reports of both render paths: work that an image does not need must not be done.
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"
#include "Tetrahedra/MapperImage.h"

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

/// Renders a volume repeatedly with the same render path and projection.
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
    // Otherwise, the level of detail would depend on the rendering time.
    this->Drawer->AutoAdjustLevelOfDetailOff();
  }

  /// Renders with the current settings of the mapper. Returns the mapper's report.
  ReportCopy Draw()
  {
    this->Stage.SetVolume(this->Drawer, this->What.Property);
    this->Stage.SetCamera(this->What.Camera);
    this->Stage.Render();
    return CopyReport(this->Drawer->GetReport());
  }

  /// Configures the mapper and renders. Returns the mapper's report.
  ReportCopy Draw(Blend blend)
  {
    this->What.Settings.How = blend;
    Configure(this->Drawer, this->What);
    return this->Draw();
  }

  bool IsOpenGL() const { return this->Path == Mapper::OPENGL_PATH; }
  vtkIdType GetCells() const { return this->What.Grid->GetNumberOfCells(); }

  std::string Name;
  ImageCase What;
  vtkNew<Mapper> Drawer;

private:
  VolumeStage Stage;
  int Path;
};

/// Returns whether the report lists a feature. The render paths spell features differently, such as
/// `delta-t` and `DELTA_T`.
bool HasFeature(vtkInterlumeReport* report, const std::string& feature)
{
  std::string text = report->GetText("Features");
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char character)
    { return character == '_' ? '-' : static_cast<char>(std::tolower(character)); });
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

void ExpectNoUploads(Check& check, vtkInterlumeReport* report, const std::string& what)
{
  check.That(!report->GetNumber("Sorted"), what + ": not sorted");
  check.Equal(report->GetCount("UploadedStaticBytes"), 0, what + ": static bytes");
  check.Equal(report->GetCount("UploadedOrderBytes"), 0, what + ": bytes of the order");
  check.Equal(report->GetCount("UploadedImageBytes"), 0, what + ": bytes of the image");
}

void TestReasons(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  check.That(
    scene.Drawer->GetReport()->GetText("PathReason").empty(), "no reason before the first frame");
  const ReportCopy report = scene.Draw(Blend::Composite);
  check.Equal(report->GetCount("RenderPath"), path, scene.Name + ": path");
  check.That(!report->GetText("PathReason").empty(), scene.Name + ": the path has a reason");
  check.That(!report->GetText("BlendReason").empty(), scene.Name + ": the blend mode has a reason");
  check.That(!report->GetText("SortReason").empty(), scene.Name + ": the sort mode has a reason");
  check.Equal(report->GetCount("Tetrahedra"), scene.GetCells(), scene.Name + ": tetrahedra");
  check.Equal(
    report->GetCount("TetrahedraDrawn"), scene.GetCells(), scene.Name + ": tetrahedra drawn");
  check.Equal(report->GetCount("TetrahedraClipped"), 0, scene.Name + ": tetrahedra clipped");
  check.Equal(report->GetCount("Passes"), 1, scene.Name + ": passes");
  check.Equal(report->GetCount("Layers"), 0, scene.Name + ": layers");
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
  check.Equal(
    without->GetCount("BlendMode"), Mapper::COMPOSITE_BLEND, scene.Name + ": automatic blend");
  AddLinearArray(scene.What.Grid, "DeltaT", 1.0, { { -0.8, 0.5, 0.3 } });
  const ReportCopy with = scene.Draw();
  check.That(HasFeature(with, "delta-t"), scene.Name + ": an extent in time");
  check.Equal(
    with->GetCount("BlendMode"), Mapper::OPTICAL_DEPTH_BLEND, scene.Name + ": automatic blend");
  check.Equal(
    with->GetCount("SortMode"), Mapper::NO_SORT, scene.Name + ": automatic blend is not sorted");
}

void TestOrder(Check& check, int path, bool parallel)
{
  const struct
  {
    Blend How;
    const char* Name;
  } modes[] = { { Blend::Additive, "additive" }, { Blend::MaximumIntensity, "maximum" },
    { Blend::Priority, "priority" }, { Blend::OpticalDepth, "optical depth" },
    { Blend::Composite, "composite of one color" } };
  for (const auto& mode : modes)
  {
    Scene scene(path, parallel);
    AddSlabIndices(scene.What.Grid, "IntervalId", 2, 3);
    if (mode.How == Blend::Composite)
    {
      scene.What.Property = MakeProperty({ { 0.0, Red, 0.1 }, { 1.0, Red, 1.0 } });
    }
    const std::string name = scene.Name + ", " + mode.Name;
    const ReportCopy report = scene.Draw(mode.How);
    check.Equal(report->GetCount("SortMode"), Mapper::NO_SORT, name + ": sort mode");
    check.That(!report->GetNumber("Sorted"), name + ": not sorted");
    check.That(!report->GetNumber("HasAdjacency"), name + ": no adjacency");
    const bool isPriority = mode.How == Blend::Priority;
    check.Equal(report->GetCount("UploadedOrderBytes"),
      isPriority && scene.IsOpenGL() ? 4 * scene.GetCells() : 0, name + ": bytes of the order");
    check.Equal(report->GetCount("Layers"), isPriority ? 3 : 0, name + ": layers");
    check.Equal(report->GetCount("Passes"), isPriority ? 3 : 1, name + ": passes");
    ExpectNoUploads(check, scene.Draw(), name + ", again");
    scene.What.Camera->Azimuth(10.0);
    const ReportCopy moved = scene.Draw();
    check.Equal(moved->GetCount("UploadedStaticBytes"), 0, name + ", moved: static bytes");
    check.Equal(moved->GetCount("UploadedOrderBytes"), 0, name + ", moved: bytes of the order");
    check.That(!moved->GetNumber("Sorted"), name + ", moved: not sorted");
  }
}

void TestSortedFrames(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  const vtkIdType orderBytes = scene.IsOpenGL() ? 4 * scene.GetCells() : 0;
  const ReportCopy first = scene.Draw(Blend::Composite);
  check.Equal(first->GetCount("SortMode"), Mapper::MPVONC_SORT, scene.Name + ": sort mode");
  check.That(first->GetNumber("Sorted") > 0, scene.Name + ": sorted");
  check.That(first->GetNumber("HasAdjacency") > 0, scene.Name + ": adjacency");
  check.Equal(
    first->GetCount("UploadedOrderBytes"), orderBytes, scene.Name + ": bytes of the order");
  // Unlike later frames, the first frame uploads data.
  check.That((first->GetNumber("UploadedStaticBytes") > 0) == scene.IsOpenGL(),
    scene.Name + ": static bytes");
  check.That((first->GetNumber("UploadedImageBytes") > 0) == !scene.IsOpenGL(),
    scene.Name + ": image bytes");
  ExpectNoUploads(check, scene.Draw(), scene.Name + ", still");
  ExpectNoUploads(check, scene.Draw(), scene.Name + ", still again");

  for (int step = 0; step < 3; ++step)
  {
    scene.What.Camera->Azimuth(10.0);
    const ReportCopy moved = scene.Draw();
    check.That(moved->GetNumber("Sorted") > 0, scene.Name + ", moved: sorted");
    check.Equal(moved->GetCount("UploadedStaticBytes"), 0, scene.Name + ", moved: static bytes");
    check.Equal(moved->GetCount("UploadedOrderBytes"), orderBytes,
      scene.Name + ", moved: bytes of the order");
    ExpectNoUploads(check, scene.Draw(), scene.Name + ", moved and still");
  }

  // Change only the colors.
  scene.What.Property->GetRGBTransferFunction()->AddRGBPoint(0.5, 0.0, 1.0, 0.0);
  const ReportCopy colored = scene.Draw();
  check.That(!colored->GetNumber("Sorted"), scene.Name + ", other colors: not sorted");
  check.Equal(
    colored->GetCount("UploadedOrderBytes"), 0, scene.Name + ", other colors: bytes of the order");
  if (scene.IsOpenGL())
  {
    check.That(colored->GetNumber("UploadedStaticBytes") > 0 &&
        colored->GetNumber("UploadedStaticBytes") < first->GetNumber("UploadedStaticBytes"),
      scene.Name + ", other colors: only the colors are uploaded");
  }
  else
  {
    check.Equal(colored->GetCount("UploadedImageBytes"), first->GetCount("UploadedImageBytes"),
      scene.Name + ", other colors: the image is uploaded again");
  }
  ExpectNoUploads(check, scene.Draw(), scene.Name + ", other colors, still");
}

void TestBoundary(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  const ReportCopy without = scene.Draw(Blend::Composite);
  check.Equal(without->GetCount("BoundaryTriangles"), 0, scene.Name + ": no triangles");
  check.That(!HasFeature(without, "surface"), scene.Name + ": no surface");
  // Use one face of the first tetrahedron.
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
  check.Equal(with->GetCount("BoundaryTriangles"), 1, scene.Name + ": one triangle");
  check.Equal(with->GetCount("UnmatchedTriangles"), 0, scene.Name + ": no unmatched triangle");
  check.That(HasFeature(with, "surface"), scene.Name + ": a surface");
  ExpectNoUploads(check, scene.Draw(), scene.Name + ", with a triangle, still");
  // Moving the camera uploads no static data: lights and cameras are passed as uniforms.
  scene.What.Camera->Azimuth(10.0);
  check.Equal(
    scene.Draw()->GetCount("UploadedStaticBytes"), 0, scene.Name + ", with a triangle, moved");
  scene.Drawer->SetBoundaryData(nullptr);
  const ReportCopy after = scene.Draw();
  check.Equal(after->GetCount("BoundaryTriangles"), 0, scene.Name + ": the triangle is removed");
  check.That(!HasFeature(after, "surface"), scene.Name + ": the surface is removed");
}

/// Tests that tetrahedra cut by the near plane are computed and uploaded once per view.
void TestNearPlane(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  double range[2];
  scene.What.Camera->GetClippingRange(range);
  scene.What.Camera->SetClippingRange(scene.What.Camera->GetDistance(), range[1]);
  const ReportCopy first = scene.Draw(Blend::Composite);
  check.That(
    first->GetNumber("TetrahedraClipped") > 0, scene.Name + ": the near plane clips tetrahedra");
  const ReportCopy still = scene.Draw();
  check.Equal(still->GetCount("TetrahedraClipped"), first->GetCount("TetrahedraClipped"),
    scene.Name + ": the second frame has the same number");
  ExpectNoUploads(check, still, scene.Name + ", cut by the near plane, still");
}

/// Tests that gaps, which only sorting finds, are not reported for frames without sorting.
void TestGaps(Check& check, int path, bool parallel)
{
  Scene scene(path, parallel);
  scene.What.Grid = MakeCube(3);
  AddSlabIndices(scene.What.Grid, "slab", 2, 3);
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
    scene.Name + ": a mesh in two parts has gaps");
  const ReportCopy unsorted = scene.Draw(Blend::Additive);
  check.That(!unsorted->GetNumber("Sorted"), scene.Name + ": additive after composite, not sorted");
  check.Equal(unsorted->GetCount("Gaps"), 0, scene.Name + ": additive after composite, gaps");
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
