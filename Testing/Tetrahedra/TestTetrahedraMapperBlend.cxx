// SPDX-License-Identifier: BSD-3-Clause
// Tests every blend mode, kind of array and clipping of both render paths against the reference.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <iostream>
#include <limits>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;

constexpr double Bound = 1e-3;
constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };
constexpr Point3 Red = { { 1.0, 0.1, 0.0 } };
constexpr Point3 Green = { { 0.2, 1.0, 0.1 } };
constexpr Point3 Blue = { { 0.1, 0.3, 1.0 } };

ImageCase MakeCase(bool parallel)
{
  return reference::MakeCase(
    MakeCube(4), MakeRamp(0.1, 1.0, 0.25), Slanted, parallel, { { 80, 64 } });
}

/// Compares both render paths with the reference. \a openGLBound may be larger for dense volumes,
/// in which missing pixels at silhouettes are visible.
void Expect(
  Check& check, const ImageCase& what, const std::string& name, double openGLBound = Bound)
{
  const RgbaImage expected = DrawReference(what);
  check.That(LargestAlpha(expected) > 0.2, name + ": the volume is visible");
  for (int path : AllRenderPaths())
  {
    const ImageError error = CompareImages(DrawByPath(path, what), expected);
    const std::string fullName = name +
      (what.Camera->GetParallelProjection() ? ", parallel, " : ", perspective, ") +
      GetPathName(path);
    std::cout << fullName << ": " << error << '\n';
    const bool isOpenGL = path == vtkTimeWeightedTetrahedraMapper::OPENGL_PATH;
    check.Near(error.Max, 0.0, isOpenGL ? openGLBound : Bound, fullName, 1.0);
  }
}

void TestBlendModes(Check& check, bool parallel)
{
  ImageCase what = MakeCase(parallel);
  AddSlabIndices(what.Grid, "IntervalId", 2, 4);
  // Additive blending saturates, so it is also tested with a fainter volume.
  auto faint = MakeRamp(0.01, 0.1);
  const struct
  {
    Blend How;
    const char* Name;
  } modes[] = { { Blend::Composite, "composite" }, { Blend::MaximumIntensity, "maximum" },
    { Blend::Additive, "additive" }, { Blend::Priority, "priority" },
    { Blend::OpticalDepth, "optical depth" } };
  AddLinearArray(what.Grid, "DeltaT", 1.0, { { -0.8, 0.5, 0.3 } });
  for (const auto& mode : modes)
  {
    what.Settings.How = mode.How;
    for (const char* extent : { "", "DeltaT" })
    {
      what.Settings.Arrays.DeltaT = extent;
      Expect(check, what, std::string(mode.Name) + (*extent ? ", extent in time" : ""));
    }
  }
  what.Settings.Arrays.DeltaT.clear();
  what.Settings.How = Blend::Additive;
  what.Property = faint;
  const RgbaImage expected = DrawReference(what);
  for (int path : AllRenderPaths())
  {
    const ImageError error = CompareImages(DrawByPath(path, what), expected);
    check.Near(error.Max, 0.0, Bound * LargestAlpha(expected), "additive, faint", 1.0);
  }
}

/// Tests layers that are ordered by priority instead of distance.
void TestPriorities(Check& check, bool parallel)
{
  ImageCase what = MakeCase(parallel);
  AddSlabIndices(what.Grid, "layer", 0, 3);
  what.Property = MakeProperty({ { 0.0, Red, 2.0 }, { 1.0, Green, 1.0 }, { 2.0, Blue, 3.0 } });
  what.Settings.How = Blend::Priority;
  what.Settings.Layers = "layer";
  what.Settings.Arrays.Scalars = "layer";
  what.Settings.Arrays.OfCells = true;
  Expect(check, what, "priority by number");
  what.Settings.Priorities = { { 0, 5.0 }, { 1, -1.0 }, { 2, 0.5 } };
  Expect(check, what, "explicit priorities");
  what.Settings.Priorities = { { 0, 2.0 }, { 1, 2.0 } };
  Expect(check, what, "equal priorities");
}

