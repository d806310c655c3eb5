// SPDX-License-Identifier: BSD-3-Clause
// Extremes and bad input of vtkImplicitFlowVolumeMapper, each by its name.
#include "FlowDrawing.h"

#include "Support/Checks/ReferenceMessages.h"
#include "Support/Pages/StabilityCase.h"
#include "Support/Pictures/PictureSettings.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>
#include <sstream>

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

  /// The largest difference of two pictures.
  void Same(const std::string& name, const std::string& extreme, const RgbaPicture& found,
    const RgbaPicture& expected, double bound, bool isSeen = true)
  {
    const bool isRight = (LargestAlpha(expected) > 0.05) == isSeen;
    this->Catalogue.Measure(name, extreme,
      isSeen ? "the picture without it, largest channel difference" : "nothing is drawn",
      isRight ? ComparePictures(found, expected).Max : NotANumber, bound);
  }

  /// An error that has these words, once, and no picture.
  template <typename Change>
  void Wrong(const std::string& name, const std::string& extreme, const std::string& words,
    const Change& change)
  {
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    mapper->SetInflowTexture(0, MakePaint(17, 17, &Blob));
    vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(9, &Uniform);
    vtkNew<vtkVolumeProperty> property;
    RgbaPicture found;
    const std::string message = ErrorsOf(mapper,
      [&]()
      {
        change(mapper, voxels, property);
        found = DrawFlow(mapper, voxels, MakeScene(), property);
      });
    this->Catalogue.Check(name, extreme, "an error that names it: " + words, message,
      message.find(words) != std::string::npos && LargestAlpha(found) == 0.0);
  }

  StabilityCatalogue Catalogue;
};

RgbaPicture Draw(
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
  const RgbaPicture expected = Draw(MakeFlowVoxels(17, &Uniform), plain, paint);
  for (const double scale : { 1e-6, 1e6 })
  {
    vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(17, &Uniform);
    voxels->SetOrigin(-0.5 * scale, -0.5 * scale, -0.5 * scale);
    voxels->SetSpacing(scale / 16.0, scale / 16.0, scale / 16.0);
    FlowScene scene = MakeScene();
    scene.UnitDistance *= scale;
    scene.Camera = LookAt({ { 0.0, 0.0, 0.0 } }, 0.87 * scale, { { -0.5, 0.6, -0.4 } }, false);
    table.Same(scale < 1.0 ? "size-1e-6" : "size-1e+6", "a volume of that size",
      Draw(voxels, scene, paint), expected, 1e-4);
  }
  vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(17, &Uniform);
  voxels->SetOrigin(1e6 - 0.5, -1e6 - 0.5, 1e6 - 0.5);
  FlowScene far = MakeScene();
  far.Camera = LookAt({ { 1e6, -1e6, 1e6 } }, 0.87, { { -0.5, 0.6, -0.4 } }, false);
  table.Same("far-1e+6", "a volume of size 1, 1e6 away", Draw(voxels, far, paint), expected, 1e-3);

  // Two points along each axis are one cell: uniform flow is linear in it.
  FlowScene coarse = MakeScene();
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInflowTexture(0, paint);
  mapper->SetSampleDistance(1.0 / 32.0);
  table.Same("one-cell", "two points along each axis",
    DrawFlow(mapper, MakeFlowVoxels(2, &Uniform), coarse), expected, 2e-3);
  vtkNew<vtkImplicitFlowVolumeMapper> tiny;
  tiny->SetInflowTexture(0, paint);
  tiny->SetSampleDistance(1e-300);
  FlowScene small = MakeScene();
  small.Size = { { 4, 4 } };
  tiny->SetSampleDistance(1e-12);
  tiny->PaintFilterOff();
  tiny->SetSampleDistance(1e-12);
  const RgbaPicture many = DrawFlow(tiny, MakeFlowVoxels(3, &Uniform), small);
  table.Same("samples-1e-12", "samples 1e-12 apart, of which there are 6,000", many,
    MakeFlowPicture(small), 1e-2);

  // From within the volume, against the formula.
  FlowScene inside = MakeScene();
  inside.Camera->SetPosition(0.1, 0.05, 0.1);
  inside.Camera->SetFocalPoint(-0.4, 0.1, -0.3);
  inside.Camera->SetClippingRange(0.001, 3.0);
  table.Same("eye-inside", "the eye inside the volume",
    Draw(MakeFlowVoxels(33, &Uniform), inside, paint), MakeFlowPicture(inside), 5e-3);
}

