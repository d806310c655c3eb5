// SPDX-License-Identifier: BSD-3-Clause
// Images of vtkShadowedSliceMapper compared with ray marching in double precision: volumes, scalar
// types and components, materials, cuts, cameras and settings. All scenes have a light along (1,
// -1, -1).
#include "Support/Inputs/DataFiles.h"
#include "Light/ShadowComparison.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceRay.h"
#include "Support/Images/ReferenceShadowImage.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTransform.h"
#include "vtkVolumeProperty.h"

namespace
{

using namespace reference;

/// Bound for soft media. It allows for transfer functions that are nonlinear within a slab, since
/// slabs that are one voxel thick use one sample at their center.
constexpr ImageBound Soft = { 0.015, 0.0006 };
/// Bound for volumes cut by planes, which leave slabs thinner than a voxel.
constexpr ImageBound Cut = { 0.06, 0.0006 };
/// Bound for surfaces thinner than a voxel.
constexpr ImageBound Hard = { 0.06, 0.001 };

vtkSmartPointer<vtkImageData> SmallSphere()
{
  return MakeImage(20, MakeSphere(0.15, 0.45));
}

ShadowScene SphereScene(bool shade)
{
  return MakeScene(SmallSphere(), MakeTranslucentProperty(0.5, shade));
}

void TestVolumes(Check& check)
{
  for (bool shade : { false, true })
  {
    const std::string suffix = shade ? ", shaded" : ", not shaded";
    ExpectSimilarToReference(check, "soft sphere" + suffix, SphereScene(shade), Soft);
    ExpectSimilarToReference(check, "dense sphere" + suffix,
      MakeScene(MakeImage(24, MakeSphere(0.3, 0.45)), MakeTranslucentProperty(0.97, shade)), Hard);
    ExpectSimilarToReference(check, "two boxes" + suffix,
      MakeScene(MakeImage(24, TwoBoxes), MakeTranslucentProperty(0.9, shade)), Hard);
  }
}

/// Tests skin and bone in a CT scan of part of a head.
void TestTomography(Check& check)
{
  const auto head = interlume::ReadData("headsq_quarter.vti");
  auto* image = vtkImageData::SafeDownCast(head);
  const int extent[6] = { 16, 47, 34, 61, 40, 71 };
  image->Crop(extent);
  image->SetOrigin(0.0, 0.0, 0.0);
  const double voxel = image->GetSpacing()[0];
  auto property =
    MakeProperty({ { 400.0, { { 0.9, 0.6, 0.5 } }, 0.0 }, { 1000.0, { { 0.9, 0.7, 0.6 } }, 0.3 },
                   { 1500.0, { { 1.0, 1.0, 0.9 } }, 0.8 } },
      voxel);
  property->ShadeOn();
  property->SetAmbient(0.1);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.2);
  ExpectSimilarToReference(check, "tomography", MakeScene(image, property), { 0.1, 0.0015 });
}

void TestScalarTypes(Check& check)
{
  auto scene = SphereScene(true);
  scene.Size = { { 32, 32 } };
  scene.Property->GetScalarOpacity()->RemoveAllPoints();
  scene.Property->GetScalarOpacity()->AddPoint(0.0, 0.0);
  scene.Property->GetScalarOpacity()->AddPoint(100.0, 0.5);
  scene.Property->GetRGBTransferFunction()->AddRGBPoint(100.0, 1.0, 0.3, 0.2);
  const auto doubles = scene.Image;
  vtkDataArray* from = doubles->GetPointData()->GetScalars();
  for (int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    const auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    values->SetNumberOfTuples(from->GetNumberOfTuples());
    const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
    for (vtkIdType id = 0; id < from->GetNumberOfTuples(); ++id)
    {
      const double value = 100.0 * from->GetComponent(id, 0);
      values->SetComponent(id, 0, isReal ? value : std::round(value));
    }
    scene.Image = vtkSmartPointer<vtkImageData>::New();
    scene.Image->CopyStructure(doubles);
    scene.Image->GetPointData()->SetScalars(values);
    ExpectSimilarToReference(check, values->GetClassName(), scene, Soft);
  }
}

/// Replaces the scalars with an array that has one component per field.
void AddComponents(vtkImageData* image, const std::vector<Field>& fields, int type, double scale)
{
  const auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  values->SetNumberOfComponents(static_cast<int>(fields.size()));
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    Double3 x;
    image->GetPoint(id, x.data());
    for (double& coordinate : x)
    {
      coordinate += 0.5;
    }
    for (std::size_t k = 0; k < fields.size(); ++k)
    {
      const double value = scale * fields[k](x);
      values->SetComponent(
        id, static_cast<int>(k), type == VTK_UNSIGNED_CHAR ? std::round(value) : value);
    }
  }
  image->GetPointData()->SetScalars(values);
}

