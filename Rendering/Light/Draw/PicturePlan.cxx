// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/PicturePlan.h"

#include "Casters/SceneCasters.h"
#include "Draw/SliceLightBuffer.h"
#include "Draw/SliceShader.h"
#include "Lights/EmitterSamples.h"
#include "Loader/OpenGLFunctions.h"
#include "Receivers/SliceScene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

namespace
{
// The factors by which pictures may be coarser than asked for.
constexpr std::array<double, 5> COARSENESSES{ { 1.0, 1.5, 2.0, 3.0, 4.0 } };
// Columns of a light's buffer for each voxel where matter may have edges that voxels have not: the
// columns show as stripes on them.
constexpr double MATTER_TEXELS = 2.0;
}

void PicturePlan::Make(SliceFrame& frame, const std::vector<SlicePlan::Matter>& matter,
  const vtkShadowedSliceSettings& asked, double coarseness, vtkShadowedSliceReport& report,
  int leastBufferSize)
{
  SlicePlan::Settings settings;
  settings.AutomaticFactor = AutomaticSpacing * coarseness;
  settings.BufferSize = asked.LightBufferSize;
  settings.PictureSize = std::min(frame.Size[0], frame.Size[1]);
  settings.LeastBufferSize = leastBufferSize;
  settings.TexelsOfVoxel = frame.Matter ? MATTER_TEXELS : 1.0;
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  settings.LargestBufferSize = std::min(settings.LargestBufferSize, static_cast<int>(limit));
  const auto isSoft = [](const LightSource& light)
  { return light.Area != nullptr && light.ShadowStrength > 0.0; };
  const std::size_t lights = frame.Lights.size();
  report.ShadowedLights = static_cast<int>(std::count_if(frame.Lights.begin(), frame.Lights.end(),
    [](const LightSource& light) { return light.ShadowStrength > 0.0; }));
  report.SoftLights =
    static_cast<int>(std::count_if(frame.Lights.begin(), frame.Lights.end(), isSoft));

  // Surfaces hide the samples of a light from layers of the same samples.
  const int samples =
    std::max(asked.NumberOfLightSamples, frame.Scene ? frame.Scene->Casters->GetLightSamples() : 0);
  std::vector<int> sampled;
  if (report.SoftLights > 0)
  {
    constexpr std::array<const char*, 3> names{ { "AccumulatedConvolution", "SampleLayers",
      "SampledLights" } };
    // A surface of a scene takes what is left of a light once: shares of lights that stand for
    // samples would be multiplied, and layers of the same samples show the same.
    const bool isOfLayers =
      frame.Scene != nullptr && asked.SoftShadowMethod == vtkShadowedSliceSettings::SAMPLED_LIGHTS;
    const int method = isOfLayers ? static_cast<int>(vtkShadowedSliceSettings::SAMPLE_LAYERS)
                                  : asked.SoftShadowMethod;
    report.SoftShadowMethod = names[method];
    settings.Samples = samples;
    settings.SoftMethod = method == vtkShadowedSliceSettings::SAMPLE_LAYERS ? SlicePlan::LAYERS
      : method == vtkShadowedSliceSettings::ACCUMULATED_CONVOLUTION         ? SlicePlan::CONVOLUTION
                                                                            : SlicePlan::HARD;
    for (std::size_t i = 0; i < lights && settings.SoftMethod == SlicePlan::HARD; ++i)
    {
      if (isSoft(frame.Lights[i]))
      {
        sampled.push_back(static_cast<int>(i));
      }
    }
  }
  if (!sampled.empty())
  {
    frame.Lights = EmitterSamples::Split(frame.Lights, sampled, samples);
    report.SampledLights = samples * static_cast<int>(sampled.size());
  }
  frame.Plan.Make(frame.Eye, frame.Lights, matter, settings);
  const std::vector<int> hard = frame.Plan.NotSoft;
  report.HardLightsInstead = static_cast<int>(hard.size());
  if (!hard.empty())
  {
    for (const int light : hard)
    {
      frame.Lights[static_cast<std::size_t>(light)].Area = nullptr;
    }
    frame.Plan.Make(frame.Eye, frame.Lights, matter, settings);
  }
  report.Lights = frame.IsLit() ? static_cast<int>(lights) : 0;
  report.Sweeps = static_cast<int>(frame.Plan.Sweeps.size());
  report.FrontToBackSweeps = static_cast<int>(std::count_if(frame.Plan.Sweeps.begin(),
    frame.Plan.Sweeps.end(), [](const SlicePlan::Sweep& sweep) { return sweep.IsFrontToBack; }));
  report.SliceSpacing = frame.Plan.Sweeps[0].Spacing * frame.Space.Radius;
}

vtkIdType PicturePlan::GetBufferBytes(const std::vector<const SliceFrame*>& frames)
{
  const SliceFrame& frame = *frames[0];
  const vtkIdType pixels = static_cast<vtkIdType>(frame.Size[0]) * frame.Size[1];
  vtkIdType bytes =
    pixels * static_cast<vtkIdType>(sizeof(float)) * (frame.Plan.HasFurtherPictures() ? 9 : 5);
  for (std::size_t sweep = 0; sweep < frame.Plan.Sweeps.size(); ++sweep)
  {
    // Thick matter needs two layers of each buffer.
    const auto thick = static_cast<int>(std::count_if(frames.begin(), frames.end(),
      [sweep](const SliceFrame* other) { return SliceShader::HasThickPart(*other, sweep); }));
    for (const SlicePlan::ShadowedLight& light : frame.Plan.Sweeps[sweep].Lights)
    {
      const vtkIdType texels = static_cast<vtkIdType>(light.BufferSize) * light.BufferSize;
      bytes += static_cast<vtkIdType>(sizeof(float)) * frame.GetLightChannels() *
        ((light.IsWide ? 1 : 1 + 2 * thick) * texels + SliceLightBuffer::GetSoftTexels(light));
    }
  }
  return bytes;
}

double PicturePlan::ChooseCoarseness(double seconds, double lastCoarseness, double allocated)
{
  // The time of a full picture counts slices and pixels along both edges.
  const double full = seconds * std::pow(lastCoarseness, 3.0);
  for (const double coarseness : COARSENESSES)
  {
    if (full <= allocated * std::pow(coarseness, 3.0))
    {
      return coarseness;
    }
  }
  return COARSENESSES.back();
}

}