void TestValues(FlowTable& table)
{
  FlowScene scene = MakeScene();
  const auto hole = [](const Place3& x) { return std::abs(x[0]) < 0.2 && x[1] > -0.1; };
  const auto holed = [&](const Place3& x)
  {
    FlowEnd answer = Uniform(x);
    answer.IsReached = !hole(x);
    return answer;
  };
  const RgbaPicture expected = Draw(MakeFlowVoxels(17, holed), scene);
  for (const char* name : { "TerminationUV", "AdvectionTime" })
  {
    for (const double value : { NotANumber, std::numeric_limits<double>::infinity() })
    {
      vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(17, &Uniform);
      for (vtkIdType i = 0; i < voxels->GetNumberOfPoints(); ++i)
      {
        Place3 x;
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
      const RgbaPicture found = DrawFlow(mapper, voxels, scene);
      const std::string kind = std::isnan(value) ? "nan" : "infinity";
      table.Same(kind + "-" + name, kind + " in " + name, found, expected, 0.0);
      table.Catalogue.Check(kind + "-warning-" + name, kind + " in " + name, "a warning",
        observer->GetWarningMessage(),
        observer->GetWarningMessage().find("not finite") != std::string::npos);
    }
  }
  FlowScene nothing = MakeScene();
  const auto none = [](const Place3&) { return FlowEnd{ false, -1, 0.0, 0.0, 0.0 }; };
  const RgbaPicture empty = Draw(MakeFlowVoxels(9, none), nothing);
  table.Same("nothing-reached", "no sample reached a surface", empty, empty, 0.0, false);

  // Surfaces without a texture have the default colour.
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetDefaultColor(0.2, 0.4, 0.6, 0.5);
  const RgbaPicture plain = DrawFlow(mapper, MakeFlowVoxels(9, &Uniform), scene);
  FlowScene colored = MakeScene();
  colored.Paint = [](const FlowEnd&) { return Color4{ { 0.2, 0.4, 0.6, 0.5 } }; };
  table.Same("no-texture", "an id without a texture", plain, MakeFlowPicture(colored), 1e-3);

  // Places far beyond the texture have its edge.
  const auto beyond = [](const Place3& x) { return FlowEnd{ true, 0, 1e6 + x[0], -1e6, 1e30 }; };
  FlowScene edge = MakeScene();
  edge.Paint = [](const FlowEnd&) { return Color4{ { 1.0, 0.0, 0.5, 0.4 } }; };
  table.Same("places-1e+6", "u and v a million beyond the texture",
    Draw(MakeFlowVoxels(9, beyond), edge,
      MakePaint(8, 8,
        [](double u, double v) {
          return u > 0.9 && v < 0.1 ? Color4{ { 1, 0, 0.5, 0.4 } } : Color4{ { 0, 1, 0, 1 } };
        })),
    MakeFlowPicture(edge), 1e-3);

  // Opaque paint in an instant, and paint that is nearly nothing.
  FlowScene thin = MakeScene();
  // Textures have sixteen bits.
  constexpr double faint = 66.0 / 65535.0;
  thin.Paint = [=](const FlowEnd&) { return Color4{ { 1.0, 1.0, 1.0, faint } }; };
  table.Same("alpha-1e-3", "paint of opacity 1e-3, a unit distance of the volume's size / 3",
    Draw(MakeFlowVoxels(9, &Uniform), thin,
      MakePaint(4, 4,
        [](double, double) {
          return Color4{ { 1, 1, 1, faint } };
        })),
    MakeFlowPicture(thin), 2e-6, false);
  FlowScene solid = MakeScene();
  solid.Paint = [](const FlowEnd&) { return Color4{ { 0.3, 0.6, 0.9, 1.0 } }; };
  table.Same("alpha-1", "opaque paint",
    Draw(MakeFlowVoxels(9, &Uniform), solid,
      MakePaint(4, 4,
        [](double, double) {
          return Color4{ { 0.3, 0.6, 0.9, 1.0 } };
        })),
    MakeFlowPicture(solid), 1e-4);
}

void TestWrong(FlowTable& table)
{
  using Mapper = vtkImplicitFlowVolumeMapper;
  for (const char* name : { "FlowStatus", "TerminationId", "TerminationUV", "AdvectionTime" })
  {
    table.Wrong(std::string("missing-") + name, std::string("no array ") + name, name,
      [&](Mapper*, vtkImageData* voxels, vtkVolumeProperty*)
      { voxels->GetPointData()->RemoveArray(name); });
  }
  table.Wrong("components", "TerminationUV with one component", "TerminationUV",
    [](Mapper*, vtkImageData* voxels, vtkVolumeProperty*)
    {
      auto one = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_FLOAT));
      one->SetName("TerminationUV");
      one->SetNumberOfTuples(voxels->GetNumberOfPoints());
      voxels->GetPointData()->AddArray(one);
    });
  table.Wrong("image-3d", "an inflow texture of three dimensions", "inflow texture of id 0",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(3, 3, 3);
      image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
      mapper->SetInflowTexture(0, image);
    });
  table.Wrong("image-int", "an inflow texture of int", "type int",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(3, 3, 1);
      image->AllocateScalars(VTK_INT, 4);
      mapper->SetInflowTexture(0, image);
    });
  table.Wrong("image-empty", "a detail texture without scalars", "detail texture",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(3, 3, 1);
      mapper->SetDetailTexture(image);
    });
  table.Wrong("image-large", "an inflow texture of 100,000 columns", "at most",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(100000, 2, 1);
      image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
      mapper->SetInflowTexture(0, image);
    });
  table.Wrong("memory", "a limit of 1000 bytes", "MaximumTextureMemory",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*)
    { mapper->SetMaximumTextureMemory(1000); });
  table.Wrong("opacity-array", "an opacity array that is not there", "\"Nothing\"",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty*) { mapper->SetOpacityArray("Nothing"); });
  table.Wrong("shading-array", "a shading array of two components", "2 components",
    [](Mapper* mapper, vtkImageData*, vtkVolumeProperty* property)
    {
      property->ShadeOn();
      mapper->SetShadingArray("TerminationUV");
    });
  table.Wrong("blend-mode", "maximum intensity", "composite",
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
  const std::string message = ErrorsOf(mapper, [&]() { stage.Render(); });
  table.Catalogue.Check("unstructured", "an unstructured grid", "an error that says what to do",
    message, message.find("SAMPLES_OF_IMAGE") != std::string::npos);
}
}

int TestFlowVolumeExtremes(int argc, char* argv[])
{
  FlowTable table(argc, argv);
  TestSizes(table);
  TestValues(table);
  TestWrong(table);
  return table.Catalogue.GetExitCode();
}
