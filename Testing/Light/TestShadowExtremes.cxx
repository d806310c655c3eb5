// SPDX-License-Identifier: BSD-3-Clause
// Extreme and invalid input of vtkShadowedSliceMapper: light positions, shapes and sizes of
// volumes, materials, non-finite values, light images and memory.
#include "Support/Pages/StabilityCase.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceShadowImage.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "Loader/OpenGLFunctions.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkProjectiveLight.h"
#include "vtkRenderWindow.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTestErrorObserver.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <limits>

namespace
{

using namespace reference;

/// Bound for a fuzzy sphere. It allows for the error of slabs that are one voxel thick and use one
/// sample at their center.
constexpr double Bound = 0.02;

class ShadowTable
{
public:
  ShadowTable(int argc, char* argv[])
    : Catalogue("TestShadowExtremes", argc, argv)
  {
    this->Catalogue.SetClass("vtkShadowedSliceMapper");
  }

  /// Compares the mapper's frame with the reference.
  void Measure(const std::string& name, const std::string& extreme, const ShadowScene& scene,
    double bound = Bound)
  {
    vtkNew<vtkShadowedSliceMapper> mapper;
    const RgbaImage found = DrawByMapper(mapper, scene);
    this->Measure(name, extreme, found, MakeShadowImage(scene), bound);
  }

  void Measure(const std::string& name, const std::string& extreme, const RgbaImage& found,
    const RgbaImage& expected, double bound)
  {
    const bool isSeen = LargestAlpha(expected) > 0.05;
    this->Catalogue.Measure(name, extreme, "largest channel error against the reference",
      isSeen ? CompareImages(found, expected).Max : std::nan(""), bound);
  }

