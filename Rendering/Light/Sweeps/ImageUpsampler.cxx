// SPDX-License-Identifier: BSD-3-Clause
#include "Sweeps/ImageUpsampler.h"

#include "Offscreen/ShaderFeatures.h"
#include "Space/ShaderUniforms.h"
#include "Space/UnitVector.h"

#include "InterlumeSliceShowFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>

namespace interlume
{

namespace
{
// Returns the view direction at the center of the image.
glm::vec3 GetViewDirection(const glm::dmat4& unitFromClip)
{
  const auto at = [&](double depth)
  {
    const glm::dvec4 position = unitFromClip * glm::dvec4(0.0, 0.0, depth, 1.0);
    return glm::dvec3(position) / position.w;
  };
  return glm::vec3(UnitVector::Normalize(at(0.5) - at(-1.0), { 0.0, 0.0, -1.0 }));
}
}

ImageUpsampler::ImageUpsampler() = default;

ImageUpsampler::~ImageUpsampler() = default;

void ImageUpsampler::SetDepths(
  vtkTextureObject* surfaces, vtkTextureObject* front, const glm::dmat4& unitFromClip)
{
  this->Surfaces = surfaces;
  this->Front = surfaces ? front : nullptr;
  this->UnitFromClip = unitFromClip;
}

bool ImageUpsampler::Show(vtkOpenGLRenderWindow* window, vtkTextureObject* image)
{
  const auto isFiner = [image](vtkTextureObject* depth)
  {
    return depth && depth->GetHandle() != 0 &&
      (depth->GetWidth() > image->GetWidth() || depth->GetHeight() > image->GetHeight());
  };
  if (!isFiner(this->Surfaces))
  {
    this->Quad.ReleaseGraphicsResources(window);
    return false;
  }
  vtkTextureObject* front = isFiner(this->Front) ? this->Front.Get() : nullptr;
  const glm::dvec2 size(image->GetWidth(), image->GetHeight());
  // Depth difference that a slanted surface can have between adjacent pixels: twice the width of a
  // pixel if the unit sphere fills the image.
  const double slant = 4.0F / static_cast<float>(std::max(size.x, size.y));
  const glm::vec3 viewDirection = GetViewDirection(this->UnitFromClip);
  this->Surfaces->Activate();
  if (front)
  {
    front->Activate();
  }
  this->Quad.DrawWithShader(window, image,
    ShaderFeatures::Insert(InterlumeSliceShowFS, front ? "FRONT" : ""),
    [&](vtkShaderProgram* program)
    {
      const ShaderUniforms uniforms(program);
      uniforms.Set("imageSize", size);
      uniforms.Set("surfaceDepth", this->Surfaces->GetTextureUnit());
      uniforms.Set("unitFromClip", this->UnitFromClip);
      uniforms.Set("viewRay", glm::dvec3(viewDirection));
      uniforms.Set("slant", slant);
      uniforms.Set("frontDepth", front ? front->GetTextureUnit() : 0);
    });
  this->Surfaces->Deactivate();
  if (front)
  {
    front->Deactivate();
  }
  return true;
}

void ImageUpsampler::ReleaseGraphicsResources(vtkWindow* window)
{
  this->SetDepths(nullptr, nullptr, glm::dmat4(1.0));
  this->Quad.ReleaseGraphicsResources(window);
}

}
