// SPDX-License-Identifier: BSD-3-Clause
// Tests every kind of camera: stereo, sheared, off-axis and with user transforms. Silhouettes are
// compared with vtkPolyDataMapper. Colors of slabs, also cut by planes and surfaces, are compared
// with formulas. Selection and lit boundaries are tested as well.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/LargestError.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperImage.h"
#include "Tetrahedra/PixelSegments.h"
#include "View/TetrahedraView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;

constexpr std::array<double, 6> Box = { { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } };
constexpr int Slabs = 3;
constexpr double Extinctions[Slabs] = { 2.0, 0.7, 4.0 };
constexpr Point3 Colors[Slabs] = { { { 1.0, 0.1, 0.0 } }, { { 0.0, 0.9, 0.3 } },
  { { 0.2, 0.0, 1.0 } } };
/// View direction nearly parallel to the planes between the slabs, so that the two eyes see
/// opposite sides of the planes.
constexpr Point3 Along = { { 0.01, -0.35, 1.0 } };

/// A camera that looks at the unit cube, in a window that may be stereo.
struct CameraCase
{
  std::string Name;
  std::function<void(vtkCamera*)> Change;
  /// VTK's stereo type, or 0 for no stereo.
  int StereoType = 0;
  /// True if the camera's transforms preserve lengths and angles, so that vtkPolyDataMapper shades
  /// correctly.
  bool IsRigid = true;
  /// True if the near or far plane cuts the cube, so that its visible surface has a hole.
  bool IsCut = false;
};

vtkSmartPointer<vtkTransform> MakeTransform(const std::function<void(vtkTransform*)>& change)
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  change(transform);
  return transform;
}

/// Sets the screen of an off-axis camera to a parallelogram in view coordinates.
void SetScreen(vtkCamera* camera, const Point3& center, const Point3& right, const Point3& up)
{
  Point3 corners[3];
  for (int k = 0; k < 3; ++k)
  {
    corners[0][k] = center[k] - right[k] - up[k];
    corners[1][k] = center[k] + right[k] - up[k];
    corners[2][k] = center[k] + right[k] + up[k];
  }
  camera->SetScreenBottomLeft(corners[0].data());
  camera->SetScreenBottomRight(corners[1].data());
  camera->SetScreenTopRight(corners[2].data());
  camera->UseOffAxisProjectionOn();
}