void TestComponents(Check& check)
{
  const Field x = [](const Double3& p) { return p[0]; };
  const Field y = [](const Double3& p) { return p[1]; };
  const Field wave = [](const Double3& p) { return 0.5 + 0.5 * std::cos(6.0 * p[2]); };
  const std::vector<Field> fields = { MakeSphere(0.1, 0.4), TwoBoxes, x, wave };
  const double colors[4][3] = { { 0.9, 0.2, 0.2 }, { 0.2, 0.9, 0.2 }, { 0.2, 0.2, 0.9 },
    { 0.8, 0.8, 0.1 } };
  const double opacities[4] = { 0.6, 0.8, 0.1, 0.15 };
  for (std::size_t count : { 2, 3, 4 })
  {
    auto scene = SphereScene(true);
    AddComponents(scene.Image, { fields.begin(), fields.begin() + count }, VTK_FLOAT, 1.0);
    for (int k = 0; k < static_cast<int>(count); ++k)
    {
      vtkNew<vtkColorTransferFunction> color;
      color->AddRGBPoint(0.0, 0.5, 0.5, 0.5);
      color->AddRGBPoint(1.0, colors[k][0], colors[k][1], colors[k][2]);
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.0, 0.0);
      opacity->AddPoint(1.0, opacities[k]);
      scene.Property->SetColor(k, color);
      scene.Property->SetScalarOpacity(k, opacity);
      scene.Property->SetScalarOpacityUnitDistance(k, 0.05 + 0.05 * k);
      scene.Property->SetComponentWeight(k, 1.0 - 0.2 * k);
      scene.Property->SetAmbient(k, 0.1 + 0.1 * k);
      scene.Property->SetDiffuse(k, 0.8 - 0.1 * k);
    }
    ExpectSimilarToReference(check, std::to_string(count) + " independent components", scene, Hard);
  }
  for (bool shade : { false, true })
  {
    const std::string suffix = shade ? ", shaded" : "";
    auto scene = SphereScene(shade);
    scene.Property->IndependentComponentsOff();
    AddComponents(scene.Image, { wave, MakeSphere(0.15, 0.45) }, VTK_FLOAT, 1.0);
    ExpectSimilarToReference(check, "color and opacity" + suffix, scene, Soft);
    AddComponents(scene.Image, { x, y, wave, MakeSphere(0.15, 0.45) }, VTK_FLOAT, 1.0);
    ExpectSimilarToReference(check, "RGB and opacity, float" + suffix, scene, Soft);
    AddComponents(scene.Image, { x, y, wave, MakeSphere(0.15, 0.45) }, VTK_UNSIGNED_CHAR, 255.0);
    scene.Property->GetScalarOpacity()->RemoveAllPoints();
    scene.Property->GetScalarOpacity()->AddPoint(0.0, 0.0);
    scene.Property->GetScalarOpacity()->AddPoint(255.0, 0.5);
    ExpectSimilarToReference(check, "RGB and opacity, unsigned char" + suffix, scene, Soft);
  }
}

void TestArrays(Check& check)
{
  auto scene = SphereScene(true);
  const vtkSmartPointer<vtkDataArray> sphere = scene.Image->GetPointData()->GetScalars();
  AddComponents(scene.Image, { TwoBoxes }, VTK_FLOAT, 1.0);
  scene.Image->GetPointData()->GetScalars()->SetName("boxes");
  scene.Image->GetPointData()->AddArray(sphere);
  scene.Array.Name = "f";
  ExpectSimilarToReference(check, "array by name", scene, Soft);

  const auto cells = vtkSmartPointer<vtkDataArray>::Take(sphere->NewInstance());
  cells->SetName("cells");
  for (vtkIdType id = 0; id < scene.Image->GetNumberOfCells(); ++id)
  {
    double box[6];
    scene.Image->GetCellBounds(id, box);
    const Double3 center = { { 0.5 + 0.5 * (box[0] + box[1]), 0.5 + 0.5 * (box[2] + box[3]),
      0.5 + 0.5 * (box[4] + box[5]) } };
    cells->InsertNextTuple1(MakeSphere(0.1, 0.42)(center));
  }
  scene.Image->GetCellData()->AddArray(cells);
  scene.Array = { "cells", true };
  ExpectSimilarToReference(check, "cell values", scene, Soft);
}

