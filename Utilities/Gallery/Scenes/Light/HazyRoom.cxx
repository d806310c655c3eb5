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

/// Returns the interior of the room. It extends past the upper edge and the sides of the image.
vtkBoundingBox Interior()
{
  return { -1.0, 1.5, -0.9, 1.0, 0.0, 1.4 };
}

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
                  vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::ROBOT), 0.02),
          { -0.25, 0.1, 0.018 }, 0.0, 0.0, 0.68),
        Arrange(SoftenEdges(
                  vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::RINGS), 0.02),
          { 0.54, 0.32, 0.41 }, -28.0, 80.0, 0.42),
        MakeRoom(Interior()) }),
    vtkBoundingBox(-1.1, 1.5, -0.9, 1.1, -0.1, 1.4), 270);
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

Panel& AddHazyRoom(Stage& stage, double opacity, const Lights& lights)
{
  Panel& panel = AddHazyPanel(stage, SampleRoom(), Interior(), opacity, lights);
  panel.Frame(vtkBoundingBox(-0.8, 1.0, -0.2, 1.0, 0.02, 1.12));
  panel.LookFrom({ 0.35, -1.0, 0.28 }, { 0.0, 0.0, 1.0 });
  return panel;
}
}
