// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Light/CloudScene.h"

#include "Gallery/Panel.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Support/Inputs/Clouds.h"

#include "vtkShadowedSliceMapper.h"

namespace gallery
{
namespace
{
/// Mean cosine of the scattering angle. That of water droplets is about 0.85, but then the edges
/// in front of the sun are too bright and all other parts too dark.
constexpr double ANISOTROPY = 0.6;
}

vtkSmartPointer<vtkVolume> MakeCloudVolume(vtkSpatialObject* clouds,
  const std::array<double, 6>& bounds, int cells, Scattering scattering, double extinction)
{
  vtkSmartPointer<vtkVolume> volume = MakeSlicedVolume(
    interlume::SampleDensity(clouds, bounds, cells), interlume::MakeCloudProperty(extinction));
  Scatter(volume, scattering, ANISOTROPY);
  return volume;
}

void Scatter(vtkVolume* volume, Scattering scattering, double anisotropy, int cells)
{
  vtkShadowedSliceMapper* mapper = GetSlicedMapper(volume);
  mapper->SetScatteringMode(scattering == Scattering::SINGLE
      ? vtkShadowedSliceMapper::SINGLE_SCATTERING
      : scattering == Scattering::FORWARD ? vtkShadowedSliceMapper::FORWARD_SCATTERING
                                          : vtkShadowedSliceMapper::FULL_SCATTERING);
  mapper->SetPhaseFunctionToHenyeyGreenstein();
  mapper->SetAnisotropy(anisotropy);
  mapper->SetScatteringGridSize(cells);
}

void UseSky(
  Panel& panel, const vtkVector3d& sun, const vtkVector3d& sky, double sunlight, double skylight)
{
  vtkSmartPointer<vtkLight> direct = MakeParallelLight(sun, sunlight);
  direct->SetDiffuseColor(1.0, 0.96, 0.88);
  vtkSmartPointer<vtkLight> scattered = MakeParallelLight(sky, skylight);
  scattered->SetDiffuseColor(0.72, 0.85, 1.0);
  panel.SetLights({ direct, scattered });
  panel.SetBackground({ 0.46, 0.62, 0.80 }, { 0.10, 0.22, 0.46 });
}
}