  StabilityCatalogue Catalogue;
};

ShadowScene SphereScene()
{
  auto scene = MakeScene(MakeImage(24, MakeSphere(0.1, 0.45)), MakeTranslucentProperty(0.4, false));
  scene.Size = { { 48, 48 } };
  return scene;
}

void TestLightPositions(ShadowTable& table)
{
  auto scene = SphereScene();
  const auto measure = [&](const std::string& name, const std::string& extreme,
                         const vtkSmartPointer<vtkLight>& light, double bound = Bound)
  {
    scene.Lights = { light };
    for (bool parallel : { false, true })
    {
      const Double3 direction = { { -0.3, -0.4, -1.0 } };
      scene.Camera = LookAt(scene.Image, direction, parallel);
      table.Measure(name + (parallel ? "-parallel" : "-perspective"), extreme, scene, bound);
    }
  };
  measure(
    "light-inside", "a light inside the volume", MakePositionalLight({ { 0.1, 0.05, 0.15 } }));
  measure("light-inside-center", "a light at the center of the volume",
    MakePositionalLight({ { 0.0, 0.0, 1e-9 } }));
  Double3 cameraPosition;
  scene.Camera->GetPosition(cameraPosition.data());
  measure("light-at-eye", "a light at the camera", MakePositionalLight(cameraPosition));
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  head->SetIntensity(0.8);
  measure("headlight", "light along the view", head.Get());
  measure("light-opposite", "light exactly opposite to the view",
    MakeDirectionalLight({ { 0.3, 0.4, 1.0 } }));
  measure("light-opposite-point", "a light exactly opposite to the camera",
    MakePositionalLight({ { -cameraPosition[0], -cameraPosition[1], -cameraPosition[2] } }));
  measure("light-across", "light exactly perpendicular to the view",
    MakeDirectionalLight({ { 1.0, -0.75, 0.0 } }));
  // If the direction to the light is perpendicular to the view direction, as here, the slice order
  // switches between front-to-back and back-to-front.
  measure("light-in-slice-plane", "a light next to the volume, in the plane of a slice",
    MakePositionalLight({ { -0.8, 0.6, 0.0 } }));
  measure("light-distance-1e-3", "a light 1e-3 above the volume",
    MakePositionalLight({ { 0.0, 0.0, 0.501 } }));
  measure(
    "light-distance-1e+6", "a light 1e6 away", MakePositionalLight({ { -6e5, 4.8e5, 6.4e5 } }));
  scene.Lights = { MakeDirectionalLight({ { 0.0, 0.0, 0.0 } }) };
  vtkNew<vtkShadowedSliceMapper> mapper;
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  mapper->AddObserver(vtkCommand::WarningEvent, observer);
  const RgbaImage found = DrawByMapper(mapper, scene);
  scene.Lights.clear();
  vtkNew<vtkShadowedSliceMapper> without;
  const double difference = CompareImages(found, DrawByMapper(without, scene)).Max;
  table.Catalogue.Check("light-without-direction", "position and focal point the same",
    "an error, and the light is skipped",
    observer->GetErrorMessage() + observer->GetWarningMessage(),
    (observer->GetError() || observer->GetWarning()) && difference < 1e-6);
}

void TestShapes(ShadowTable& table)
{
  auto scene = SphereScene();
  scene.Image = MakeImage({ { 24, 24, 8 } }, { { 0.02, 0.02, 1.0 } }, MakeSphere(0.1, 0.45));
  scene.Property->SetScalarOpacityUnitDistance(0.5);
  for (const Double3& direction :
    { Double3{ { -0.3, -0.4, -1.0 } }, Double3{ { -1.0, -0.5, 0.01 } } })
  {
    scene.Camera = LookAt(scene.Image, direction, false);
    table.Measure(direction[2] < 0.0 ? "voxels-1-1-50-along" : "voxels-1-1-50-across",
      "voxels of 1:1:50", scene);
  }
  for (const double thickness : { 1e-6, 1e-9 })
  {
    auto sheet = SphereScene();
    sheet.Image =
      MakeImage({ { 24, 24, 8 } }, { { 1.0 / 24, 1.0 / 24, thickness } }, MakeSphere(0.1, 0.45));
    sheet.Property->SetScalarOpacityUnitDistance(10.0 * thickness);
    // The slices are parallel to the sheet.
    sheet.Camera = LookAt(sheet.Image, { { -0.3, -0.4, -1.0 } }, true);
    sheet.Lights = { MakeDirectionalLight({ { 0.3, 0.4, -1.0 } }) };
    vtkNew<vtkShadowedSliceMapper> mapper;
    const std::string name = thickness < 1e-8 ? "sheet-1e-9" : "sheet-1e-6";
    const std::string extreme = "voxels " + name.substr(6) + " thick, seen and lit obliquely";
    const RgbaImage found = DrawByMapper(mapper, sheet);
    table.Measure(name, extreme, found, MakeShadowImage(sheet), Bound);
    table.Catalogue.Measure(name + "-buffer", extreme,
      "texels across the light buffer, above the minimum of 64",
      mapper->GetReport()->GetNumber("LightBufferSize") - 64.0, 0.0);
  }
  for (double scale : { 1e-6, 1e6 })
  {
    auto scaled = SphereScene();
    scaled.Image = MakeImage(
      { { 24, 24, 24 } }, { { scale / 24, scale / 24, scale / 24 } }, MakeSphere(0.1, 0.45));
    scaled.Property->SetScalarOpacityUnitDistance(0.1 * scale);
    scaled.Camera = LookAt(scaled.Image, { { -0.3, -0.4, -1.0 } }, false);
    const std::string name = scale < 1.0 ? "scale-1e-6" : "scale-1e+6";
    table.Measure(name, "a volume of that size", scaled);
    scaled.Lights = { MakePositionalLight({ { -scale, 0.9 * scale, 1.1 * scale } }) };
    scaled.Lights[0]->SetAttenuationValues(1.0, 0.1 / scale, 0.1 / (scale * scale));
    table.Measure(name + "-positional", "a volume of that size, with light attenuation", scaled);
  }
  auto far = SphereScene();
  far.Image->SetOrigin(1e6 - 0.5, -1e6 - 0.5, 1e6 - 0.5);
  far.Camera = LookAt(far.Image, { { -0.3, -0.4, -1.0 } }, true);
  table.Measure("far-1e+6", "a volume of size 1, 1e6 away", far);
}

void TestMaterials(ShadowTable& table)
{
  // An opaque cube: its front face shows its color if lit from the front, and is black if lit from
  // behind.
  auto scene = MakeHomogeneousScene(8, 1.0);
  scene.Size = { { 16, 16 } };
  scene.Property->GetScalarOpacity()->RemoveAllPoints();
  scene.Property->GetScalarOpacity()->AddPoint(0.0, 1.0);
  scene.Property->SetScalarOpacityUnitDistance(0.01);
  scene.Camera = LookAt(scene.Image, { { 0.0, 0.0, -1.0 } }, true);
  const auto drawCenter = [&](double alongZ)
  {
    scene.Lights = { MakeDirectionalLight({ { 0.0, 0.0, alongZ } }) };
    scene.Lights[0]->SetIntensity(1.0);
    vtkNew<vtkShadowedSliceMapper> mapper;
    const RgbaImage found = DrawByMapper(mapper, scene);
    const double* pixel = found.At(8, 8);
    return std::array<double, 2>{ { pixel[0], pixel[3] } };
  };
  // At optical depth t, the transmittances toward the camera and toward the light are both exp(-t).
  // The integral of their product is 0.5.
  const std::array<double, 2> lit = drawCenter(-1.0);
  table.Catalogue.Measure("opaque-lit", "fully opaque, lit from the front",
    "alpha 1, half of the light", std::max(std::abs(lit[0] - 0.5), std::abs(lit[1] - 1.0)), 1e-3);
  const std::array<double, 2> dark = drawCenter(1.0);
  table.Catalogue.Measure("opaque-dark", "fully opaque, lit from behind", "alpha 1, black",
    std::max(std::abs(dark[0]), std::abs(dark[1] - 1.0)), 1e-3);
  scene.Property->GetScalarOpacity()->RemoveAllPoints();
  scene.Property->GetScalarOpacity()->AddPoint(0.0, 0.0);
  const std::array<double, 2> none = drawCenter(-1.0);
  table.Catalogue.Measure("transparent", "fully transparent", "an empty image",
    std::max(std::abs(none[0]), std::abs(none[1])), 0.0);

  auto solid = MakeScene(MakeImage(24, MakeSphere(0.4, 0.45)), MakeTranslucentProperty(1.0, false));
  solid.Size = { { 48, 48 } };
  solid.Property->SetScalarOpacityUnitDistance(1.0 / 24.0);
  vtkNew<vtkShadowedSliceMapper> mapper;
  const ImageError error = CompareImages(DrawByMapper(mapper, solid), MakeShadowImage(solid));
  table.Catalogue.Measure("opaque-ball", "opacity increases to 1 within a voxel",
    "mean channel error against the reference", error.Mean, 0.01);

  auto flat = MakeHomogeneousScene(8, 2.0);
  flat.Size = { { 32, 32 } };
  flat.Property->ShadeOn();
  flat.Property->SetAmbient(0.1);
  flat.Property->SetSpecular(0.5);
  table.Measure("zero-gradient", "shaded, with zero gradients", flat, 0.03);
}

/// Checks the Beer-Lambert law for slabs of very low optical depth.
void TestManySlices(ShadowTable& table)
{
  for (double tau : { 1e-3, 1.0, 8.0 })
  {
    auto scene = MakeHomogeneousScene(8, tau);
    scene.Size = { { 12, 12 } };
    scene.Camera = LookAt(scene.Image, { { 0.0, 0.0, -1.0 } }, true);
    for (double alongZ : { -1.0, 1.0 })
    {
      scene.Lights = { MakeDirectionalLight({ { 0.0, 0.0, alongZ } }) };
      scene.Lights[0]->SetIntensity(1.0);
      vtkNew<vtkShadowedSliceMapper> mapper;
      mapper->SetSliceSpacing(1.0 / 4096.0);
      const RgbaImage found = DrawByMapper(mapper, scene);
      const double alpha = -std::expm1(-tau);
      const double seen = alongZ < 0.0 ? -0.5 * std::expm1(-2.0 * tau) : tau * std::exp(-tau);
      const double error =
        std::max(std::abs(found.At(6, 6)[3] - alpha), std::abs(found.At(6, 6)[0] - seen));
      const std::string depth = tau < 0.1 ? "1e-3" : (tau < 2.0 ? "1" : "8");
      table.Catalogue.Measure("slices-4096-depth-" + depth + (alongZ < 0.0 ? "-front" : "-back"),
        "4,096 slices with a total optical depth of " + depth,
        "error of alpha and light from the closed form, relative to alpha",
        mapper->GetReport()->GetNumber("Slices") >= 4096 ? error / alpha : std::nan(""), 1e-3);
    }
  }
}

void TestNan(ShadowTable& table)
{
  auto scene = SphereScene();
  vtkDataArray* values = scene.Image->GetPointData()->GetScalars();
  vtkIdType count = 0;
  for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
  {
    double x[3];
    scene.Image->GetPoint(id, x);
    if (x[0] > 0.05 && x[1] > -0.1)
    {
      values->SetComponent(id, 0,
        id % 3 == 0 ? std::numeric_limits<double>::infinity()
                    : std::numeric_limits<double>::quiet_NaN());
      ++count;
    }
  }
  vtkNew<vtkShadowedSliceMapper> mapper;
  int warnings = 0;
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::WarningEvent, observer);
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  RgbaImage found;
  for (int frame = 0; frame < 3; ++frame)
  {
    found = stage.Capture();
    warnings += observer->GetWarning() ? 1 : 0;
    observer->Clear();
    scene.Camera->Modified();
  }
  table.Measure(
    "nan", "a quarter of the voxels are NaN or infinite", found, MakeShadowImage(scene), 0.03);
  const vtkIdType counted = mapper->GetReport()->GetNumber("NonFiniteVoxels");
  table.Catalogue.Check("nan-counted", "voxels that are NaN or infinite", "all are counted",
    std::to_string(counted) + " of " + std::to_string(count), counted == count);
  table.Catalogue.Check("nan-warned", "voxels that are NaN or infinite", "one warning",
    std::to_string(warnings) + " of three images with a warning", warnings == 1);
  values->Fill(std::nan(""));
  values->Modified();
  scene.Image->Modified();
  table.Catalogue.Measure(
    "nan-all", "all voxels are NaN", "an empty image", LargestAlpha(stage.Capture()), 0.0);
}

