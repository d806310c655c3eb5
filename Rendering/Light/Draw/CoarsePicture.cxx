// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/CoarsePicture.h"

#include "Space/MatrixUniform.h"
#include "Space/UnitVector.h"

#include "InterlumeSliceShowFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderFeatures.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>

namespace interlume
{

namespace
{
// Returns the direction in which the eye looks through the middle of the picture.
glm::vec3 GetSightline(const glm::dmat4& unitFromClip)
{
  const auto at = [&](double depth)
  {
    const glm::dvec4 place = unitFromClip * glm::dvec4(0.0, 0.0, depth, 1.0);
    return glm::dvec3(place) / place.w;
  };
  return glm::vec3(UnitVector::Normalize(at(0.5) - at(-1.0), { 0.0, 0.0, -1.0 }));
}
}

CoarsePicture::CoarsePicture() = default;

CoarsePicture::~CoarsePicture() = default;

void CoarsePicture::SetDepths(
  vtkTextureObject* surfaces, vtkTextureObject* front, const glm::dmat4& unitFromClip)
{
  this->Surfaces = surfaces;
  this->Front = surfaces ? front : nullptr;
  this->UnitFromClip = unitFromClip;
}

bool CoarsePicture::Show(vtkOpenGLRenderWindow* window, vtkTextureObject* image)
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
  const std::array<float, 2> size{ { static_cast<float>(image->GetWidth()),
    static_cast<float>(image->GetHeight()) } };
  // Twice the width of a pixel where the volume's sphere fills the picture.
  const float slant = 4.0F / std::max(size[0], size[1]);
  const glm::vec3 sightline = GetSightline(this->UnitFromClip);
  this->Surfaces->Activate();
  if (front)
  {
    front->Activate();
  }
  this->Quad.DrawWith(window, image,
    vtkShaderFeatures::Insert(InterlumeSliceShowFS, front ? "FRONT" : ""),
    [&](vtkShaderProgram* program)
    {
      program->SetUniform2f("imageSize", size.data());
      program->SetUniformi("surfaceDepth", this->Surfaces->GetTextureUnit());
      MatrixUniform::Set(program, "unitFromClip", this->UnitFromClip);
      program->SetUniform3f("sightline", &sightline[0]);
      program->SetUniformf("slant", slant);
      if (front)
      {
        program->SetUniformi("frontDepth", front->GetTextureUnit());
      }
    });
  this->Surfaces->Deactivate();
  if (front)
  {
    front->Deactivate();
  }
  return true;
}

void CoarsePicture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->SetDepths(nullptr, nullptr, glm::dmat4(1.0));
  this->Quad.ReleaseGraphicsResources(window);
}

}
