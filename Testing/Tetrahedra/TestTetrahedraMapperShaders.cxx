// SPDX-License-Identifier: BSD-3-Clause
// The silhouettes of a vertex shader against those of a geometry shader: every kind of array, blend
// mode and part of a picture, by one mapper that takes turns with both.
#include "Support/Drawing/PictureCases.h"
#include "Support/Pictures/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperPicture.h"

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
/// Both shaders do the same arithmetic, which a compiler may put together differently.
constexpr double Rounding = 1e-5;

vtkSmartPointer<Mapper> NewMapper()
{
  auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->SetRenderPath(Mapper::OPENGL_PATH);
  mapper->AutoAdjustLevelOfDetailOff();
  return mapper;
}

void Expect(Check& check, Mapper* mapper, const PictureCase& what, const std::string& name)
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
  const RgbaPicture made = stage.Capture();
  check.Near(mapper->GetReport()->GetNumber("SilhouetteShader"), Mapper::GEOMETRY_SHADER, 0.0,
    name + ": geometry");
  const vtkIdType bytes = mapper->GetReport()->GetNumber("BufferBytes");
  check.That(LargestAlpha(made) > 0.1, name + ": something is seen");
  mapper->SetSilhouetteShader(Mapper::VERTEX_SHADER);
  const RgbaPicture pulled = stage.Capture();
  check.Near(mapper->GetReport()->GetNumber("SilhouetteShader"), Mapper::VERTEX_SHADER, 0.0,
    name + ": vertices");
  check.That(mapper->GetReport()->GetNumber("BufferBytes") > bytes, name + ": bytes of indices");
  check.Near(mapper->GetReport()->GetNumber("UploadedOrderBytes"), 0, 0.0,
    name + ": the order is sent once");
  mapper->SetSilhouetteShader(Mapper::GEOMETRY_SHADER);
  const RgbaPicture again = stage.Capture();
  const PictureError error = ComparePictures(pulled, made);
  std::cout << name << ": " << error << '\n';
  check.Near(error.Max, 0.0, Rounding, name, 1.0);
  check.That(ComparePictures(again, made).Max == 0.0, name + ": and back");
}

PictureCase MakeBlock(bool parallel)
{
  PictureCase what = MakeCase(MakeCube(5), MakeRamp(0.1, 1.0, 0.25), Slanted, parallel);
  AddSlabs(what.Grid, "IntervalId", 2, 4);
  AddLinear(what.Grid, "DeltaT", 1.0, { { -0.8, 0.5, 0.3 } });
  return what;
}

void TestBlendModes(Check& check, bool parallel)
{
  const std::string view = parallel ? ", parallel" : ", perspective";
  for (Blend how : { Blend::Composite, Blend::MaximumIntensity, Blend::Additive, Blend::Priority,
         Blend::OpticalDepth })
  {
    PictureCase what = MakeBlock(parallel);
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

/// Adds colours with opacities that no two neighbours share.
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
    PictureCase what = MakeBlock(parallel);
    what.Settings.Arrays.Scalars = "colors";
    what.Settings.Arrays.OfCells = ofCells;
    what.Property->IndependentComponentsOff();
    AddColors(ofCells ? static_cast<vtkDataSetAttributes*>(what.Grid->GetCellData())
                      : static_cast<vtkDataSetAttributes*>(what.Grid->GetPointData()),
      ofCells ? what.Grid->GetNumberOfCells() : what.Grid->GetNumberOfPoints());
    Expect(check, NewMapper(), what, ofCells ? "colours of cells" : "colours of points");
  }
}

/// Boundary triangles, something opaque within, the near plane within, tetrahedra left out.
void TestParts(Check& check, bool parallel)
{
  PictureCase what = MakeBlock(parallel);
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
  Expect(check, NewMapper(), what, "a sphere within");

  what = MakeBlock(parallel);
  double range[2];
  what.Camera->GetClippingRange(range);
  what.Camera->SetClippingRange(what.Camera->GetDistance() - 0.13, range[1]);
  Expect(check, NewMapper(), what, "near plane within");

  // More tetrahedra than have indices, so that they are drawn in several goes.
  what = MakeCase(MakeCube(16), MakeRamp(0.1, 1.0, 0.25), Slanted, parallel);
  Expect(check, NewMapper(), what, "20,480 tetrahedra");
}

void TestChoice(Check& check)
{
  const PictureCase what = MakeBlock(true);
  vtkNew<Mapper> mapper;
  check.Equal(mapper->GetSilhouetteShader(), Mapper::AUTOMATIC_SHADER, "default");
  mapper->SetSilhouetteShader(7);
  check.Equal(mapper->GetSilhouetteShader(), Mapper::AUTOMATIC_SHADER, "clamped");
  mapper->SetRenderPath(Mapper::OPENGL_PATH);
  DrawByMapper(mapper, what);
  check.That(mapper->GetReport()->GetNumber("SilhouetteShader") != Mapper::AUTOMATIC_SHADER,
    "one is chosen");
  check.That(!mapper->GetReport()->GetText("ShaderReason").empty(), "the choice has a reason");
  mapper->SetRenderPath(Mapper::SOFTWARE_PATH);
  DrawByMapper(mapper, what);
  check.That(mapper->GetReport()->GetText("ShaderReason").empty(), "no shader in software");
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
