// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SlicePlanner.h"

#include "Buffers/SliceLightBuffer.h"
#include "ShadowMaps/SceneOccluders.h"
#include "Draw/ImageSettings.h"
#include "Lights/EmitterSamples.h"
#include "Loader/OpenGLFunctions.h"
#include "Receivers/SliceScene.h"
#include "Shaders/SliceShader.h"
#include "Sweeps/SliceReport.h"

#include "vtkShadowedSliceSettings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

namespace
{
// Light buffer columns per voxel for a custom medium, whose edges can be sharper than voxels. With
// fewer columns, stripes appear along these edges.
constexpr double MEDIUM_TEXELS = 2.0;
}

void SlicePlanner::Make(ImageState& image, const States& states,
  const std::vector<SlicePlan::SlicedVolume>& volumes, const ImageSettings& shared,
  double coarseness, SliceReport& report)
{
  SlicePlan::Settings settings;
  settings.AutomaticFactor = AutomaticSpacing * coarseness;
  settings.BufferSize = shared.LightBufferSize;
  settings.SmallerImageSize = std::min(image.Size[0], image.Size[1]);
  settings.MinimumBufferSize = shared.MinimumBufferSize;
  settings.TexelsOfVoxel = (states[0]->Medium ? MEDIUM_TEXELS : 1.0) / shared.Coarseness;
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  settings.LargestBufferSize = std::min(settings.LargestBufferSize, static_cast<int>(limit));
  const auto isSoft = [](const LightSource& light)
  { return light.Area != nullptr && light.ShadowStrength > 0.0; };
  const std::size_t lights = image.Lights.size();
  report.ShadowedLights = static_cast<int>(std::count_if(image.Lights.begin(), image.Lights.end(),
    [](const LightSource& light) { return light.ShadowStrength > 0.0; }));
  report.SoftShadowLights =
    static_cast<int>(std::count_if(image.Lights.begin(), image.Lights.end(), isSoft));

  // Surfaces and sample layers use the same samples of a light.
  const int samples = std::max(
    shared.NumberOfLightSamples, image.Scene ? image.Scene->Occluders->GetLightSamples() : 0);
  std::vector<int> sampled;
  if (report.SoftShadowLights > 0)
  {
    constexpr std::array<const char*, 3> names{ { "AccumulatedConvolution", "SampleLayers",
      "SampledLights" } };
    // Surfaces of a scene attenuate an area light by their mean over its samples. If each sample
    // were a separate light, each would be attenuated by this mean. Sample layers avoid this.
    const bool isOfLayers =
      image.Scene != nullptr && shared.SoftShadowMethod == vtkShadowedSliceSettings::SAMPLED_LIGHTS;
    const int method = isOfLayers ? static_cast<int>(vtkShadowedSliceSettings::SAMPLE_LAYERS)
                                  : shared.SoftShadowMethod;
    report.SoftShadowMethod = names[method];
    settings.Samples = samples;
    settings.SoftMethod = method == vtkShadowedSliceSettings::SAMPLE_LAYERS ? SlicePlan::LAYERS
      : method == vtkShadowedSliceSettings::ACCUMULATED_CONVOLUTION         ? SlicePlan::CONVOLUTION
                                                                            : SlicePlan::HARD;
    for (std::size_t i = 0; i < lights && settings.SoftMethod == SlicePlan::HARD; ++i)
    {
      if (isSoft(image.Lights[i]))
      {
        sampled.push_back(static_cast<int>(i));
      }
    }
  }
  if (!sampled.empty())
  {
    image.Lights = EmitterSamples::Split(image.Lights, sampled, samples);
    report.SampledLights = samples * static_cast<int>(sampled.size());
  }
  image.Plan.Make(image.Camera, image.Lights, volumes, settings);
  const std::vector<int> hard = image.Plan.NotSoft;
  report.AreaLightsWithHardShadows = static_cast<int>(hard.size());
  if (!hard.empty())
  {
    for (const int light : hard)
    {
      image.Lights[static_cast<std::size_t>(light)].Area = nullptr;
    }
    image.Plan.Make(image.Camera, image.Lights, volumes, settings);
  }
  report.Lights = states[0]->IsLit() ? static_cast<int>(lights) : 0;
  report.Sweeps = static_cast<int>(image.Plan.Sweeps.size());
  report.FrontToBackSweeps = static_cast<int>(std::count_if(image.Plan.Sweeps.begin(),
    image.Plan.Sweeps.end(), [](const SlicePlan::Sweep& sweep) { return sweep.IsFrontToBack; }));
  report.SliceSpacing = image.Plan.Sweeps[0].Spacing * states[0]->Space.Radius;
}

vtkIdType SlicePlanner::GetBufferBytes(const ImageState& image, const States& states)
{
  const vtkIdType pixels = static_cast<vtkIdType>(image.Size[0]) * image.Size[1];
  vtkIdType bytes =
    pixels * static_cast<vtkIdType>(sizeof(float)) * (image.Plan.HasMultipleImages() ? 9 : 5);
  for (std::size_t sweep = 0; sweep < image.Plan.Sweeps.size(); ++sweep)
  {
    // Each volume with thick fragments needs two layers per light buffer.
    const auto thick = static_cast<int>(std::count_if(states.begin(), states.end(),
      [sweep](const VolumeRenderState* other)
      { return SliceShader::HasThickPart(*other, sweep); }));
    for (const SlicePlan::ShadowedLight& light : image.Plan.Sweeps[sweep].Lights)
    {
      const vtkIdType texels = static_cast<vtkIdType>(light.BufferSize) * light.BufferSize;
      bytes += static_cast<vtkIdType>(sizeof(float)) * image.GetLightChannels() *
        ((light.IsWide ? 1 : 1 + 2 * thick) * texels +
          SliceLightBuffer::GetNumberOfSoftShadowTexels(light));
    }
  }
  return bytes;
}

}
