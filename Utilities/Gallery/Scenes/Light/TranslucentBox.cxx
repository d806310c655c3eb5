// SPDX-License-Identifier: BSD-3-Clause
// Beams of light through translucent boxes.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"
#include "Gallery/VectorArithmetic.h"

#include "vtkActor.h"
#include "vtkClipPolyData.h"
#include "vtkCubeSource.h"
#include "vtkImplicitBoolean.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSphere.h"
#include "vtkVector.h"
#include "vtkVolumeCollection.h"

#include <array>
#include <cmath>

namespace
{
using namespace gallery;

/// A translucent box surrounded by a thin medium ("air").
struct TranslucentBox
{
  vtkVector3d Lengths;
  /// Length of the air along x.
  double AirLength;
  /// Rotation around the z axis.
  double Degrees;
  /// Extinctions per unit of length.
  double Extinction;
  double AirExtinction;
};

/// Density of the air divided by the density of the box.
constexpr double AIR_FRACTION = 0.2;

/// Sets a background as dark as unlit air, so that the limits of the air are not visible.
void UseDarkness(Panel& panel)
{
  panel.SetBackground({ 0.03, 0.03, 0.035 }, { 0.03, 0.03, 0.035 });
}

vtkSmartPointer<vtkImageData> SampleBox(const TranslucentBox& box)
{
  const vtkColor3d white(1.0, 1.0, 1.0);
  vtkSmartPointer<vtkSpatialPrimitive> air =
    MakeBox({ -0.5 * box.AirLength, -0.6, -0.9 }, { 0.5 * box.AirLength, 0.6, 0.9 }, white);
  air->SetDensity(AIR_FRACTION);
  air->SetEdgeWidth(0.25);
  vtkSmartPointer<vtkSpatialPrimitive> solid =
    MakeBox(-0.5 * box.Lengths, 0.5 * box.Lengths, white);
  solid->SetEdgeWidth(0.04);
  return Sample(Unite({ Place(solid, { 0.0, 0.0, 0.0 }, box.Degrees), air }),
    vtkBoundingBox(-0.5 * box.AirLength - 0.1, 0.5 * box.AirLength + 0.1, -0.7, 0.7, -1.0, 1.0),
    static_cast<int>(47.0 * box.AirLength));
}

vtkSmartPointer<vtkActor> MakeBoxFrame(const vtkVector3d& lengths, double degrees)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(lengths[0]);
  cube->SetYLength(lengths[1]);
  cube->SetZLength(lengths[2]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->RotateZ(degrees);
  const vtkColor3d color = OutlineColor();
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetRepresentationToWireframe();
  actor->GetProperty()->SetLineWidth(2.5);
  actor->GetProperty()->LightingOff();
  return actor;
}

/// Adds two panels of \a box, which is centered at the origin and lit by \a beams: without and with
/// attenuation of the light.
ShadowPair AddTranslucentBox(Stage& stage, const TranslucentBox& box, const Lights& beams)
{
  vtkSmartPointer<vtkImageData> image = SampleBox(box);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0 * AIR_FRACTION, 1.0 - std::exp(-box.AirExtinction));
  opacity->AddPoint(255.0, 1.0 - std::exp(-box.Extinction));
  vtkSmartPointer<vtkVolumeProperty> medium = MakeColoredMedium(opacity, 1.0);
  medium->SetAmbient(0.08);
  medium->SetDiffuse(1.0);
  medium->SetSpecular(0.0);

  Panel& without = stage.AddPanel("without attenuation");
  Panel& with = stage.AddPanel("with attenuation");
  for (Panel* panel : { &without, &with })
  {
    // The maximum surface gradient makes scattering nearly isotropic, so that edges are not shaded.
    vtkSmartPointer<vtkVolume> volume = MakeSlicedVolume(image, medium, 1.0);
    // The beams are narrow, so a small light buffer is sufficient.
    GetSlicedMapper(volume)->SetLightBufferSize(128);
    GetSlicedMapper(volume)->SetShadows(panel == &with);
    panel->Add(volume);
    panel->Add(MakeBoxFrame(box.Lengths, box.Degrees));
    panel->SetAmbientOcclusion(0.0);
    UseDarkness(*panel);
    panel->SetLights(beams);
  }
  return { without, with };
}

