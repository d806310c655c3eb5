// SPDX-License-Identifier: BSD-3-Clause
// vtkImplicitFlowVolumeMapper with other props: occlusion by opaque props, clipping planes,
// cropping, several renderers, selection, and the same flow drawn with vtkFlowVolume.
#include "FlowDrawing.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/LargestError.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkFlowVolume.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerminationPlane.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <iostream>

namespace
{

using namespace reference;

vtkSmartPointer<vtkImageData> MakeBlob()
{
  return MakePaint(129, 129, &Blob);
}

/// Compares each kind of clipping with the formula.
void TestCuts(Check& check)
{
  FlowScene scene = MakeBlobScene();
  const auto compare = [&](
                         vtkImplicitFlowVolumeMapper* mapper, const std::string& what, double bound)
  {
    mapper->SetInflowTexture(0, MakeBlob());
    const ImageError error = CompareImages(
      DrawFlow(mapper, MakeFlowVoxels(33, &Uniform), scene), MakeFlowReferenceImage(scene, 800));
    std::cout << what << ": " << error << "\n";
    check.That(error.Max <= bound, what + ": largest error " + std::to_string(error.Max));
  };
  vtkNew<vtkImplicitFlowVolumeMapper> full;
  compare(full, "full cube", 2e-3);
  scene.IsRetained = [](const Position3& x) { return x[0] + 2.0 * x[2] > 0.1; };
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.1, 0.0, 0.0);
  plane->SetNormal(1.0, 0.0, 2.0);
  vtkNew<vtkImplicitFlowVolumeMapper> clipped;
  clipped->AddClippingPlane(plane);
  compare(clipped, "clipped", 2e-3);
  scene.IsRetained = [](const Position3& x)
  { return x[0] > -0.3 && x[0] < 0.2 && x[1] > -0.1 && x[2] < 0.25; };
  vtkNew<vtkImplicitFlowVolumeMapper> cropped;
  cropped->CroppingOn();
  cropped->SetCroppingRegionPlanes(-0.3, 0.2, -0.1, 0.6, -0.6, 0.25);
  compare(cropped, "cropped", 2e-3);
  scene.IsRetained = [](const Position3& x) {
    return !(x[0] > -0.3 && x[0] < 0.2 && x[1] > -0.1 && x[1] < 0.6 && x[2] > -0.6 && x[2] < 0.25);
  };
  vtkNew<vtkImplicitFlowVolumeMapper> inverse;
  inverse->CroppingOn();
  inverse->SetCroppingRegionPlanes(-0.3, 0.2, -0.1, 0.6, -0.6, 0.25);
  inverse->SetCroppingRegionFlags(0x7ffdfff);
  compare(inverse, "cube without a box", 2e-3);

  // A rotated cube in which all voxels have the same inflow position.
  scene.Flow = [](const Position3&) { return FlowEnd{ true, 0, 0.5, 0.45, 0.5 }; };
  const double axes[9] = { 0.8, -0.6, 0.0, 0.48, 0.64, -0.6, -0.36, -0.48, -0.8 };
  vtkSmartPointer<vtkImageData> rotated = MakeFlowVoxels(9, scene.Flow);
  rotated->SetDirectionMatrix(axes);
  Position3 center;
  rotated->GetCenter(center.data());
  rotated->SetOrigin(-0.5 - center[0], -0.5 - center[1], -0.5 - center[2]);
  // Even if samples are far apart, cropping and clipping planes yield the same image.
  RgbaImage images[2];
  for (const bool isClipped : { false, true })
  {
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    mapper->SetInflowTexture(0, MakeBlob());
    mapper->SetSampleDistance(0.2);
    mapper->SetCropping(!isClipped);
    mapper->SetCroppingRegionPlanes(-0.3, 0.2, -0.1, 0.33, -0.31, 0.25);
    for (int side = 0; side < 6 && isClipped; ++side)
    {
      Position3 normal{};
      Position3 origin{};
      normal[static_cast<std::size_t>(side) / 2] = side % 2 == 0 ? 1.0 : -1.0;
      origin[static_cast<std::size_t>(side) / 2] = mapper->GetCroppingRegionPlanes()[side];
      vtkNew<vtkPlane> face;
      face->SetNormal(normal.data());
      face->SetOrigin(origin.data());
      mapper->AddClippingPlane(face);
    }
    images[isClipped ? 1 : 0] = DrawFlow(mapper, rotated, scene);
  }
  check.That(LargestAlpha(images[1]) > 0.3, "the image of the rotated volume is not empty");
  check.Near(CompareImages(images[0], images[1]).Max, 0.0, 1e-5,
    "cropping of a rotated volume equals six clipping planes", 1.0);
}

