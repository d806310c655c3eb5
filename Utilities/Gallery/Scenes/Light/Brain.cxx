// SPDX-License-Identifier: BSD-3-Clause
// A scanned head with exposed brain, without and with shadows, from a distance and close up.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkNew.h"
#include "vtkTransform.h"

namespace
{
void Build(gallery::Stage& stage)
{
  // In the scan, the skin is brighter than the brain.
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.88, 0.72, 0.70);
  colors->AddRGBPoint(70.0, 0.88, 0.72, 0.70);
  colors->AddRGBPoint(100.0, 0.88, 0.70, 0.55);
  // Smooths steps between the slices of the scan.
  vtkNew<vtkImageGaussianSmooth> scan;
  scan->SetInputDataObject(interlume::ReadData("brainsmall.vti"));
  scan->SetStandardDeviations(0.4, 0.4, 1.2);
  scan->SetRadiusFactors(2.5, 2.5, 2.5);
  scan->Update();
  vtkSmartPointer<vtkSpatialObject> head =
    gallery::MakeImageObject(scan->GetOutput(), 15.0, 55.0, colors);
  const double scale = 1.0 / 128.0;
  vtkNew<vtkTransform> transform;
  transform->Scale(scale, scale, scale);
  transform->RotateX(-90.0);
  transform->Translate(-64.0, -64.0, -42.0);
  head->SetTransform(transform);
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(head, vtkBoundingBox(-0.5, 0.5, -0.35, 0.35, -0.5, 0.5), 180, 1.0);
  vtkSmartPointer<vtkVolumeProperty> property = gallery::MakeSolidMedium(image);
  const gallery::Lights lights = gallery::MakeStudioLights({ -2.2, -2.3, 2.1 });
  lights.back()->SetIntensity(0.45);
  gallery::ShadowPair whole = gallery::AddShadowPair(stage, image, property, lights);
  gallery::ShadowPair part =
    gallery::AddShadowPair(stage, image, property, lights, 0.0, "close up, ");
  stage.SetColumns(2);
  for (const gallery::ShadowPair& pair : { whole, part })
  {
    pair.SetBackground({ 0.52, 0.60, 0.64 }, { 0.14, 0.19, 0.23 });
  }
  whole.Look({ 0.4, -1.0, 0.5 }, vtkBoundingBox(-0.3, 0.3, -0.1, 0.1, -0.26, 0.29));
  part.Look({ 0.4, -1.0, 0.5 }, vtkBoundingBox(-0.09, 0.18, -0.3, -0.1, 0.05, 0.2));
}

const gallery::SceneRegistration registration(
  { "brain", "2.15", "A brain, without and with shadows, and close up",
    "A scanned head with exposed brain. With shadows, the cut edge of the skin shades the brain, "
    "and the folds have depth. The close-up shows that shadow edges are smooth, since shadows are "
    "computed per pixel, not per voxel.",
    { "brainsmall.vti" }, &Build });
}