const std::vector<CameraCase>& AllCameras()
{
  const auto unchanged = [](vtkCamera*) {};
  const auto wide = [](vtkCamera* camera) { camera->SetEyeAngle(12.0); };
  static const std::vector<CameraCase> cameras = {
    { "plain", unchanged },
    { "left eye", unchanged, VTK_STEREO_LEFT },
    { "right eye", unchanged, VTK_STEREO_RIGHT },
    { "left eye, wide", wide, VTK_STEREO_LEFT },
    { "right eye, wide", wide, VTK_STEREO_RIGHT },
    { "sheared", [](vtkCamera* camera) { camera->SetViewShear(0.2, -0.15, 0.7); } },
    { "sheared, left eye", [](vtkCamera* camera) { camera->SetViewShear(-0.1, 0.2, 1.2); },
      VTK_STEREO_LEFT },
    { "window center", [](vtkCamera* camera) { camera->SetWindowCenter(0.3, -0.2); } },
    { "window center, right eye", [](vtkCamera* camera) { camera->SetWindowCenter(-0.3, 0.2); },
      VTK_STEREO_RIGHT },
    { "view angle", [](vtkCamera* camera) { camera->SetViewAngle(35.0); }, VTK_STEREO_LEFT },
    { "horizontal view angle",
      [](vtkCamera* camera)
      {
        camera->UseHorizontalViewAngleOn();
        camera->SetViewAngle(30.0);
      } },
    { "mirrored",
      [](vtkCamera* camera) {
        camera->SetUserTransform(MakeTransform([](vtkTransform* t) { t->Scale(-1.0, 1.0, 1.0); }));
      } },
    { "upside down, left eye",
      [](vtkCamera* camera)
      { camera->SetUserTransform(MakeTransform([](vtkTransform* t) { t->RotateZ(180.0); })); },
      VTK_STEREO_LEFT },
    { "rotated image",
      [](vtkCamera* camera)
      {
        camera->SetUserTransform(MakeTransform(
          [](vtkTransform* t)
          {
            t->Translate(0.1, 0.05, 0.0);
            t->RotateZ(33.0);
            t->Scale(0.8, 1.1, 1.0);
          }));
      } },
    { "tilted depth",
      [](vtkCamera* camera)
      {
        vtkNew<vtkMatrix4x4> matrix;
        matrix->SetElement(2, 0, 0.1);
        matrix->SetElement(2, 1, -0.05);
        matrix->SetElement(2, 2, 0.7);
        camera->SetUserTransform(MakeTransform([&](vtkTransform* t) { t->SetMatrix(matrix); }));
      } },
    { "user view transform",
      [](vtkCamera* camera)
      {
        camera->SetUserViewTransform(MakeTransform(
          [](vtkTransform* t)
          {
            t->RotateZ(20.0);
            t->Scale(1.2, 0.7, 0.9);
          }));
      },
      0, false },
    { "model transform, right eye",
      [](vtkCamera* camera)
      {
        camera->SetModelTransformMatrix(MakeTransform(
          [](vtkTransform* t)
          {
            t->Translate(0.1, -0.1, 0.2);
            t->RotateY(10.0);
          })->GetMatrix());
      },
      VTK_STEREO_RIGHT },
    { "cut by near and far plane, left eye",
      [](vtkCamera* camera)
      {
        const double distance = camera->GetDistance();
        camera->SetClippingRange(distance - 0.4, distance + 0.3);
      },
      VTK_STEREO_LEFT, false, true },
  };
  return cameras;
}

/// Returns off-axis cameras, whose screens are given in view coordinates.
const std::vector<CameraCase>& AllScreens()
{
  static const std::vector<CameraCase> cameras = {
    { "off-axis",
      [](vtkCamera* camera)
      {
        const double z = -camera->GetDistance();
        SetScreen(camera, { { 0.3, -0.2, z } }, { { 1.2, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } });
      } },
    { "off-axis, right eye, rotated screen",
      [](vtkCamera* camera)
      {
        camera->SetLeftEye(0);
        camera->SetEyeSeparation(1.0);
        const double z = -camera->GetDistance();
        SetScreen(camera, { { 0.1, 0.1, z } }, { { 1.2, 0.0, 0.4 } }, { { 0.0, 1.0, 0.0 } });
      } },
    { "off-axis, stereo",
      [](vtkCamera* camera)
      {
        camera->SetEyeSeparation(1.5);
        const double z = -camera->GetDistance();
        SetScreen(camera, { { -0.1, 0.1, z } }, { { 1.2, 0.0, 0.0 } }, { { 0.0, 0.9, 0.3 } });
      },
      VTK_STEREO_LEFT },
  };
  return cameras;
}

/// A window with a camera that looks at a cube, which consists of slabs in different colors.
class Scene
{
public:
  Scene(const CameraCase& what, bool parallel, bool isScreen)
    : Case(what)
    , Grid(MakeBox({ { Slabs, 2, 4 } }))
    , Stage(std::array<int, 2>{ { 88, 72 } })
    , Camera(LookAt(this->Grid, Along, parallel))
  {
    AddSlabIndices(this->Grid, "slab", 0, Slabs);
    if (isScreen)
    {
      // Move the volume instead of the camera.
      vtkNew<vtkMatrix4x4> matrix;
      matrix->DeepCopy(this->Camera->GetViewTransformMatrix());
      const double distance = this->Camera->GetDistance();
      this->Camera->SetPosition(0.0, 0.0, 0.0);
      this->Camera->SetFocalPoint(0.0, 0.0, -distance);
      this->Camera->SetViewUp(0.0, 1.0, 0.0);
      this->Stage.GetVolume()->SetUserMatrix(matrix);
    }
    what.Change(this->Camera);
    this->Stage.SetCamera(this->Camera);
    if (what.StereoType != 0)
    {
      this->Stage.GetWindow()->SetStereoType(what.StereoType);
      this->Stage.GetWindow()->StereoRenderOn();
    }
    std::vector<FunctionNode> nodes;
    for (int slab = 0; slab < Slabs; ++slab)
    {
      nodes.push_back({ static_cast<double>(slab), Colors[slab], Extinctions[slab] });
    }
    this->Property = MakeProperty(nodes);
  }

