// SPDX-License-Identifier: BSD-3-Clause
// A cloud in sunlight in all scattering modes, compared with Monte Carlo path tracing.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Transport/CloudCase.h"
#include "Support/Transport/SceneTransport.h"

#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"

#include <cmath>
#include <iostream>
#include <string>

namespace
{

using namespace reference;

constexpr int Cells = 40;
constexpr int Pixels = 16;

RgbaImage Draw(VolumeStage& stage, const ShadowScene& scene, int mode)
{
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputData(scene.Image);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetScatteringMode(mode);
  mapper->SetPhaseFunctionToHenyeyGreenstein();
  mapper->SetAnisotropy(CloudAnisotropy);
  stage.SetVolume(mapper, scene.Property);
  return stage.Capture();
}

/// Returns the root mean square difference, relative to the root mean square of the reference and
/// corrected for its noise.
double GetError(const RgbaImage& found, const TransportImage& expected)
{
  double difference = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < found.Values.size(); i += 4)
  {
    const double noise = expected.StandardError.Values[i] * expected.StandardError.Values[i];
    difference += std::pow(found.Values[i] - expected.Mean.Values[i], 2.0) - noise;
    square += expected.Mean.Values[i] * expected.Mean.Values[i] - noise;
  }
  return std::sqrt(std::max(difference, 0.0) / square);
}

}

int TestScatteredClouds(int, char*[])
{
  Check check;
  const ShadowScene scene = MakeCloudCase(Cells, Pixels);
  VolumeStage stage(scene.Size);
  stage.SetLights(scene.Lights);
  stage.SetCamera(scene.Camera);
  SceneTransportSettings settings;
  settings.Phase = TransportPhase::HenyeyGreenstein(CloudAnisotropy);
  settings.PathsPerPixel = 800;
  const TransportImage all = TraceScene(scene, settings);
  settings.MaximumScatterings = 1;
  const TransportImage once = TraceScene(scene, settings);

  const RgbaImage single = Draw(stage, scene, vtkShadowedSliceMapper::SINGLE_SCATTERING);
  const double first = GetError(single, once);
  const double singleError = GetError(single, all);
  const double forwardError =
    GetError(Draw(stage, scene, vtkShadowedSliceMapper::FORWARD_SCATTERING), all);
  const double fullError =
    GetError(Draw(stage, scene, vtkShadowedSliceMapper::FULL_SCATTERING), all);
  std::cout << "single against one scattering: " << first << "; against all orders: single "
            << singleError << ", forward " << forwardError << ", full " << fullError << "\n";
  // The bound allows for the resolution of the light buffer, which affects view rays along the
  // cloud's edge.
  check.That(first < 0.12, "single scattering: " + std::to_string(first));
  check.That(fullError < forwardError && forwardError < singleError,
    "full scattering has the smallest error");
  check.That(fullError < 0.12, "full scattering: " + std::to_string(fullError));
  return check.Result();
}