/// Tests AUTOMATIC_BLEND: optical depth blending if the input has an array `DeltaT`, otherwise
/// composite blending.
void TestAutomatic(Check& check)
{
  ImageCase what = MakeCase(true);
  for (bool hasExtent : { false, true })
  {
    if (hasExtent)
    {
      AddLinearArray(what.Grid, "DeltaT", 1.0, { { -0.8, 0.5, 0.3 } });
      what.Settings.How = Blend::OpticalDepth;
      what.Settings.Arrays.DeltaT = "DeltaT";
    }
    const RgbaImage expected = DrawReference(what);
    for (int path : AllRenderPaths())
    {
      vtkNew<Mapper> mapper;
      mapper->SetRenderPath(path);
      Configure(mapper, what);
      mapper->SetDeltaTArrayName(nullptr);
      mapper->SetBlendModeToAutomatic();
      VolumeStage stage(what.Settings.Size);
      stage.SetVolume(mapper, what.Property);
      stage.SetCamera(what.Camera);
      check.Near(CompareImages(stage.Capture(), expected).Max, 0.0, Bound,
        "automatic blend, " + GetPathName(path), 1.0);
    }
  }
}

template <typename Array>
void AddColors(vtkDataSetAttributes* data, vtkIdType tuples, int components, double scale)
{
  vtkNew<Array> colors;
  colors->SetName("colors");
  colors->SetNumberOfComponents(components);
  colors->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      const double value = 0.5 + 0.5 * std::sin(1.7 * static_cast<double>(i) + 2.1 * k);
      colors->SetTypedComponent(i, k, static_cast<typename Array::ValueType>(scale * value));
    }
  }
  data->AddArray(colors);
}

/// Tests point and cell arrays that contain colors.
void TestColorArrays(Check& check, bool parallel)
{
  for (bool ofCells : { false, true })
  {
    const std::string suffix = ofCells ? " of cells" : " of points";
    for (int components : { 2, 3, 4 })
    {
      ImageCase what = MakeCase(parallel);
      what.Settings.Arrays.Scalars = "colors";
      what.Settings.Arrays.OfCells = ofCells;
      vtkDataSetAttributes* data = what.Grid->GetPointData();
      vtkIdType tuples = what.Grid->GetNumberOfPoints();
      if (ofCells)
      {
        data = what.Grid->GetCellData();
        tuples = what.Grid->GetNumberOfCells();
      }
      what.Property->IndependentComponentsOff();
      AddColors<vtkFloatArray>(data, tuples, components, 1.0);
      Expect(check, what, std::to_string(components) + " components" + suffix);
      if (components > 2)
      {
        data->RemoveArray("colors");
        AddColors<vtkUnsignedCharArray>(data, tuples, components, 255.0);
        what.Property = MakeProperty({ { 0.0, Red, 0.1 }, { 255.0, Red, 1.0 } }, 0.25);
        what.Property->IndependentComponentsOff();
        Expect(check, what, std::to_string(components) + " bytes" + suffix);
        what.Settings.How = Blend::MaximumIntensity;
        // Colors are discontinuous between cells. Therefore OpenGL's rounding at an edge is
        // visible.
        Expect(check, what, std::to_string(components) + " bytes" + suffix + ", maximum",
          ofCells ? 0.5 : Bound);
      }
    }
  }
}

void TestTransferFunctions(Check& check, bool parallel)
{
  // Thirty nodes over the range of the field: about four per tetrahedron.
  std::vector<FunctionNode> nodes;
  for (int node = 0; node < 30; ++node)
  {
    const double x = 0.1 + 0.9 * node / 29.0;
    const Point3& color = node % 3 == 0 ? Red : node % 3 == 1 ? Green : Blue;
    nodes.push_back({ x, color, node % 2 == 0 ? 0.0 : 6.0 });
  }
  ImageCase what = MakeCase(parallel);
  what.Property = MakeProperty(nodes);
  Expect(check, what, "thirty nodes");
  what.Grid = MakeCube(1);
  Expect(check, what, "thirty nodes in five tetrahedra");
  what.Settings.How = Blend::OpticalDepth;
  Expect(check, what, "thirty nodes, optical depth");
  what.Settings.How = Blend::Composite;
  // A step, and a spike that is narrower than a tetrahedron.
  what.Property = MakeProperty({ { 0.0, Red, 0.0 }, { 0.5, Red, 0.0 }, { 0.5000001, Blue, 3.0 },
    { 0.7, Blue, 3.0 }, { 0.7001, Green, 900.0 }, { 0.7002, Green, 0.2 }, { 1.0, Green, 0.2 } });
  Expect(check, what, "a step and a spike");
  what.Property = MakeRamp(0.1, 1.0, 0.03);
  Expect(check, what, "unit distance 0.03", 3e-3);
  what.Property = MakeRamp(0.0, 1.0, 0.25);
  what.Settings.Mode = Integration::AverageColor;
  Expect(check, what, "average color");
}