  void SetMapper(Mapper* mapper)
  {
    mapper->SetInputData(static_cast<vtkDataSet*>(this->Grid));
    mapper->SetScalarMode(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
    mapper->SelectScalarArray("slab");
    mapper->AutoAdjustLevelOfDetailOff();
    this->Stage.SetVolume(mapper, this->Property);
  }

  RgbaImage Draw()
  {
    // Rendering the window passes the stereo settings to the camera.
    this->Stage.Render();
    return this->Stage.Capture();
  }

  vtkSmartPointer<vtkActor> AddSurface(vtkAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->SetUserMatrix(this->Stage.GetVolume()->GetUserMatrix());
    this->Stage.AddActor(actor);
    return actor;
  }

  CameraCase Case;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  VolumeStage Stage;
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkVolumeProperty> Property;
};

/// Returns the composited color of the slabs along a pixel's segment.
std::array<double, 4> ExpectSlabs(const PixelSegment& segment, vtkVolume* volume)
{
  struct Piece
  {
    double From;
    double Length;
    int Slab;
  };
  std::vector<Piece> pieces;
  for (int slab = 0; slab < Slabs; ++slab)
  {
    PixelSegment part = segment;
    std::array<double, 6> box = Box;
    box[0] = static_cast<double>(slab) / Slabs;
    box[1] = static_cast<double>(slab + 1) / Slabs;
    part.ClipToBox(box, volume);
    if (!part.IsEmpty())
    {
      pieces.push_back({ part.GetFrom(), part.GetLength(), slab });
    }
  }
  std::sort(
    pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.From < b.From; });
  std::array<double, 4> color = { { 0.0, 0.0, 0.0, 0.0 } };
  for (const Piece& piece : pieces)
  {
    const double alpha = -std::expm1(-Extinctions[piece.Slab] * piece.Length) * (1.0 - color[3]);
    for (int c = 0; c < 3; ++c)
    {
      color[c] += alpha * Colors[piece.Slab][c];
    }
    color[3] += alpha;
  }
  return color;
}

/// Compares all pixels with the composited slabs along their segments, which \a clip may shorten. A
/// few pixels may differ on the OpenGL path, which may round an edge of a tetrahedron to the other
/// side of a pixel's center.
void CompareSlabs(Check& check, Scene& scene, const RgbaImage& image, const std::string& name,
  const std::function<void(PixelSegment&)>& clip = {})
{
  const bool isSoftware = name.find("software") == 0;
  const PixelSegments segments(scene.Stage.GetRenderer());
  double largest = 0.0;
  int seen = 0;
  int different = 0;
  for (const auto& [j, i] : AllIndices(image.Height, image.Width))
  {
    PixelSegment segment = segments.Get(i, j);
    if (clip)
    {
      clip(segment);
    }
    const std::array<double, 4> expected = ExpectSlabs(segment, scene.Stage.GetVolume());
    seen += expected[3] > 0.1 ? 1 : 0;
    double error = 0.0;
    // Skip alpha: opaque surfaces set it.
    for (int c = 0; c < (clip ? 3 : 4); ++c)
    {
      const double distance = std::abs(image.At(i, j)[c] - expected[c]);
      error = std::isfinite(distance) ? std::max(error, distance) : 1e9;
    }
    different += error > 1e-3 ? 1 : 0;
    reference::KeepLargest(largest, error);
  }
  check.That(seen > 1000, name + ": " + std::to_string(seen) + " pixels show the cube");
  check.That(
    different <= (isSoftware ? 0 : 4), name + ": " + std::to_string(different) + " pixels differ");
  check.Near(largest, 0.0, !isSoftware ? 1e-2 : clip ? 1e-3 : 2e-5, name, 1.0);
}