void TestMaterials(Check& check)
{
  for (bool shade : { false, true })
  {
    auto scene = SphereScene(shade);
    vtkNew<vtkPiecewiseFunction> gradient;
    gradient->AddPoint(0.0, 0.0);
    gradient->AddPoint(0.3, 1.0);
    scene.Property->SetGradientOpacity(gradient);
    scene.Property->SetScalarOpacityUnitDistance(0.02);
    ExpectSimilarToReference(
      check, shade ? "gradient opacity, shaded" : "gradient opacity", scene, Soft);
  }
  auto scene = SphereScene(true);
  scene.Lights[0]->SetShadowAttenuation(0.5);
  ExpectSimilarToReference(check, "half of the shadow strength", scene, Soft);
  scene = SphereScene(true);
  scene.TransmissionColor = vtkSmartPointer<vtkColorTransferFunction>::New();
  scene.TransmissionColor->AddRGBPoint(0.0, 1.0, 0.5, 0.0);
  scene.TransmissionColor->AddRGBPoint(1.0, 0.8, 0.1, 0.3);
  ExpectSimilarToReference(check, "colored transmission", scene, Soft);
  scene = SphereScene(false);
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.0, 0.3);
  gray->AddPoint(1.0, 0.9);
  scene.Property->SetColor(gray);
  ExpectSimilarToReference(check, "gray", scene, Soft);
}

void TestCuts(Check& check)
{
  auto scene = SphereScene(true);
  scene.CroppingPlanes = { { -0.22, 0.31, -0.27, 0.13, -0.4, 0.17 } };
  scene.CroppingFlags = VTK_CROP_SUBVOLUME;
  ExpectSimilarToReference(check, "subvolume", scene, Cut);
  for (int flags : { VTK_CROP_FENCE, VTK_CROP_INVERTED_CROSS })
  {
    scene.CroppingFlags = flags;
    ExpectSimilarToReference(check, "cropping " + std::to_string(flags), scene, Cut);
  }
  scene.CroppingFlags = 0;
  for (const Double3& normal : { Double3{ { 0.0, -1.0, 0.3 } }, Double3{ { -0.8, 0.2, -0.5 } } })
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.05, 0.1, 0.12);
    Double3 n = normal;
    vtkMath::Normalize(n.data());
    plane->SetNormal(n.data());
    scene.ClippingPlanes.emplace_back(plane);
    ExpectSimilarToReference(
      check, "clipping planes, " + std::to_string(scene.ClippingPlanes.size()), scene, Cut);
  }
}

/// Tests an opaque black plane that fills the frame and intersects the volume.
void TestOpaque(Check& check)
{
  auto scene = SphereScene(true);
  Double3 normal = { { 0.2, 0.5, 1.0 } };
  vtkMath::Normalize(normal.data());
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-10.0, -10.0, 0.0);
  source->SetPoint1(10.0, -10.0, 0.0);
  source->SetPoint2(-10.0, 10.0, 0.0);
  source->SetCenter(0.0, 0.0, -0.05);
  source->SetNormal(normal.data());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> plane;
  plane->SetMapper(mapper);
  plane->GetProperty()->SetColor(0.0, 0.0, 0.0);
  plane->GetProperty()->LightingOff();
  scene.Actors = { plane.Get() };
  const Double3 center = { { 0.0, 0.0, -0.05 } };
  for (bool parallel : { false, true })
  {
    scene.Camera = LookAt(scene.Image, { { -0.3, -0.4, -1.0 } }, parallel);
    const PixelRays rays(scene.Camera, scene.Size);
    scene.OpaqueDistance.clear();
    for (int j = 0; j < scene.Size[1]; ++j)
    {
      for (int i = 0; i < scene.Size[0]; ++i)
      {
        const Ray ray = rays.Get(i, j);
        Real height = 0;
        Real slope = 0;
        for (int axis = 0; axis < 3; ++axis)
        {
          height += (center[axis] - ray.Origin[axis]) * normal[axis];
          slope += ray.Direction[axis] * normal[axis];
        }
        scene.OpaqueDistance.push_back(static_cast<double>(height / slope));
      }
    }
    RgbaImage expected = MakeShadowImage(scene);
    for (std::size_t alpha = 3; alpha < expected.Values.size(); alpha += 4)
    {
      expected.Values[alpha] = 1.0;
    }
    vtkNew<vtkShadowedSliceMapper> slices;
    ExpectSimilar(check, parallel ? "opaque plane, parallel" : "opaque plane",
      DrawByMapper(slices, scene), expected, Soft);
  }
}

void TestCameras(Check& check)
{
  for (bool parallel : { false, true })
  {
    for (const Double3& direction : { Double3{ { 1.0, 0.2, 0.1 } }, Double3{ { 0.0, 0.0, 1.0 } },
           Double3{ { 0.1, -1.0, 0.0 } }, Double3{ { -1.0, 1.0, 1.0 } } })
    {
      auto scene = SphereScene(true);
      scene.Size = { { 48, 32 } };
      scene.Camera = LookAt(scene.Image, direction, parallel);
      ExpectSimilarToReference(check,
        std::string(parallel ? "parallel" : "perspective") + " along " +
          std::to_string(direction[0]) + ", " + std::to_string(direction[1]) + ", " +
          std::to_string(direction[2]),
        scene, Soft);
    }
  }
  auto scene = SphereScene(true);
  scene.Camera->SetViewAngle(80.0);
  scene.Camera->SetPosition(0.1, 0.1, 0.2);
  scene.Camera->SetFocalPoint(0.0, 0.0, -1.0);
  scene.Camera->SetClippingRange(5e-4, 10.0);
  ExpectSimilarToReference(check, "camera inside the volume", scene, { 0.02, 0.001 });
  scene = SphereScene(true);
  scene.Camera->SetWindowCenter(0.3, -0.2);
  scene.Camera->SetRoll(40.0);
  ExpectSimilarToReference(check, "shifted and rolled camera", scene, Soft);
}

