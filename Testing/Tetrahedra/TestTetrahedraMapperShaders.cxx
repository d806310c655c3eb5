// SPDX-License-Identifier: BSD-3-Clause
// Tests that a vertex shader and a geometry shader produce the same silhouettes, for every kind of
// array and blend mode, with one mapper that alternates between them.
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <iostream>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;

constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };
/// Both shaders use the same arithmetic, but compilers may reorder it.
constexpr double Rounding = 1e-5;

vtkSmartPointer<Mapper> NewMapper()
{
  auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->SetRenderPath(Mapper::OPENGL_PATH);
  mapper->AutoAdjustLevelOfDetailOff();
  return mapper;
}

void Expect(Check& check, Mapper* mapper, const ImageCase& what, const std::string& name)
{
  Configure(mapper, what);
  VolumeStage stage(what.Settings.Size);
  stage.SetVolume(mapper, what.Property);
  stage.SetCamera(what.Camera);
  for (const auto& actor : what.Actors)
  {
    stage.AddActor(actor);
  }
  mapper->SetSilhouetteShader(Mapper::GEOMETRY_SHADER);
  const RgbaImage geometry = stage.Capture();
  check.Equal(mapper->GetReport()->GetCount("SilhouetteShader"), Mapper::GEOMETRY_SHADER,
    name + ": geometry");
  const vtkIdType bytes = mapper->GetReport()->GetNumber("BufferBytes");
  check.That(LargestAlpha(geometry) > 0.1, name + ": the volume is visible");
  mapper->SetSilhouetteShader(Mapper::VERTEX_SHADER);
  const RgbaImage vertices = stage.Capture();
  check.Equal(
    mapper->GetReport()->GetCount("SilhouetteShader"), Mapper::VERTEX_SHADER, name + ": vertices");
  check.That(mapper->GetReport()->GetNumber("BufferBytes") > bytes,
    name + ": the indices need buffer memory");
  check.Equal(mapper->GetReport()->GetCount("UploadedOrderBytes"), 0,
    name + ": the order is not uploaded again");
  mapper->SetSilhouetteShader(Mapper::GEOMETRY_SHADER);
  const RgbaImage again = stage.Capture();
  const ImageError error = CompareImages(vertices, geometry);
  std::cout << name << ": " << error << '\n';
  check.Near(error.Max, 0.0, Rounding, name, 1.0);
  check.That(
    CompareImages(again, geometry).Max == 0.0, name + ": the first shader reproduces its image");
}

ImageCase MakeBlock(bool parallel)
{
  ImageCase what = MakeCase(MakeCube(5), MakeRamp(0.1, 1.0, 0.25), Slanted, parallel);
  AddSlabIndices(what.Grid, "IntervalId", 2, 4);
  AddLinearArray(what.Grid, "DeltaT", 1.0, { { -0.8, 0.5, 0.3 } });
  return what;
}

void TestBlendModes(Check& check, bool parallel)
{
  const std::string view = parallel ? ", parallel" : ", perspective";
  for (Blend how : { Blend::Composite, Blend::MaximumIntensity, Blend::Additive, Blend::Priority,
         Blend::OpticalDepth })
  {
    ImageCase what = MakeBlock(parallel);
    what.Settings.How = how;
    for (const char* extent : { "", "DeltaT" })
    {
      what.Settings.Arrays.DeltaT = extent;
      Expect(check, NewMapper(), what,
        "blend mode " + std::to_string(static_cast<int>(how)) + (*extent ? ", in time" : "") +
          view);
    }
  }
}

/// Adds RGBA colors that differ strongly between consecutive tuples.
void AddColors(vtkDataSetAttributes* data, vtkIdType tuples)
{
  vtkNew<vtkFloatArray> colors;
  colors->SetName("colors");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < 4 * tuples; ++i)
  {
    colors->SetValue(i, static_cast<float>(0.5 + 0.5 * std::sin(1.7 * static_cast<double>(i))));
  }
  data->AddArray(colors);
}

void TestColors(Check& check, bool parallel)
{
  for (bool ofCells : { false, true })
  {
    ImageCase what = MakeBlock(parallel);
    what.Settings.Arrays.Scalars = "colors";
    what.Settings.Arrays.OfCells = ofCells;
    what.Property->IndependentComponentsOff();
    AddColors(ofCells ? static_cast<vtkDataSetAttributes*>(what.Grid->GetCellData())
                      : static_cast<vtkDataSetAttributes*>(what.Grid->GetPointData()),
      ofCells ? what.Grid->GetNumberOfCells() : what.Grid->GetNumberOfPoints());
    Expect(check, NewMapper(), what, ofCells ? "colors of cells" : "colors of points");
  }
}

/// Tests boundary triangles, an opaque sphere inside the volume, a near plane inside the volume,
/// and several draw calls.
void TestParts(Check& check, bool parallel)
{
  ImageCase what = MakeBlock(parallel);
  vtkNew<vtkGeometryFilter> boundary;
  boundary->SetInputData(what.Grid);
  auto withBoundary = NewMapper();
  withBoundary->SetBoundaryConnection(boundary->GetOutputPort());
  vtkNew<vtkProperty> property;
  property->SetOpacity(0.3);
  withBoundary->SetBoundaryProperty(property);
  Expect(check, withBoundary, what, "boundary");

  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.5, 0.5, 0.5);
  sphere->SetRadius(0.3);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(surface);
  what.Actors.push_back(actor);
  Expect(check, NewMapper(), what, "a sphere inside");

  what = MakeBlock(parallel);
  double range[2];
  what.Camera->GetClippingRange(range);
  what.Camera->SetClippingRange(what.Camera->GetDistance() - 0.13, range[1]);
  Expect(check, NewMapper(), what, "near plane inside");

  // More tetrahedra than one draw call can index.
  what = MakeCase(MakeCube(16), MakeRamp(0.1, 1.0, 0.25), Slanted, parallel);
  Expect(check, NewMapper(), what, "20,480 tetrahedra");
}

void TestChoice(Check& check)
{
  const ImageCase what = MakeBlock(true);
  vtkNew<Mapper> mapper;
  check.Equal(mapper->GetSilhouetteShader(), Mapper::AUTOMATIC_SHADER, "default shader");
  mapper->SetSilhouetteShader(7);
  check.Equal(
    mapper->GetSilhouetteShader(), Mapper::AUTOMATIC_SHADER, "invalid shaders are clamped");
  mapper->SetRenderPath(Mapper::OPENGL_PATH);
  DrawByMapper(mapper, what);
  check.That(mapper->GetReport()->GetNumber("SilhouetteShader") != Mapper::AUTOMATIC_SHADER,
    "a shader is selected");
  check.That(!mapper->GetReport()->GetText("ShaderReason").empty(), "the selection has a reason");
  mapper->SetRenderPath(Mapper::SOFTWARE_PATH);
  DrawByMapper(mapper, what);
  check.That(
    mapper->GetReport()->GetText("ShaderReason").empty(), "the software path has no shader");
}

}

int TestTetrahedraMapperShaders(int, char*[])
{
  Check check;
  for (bool parallel : { true, false })
  {
    TestBlendModes(check, parallel);
    TestColors(check, parallel);
    TestParts(check, parallel);
  }
  TestChoice(check);
  return check.Result();
}
