// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Light/TranslucentBox.h"

#include "Gallery/Look.h"
#include "Gallery/Panel.h"
#include "Gallery/Stage.h"
#include "Gallery/VectorArithmetic.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSpatialObject.h"
#include "vtkSpatialPrimitive.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace gallery
{
namespace
{
/// Density of the air, of that of the box.
constexpr double AIR_SHARE = 0.2;

vtkSmartPointer<vtkImageData> SampleBox(const TranslucentBox& box)
{
  const vtkColor3d white(1.0, 1.0, 1.0);
  vtkSmartPointer<vtkSpatialPrimitive> air =
    MakeBox({ -1.4, -0.6, -0.9 }, { 1.4, 0.6, 0.9 }, white);
  air->SetDensity(AIR_SHARE);
  air->SetEdgeWidth(0.2);
  vtkSmartPointer<vtkSpatialPrimitive> solid =
    MakeBox(-0.5 * box.Lengths, 0.5 * box.Lengths, white);
  solid->SetEdgeWidth(0.04);
  return Sample(Unite({ Place(solid, { 0.0, 0.0, 0.0 }, box.Degrees), air }),
    vtkBoundingBox(-1.5, 1.5, -0.7, 0.7, -1.0, 1.0), 140);
}
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
  const vtkColor3d colour = Pencil();
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetRepresentationToWireframe();
  actor->GetProperty()->SetLineWidth(2.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

ShadowPair AddTranslucentBox(Stage& stage, const TranslucentBox& box, const Lights& beams)
{
  vtkSmartPointer<vtkImageData> image = SampleBox(box);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0 * AIR_SHARE, 1.0 - std::exp(-box.AirExtinction));
  opacity->AddPoint(255.0, 1.0 - std::exp(-box.Extinction));
  vtkSmartPointer<vtkVolumeProperty> matter = MakeColouredMatter(opacity, 1.0);
  matter->SetAmbient(0.05);
  matter->SetDiffuse(1.0);
  matter->SetSpecular(0.0);

  Panel& without = stage.AddPanel("without attenuation");
  Panel& with = stage.AddPanel("with attenuation");
  for (Panel* panel : { &without, &with })
  {
    // All of this scatters evenly, at its edges too.
    vtkSmartPointer<vtkVolume> volume = MakeSlicedVolume(image, matter, 1.0);
    // Beams are narrow.
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
}