void TestScreens(ShadowTable& table)
{
  auto scene = SphereScene();
  vtkNew<vtkProjectiveLight> light;
  light->PositionalOn();
  light->SetConeAngle(180.0);
  light->SetPosition(-0.9, 1.0, 1.2);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetScreenSize(3.0, 3.0);
  vtkNew<vtkImageData> slide;
  slide->SetDimensions(1, 1, 1);
  slide->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  slide->GetPointData()->GetScalars()->SetTuple3(0, 200.0, 100.0, 50.0);
  light->SetImage(slide);
  scene.Lights = { light.Get() };
  table.Measure("screen-1x1", "a light's image of one sample", scene);
  vtkNew<vtkImageData> missing;
  light->SetImage(missing);
  scene.Lights.push_back(MakeDirectionalLight({ { 1.0, -1.0, -1.0 } }));
  vtkNew<vtkShadowedSliceMapper> mapper;
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  const RgbaImage found = DrawByMapper(mapper, scene);
  table.Catalogue.Check("screen-missing", "a light's image without samples", "an error",
    observer->GetErrorMessage(), observer->GetError());
  scene.Lights.erase(scene.Lights.begin());
  table.Measure("screen-missing-others", "a light's image without samples, and another light",
    found, MakeShadowImage(scene), Bound);
}

