// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/ImageSettings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

void ImageSettings::Add(const vtkShadowedSliceSettings& settings)
{
  using Settings = vtkShadowedSliceSettings;
  this->HasShadows = this->HasShadows || settings.Shadows;
  this->MaximumNumberOfShadowLights =
    std::max(this->MaximumNumberOfShadowLights, settings.MaximumNumberOfShadowLights);
  this->IsSmoothLookup = this->IsSmoothLookup || settings.LightLookup == Settings::BILINEAR_LOOKUP;
  this->ImageSampleDistance = std::min(this->ImageSampleDistance, settings.ImageSampleDistance);
  this->AutoAdjustSampleDistances =
    this->AutoAdjustSampleDistances && settings.AutoAdjustSampleDistances;
  this->NumberOfLightSamples = std::max(this->NumberOfLightSamples, settings.NumberOfLightSamples);
  // Order of preference: sample layers, convolution, sampled lights.
  const std::array<int, 3> ranks{ { 1, 2, 0 } };
  if (ranks[settings.SoftShadowMethod] > ranks[this->SoftShadowMethod])
  {
    this->SoftShadowMethod = settings.SoftShadowMethod;
  }
  this->MinimumBufferSize = std::max(this->MinimumBufferSize, settings.LightBufferSize);
  this->LightBufferSize =
    this->LightBufferSize > 0 && settings.LightBufferSize > 0 ? this->MinimumBufferSize : 0;
  if (settings.MaximumTextureMemory > 0)
  {
    this->MaximumTextureMemory = this->MaximumTextureMemory > 0
      ? std::min(this->MaximumTextureMemory, settings.MaximumTextureMemory)
      : settings.MaximumTextureMemory;
  }
  this->HasColoredLight = this->HasColoredLight || settings.TransmissionColor;
}

void ImageSettings::Coarsen(double coarseness)
{
  this->Coarseness = coarseness;
  const auto reduce = [coarseness](int number, double factor)
  { return static_cast<int>(std::ceil(number / (factor * coarseness))); };
  this->LightBufferSize = reduce(this->LightBufferSize, 1.0);
  this->MinimumBufferSize = reduce(this->MinimumBufferSize, 1.0);
  this->NumberOfLightSamples = reduce(this->NumberOfLightSamples, coarseness);
}

}
