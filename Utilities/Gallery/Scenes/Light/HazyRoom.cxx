// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Light/HazyRoom.h"

#include "Gallery/Look.h"
#include "Gallery/Scenes/Light/Room.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModelSource.h"
#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTransform.h"

namespace gallery
{
namespace
{
/// Smoke density that has the given opacity in MakeSolidMediumInSmoke().
constexpr double SMOKE_DENSITY = 60.0 / 255.0;

/// Scales \a object, tilts it backward by \a tilt degrees, rotates it around the z axis by
/// \a degrees, and moves it by \a offset.
vtkSmartPointer<vtkSpatialObject> Arrange(vtkSmartPointer<vtkSpatialObject> object,
  const vtkVector3d& offset, double degrees, double tilt, double scale)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(offset.GetData());
  transform->RotateZ(degrees);
  transform->RotateX(tilt);
  transform->Scale(scale, scale, scale);
  object->SetTransform(transform);
  return object;
}

vtkSmartPointer<vtkImageData> SampleRoom()
{
  return Sample(
    Unite(
      { Arrange(SoftenEdges(
                  vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::ROBOT), 0.05),
          { -0.5, 0.1, 0.0 }, -20.0, 0.0, 0.85),
        Arrange(SoftenEdges(
                  vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::RINGS), 0.04),
          { 0.54, 0.32, 0.41 }, -28.0, 80.0, 0.42),
        MakeRoom() }),
    vtkBoundingBox(-1.1, 1.05, -1.05, 1.1, -0.1, 1.35), 190);
}
}

Panel& AddHazyPanel(Stage& stage, vtkImageData* room, const vtkBoundingBox& inside, double opacity,
  const Lights& lights)
{
  // The smoke is much less dense than solids, so it does not affect their normals. It is
  // homogeneous, since 8-bit densities have too few levels for variations of such thin smoke.
  constexpr double density = 12.0 / 255.0;
  vtkVector3d lower;
  vtkVector3d upper;
  inside.GetMinPoint(lower.GetData());
  inside.GetMaxPoint(upper.GetData());
  const vtkColor3d white(1.0, 1.0, 1.0);
  AddSmoke(room, MakeBox(lower, upper, white), density, white);
  vtkSmartPointer<vtkVolumeProperty> medium =
    MakeSolidMediumInSmoke(room, SMOKE_DENSITY / density * opacity);
  medium->SetAmbient(0.1);
  vtkSmartPointer<vtkVolume> volume = MakeSlicedVolume(room, medium, SMOKE_GRADIENT);
  // The medium fills the whole volume, so a larger light buffer would be slow.
  GetSlicedMapper(volume)->SetLightBufferSize(512);
  Panel& panel = stage.AddPanel("");
  panel.Add(volume);
  panel.SetLights(lights);
  panel.SetBackground(DarkBackground());
  return panel;
}

Panel& AddHazyRoom(Stage& stage, const Lights& lights)
{
  const vtkBoundingBox inside(-1.0, 1.0, -1.0, 1.0, 0.0, 1.3);
  Panel& panel = AddHazyPanel(stage, SampleRoom(), inside, 0.003, lights);
  panel.Frame(vtkBoundingBox(-1.0, 1.0, -1.0, 1.0, 0.0, 1.24));
  panel.LookFrom({ 0.45, -1.0, 0.33 }, { 0.0, 0.0, 1.0 });
  return panel;
}
}
