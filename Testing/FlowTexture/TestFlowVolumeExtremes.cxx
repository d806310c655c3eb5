// SPDX-License-Identifier: BSD-3-Clause
// Extreme and invalid input of vtkImplicitFlowVolumeMapper.
#include "FlowDrawing.h"

#include "Support/Checks/ReferenceMessages.h"
#include "Support/Pages/StabilityCase.h"
#include "Support/Images/CameraSettings.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>

namespace
{

using namespace reference;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();

FlowScene MakeScene()
{
  FlowScene scene = MakeBlobScene();
  scene.Size = { { 32, 32 } };
  return scene;
}

class FlowTable
{
public:
  FlowTable(int argc, char* argv[])
    : Catalogue("TestFlowVolumeExtremes", argc, argv)
  {
    this->Catalogue.SetClass("vtkImplicitFlowVolumeMapper");
  }

  /// Records the largest difference between two images.
  void ExpectImage(const std::string& name, const std::string& extreme, const RgbaImage& found,
    const RgbaImage& expected, double bound, bool isSeen = true)
  {
    const bool isVisibilityExpected = (LargestAlpha(expected) > 0.05) == isSeen;
    this->Catalogue.Measure(name, extreme,
      isSeen ? "the image without the extreme, largest channel difference" : "nothing is drawn",
      isVisibilityExpected ? CompareImages(found, expected).Max : NotANumber, bound);
  }

  /// Expects one error that contains \a words, and an empty image.
  template <typename Change>
  void ExpectError(const std::string& name, const std::string& extreme, const std::string& words,
    const Change& change)
  {
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    mapper->SetInflowTexture(0, MakePaint(17, 17, &Blob));
    vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(9, &Uniform);
    vtkNew<vtkVolumeProperty> property;
    RgbaImage found;
    const std::string message = CaptureErrors(mapper,
      [&]()
      {
        change(mapper, voxels, property);
        found = DrawFlow(mapper, voxels, MakeScene(), property);
      });
    this->Catalogue.Check(name, extreme, "an error that contains " + words, message,
      message.find(words) != std::string::npos && LargestAlpha(found) == 0.0);
  }