/// Calls \a action for each render path and shader.
void ForEachPath(const std::function<void(Mapper*, const std::string&)>& action)
{
  for (int path : AllRenderPaths())
  {
    const bool isSoftware = path == Mapper::SOFTWARE_PATH;
    for (int shader : { Mapper::GEOMETRY_SHADER, Mapper::VERTEX_SHADER })
    {
      if (isSoftware && shader == Mapper::VERTEX_SHADER)
      {
        continue;
      }
      vtkNew<Mapper> mapper;
      mapper->SetRenderPath(path);
      mapper->SetSilhouetteShader(shader);
      action(
        mapper, GetPathName(path) + (shader == Mapper::VERTEX_SHADER ? ", vertex shader" : ""));
    }
  }
}

void TestSlabs(Check& check, Scene& scene)
{
  ForEachPath(
    [&](Mapper* mapper, const std::string& path)
    {
      scene.SetMapper(mapper);
      CompareSlabs(check, scene, scene.Draw(), path + ": slabs");
    });
}

/// Tests that the volume covers the same pixels as the cube's surface rendered by
/// vtkPolyDataMapper.
void TestSilhouette(Check& check, Scene& scene)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(Box.data());
  const auto surface = scene.AddSurface(cube);
  scene.Stage.GetVolume()->VisibilityOff();
  const RgbaImage expected = scene.Draw();
  surface->VisibilityOff();
  scene.Stage.GetVolume()->VisibilityOn();
  ForEachPath(
    [&](Mapper* mapper, const std::string& path)
    {
      scene.SetMapper(mapper);
      const RgbaImage image = scene.Draw();
      int covered = 0;
      int different = 0;
      for (std::size_t i = 3; i < image.Values.size(); i += 4)
      {
        covered += expected.Values[i] > 0.5 ? 1 : 0;
        // A few pixels may differ, since edges of the cube may pass through pixel centers.
        different += (expected.Values[i] > 0.5) != (image.Values[i] > 1e-5) ? 1 : 0;
      }
      check.That(covered > 800, path + ": the surface is visible");
      check.That(different <= 3,
        path + ": silhouettes differ in " + std::to_string(different) + " of " +
          std::to_string(covered) + " pixels");
    });
}

/// Tests an opaque plane through the cube.
void TestOpaque(Check& check, Scene& scene)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-9.0, -9.0, 0.2);
  plane->SetPoint1(9.0, -9.0, 0.5);
  plane->SetPoint2(-9.0, 9.0, 0.4);
  const auto surface = scene.AddSurface(plane);
  surface->GetProperty()->SetColor(0.0, 0.0, 0.0);
  plane->Update();
  double corner[4];
  double sides[2][4];
  vtkMatrix4x4* matrix = scene.Stage.GetVolume()->GetMatrix();
  const auto move = [matrix](const double* point, double* moved)
  {
    const double homogeneous[4] = { point[0], point[1], point[2], 1.0 };
    matrix->MultiplyPoint(homogeneous, moved);
  };
  move(plane->GetOrigin(), corner);
  move(plane->GetPoint1(), sides[0]);
  move(plane->GetPoint2(), sides[1]);
  for (double* side : sides)
  {
    vtkMath::Subtract(side, corner, side);
  }
  Point3 normal;
  vtkMath::Cross(sides[0], sides[1], normal.data());
  const Point3 origin = { { corner[0], corner[1], corner[2] } };
  ForEachPath(
    [&](Mapper* mapper, const std::string& path)
    {
      scene.SetMapper(mapper);
      CompareSlabs(check, scene, scene.Draw(), path + ": cut by a surface",
        [&](PixelSegment& segment)
        {
          const Point3 front = segment.GetFront();
          Point3 offset;
          vtkMath::Subtract(front.data(), origin.data(), offset.data());
          const double side = vtkMath::Dot(normal.data(), offset.data()) < 0.0 ? -1.0 : 1.0;
          segment.Clip({ { side * normal[0], side * normal[1], side * normal[2] } }, origin);
        });
    });
  surface->VisibilityOff();
}