/// Tests two thin sheets. The mapper must skip the empty cells around them.
void TestSheets(Check& check)
{
  FlowScene scene = MakeBlobScene();
  // Sheet borders are halfway between voxels that reached a surface and those that did not.
  const double h = 1.0 / 32.0;
  const auto sheets = [h](const Position3& x)
  {
    FlowEnd end = Uniform(x);
    end.IsReached = std::abs(x[0]) < 1.5 * h || std::abs(x[0] - 10.0 * h) < 0.5 * h;
    return end;
  };
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInflowTexture(0, MakeBlob());
  mapper->SetSampleDistance(0.1 * h);
  scene.Flow = sheets;
  scene.UnitDistance = 0.05;
  const ImageError error = CompareImages(
    DrawFlow(mapper, MakeFlowVoxels(33, sheets), scene), MakeFlowReferenceImage(scene, 4000));
  std::cout << "two sheets: " << error << "\n";
  check.That(error.Max <= 0.02, "sheets inside empty cells");
  check.That(
    mapper->GetReport()->GetNumber("EmptyCells") > 20 * 32 * 32, "empty cells are counted");
}

/// An opaque plate hides the part of the volume behind it, in parallel and perspective projection.
void TestOpaque(Check& check)
{
  for (const bool isParallel : { false, true })
  {
    FlowScene scene = MakeBlobScene();
    scene.Camera->SetParallelProjection(isParallel);
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(0.05, -3.0, -3.0);
    source->SetPoint1(0.05, 3.0, -3.0);
    source->SetPoint2(0.05, -3.0, 3.0);
    vtkNew<vtkPolyDataMapper> surface;
    surface->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> plate;
    plate->SetMapper(surface);
    plate->GetProperty()->LightingOff();
    plate->GetProperty()->SetColor(0.0, 0.0, 0.0);
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    mapper->SetInflowTexture(0, MakeBlob());
    vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(33, &Uniform);
    mapper->SetInputData(static_cast<vtkDataSet*>(voxels));
    vtkNew<vtkVolumeProperty> property;
    property->SetScalarOpacityUnitDistance(scene.UnitDistance);
    VolumeStage stage(scene.Size);
    stage.SetVolume(mapper, property);
    stage.SetCamera(scene.Camera);
    stage.AddActor(plate);
    const RgbaImage found = stage.Capture();
    check.Contains(mapper->GetReport()->GetText("Features"), "opaque");
    scene.IsRetained = [](const Position3& x) { return x[0] > 0.05; };
    const RgbaImage expected = MakeFlowReferenceImage(scene, 800);
    double largest = 0.0;
    for (const auto& [j, i, c] : AllIndices(scene.Size[1], scene.Size[0], 3))
    {
      reference::KeepLargest(largest, std::abs(found.At(i, j)[c] - expected.At(i, j)[c]));
    }
    std::cout << "in front of a plate, parallel " << isParallel << ": " << largest << "\n";
    check.That(largest < 2e-3, "a plate hides the volume behind it");

    // The selector finds the volume in front of the plate, and the plate next to the volume.
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(stage.GetRenderer());
    selector->SetArea(0, 0, 47, 47);
    stage.Render();
    check.That(selector->CaptureBuffers(), "the selection succeeds");
    const unsigned int center[2] = { 24, 24 };
    const unsigned int corner[2] = { 1, 1 };
    check.That(
      selector->GetPixelInformation(center, 0).Prop == stage.GetVolume(), "the volume is selected");
    check.That(selector->GetPixelInformation(corner, 0).Prop == plate, "the plate is selected");
  }
}

/// Two renderers next to each other show the same image.
void TestRenderers(Check& check)
{
  FlowScene scene = MakeBlobScene();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(96, 48);
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInflowTexture(0, MakeBlob());
  vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(17, &Uniform);
  mapper->SetInputData(static_cast<vtkDataSet*>(voxels));
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkNew<vtkRenderer> renderers[2];
  for (int i = 0; i < 2; ++i)
  {
    renderers[i]->SetViewport(0.5 * i, 0.0, 0.5 * i + 0.5, 1.0);
    renderers[i]->SetActiveCamera(scene.Camera);
    renderers[i]->AddVolume(volume);
    window->AddRenderer(renderers[i]);
  }
  window->Render();
  check.Equal(
    mapper->GetReport()->GetCount("GridUploads"), 0, "both renderers share their textures");
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, 95, 47, 0, pixels);
  int largest = 0;
  int brightest = 0;
  for (const auto& [j, i, c] : AllIndices(48, 48, 3))
  {
    const int a = pixels->GetTypedComponent(96 * j + i, c);
    largest = std::max(largest, std::abs(a - pixels->GetTypedComponent(96 * j + 48 + i, c)));
    brightest = std::max(brightest, a);
  }
  check.That(brightest > 50 && largest <= 1, "both images are equal");
}