/// Expects an error message that contains \a word, and an unchanged frame.
void ExpectError(ShadowTable& table, const std::string& name, const std::string& extreme,
  const std::string& word,
  const std::function<void(vtkShadowedSliceMapper*, ShadowScene&)>& invalidate)
{
  auto scene = SphereScene();
  vtkNew<vtkShadowedSliceMapper> mapper;
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  const RgbaImage before = stage.Capture();
  const bool wasValid = !observer->GetError() && LargestAlpha(before) > 0.1;
  invalidate(mapper, scene);
  const RgbaImage after = stage.Capture();
  const std::string message = observer->GetErrorMessage();
  table.Catalogue.Check(name, extreme, "an error with '" + word + "'", message,
    wasValid && message.find(word) != std::string::npos);
  table.Catalogue.Measure(name + "-picture", extreme, "the image of the previous frame",
    CompareImages(after, before).Max, 0.0);
  // Expects an empty image from a mapper that has not drawn any frame yet.
  vtkNew<vtkShadowedSliceMapper> fresh;
  observer->Clear();
  fresh->AddObserver(vtkCommand::ErrorEvent, observer);
  auto first = SphereScene();
  VolumeStage empty(first.Size);
  SetScene(empty, fresh, first);
  invalidate(fresh, first);
  table.Catalogue.Measure(name + "-first", extreme + ", for the first image", "an empty image",
    LargestAlpha(empty.Capture()), 0.0);
  const std::string firstMessage = observer->GetErrorMessage();
  table.Catalogue.Check(name + "-first-error", extreme + ", for the first image",
    "an error with '" + word + "'", firstMessage, firstMessage.find(word) != std::string::npos);
}