/// Tests that the selected cell is where the opacity along the pixel's segment is half of the
/// total.
void TestSelection(Check& check, Scene& scene)
{
  vtkNew<Mapper> mapper;
  scene.SetMapper(mapper);
  scene.Stage.Render();
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(scene.Stage.GetVolume()->GetMatrix(), inverse);
  const int found = CheckSelection(
    check, scene.Stage.GetRenderer(), scene.Stage.GetVolume(), scene.Grid,
    [&scene](PixelSegment& segment) { segment.ClipToBox(Box, scene.Stage.GetVolume()); },
    [&inverse](const Point3& point)
    {
      double x[4] = { point[0], point[1], point[2], 1.0 };
      inverse->MultiplyPoint(x, x);
      return Extinctions[std::max(0, std::min(static_cast<int>(Slabs * x[0]), Slabs - 1))];
    });
  check.That(found > 100, "selection: " + std::to_string(found) + " pixels");
}

/// Tests that boundary triangles under a scene light have the same shading as with
/// vtkPolyDataMapper.
void TestLitBoundary(Check& check, Scene& scene)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  double center[4] = { 2.0, 1.5, -2.0, 1.0 };
  scene.Stage.GetVolume()->GetMatrix()->MultiplyPoint(center, center);
  light->SetPosition(center);
  light->PositionalOn();
  light->SetConeAngle(180.0);
  scene.Stage.SetLights({ light });
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(Box.data());
  cube->Update();
  vtkNew<vtkPolyData> face;
  // The faces of tetrahedra that lie on the front face of the cube.
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < scene.Grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    scene.Grid->GetCellPoints(cell, size, corners);
    for (int k = 0; k < 4; ++k)
    {
      vtkIdType ids[3];
      bool isFace = true;
      for (int c = 0, n = 0; c < 4; ++c)
      {
        if (c != k)
        {
          isFace = isFace && scene.Grid->GetPoint(corners[c])[2] == 0.0;
          ids[n++] = corners[c];
        }
      }
      if (isFace)
      {
        triangles->InsertNextCell(3, ids);
      }
    }
  }
  face->SetPoints(scene.Grid->GetPoints());
  face->SetPolys(triangles);
  vtkNew<vtkProperty> property;
  property->SetColor(0.9, 0.8, 0.7);
  property->SetOpacity(1.0);
  property->SetAmbient(0.1);
  property->SetDiffuse(0.8);
  vtkNew<vtkPolyDataMapper> polyDataMapper;
  polyDataMapper->SetInputData(face);
  vtkNew<vtkActor> actor;
  actor->SetMapper(polyDataMapper);
  actor->SetProperty(property);
  actor->SetUserMatrix(scene.Stage.GetVolume()->GetUserMatrix());
  scene.Stage.AddActor(actor);
  scene.Stage.GetVolume()->VisibilityOff();
  const RgbaImage expected = scene.Draw();
  actor->VisibilityOff();
  scene.Stage.GetVolume()->VisibilityOn();
  ForEachPath(
    [&](Mapper* mapper, const std::string& path)
    {
      scene.SetMapper(mapper);
      mapper->SetBlendMode(Mapper::COMPOSITE_BLEND);
      mapper->SetBoundaryData(face);
      mapper->SetBoundaryProperty(property);
      const RgbaImage image = scene.Draw();
      double largest = 0.0;
      int seen = 0;
      for (const auto& [j, i] : AllIndices(image.Height, image.Width))
      {
        const double* pixel = expected.At(i, j);
        if (pixel[3] > 0.5 && image.At(i, j)[3] > 0.9999)
        {
          ++seen;
          for (int c = 0; c < 3; ++c)
          {
            reference::KeepLargest(largest, std::abs(image.At(i, j)[c] - pixel[c]));
          }
        }
      }
      check.That(
        seen > 800, path + ": number of pixels that show the boundary: " + std::to_string(seen));
      check.Near(largest, 0.0, 2e-3, path + ": lit boundary", 1.0);
    });
}