void TestCellConstants(Check& check, bool parallel)
{
  ImageCase what = MakeCase(parallel);
  AddSlabIndices(what.Grid, "IntervalId", 1, 4);
  what.Settings.Arrays.Scalars = "IntervalId";
  what.Settings.Arrays.OfCells = true;
  what.Property = MakeProperty(
    { { 0.0, Red, 3.0 }, { 1.0, Green, 0.0 }, { 2.0, Blue, 1.0 }, { 3.0, Green, 4.0 } });
  Expect(check, what, "constants of cells");
  AddLinearArray(what.Grid, "DeltaT", 0.0, { { 0.5, 0.2, 0.9 } });
  what.Settings.Arrays.DeltaT = "DeltaT";
  Expect(check, what, "constants of cells, extent in time from 0");
}

void TestNearPlane(Check& check)
{
  ImageCase what = MakeCase(true);
  double range[2];
  what.Camera->GetClippingRange(range);
  const double distance = what.Camera->GetDistance();
  what.Camera->SetClippingRange(distance - 0.13, range[1]);
  Expect(check, what, "near plane through the mesh");
  what = MakeCase(false);
  what.Camera->SetClippingRange(distance + 0.11, range[1]);
  Expect(check, what, "near plane through the mesh");
  // The camera is inside the mesh but not on a face.
  what.Camera->SetPosition(0.47, 0.53, 0.41);
  what.Camera->SetFocalPoint(0.47 + 0.3, 0.53 - 0.4, 0.41 + 1.0);
  what.Camera->SetViewAngle(70.0);
  what.Camera->SetClippingRange(0.02, 10.0);
  Expect(check, what, "camera inside the mesh");
  what.Camera->SetClippingRange(1e-4, 10.0);
  Expect(check, what, "camera inside the mesh, near plane at 1e-4");
}

/// Tests that a fine mesh around the camera gives the same image as a mesh of five tetrahedra. The
/// front half absorbs only 99 % of the light, so that tetrahedra behind it are still visible.
void TestNearlyOpaque(Check& check)
{
  ImageCase what = MakeCase(false);
  what.Camera->SetPosition(0.47, 0.53, 0.41);
  what.Camera->SetFocalPoint(0.47 + 0.3, 0.53 - 0.4, 0.41 + 1.0);
  what.Camera->SetViewAngle(70.0);
  what.Camera->SetClippingRange(1e-4, 10.0);
  what.Property = MakeRamp(12.0, 12.0);
  what.Grid = MakeCube(1);
  const RgbaImage expected = DrawReference(what);
  what.Grid = MakeCube(16);
  for (int path : AllRenderPaths())
  {
    const ImageError error = CompareImages(DrawByPath(path, what), expected);
    check.Near(error.Max, 0.0, Bound, "nearly opaque, " + GetPathName(path), 1.0);
  }
}

/// Tests an opaque plane in front of, inside and behind the volume.
void TestOpaque(Check& check, bool parallel)
{
  const Point3 color = { { 0.2, 0.6, 0.4 } };
  for (Blend how : { Blend::Composite, Blend::OpticalDepth, Blend::MaximumIntensity })
  {
    for (double behind : { -1.5, -0.3, 0.05, 0.3, 1.5 })
    {
      ImageCase what = MakeCase(parallel);
      what.Settings.How = how;
      AddPlane(what, behind, color);
      RgbaImage expected = DrawReference(what);
      for (const auto& [j, i] : AllIndices(expected.Height, expected.Width))
      {
        double* pixel = expected.At(i, j);
        for (int k = 0; k < 3; ++k)
        {
          pixel[k] += (1.0 - pixel[3]) * color[k];
        }
        pixel[3] = 1.0;
      }
      for (int path : AllRenderPaths())
      {
        const ImageError error = CompareImages(DrawByPath(path, what), expected);
        const std::string name = "plane " + std::to_string(behind) + " behind the center, blend " +
          std::to_string(static_cast<int>(how)) + (parallel ? ", parallel, " : ", perspective, ") +
          GetPathName(path);
        std::cout << name << ": " << error << '\n';
        check.Near(error.Max, 0.0, Bound, name, 1.0);
      }
    }
  }
}

}

int TestTetrahedraMapperBlend(int, char*[])
{
  Check check;
  for (bool parallel : { true, false })
  {
    TestBlendModes(check, parallel);
    TestPriorities(check, parallel);
    TestColorArrays(check, parallel);
    TestTransferFunctions(check, parallel);
    TestCellConstants(check, parallel);
    TestOpaque(check, parallel);
  }
  TestAutomatic(check);
  TestNearPlane(check);
  TestNearlyOpaque(check);
  return check.Result();
}
