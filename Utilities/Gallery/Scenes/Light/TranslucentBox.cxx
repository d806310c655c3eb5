// SPDX-License-Identifier: BSD-3-Clause
// Beams of light through translucent boxes.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Stage.h"
#include "Gallery/VectorArithmetic.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSpatialOperation.h"
#include "vtkTransform.h"
#include "vtkVector.h"

#include <array>
#include <cmath>

namespace
{
using namespace gallery;

/// A translucent box surrounded by a thin medium ("air").
struct TranslucentBox
{
  vtkVector3d Lengths;
  /// Rotation around the vertical.
  double Degrees;
  /// Extinctions per unit of length.
  double Extinction;
  double AirExtinction;
};

/// Density of the air divided by the density of the box.
constexpr double AIR_FRACTION = 0.2;

vtkSmartPointer<vtkImageData> SampleBox(const TranslucentBox& box)
{
  const vtkColor3d white(1.0, 1.0, 1.0);
  vtkSmartPointer<vtkSpatialPrimitive> air =
    MakeBox({ -1.4, -0.6, -0.9 }, { 1.4, 0.6, 0.9 }, white);
  air->SetDensity(AIR_FRACTION);
  air->SetEdgeWidth(0.2);
  vtkSmartPointer<vtkSpatialPrimitive> solid =
    MakeBox(-0.5 * box.Lengths, 0.5 * box.Lengths, white);
  solid->SetEdgeWidth(0.04);
  return Sample(Unite({ Place(solid, { 0.0, 0.0, 0.0 }, box.Degrees), air }),
    vtkBoundingBox(-1.5, 1.5, -0.7, 0.7, -1.0, 1.0), 140);
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
  const vtkColor3d color = Pencil();
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetRepresentationToWireframe();
  actor->GetProperty()->SetLineWidth(2.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

/// Adds two panels of \a box, which is centered at the origin: without and with attenuation of
/// \a beams. The air fills most of a volume of 3 x 1.4 x 2 units.
ShadowPair AddTranslucentBox(Stage& stage, const TranslucentBox& box, const Lights& beams)
{
  vtkSmartPointer<vtkImageData> image = SampleBox(box);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0 * AIR_FRACTION, 1.0 - std::exp(-box.AirExtinction));
  opacity->AddPoint(255.0, 1.0 - std::exp(-box.Extinction));
  vtkSmartPointer<vtkVolumeProperty> medium = MakeColoredMedium(opacity, 1.0);
  medium->SetAmbient(0.05);
  medium->SetDiffuse(1.0);
  medium->SetSpecular(0.0);

  Panel& without = stage.AddPanel("without attenuation");
  Panel& with = stage.AddPanel("with attenuation");
  for (Panel* panel : { &without, &with })
  {
    // With this surface gradient, scattering is isotropic everywhere and edges are not shaded.
    vtkSmartPointer<vtkVolume> volume = MakeSlicedVolume(image, medium, 1.0);
    // The beams are narrow, so a small light buffer is sufficient.
    GetSlicedMapper(volume)->SetLightBufferSize(128);
    GetSlicedMapper(volume)->SetShadows(panel == &with);
    panel->Add(volume);
    panel->Add(MakeBoxFrame(box.Lengths, box.Degrees));
    panel->SetAmbientOcclusion(0.0);
    panel->SetBackground(DarkBackground());
    panel->SetLights(beams);
  }
  return { without, with };
}

void BuildBeamBox(gallery::Stage& stage)
{
  const TranslucentBox box = { { 1.0, 0.6, 0.7 }, 35.0, 2.2, 0.4 };
  AddTranslucentBox(stage, box,
    { gallery::MakeBeam({ -3.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, 0.26, 4.4, { 1.0, 0.86, 0.6 }) })
    .Look({ 0.0, -1.0, 0.35 }, vtkBoundingBox(-0.74, 0.74, -0.3, 0.3, -0.6, 0.6));
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
      gallery::MakeBeam(center + vtkVector3d(1.6, -0.2, 0.75), center, 0.2, 6.5, color));
    height -= 0.24;
  }
  const TranslucentBox cube = { { 0.84, 0.84, 0.84 }, 25.0, 1.8, 0.35 };
  AddTranslucentBox(stage, cube, beams)
    .Look({ 0.1, -1.0, 0.25 }, vtkBoundingBox(-0.74, 0.74, -0.3, 0.3, -0.6, 0.6));
}

const gallery::SceneRegistration beamsCube(
  { "beams-cube", "2.24", "Red, green and blue beams through a translucent cube",
    "Parallel beams enter at the upper right, pass a translucent cube and leave it at the lower "
    "left, visible in thin air. Without attenuation they leave with their original brightness. "
    "With attenuation the cube absorbs most of their light. In both images the medium in front "
    "hides a part of them.",
    {}, &BuildBeamsCube });

const vtkVector3d BOX(0.6, 0.6, 0.84);
const vtkVector3d POSITION(0.42, 0.0, 0.0);
constexpr double DEGREES = 24.0;

/// Returns a screen perpendicular to the x axis, with three holes in a vertical row.
vtkSmartPointer<vtkSpatialObject> MakeScreen()
{
  const vtkColor3d metal(0.42, 0.45, 0.50);
  auto screen = vtkSmartPointer<vtkSpatialOperation>::New();
  screen->SetOperationToDifference();
  screen->AddOperand(gallery::MakeDisk({ 0.0, 0.0, 0.03 }, 0.66, 0.06, metal));
  for (const double aside : { -0.2, 0.0, 0.2 })
  {
    screen->AddOperand(gallery::MakeDisk({ aside, 0.0, 0.2 }, 0.065, 0.4, metal));
  }
  vtkNew<vtkTransform> transform;
  transform->Translate(-0.95, 0.0, 0.0);
  transform->RotateY(90.0);
  screen->SetTransform(transform);
  return screen;
}

void BuildBeamSoft(gallery::Stage& stage)
{
  const vtkColor3d white(1.0, 1.0, 1.0);
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(MakeScreen(), vtkBoundingBox(-1.05, 1.25, -0.7, 0.7, -0.7, 0.7), 115);
  vtkSmartPointer<vtkSpatialPrimitive> air =
    gallery::MakeBox({ -0.9, -0.5, -0.5 }, { 1.2, 0.5, 0.5 }, white);
  air->SetDensity(0.16);
  air->SetEdgeWidth(0.2);
  gallery::AddSmoke(image,
    gallery::Unite(
      { gallery::Place(gallery::MakeBox(-0.5 * BOX, 0.5 * BOX, white), POSITION, DEGREES), air }),
    0.2, white);
  vtkSmartPointer<vtkVolumeProperty> medium = gallery::MakeSolidMediumInSmoke(image, 0.03);
  medium->SetAmbient(0.03);
  vtkSmartPointer<vtkLight> lamp = gallery::MakePointLight({ -3.2, 0.0, 0.0 }, 15.0);
  lamp->SetDiffuseColor(1.0, 0.86, 0.6);
  // With this surface gradient, scattering is isotropic everywhere and edges are not shaded.
  gallery::SoftPair pair = gallery::AddSoftPair(stage, image, medium, { lamp }, 0.4, 1.0, 192);
  for (gallery::Panel* panel : { &pair.Hard, &pair.Soft })
  {
    panel->SetBackground(gallery::DarkBackground());
    panel->SetAmbientOcclusion(0.0);
    vtkSmartPointer<vtkActor> frame = MakeBoxFrame(BOX, DEGREES);
    frame->SetPosition(POSITION[0], POSITION[1], POSITION[2]);
    panel->Add(frame);
  }
  pair.Look({ 0.35, -1.0, 0.25 }, vtkBoundingBox(-0.98, 0.92, -0.1, 0.1, -0.5, 0.5));
}

const gallery::SceneRegistration beamSoft(
  { "beam-soft", "2.38", "Beams of light behind holes, hard and soft",
    "Light passes through three holes of a screen into thin smoke and a translucent box. Under a "
    "point light each beam has a sharp edge. Under a disk light the beams widen behind the holes "
    "and merge, and their cores fade.",
    {}, &BuildBeamSoft });
}