/// Tests that the eye position used to order the pieces of different processes is that of VTK's
/// stereo rendering.
void TestEye(Check& check, bool isLeft)
{
  check.SetContext(isLeft ? "eye, left" : "eye, right");
  Scene scene({ "", [](vtkCamera* camera) { camera->SetEyeAngle(7.0); },
                isLeft ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT },
    false, false);
  scene.Stage.GetVolume()->SetScale(2.0, 1.0, 0.5);
  vtkNew<Mapper> mapper;
  scene.SetMapper(mapper);
  scene.Stage.Render();
  const std::array<double, 4> eye =
    interlume::TetrahedraView::FindEye(scene.Stage.GetRenderer(), scene.Stage.GetVolume());
  check.That(eye[3] > 0.0, "w is positive");
  const double offset = (isLeft ? -1.0 : 1.0) * scene.Camera->GetDistance() *
    std::tan(vtkMath::RadiansFromDegrees(3.5));
  const double scale[3] = { 2.0, 1.0, 0.5 };
  for (int k = 0; k < 3; ++k)
  {
    const double expected = scene.Camera->GetPosition()[k] +
      offset * scene.Camera->GetViewTransformMatrix()->GetElement(0, k);
    check.Near(scale[k] * eye[k] / eye[3], expected, 1e-9, "eye position", 1.0);
  }
}

/// Compares windows that show both eyes at once with the images of vtkPolyDataMapper.
void TestBothEyes(Check& check, int type)
{
  check.SetContext("both eyes, type " + std::to_string(type));
  Scene scene({ "", [](vtkCamera*) {}, type }, false, false);
  scene.Property = MakeProperty({ { 0.0, { { 1.0, 1.0, 1.0 } }, 1e6 } });
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(Box.data());
  const auto surface = scene.AddSurface(cube);
  const auto read = [&scene]()
  {
    scene.Stage.Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    scene.Stage.GetWindow()->GetPixelData(0, 0, 87, 71, 0, pixels);
    return std::vector<unsigned char>(
      pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  };
  scene.Stage.GetVolume()->VisibilityOff();
  const std::vector<unsigned char> expected = read();
  surface->VisibilityOff();
  scene.Stage.GetVolume()->VisibilityOn();
  ForEachPath(
    [&](Mapper* mapper, const std::string& path)
    {
      scene.SetMapper(mapper);
      const std::vector<unsigned char> found = read();
      int different = 0;
      int covered = 0;
      for (std::size_t i = 0; i < found.size() && i < expected.size(); ++i)
      {
        covered += expected[i] > 128 ? 1 : 0;
        different += std::abs(found[i] - expected[i]) > 2 ? 1 : 0;
      }
      check.That(covered > 1000, path + ": the volume is visible");
      check.That(different <= 9, path + ": " + std::to_string(different) + " channels differ");
    });
}

void TestCamera(Check& check, const CameraCase& what, bool parallel, bool isScreen)
{
  check.SetContext(what.Name + (parallel ? ", parallel" : ", perspective"));
  Scene scene(what, parallel, isScreen);
  TestSlabs(check, scene);
  TestSelection(check, scene);
  if (!what.IsCut)
  {
    TestSilhouette(check, scene);
  }
  TestOpaque(check, scene);
  if (what.IsRigid)
  {
    TestLitBoundary(check, scene);
  }
}

}

int TestTetrahedraMapperCameras(int, char*[])
{
  Check check;
  for (const CameraCase& what : AllCameras())
  {
    for (bool parallel : { false, true })
    {
      TestCamera(check, what, parallel, false);
    }
  }
  for (const CameraCase& what : AllScreens())
  {
    TestCamera(check, what, false, true);
  }
  TestEye(check, true);
  TestEye(check, false);
  for (int type :
    { VTK_STEREO_RED_BLUE, VTK_STEREO_INTERLACED, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL })
  {
    TestBothEyes(check, type);
  }
  return check.Result();
}