vtkSmartPointer<vtkImageData> MakeBytes(const std::array<int, 3>& size, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], size[2]);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  image->GetPointData()->GetScalars()->Fill(100.0);
  return image;
}

void TestErrors(ShadowTable& table)
{
  GLint limit = 0;
  {
    VolumeStage stage(std::array<int, 2>{ { 8, 8 } });
    stage.Render();
    stage.GetWindow()->MakeCurrent();
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limit);
  }
  const auto setInput = [](const vtkSmartPointer<vtkImageData>& image) {
    return [image](vtkShadowedSliceMapper* mapper, ShadowScene&) { mapper->SetInputData(image); };
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<int, 3> size = { { 1, 1, 1 } };
    size[axis] = limit + 1;
    std::string name = "volume-above-limit-";
    name.append(1, "xyz"[axis]);
    ExpectError(table, name, "one voxel more than the maximum of a texture", std::to_string(limit),
      setInput(MakeBytes(size, 1)));
  }
  ExpectError(table, "memory", "a texture limit of 1,000 bytes", "MaximumTextureMemory",
    [](vtkShadowedSliceMapper* mapper, ShadowScene&) { mapper->SetMaximumTextureMemory(1000); });
  ExpectError(table, "no-scalars", "an image without scalars", "calar",
    [](vtkShadowedSliceMapper* mapper, ShadowScene&)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(3, 3, 3);
      mapper->SetInputData(image);
    });
  ExpectError(table, "missing-array", "an array that does not exist", "nowhere",
    [](vtkShadowedSliceMapper* mapper, ShadowScene&)
    {
      mapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
      mapper->SelectScalarArray("nowhere");
    });
  ExpectError(table, "blend-mode", "maximum intensity", "lend",
    [](vtkShadowedSliceMapper* mapper, ShadowScene&) { mapper->SetBlendModeToMaximumIntensity(); });
  ExpectError(table, "three-dependent", "three dependent components", "three",
    [](vtkShadowedSliceMapper* mapper, ShadowScene& scene)
    {
      scene.Property->IndependentComponentsOff();
      mapper->SetInputData(MakeBytes({ { 4, 4, 4 } }, 3));
    });
  ExpectError(table, "five-components", "five components", "5 components",
    setInput(MakeBytes({ { 4, 4, 4 } }, 5)));
}

}

int TestShadowExtremes(int argc, char* argv[])
{
  ShadowTable table(argc, argv);
  TestLightPositions(table);
  TestShapes(table);
  TestMaterials(table);
  TestManySlices(table);
  TestNan(table);
  TestErrors(table);
  table.Catalogue.SetClass("vtkProjectiveLight");
  TestScreens(table);
  return table.Catalogue.GetExitCode();
}
