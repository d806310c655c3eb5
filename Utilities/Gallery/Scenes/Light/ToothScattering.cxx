// SPDX-License-Identifier: BSD-3-Clause
// A scanned tooth without and with scattering inside.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/CloudScene.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataSet.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShadowedSliceMapper.h"

namespace
{
/// Returns the scattering albedo. Absorption is low; blue light is absorbed most.
vtkSmartPointer<vtkColorTransferFunction> MakeAlbedo()
{
  auto albedo = vtkSmartPointer<vtkColorTransferFunction>::New();
  albedo->AddRGBPoint(90.0, 0.998, 0.990, 0.965);
  albedo->AddRGBPoint(190.0, 0.999, 0.996, 0.985);
  return albedo;
}

vtkSmartPointer<vtkVolumeProperty> MakeMedium()
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(115.0, 0.0);
  opacity->AddPoint(150.0, 0.35);
  opacity->AddPoint(255.0, 0.45);
  vtkNew<vtkColorTransferFunction> ivory;
  ivory->AddRGBPoint(90.0, 0.93, 0.86, 0.72);
  ivory->AddRGBPoint(190.0, 0.97, 0.95, 0.90);
  auto medium = vtkSmartPointer<vtkVolumeProperty>::New();
  medium->SetScalarOpacity(opacity);
  medium->SetColor(ivory);
  medium->SetInterpolationTypeToLinear();
  medium->ShadeOn();
  medium->SetAmbient(0.2);
  medium->SetDiffuse(0.8);
  medium->SetSpecular(0.0);
  return medium;
}

void Build(gallery::Stage& stage)
{
  // Without smoothing, ring artifacts of the scan would be visible.
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputDataObject(interlume::ReadData("tooth.vti"));
  smooth->SetStandardDeviations(1.2, 1.2, 2.5);
  smooth->SetRadiusFactor(2.0);
  smooth->Update();
  vtkImageData* image = smooth->GetOutput();
  gallery::Panel& without = stage.AddPanel("light that is reflected");
  gallery::Panel& with = stage.AddPanel("light that is scattered inside");
  for (gallery::Panel* panel : { &without, &with })
  {
    vtkSmartPointer<vtkVolume> volume = gallery::MakeSlicedVolume(image, MakeMedium());
    if (panel == &with)
    {
      gallery::Scatter(volume, gallery::Scattering::FULL, 0.8);
      gallery::GetSlicedMapper(volume)->SetScatteringAlbedo(MakeAlbedo());
    }
    panel->Add(volume);
    vtkSmartPointer<vtkLight> lamp =
      gallery::MakeParallelLight({ 1.0, 0.55, 0.5 }, panel == &with ? 0.44 : 1.8);
    lamp->SetDiffuseColor(1.0, 0.95, 0.85);
    panel->SetLights(
      { lamp, gallery::MakeParallelLight({ -0.7, -1.0, 0.6 }, panel == &with ? 0.12 : 1.0) });
    panel->SetBackground({ 0.20, 0.23, 0.28 }, { 0.06, 0.07, 0.09 });
  }
  const double* bounds = image->GetBounds();
  const vtkVector3d size(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  const vtkBoundingBox frame(bounds[0] + 0.16 * size[0], bounds[0] + 0.84 * size[0],
    bounds[2] + 0.45 * size[1], bounds[2] + 0.55 * size[1], bounds[4] + 0.12 * size[2], bounds[5]);
  without.Frame(frame);
  with.Frame(frame);
  without.LookFrom({ 0.25, -1.0, 0.25 }, { 0.0, 0.0, 1.0 });
  with.ShareCamera(without);
}

const gallery::SceneRegistration registration({ "tooth-scattering", "2.53",
  "A scanned tooth without and with scattering inside",
  "A light is behind a tooth on the right. In the first image, light is reflected where it reaches "
  "the medium. In the second image, it is scattered inside until it leaves, so that shadows are "
  "soft and the far side glows. The lights of the second image are weaker. The scan ends below "
  "the tip of a cusp.",
  { "tooth.vti" }, &Build });
}