/// Compares silhouettes and optical depths of the same Gaussian inflow, drawn with tetrahedra and
/// with a texture.
void TestFlowVolume(Check& check)
{
  const int n = 41;
  auto field = vtkSmartPointer<vtkImageData>::New();
  field->SetDimensions(n, n, n);
  field->SetOrigin(-0.5, -0.5, -0.5);
  field->SetSpacing(1.0 / (n - 1), 1.0 / (n - 1), 1.0 / (n - 1));
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Velocity");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    const double* x = field->GetPoint(i);
    vectors->InsertNextTuple3(1.0, 0.8 * x[2] - 0.2 * x[1], -0.8 * x[1] - 0.2 * x[2]);
  }
  field->GetPointData()->SetVectors(vectors);
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(-0.5, -0.9, -0.9);
  plane->SetPoint1(-0.5, 0.9, -0.9);
  plane->SetPoint2(-0.5, -0.9, 0.9);
  // Streamlines that leave through the lateral faces of the field have no inflow value. Only the
  // core of the field is drawn.
  vtkNew<vtkImplicitFlowField> flow;
  flow->SetInputData(field);
  flow->AddTerminationSurface(plane);
  flow->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  flow->Update();
  auto* samples = vtkImageData::SafeDownCast(flow->GetOutputDataObject(0));
  // Inflow values are exp(-(r / width)^2), and values below the limit are transparent. Extinction
  // is proportional to the inflow value.
  const double limit = 0.15;
  const double width = 0.11;
  const double strength = 6.0;
  const auto inflow = [&](double u, double v)
  {
    const double r = std::hypot(u - 0.5, v - 0.5) / width;
    return std::exp(-r * r);
  };
  vtkNew<vtkInflowMapping> mapping;
  mapping->AddRing(0, 0.5, 0.5, 0.0, width);
  mapping->SetInputData(samples);
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(mapping->GetOutputPort());
  volume->SetNumberOfIntervals(1);
  volume->SetInterval(0, limit, 2.0);
  volume->Update();

  FlowScene scene = MakeBlobScene();
  scene.Size = { { 96, 96 } };
  scene.UnitDistance = 1.0;
  scene.Camera = LookAlong({ { -0.3, 0.9, -0.4 } }, true);
  vtkNew<vtkImplicitFlowVolumeMapper> textured;
  textured->SetInflowTexture(0,
    MakePaint(513, 513,
      [&](double u, double v)
      {
        const double value = inflow(u, v);
        return Color4{ { 1.0, 1.0, 1.0, value > limit ? 1.0 - std::exp(-strength * value) : 0.0 } };
      }));
  textured->SetSampleDistance(0.25 / (n - 1));
  const RgbaImage texturedImage = DrawFlow(textured, samples, scene);

  vtkNew<vtkTimeWeightedTetrahedraMapper> tetrahedra;
  tetrahedra->SetInputData(vtkUnstructuredGrid::SafeDownCast(volume->GetOutputDataObject(0)));
  tetrahedra->SelectScalarArray("Inflow");
  tetrahedra->SetScalarModeToUsePointFieldData();
  std::vector<FunctionNode> nodes;
  for (int i = 0; i <= 100; ++i)
  {
    // The opacity function of the tetrahedra is the extinction per unit length.
    nodes.push_back({ 0.01 * i, { { 1.0, 1.0, 1.0 } }, strength * 0.01 * i });
  }
  vtkSmartPointer<vtkVolumeProperty> property = MakeProperty(nodes, 1.0);
  VolumeStage stage(scene.Size);
  stage.SetVolume(tetrahedra, property);
  stage.SetCamera(scene.Camera);
  const RgbaImage tetrahedraImage = stage.Capture();
  double depths[2] = { 0.0, 0.0 };
  double difference = 0.0;
  int outside = 0;
  int inside = 0;
  const auto depthOf = [](const double* pixel) { return -std::log(1.0 - pixel[3]); };
  for (int j = 2; j < scene.Size[1] - 2; ++j)
  {
    for (int i = 2; i < scene.Size[0] - 2; ++i)
    {
      const double a = depthOf(texturedImage.At(i, j));
      const double b = depthOf(tetrahedraImage.At(i, j));
      depths[0] += a;
      depths[1] += b;
      difference += std::abs(a - b);
      // Silhouettes may differ by one pixel: in the other image, the pixel or one of its neighbors
      // must have the same visibility.
      for (const bool isSeen : { true, false })
      {
        const auto has = [&](const RgbaImage& image, int x, int y)
        { return (image.At(x, y)[3] > 0.02) == isSeen; };
        bool isNear = false;
        for (int k = 0; k < 9; ++k)
        {
          isNear = isNear || has(tetrahedraImage, i + k % 3 - 1, j + k / 3 - 1);
        }
        outside += has(texturedImage, i, j) && !isNear ? 1 : 0;
      }
      inside += b > 0.02 ? 1 : 0;
    }
  }
  std::cout << "texture and tetrahedra: depth " << depths[0] << " and " << depths[1]
            << ", difference " << difference << ", outside silhouettes " << outside << " of "
            << inside << " pixels\n";
  check.That(inside > 500, "the flow is visible");
  check.That(outside == 0, "silhouettes match within a pixel");
  check.That(std::abs(depths[0] / depths[1] - 1.0) <= 0.02, "the total optical depth");
  check.That(difference <= 0.02 * depths[1], "the optical depth of pixels");
}
}

int TestFlowVolumeScene(int, char*[])
{
  return RunChecks({ TestCuts, TestSheets, TestOpaque, TestRenderers, TestFlowVolume });
}