void TestTransforms(Check& check)
{
  auto scene = SphereScene(true);
  scene.Image = MakeImage({ { 16, 24, 10 } }, { { 0.06, 0.04, 0.12 } }, MakeSphere(0.15, 0.45));
  scene.Camera = LookAt(scene.Image, { { -0.3, -0.4, -1.0 } }, false);
  ExpectSimilarToReference(check, "anisotropic voxels", scene, Soft);
  scene.Image->SetDirectionMatrix(0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0);
  scene.Camera = LookAt(scene.Image, { { -0.3, -0.4, -1.0 } }, false);
  ExpectSimilarToReference(check, "rotated axes", scene, Soft);
  scene = SphereScene(true);
  vtkNew<vtkTransform> transform;
  transform->Translate(10.0, -20.0, 5.0);
  transform->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
  transform->Scale(3.0, 1.0, 2.0);
  scene.Matrix = transform->GetMatrix();
  scene.Camera = LookAt(scene.Image, { { -0.3, -0.4, -1.0 } }, false, scene.Matrix);
  scene.CroppingPlanes = { { -0.3, 0.3, -0.3, 0.3, -0.3, 0.1 } };
  scene.CroppingFlags = VTK_CROP_SUBVOLUME;
  ExpectSimilarToReference(check, "matrix of the volume", scene, Cut);
}

/// The mapper's settings change the accuracy of frames, but nothing else.
void TestSettings(Check& check)
{
  const auto scene = MakeScene(MakeImage(24, TwoBoxes), MakeTranslucentProperty(0.9, true));
  const RgbaImage expected = MakeShadowImage(scene);
  const auto draw = [&](const std::function<void(vtkShadowedSliceMapper*)>& set)
  {
    vtkNew<vtkShadowedSliceMapper> mapper;
    set(mapper);
    return DrawByMapper(mapper, scene);
  };
  const auto fine = [](vtkShadowedSliceMapper* mapper)
  {
    mapper->SetSliceSpacing(0.2 / 24.0);
    mapper->SetLightBufferSize(256);
  };
  ExpectSimilar(check, "fine", draw(fine), expected, { 0.02, 0.001 });
  const RgbaImage nearest = draw(
    [&](vtkShadowedSliceMapper* mapper)
    {
      fine(mapper);
      mapper->SetLightLookupToNearest();
    });
  ExpectSimilar(check, "nearest lookup, fine", nearest, expected, { 0.03, 0.001 });
  const auto coarse = [](int lookup)
  {
    return [lookup](vtkShadowedSliceMapper* mapper)
    {
      mapper->SetLightBufferSize(16);
      mapper->SetLightLookup(lookup);
    };
  };
  const RgbaImage bilinear = draw(coarse(vtkShadowedSliceMapper::BILINEAR_LOOKUP));
  const RgbaImage nearestCoarse = draw(coarse(vtkShadowedSliceMapper::NEAREST_LOOKUP));
  check.That(
    CompareImages(bilinear, nearestCoarse).Max > 0.02, "lookups differ with a coarse buffer");
  check.That(CompareImages(bilinear, expected).Mean < CompareImages(nearestCoarse, expected).Mean,
    "bilinear lookup is closer");
  const RgbaImage one = draw([](vtkShadowedSliceMapper*) {});
  for (double distance : { 0.5, 2.0, 3.0 })
  {
    const RgbaImage found =
      draw([&](vtkShadowedSliceMapper* mapper) { mapper->SetImageSampleDistance(distance); });
    ExpectSimilar(check, "image sample distance " + std::to_string(distance), found, one,
      distance > 1.0 ? ImageBound{ 0.3, 0.015 } : ImageBound{ 0.1, 0.003 });
    check.That(CompareImages(found, one).Max > 1e-4, "the image sample distance is used");
  }
}

}

int TestShadowImages(int, char*[])
{
  Check check;
  TestVolumes(check);
  TestTomography(check);
  TestScalarTypes(check);
  TestComponents(check);
  TestArrays(check);
  TestMaterials(check);
  TestCuts(check);
  TestOpaque(check);
  TestCameras(check);
  TestTransforms(check);
  TestSettings(check);
  return check.Result();
}