  StabilityCatalogue Catalogue;
};

RgbaImage Draw(
  vtkImageData* voxels, const FlowScene& scene, vtkImageData* paint = MakePaint(129, 129, &Blob))
{
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInflowTexture(vtkImplicitFlowVolumeMapper::ALL, paint);
  return DrawFlow(mapper, voxels, scene);
}

void TestSizes(FlowTable& table)
{
  const FlowScene plain = MakeScene();
  vtkSmartPointer<vtkImageData> paint = MakePaint(129, 129, &Blob);
  const RgbaImage expected = Draw(MakeFlowVoxels(17, &Uniform), plain, paint);
  for (const double scale : { 1e-6, 1e6 })
  {
    vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(17, &Uniform);
    voxels->SetOrigin(-0.5 * scale, -0.5 * scale, -0.5 * scale);
    voxels->SetSpacing(scale / 16.0, scale / 16.0, scale / 16.0);
    FlowScene scene = MakeScene();
    scene.UnitDistance *= scale;
    scene.Camera = LookAt({ { 0.0, 0.0, 0.0 } }, 0.87 * scale, { { -0.5, 0.6, -0.4 } }, false);
    table.ExpectImage(scale < 1.0 ? "size-1e-6" : "size-1e+6", "a volume of that size",
      Draw(voxels, scene, paint), expected, 1e-4);
  }
  vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(17, &Uniform);
  voxels->SetOrigin(1e6 - 0.5, -1e6 - 0.5, 1e6 - 0.5);
  FlowScene far = MakeScene();
  far.Camera = LookAt({ { 1e6, -1e6, 1e6 } }, 0.87, { { -0.5, 0.6, -0.4 } }, false);
  table.ExpectImage(
    "far-1e+6", "a volume of size 1, 1e6 away", Draw(voxels, far, paint), expected, 1e-3);

  // Two points along each axis form a single cell, in which uniform flow is linear.
  FlowScene coarse = MakeScene();
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInflowTexture(0, paint);
  mapper->SetSampleDistance(1.0 / 32.0);
  table.ExpectImage("one-cell", "two points along each axis",
    DrawFlow(mapper, MakeFlowVoxels(2, &Uniform), coarse), expected, 2e-3);
  vtkNew<vtkImplicitFlowVolumeMapper> tiny;
  tiny->SetInflowTexture(0, paint);
  tiny->TextureFilterOff();
  FlowScene small = MakeScene();
  small.Size = { { 4, 4 } };
  for (const auto& [distance, text] :
    std::map<double, std::string>{ { 1e-300, "1e-300" }, { 1e-12, "1e-12" } })
  {
    tiny->SetSampleDistance(distance);
    table.ExpectImage("samples-" + text, "samples " + text + " apart, limited to 6,000",
      DrawFlow(tiny, MakeFlowVoxels(3, &Uniform), small), MakeFlowReferenceImage(small), 1e-2);
  }

  // Compares the image of a camera inside the volume with the formula.
  FlowScene inside = MakeScene();
  inside.Camera->SetPosition(0.1, 0.05, 0.1);
  inside.Camera->SetFocalPoint(-0.4, 0.1, -0.3);
  inside.Camera->SetClippingRange(0.001, 3.0);
  table.ExpectImage("eye-inside", "the camera inside the volume",
    Draw(MakeFlowVoxels(33, &Uniform), inside, paint), MakeFlowReferenceImage(inside), 5e-3);
}

// A sample counts once, whichever of its values are not finite.
void TestNonFiniteCount(FlowTable& table)
{
  vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(5, &Uniform);
  voxels->GetPointData()->GetArray("TerminationUV")->SetComponent(7, 1, NotANumber);
  voxels->GetPointData()->GetArray("AdvectionTime")->SetComponent(7, 0, NotANumber);
  voxels->GetPointData()->GetArray("AdvectionTime")->SetComponent(8, 0, NotANumber);
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->AddObserver(vtkCommand::WarningEvent, observer);
  mapper->SetOpacityArray("AdvectionTime");
  DrawFlow(mapper, voxels, MakeScene());
  const vtkIdType count = mapper->GetReport()->GetCount("NonFiniteSamples");
  table.Catalogue.Check("nan-count", "nan in several arrays", "two samples",
    std::to_string(count) + " samples", count == 2);
}

void TestValues(FlowTable& table)
{
  FlowScene scene = MakeScene();
  const auto hole = [](const Position3& x) { return std::abs(x[0]) < 0.2 && x[1] > -0.1; };
  const auto holed = [&](const Position3& x)
  {
    FlowEnd end = Uniform(x);
    end.IsReached = !hole(x);
    return end;
  };
  const RgbaImage expected = Draw(MakeFlowVoxels(17, holed), scene);
  for (const char* name : { "TerminationUV", "AdvectionTime" })
  {
    for (const double value : { NotANumber, std::numeric_limits<double>::infinity() })
    {
      vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(17, &Uniform);
      for (vtkIdType i = 0; i < voxels->GetNumberOfPoints(); ++i)
      {
        Position3 x;
        voxels->GetPoint(i, x.data());
        if (hole(x))
        {
          voxels->GetPointData()->GetArray(name)->SetComponent(i, 0, value);
        }
      }
      vtkNew<vtkTest::ErrorObserver> observer;
      vtkNew<vtkImplicitFlowVolumeMapper> mapper;
      mapper->AddObserver(vtkCommand::WarningEvent, observer);
      mapper->SetInflowTexture(0, MakePaint(129, 129, &Blob));
      const RgbaImage found = DrawFlow(mapper, voxels, scene);
      const std::string kind = std::isnan(value) ? "nan" : "infinity";
      table.ExpectImage(kind + "-" + name, kind + " in " + name, found, expected, 0.0);
      table.Catalogue.Check(kind + "-warning-" + name, kind + " in " + name, "a warning",
        observer->GetWarningMessage(),
        observer->GetWarningMessage().find("not finite") != std::string::npos);
    }
  }
  TestNonFiniteCount(table);
  FlowScene nothing = MakeScene();
  const auto none = [](const Position3&) { return FlowEnd{ false, -1, 0.0, 0.0, 0.0 }; };
  const RgbaImage empty = Draw(MakeFlowVoxels(9, none), nothing);
  table.ExpectImage("nothing-reached", "no sample reached a surface", empty, empty, 0.0, false);

  // Surfaces without a texture have the default color.
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetDefaultColor(0.2, 0.4, 0.6, 0.5);
  const RgbaImage plain = DrawFlow(mapper, MakeFlowVoxels(9, &Uniform), scene);
  FlowScene colored = MakeScene();
  colored.Paint = [](const FlowEnd&) { return Color4{ { 0.2, 0.4, 0.6, 0.5 } }; };
  table.ExpectImage(
    "no-texture", "an id without a texture", plain, MakeFlowReferenceImage(colored), 1e-3);

  // Texture coordinates far outside [0, 1] have the color of the texture's edge.
  const auto outside = [](const Position3& x) {
    return FlowEnd{ true, 0, 1e6 + x[0], -1e6, 1e30 };
  };
  FlowScene edge = MakeScene();
  edge.Paint = [](const FlowEnd&) { return Color4{ { 1.0, 0.0, 0.5, 0.4 } }; };
  table.ExpectImage("places-1e+6", "u and v a million outside the texture",
    Draw(MakeFlowVoxels(9, outside), edge,
      MakePaint(8, 8,
        [](double u, double v) {
          return u > 0.9 && v < 0.1 ? Color4{ { 1, 0, 0.5, 0.4 } } : Color4{ { 0, 1, 0, 1 } };
        })),
    MakeFlowReferenceImage(edge), 1e-3);

  // A texture of very low opacity, and an opaque texture.
  FlowScene thin = MakeScene();
  // The mapper stores texture values with 16 bits.
  constexpr double faint = 66.0 / 65535.0;
  thin.Paint = [=](const FlowEnd&) { return Color4{ { 1.0, 1.0, 1.0, faint } }; };
  table.ExpectImage("alpha-1e-3",
    "a texture of opacity 1e-3, with a unit distance of a third of the volume's size",
    Draw(MakeFlowVoxels(9, &Uniform), thin,
      MakePaint(4, 4,
        [](double, double) {
          return Color4{ { 1, 1, 1, faint } };
        })),
    MakeFlowReferenceImage(thin), 2e-6, false);
  FlowScene solid = MakeScene();
  solid.Paint = [](const FlowEnd&) { return Color4{ { 0.3, 0.6, 0.9, 1.0 } }; };
  table.ExpectImage("alpha-1", "an opaque texture",
    Draw(MakeFlowVoxels(9, &Uniform), solid,
      MakePaint(4, 4,
        [](double, double) {
          return Color4{ { 0.3, 0.6, 0.9, 1.0 } };
        })),
    MakeFlowReferenceImage(solid), 1e-4);
}

void TestErrors(FlowTable& table)
{
  using Mapper = vtkImplicitFlowVolumeMapper;
  for (const char* name : { "FlowStatus", "TerminationId", "TerminationUV", "AdvectionTime" })
  {
    table.ExpectError(std::string("missing-") + name, std::string("no array ") + name, name,
      [&](Mapper*, vtkImageData* voxels, vtkVolumeProperty*)
      { voxels->GetPointData()->RemoveArray(name); });
  }
  table.ExpectError("components", "TerminationUV with one component", "TerminationUV",
    [](Mapper*, vtkImageData* voxels, vtkVolumeProperty*)
    {
      auto one = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_FLOAT));
      one->SetName("TerminationUV");
      one->SetNumberOfTuples(voxels->GetNumberOfPoints());
      voxels->GetPointData()->AddArray(one);
    });
  table.ExpectError("image-3d", "a three-dimensional inflow texture", "inflow texture of id 0",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(3, 3, 3);
      image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
      mapper->SetInflowTexture(0, image);
    });
  table.ExpectError("image-int", "an inflow texture of int", "type int",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(3, 3, 1);
      image->AllocateScalars(VTK_INT, 4);
      mapper->SetInflowTexture(0, image);
    });
  table.ExpectError("image-empty", "a detail texture without scalars", "detail texture",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(3, 3, 1);
      mapper->SetDetailTexture(image);
    });
  table.ExpectError("image-large", "an inflow texture of 100,000 columns", "at most",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(100000, 2, 1);
      image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
      mapper->SetInflowTexture(0, image);
    });
  table.ExpectError("memory", "a limit of 1000 bytes", "MaximumTextureMemory",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    { mapper->SetMaximumTextureMemory(1000); });
  table.ExpectError("opacity-array", "an opacity array that does not exist", "\"Nothing\"",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*) { mapper->SetOpacityArray("Nothing"); });
  table.ExpectError("shading-array", "a two-component shading array", "2 components",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty* property)
    {
      property->ShadeOn();
      mapper->SetShadingArray("TerminationUV");
    });
  table.ExpectError("blend-mode", "maximum intensity", "composite",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    { mapper->SetBlendModeToMaximumIntensity(); });

  vtkNew<Mapper> mapper;
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 1.0, 1.0);
  grid->SetPoints(points);
  mapper->SetInputDataObject(0, grid);
  VolumeStage stage(std::array<int, 2>{ { 8, 8 } });
  vtkNew<vtkVolumeProperty> property;
  stage.SetVolume(mapper, property);
  const std::string message = CaptureErrors(mapper, [&]() { stage.Render(); });
  table.Catalogue.Check("unstructured", "an unstructured grid", "an error that names the solution",
    message, message.find("SAMPLES_OF_IMAGE") != std::string::npos);
}
}

int TestFlowVolumeExtremes(int argc, char* argv[])
{
  FlowTable table(argc, argv);
  TestSizes(table);
  TestValues(table);
  TestErrors(table);
  return table.Catalogue.GetExitCode();
}