void BuildBeamBox(gallery::Stage& stage)
{
  // The panels are wide, so one is above the other.
  stage.SetColumns(1);
  const TranslucentBox box = { { 1.0, 0.6, 0.7 }, 4.6, 35.0, 1.15, 0.3 };
  AddTranslucentBox(stage, box,
    { gallery::MakeBeam({ -3.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, 0.32, 4.6, { 1.0, 0.80, 0.5 }) })
    .Look({ 0.0, -1.0, 0.35 }, vtkBoundingBox(-1.4, 1.4, -0.3, 0.3, -0.5, 0.5));
}

const gallery::SceneRegistration beamBox(
  { "beam-box", "2.25", "A beam of light through a box rotated by 35 degrees",
    "The beam runs from left to right, perpendicular to the view. Without attenuation it is "
    "brightest on the right, where less of the translucent box is in front of it. With attenuation "
    "the box absorbs most of its light, and only a little leaves.",
    {}, &BuildBeamBox });

void BuildBeamsCube(gallery::Stage& stage)
{
  const std::array<vtkColor3d, 3> colors = { { { 1.0, 0.16, 0.10 }, { 0.16, 1.0, 0.22 },
    { 0.16, 0.32, 1.0 } } };
  gallery::Lights beams;
  double height = 0.24;
  for (const vtkColor3d& color : colors)
  {
    const vtkVector3d center(0.0, 0.0, height);
    beams.push_back(
      gallery::MakeBeam(center + vtkVector3d(1.6, -0.2, 0.75), center, 0.2, 8.0, color));
    height -= 0.24;
  }
  const TranslucentBox cube = { { 0.84, 0.84, 0.84 }, 2.4, 25.0, 1.2, 0.4 };
  AddTranslucentBox(stage, cube, beams)
    .Look({ 0.1, -1.0, 0.25 }, vtkBoundingBox(-0.6, 0.6, -0.3, 0.3, -0.6, 0.6));
}

const gallery::SceneRegistration beamsCube(
  { "beams-cube", "2.24", "Red, green and blue beams through a translucent cube",
    "Parallel beams enter at the upper right, pass a translucent cube and leave it at the lower "
    "left, visible in thin air. Without attenuation they leave with their original brightness. "
    "With attenuation the cube absorbs most of their light. In both images the medium in front "
    "hides a part of them.",
    {}, &BuildBeamsCube });

const vtkVector3d BOX(0.9, 0.5, 0.66);
const vtkVector3d POSITION(0.36, 0.0, 0.0);
constexpr double DEGREES = 24.0;

/// Returns a screen perpendicular to the x axis, with three holes in a vertical row. It casts
/// shadows, but is not drawn.
vtkSmartPointer<vtkActor> MakeScreen()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.95, -1.5, -1.5);
  plane->SetPoint1(-0.95, 1.5, -1.5);
  plane->SetPoint2(-0.95, -1.5, 1.5);
  plane->SetResolution(150, 150);
  vtkNew<vtkImplicitBoolean> holes;
  for (const double height : { -0.14, 0.0, 0.14 })
  {
    vtkNew<vtkSphere> hole;
    hole->SetCenter(-0.95, 0.0, height);
    hole->SetRadius(0.05);
    holes->AddFunction(hole);
  }
  vtkNew<vtkClipPolyData> screen;
  screen->SetInputConnection(plane->GetOutputPort());
  screen->SetClipFunction(holes);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(screen->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->VisibilityOff();
  vtkShadowedScenePass::SetCastsShadowsWhenInvisible(actor, true);
  return actor;
}

void BuildBeamSoft(gallery::Stage& stage)
{
  stage.SetColumns(1);
  const vtkColor3d white(1.0, 1.0, 1.0);
  vtkSmartPointer<vtkSpatialPrimitive> air =
    gallery::MakeBox({ -0.94, -0.5, -0.5 }, { 2.2, 0.5, 0.5 }, white);
  air->SetDensity(0.6);
  air->SetEdgeWidth(0.2);
  vtkSmartPointer<vtkSpatialPrimitive> solid = gallery::MakeBox(-0.5 * BOX, 0.5 * BOX, white);
  solid->SetEdgeWidth(0.04);
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(gallery::Unite({ gallery::Place(solid, POSITION, DEGREES), air }),
      vtkBoundingBox(-0.94, 2.2, -0.5, 0.5, -0.5, 0.5), 130);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 0.36);
  vtkSmartPointer<vtkVolumeProperty> medium = MakeColoredMedium(opacity, 1.0);
  medium->SetAmbient(0.03);
  medium->SetSpecular(0.0);
  vtkSmartPointer<vtkLight> lamp = gallery::MakePointLight({ -5.0, 0.0, 0.0 }, 36.0);
  lamp->SetDiffuseColor(1.0, 0.86, 0.6);
  // The maximum surface gradient makes scattering nearly isotropic, so that edges are not shaded.
  gallery::SoftShadowPair pair =
    gallery::AddSoftShadowPair(stage, image, medium, { lamp }, 0.45, 1.0, 192);
  for (gallery::Panel* panel : { &pair.Hard, &pair.Soft })
  {
    UseDarkness(*panel);
    panel->Add(MakeScreen());
    // With fewer samples, the edges of the holes leave streaks in the soft beams.
    gallery::UseSceneShadows(*panel, panel == &pair.Soft ? 64 : 1);
    vtkSmartPointer<vtkActor> frame = MakeBoxFrame(BOX, DEGREES);
    frame->SetPosition(POSITION[0], POSITION[1], POSITION[2]);
    panel->Add(frame);
  }
  // With thicker slices or a finer depth map, slices at the edges of the hard beams would leave
  // ripples. The texels of the depth map are wider than the slices.
  vtkShadowedSliceMapper* hard = gallery::GetSlicedMapper(
    vtkVolume::SafeDownCast(pair.Hard.GetRenderer()->GetVolumes()->GetItemAsObject(0)));
  hard->SetSliceSpacing(0.2 * image->GetSpacing()[0]);
  hard->SetLightBufferSize(384);
  vtkShadowedScenePass::SafeDownCast(pair.Hard.GetRenderer()->GetPass())
    ->SetDepthMapResolution(320);
  pair.Look({ 0.25, -1.0, 0.25 }, vtkBoundingBox(-0.8, 1.7, -0.1, 0.1, -0.36, 0.36));
}

const gallery::SceneRegistration beamSoft({ "beam-soft", "2.38",
  "Beams of light behind holes, hard and soft",
  "Light passes through three holes of a screen into thin smoke and a translucent box. The screen "
  "casts shadows, but is not drawn. Under a point light each beam has a sharp edge. Under a disk "
  "light the beams widen behind the holes "
  "and merge, and their cores fade.",
  {}, &BuildBeamSoft });
}
